import io
import sys

import pytest

from repro.commands.progress import Progress


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


def test_plain_lines_come_ten_seconds_apart_and_at_the_end(clock: list[float]) -> None:
    stream = io.StringIO()
    say = Progress(stream)

    for done in range(1, 41):
        clock[0] += 1.0
        say(done, 40)

    assert stream.getvalue().splitlines() == [
        "10/40 runs (25 %), 1/s, 30 s left",
        "20/40 runs (50 %), 1/s, 20 s left",
        "30/40 runs (75 %), 1/s, 10 s left",
        "40/40 runs (100 %), 1/s, 0 s left",
    ]


def test_plain_lines_hold_no_control_characters(clock: list[float]) -> None:
    stream = io.StringIO()
    say = Progress(stream)
    clock[0] += 60.0

    say(7, 40)

    assert stream.getvalue().rstrip("\n").isprintable()


def test_terminal_shows_one_line_that_is_redrawn(clock: list[float]) -> None:
    stream = Terminal()
    say = Progress(stream)

    for done in (10, 20, 40):
        clock[0] += 5.0
        say(done, 40)

    shown = stream.getvalue()
    assert shown.count("\n") == 1
    assert shown.endswith("\n")
    assert [line.count("█") for line in shown.split("\r")[1:]] == [7, 15, 30]


def test_last_state_is_shown_however_soon_it_comes(clock: list[float]) -> None:
    stream = io.StringIO()

    Progress(stream)(3, 3)

    assert clock == [100.0]
    assert stream.getvalue().startswith("3/3 runs (100 %)")


def test_nothing_is_said_before_the_first_run_is_done(clock: list[float]) -> None:
    stream = io.StringIO()
    say = Progress(stream)
    clock[0] += 60.0

    say(0, 40)

    assert not stream.getvalue()


def test_stream_is_the_standard_error_of_the_moment(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = io.StringIO()
    monkeypatch.setattr(sys, "stderr", stream)

    Progress()(3, 3)

    assert stream.getvalue()
