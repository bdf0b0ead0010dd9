"""How the judge does on tables whose truth is known: our own runs, printed as a paper would."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.determinism.seeds import generator
from repro.functions import BenchmarkProblem
from repro.judge.findings import LEVEL, judged
from repro.judge.verdict import Verdict
from repro.model.cells import every_cell
from repro.model.claims import CellClaim
from repro.model.evidence import Evidence, Runs
from repro.model.experiment import Experiment
from repro.model.measures.measure import TABLES
from repro.model.tolerances import FromMinimum, Interval
from repro.optimisers.random_search import RandomSearch
from repro.statistics.summary import STATISTICS
from repro.statistics.tables import quantile_interval
from repro.tables.published import Printed, PublishedTable

Vector = NDArray[np.float64]
Row = dict[str, object]
KNOWN = ("best", "worst", "mean", "std")
FACTORS = (0.01, 0.1, 1.0, 3.0, 10.0, 100.0)
"""How many times as far from the minimum a printed value lies as the true one."""
SAID = (Verdict.REPRODUCED, Verdict.CONSISTENT, Verdict.UNDECIDED, Verdict.CONTRADICTED)
KINDS = ("narrow", "rare outliers", "decades", "quantised")
SAME = 1e-12  # share of a value by which sums of the same runs in another order may differ
_PLACE = ("calibration", "problem", "search")


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownTable:
    """Runs that were made: `stored`, shape (repeats, n), are ours, `new`, shape (n,), a paper's.

    `name` is that of the random numbers which the judge draws.
    """

    name: str
    kind: str
    problem: BenchmarkProblem
    stored: Vector
    new: Vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Trial:
    """What the judge says of one value that lies `factor` times as far from the minimum as it did.

    `covered` says whether the interval held the true value, `resampled` whether one would have that
    comes from resampling the stored runs alone.
    """

    kind: str
    repeats: int
    statistic: str
    factor: float
    verdict: Verdict
    covered: bool
    resampled: bool


def kind_of(costs: Vector, problem: BenchmarkProblem) -> str:
    """Return what the costs of many runs, shape (runs,), look like, as one of `KINDS`.

    "quantised": most runs share their cost with another, as those within a few steps of double
    arithmetic from the minimum do; "narrow": distances from the minimum span less than a decade;
    "rare outliers": those of 95 in 100 runs do; "decades": the rest.
    """
    away = np.sort(costs) - problem.function.minimum
    alone = np.unique(costs, return_counts=True)[1] == 1
    if alone.sum() < away.size / 2:
        return "quantised"
    if away[-1] < 10.0 * away[0]:
        return "narrow"
    low, high = quantile_interval(away, LEVEL)
    return "rare outliers" if high < 10.0 * low else "decades"


def drawn(
    costs: Vector, *, name: str, kind: str, problem: BenchmarkProblem, repeats: int, runs: int
) -> KnownTable:
    """Return a new table and stored ones, drawn without replacement from costs, shape (any,)."""
    rng = generator("calibration", name, repeats)
    found = rng.permutation(costs)[: (repeats + 1) * runs].reshape(repeats + 1, runs)
    return KnownTable(name=name, kind=kind, problem=problem, stored=found[1:], new=found[0])


def trials(known: KnownTable) -> Iterator[Trial]:
    """Yield what the judge says of each statistic of the new table, true and false.

    A false value is left out where its print and that of the truth overlap: no reader can tell.
    """
    cost = np.empty(0)
    runs = Runs(costs=known.stored, points=cost, histories=np.zeros(0), evaluations=0)
    experiment = _experiment(known)
    evidence = Evidence(f"calibration/{known.name}", (experiment,), {_PLACE: runs})
    plain = resampled(known)
    for factor in FACTORS:
        for claim in _claims(known, experiment, factor):
            finding, _ = judged(claim, evidence)
            if finding.measured is None:  # never: the runs are there
                continue
            true = float(STATISTICS[claim.column](known.new))
            yield Trial(
                kind=known.kind,
                repeats=len(known.stored),
                statistic=claim.column,
                factor=factor,
                verdict=finding.verdict,
                covered=_holds(finding.measured, true),
                resampled=_holds(plain[claim.column], true),
            )


def resampled(known: KnownTable) -> dict[str, Interval]:
    """Return what plain resampling of the stored runs expects, for comparison alone."""
    rng = generator("resampled", known.name, len(known.stored))
    tables = rng.choice(known.stored.ravel(), (TABLES, known.new.size))
    return {name: quantile_interval(STATISTICS[name](tables), LEVEL) for name in KNOWN}


def verdict_rows(tried: Iterable[Trial]) -> list[Row]:
    """Return how often each verdict fell, by repeats, statistic and factor; shares add up to 1."""
    said: defaultdict[tuple[int, str, float], Counter[Verdict]] = defaultdict(Counter)
    for trial in tried:
        said[trial.repeats, trial.statistic, trial.factor][trial.verdict] += 1
    return [
        {
            "repeats": repeats,
            "statistic": statistic,
            "factor": factor,
            "verdict": str(verdict),
            "share": round(fell[verdict] / fell.total(), 3),
        }
        for (repeats, statistic, factor), fell in sorted(said.items(), key=_order)
        for verdict in SAID
    ]


def coverage_rows(tried: Iterable[Trial]) -> list[Row]:
    """Return how often the interval held a true value, by kind, repeats and statistic.

    Beside it: how often resampling would have, and how often the truth was contradicted.
    """
    true: defaultdict[tuple[str, int, str], list[Trial]] = defaultdict(list)
    for trial in tried:
        if trial.factor == 1:
            true[trial.kind, trial.repeats, trial.statistic].append(trial)
    return [
        {
            "kind": kind,
            "repeats": repeats,
            "statistic": statistic,
            "promised": LEVEL,
            "reached": _share(trial.covered for trial in found),
            "resampled": _share(trial.resampled for trial in found),
            "contradicted": _share(trial.verdict is Verdict.CONTRADICTED for trial in found),
        }
        for (kind, repeats, statistic), found in sorted(true.items())
    ]


def _experiment(known: KnownTable) -> Experiment:
    name, problem, search = _PLACE
    return Experiment(
        name=name,
        where="",
        proposed=search,
        problems={problem: known.problem},
        algorithms={search: RandomSearch()},  # none is run: it only has the name
        population=1,
        iterations=1,
        runs=known.new.size,
    )


def _claims(known: KnownTable, experiment: Experiment, factor: float) -> tuple[CellClaim, ...]:
    """Return the claims of a table that prints every value so many times as far off."""
    shown = {name: _printed(known, name, factor) for name in KNOWN}
    true = {name: _printed(known, name, 1.0) for name in KNOWN}
    cells = [name for name in KNOWN if factor == 1 or _apart(shown[name], true[name])]
    if not cells:
        return ()
    page = (
        "Table 1, made up",
        f"Problem | Algorithm || {' | '.join(cells)}",
        f"{_PLACE[1]} | {_PLACE[2]} || {' | '.join(shown[name].text for name in cells)}",
    )
    return every_cell(
        PublishedTable.read("\n".join(page)),
        of=experiment,
        rows=("problem", "algorithm"),
        columns="statistic",
        within=FromMinimum(),
    )


def _printed(known: KnownTable, statistic: str, factor: float) -> Printed:
    true = float(STATISTICS[statistic](known.new))
    minimum = 0.0 if statistic == "std" else known.problem.function.minimum
    value = true if factor == 1 else minimum + factor * (true - minimum)
    return Printed(f"{value:.2e}")  # three significant digits


def _apart(one: Printed, other: Printed) -> bool:
    return abs(one.value - other.value) > one.rounding + other.rounding


def _holds(interval: Interval, value: float) -> bool:
    slack = SAME * abs(value)
    return interval[0] - slack <= value <= interval[1] + slack


def _order(item: tuple[tuple[int, str, float], object]) -> tuple[int, int, float]:
    (repeats, statistic, factor), _ = item
    return repeats, KNOWN.index(statistic), factor


def _share(said: Iterable[bool]) -> float:
    return round(float(np.mean(list(said))), 3)
