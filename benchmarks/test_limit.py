"""Ours against the same loops in C, and against the random numbers and functions alone."""

from functools import partial
from statistics import median

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.in_c import OPTIONS, alone, compiler, draws_of, in_c
from benchmarks.measuring import Seconds, in_turns, median_ratio, seconds
from benchmarks.ours import EVALUATIONS, KERNELS, PROBLEMS, State, kernel, state
from benchmarks.results import Results, Section

ROUNDS = 41
FLOOR_ROUNDS = 15
COUNT = 100_000
FAST = "fast"
COLUMNS = ("exact", "plain", FAST)

pytestmark = pytest.mark.skipif(compiler() is None, reason="there is no C compiler (cc)")

FLOOR = Section(
    title="The floor: random numbers and transcendental functions alone",
    text=f"Nanoseconds each, in C, {COUNT} at a time; arguments from U(-30, 30). `-Ofast` calls "
    "glibc's libmvec, which gives other last bits.",
    columns=("what", f"`{' '.join(OPTIONS['plain'])}`", f"`{' '.join(OPTIONS[FAST])}`"),
)
LIMIT = Section(
    title="Against C",
    text="Nanoseconds per evaluation, single core, population 30, dimension 30, 500 iterations. "
    "C has the cost inlined in its loop; ours reaches it through a pointer, because it is "
    "compiled once per algorithm and once per function, not once per pair. The plain loop takes "
    "its cosine and sine from the C library, and the compiler fuses multiplications with "
    "additions, so that it rounds otherwise; so does `-Ofast`, which sums in any order besides. "
    "With the cosine of repro/determinism/sines.py and nothing fused, C gives the same bits: "
    "before every measurement best costs, histories and the random state afterwards of ten runs "
    "are compared. The floor is what the run's draws take one after the other, and its function's "
    "cosines, "
    "sines and exponentials in libmvec.",
    columns=(
        *("search", "function", "ours", "floor", "ours / C, same bits"),
        *("ours / plain C `-O3`", "ours / C `-Ofast` with libmvec"),
    ),
)
POINTER = Section(
    title="Against C that reaches the cost through a pointer",
    text="The same on the sphere, where a call weighs most, with the cost in C behind a pointer "
    "as ours is.",
    columns=("search", "ours [ns]", "C [ns]", "ours / C"),
)


@pytest.mark.parametrize("what", ["draws", "cosines", "sines", "exponentials"])
def test_each_alone(benchmark: BenchmarkFixture, results: Results, what: str) -> None:
    random = state(1)
    calls = {kind: partial(alone(kind, what, COUNT), random) for kind in ("plain", FAST)}
    taken = in_turns(benchmark, calls, rounds=FLOOR_ROUNDS)
    results.add(FLOOR, what, *(f"{1e9 * median(taken[kind]) / COUNT:.2f}" for kind in calls))


@pytest.mark.parametrize("function", PROBLEMS)
@pytest.mark.parametrize("search", KERNELS)
def test_search_ends_where_c_does(
    benchmark: BenchmarkFixture, results: Results, search: str, function: str
) -> None:
    ours, theirs = kernel(search, function), in_c("exact", search, function)
    for seed in range(10):
        random = state(seed), state(seed)
        assert ours(random[0]) == theirs(random[1])
        assert random[0].tolist() == random[1].tolist()
    random_of = {name: state(1) for name in ("ours", *COLUMNS)}
    calls = {"ours": partial(ours, random_of["ours"])}
    calls |= {kind: partial(in_c(kind, search, function), random_of[kind]) for kind in COLUMNS}
    floor = _floor(search, function)
    taken = in_turns(benchmark, calls, rounds=ROUNDS)
    ratios = (f"{median_ratio(taken['ours'], taken[kind]):.2f}" for kind in COLUMNS)
    results.add(LIMIT, search.upper(), function, _each(taken, "ours"), f"{floor:.0f}", *ratios)


@pytest.mark.parametrize("search", KERNELS)
def test_pointer_costs_both_the_same(
    benchmark: BenchmarkFixture, results: Results, search: str
) -> None:
    ours, theirs = kernel(search, "sphere"), in_c("exact", search, "sphere", pointer=True)
    random = state(1), state(1)
    assert ours(random[0]) == theirs(random[1])
    calls = {"ours": partial(ours, random[0]), "C": partial(theirs, random[1])}
    taken = in_turns(benchmark, calls, rounds=ROUNDS)
    ratio = f"{median_ratio(taken['ours'], taken['C']):.2f}"
    results.add(POINTER, search.upper(), _each(taken, "ours"), _each(taken, "C"), ratio)


def _each(taken: Seconds, name: str) -> str:
    return f"{1e9 * median(taken[name]) / EVALUATIONS:.0f}"


def _floor(search: str, function: str) -> float:
    """Return the nanoseconds per evaluation that draws and functions alone would take."""
    calls = {
        "sphere": {},
        "rastrigin": {"cosines": 30.0},
        "ackley": {"cosines": 30.0, "exponentials": 2.0},
        "penalized_1": {"sines": 30.0},
    }[function]
    calls = calls | {"draws": draws_of(search, function) / EVALUATIONS}
    random = state(1)
    return sum(count * _alone(what, random) for what, count in calls.items())


def _alone(what: str, random: State) -> float:
    run = partial(alone("plain" if what == "draws" else FAST, what, COUNT), random)
    return 1e9 * median(seconds(run) for _ in range(5)) / COUNT
