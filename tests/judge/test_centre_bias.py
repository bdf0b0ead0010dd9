import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.judge.centre_bias import SOLVED, Bias, Costs, biases, shifts_of, standings

Vector = NDArray[np.float64]
MINIMA = {"F1": 0.0, "F2": -3.0}
RNG = np.random.default_rng(4)
PLAIN = RNG.uniform(0.5, 2.0, size=30)
NOISE = RNG.uniform(0.9, 1.1, size=30)


def costs_of(**factors: float) -> Costs:
    """Return costs of algorithms whose errors grow by a factor per unit of shift."""
    return {
        (shift, problem, name): MINIMA[problem] + PLAIN * (factor**shift) * (NOISE if shift else 1)
        for name, factor in factors.items()
        for problem in MINIMA
        for shift in (0.0, 1.0, 2.0)
    }


def of(costs: Costs, name: str, shift: float, minima: dict[str, float] = MINIMA) -> Bias:
    names = tuple(dict.fromkeys(algorithm for _, _, algorithm in costs))
    found = biases(costs, minima, names)
    return next(b for b in found if (b.algorithm, b.shift) == (name, shift))


def test_ratio_is_the_geometric_mean_over_the_problems_of_the_ratios_of_mean_errors() -> None:
    costs = {
        (0.0, "F1", "A"): np.array([1.0, 3.0]),
        (1.0, "F1", "A"): np.array([40.0, 160.0]),  # 100 / 2
        (0.0, "F2", "A"): np.array([-2.0, -2.0]),
        (1.0, "F2", "A"): np.array([-1.0, -1.0]),  # 2 / 1
    }
    bias = of(costs, "A", 1.0)

    assert bias.ratios == pytest.approx({"F1": 50.0, "F2": 2.0})
    assert bias.ratio == pytest.approx(10.0)


def test_only_a_ratio_above_ten_is_flagged() -> None:
    costs = costs_of(biased=20.0, plain=1.0)

    assert of(costs, "biased", 1.0).flagged
    assert not of(costs, "plain", 2.0).flagged
    exact = {key: MINIMA[key[1]] + np.full(2, 10.0 ** key[0]) for key in costs}
    assert not of(exact, "plain", 1.0).flagged  # exactly 10


def test_a_biased_method_differs_and_one_without_bias_does_not() -> None:
    costs = costs_of(biased=20.0, plain=1.0, better=0.1)

    assert of(costs, "biased", 1.0).p < 1e-6
    assert of(costs, "plain", 1.0).p > 0.05
    assert of(costs, "better", 1.0).p == 1.0


def test_p_values_are_corrected_for_all_algorithms_and_shifts() -> None:
    alone = of({k: v for k, v in costs_of(A=20.0).items() if k[0] != 2.0}, "A", 1.0)
    one_of_six = of(costs_of(A=20.0, B=20.0, C=20.0), "A", 1.0)

    assert one_of_six.p == pytest.approx(6 * alone.p)


def test_errors_below_the_floor_count_as_solved() -> None:
    costs = {
        (0.0, "F1", "A"): np.full(5, 1e-300),
        (1.0, "F1", "A"): np.array([0.0, 1e-80, 1e-12, SOLVED, 1e-9]),
    }
    bias = of(costs, "A", 1.0, {"F1": 0.0})

    assert bias.ratio == 1.0
    assert bias.p == 1.0
    assert bias.interval == (1.0, 1.0)


def test_a_solved_problem_that_is_lost_has_a_finite_ratio() -> None:
    costs = {(0.0, "F1", "A"): np.zeros(5), (1.0, "F1", "A"): np.full(5, 7.0)}

    assert of(costs, "A", 1.0, {"F1": 0.0}).ratio == pytest.approx(7.0 / SOLVED)


@given(st.lists(st.floats(0.0, 1e6), min_size=2, max_size=12), st.floats(-50.0, 50.0))
def test_a_function_that_changes_nothing_has_no_bias(costs: list[float], minimum: float) -> None:
    values = minimum + np.array(costs)
    same = {(shift, "F1", "A"): values for shift in (0.0, 1.0)}
    bias = of(same, "A", 1.0, {"F1": minimum})

    assert (bias.ratio, bias.p, bias.flagged) == (1.0, 1.0, False)


def test_interval_holds_the_ratio_and_comes_out_the_same_again() -> None:
    first, again = (of(costs_of(A=20.0, B=3.0), "B", 2.0) for _ in range(2))
    low, high = first.interval

    assert first == again
    assert low < first.ratio < high
    assert high / low < 1.1


def test_repeats_count_as_more_runs() -> None:
    costs = costs_of(A=20.0)
    folded = {key: values.reshape(3, 10) for key, values in costs.items()}

    assert of(folded, "A", 1.0) == of(costs, "A", 1.0)


def test_shifts_are_counted_without_the_function_in_place() -> None:
    assert shifts_of(costs_of(A=1.0)) == (1.0, 2.0)


def test_ranking_turns_round_when_the_biased_method_loses_its_gift() -> None:
    costs = dict(costs_of(biased=20.0, honest=1.0, worst=1.0))
    for key, values in list(costs.items()):
        factor = {"biased": 0.1, "honest": 1.0, "worst": 30.0}[key[2]]
        costs[key] = MINIMA[key[1]] + factor * (values - MINIMA[key[1]])
    before, small, large = standings(costs, tuple(MINIMA), ("biased", "honest", "worst"))

    assert (before.shift, small.shift, large.shift) == (0.0, 1.0, 2.0)
    assert before.place("biased") == 1
    assert large.place("biased") == 3
    assert before.ranks == {"biased": 1.0, "honest": 2.0, "worst": 3.0}


def test_ties_share_mean_rank_and_better_place() -> None:
    same = {(0.0, "F1", name): np.ones(3) for name in "AB"} | {(0.0, "F1", "C"): np.zeros(3)}
    (standing,) = standings(same, ("F1",), ("A", "B", "C"))

    assert standing.ranks == {"A": 2.5, "B": 2.5, "C": 1.0}
    assert [standing.place(name) for name in "ABC"] == [2, 2, 1]


def test_costs_far_below_the_floor_still_rank_as_papers_rank_them() -> None:
    tiny = {(0.0, "F1", "A"): np.full(3, 1e-250), (0.0, "F1", "B"): np.full(3, 1e-200)}
    (standing,) = standings(tiny, ("F1",), ("A", "B"))

    assert standing.ranks == {"A": 1.0, "B": 2.0}
