from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from papers.smwoa2022 import PAPER as SMWOA
from repro.functions import FUNCTIONS
from repro.judge.judgement import judge
from repro.model.evidence import Evidence, Runs
from repro.model.paper import Paper
from repro.optimisers import DE
from repro.report.views.algorithms import AlgorithmsView, algorithms_views
from repro.statistics.friedman import friedman
from tests.doe2021 import PAPER, TEST
from tests.small_papers import evidence_of

Vector = NDArray[np.float64]
LOW, HIGH = [1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0, 8.0]


def runs(*repeats: list[float], dimension: int = 3) -> Runs:
    costs = np.array(repeats)
    return Runs(
        costs=costs,
        points=np.ones((*costs.shape, dimension)),
        histories=np.ones((*costs.shape, 12)),
        evaluations=72,
    )


def compared(paper: Paper, evidence: Evidence) -> tuple[AlgorithmsView, ...]:
    return algorithms_views(judge(paper, evidence))


def wider(problems: int = 2) -> Paper:
    """Return the invented paper with three algorithms on several problems."""
    experiment = replace(
        TEST,
        problems={f"F{k}": FUNCTIONS["sphere"].problem(3) for k in range(1, problems + 1)},
        algorithms={**TEST.algorithms, "DE": DE()},
    )
    return replace(PAPER, experiments=(experiment, *PAPER.experiments[1:]))


def filled(paper: Paper, **costs: list[float]) -> Evidence:
    return evidence_of(
        paper,
        {
            ("test", problem, name): runs(values)
            for problem in paper.experiments[0].problems
            for name, values in costs.items()
        },
    )


def test_experiments_without_all_their_runs_are_not_compared() -> None:
    evidence = evidence_of(PAPER, {("test", "F1", "WOA"): runs(LOW)})

    assert compared(PAPER, evidence) == ()


def test_a_comparison_counts_wins_of_the_proposed_algorithm() -> None:
    (comparison,) = compared(PAPER, filled(PAPER, WOA=LOW, PSO=HIGH))
    ((problem, texts),) = comparison.rows

    assert problem == "F1"
    # 8 untied values: 2 of the 70 orders of 4 and 4
    assert texts == ("p = 0.02857, Holm 0.02857, wins 1.00 [1.00, 1.00]",)
    assert comparison.budgets == (("WOA", 72), ("PSO", 72))
    assert comparison.ranking is None


def test_runs_that_overlap_give_an_interval_around_the_wins() -> None:
    (comparison,) = compared(
        PAPER, filled(PAPER, WOA=[1.0, 4.0, 5.0, 7.0], PSO=[2.0, 3.0, 6.0, 8.0])
    )
    ((wins, low, high),) = comparison.data[["wins", "low", "high"]].to_numpy()

    assert wins == 9 / 16
    assert 0 < low < 0.3
    assert high > 0.8


def test_equal_runs_do_not_differ() -> None:
    (comparison,) = compared(PAPER, filled(PAPER, WOA=[0.0] * 4, PSO=[0.0] * 4))

    assert comparison.rows[0][1] == ("p = 1, Holm 1, wins 0.50 [0.50, 0.50]",)


def test_holm_is_over_the_whole_table() -> None:
    (comparison,) = compared(wider(), filled(wider(), WOA=LOW, PSO=HIGH, DE=HIGH))

    assert comparison.others == ("PSO", "DE")
    assert [len(texts) for _, texts in comparison.rows] == [2, 2]
    assert all("Holm 0.1143" in text for _, texts in comparison.rows for text in texts)


def test_three_algorithms_on_two_problems_are_ranked_by_their_means() -> None:
    (comparison,) = compared(wider(), filled(wider(), WOA=HIGH, PSO=LOW, DE=[2.5] * 4))
    ranking = comparison.ranking

    assert ranking
    assert ranking.rows == (("PSO", "1.500"), ("DE", "1.500"), ("WOA", "3.000"))
    assert ranking.headings == ("algorithm", "average rank")
    means = np.array([[6.5, 2.5, 2.5]] * 2)
    assert ranking.friedman == friedman(means)


def test_two_algorithms_or_one_problem_have_no_ranking() -> None:
    (one,) = compared(wider(problems=1), filled(wider(problems=1), WOA=LOW, PSO=HIGH, DE=HIGH))

    assert one.ranking is None
    assert [kind for kind, _ in one.tables()] == ["rank-sum"]


def test_only_the_first_repeat_is_compared() -> None:
    repeats = {"WOA": runs(LOW, HIGH), "PSO": runs(HIGH, LOW)}
    evidence = evidence_of(PAPER, {("test", "F1", name): own for name, own in repeats.items()})

    assert compared(PAPER, evidence)[0].rows[0][1][0].endswith("wins 1.00 [1.00, 1.00]")


def test_what_the_paper_prints_stands_beside_ours() -> None:
    experiment = SMWOA.experiments[0]
    rng = np.random.default_rng(3)
    evidence = evidence_of(
        SMWOA,
        {
            (experiment.name, problem, name): runs(
                rng.uniform(1, 2 + place, size=30).tolist(), dimension=len(subject.bounds)
            )
            for problem, subject in experiment.problems.items()
            for place, name in enumerate(experiment.algorithms)
        },
    )
    comparison = next(c for c in compared(SMWOA, evidence) if c.experiment is experiment)

    against = {other: (printed, ours) for other, printed, ours in comparison.printed}
    assert list(against) == ["WOA", "PSO", "GSA", "DE", "SMA"]
    assert against["WOA"][0] == "8.24×10^-6/+"
    assert float(against["SMA"][1].replace("×10^", "e")) < 1e-20
    assert comparison.ranking
    assert comparison.ranking.rows[0] == ("SMWOA", "1.000", "1.4000")


def test_the_same_evidence_gives_the_same_comparison() -> None:
    evidence = filled(wider(), WOA=LOW, PSO=[3.5, 2.5, 1.5, 9.0], DE=HIGH)

    (one,), (other,) = compared(wider(), evidence), compared(wider(), evidence)
    assert one.data.equals(other.data)
    assert replace(one, data=other.data) == other
