"""What the pages say of the algorithms of one experiment against each other."""

from collections.abc import Sequence
from dataclasses import dataclass

import pandas as pd

from repro.judge.findings import Finding
from repro.judge.judgement import Judgement
from repro.judge.rank_tests import AlgorithmTests, RankSumTest
from repro.model.claims import Claim
from repro.model.experiment import Experiment
from repro.model.identifiers import anchor
from repro.model.measures.ranks import MeanRank, RankSum
from repro.report.drawings.draw import Drawing, drawing
from repro.report.drawings.ranks import rank_plot
from repro.report.frames import rank_sums
from repro.report.plain_rows import rows_of_tests
from repro.report.words import number
from repro.statistics.friedman import Friedman

Judged = Sequence[tuple[Claim, Finding]]


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
class AlgorithmsView:
    """Tests of the proposed algorithm against the others, on the first repeat.

    `rows` holds problem and one text per other algorithm, `data` the same for programs, `printed`
    each p-value that the paper prints: (other, printed, re-run).
    """

    experiment: Experiment
    others: tuple[str, ...]
    rows: tuple[tuple[str, tuple[str, ...]], ...]
    data: pd.DataFrame
    budgets: tuple[tuple[str, int], ...]
    printed: tuple[tuple[str, str, str], ...]
    ranking: Ranking | None

    @property
    def left_out(self) -> str:
        """What is said of algorithms that are not run; nothing where there are none."""
        because = [f"{name} ({gap.because})" for name, gap in self.experiment.left_out.items()]
        return f"Not re-run, and compared with nothing: {'; '.join(because)}." if because else ""

    def tables(self) -> tuple[tuple[str, pd.DataFrame], ...]:
        """Return the kind and the rows of each table of data."""
        ranks = (("ranks", self.ranking.drawing.frame),) if self.ranking else ()
        return (("rank-sum", self.data), *ranks) if self.others else ranks


def algorithms_views(judgement: Judgement) -> tuple[AlgorithmsView, ...]:
    """Return what is shown of the tests of every experiment."""
    judged = tuple(zip(judgement.paper.said, judgement.findings, strict=True))
    return tuple(_view(judgement.paper.key, tests, judged) for tests in judgement.tests)


def _view(paper: str, found: AlgorithmTests, judged: Judged) -> AlgorithmsView:
    experiment, others = found.experiment, found.others
    words = {(test.problem, test.against): _words(test) for test in found.tests}
    return AlgorithmsView(
        experiment=experiment,
        others=others,
        rows=tuple(
            (problem, tuple(words[problem, other] for other in others))
            for problem in experiment.problems
        ),
        data=rank_sums(rows_of_tests([found])),
        budgets=tuple(found.budgets.items()),
        printed=_printed_p_values(experiment, judged),
        ranking=_ranking(paper, experiment, found.friedman, judged) if found.friedman else None,
    )


def _words(test: RankSumTest) -> str:
    low, high = test.interval
    return (
        f"p = {number(test.p)}, Holm {number(test.holm)}, "
        f"wins {test.wins:.2f} [{low:.2f}, {high:.2f}]"
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


def _ranking(paper: str, experiment: Experiment, found: Friedman, judged: Judged) -> Ranking:
    names = tuple(experiment.algorithms)
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
            identifier=anchor(paper, "ranks", experiment.name),
        ),
    )
