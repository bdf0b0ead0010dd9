"""Every printed table at one glance: by how many powers of ten the re-run is off."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from repro.judge.one_sided import one_sided
from repro.judge.verdict import Verdict
from repro.report.views.findings import Shown, Table

MOST = 6  # powers of ten: what is further off looks the same


@dataclass(frozen=True, slots=True, kw_only=True)
class Square:
    """One printed number on the map: how it looks, what stands in it, and the same in words."""

    anchor: str
    look: str
    text: str
    says: str


@dataclass(frozen=True, slots=True, kw_only=True)
class HeatMap:
    """A printed table as squares; texts, and cells that nothing is said of, are None.

    `one_sided` says which columns have re-runs that all lie on one side.
    """

    label: str
    anchor: str
    headings: tuple[str, ...]
    columns: tuple[str, ...]
    rows: tuple[tuple[tuple[str, ...], tuple[Square | None, ...]], ...]
    one_sided: tuple[str, ...]


def heat_map(table: Table) -> HeatMap:
    """Return the map of a table that is judged."""
    return HeatMap(
        label=table.label,
        anchor=table.anchor,
        headings=table.headings,
        columns=table.columns,
        rows=tuple(
            (headings, tuple(_square(cell) if isinstance(cell, Shown) else None for cell in cells))
            for headings, cells in table.rows
        ),
        one_sided=tuple(_one_sided(table)),
    )


def powers_off(value: float | None, printed: float | None) -> float | None:
    """Return log10 of re-run over printed, cut at `MOST` either way.

    None where there is none: one of the two is missing or zero, or their signs differ.
    """
    if value is None or printed is None or not math.isfinite(value) or 0.0 in (value, printed):
        return None
    if (value < 0.0) is not (printed < 0.0):
        return None
    powers = math.log10(abs(value)) - math.log10(abs(printed))
    return max(-MOST, min(MOST, powers))


def _square(shown: Shown) -> Square:
    look, text, says = _looks(shown)
    finding = shown.finding
    marks = "⚑" * shown.impossible + "◐" * (finding.verdict is Verdict.DEPENDS)
    place = f"{finding.row}, {finding.column}: printed {shown.printed}"
    told = f"{place}, re-run {shown.value}, {says}; {shown.verdict}" if says else f"{place}; {text}"
    impossible = "; cannot be" if shown.impossible else ""
    return Square(anchor=shown.anchor, look=look, text=text + marks, says=told + impossible)


def _looks(shown: Shown) -> tuple[str, str, str]:
    """Return the look of a square, its text, and what it says of re-run and print."""
    value, printed = shown.finding.value, shown.order
    if value is None or printed is None:
        return "none", shown.sign, ""
    low, high = shown.finding.accepted
    if low <= value <= high:
        return "same", "=", "within the tolerance"
    powers = powers_off(value, printed)
    if powers is None:
        return "apart", "0" if 0.0 in (value, printed) else "±", "no ratio"
    sign = "−" if powers < 0.0 else "+"
    whole = math.floor(abs(powers) + 0.5)
    step = min(MOST, max(1, math.ceil(abs(powers))))
    factor = "or more" if abs(powers) == MOST else ""
    says = f"{abs(powers):.1f} powers of ten {factor} {'lower' if powers < 0.0 else 'higher'}"
    look = f"{'low' if powers < 0.0 else 'high'} by-{step}"
    return look, f"{sign}{whole or ''}", " ".join(says.split())


def _one_sided(table: Table) -> Iterable[str]:
    """Yield what columns have numbers that all come out lower, and what all higher."""
    cells = [cell.finding for _, row in table.rows for cell in row if isinstance(cell, Shown)]
    sides: dict[str, list[str]] = {}
    for each in one_sided(cells):
        sides.setdefault(each.side, []).append(f"{each.column} ({each.numbers})")
    for side, columns in sides.items():
        yield f"every number of {', '.join(columns)} re-runs {side} than printed"
