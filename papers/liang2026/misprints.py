"""Liang et al.: what the paper misprints or keeps to itself."""

from repro.model.open_points import Erratum, Gap

ROBOGUIDE = Gap(
    what="times in the RoboGuide simulation (18 % less)",
    where="section V-C 1) and section VI",
    because="the waypoints P1 to P4, the times and the planned motion are not printed",
)
SMOOTHER = Gap(
    what="smoother transitions and results of simulation and arm that agree",
    where="section V-C",
    because="no measure of either is named, and no curve or time of these motions is printed as "
    "data",
)
PHYSICAL_ARM = Gap(
    what="times on the physical arm (16.4 % less)",
    where="section V-C 2) and section VI",
    because="the waypoints P1 to P4 and the measured times are not printed, and it needs the arm",
)
TOOL_ERROR = Gap(
    what="position error of the physical arm (within 2 mm)",
    where="section V-C 2) and section VI",
    because="no measured positions are printed, and it needs the arm",
)

ERRATA = (
    Erratum(
        where="Table I, F12",
        printed="π/n [10 sin²(π (x_1+1)/4) + Σ ((x_i+1)/4)²] (1 + 10 sin²(π (x_n+1)/4)) + "
        "((x_n+1)/4)² + Σ U: the factor stands outside the sum, the last square outside π/n, and U "
        "is not defined",
        used="Generalized penalized function 1 with y_i = 1 + (x_i+1)/4 and the factor "
        "1 + 10 sin²(π y_{i+1}) inside the sum, the last square inside π/n, and U as there (Yao, "
        "Liu & Lin 1999)",
        because="the name, box, constants and optimum are those of that function",
    ),
    Erratum(
        where="Eqs. (20)-(21)",
        printed="last row 0 0 0 0, in Eq. (20) and in the first matrix of Eq. (21)",
        used="0 0 0 1",
        because="a homogeneous transformation ends in 0 0 0 1, as the other matrices do",
    ),
    Erratum(
        where="Table III against Table IV",
        printed="d_1 = 490",
        used="490, as printed",
        because="the tables do not quite agree: the audit gives the gap and the one constant that "
        "would close it; the re-run keeps the print",
    ),
    Erratum(
        where="section III-D",
        printed="Kent map",
        used="Tent map",
        because="section III-B and Eq. (13) say Tent",
    ),
    Erratum(
        where="section III-C, step 4",
        printed="Eqs. (9) and (10) encircle, (11) is the spiral, (12) and (13) search",
        used="(8)-(9) encircle, (10) is the spiral, (11)-(12) search",
        because="that is what the numbered equations say; (13) is the Tent map",
    ),
)
