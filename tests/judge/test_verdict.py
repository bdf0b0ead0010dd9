import math

from hypothesis import given
from hypothesis import strategies as st

from repro.judge.verdict import Verdict, verdict_of

INTERVAL = st.tuples(st.integers(-4, 4), st.integers(-4, 4)).map(lambda ends: tuple(sorted(ends)))


@given(INTERVAL, INTERVAL)
def test_verdict_follows_from_inclusion_and_disjointness(
    measured: tuple[int, int], accepted: tuple[int, int]
) -> None:
    inside = set(range(measured[0], measured[1] + 1)) <= set(range(accepted[0], accepted[1] + 1))
    disjoint = max(measured[0], accepted[0]) > min(measured[1], accepted[1])

    verdict, side = verdict_of(measured, accepted)

    assert (verdict == Verdict.REPRODUCED) == inside
    assert (verdict == Verdict.CONTRADICTED) == disjoint
    assert (verdict == Verdict.UNDECIDED) == (not inside and not disjoint)
    assert (side is not None) == disjoint


def test_contradicted_number_says_on_which_side_the_measured_one_lies() -> None:
    assert verdict_of((0.0, 1.0), (2.0, 3.0)) == (Verdict.CONTRADICTED, "lower")
    assert verdict_of((4.0, 5.0), (2.0, 3.0)) == (Verdict.CONTRADICTED, "higher")


def test_ends_of_the_band_are_accepted() -> None:
    beyond = math.nextafter(3.0, math.inf)

    assert verdict_of((2.0, 3.0), (2.0, 3.0)) == (Verdict.REPRODUCED, None)
    assert verdict_of((2.0, beyond), (2.0, 3.0)) == (Verdict.UNDECIDED, None)
    assert verdict_of((3.0, 4.0), (2.0, 3.0)) == (Verdict.UNDECIDED, None)
    assert verdict_of((beyond, 4.0), (2.0, 3.0)) == (Verdict.CONTRADICTED, "higher")


def test_words_of_the_verdicts_are_the_contract() -> None:
    assert [str(verdict) for verdict in Verdict] == [
        "reproduced",
        "contradicted",
        "undecided",
        "not reproducible",
        "not run",
    ]
