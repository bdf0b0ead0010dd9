"""What the pages show of the calibration: what truthful and false papers get, and a paper's own."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from repro.judge.judgement import Judgement
from repro.judge.verdict import Verdict
from repro.model.claims import CellClaim
from repro.model.measures.measure import Statistic
from repro.report.words import SYMBOLS
from repro.statistics.summary import STATISTICS

Row = Mapping[str, Any]
TRUTH = 1.0
NOT_JUDGED = (Verdict.NOT_REPRODUCIBLE, Verdict.NOT_RUN)
SAID = (Verdict.REPRODUCED, Verdict.CONSISTENT, Verdict.UNDECIDED, Verdict.CONTRADICTED)
"""What the calibration judges: one reading alone, of which no verdict depends."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Truthful:
    """What a paper that prints our own tables would get for as many cells of each statistic.

    `expected` sums to `cells`; `own` is what these cells of the paper have; `repeats` the depth of
    the calibration, the nearest that is not deeper than the paper's.
    """

    cells: int
    repeats: int
    expected: Mapping[Verdict, int]
    own: Mapping[Verdict, int]

    @property
    def says(self) -> str:
        """What such a paper would get, as a sentence."""
        would = ", ".join(f"{self.expected[verdict]} {verdict}" for verdict in SAID)
        have = ", ".join(f"{count} {verdict}" for verdict, count in self.own.items())
        cells = f"{self.cells} cell{'s' if self.cells != 1 else ''}"
        return (
            f"A paper that prints our own tables would get about {would} of these {cells} that "
            f"print a best, worst, mean or std of costs. By the re-run alone this one has {have}."
        )


def truthful(judgement: Judgement, rows: Sequence[Row]) -> Truthful | None:
    """Return what a truthful paper would have scored; None where nothing is calibrated or judged.

    `rows` are those of the calibration.
    """
    statistics = [
        (claim.measure.statistic, finding.as_run or finding.verdict)
        for claim, finding in zip(judgement.paper.said, judgement.findings, strict=True)
        if isinstance(claim, CellClaim)
        and isinstance(claim.measure, Statistic)
        and claim.measure.quantity == "cost"  # the calibration is of costs
        and claim.measure.statistic in STATISTICS  # and of what most tables print
        and finding.verdict not in NOT_JUDGED
    ]
    depths = [row["repeats"] for row in rows if row["repeats"] <= judgement.repeats]
    shares = _shares(rows, max(depths, default=0))
    if not depths or not statistics or not {name for name, _ in statistics} <= shares.keys():
        return None
    sums = {verdict: sum(shares[name].get(verdict, 0.0) for name, _ in statistics)
            for verdict in SAID}  # fmt: skip
    own = Counter(verdict for _, verdict in statistics)
    return Truthful(
        cells=len(statistics),
        repeats=max(depths),
        expected=_whole(sums, len(statistics)),
        own={verdict: own[verdict] for verdict in Verdict if own[verdict]},
    )


def _shares(rows: Iterable[Row], repeats: int) -> Mapping[str, Mapping[str, float]]:
    """Return the share of each verdict among true tables, by statistic."""
    found: dict[str, dict[str, float]] = {}
    for row in rows:
        if row["repeats"] == repeats and row["factor"] == TRUTH:
            found.setdefault(row["statistic"], {})[row["verdict"]] = row["share"]
    return found


def _whole(sums: Mapping[Verdict, float], total: int) -> Mapping[Verdict, int]:
    """Return whole numbers that sum to the total: what is left over goes to the largest rests."""
    whole = {verdict: int(number) for verdict, number in sums.items()}
    rests = sorted(sums, key=lambda verdict: whole[verdict] - sums[verdict])
    for verdict in rests[: total - sum(whole.values())]:
        whole[verdict] += 1
    return whole


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """A table in words: what it is of, its headings and its rows."""

    name: str
    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def share_sheets(rows: Sequence[Row]) -> list[Sheet]:
    """Return, for each depth, the share of each verdict by statistic and factor."""
    cells: dict[int, dict[tuple[str, float], dict[str, float]]] = {}
    for row in rows:
        place = row["statistic"], row["factor"]
        cells.setdefault(row["repeats"], {}).setdefault(place, {})[row["verdict"]] = row["share"]
    return [
        Sheet(
            name=f"{repeats} repeat{'s' if repeats != 1 else ''}",
            headings=("statistic", "distance", *(f"{SYMBOLS[v]} {v}" for v in SAID)),
            rows=tuple(
                (statistic, _value(factor), *(_percent(shares.get(v, 0.0)) for v in SAID))
                for (statistic, factor), shares in places.items()
            ),
        )
        for repeats, places in sorted(cells.items())
    ]


def coverage_sheet(rows: Sequence[Row]) -> Sheet:
    """Return how often the next table lies in its prediction interval, by kind of costs.

    In brackets stands what plain resampling would reach, where that is known.
    """
    depths = sorted({row["repeats"] for row in rows})
    places: dict[tuple[str, str], dict[int, str]] = {}
    for row in rows:
        plain = row.get("resampled")
        reached = _percent(row["reached"]) + (f" ({_percent(plain)})" if plain is not None else "")
        places.setdefault((row["kind"], row["statistic"]), {})[row["repeats"]] = reached
    return Sheet(
        name="coverage",
        headings=(
            "costs",
            "statistic",
            *(f"{depth} repeat{'s' if depth != 1 else ''}" for depth in depths),
        ),
        rows=tuple(
            (kind, statistic, *(found.get(depth, "–") for depth in depths))
            for (kind, statistic), found in places.items()
        ),
    )


def _value(factor: float) -> str:
    if factor == TRUTH:
        return "true"
    return f"×{factor:g}" if factor > TRUTH else f"÷{1.0 / factor:g}"


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %"
