"""What the audit says: one row per contradiction or coincidence."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TypedDict

from repro.tables.relations import Cell, Number, TextNumber


class Grade(StrEnum):
    """How strong a row is; the value is the word shown."""

    IMPOSSIBLE = "impossible"
    INCONSISTENT = "inconsistent"
    NOTED = "noted"


class CellPlace(TypedDict):
    """A cell of the row's table, as results files print it."""

    row: str
    column: str


@dataclass(frozen=True, slots=True, kw_only=True)
class AuditRow:
    """One thing that printed numbers say about themselves, with the arithmetic.

    `table` is a label, or a place in the text where no table is concerned. Either one cell is
    concerned, at `row` and `column`, or these are None and `cells` lists those that are. Where the
    row needs more than that numbers are rounded or cut off and computed in single or double
    precision, in any usual order of summing, `condition` says what: the end of "holds if …".
    """

    paper: str
    table: str
    row: str | None
    column: str | None
    cells: tuple[CellPlace, ...]
    check: str
    grade: Grade
    explanation: str
    condition: str | None = None

    @property
    def is_proof(self) -> bool:
        """Whether no runs whatever give the print."""
        return self.grade is Grade.IMPOSSIBLE and self.condition is None


def audit_row(
    paper: str,
    numbers: Sequence[Number],
    *,
    check: str,
    grade: Grade,
    explanation: str,
    condition: str | None = None,
) -> AuditRow:
    """Return the row that concerns `numbers`, filed under the first table among them."""
    cells = [number for number in numbers if not isinstance(number, TextNumber)]
    label = cells[0].label if cells else numbers[0].where
    places = tuple(_places(label, cells))
    alone = places[0] if len(places) == 1 else None
    return AuditRow(
        paper=paper,
        table=label,
        row=alone["row"] if alone else None,
        column=alone["column"] if alone else None,
        cells=() if alone else places,
        check=check,
        grade=grade,
        explanation=explanation,
        condition=condition,
    )


def _places(label: str, cells: Iterable[Cell]) -> Iterable[CellPlace]:
    return (CellPlace(row=cell.row, column=cell.column) for cell in cells if cell.label == label)
