import math
from dataclasses import replace

import pytest

from repro.judge.turning import ReadingOutcome, Weighed, seeming, turned
from repro.judge.verdict import Verdict
from repro.model.assumptions import Alternative, Assumption
from repro.runs.readings import Reading

HELD, NOT, OPEN = Verdict.CONSISTENT, Verdict.CONTRADICTED, Verdict.UNDECIDED


def outcome(
    verdict: Verdict,
    name: str = "",
    *,
    p: float = 0.5,
    side: str | None = None,
    reading: Reading | None = None,
    measured: tuple[float, float] = (0.0, 1.0),
) -> Weighed:
    shown = ReadingOutcome(reading=name, verdict=verdict, side=side, measured=measured, repeats=10)
    return Weighed(shown=shown, reading=reading, p=p)


def test_reading_that_holds_a_contradicted_number_turns_it() -> None:
    others = [outcome(HELD, "a"), outcome(NOT, "b", p=0.0), outcome(OPEN, "c")]

    assert turned(outcome(NOT, p=0.0), others) == ("a",)


def test_reading_that_surely_contradicts_a_held_number_turns_it() -> None:
    others = [outcome(HELD, "a"), outcome(NOT, "b", p=0.0), outcome(OPEN, "c")]

    assert turned(outcome(HELD), others) == ("b",)


def test_runs_that_rule_nothing_out_turn_nothing() -> None:
    unbounded = outcome(HELD, "few runs", measured=(0.0, math.inf))

    assert turned(outcome(NOT, p=0.0), [unbounded]) == ()
    assert seeming(outcome(NOT, p=0.0), [unbounded]) == (unbounded,)


def test_thirty_chances_do_not_make_one() -> None:
    many = [outcome(HELD, f"held {k}") for k in range(29)]

    assert turned(outcome(HELD), [*many, outcome(NOT, "chance", p=0.01)]) == ()
    assert turned(outcome(HELD), [outcome(NOT, "alone", p=0.01)]) == ("alone",)


def test_number_that_no_reading_touches_turns_on_nothing() -> None:
    assert turned(outcome(NOT, p=0.0), []) == ()
    assert turned(outcome(HELD), []) == ()


def test_undecided_number_turns_only_where_readings_oppose_each_other() -> None:
    held, surely = outcome(HELD, "a"), outcome(NOT, "b", p=0.0)

    assert turned(outcome(OPEN), [held]) == ()
    assert turned(outcome(OPEN), [surely]) == ()
    assert turned(outcome(OPEN), [held, surely]) == ("a", "b")


def setting(at: float, *, what: str = "duration", unprinted: bool = True) -> Reading:
    alternative = Alternative(says=f"{at}", name=f"{what} {at}", at=at)
    assumption = Assumption(
        what=what, chosen="1", alternatives=(alternative,), because="so", where="p. 3",
        open=unprinted, at=1.0,
    )  # fmt: skip
    return Reading(alternatives=(alternative,), of=(assumption,))


def at(side: str, value: float, **options: object) -> Weighed:
    reading = setting(value, **options)  # type: ignore[arg-type]
    return outcome(NOT, reading.name, p=0.0, side=side, reading=reading)


def test_open_setting_that_passes_the_number_between_its_values_turns_it() -> None:
    own = outcome(NOT, p=0.0, side="lower")

    assert turned(own, [at("lower", 0.5), at("higher", 2.0)]) == ("duration",)
    assert turned(own, [at("lower", 0.5), at("lower", 2.0)]) == ()


def test_only_neighbouring_values_of_a_setting_pass_a_number() -> None:
    own = outcome(NOT, p=0.0, side="lower")
    undecided = outcome(OPEN, "duration 2", reading=setting(2.0))

    assert turned(own, [at("higher", 3.0), undecided]) == ()


@pytest.mark.parametrize(("what", "unprinted"), [("duration", False)])
def test_setting_that_the_paper_prints_is_no_range(what: str, *, unprinted: bool) -> None:
    own = outcome(NOT, p=0.0, side="lower")

    assert turned(own, [at("higher", 2.0, what=what, unprinted=unprinted)]) == ()


def test_two_settings_are_two_ranges() -> None:
    own = outcome(OPEN, p=0.5)
    lower, higher = at("lower", 2.0), at("higher", 3.0, what="box")

    assert turned(own, [lower, higher]) == ()
    contradicted = outcome(NOT, p=0.0, side="lower")
    assert turned(contradicted, [lower, higher]) == ("box",)


def test_on_what_the_text_rules_out_no_verdict_turns() -> None:
    note = replace(setting(2.0).alternatives[0], ruled_out=True)
    reading = replace(setting(2.0), alternatives=(note,))
    held, against = (outcome(v, "note", p=0.0, reading=reading) for v in (HELD, NOT))

    assert turned(outcome(NOT, p=0.0), [held]) == ()
    assert turned(outcome(HELD), [against]) == ()
    assert seeming(outcome(NOT), [held]) == ()
    assert seeming(outcome(HELD), [against]) == ()


def test_what_would_turn_a_verdict_seems_to_before_it_is_sure() -> None:
    held, unsure = outcome(HELD, "a"), outcome(NOT, "b", p=0.2)

    assert seeming(outcome(HELD), [held, unsure]) == (unsure,)
    assert seeming(outcome(NOT), [held, unsure]) == (held,)
    assert seeming(outcome(OPEN), [held, unsure]) == ()
