"""How the runs of each printed number are spread, against what is printed of them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from repro.model.claims import CellClaim
from repro.model.evidence import Evidence
from repro.model.identifiers import anchor
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.report.drawings.distribution import Panel, Strip, distribution_plot
from repro.report.drawings.draw import Drawing, drawing
from repro.tables.published import UNITS

PANELS = 6  # in one drawing, so that it stays light; a longer table gets several
MARKED = ("mean", "best", "single")  # the printed statistics that say where runs are


@dataclass(frozen=True, slots=True, kw_only=True)
class Distribution:
    """A drawing of the runs behind a printed table, and the name of its file of data."""

    name: str
    drawing: Drawing


def distributions(paper: Paper, evidence: Evidence) -> tuple[Distribution, ...]:
    """Return a drawing or more for every printed table with claims on statistics of runs.

    Only cells whose runs are there are drawn; a table without any has no drawing.
    """
    found = []
    for table in paper.results:
        of_table = (c for c in paper.claims if isinstance(c, CellClaim))
        claims = sorted(
            (claim for claim in of_table if claim.table is table),
            key=lambda claim: claim.table.row_names.index(claim.row),
        )
        panels = _panels(claims, evidence)
        parts = [panels[start : start + PANELS] for start in range(0, len(panels), PANELS)]
        for number, part in enumerate(parts, start=1):
            label = f"{table.label}, part {number}" if len(parts) > 1 else table.label
            found.append(_distribution(evidence.key, label, part))
    return tuple(found)


def _distribution(key: str, label: str, panels: Sequence[Panel]) -> Distribution:
    name = anchor("runs", label)
    return Distribution(
        name=name,
        drawing=drawing(
            lambda: distribution_plot(panels),
            title=f"Runs behind {label}",
            identifier=anchor(key, name),
        ),
    )


def _panels(claims: Sequence[CellClaim], evidence: Evidence) -> list[Panel]:
    """Return one panel per problem and quantity, a strip per algorithm, in the table's order."""
    printed: dict[tuple[str, str, str], dict[str, dict[str, float]]] = {}
    units: dict[tuple[str, str, str], str] = {}
    for claim in claims:
        measure = claim.measure
        if isinstance(measure, Statistic) and measure.cell in evidence.runs:
            panel = (measure.experiment, measure.problem, measure.quantity)
            units.setdefault(panel, claim.printed.unit)
            marks = printed.setdefault(panel, {}).setdefault(measure.algorithm, {})
            if measure.statistic in MARKED:
                marks[measure.statistic] = claim.printed.value
    return [
        _panel(panel, units[panel], algorithms, evidence) for panel, algorithms in printed.items()
    ]


def _panel(
    place: tuple[str, str, str],
    unit: str,
    printed: Mapping[str, Mapping[str, float]],
    evidence: Evidence,
) -> Panel:
    experiment, problem, quantity = place
    return Panel(
        title=problem if quantity == "cost" else f"{problem}: {quantity}",
        unit=unit,
        strips=tuple(
            Strip(
                algorithm=name,
                values=evidence.values((experiment, problem, name), quantity).ravel() / UNITS[unit],
                printed=marks,
            )
            for name, marks in printed.items()
        ),
    )
