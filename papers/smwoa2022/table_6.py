"""SMWOA: what is measured for the cells of Table 6, and how near it must come."""

from papers.smwoa2022.experiments import TRAJECTORY
from papers.smwoa2022.printed import TABLE_6
from repro.model.claims import CellClaim, every_cell
from repro.model.tolerances import Percent

# Declared before any run. Printed to 1 ms; 1 % lets the searches of two programs differ a little.
TIME = Percent(1)


def table_6(statistic: str) -> tuple[CellClaim, ...]:
    """Return the claims on the durations, by which of the runs they are taken to be."""
    return every_cell(
        TABLE_6,
        of=TRAJECTORY,
        rows=("algorithm",),
        columns="quantity",
        given={"problem": "UR5", "statistic": statistic},
        names={"Total Time": "total"} | {f"h{k}": f"duration {k}" for k in range(1, 6)},
        within=TIME,
    )
