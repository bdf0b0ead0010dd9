"""Arms and motions: D-H kinematics, polynomials, minimum-time and path-fitting problems."""

from repro.robotics.directed_spline import DirectedSpline
from repro.robotics.joint_axes import freedoms, jacobian
from repro.robotics.kinematics import Convention, dh_rows, forward_kinematics
from repro.robotics.law import Law
from repro.robotics.path_fitting import PathFitting
from repro.robotics.polynomial_motion import PolynomialMotion
from repro.robotics.polynomials import RestToRestLaw, cubic, quintic, septic
from repro.robotics.rest_to_rest import MinimumTime, peak
from repro.robotics.shown_motion import ShowsMotion
from repro.robotics.spline_motion import MinimumTimeSpline

__all__ = [
    "Convention",
    "DirectedSpline",
    "Law",
    "MinimumTime",
    "MinimumTimeSpline",
    "PathFitting",
    "PolynomialMotion",
    "RestToRestLaw",
    "ShowsMotion",
    "cubic",
    "dh_rows",
    "forward_kinematics",
    "freedoms",
    "jacobian",
    "peak",
    "quintic",
    "septic",
]
