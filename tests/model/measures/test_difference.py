import pytest

from repro.model.measures.measure import Computed, Difference, Statistic
from tests.small_papers import evidence

BEFORE = Computed(how="time as set", value=lambda: 5.0)
AFTER = Statistic(experiment="search", problem="bowl", algorithm="guess", statistic="best")


def test_difference_is_what_is_saved() -> None:
    after = Computed(how="time found", value=lambda: 2.25)

    found = Difference(before=BEFORE, after=after).measure(evidence())

    assert found.value == 2.75
    assert found.draws.tolist() == [2.75]
    assert found.repeats == 0


def test_difference_to_runs_varies_with_the_runs() -> None:
    costs = [[3.0, 1.0], [2.0, 4.0]]

    found = Difference(before=BEFORE, after=AFTER).measure(evidence(guess=costs))

    assert found.value == pytest.approx(4.0)
    assert found.draws.max() > 4.0
    assert {1.0, 2.0, 3.0, 4.0} <= set(found.draws)
    assert found.repeats == 2


def test_difference_needs_the_cells_of_both_sides_and_says_them() -> None:
    difference = Difference(before=BEFORE, after=AFTER)

    assert difference.cells() == (("search", "bowl", "guess"),)
    assert difference.words == "difference from time as set to best cost of guess on bowl"
