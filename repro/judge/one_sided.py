"""Printed columns whose re-runs all come out on one side of what is accepted."""

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

from repro.judge.findings import Finding

LEAST = 3  # numbers of a column that lie on one side before that is said


@dataclass(frozen=True, slots=True, kw_only=True)
class OneSided:
    """A column of a table: each of its `numbers` re-runs `lower`, or each `higher`, than printed.

    `first` is the position of the first of them among the findings.
    """

    table: str
    column: str
    side: str
    numbers: int
    first: int


def one_sided(findings: Iterable[Finding]) -> tuple[OneSided, ...]:
    """Return the columns of which no number lies within the tolerance or on the other side.

    They are judged by the first repeat, as the tables show it.
    """
    columns: dict[tuple[str, str], list[tuple[int, str]]] = defaultdict(list)
    for position, finding in enumerate(findings):
        if finding.table and finding.column and finding.value is not None:
            columns[finding.table, finding.column].append((position, _side(finding)))
    return tuple(
        OneSided(table=table, column=column, side=own[0][1], numbers=len(own), first=own[0][0])
        for (table, column), own in columns.items()
        if len(own) >= LEAST and own[0][1] and len({side for _, side in own}) == 1
    )


def _side(finding: Finding) -> str:
    low, high = finding.accepted
    if finding.value is None or low <= finding.value <= high:
        return ""
    return "lower" if finding.value < low else "higher"
