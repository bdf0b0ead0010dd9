from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import mannwhitneyu, wilcoxon

from repro.model.claims import ranked
from repro.model.evidence import Evidence, Runs
from repro.model.measures.measure import Rank
from repro.model.measures.ranks import Contest, ContestPlace, Firsts, MeanRank, RankSum
from tests.small_papers import PAPER, evidence_of

CONTEST = Contest(experiment="e", problems=("p", "q"), algorithms=("a", "b", "c"))


def evidence(**costs: tuple[list[list[float]], list[list[float]]]) -> Evidence:
    """Return evidence with the costs (repeats, runs) of each algorithm on p and q."""
    return evidence_of(
        PAPER,
        {
            ("e", problem, name): Runs(
                costs=np.array(values),
                points=np.zeros((*np.shape(values), 1)),
                histories=np.zeros((*np.shape(values), 1)),
                evaluations=1,
            )
            for name, pair in costs.items()
            for problem, values in zip("pq", pair, strict=True)
        },
    )


def constant(**costs: tuple[float, float]) -> Evidence:
    return evidence(**{name: ([[p, p]], [[q, q]]) for name, (p, q) in costs.items()})


@pytest.mark.parametrize(("name", "mean"), [("a", 1.0), ("b", 2.5), ("c", 2.5)])
def test_mean_rank_is_the_average_over_the_problems(name: str, mean: float) -> None:
    found = constant(a=(1, 1), b=(2, 7), c=(3, 2))

    assert MeanRank(contest=CONTEST, algorithm=name).measure(found).value == mean


def test_ties_share_the_mean_of_their_places() -> None:
    found = constant(a=(1, 5), b=(1, 5), c=(2, 5))

    ranks = [MeanRank(contest=CONTEST, algorithm=name).measure(found).value for name in "abc"]

    assert ranks == [1.75, 1.75, 2.5]


def test_mean_ranks_of_all_add_up_in_every_resampled_table() -> None:
    rng = np.random.default_rng(1)
    found = evidence(
        a=(rng.random((2, 4)).tolist(), rng.random((2, 4)).tolist()),
        b=(rng.random((2, 4)).tolist(), rng.random((2, 4)).tolist()),
        c=(rng.random((2, 4)).tolist(), rng.random((2, 4)).tolist()),
    )

    each = [MeanRank(contest=CONTEST, algorithm=name).measure(found) for name in "abc"]

    assert np.sum([one.draws for one in each], axis=0) == pytest.approx(np.full(2000, 6.0))
    assert len(set(each[0].draws)) > 1
    assert [one.repeats for one in each] == [2, 2, 2]


def test_rank_sum_rests_on_the_fewest_repeats_of_any_cell() -> None:
    many, few = [[1.0, 2.0], [3.0, 4.0]], [[5.0, 6.0]]
    found = evidence(a=(many, many), b=(many, few))

    test = RankSum(experiment="e", problems=("p", "q"), algorithm="a", against="b")

    assert test.measure(found).repeats == 1


@pytest.mark.parametrize(("name", "place"), [("a", 1), ("b", 2), ("c", 2)])
def test_places_order_mean_ranks_and_ties_share_the_better(name: str, place: int) -> None:
    found = constant(a=(1, 1), b=(2, 7), c=(3, 2))

    measured = ContestPlace(contest=CONTEST, algorithm=name).measure(found)

    assert measured.value == place
    assert set(measured.draws) == {place}


@pytest.mark.parametrize(("name", "count"), [("a", 2), ("b", 1), ("c", 0)])
def test_firsts_count_the_problems_and_shared_firsts(name: str, count: int) -> None:
    found = constant(a=(1, 1), b=(1, 3), c=(2, 2))

    assert Firsts(contest=CONTEST, algorithm=name).measure(found).value == count


def test_contest_ranks_the_statistic_that_it_names() -> None:
    found = evidence(a=([[0.0, 9.0]],) * 2, b=([[2.0, 3.0]],) * 2, c=([[4.0, 4.0]],) * 2)

    by = {
        name: MeanRank(
            contest=Contest(
                experiment="e", problems=("p", "q"), algorithms=("a", "b", "c"), statistic=name
            ),
            algorithm="a",
        )
        .measure(found)
        .value
        for name in ("best", "mean", "worst")
    }

    assert by == {"best": 1.0, "mean": 3.0, "worst": 3.0}


def test_rank_sum_is_that_of_the_first_repeat_on_all_problems_together() -> None:
    rng = np.random.default_rng(3)
    a, b = rng.normal(0, 1, (2, 2, 9)), rng.normal(0.5, 1, (2, 2, 9))
    found = evidence(a=(a[0].tolist(), a[1].tolist()), b=(b[0].tolist(), b[1].tolist()))

    measured = RankSum(experiment="e", problems=("p", "q"), algorithm="a", against="b").measure(
        found
    )

    expected = mannwhitneyu(a[:, 0].ravel(), b[:, 0].ravel(), method="asymptotic").pvalue
    assert measured.value == pytest.approx(expected, rel=1e-12)
    assert len(set(measured.draws)) > 100
    assert ((measured.draws >= 0) & (measured.draws <= 1)).all()


@pytest.mark.parametrize(
    ("a", "b", "sign"),
    [
        (range(9), range(20, 29), 1.0),
        (range(20, 29), range(9), -1.0),
        (range(9), range(9), 0.0),
        ([4] * 9, [4] * 9, 0.0),
    ],
)
def test_sign_says_which_side_is_lower_at_the_level(
    a: list[float], b: list[float], sign: float
) -> None:
    found = evidence(a=([list(a)],) * 2, b=([list(b)],) * 2)
    test = RankSum(experiment="e", problems=("p", "q"), algorithm="a", against="b", sign=True)

    assert test.measure(found).value == sign


def test_equal_samples_are_not_different() -> None:
    found = evidence(a=([[4.0] * 9],) * 2, b=([[4.0] * 9],) * 2)

    measured = RankSum(experiment="e", problems=("p",), algorithm="a", against="b").measure(found)

    assert measured.value == 1.0
    assert set(measured.draws) == {1.0}


def test_measures_need_every_cell_that_they_compare() -> None:
    cells = {("e", problem, name) for problem in "pq" for name in "abc"}

    for kind in (MeanRank, ContestPlace, Firsts):
        assert set(kind(contest=CONTEST, algorithm="b").cells()) == cells
    pair = RankSum(experiment="e", problems=("p", "q"), algorithm="a", against="c")
    assert set(pair.cells()) == {cell for cell in cells if cell[2] != "b"}


def test_claimed_places_are_ranks_on_each_problem() -> None:
    claims = ranked(CONTEST, algorithm="b", places={"p": 2, "q": 3}, claim="b", where="p. 4")

    assert [claim.claim for claim in claims] == ["b, on p: place 2", "b, on q: place 3"]
    assert [claim.printed.value for claim in claims] == [2, 3]
    assert [claim.accepted.band(claim.printed) for claim in claims] == [(2, 2), (3, 3)]
    for claim, problem in zip(claims, "pq", strict=True):
        assert isinstance(claim.measure, Rank)
        assert claim.measure.of.cell == ("e", problem, "b")
        assert claim.measure.among == ("a", "b", "c")


def test_rank_sum_of_averages_compares_one_number_per_problem() -> None:
    rng = np.random.default_rng(3)
    problems = tuple(f"p{i}" for i in range(15))
    a, b = rng.normal(0, 1, (2, 15, 2, 9))
    cells = {
        ("e", problem, name): Runs(
            costs=table[k], points=np.zeros((2, 9, 1)), histories=np.zeros((1, 9, 1)), evaluations=1
        )
        for k, problem in enumerate(problems)
        for name, table in (("a", a), ("b", b))
    }
    found = evidence_of(PAPER, cells)
    test = RankSum(experiment="e", problems=problems, algorithm="a", against="b")

    averages = replace(test, samples="averages").measure(found)
    each = replace(test, samples="each problem").measure(found)

    means = [table[:, 0].mean(axis=-1) for table in (a, b)]
    assert averages.value == pytest.approx(mannwhitneyu(*means, method="asymptotic").pvalue)
    ps = [
        mannwhitneyu(x, y, method="asymptotic").pvalue
        for x, y in zip(a[:, 0], b[:, 0], strict=True)
    ]
    assert each.value == pytest.approx(np.mean(ps))


def test_words_name_what_is_compared() -> None:
    measures = [kind(contest=CONTEST, algorithm="b") for kind in (MeanRank, ContestPlace, Firsts)]

    for measure in measures:
        assert "b" in measure.words
        assert "mean cost among a, b, c" in measure.words
    pair = RankSum(experiment="e", problems=("p",), algorithm="a", against="c")
    assert pair.words == (
        "p-value of the rank-sum test of a against c, all runs on all problems together, 1 problems"
    )


def test_signed_rank_test_pairs_the_runs_as_they_follow_each_other() -> None:
    rng = np.random.default_rng(3)
    a, b = rng.random((2, 12)), rng.random((2, 12))
    found = evidence(a=(a.tolist(), b.tolist()), b=(b.tolist(), a.tolist()))

    test = RankSum(experiment="e", problems=("p",), algorithm="a", against="b", by="signed-rank")

    expected = wilcoxon(a[0] - b[0], method="asymptotic", correction=True).pvalue
    assert test.measure(found).value == pytest.approx(expected, rel=1e-9)
    assert "signed-rank test of a against b" in test.words


def test_sign_of_the_signed_rank_test_says_who_is_lower() -> None:
    low, high = [[1.0 + k for k in range(9)]], [[2.5 + k for k in range(9)]]
    found = evidence(a=(low, low), b=(high, high))
    test = RankSum(
        experiment="e", problems=("p",), algorithm="a", against="b", by="signed-rank", sign=True
    )

    assert test.measure(found).value == 1.0
    assert replace(test, algorithm="b", against="a").measure(found).value == -1.0


def test_contest_shares_ties_as_it_is_told() -> None:
    found = constant(a=(1, 5), b=(1, 5), c=(2, 5))
    dense = replace(CONTEST, ties="dense")

    ranks = [MeanRank(contest=dense, algorithm=name).measure(found).value for name in "abc"]

    assert ranks == [1.0, 1.0, 1.5]
