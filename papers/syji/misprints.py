"""SYJI-0035: what the paper misprints or keeps to itself."""

from repro.model.open_points import Erratum, Gap

SERVO = Gap(
    what="greatest velocity, acceleration and jerk against what the servo drive allows",
    where="section 6R robot simulation",
    because="the drive and its limits are not printed",
)

ERRATA = (
    Erratum(
        where="section Simulation parameter settings, item 4",
        printed="0.845 s for segment 2",
        used="0.8945 s wherever the printed durations are judged; 0.845 as printed in its claim",
        because="the four printed durations make 2.2504 s, with 0.8945 they make 2.2999 s exactly",
    ),
    Erratum(
        where="Tables 2 and 3, jerk of joint 1, seventh order",
        printed="15.12",
        used="18.9 in Table 2; 15.12, as printed, as the limit of Table 3",
        because="42·45/5³ = 15.12 is the greatest positive jerk of a joint that moves 45° forward; "
        "its greatest jerk is -52.5·45/5³ = -18.9, and joint 4, which moves alike, has 18.89",
    ),
    Erratum(
        where="Table 2, joints 2 and 6, seventh order",
        printed="velocity 39.36 and jerk 37.78",
        used="39.375 and 37.8",
        because="they are twice 19.68 and 18.89, which are 19.6875 and 18.9 cut off (18.9 as a "
        "double can lie just below it)",
    ),
    Erratum(
        where="Table 2, joints 2 and 6, fifth order",
        printed="acceleration 20.75",
        used="20.785",
        because="10/√3·90/5² = 20.785, twice the 10.39 of the others; on the paper's time axis of "
        "0.1 s steps it would be 20.757, but 10.39 would then be 10.38",
    ),
    Erratum(
        where="Table 3",
        printed="limits said to be the greatest values of the seventh-order motion",
        used="as printed",
        because="most are cut off, so that the 5 s motion itself lies above them by less than "
        "0.1 %, which the tolerance of the claims allows for",
    ),
    Erratum(
        where="Table 1, θ2",
        printed="-60° to 55°",
        used="the 90° and 67.5° of Table 4, as printed",
        because="the motion starts outside the range of joint 2",
    ),
    Erratum(
        where="section Simulation parameter settings, item 3",
        printed="fitness with number (17)",
        used="Eq. (9) with λ = 0.1, 0.01, 0.01",
        because="(17) is already an equation of the search",
    ),
    Erratum(
        where="section Bubble-net attacking method, item 1",
        printed="A within [-1.1]",
        used="[-1, 1]",
        because="a comma became a point; in Eq. (12) A lies in [-a, a], a falling from 2",
    ),
)
