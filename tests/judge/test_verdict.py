import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.judge.verdict import Verdict, unseen, verdict_of

INTERVAL = st.tuples(st.integers(-4, 4), st.integers(-4, 4)).map(lambda ends: tuple(sorted(ends)))
Pair = tuple[int, int]


def meet(one: Pair, other: Pair) -> bool:
    return max(one[0], other[0]) <= min(one[1], other[1])


@given(measured=INTERVAL, printed=st.integers(-4, 4), slack=st.integers(0, 3))
def test_verdict_follows_from_inclusion_and_disjointness(
    measured: Pair, printed: int, slack: int
) -> None:
    accepted = printed - slack, printed + slack
    inside = accepted[0] <= measured[0] and measured[1] <= accepted[1]
    covered = meet(measured, (printed, printed))

    verdict, side = verdict_of(measured, (printed, printed), accepted)

    assert (verdict == Verdict.REPRODUCED) == inside
    assert (verdict == Verdict.CONSISTENT) == (covered and not inside)
    assert (verdict == Verdict.CONTRADICTED) == (not meet(measured, accepted))
    assert (verdict == Verdict.UNDECIDED) == (
        meet(measured, accepted) and not covered and not inside
    )
    assert (side is not None) == (verdict == Verdict.CONTRADICTED)


def test_rounding_of_the_print_counts_as_printed() -> None:
    assert verdict_of((1.4, 9.0), (0.5, 1.5), (0.2, 1.8))[0] is Verdict.CONSISTENT
    assert verdict_of((1.6, 9.0), (0.5, 1.5), (0.2, 1.8))[0] is Verdict.UNDECIDED


def test_contradicted_number_says_on_which_side_the_measured_one_lies() -> None:
    assert verdict_of((0.0, 1.0), (2.5, 2.5), (2.0, 3.0)) == (Verdict.CONTRADICTED, "lower")
    assert verdict_of((4.0, 5.0), (2.5, 2.5), (2.0, 3.0)) == (Verdict.CONTRADICTED, "higher")


def test_ends_of_the_band_are_accepted() -> None:
    beyond, point = math.nextafter(3.0, math.inf), (2.5, 2.5)

    assert verdict_of((2.0, 3.0), point, (2.0, 3.0)) == (Verdict.REPRODUCED, None)
    assert verdict_of((2.0, beyond), point, (2.0, 3.0)) == (Verdict.CONSISTENT, None)
    assert verdict_of((3.0, 4.0), point, (2.0, 3.0)) == (Verdict.UNDECIDED, None)
    assert verdict_of((beyond, 4.0), point, (2.0, 3.0)) == (Verdict.CONTRADICTED, "higher")


def test_interval_without_ends_is_consistent_with_anything() -> None:
    everything = (-math.inf, math.inf)

    assert verdict_of(everything, (2.5, 2.5), (2.0, 3.0)) == (Verdict.CONSISTENT, None)


def test_words_of_the_verdicts_are_the_contract() -> None:
    assert [str(verdict) for verdict in Verdict] == [
        "reproduced",
        "consistent",
        "undecided",
        "depends",
        "contradicted",
        "not reproducible",
        "not run",
    ]


@pytest.mark.parametrize(
    ("measured", "printed", "minimum", "factor"),
    [
        ((1.0, 10.0), 2.0, 0.0, 5.0),
        ((1.0, 10.0), 8.0, 0.0, 8.0),
        ((4.0, 13.0), 5.0, 3.0, 5.0),  # of distances from the minimum
        ((-13.0, -4.0), -5.0, 0.0, 2.6),
        ((0.0, 10.0), 2.0, 0.0, "unbounded"),
        ((3.0, 10.0), 5.0, 3.0, "unbounded"),
        ((1.0, math.inf), 2.0, 0.0, "unbounded"),
        ((-1.0, 1.0), 0.5, 0.0, "unbounded"),
        ((0.0, 0.0), 0.0, 0.0, 1.0),
    ],
)
def test_unseen_is_the_farthest_factor_inside_the_interval(
    measured: tuple[float, float], printed: float, minimum: float, factor: float | str
) -> None:
    assert unseen(measured, printed, minimum) == pytest.approx(factor)
