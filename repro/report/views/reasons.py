"""The audit by reason: what one check says, once, with every printed number that it concerns."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from repro.report.views.findings import Place, Shown
from repro.tables.rows import AuditRow, Grade

Groups = dict[str, dict[str, list["Concerned"]]]  # by check, then by condition
PLACES = 4  # of one row before they are counted and no longer listed


@dataclass(frozen=True, slots=True, kw_only=True)
class Concerned:
    """One row of the audit: its `number` from 1 on, and the places that it concerns.

    Each place is its words and the anchor of its number, "" where it is not judged.
    """

    number: int
    row: AuditRow
    label: str
    places: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Reason:
    """Every row that one check gives, by the condition under which it does."""

    check: str
    cases: tuple[tuple[str, tuple[Concerned, ...]], ...]

    @property
    def rows(self) -> int:
        """How many rows of the audit these are."""
        return sum(len(rows) for _, rows in self.cases)


@dataclass(frozen=True, slots=True, kw_only=True)
class Strength:
    """The reasons of one strength, the most frequent first.

    `name` is "proof", "conditional", or a grade.
    """

    name: str
    reasons: tuple[Reason, ...]

    @property
    def rows(self) -> int:
        """How many rows of the audit these are."""
        return sum(reason.rows for reason in self.reasons)


def strengths(audit: Sequence[AuditRow], found: Iterable[Shown]) -> tuple[Strength, ...]:
    """Return the audit with proofs first, then what a condition decides, and what is noted last."""
    anchors = {(s.finding.table, s.finding.row, s.finding.column): s.anchor for s in found}
    groups: dict[str, Groups] = {}
    for number, row in enumerate(audit, start=1):
        own = groups.setdefault(_strength(row), {}).setdefault(row.check, {})
        own.setdefault(row.condition or "", []).append(_concerned(number, row, anchors))
    return tuple(
        Strength(name=name, reasons=tuple(_reasons(groups[name])))
        for name in ("proof", "conditional", str(Grade.INCONSISTENT), str(Grade.NOTED))
        if name in groups
    )


def _strength(row: AuditRow) -> str:
    if row.grade is Grade.IMPOSSIBLE:
        return "proof" if row.is_proof else "conditional"
    return str(row.grade)


def _reasons(groups: Groups) -> list[Reason]:
    found = [
        Reason(check=check, cases=tuple((each, tuple(rows)) for each, rows in own.items()))
        for check, own in groups.items()
    ]
    return sorted(found, key=lambda reason: -reason.rows)


def _concerned(number: int, row: AuditRow, anchors: Mapping[Place, str]) -> Concerned:
    cells = [(row.row, row.column)] if row.row else [(c["row"], c["column"]) for c in row.cells]
    places = tuple(
        (", ".join(filter(None, cell)), anchors.get((row.table, *cell), "")) for cell in cells
    )
    words = [text for text, _ in places]
    if len(words) > PLACES:
        words = [f"{len(words)} numbers"]
    return Concerned(number=number, row=row, label="; ".join(words) or row.table, places=places)
