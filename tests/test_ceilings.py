import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.audit.blocks import CEILINGS
from repro.functions import FUNCTIONS
from tests.summaries import audited, most, scientific, summary


def dimension(name: str) -> int:
    return FUNCTIONS[name].fixed_dimension or 30


@pytest.mark.parametrize("name", CEILINGS)
@given(data=st.data())
def test_no_point_of_the_box_lies_above_the_ceiling(name: str, data: st.DataObject) -> None:
    bounds = FUNCTIONS[name].problem(dimension(name)).bounds
    share = st.one_of(st.sampled_from([0.0, 1.0]), st.floats(0.0, 1.0))
    shares = data.draw(st.lists(share, min_size=len(bounds), max_size=len(bounds)))
    point = bounds[:, 0] + np.array(shares) * (bounds[:, 1] - bounds[:, 0])
    assert FUNCTIONS[name](point) <= most(name) * (1 + 1e-12)


@pytest.mark.parametrize("name", ["sphere", "schwefel_2_22", "schwefel_1_2", "schwefel_2_21"])
def test_a_corner_of_the_box_reaches_the_ceiling(name: str) -> None:
    corner = FUNCTIONS[name].problem(30).bounds[:, 1]
    assert FUNCTIONS[name](corner) == pytest.approx(most(name), rel=1e-12)


def test_runs_that_end_on_the_ceiling_are_possible() -> None:
    sample = np.array([-10.0] * 7 + [0.0] * 3)
    block = {name: scientific(summary(sample)[name]) for name in ("mean", "std")}
    assert audited(block, n=10, function="shekel_5") == {}


def test_a_std_that_needs_runs_above_the_ceiling_is_impossible() -> None:
    sample = np.array([-10.0] * 9 + [10.0])
    block = {name: scientific(summary(sample)[name]) for name in ("mean", "std")}
    row = audited(block, n=10, function="shekel_5")["std-bound"]
    assert "no value above 0, which Shekel, 5 wells never exceeds" in row.explanation


def test_a_ceiling_that_the_mean_keeps_out_of_reach_is_not_named() -> None:
    row = audited({"mean": "1.000×10^-5", "std": "1.000×10^-3"}, n=10)["std-bound"]
    assert "never exceeds" not in row.explanation
