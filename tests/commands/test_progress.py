import io
import sys
from dataclasses import replace
from typing import TextIO, cast

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from repro.commands.progress import Progress, duration
from repro.commands.streams import FitForTerminal, for_terminal
from repro.runs.plan import plan
from repro.runs.run import failed
from tests.hostile import STRINGS
from tests.small_papers import PAPER

TASK = plan([PAPER], 1)[0]


class Terminal(io.StringIO):
    """A stream that says it is a terminal."""

    def isatty(self) -> bool:
        """Say so."""
        return True


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return the time in a list, to be set by the test."""
    now = [100.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    return now


def expecting(stream: io.StringIO | None, count: int) -> Progress:
    """Return the progress of so many runs, of which none is done."""
    progress = Progress(stream)
    progress.expect([TASK] * count, {})
    return progress


def go_on(progress: Progress, runs: int, seconds: float = 1.0) -> None:
    """Let some runs be done, one after the other."""
    for _ in range(runs):
        progress.note(failed(TASK, "", seconds))
    progress(0, 0)


def test_plain_lines_come_ten_seconds_apart_and_at_the_end(clock: list[float]) -> None:
    stream = io.StringIO()
    progress = expecting(stream, 40)

    for _ in range(40):
        clock[0] += 1.0
        go_on(progress, 1)

    assert stream.getvalue().splitlines() == [
        "10/40 runs (25 %), 30 s left: small2020, search",
        "20/40 runs (50 %), 20 s left: small2020, search",
        "30/40 runs (75 %), 10 s left: small2020, search",
        "40/40 runs (100 %), 0 s left: small2020, search",
    ]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(name=st.text() | st.sampled_from(STRINGS) | st.just("a\nb"))
def test_no_name_of_an_experiment_moves_the_cursor(clock: list[float], name: str) -> None:
    for terminal in (Terminal(), io.StringIO()):
        progress = Progress(cast("TextIO", FitForTerminal(terminal)))
        task = replace(TASK, experiment=name)
        progress.expect([task, task], {})
        clock[0] += 20.0
        progress.note(failed(task, "", 1.0))
        progress(0, 0)

        (drawn,) = terminal.getvalue().removeprefix("\r").splitlines()
        line = drawn.removesuffix("\033[K")
        assert line == for_terminal(line)
        assert line.count("left: small2020, ") == 1


def test_plain_lines_hold_no_control_characters(clock: list[float]) -> None:
    stream = io.StringIO()
    progress = expecting(stream, 40)
    clock[0] += 60.0

    go_on(progress, 7)

    assert stream.getvalue().rstrip("\n").isprintable()


def test_terminal_shows_one_line_that_is_redrawn(clock: list[float]) -> None:
    stream = Terminal()
    progress = expecting(stream, 40)

    for runs in (10, 10, 20):
        clock[0] += 5.0
        go_on(progress, runs)

    shown = stream.getvalue()
    assert shown.count("\n") == 1
    assert shown.endswith("\n")
    assert [line.count("█") for line in shown.split("\r")[1:]] == [7, 15, 30]


def test_last_state_is_shown_however_soon_it_comes(clock: list[float]) -> None:
    stream = io.StringIO()

    go_on(expecting(stream, 3), 3)

    assert clock == [100.0]
    assert stream.getvalue().startswith("3/3 runs (100 %), 0 s left")


def test_nothing_is_said_before_the_first_run_is_done(clock: list[float]) -> None:
    stream = io.StringIO()
    progress = expecting(stream, 40)
    clock[0] += 60.0

    progress(0, 40)

    assert not stream.getvalue()


def test_time_in_which_something_else_goes_on_does_not_count(clock: list[float]) -> None:
    stream = io.StringIO()
    progress = expecting(stream, 40)
    with progress.paused():
        clock[0] += 500.0
    clock[0] += 10.0

    go_on(progress, 10)

    assert "30 s left" in stream.getvalue()


def test_runs_that_come_later_are_counted_anew(clock: list[float]) -> None:
    stream = io.StringIO()
    progress = expecting(stream, 4)
    clock[0] += 10.0
    go_on(progress, 4)
    assert not progress.expecting

    progress.expect([TASK] * 2, {})
    clock[0] += 10.0
    go_on(progress, 1)

    assert stream.getvalue().splitlines()[1].startswith("1/2 runs (50 %), 10 s left")


@pytest.mark.parametrize(
    ("seconds", "said"),
    [(0.4, "0 s"), (59.6, "1 min 0 s"), (200, "3 min 20 s"), (7500, "2 h 5 min")],
)
def test_times_are_said_as_a_reader_would(seconds: float, said: str) -> None:
    assert duration(seconds) == said


def test_stream_is_the_standard_error_of_the_moment(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = io.StringIO()
    monkeypatch.setattr(sys, "stderr", stream)

    go_on(expecting(None, 3), 3)

    assert stream.getvalue()
