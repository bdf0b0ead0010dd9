import multiprocessing
import os
import threading
import time
from functools import partial
from pathlib import Path

import pytest

from repro.runs.workers.side_by_side import side_by_side


@pytest.fixture(autouse=True)
def alone(monkeypatch: pytest.MonkeyPatch) -> None:
    # threads that the tests' own runner has beside them are none of ours
    monkeypatch.setattr(threading, "active_count", lambda: 1)


def test_what_calls_find_comes_back_in_their_order_from_as_many_processes_as_work() -> None:
    found = side_by_side([partial(own_number, k) for k in range(5)], 2)
    numbers = [each.partition(b" ")[2] for each in found if each]
    assert [each and each[:1] for each in found] == [b"0", b"1", b"2", b"3", b"4"]
    assert len({*numbers, str(os.getpid()).encode()}) == 3


def own_number(k: int) -> bytes:
    time.sleep(0.02 * (5 - k))
    return f"{k} {os.getpid()}".encode()


def test_a_call_that_fails_or_dies_finds_nothing_and_stops_no_other() -> None:
    def fails() -> bytes:
        raise SystemExit(3)

    def dies() -> bytes:
        os._exit(0)

    assert side_by_side([fails, dies, lambda: b"x" * (1 << 20)], 2) == [
        None,
        None,
        b"x" * (1 << 20),
    ]


@pytest.mark.parametrize(("workers", "calls"), [(1, 2), (2, 1)])
def test_nothing_is_made_apart_where_that_saves_no_time(workers: int, calls: int) -> None:
    assert side_by_side([lambda: b"made"] * calls, workers) == [None] * calls


def test_an_interrupt_ends_what_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def late() -> bytes:
        time.sleep(600)
        (tmp_path / "late").touch()
        return b""

    def interrupted(_: object) -> object:
        raise KeyboardInterrupt

    monkeypatch.setattr("repro.runs.workers.side_by_side.wait", interrupted)
    with pytest.raises(KeyboardInterrupt):
        side_by_side([late, late], 2)
    monkeypatch.undo()
    for child in multiprocessing.active_children():
        child.join(10)
    assert multiprocessing.active_children() == []
