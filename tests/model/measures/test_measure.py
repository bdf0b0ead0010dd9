import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.model.evidence import Evidence
from repro.model.measures.measure import Computed, Difference, Measured, Rank, Reduction, Statistic
from tests.small_papers import evidence, searching

COSTS = [[3.0, 1.0, 2.0], [9.0, 8.0, 7.0]]
NAMES = ("a", "b", "c")


def statistic(name: str, algorithm: str = "guess") -> Statistic:
    return Statistic(experiment="search", problem="bowl", algorithm=algorithm, statistic=name)


def rank(algorithm: str, name: str = "mean") -> Rank:
    return Rank(of=statistic(name, algorithm), among=NAMES)


def three(a: float, b: float, c: float) -> Evidence:
    return evidence(searching(), a=[[a, a]], b=[[b, b]], c=[[c, c]])


@pytest.mark.parametrize(("name", "value"), [("best", 1), ("worst", 3), ("mean", 2), ("std", 1)])
def test_value_is_that_of_the_first_repeat(name: str, value: float) -> None:
    found = statistic(name).measure(evidence(guess=COSTS))

    assert found.value == value
    assert found.repeats == 2


def test_draws_are_tables_that_may_follow_all_repeats() -> None:
    found = statistic("best").measure(evidence(guess=COSTS))

    assert {1, 2, 3, 7, 8, 9} <= set(np.unique(found.draws))
    # the best of three more lies below all six with chance 3/9; the standard error of a share of
    # 2000 tables is 0.0105 there: 5 of them
    assert (found.draws < 1).mean() == pytest.approx(1 / 3, abs=0.053)
    assert len(found.draws) == 2000


def test_best_and_worst_are_extremes_and_what_is_made_of_them() -> None:
    costs = evidence(guess=COSTS, wide=COSTS)
    fixed = Computed(how="as set", value=lambda: 10.0)

    thin = [
        measure.measure(costs).thin
        for measure in (
            statistic("best"),
            statistic("worst"),
            Rank(of=statistic("best"), among=("guess", "wide")),
            Reduction(before=fixed, after=statistic("worst")),
        )
    ]  # fmt: skip

    assert thin == [True] * 4
    assert not statistic("mean").measure(costs).thin
    assert not Rank(of=statistic("mean"), among=("guess", "wide")).measure(costs).thin


def test_statistics_of_one_cell_are_drawn_from_the_same_tables() -> None:
    found = {
        name: statistic(name).measure(evidence(guess=COSTS)).draws
        for name in ("best", "worst", "mean", "std")
    }

    assert not found["std"][found["best"] == found["worst"]].any()
    assert (found["best"] <= found["mean"] + 1e-12).all()
    assert (found["mean"] <= found["worst"] + 1e-12).all()


def test_cells_are_drawn_independently_and_alike_every_time() -> None:
    found = evidence(guess=COSTS, wide=COSTS)
    guess, again = (statistic("mean").measure(found).draws for _ in range(2))
    wide = statistic("mean", "wide").measure(found).draws

    assert guess.tolist() == again.tolist()
    # independent draws of 2000 tables correlate by 1 / sqrt(2000) = 0.022; 5 of them
    assert abs(float(np.corrcoef(guess, wide)[0, 1])) < 0.112


def test_other_quantities_are_measured_in_their_place() -> None:
    after = Statistic(
        experiment="search",
        problem="bowl",
        algorithm="guess",
        statistic="mean",
        quantity="cost after 1 iterations",
    )

    assert after.measure(evidence(guess=COSTS)).value == 10.0
    assert after.words == "mean cost after 1 iterations of guess on bowl"


@pytest.mark.parametrize(
    ("costs", "ranks"),
    [
        ((1, 2, 3), [1, 2, 3]),
        ((5, 2, 3), [3, 1, 2]),
        ((2, 2, 3), [1, 1, 3]),
        ((7, 2, 7), [2, 1, 2]),
    ],
)
def test_rank_is_one_more_than_the_number_of_lower_ones(
    costs: tuple[float, float, float], ranks: list[float]
) -> None:
    assert [rank(name).measure(three(*costs)).value for name in NAMES] == ranks


@given(st.permutations(NAMES), st.floats(1e-300, 1e300))
def test_rank_asks_for_order_and_not_for_size(order: list[str], scale: float) -> None:
    costs = {name: [[scale * (1 + k)] * 2] for k, name in enumerate(order)}

    found = [rank(name).measure(evidence(searching(), **costs)) for name in order]

    assert [measured.value for measured in found] == [1, 2, 3]
    assert [float(np.ptp(measured.draws)) for measured in found] == [0, 0, 0]


def test_rank_of_overlapping_runs_varies_between_first_and_last() -> None:
    found = evidence(searching(), a=[[1.0, 5.0]], b=[[2.0, 4.0]], c=[[3.0, 3.0]])

    assert set(rank("a").measure(found).draws) == {1.0, 2.0, 3.0}


def test_equal_ones_share_the_lower_rank_in_every_resampled_table() -> None:
    found = evidence(searching(), a=[[2.0, 2.0]], b=[[2.0, 2.0]], c=[[3.0, 3.0]])

    assert [set(rank(name).measure(found).draws) for name in NAMES] == [{1.0}, {1.0}, {3.0}]


def test_measures_name_the_cells_that_they_need() -> None:
    fixed = Computed(how="as set", value=lambda: 10.0)

    assert rank("b").cells() == tuple(("search", "bowl", name) for name in NAMES)
    assert fixed.cells() == ()
    assert Reduction(before=fixed, after=statistic("mean")).cells() == (
        ("search", "bowl", "guess"),
    )


def test_measures_are_said_in_words() -> None:
    fixed = Computed(how="time as set", value=lambda: 10.0)
    reduction = Reduction(before=fixed, after=statistic("mean"))

    assert rank("b").words == "rank of mean cost of b on bowl among a, b, c"
    assert reduction.words == (
        "reduction in percent from time as set to mean cost of guess on bowl"
    )


@pytest.mark.parametrize("measure", [Difference, Reduction])
def test_comparison_rests_on_the_fewest_repeats_of_either_side(
    measure: type[Difference] | type[Reduction],
) -> None:
    found = evidence(searching(), a=COSTS, b=COSTS[:1], c=COSTS)

    assert (
        measure(before=statistic("best", "a"), after=statistic("best", "b")).measure(found).repeats
        == 1
    )
    assert rank("a").measure(found).repeats == 1


def measured_reduction(before: float, after: float) -> Measured:
    fixed = (Computed(how="as set", value=value) for value in (lambda: before, lambda: after))
    return Reduction(before=next(fixed), after=next(fixed)).measure(evidence())


@pytest.mark.parametrize(
    ("before", "after", "percent"), [(10, 10, 0), (10, 4.69, 53.1), (4, 6, -50)]
)
def test_reduction_is_the_share_that_is_saved(before: float, after: float, percent: float) -> None:
    found = measured_reduction(before, after)

    assert found.value == pytest.approx(percent)
    assert found.draws == pytest.approx([percent])
    assert found.repeats == 0


def test_reduction_to_runs_varies_with_the_runs() -> None:
    fixed = Computed(how="as set", value=lambda: 10.0)

    found = Reduction(before=fixed, after=statistic("best")).measure(evidence(guess=COSTS))

    assert found.value == pytest.approx(90.0)
    assert {10, 20, 30, 70, 80, 90} <= set(np.round(found.draws))
    assert found.repeats == 2
