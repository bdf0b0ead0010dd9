"""Measures that compare algorithms over several problems at once: mean ranks and rank-sum tests."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from types import MappingProxyType
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.model.evidence import Cell, Evidence
from repro.model.measures.measure import Measured, Statistic
from repro.model.measures.to_come import tables_to_come
from repro.statistics.pairs import paired_p
from repro.statistics.places import Ties
from repro.statistics.rank_sum import rank_sums
from repro.tables.relations import RankTest

Vector = NDArray[np.float64]
TEST_TABLES = 400  # tables per test: its 2.5 % tail then holds 10 of them
LEVEL = 0.05
Samples = Literal["all runs", "averages", "each problem"]
SAMPLES: Mapping[Samples, str] = MappingProxyType(
    {
        "all runs": "all runs on all problems together",
        "averages": "the averages of the problems",
        "each problem": "problem by problem, p-values averaged",
    }
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Contest:
    """Algorithms ranked on each of several problems by a statistic of their runs.

    1 is for the lowest; ties share the mean of their places, if `ties` says no other way.
    """

    experiment: str
    problems: tuple[str, ...]
    algorithms: tuple[str, ...]
    statistic: str = "mean"
    ties: Ties = "average"

    @property
    def words(self) -> str:
        """What is ranked, as a phrase."""
        shared = "" if self.ties == "average" else f", ties {self.ties}"
        return f"{self.statistic} cost among {', '.join(self.algorithms)}{shared}"

    def statistics(self, problem: str) -> tuple[Statistic, ...]:
        """Return the statistic of each algorithm on one problem."""
        return tuple(
            Statistic(
                experiment=self.experiment,
                problem=problem,
                algorithm=algorithm,
                statistic=self.statistic,
            )
            for algorithm in self.algorithms
        )

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of every algorithm on every problem."""
        return tuple(product((self.experiment,), self.problems, self.algorithms))

    def ranks(self, evidence: Evidence) -> tuple[Vector, int]:
        """Return ranks (problems, algorithms, 1 + tables), the first repeat first, and repeats."""
        return evidence.remember(("ranks", self), partial(self._ranks, evidence))

    def _ranks(self, evidence: Evidence) -> tuple[Vector, int]:
        # problem by problem, so that one whose runs a reading leaves as they are is ranked once
        alone = [replace(self, problems=(problem,)) for problem in self.problems]
        found = [evidence.remember(one, partial(one.on_its_problem, evidence)) for one in alone]
        return np.array([ranks for ranks, _ in found]), min(repeats for _, repeats in found)

    def on_its_problem(self, evidence: Evidence) -> tuple[Vector, int]:
        """Return ranks (algorithms, 1 + tables) on the one problem of the contest, and repeats."""
        from scipy.stats import rankdata  # noqa: PLC0415 (slow to load)

        (problem,) = self.problems
        found = [statistic.measure(evidence) for statistic in self.statistics(problem)]
        costs = [np.append(each.value, each.draws) for each in found]
        return rankdata(costs, axis=0, method=self.ties), min(each.repeats for each in found)

    def of(self, algorithm: str) -> int:
        """Return the position of an algorithm; DeclarationError where it does not take part."""
        if algorithm not in self.algorithms:
            message = (
                f"{algorithm!r} takes no part in the contest of {self.experiment!r}, which is "
                f"among {', '.join(self.algorithms)}"
            )
            raise DeclarationError(message)
        return self.algorithms.index(algorithm)


@dataclass(frozen=True, slots=True, kw_only=True)
class MeanRank:
    """An algorithm's rank in a contest, averaged over the problems."""

    follows: ClassVar[bool] = False
    contest: Contest
    algorithm: str

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return f"mean rank of {self.algorithm} by {self.contest.words}"

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of the contest."""
        return self.contest.cells()

    def measure(self, evidence: Evidence) -> Measured:
        """Return the mean rank in the first repeat and in tables that may come next."""
        ranks, repeats = self.contest.ranks(evidence)
        return _measured(ranks.mean(axis=0)[self.contest.of(self.algorithm)], repeats)


@dataclass(frozen=True, slots=True, kw_only=True)
class ContestPlace:
    """An algorithm's place by mean rank, 1 for the lowest; ties share the better place."""

    follows: ClassVar[bool] = False
    contest: Contest
    algorithm: str

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return (
            f"place of {self.algorithm} by mean rank over {', '.join(self.contest.problems)}, by "
            f"{self.contest.words}"
        )

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of the contest."""
        return self.contest.cells()

    def measure(self, evidence: Evidence) -> Measured:
        """Return the place in the first repeat and in tables that may come next."""
        from scipy.stats import rankdata  # noqa: PLC0415 (slow to load)

        ranks, repeats = self.contest.ranks(evidence)
        # sums of ranks are exact, so that equal ones tie; their means may differ in the last bit
        places = rankdata(ranks.sum(axis=0), axis=0, method="min")
        return _measured(places[self.contest.of(self.algorithm)], repeats)


@dataclass(frozen=True, slots=True, kw_only=True)
class Firsts:
    """On how many problems of a contest an algorithm is first, or shares that place."""

    follows: ClassVar[bool] = False
    contest: Contest
    algorithm: str

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return f"problems on which {self.algorithm} is first by {self.contest.words}"

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of the contest."""
        return self.contest.cells()

    def measure(self, evidence: Evidence) -> Measured:
        """Return the count in the first repeat and in tables that may come next."""
        ranks, repeats = self.contest.ranks(evidence)
        first = ranks[:, self.contest.of(self.algorithm)] == ranks.min(axis=1)
        return _measured(first.sum(axis=0, dtype=np.float64), repeats)


@dataclass(frozen=True, slots=True, kw_only=True)
class RankSum:
    """Wilcoxon's rank-sum test of one algorithm against another over several problems.

    By "signed-rank" it is his test of pairs: the runs as they follow each other, or the averages.
    `samples` says what is compared: all runs on all problems together, the averages of the
    problems, or the runs problem by problem, whose p-values are then averaged. The p-value is
    two-sided, by the normal approximation with tie and continuity correction, pairs that are equal
    left out. As a `sign` it is
    1 where the algorithm's costs are the lower at the 5 % level, -1 where they are the higher, else
    0.
    """

    follows: ClassVar[bool] = False
    experiment: str
    problems: tuple[str, ...]
    algorithm: str
    against: str
    sign: bool = False
    samples: Samples = "all runs"
    by: RankTest = "rank-sum"

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        kind = "sign" if self.sign else "p-value"
        return (
            f"{kind} of the {self.by} test of {self.algorithm} against {self.against}, "
            f"{SAMPLES[self.samples]}, {len(self.problems)} problems"
        )

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of both algorithms on every problem."""
        return tuple(product((self.experiment,), self.problems, (self.algorithm, self.against)))

    def measure(self, evidence: Evidence) -> Measured:
        """Return p or sign in the first repeat and in tables that may come next."""
        return evidence.remember(self, partial(self._measure, evidence))

    def _measure(self, evidence: Evidence) -> Measured:
        test = replace(self, sign=False)
        p, lower = evidence.remember(("test", test), partial(test.test, evidence))
        found = np.where(p < LEVEL, np.where(lower, 1.0, -1.0), 0.0) if self.sign else p
        return _measured(found, min(len(evidence.values(cell)) for cell in self.cells()))

    def test(self, evidence: Evidence) -> tuple[Vector, NDArray[np.bool_]]:
        """Return p in the first repeat and in tables to come, and whether costs rank lower."""
        own, others = (self._tables(evidence, name) for name in (self.algorithm, self.against))
        tested = _signed_rank if self.by == "signed-rank" else rank_sums
        p, lower = tested(self._sample(own), self._sample(others))
        if self.samples == "each problem":
            p = np.mean([tested(x, y)[0] for x, y in zip(own, others, strict=True)], axis=0)
        return p, lower

    def _sample(self, tables: list[Vector]) -> Vector:
        """Return what is ranked together, shape (1 + tables, values)."""
        if self.samples == "averages":
            return np.stack([table.mean(axis=-1) for table in tables], axis=-1)
        return np.hstack(tables)

    def _tables(self, evidence: Evidence, algorithm: str) -> list[Vector]:
        """Return per problem the first repeat, then tables to come: (1 + tables, runs) each."""
        tables = []
        for problem in self.problems:
            cell = (self.experiment, problem, algorithm)
            values = evidence.values(cell)
            ends = evidence.floor(cell), evidence.ceiling(cell)
            drawn = tables_to_come(values, evidence.key, *cell, tables=TEST_TABLES, ends=ends)
            tables.append(np.vstack([values[:1], drawn]))
        return tables


def _measured(values: Vector, repeats: int) -> Measured:
    """Return what was measured: the first value belongs to the first repeat."""
    return Measured(value=float(values[0]), draws=values[1:], repeats=repeats)


def _signed_rank(x: Vector, y: Vector) -> tuple[Vector, NDArray[np.bool_]]:
    """Return two-sided p-values of pairs, row by row, and whether x ranks lower than y."""
    with np.errstate(invalid="ignore"):
        differences = np.where(x == y, 0.0, x - y)  # two infinite costs are equal
    found = [paired_p(row) for row in differences]
    return np.array([p for p, _ in found]), np.array([lower for _, lower in found])
