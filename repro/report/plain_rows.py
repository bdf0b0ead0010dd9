"""Tests and standings as plain rows, which have the same names whatever is tested."""

from collections.abc import Iterable, Iterator
from typing import Any

from repro.judge.beside_baselines import ExperimentStandings, ProblemStandings
from repro.judge.centre_bias import CentreBias
from repro.judge.rank_tests import AlgorithmTests
from repro.statistics.friedman import Friedman

Row = dict[str, Any]
TEST: Row = dict.fromkeys((
    *("test", "experiment", "problem", "algorithm", "against", "p", "holm", "wins", "wins_low"),
    *("wins_high", "rank", "critical_difference", "problems"),
))  # fmt: skip
STANDING: Row = dict.fromkeys((
    *("experiment", "problem", "algorithm", "kind", "runs", "evaluations", "mean", "median"),
    *("minimum", "minimum_how", "distance", "rank"),
))  # fmt: skip
RANK_SUM, FRIEDMAN = "rank sum", "Friedman"


def rows_of_tests(found: Iterable[AlgorithmTests]) -> list[Row]:
    """Return a row for each rank-sum test and one for each algorithm's rank in Friedman's.

    Names are those of `RankSumTest` and `Friedman`; what a test has not is None. `p` of Friedman's
    is that all ranks of the experiment are equal.
    """
    return [{**TEST, **row} for each in found for row in _tests(each)]


def _tests(found: AlgorithmTests) -> Iterator[Row]:
    own = found.experiment
    for test in found.tests:
        low, high = test.interval
        yield {
            "test": RANK_SUM, "experiment": own.name, "problem": test.problem,
            "algorithm": own.proposed, "against": test.against, "p": test.p, "holm": test.holm,
            "wins": test.wins, "wins_low": low, "wins_high": high,
        }  # fmt: skip
    if found.friedman:
        yield from _ranks(own.name, tuple(own.algorithms), found.friedman)


def _ranks(experiment: str, names: Iterable[str], found: Friedman) -> Iterator[Row]:
    for name, rank in zip(names, found.ranks, strict=True):
        yield {
            "test": FRIEDMAN, "experiment": experiment, "algorithm": name, "p": found.p,
            "rank": rank, "critical_difference": found.critical_difference,
            "problems": found.problems,
        }  # fmt: skip


def rows_of_standings(found: Iterable[ExperimentStandings]) -> list[Row]:
    """Return a row for each algorithm on each problem, beside the baselines.

    Names are those of `Standing`; how long a run took stands in the provenance. A row without a
    problem is the mean rank over all of them, as printed and at equal evaluations (`BudgetRow`).
    """
    return [{**STANDING, **row} for each in found for row in _standings(each)]


def _standings(found: ExperimentStandings) -> Iterator[Row]:
    name = found.experiment.name
    for standing in found.problems:
        yield from ({"experiment": name, **row} for row in _on_problem(standing))
    for row in found.budgets:
        for kind, evaluations, rank in (
            ("printed protocol", row.evaluations, row.rank),
            ("equal evaluations", row.equal_evaluations, row.equal_rank),
        ):
            yield {
                "experiment": name, "algorithm": row.algorithm, "kind": kind,
                "evaluations": evaluations, "rank": rank,
            }  # fmt: skip


def _on_problem(found: ProblemStandings) -> Iterator[Row]:
    minimum = found.minimum
    for row in found.rows:
        yield {
            "problem": found.problem, "algorithm": row.algorithm, "kind": row.kind,
            "runs": len(row.costs), "evaluations": row.evaluations, "mean": row.mean,
            "median": row.median, "minimum": minimum.value if minimum else None,
            "minimum_how": minimum.how if minimum else None, "distance": row.distance,
            "rank": row.rank,
        }  # fmt: skip


def rows_of_bias(found: CentreBias | None) -> list[Row]:
    """Return a row for each algorithm at each shift; none where no optimum was moved.

    Names are those of `Bias`, and `low` and `high` are the ends of its interval.
    """
    if found is None:
        return []
    return [
        {
            "experiment": found.experiment.name, "algorithm": bias.algorithm, "shift": bias.shift,
            "runs": found.runs, "ratio": bias.ratio, "low": bias.interval[0],
            "high": bias.interval[1], "p": bias.p, "flagged": bias.flagged,
        }
        for bias in found.biases
    ]  # fmt: skip
