"""Liang et al.: where the tool is, by Tables III and V, for the cells of Table IV."""

from functools import partial

from papers.liang2026.experiments import DH
from papers.liang2026.printed import TABLE_IV, TABLE_V
from repro.model.claims import CellClaim, computed_cells
from repro.model.measures.measure import Computed
from repro.model.tolerances import Absolute
from repro.robotics.kinematics import Convention, tool_coordinate

# Four decimals of a radian in five joints, 3.5 m from the base, move the tool by 0.9 mm at most.
TOOL = Absolute(0.001)


def tool_positions(convention: Convention) -> tuple[CellClaim, ...]:
    """Return the claims on Table IV: each position is that which Table V gives by Table III."""
    return computed_cells(TABLE_IV, measure=partial(_position, convention), within=TOOL)


def _position(convention: Convention, waypoint: str, axis: str) -> Computed:
    joints = TABLE_V.column(waypoint)
    return Computed(
        how=f"{axis} of the tool at {waypoint} by Tables III and V, {convention} convention",
        value=partial(tool_coordinate, DH, joints, axis, convention=convention),
    )
