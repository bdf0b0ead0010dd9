import multiprocessing
import os
import signal
import threading
import time
from functools import partial
from pathlib import Path

import pytest

from repro.runs.workers.side_by_side import Ask, beside, side_by_side


@pytest.fixture(autouse=True)
def alone(monkeypatch: pytest.MonkeyPatch) -> None:
    # threads that the tests' own runner has beside them are none of ours
    monkeypatch.setattr(threading, "active_count", lambda: 1)


def test_what_calls_find_comes_back_in_their_order_from_as_many_processes_as_work() -> None:
    found = side_by_side([partial(own_number, k) for k in range(5)], 2, nothing)
    numbers = [each.partition(b" ")[2] for each in found if each]
    assert [each and each[:1] for each in found] == [b"0", b"1", b"2", b"3", b"4"]
    assert len({*numbers, str(os.getpid()).encode()}) == 3


def nothing(number: int, what: bytes) -> None:
    pytest.fail(f"call {number} asked for {what!r}")


def own_number(k: int, _: Ask) -> bytes:
    time.sleep(0.02 * (5 - k))
    return f"{k} {os.getpid()}".encode()


def test_a_call_that_fails_or_dies_finds_nothing_and_stops_no_other() -> None:
    def fails(_: Ask) -> bytes:
        raise SystemExit(3)

    def dies(_: Ask) -> bytes:
        os._exit(0)

    assert side_by_side([fails, dies, lambda _: b"x" * (1 << 20)], 2, nothing) == [
        None,
        None,
        b"x" * (1 << 20),
    ]


@pytest.mark.parametrize(("workers", "calls"), [(1, 2), (2, 1)])
def test_nothing_is_made_apart_where_that_saves_no_time(workers: int, calls: int) -> None:
    assert side_by_side([lambda _: b"made"] * calls, workers, nothing) == [None] * calls


def test_an_interrupt_ends_what_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def late(_: Ask) -> bytes:
        time.sleep(600)
        (tmp_path / "late").touch()
        return b""

    def interrupted(_: object) -> object:
        raise KeyboardInterrupt

    monkeypatch.setattr("repro.runs.workers.side_by_side.wait", interrupted)
    with pytest.raises(KeyboardInterrupt):
        side_by_side([late, late], 2, nothing)
    monkeypatch.undo()
    assert all_have_ended()


def all_have_ended() -> bool:
    for child in multiprocessing.active_children():
        child.join(10)
    return multiprocessing.active_children() == []


def test_what_a_call_asks_for_is_done_here_before_it_goes_on(tmp_path: Path) -> None:
    def asks(k: int, ask: Ask) -> bytes:
        for _ in range(2):
            ask(str(tmp_path / str(k)).encode())
        return (tmp_path / str(k)).read_bytes()

    def do(number: int, what: bytes) -> None:
        with Path(what.decode()).open("a", encoding="utf-8") as file:
            file.write(f"{number} in {os.getpid()}. ")

    found = side_by_side([partial(asks, k) for k in range(3)], 2, do)

    assert found == [f"{k} in {os.getpid()}. ".encode() * 2 for k in range(3)]


def test_a_call_that_dies_while_it_waits_stops_no_other() -> None:
    def asks(ask: Ask) -> bytes:
        ask(str(os.getpid()).encode())
        return b"found"

    def do(number: int, what: bytes) -> None:
        if number == 0:
            os.kill(int(what), signal.SIGKILL)

    assert side_by_side([asks, asks, asks], 2, do) == [None, b"found", b"found"]


def test_what_cannot_be_done_for_a_call_ends_all() -> None:
    def asks(ask: Ask) -> bytes:
        ask(b"")
        return b""

    def do(number: int, what: bytes) -> None:
        raise KeyError(number, what)

    with pytest.raises(KeyError):
        side_by_side([asks, asks], 2, do)
    assert all_have_ended()


def test_a_call_beside_is_made_meanwhile_and_ends_with_the_block(tmp_path: Path) -> None:
    made = tmp_path / "made"

    def call() -> None:
        made.write_text(str(os.getpid()), encoding="utf-8")
        made.rename(tmp_path / "whole")
        time.sleep(600)

    with beside(call):
        while not (tmp_path / "whole").exists():
            time.sleep(0.01)
        (child,) = multiprocessing.active_children()
    assert (tmp_path / "whole").read_text(encoding="utf-8") == str(child.pid)
    assert multiprocessing.active_children() == []


def test_what_a_call_beside_raises_is_its_own(capfd: pytest.CaptureFixture[str]) -> None:
    def call() -> None:
        raise KeyError

    with beside(call):
        assert all_have_ended()
    assert capfd.readouterr() == ("", "")
