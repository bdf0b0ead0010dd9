"""What a study of 10^4 to 10^7 short runs costs, step by step.

`python benchmarks/scale.py [RUNS…] [--dask ADDRESS]` plans a made-up paper, makes its runs (here,
or on a Dask cluster that exists already), asks what is missing, judges and writes the pages, and
prints a table. Problems and repeats grow alike, with the root of the number of runs. Each step has
a process of its own, so that its memory, beyond that of a fresh process, is its own.
"""

import argparse
import json
import math
import re
import resource
import subprocess
import sys
import tempfile
import time
from argparse import Namespace
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from repro.commands.running import run_lacking
from repro.commands.written_pages import write_pages
from repro.functions import FUNCTIONS
from repro.model.cells import every_cell
from repro.model.paper import Paper
from repro.model.tolerances import Percent
from repro.optimisers import PSO, WOA
from repro.runs.plan import Task, planned
from repro.runs.store.store import Store
from repro.runs.workers.local import usable_cores
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER

RUNS, ITERATIONS, POPULATION = 30, 50, 4
ALGORITHMS = {"WOA": WOA(), "PSO": PSO()}
SIZES = (10**4, 10**5, 10**6)


def study_of(runs: int) -> tuple[Paper, int]:
    """Return a paper, each cell of its table claimed, and how often it makes about so many runs."""
    rows = max(1, round(math.sqrt(runs / 100)))
    problem = FUNCTIONS["sphere"].problem(2)
    experiment = replace(
        EXPERIMENT,
        problems={f"sphere {k}": problem for k in range(rows)},
        algorithms=ALGORITHMS,
        proposed="WOA",
        population=POPULATION,
        iterations=ITERATIONS,
        runs=RUNS,
    )
    lines = "\n".join(f"{name} | mean || 0.05 | 0.5" for name in experiment.problems)
    head = f"Table 1, p. 3 ({RUNS} runs)\nproblem | statistic || {' | '.join(ALGORITHMS)}\n"
    table = PublishedTable.read(head + lines)
    claims = every_cell(
        table, of=experiment, rows=("problem", "statistic"), columns="algorithm", within=Percent(25)
    )
    paper = replace(PAPER, experiments=(experiment,), results=(table,), claims=claims)
    return paper, max(1, round(runs / (RUNS * rows * len(ALGORITHMS))))


def _plan(_store: Store, _paper: Paper, tasks: Sequence[Task], _dask: str) -> None:
    for _ in tasks:
        pass


def _run(store: Store, _paper: Paper, tasks: Sequence[Task], dask: str) -> None:
    options = Namespace(dask=dask, workers=usable_cores())
    if run_lacking(store, tasks, options, lambda *_: None):
        sys.exit("a run failed")


def _resume(store: Store, _paper: Paper, tasks: Sequence[Task], _dask: str) -> None:
    if any(store.lacking(tasks)):
        sys.exit("runs are missing")


def _report(store: Store, paper: Paper, tasks: Sequence[Task], _dask: str) -> None:
    results = write_pages(store, [paper], tasks, store.folder / "pages", [paper.key])
    judged = sum(len(each["findings"]) for each in results["papers"])
    if judged != len(paper.claims):
        sys.exit(f"{judged} claims of {len(paper.claims)} were judged")


STEPS: dict[str, Callable[[Store, Paper, Sequence[Task], str], None]] = {
    "plan": _plan,
    "run": _run,
    "resume": _resume,
    "report": _report,
}


def measured(step: str, runs: int, folder: Path, dask: str = "") -> dict[str, float]:
    """Return what one step took in a process of its own: s, processor s, MB, and how many runs."""
    call = (sys.executable, "-m", "benchmarks.scale", str(runs), "--step", step)
    told = subprocess.run(
        (*call, "--folder", str(folder), "--dask", dask), stdout=subprocess.PIPE, check=True
    ).stdout
    found: dict[str, float] = json.loads(told)
    return found


def exponent(taken: Sequence[tuple[float, float]]) -> float:
    """Return the exponent of seconds by runs, of a straight line through their logarithms."""
    runs, seconds = np.log(np.array(taken)).T
    return float(np.polyfit(runs, seconds, 1)[0])


def _measure(step: str, runs: int, folder: Path, dask: str) -> None:
    memory = _peak()
    paper, repeats = study_of(runs)
    with Store(folder) as store:
        start = time.perf_counter(), time.process_time()
        tasks = planned([paper], repeats, protocol_only=True)
        STEPS[step](store, paper, tasks, dask)
        taken = time.perf_counter() - start[0], time.process_time() - start[1]
    names = ("seconds", "processor", "memory", "runs")
    told = dict(zip(names, (*taken, _peak() - memory, len(tasks)), strict=True))
    sys.stdout.write(json.dumps(told))


def _peak() -> float:
    """Return the most memory that this process had, in MB.

    On Linux what getrusage tells of a process begins with what the one that started it had.
    """
    status = Path("/proc/self/status")
    if status.exists():
        (most,) = re.findall(r"^VmHWM:\s*(\d+) kB$", status.read_text("utf-8"), re.MULTILINE)
        return int(most) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main() -> None:
    """Print the table, and the exponent of each step."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", nargs="*", type=float, default=SIZES)
    parser.add_argument("--dask", default="", metavar="ADDRESS")
    parser.add_argument("--step", choices=STEPS)
    parser.add_argument("--folder", type=Path)
    options = parser.parse_args()
    if options.step:
        _measure(options.step, int(options.runs[0]), options.folder, options.dask)
        return
    sys.stdout.write("| runs | step | s | µs a run | MB |\n| --- | --- | --- | --- | --- |\n")
    taken: dict[str, list[tuple[float, float]]] = {step: [] for step in STEPS}
    for runs in map(int, options.runs):
        with tempfile.TemporaryDirectory() as folder:
            for step in STEPS:
                found = measured(step, runs, Path(folder), options.dask)
                count, seconds = found["runs"], found["seconds"]
                taken[step].append((count, seconds))
                sys.stdout.write(
                    f"| {count:.0f} | {step} | {seconds:.1f} | {1e6 * seconds / count:.0f} "
                    f"| {found['memory']:.0f} |\n"
                )
                sys.stdout.flush()
    if len(options.runs) > 1:
        parts = (f"{step} {exponent(points):.2f}" for step, points in taken.items())
        sys.stdout.write(f"\nexponent of the time: {', '.join(parts)}\n")


if __name__ == "__main__":
    main()
