"""SYJI-0035: what the printed numbers must be to each other."""

from papers.syji.printed import (
    DURATIONS,
    RESULTS,
    SAVED,
    TABLE_1,
    TABLE_2,
    TABLE_3,
    TABLE_4,
    TOTAL,
    WHOLE,
)
from repro.tables.published import Printed, PublishedTable
from repro.tables.relations import (
    EqualSpacing,
    InRange,
    Less,
    Relation,
    SameNumbers,
    Sum,
    TableCell,
    TextNumber,
)


def in_text(printed: Printed) -> TextNumber:
    """Return a number of the text that reports the result."""
    return TextNumber(printed=printed, where=RESULTS)


def column(table: PublishedTable, name: str) -> tuple[TableCell, ...]:
    """Return the cells of a column."""
    return tuple(TableCell(table=table, row=row, column=name) for row in table.row_names)


def ranges() -> dict[str, tuple[TextNumber, TextNumber]]:
    """Return the ends of each joint's range, which Table 1 prints in one cell."""
    found = {}
    for joint, cells in zip(TABLE_1.row_names, TABLE_1.cells, strict=True):
        low, high = str(cells[-1]).replace("°", "").split("~")
        found[joint] = (
            TextNumber(printed=Printed(low, "deg"), where=f"Table 1, joint {joint}"),
            TextNumber(printed=Printed(high, "deg"), where=f"Table 1, joint {joint}"),
        )
    return found


KINDS = ("Velocity", "Acceleration", "Jerk")
RELATIONS: tuple[Relation, ...] = (
    Sum(total=in_text(TOTAL), addends=tuple(in_text(duration) for duration in DURATIONS)),
    Less(
        printed=in_text(SAVED),
        before=TextNumber(printed=WHOLE, where="section 6R robot simulation"),
        after=in_text(TOTAL),
    ),
    *(
        SameNumbers(
            first=column(TABLE_3, f"Maximum {kind}"),
            second=column(TABLE_2, f"{peak} 7"),
            meaning="the limits are what Table 2 prints as peaks of the 5 s motion, so that no "
            "faster motion of that shape obeys them",
        )
        for kind, peak in zip(
            KINDS, ("Maximum velocity", "Maximum acceleration", "Maximum Jerk"), strict=True
        )
    ),
    *(
        EqualSpacing(
            numbers=tuple(
                TableCell(table=TABLE_4, row=joint, column=name) for name in TABLE_4.column_names
            )
        )
        for joint in TABLE_4.row_names
    ),
    *(
        InRange(value=TableCell(table=TABLE_4, row=joint, column=place), low=low, high=high)
        for joint, (low, high) in ranges().items()
        for place in TABLE_4.column_names
    ),
)
