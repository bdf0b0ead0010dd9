"""Measuring: contenders take turns inside one process, and medians are compared.

What runs on one thread is measured in processor time, which other programs on the same cores
disturb little; what waits for disks or other threads, by the clock on the wall.
"""

import statistics
import time
from collections.abc import Callable, Mapping
from typing import TypeVar

from pytest_benchmark.fixture import BenchmarkFixture

Outcome = TypeVar("Outcome")
Seconds = Mapping[str, list[float]]
Clock = Callable[[], float]


def seconds(call: Callable[[], object], clock: Clock = time.thread_time) -> float:
    """Return how long one call takes, in s of the clock."""
    start = clock()
    call()
    return clock() - start


def in_turns(
    benchmark: BenchmarkFixture,
    calls: Mapping[str, Callable[[], object]],
    *,
    rounds: int,
    clock: Clock = time.thread_time,
) -> Seconds:
    """Return the seconds of every call: once untimed, then in turns, round by round."""
    taken: dict[str, list[float]] = {name: [] for name in calls}

    def turn() -> None:
        for name, call in calls.items():
            taken[name].append(seconds(call, clock))

    turn()
    for times in taken.values():
        times.clear()
    timed(benchmark, turn, rounds=rounds)
    return taken


def timed(benchmark: BenchmarkFixture, call: Callable[[], Outcome], *, rounds: int = 1) -> Outcome:
    """Time `call` in so many rounds, and return what the last one returned."""
    outcome: Outcome = benchmark.pedantic(  # type: ignore[no-untyped-call]
        call, rounds=rounds
    )
    return outcome


def median_ratio(ours: list[float], theirs: list[float]) -> float:
    """Return the median over the rounds of our time by theirs."""
    return statistics.median(a / b for a, b in zip(ours, theirs, strict=True))
