"""Liang et al.: what the printed numbers must be to each other."""

from papers.liang2026.printed import TABLE_III, TABLE_IV, TABLE_V, TABLE_VI, TIME_SAVED
from repro.tables.relations import (
    PercentLower,
    PrintedPoses,
    Relation,
    TableCell,
    TextNumber,
    row_sums,
)

RELATIONS: tuple[Relation, ...] = (
    *row_sums(TABLE_VI, total="Total Time t", addends=("t1", "t2")),
    PercentLower(
        printed=TextNumber(printed=TIME_SAVED, where="abstract"),
        before=TableCell(table=TABLE_VI, row="Fifth-order polynomial", column="Total Time t"),
        after=TableCell(table=TABLE_VI, row="IWOA", column="Total Time t"),
    ),
    PrintedPoses(
        dh=TABLE_III,
        a="a_{i-1}",
        alpha="α_{i-1}",
        d="d_i",
        joints=TABLE_V,
        positions=TABLE_IV,
    ),
)
