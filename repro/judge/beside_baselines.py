"""Where each algorithm stands beside the baselines, and at equal evaluations."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from repro.judge.certificates import Certificate
from repro.judge.known_minimum import KnownMinimum, known_minimum
from repro.model.evidence import Cell, Runs
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.optimisers.libraries import BASELINES
from repro.runs.baseline_study import STUDY_OF
from repro.runs.equal_budget import EQUAL_BUDGET, unequal
from repro.runs.studies import study_name
from repro.statistics.summary import mean

Vector = NDArray[np.float64]
StandingKind = Literal["printed protocol", "equal evaluations", "baseline", "yours"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Standing:
    """One algorithm on one problem: final costs of one repeat, what a run cost, and its rank.

    `costs` has shape (runs,); `distance` is that of the mean from the known minimum; `seconds` are
    the median of a run. `rank` is that of the mean among all that may spend N·T evaluations, of
    which whole iterations can take fewer, ties sharing their average; None for a run of another
    budget.
    """

    algorithm: str
    kind: StandingKind
    costs: Vector
    evaluations: int
    seconds: float
    distance: float | None
    rank: float | None

    @property
    def mean(self) -> float:
        """Mean final cost."""
        return float(mean(self.costs))

    @property
    def median(self) -> float:
        """Median final cost."""
        return float(np.median(self.costs))


@dataclass(frozen=True, slots=True, kw_only=True)
class ProblemStandings:
    """Every algorithm on one problem, with its known minimum."""

    problem: str
    minimum: KnownMinimum | None
    rows: tuple[Standing, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class BudgetRow:
    """One algorithm of the paper: evaluations of a run and mean rank, as printed and at N·T."""

    algorithm: str
    evaluations: int
    equal_evaluations: int
    rank: float
    equal_rank: float


@dataclass(frozen=True, slots=True, kw_only=True)
class ExperimentStandings:
    """Every algorithm of one experiment and every baseline, problem by problem.

    `budgets` is empty where all of the paper's algorithms spend the same, or were not run again.
    """

    experiment: Experiment
    problems: tuple[ProblemStandings, ...]
    budgets: tuple[BudgetRow, ...]


def paper_standings(
    paper: Paper, runs: Mapping[Cell, Runs], certificates: Sequence[Certificate]
) -> tuple[ExperimentStandings, ...]:
    """Return the standings of every experiment with runs of baselines or at another budget."""
    found = (experiment_standings(each, runs, certificates) for each in paper.experiments)
    return tuple(
        each
        for each in found
        if each.budgets or any(row.kind == "baseline" for p in each.problems for row in p.rows)
    )


def experiment_standings(
    experiment: Experiment,
    runs: Mapping[Cell, Runs],
    certificates: Sequence[Certificate] = (),
    *,
    yours: Sequence[str] = (),
) -> ExperimentStandings:
    """Return where the algorithms of an experiment, the baselines and `yours` stand.

    What was not run is left out. `yours` are found in the experiment's own cells.
    """
    found = []
    for problem in experiment.problems:
        label = f"{experiment.name}/{problem}"
        minimum = known_minimum(label, experiment.problems[problem], certificates)
        rows = _ranked([
            _standing(name, kind, runs[cell], minimum)
            for name, kind, cell in _places(experiment, problem, yours)
            if cell in runs
        ], leave_out=unequal(experiment))  # fmt: skip
        found.append(ProblemStandings(problem=problem, minimum=minimum, rows=rows))
    budgets = budget_rows(experiment, runs)
    return ExperimentStandings(experiment=experiment, problems=tuple(found), budgets=budgets)


def _places(
    experiment: Experiment, problem: str, yours: Sequence[str]
) -> Iterable[tuple[str, StandingKind, Cell]]:
    equal = study_name(experiment.name, EQUAL_BUDGET)
    for name in yours:
        yield name, "yours", (experiment.name, problem, name)
    for name in experiment.algorithms:
        yield name, "printed protocol", (experiment.name, problem, name)
        yield name, "equal evaluations", (equal, problem, name)
    for name in BASELINES:
        yield name, "baseline", (study_name(experiment.name, STUDY_OF[name]), problem, name)


def _standing(name: str, kind: StandingKind, runs: Runs, minimum: KnownMinimum | None) -> Standing:
    costs = runs.costs[0]
    return Standing(
        algorithm=name,
        kind=kind,
        costs=costs,
        evaluations=runs.evaluations,
        seconds=runs.seconds,
        distance=None if minimum is None else float(mean(costs)) - minimum.value,
        rank=None,
    )


def _ranked(rows: Sequence[Standing], leave_out: Iterable[str]) -> tuple[Standing, ...]:
    """Return the rows with the ranks of those that spend the same budget."""
    from scipy.stats import rankdata  # noqa: PLC0415 (slow to load)

    unfair = {(name, "printed protocol") for name in leave_out}
    equal = [row for row in rows if (row.algorithm, row.kind) not in unfair]
    ranks = iter(rankdata([row.mean for row in equal]))
    return tuple(
        row if (row.algorithm, row.kind) in unfair else replace(row, rank=float(next(ranks)))
        for row in rows
    )


def mean_ranks(problems: Sequence[ProblemStandings]) -> Mapping[tuple[str, StandingKind], float]:
    """Return the mean rank over all problems, of each algorithm that has a rank on every one."""
    ranks: dict[tuple[str, StandingKind], list[float]] = {}
    for standing in problems:
        for row in standing.rows:
            if row.rank is not None:
                ranks.setdefault((row.algorithm, row.kind), []).append(row.rank)
    return {place: sum(own) / len(own) for place, own in ranks.items() if len(own) == len(problems)}


def budget_rows(experiment: Experiment, runs: Mapping[Cell, Runs]) -> tuple[BudgetRow, ...]:
    """Return the paper's ranking as printed and at equal evaluations, where all of it was run."""
    equal = study_name(experiment.name, EQUAL_BUDGET)
    again = unequal(experiment)
    printed = dict.fromkeys(experiment.algorithms, experiment.name)
    fair = {name: equal if name in again else experiment.name for name in experiment.algorithms}
    needed = {(place[name], p, name) for place in (printed, fair) for name in place
              for p in experiment.problems}  # fmt: skip
    if not again or not needed <= runs.keys():
        return ()
    before, after = (_mean_ranks(experiment, runs, place) for place in (printed, fair))
    first = next(iter(experiment.problems))
    return tuple(
        BudgetRow(
            algorithm=name,
            evaluations=runs[experiment.name, first, name].evaluations,
            equal_evaluations=runs[fair[name], first, name].evaluations,
            rank=before[name],
            equal_rank=after[name],
        )
        for name in experiment.algorithms
    )


def _mean_ranks(
    experiment: Experiment, runs: Mapping[Cell, Runs], place: Mapping[str, str]
) -> Mapping[str, float]:
    from scipy.stats import rankdata  # noqa: PLC0415 (slow to load)

    means = [
        [mean(runs[place[name], problem, name].costs[0]) for name in place]
        for problem in experiment.problems
    ]
    return dict(zip(place, rankdata(means, axis=1).mean(axis=0).tolist(), strict=True))
