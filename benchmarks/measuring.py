"""Measuring: contenders take turns inside one process, and medians are compared."""

import statistics
import time
from collections.abc import Callable, Mapping
from typing import TypeVar

from pytest_benchmark.fixture import BenchmarkFixture

Outcome = TypeVar("Outcome")
Seconds = Mapping[str, list[float]]


def seconds(call: Callable[[], object]) -> float:
    """Return how long one call takes, in s."""
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def in_turns(
    benchmark: BenchmarkFixture, calls: Mapping[str, Callable[[], object]], *, rounds: int
) -> Seconds:
    """Return the seconds of every call: once untimed, then in turns, round by round."""
    taken: dict[str, list[float]] = {name: [] for name in calls}

    def turn() -> None:
        for name, call in calls.items():
            taken[name].append(seconds(call))

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
