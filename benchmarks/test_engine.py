"""What the engine costs besides the loops: planning, storing, judging, pages, whole calls."""

import os
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import islice
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.goals import measured
from benchmarks.measuring import in_turns, seconds, timed
from benchmarks.ours import PROBLEMS, optimiser
from benchmarks.results import Results, Section
from repro.audit import audit
from repro.commands.catalogue import all_papers
from repro.commands.written_pages import write_pages
from repro.determinism.provenance import provenance
from repro.judge.findings import findings_of
from repro.model.paper import Paper
from repro.runs.gather import gather
from repro.runs.plan import Task, plan
from repro.runs.run import Record, execute
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.workers.local import usable_cores

ROOT = Path(__file__).parent.parent
TEN = 10  # the default number of repeats
SAMPLE = 200  # runs that are stored
SPREAD = 1000  # runs that are spread over cores
PAPERS = all_papers()

WHOLE = Section(
    title="Whole calls",
    text="Seconds of `repro reproduce --repeats 1` for all papers, as a program of its own. Cold: "
    "an empty store and nothing compiled, which is paid once per machine. Compiled: an empty "
    "store. Nothing to do: everything stored, the pages as they were written. What `reproduce` "
    "with nothing to do, `list` and `audit` print is kept beside the store, and told again while "
    "nothing changed: the first time takes as long as where nothing is kept.",
    columns=("call", "s"),
)
PARTS = Section(
    title="Parts of the engine",
    text="Milliseconds.",
    columns=("part", "how much", "ms"),
)
CORES = Section(
    title="Scaling and overhead",
    text="The same runs, every fifth of one repeat of all papers, on one and on two workers. "
    "Efficiency is the time on one by twice the time on two; overhead is what one worker's time "
    "holds besides the searches: handing out, storing, syncing the disk. The last column says how "
    "much longer the searches themselves take where two run at once, which is the machine's doing.",
    columns=(
        *("runs", "1 worker [s]", "2 workers [s]", "efficiency", "overhead on 1 worker"),
        "searches, on 2 / on 1",
    ),
)


def calling(folder: Path, place: str, *arguments: str) -> Callable[[], object]:
    """Return a call of Python in a folder of its own, where commands have their store and pages."""
    (folder / place).mkdir(exist_ok=True)
    environment = os.environ | {"NUMBA_CACHE_DIR": str(folder / "numba"), "PYTHONPATH": str(ROOT)}
    return partial(
        subprocess.run, (sys.executable, *arguments),
        env=environment, cwd=folder / place, check=True, capture_output=True,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("call", "place", "rounds"),
    [("cold", "first", 1), ("compiled", "second", 1), ("nothing to do", "second", 5)],
    ids=["cold", "compiled", "nothing to do"],
)
def test_reproduce(
    benchmark: BenchmarkFixture, results: Results, folder: Path, call: str, place: str, rounds: int
) -> None:
    taken: list[float] = []
    call_it = calling(folder, place, "-m", "repro", "reproduce", "--repeats", "1")
    timed(benchmark, lambda: taken.append(seconds(call_it, perf_counter)), rounds=rounds)
    results.add(WHOLE, call, measured(median(taken), ".1f"))


@pytest.mark.parametrize(
    ("call", "place", "arguments"),
    [
        ("`report`", "second", ("-m", "repro", "report", "--repeats", "1")),
        ("`list`", "second", ("-m", "repro", "list", "--repeats", "1")),
        ("`list`, nothing kept", "none", ("-m", "repro", "list", "--repeats", "1")),
        ("`audit syji`", "second", ("-m", "repro", "audit", "syji")),
        ("`audit syji`, nothing kept", "none", ("-m", "repro", "audit", "syji")),
        ("`import repro`", "none", ("-c", "import repro")),
    ],
    ids=["report", "list", "first list", "audit", "first audit", "import"],
)
def test_everyday(
    benchmark: BenchmarkFixture,
    results: Results,
    folder: Path,
    call: str,
    place: str,
    arguments: tuple[str, ...],
) -> None:
    """Commands at the store of `test_reproduce`, as programs of their own."""
    run = calling(folder, place, *arguments)
    taken = in_turns(benchmark, {call: run}, rounds=3, clock=perf_counter)
    results.add(WHOLE, call, measured(median(taken[call]), ".2f"))


def test_compiling(benchmark: BenchmarkFixture, results: Results, folder: Path) -> None:
    """One short run of every pair of search and problem, with nothing compiled."""
    code = (
        "from dataclasses import replace\n"
        "from repro.commands.catalogue import all_papers\n"
        "from repro.runs.plan import plan\n"
        "from repro.runs.run import execute\n"
        "tasks = plan(all_papers().values(), 1)\n"
        "pairs = {(type(t.optimiser), t.subject.kernel): t for t in tasks}\n"
        "for task in pairs.values():\n"
        "    execute(replace(task, iterations=1))\n"
    )
    environment = os.environ | {"NUMBA_CACHE_DIR": str(folder / "empty"), "PYTHONPATH": str(ROOT)}
    call = partial(subprocess.run, (sys.executable, "-c", code), env=environment, check=True)
    taken: list[float] = []
    timed(benchmark, lambda: taken.append(seconds(call, perf_counter)))
    results.add(WHOLE, "compiling everything, nothing else", measured(median(taken), ".1f"))


def test_planning(benchmark: BenchmarkFixture, results: Results) -> None:
    calls = {count: partial(plan, PAPERS.values(), int(count)) for count in ("1", str(TEN))}
    taken = in_turns(benchmark, calls, rounds=5)
    for count in calls:
        runs = len(plan(PAPERS.values(), int(count)))
        results.add(PARTS, "planning", f"{runs} runs", milliseconds(taken[count]))


def test_smallest_runs(benchmark: BenchmarkFixture, results: Results) -> None:
    problem, rng = PROBLEMS["sphere"].problem(1), np.random.default_rng(1)
    search = partial(optimiser("WOA").minimise, problem, population=1, iterations=1, rng=rng)

    def many() -> None:
        for _ in range(1000):
            search()

    taken = in_turns(benchmark, {"calls": many}, rounds=15)
    results.add(PARTS, "`minimise`", "1000 runs of 1 evaluation", milliseconds(taken["calls"]))


def sample(count: int) -> list[Task]:
    """Return runs of all papers in turn, each of some milliseconds."""
    tasks = plan(PAPERS.values(), 1)
    return list(islice(tasks[:: max(1, len(tasks) // count)], count))


def test_storing(benchmark: BenchmarkFixture, results: Results, folder: Path) -> None:
    records = [execute(task) for task in sample(SAMPLE)]
    with Store(folder / "storing") as store:
        store.begin(provenance())

        def one_by_one() -> None:
            for record in records:
                store.add([record])

        calls: dict[str, Callable[[], object]] = {
            "one by one": one_by_one,
            "at once": partial(store.add, records),
        }
        calls["reading"] = lambda: list(store.records([record.task for record in records]))
        taken = in_turns(benchmark, calls, rounds=5, clock=perf_counter)
    for how in calls:
        part = "storing" if how != "reading" else "reading and checking"
        results.add(PARTS, part, f"{len(records)} runs, {how}", milliseconds(taken[how]))


@pytest.mark.parametrize("paper", PAPERS.values(), ids=PAPERS)
def test_judging(benchmark: BenchmarkFixture, results: Results, folder: Path, paper: Paper) -> None:
    tasks = plan([paper], 1)
    with Store(folder / "second" / ".repro") as store:
        evidence = gather(store, paper, tasks)
    calls: dict[str, Callable[[], object]] = {
        "judging": partial(findings_of, paper.claims, evidence),
        "audit": partial(audit, paper),
    }
    taken = in_turns(benchmark, calls, rounds=3)
    results.add(PARTS, f"judging {paper.key}", "one repeat", milliseconds(taken["judging"]))
    results.add(PARTS, f"audit of {paper.key}", "all tables", milliseconds(taken["audit"]))


def test_pages(benchmark: BenchmarkFixture, results: Results, folder: Path) -> None:
    chosen, tasks = list(PAPERS.values()), plan(PAPERS.values(), 1)
    with Store(folder / "second" / ".repro") as store:
        call = partial(write_pages, store, chosen, tasks, folder / "pages", list(PAPERS))
        taken = in_turns(benchmark, {"pages": call}, rounds=1)
    results.add(PARTS, "all pages, judging included", "one repeat", milliseconds(taken["pages"]))


def test_cores(benchmark: BenchmarkFixture, results: Results, tmp_path: Path) -> None:
    if usable_cores() < 2:
        pytest.skip("one core")
    tasks = sample(SPREAD)
    searches: dict[int, list[float]] = {1: [], 2: []}
    folders = iter(range(1000))

    def run(workers: int) -> None:
        with (
            Store(tmp_path / str(next(folders))) as store,
            ThreadPoolExecutor(workers) as executor,
        ):
            failed: list[Record] = run_missing(
                store, tasks, executor=executor, workers=workers,
                environment=provenance, report=lambda *_: None,
            )  # fmt: skip
            searches[workers].append(sum(record.seconds for record in store.records(tasks)))
        assert not failed

    calls = {"1": partial(run, 1), "2": partial(run, 2)}
    taken = in_turns(benchmark, calls, rounds=3, clock=perf_counter)
    one, two = median(taken["1"]), median(taken["2"])
    efficiency = median(a / (2 * b) for a, b in zip(taken["1"], taken["2"], strict=True))
    # the first of the searches is the untimed turn
    overhead = median(
        1 - inside / whole for inside, whole in zip(searches[1][1:], taken["1"], strict=True)
    )
    slower = f"{median(searches[2]) / median(searches[1]):.2f}"
    times = (f"{one:.2f}", f"{two:.2f}")
    results.add(
        *(CORES, str(len(tasks)), *times, measured(efficiency, ".2f")),
        *(measured(100 * overhead, ".1f %"), slower),
    )


def milliseconds(taken: list[float]) -> str:
    return f"{1000 * median(taken):,.0f}"
