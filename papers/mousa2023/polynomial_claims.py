"""Mousa et al.: what the text says of the cubic, the quintic and the arm; nothing here is run."""

from collections.abc import Callable
from functools import partial

import numpy as np

from papers.mousa2023.printed import EQUATION_4, EQUATION_9, FREEDOMS, REACH
from papers.mousa2023.protocol import CUBIC, QUINTIC, SHIFT, SHIFTED
from papers.mousa2023.robot import (
    END,
    START,
    axes_out_of_range,
    axis_angles,
    least_freedoms,
    reach,
)
from repro.model.claims import Sentence
from repro.model.measures.curves import Combination, PlaceAmong, planned
from repro.model.measures.measure import Computed
from repro.model.tolerances import Between, Percent
from repro.robotics import PathFitting
from repro.tables.published import Printed

SMOOTHNESS: tuple[tuple[str, str, Combination], ...] = (
    ("jump of acceleration at the start", "start acceleration", "norm"),
    ("greatest jerk between the ends", "peak jerk", "largest"),
    ("integrated squared jerk between the ends", "squared jerk", "sum"),
)
FIRST = Printed("1", "rank")
NONE = Between(0, 1e-9)  # rounding of doubles leaves about 1e-15


def printed_curve(equation: tuple[str, ...], path: PathFitting) -> np.ndarray:
    """Return the coefficients a_0, a_1, … that Eq. (4) or (9) prints, for the ends of a path."""
    multipliers = np.array([float(text) for text in equation])
    moved = multipliers * (path.end - path.start) / path.duration ** np.arange(len(multipliers))
    moved[0] = path.start
    return moved


def largest(equation: tuple[str, ...], *quantities: str) -> Callable[[], float]:
    """Return what gives the greatest of some quantities over the joints, by a printed equation."""
    paths = CUBIC if equation is EQUATION_4 else QUINTIC

    def value() -> float:
        return max(
            float(path.quantity(quantity, printed_curve(equation, path)))
            for path in paths
            for quantity in quantities
        )

    return value


def _ends(name: str, equation: tuple[str, ...], quantity: str, unit: str, where: str) -> Sentence:
    return Sentence(
        claim=f"the {name} has zero {quantity} at both ends, as at rest before and after",
        where=where,
        printed=Printed("0", unit),
        measure=Computed(
            how=f"greatest {quantity} of the six joints at either end by the printed coefficients",
            value=largest(equation, f"start {quantity}", f"end {quantity}"),
        ),
        accepted=NONE,
        in_words=True,
    )


def _planned(paths: tuple[PathFitting, ...], name: str, measure: str) -> Computed:
    quantity, combination = next((q, c) for words, q, c in SMOOTHNESS if words == measure)
    return Computed(how=f"{measure} of the {name}", value=planned(paths, quantity, combination))


SMOOTHER = tuple(
    Sentence(
        claim=f"the quintic is smoother than the cubic (read as: lower {words})",
        where="section IV, Fig. 3",
        printed=FIRST,
        measure=PlaceAmong(
            of=_planned(QUINTIC, "quintic", words), others=(_planned(CUBIC, "cubic", words),)
        ),
        accepted=Between(1, 1),
        in_words=True,
    )
    for words, *_ in SMOOTHNESS
)


def _bend(equation: tuple[str, ...], name: str) -> Computed:
    return Computed(
        how=f"greatest less least jerk of the {name}, any joint",
        value=largest(equation, "jerk range"),
    )


ENDS = (
    Sentence(
        claim="the cubic leads from the start to the end angles",
        where="Eq. (4)",
        printed=Printed("0", "rad"),
        measure=Computed(
            how="greatest error of the six joints at either end by the printed coefficients",
            value=largest(EQUATION_4, "start error", "end error"),
        ),
        accepted=NONE,
        in_words=True,
    ),
    Sentence(
        claim="the quintic leads from the start to the end angles",
        where="Eq. (9)",
        printed=Printed("0", "rad"),
        measure=Computed(
            how="greatest error of the six joints at either end by the printed coefficients",
            value=largest(EQUATION_9, "start error", "end error"),
        ),
        accepted=NONE,
        in_words=True,
    ),
    _ends("cubic", EQUATION_4, "velocity", "rad/s", "section IV, Eqs. (2)-(4)"),
    _ends("quintic", EQUATION_9, "velocity", "rad/s", "section IV, Eqs. (6)-(9)"),
    _ends("quintic", EQUATION_9, "acceleration", "rad/s^2", "section IV, Eqs. (6)-(9)"),
)
SHAPES = (
    Sentence(
        claim="the acceleration of the cubic is a straight line (its jerk does not vary)",
        where="section IV, Fig. 3",
        printed=Printed("0", "rad/s^3"),
        measure=_bend(EQUATION_4, "cubic"),
        accepted=NONE,
        in_words=True,
    ),
    Sentence(
        claim="the acceleration of the quintic is curved (its jerk varies more than the cubic's)",
        where="section IV, Fig. 3",
        printed=Printed("2", "rank"),
        measure=PlaceAmong(of=_bend(EQUATION_9, "quintic"), others=(_bend(EQUATION_4, "cubic"),)),
        accepted=Between(2, 2),
        in_words=True,
    ),
    Sentence(
        claim="a polynomial is efficient on a well-defined path (read as: the coefficients of "
        "Eq. (9) follow the desired path without any search)",
        where="abstract and section V",
        printed=Printed("0", "rad"),
        measure=Computed(
            how="greatest norm of a joint by the printed coefficients",
            value=largest(EQUATION_9, "rms error"),
        ),
        accepted=NONE,
        in_words=True,
    ),
)


def _passed_on() -> float:
    changes = [
        np.abs(moved.desired - path.desired).max()
        for path, moved in zip(QUINTIC, SHIFTED, strict=True)
    ]
    return float(max(changes) / SHIFT)


PASSED_ON = Computed(
    how=f"greatest change of the quintic over the {SHIFT:g} rad by which its start changes",
    value=_passed_on,
)
SENSITIVE = Sentence(
    claim="a polynomial is sensitive to its initial conditions (read as: it makes a change of the "
    "start angles at least 5 % larger)",
    where="section V",
    printed=Printed("1"),
    measure=PASSED_ON,
    accepted=Between(1.05, 100),
    in_words=True,
)


def _in_range(reading: str, measure: Callable[[], int]) -> Sentence:
    return Sentence(
        claim=f"the start and end angles suit the movement limits of the six joints ({reading})",
        where="section IV, Eqs. (10) and (11)",
        printed=Printed("0"),
        measure=Computed(
            how="axes of the real arm out of range at the start or the end",
            value=lambda: float(measure()),
        ),
        accepted=Between(0, 0),
        in_words=True,
    )


ARM = (
    Sentence(
        claim="the arm has six degrees of freedom (at the start and the end angles)",
        where="title and Table IV",
        printed=FREEDOMS,
        measure=Computed(
            how="rank of the Jacobian of Table IV in the standard convention, the lower of the two",
            value=lambda: float(least_freedoms()),
        ),
        accepted=Between(6, 6),
    ),
    Sentence(
        claim="Table IV is the arm R600, whose name gives its reach in mm",
        where="Table IV",
        printed=REACH,
        measure=Computed(
            how="farthest place of the wrist centre from the axis of joint 1", value=reach
        ),
        accepted=Percent(1),  # names are round numbers
    ),
    _in_range("read as angles A1 to A6 of the real arm", partial(axes_out_of_range, START, END)),
    _in_range(
        "read as joint angles θ of Table IV",
        partial(axes_out_of_range, axis_angles(START), axis_angles(END)),
    ),
)

POLYNOMIAL_CLAIMS = (*ENDS, *SMOOTHER, *SHAPES, SENSITIVE, *ARM)
