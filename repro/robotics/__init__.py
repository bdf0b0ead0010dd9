"""Arms and motions: D-H kinematics, rest-to-rest polynomials, minimum-time problems."""

from repro.robotics.kinematics import Convention, dh_rows, forward_kinematics
from repro.robotics.polynomials import RestToRestLaw, cubic, quintic, septic
from repro.robotics.rest_to_rest import MinimumTime, peak

__all__ = [
    "Convention",
    "MinimumTime",
    "RestToRestLaw",
    "cubic",
    "dh_rows",
    "forward_kinematics",
    "peak",
    "quintic",
    "septic",
]
