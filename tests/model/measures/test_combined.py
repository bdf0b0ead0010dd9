import math

import numpy as np
import pytest

from repro.errors import DeclarationError
from repro.model.evidence import Evidence
from repro.model.measures.combined import EqualTo, MeanOf, Ratio, combined
from repro.model.measures.measure import Measure, Reduction, Statistic, computed
from repro.model.measures.ranks import RankSum
from tests.small_papers import evidence

COSTS = evidence(a=[[1.0, 2.0, 3.0], [2.0, 4.0, 6.0]], b=[[4.0, 4.0, 4.0], [1.0, 5.0, 6.0]])
ZEROS = evidence(a=[[0.0, 0.0, 0.0]], b=[[0.0, 0.0, 0.0]])


def mean(algorithm: str, statistic: str = "mean") -> Statistic:
    return Statistic(experiment="search", problem="bowl", algorithm=algorithm, statistic=statistic)


def draws(measure: Measure, costs: Evidence = COSTS) -> list[float]:
    return list(measure.measure(costs).draws)


def test_ratio_is_that_of_the_first_repeat_and_of_every_pair_of_tables() -> None:
    found = Ratio(of=mean("b"), to=mean("a")).measure(COSTS)

    of, to = (mean(name).measure(COSTS).draws for name in "ba")
    assert (found.value, found.repeats) == (2.0, 2)
    assert found.draws[to > 0.0] == pytest.approx(of[to > 0.0] / to[to > 0.0])


def test_measures_of_one_cell_vary_together() -> None:
    assert set(draws(Ratio(of=mean("a"), to=mean("a")))) == {1.0}


def test_formula_of_two_measures_is_the_reduction_in_percent() -> None:
    lower = Reduction(before=mean("b"), after=mean("a"))

    found = combined("100 * (old - new) / old", old=mean("b"), new=mean("a")).measure(COSTS)

    assert found.value == pytest.approx(lower.measure(COSTS).value)
    assert found.draws == pytest.approx(lower.measure(COSTS).draws)


def test_mean_is_over_measures_and_a_fixed_one_does_not_vary() -> None:
    ten = computed("as set", lambda: 10.0)

    found = MeanOf(parts=(mean("a"), mean("b"), ten)).measure(COSTS)

    assert found.value == pytest.approx(16.0 / 3.0)
    assert found.draws == pytest.approx(
        (mean("a").measure(COSTS).draws + mean("b").measure(COSTS).draws + 10.0) / 3.0
    )


def test_equal_measures_are_told_from_others_and_from_near_ones() -> None:
    best = mean("a", "best")  # 1, and b has 4

    values = [
        EqualTo(one=best, other=mean("b"), within=within).measure(COSTS).value
        for within in (0.0, 2.9, 3.0)
    ]

    assert values == [0.0, 0.0, 1.0]
    assert set(draws(EqualTo(one=best, other=best))) == {1.0}


def test_two_zeros_are_in_the_ratio_of_one() -> None:
    found = Ratio(of=mean("a"), to=mean("b")).measure(ZEROS)

    assert found.value == 1.0
    assert not np.isnan(found.draws).any()


def test_what_is_no_number_may_be_anything() -> None:
    found = combined("sqrt(a - 9)", a=mean("a")).measure(ZEROS)

    assert math.isinf(found.value)
    assert {*found.draws} == {-math.inf, math.inf}


def test_measures_with_fewer_draws_are_combined_as_far_as_they_go() -> None:
    p = RankSum(experiment="search", problems=("bowl",), algorithm="a", against="b")

    found = combined("p * m", p=p, m=mean("a")).measure(COSTS)

    assert len(found.draws) == len(p.measure(COSTS).draws)


def test_combinations_need_all_cells_and_say_what_they_are() -> None:
    measure = combined("a / b", a=mean("a"), b=mean("b"))

    assert measure.cells() == (*mean("a").cells(), *mean("b").cells())
    assert measure.words == (
        "a / b, where a is mean cost of a on bowl; b is mean cost of b on bowl"
    )
    assert Ratio(of=mean("a", "best"), to=mean("b")).measure(COSTS).thin


def test_formula_of_other_names_and_mean_of_nothing_are_refused() -> None:
    with pytest.raises(DeclarationError, match="has the names a, c; given are a, b"):
        combined("a / c", a=mean("a"), b=mean("b"))
    with pytest.raises(DeclarationError, match="a mean of no measures"):
        MeanOf(parts=())
