"""SMWOA: what the printed numbers must be to each other."""

from papers.smwoa2022.printed import BEFORE, TABLE_3, TABLE_6, TIME_SAVED
from repro.tables.relations import (
    AverageRank,
    PercentLower,
    PValues,
    Relation,
    TableCell,
    TextNumber,
    row_sums,
)

RELATIONS: tuple[Relation, ...] = (
    AverageRank(
        table=TABLE_3,
        rows=tuple(name for name in TABLE_3.row_names if name.endswith("Avg")),
        columns=TABLE_3.column_names,
        average="Average ranking",
        total="Total rank",
    ),
    PValues(
        numbers=tuple(
            TableCell(table=TABLE_3, row="p/h", column=name) for name in TABLE_3.column_names[1:]
        ),
        test="rank-sum",
        n=30,
    ),
    *row_sums(TABLE_6, total="Total Time", addends=("h1", "h2", "h3", "h4", "h5")),
    PercentLower(
        printed=TextNumber(printed=TIME_SAVED, where="abstract and section 4.3"),
        before=TextNumber(printed=BEFORE, where="section 4.3, Fig. 3"),
        after=TableCell(table=TABLE_6, row="SMWOA", column="Total Time"),
    ),
)
