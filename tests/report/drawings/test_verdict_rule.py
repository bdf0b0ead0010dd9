import pytest

from repro.judge.verdict import HELD, Verdict, verdict_of
from repro.report.drawings.verdict_rule import (
    ACCEPTED,
    EXAMPLES,
    PRINTED,
    ROUNDING,
    SCALE,
    Example,
    verdict_plot,
)

ENDS = PRINTED - ROUNDING, PRINTED + ROUNDING


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: str(example.verdict))
def test_a_picture_shows_the_verdict_that_it_is_named_by(example: Example) -> None:
    own, _ = verdict_of(example.measured, ENDS, ACCEPTED)

    if example.reading:
        other, _ = verdict_of(example.reading, ENDS, ACCEPTED)
        assert example.verdict is Verdict.DEPENDS
        assert own is Verdict.CONTRADICTED
        assert other in HELD
    else:
        assert own is example.verdict


def test_every_verdict_that_runs_can_give_has_a_picture() -> None:
    without = {Verdict.NOT_REPRODUCIBLE, Verdict.NOT_RUN}

    assert {example.verdict for example in EXAMPLES} == set(Verdict) - without


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: str(example.verdict))
def test_every_bar_lies_within_the_picture(example: Example) -> None:
    for low, high in (example.measured, example.reading or example.measured, ACCEPTED):
        assert SCALE[0] < low < high < SCALE[1]
    assert f"re-run {example.measured[0]:g} to" in verdict_plot(example).description
