"""What the pages say of the algorithms of one experiment against each other."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from repro.determinism.seeds import generator
from repro.judge.findings import Finding
from repro.model.claims import Claim
from repro.model.evidence import Evidence
from repro.model.experiment import Experiment
from repro.model.measures.ranks import MeanRank, RankSum
from repro.report.drawings.draw import Drawing, drawing
from repro.report.drawings.ranks import rank_plot
from repro.report.drawings.style import Rows
from repro.report.words import anchor, number
from repro.statistics.effect_size import win_interval, win_probability
from repro.statistics.friedman import Friedman, friedman
from repro.statistics.rank_sum import holm, rank_sum_p
from repro.statistics.summary import mean

Judged = Iterable[tuple[Claim, Finding]]
Pair = tuple[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Ranking:
    """Average ranks by the mean cost of the first repeat, with what the paper prints of them.

    `rows` holds (algorithm, average rank), and the printed average rank where any is printed.
    """

    friedman: Friedman
    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    drawing: Drawing


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """Tests of the proposed algorithm against the others, on the first repeat.

    `rows` holds problem and one text per other algorithm, `data` the same for programs, `printed`
    each p-value that the paper prints: (other, printed, re-run).
    """

    experiment: Experiment
    others: tuple[str, ...]
    rows: tuple[tuple[str, tuple[str, ...]], ...]
    data: Rows
    budgets: tuple[tuple[str, int], ...]
    printed: tuple[tuple[str, str, str], ...]
    ranking: Ranking | None

    def tables(self) -> tuple[tuple[str, Rows], ...]:
        """Return the kind and the rows of each table of data."""
        ranks = (("ranks", self.ranking.drawing.rows),) if self.ranking else ()
        return (("rank-sum", self.data), *ranks) if self.others else ranks


@dataclass(frozen=True, slots=True, kw_only=True)
class _Test:
    """The proposed algorithm against another on one problem."""

    p: float
    wins: float
    interval: tuple[float, float]


def comparisons(evidence: Evidence, findings: Sequence[Finding]) -> tuple[Comparison, ...]:
    """Return the tests of every experiment whose runs are all there.

    `findings` are those of the paper's claims, in their order.
    """
    judged = list(zip(evidence.paper.claims, findings, strict=True))
    return tuple(
        _comparison(experiment, evidence, judged)
        for experiment in evidence.paper.experiments
        if all(
            (experiment.name, problem, algorithm) in evidence.runs
            for problem in experiment.problems
            for algorithm in experiment.algorithms
        )
    )


def _comparison(experiment: Experiment, evidence: Evidence, judged: Judged) -> Comparison:
    others = tuple(name for name in experiment.algorithms if name != experiment.proposed)
    tests = {
        (problem, other): _test(experiment, problem, other, evidence)
        for problem in experiment.problems
        for other in others
    }
    corrected = dict(zip(tests, holm(np.array([t.p for t in tests.values()])), strict=True))
    first = next(iter(experiment.problems))
    return Comparison(
        experiment=experiment,
        others=others,
        rows=tuple(
            (problem, tuple(_words(tests[problem, o], corrected[problem, o]) for o in others))
            for problem in experiment.problems
        ),
        data=_data(experiment.proposed, tests, corrected),
        budgets=tuple(
            (name, evidence.runs[experiment.name, first, name].evaluations)
            for name in experiment.algorithms
        ),
        printed=_printed_p_values(experiment, judged),
        ranking=_ranking(experiment, evidence, judged),
    )


def _test(experiment: Experiment, problem: str, other: str, evidence: Evidence) -> _Test:
    own, costs = (
        evidence.values((experiment.name, problem, name))[0]
        for name in (experiment.proposed, other)
    )
    rng = generator("wins", evidence.paper.key, experiment.name, problem, other)
    return _Test(
        p=rank_sum_p(own, costs),
        wins=win_probability(own, costs),
        interval=win_interval(own, costs, rng=rng),
    )


def _words(test: _Test, corrected: float) -> str:
    low, high = test.interval
    return (
        f"p = {number(test.p)}, Holm {number(float(corrected))}, "
        f"wins {test.wins:.2f} [{low:.2f}, {high:.2f}]"
    )


def _data(proposed: str, tests: Mapping[Pair, _Test], corrected: Mapping[Pair, float]) -> Rows:
    headings = ("problem", "algorithm", "against", "p", "p by Holm", "wins", "low", "high")
    return (
        headings,
        *(
            (problem, proposed, other, *(f"{value:.6g}" for value in values))
            for (problem, other), test in tests.items()
            for values in [(test.p, corrected[problem, other], test.wins, *test.interval)]
        ),
    )


def _printed_p_values(experiment: Experiment, judged: Judged) -> tuple[tuple[str, str, str], ...]:
    return tuple(
        (claim.measure.against, claim.printed.text, number(finding.value))
        for claim, finding in judged
        if isinstance(claim.measure, RankSum)
        and claim.measure.experiment == experiment.name
        and not claim.measure.sign
        and finding.table
    )


def _ranking(experiment: Experiment, evidence: Evidence, judged: Judged) -> Ranking | None:
    names = tuple(experiment.algorithms)
    if len(names) < 3 or len(experiment.problems) < 2:
        return None
    means = [
        [mean(evidence.values((experiment.name, problem, name))[0]) for name in names]
        for problem in experiment.problems
    ]
    found = friedman(np.array(means))
    printed = {
        claim.measure.algorithm: claim.printed.text
        for claim, finding in judged
        if isinstance(claim.measure, MeanRank)
        and claim.measure.contest.experiment == experiment.name
        and finding.table
    }
    ranked = sorted(zip(names, found.ranks, strict=True), key=lambda pair: pair[1])
    return Ranking(
        friedman=found,
        headings=("algorithm", "average rank", "printed")[: 3 if printed else 2],
        rows=tuple(
            (name, f"{rank:.3f}", *((printed.get(name, "–"),) if printed else ()))
            for name, rank in ranked
        ),
        drawing=drawing(
            lambda: rank_plot(names, found, printed),
            title=f"Average ranks in {experiment.name}",
            identifier=anchor(evidence.paper.key, "ranks", experiment.name),
        ),
    )
