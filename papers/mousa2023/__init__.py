"""Mousa et al.: polynomials, WOA and GA for point-to-point motion of a KUKA KR4 R600."""

from papers.mousa2023.formulas import FORMULAS
from papers.mousa2023.misprints import ERRATA, GAPS
from papers.mousa2023.open_points import ASSUMPTIONS, TOGETHER
from papers.mousa2023.polynomial_claims import POLYNOMIAL_CLAIMS
from papers.mousa2023.printed import ANGLES, TABLE_IV
from papers.mousa2023.protocol import (
    ARM_CUBIC,
    ARM_QUINTIC,
    CUBIC,
    EXPERIMENTS,
    FIT,
    QUINTIC,
)
from papers.mousa2023.robot import DH
from papers.mousa2023.search_claims import search_claims
from repro.model.figures import Arm, ArmMotion, Convergence, JointCurves
from repro.model.paper import Paper, Source

PAPER = Paper(
    key="mousa2023",
    read_twice=True,
    source=Source(
        authors="Mahmoud A. A. Mousa, Abdelrahman T. Elgohr, Hatem A. Khater",
        title="Path Planning for a 6 DoF Robotic Arm Based on Whale Optimization Algorithm and "
        "Genetic Algorithm",
        year=2023,
        journal="Journal of Engineering Research 7(5), article 53",
        doi="10.21608/erjeng.2023.237586.1256",
    ),
    summary="Cubic and quintic polynomials, WOA and GA plan one motion of a KUKA KR4 R600; WOA is "
    "said to be faster and more accurate than GA. No result is printed as a number.",
    experiments=EXPERIMENTS,
    inputs=(TABLE_IV, ANGLES),
    results=(),
    claims=(*POLYNOMIAL_CLAIMS, *search_claims()),
    assumptions=ASSUMPTIONS,
    errata=ERRATA,
    gaps=GAPS,
    together=TOGETHER,
    formulas=FORMULAS,
    figures=(
        JointCurves(
            label="Fig. 2",
            caption="Angle, velocity and acceleration of the six joints by cubic polynomials",
            paths=CUBIC,
        ),
        JointCurves(
            label="Fig. 3",
            caption="Angle, velocity and acceleration of the six joints by quintic polynomials",
            paths=QUINTIC,
        ),
        JointCurves(
            label="Fig. 4",
            caption="Angle, velocity and acceleration of the six joints fitted by WOA",
            paths=QUINTIC,
            experiment=FIT.name,
            algorithms=("WOA",),
        ),
        JointCurves(
            label="Fig. 5",
            caption="Angle, velocity and acceleration of the six joints fitted by GA",
            paths=QUINTIC,
            experiment=FIT.name,
            algorithms=("GA", "GA by generations"),
        ),
        Convergence(
            label="Fig. 6",
            caption="Norm of the difference over the iterations of WOA and GA",
            experiment=FIT.name,
        ),
        Arm(
            label="Arm",
            caption="The arm of Table IV between the angles of Eqs. (10) and (11), read as angles "
            "A1 to A6 of the real arm, by the quintic and by the cubic polynomials; no time is "
            "minimised or printed, so both last the time that is assumed",
            dh=DH,
            convention="standard",
            motions=(
                ArmMotion(name="quintic polynomials", problem=ARM_QUINTIC),
                ArmMotion(name="cubic polynomials", problem=ARM_CUBIC),
            ),
            assumed=(
                "Denavit-Hartenberg convention",
                "what the start and end angles are",
                "duration of the motion",
            ),
        ),
    ),
)
