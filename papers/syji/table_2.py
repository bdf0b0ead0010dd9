"""SYJI-0035: what is measured for the cells of Table 2, and how near it must come."""

from collections.abc import Mapping
from functools import partial

from papers.syji.motions import ORDERS
from papers.syji.printed import TABLE_2, WHOLE
from repro.model.claims import CellClaim, computed_cells
from repro.model.measures.measure import Computed
from repro.model.tolerances import RoundedOrCut, Tolerance
from repro.robotics.rest_to_rest import MinimumTime, peaks

AS_HEADED = {"Maximum velocity": 1, "Maximum acceleration": 2, "Maximum Jerk": 3}
ACCELERATION_FIRST = {"Maximum velocity": 2, "Maximum acceleration": 1, "Maximum Jerk": 3}
CUT: Tolerance = RoundedOrCut()


def table_2_claims(
    derivatives: Mapping[str, int] = AS_HEADED, *, within: Tolerance = CUT
) -> tuple[CellClaim, ...]:
    """Return a claim per cell, by the derivative that each heading is taken to mean."""
    return computed_cells(TABLE_2, measure=partial(_greatest_of, derivatives), within=within)


def _greatest_of(derivatives: Mapping[str, int], joint: str, column: str) -> Computed:
    kind, _, order = column.rpartition(" ")
    problem = ORDERS[order]
    return Computed(
        how=f"closed form of the {kind.lower()} of joint {joint}, order {order}, 5 s",
        value=partial(_greatest, problem, derivatives[kind], int(joint) - 1),
    )


def _greatest(problem: MinimumTime, derivative: int, joint: int) -> float:
    return float(peaks(problem, (WHOLE.si,), derivative)[joint])
