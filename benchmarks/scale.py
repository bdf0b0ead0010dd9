"""What planning, storing and judging cost at 10^4, 10^5 and 10^6 records that nobody ran.

`python benchmarks/scale.py [RECORDS…]` prints a table; each step has a process of its own, so that
its memory, beyond that of a fresh process, is its own. Fails where planning takes 30 s or judging
60 s.
"""

import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np

from repro.judge.findings import findings_of
from repro.model.cells import every_cell
from repro.model.paper import Paper
from repro.model.tolerances import Percent
from repro.runs.gather import gather
from repro.runs.plan import Task, plan
from repro.runs.run import Record
from repro.runs.store.store import Store
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER, Bowl, Guessing

RUNS, REPEATS, ITERATIONS = 30, 10, 50
CELLS_PER_ROW = 2
AT_ONCE = 500
LIMITS = {"plan": 30.0, "judge": 60.0}  # s, at 10^6


def paper_of(records: int) -> Paper:
    """Return a paper whose protocol, ten times over, is about so many runs, each cell claimed."""
    rows = max(1, records // (RUNS * REPEATS * CELLS_PER_ROW))
    problems = {f"bowl {k}": Bowl(centre=(k / rows, -0.25)) for k in range(rows)}
    experiment = replace(
        EXPERIMENT,
        problems=problems,
        algorithms={"guess": Guessing(), "wide": Guessing(width=4.0)},
        iterations=ITERATIONS,
        runs=RUNS,
    )
    lines = "\n".join(f"{name} | mean || 0.05 | 0.5" for name in problems)
    head = "Table 1, p. 3 (30 runs)\nproblem | statistic || guess | wide\n"
    table = PublishedTable.read(head + lines)
    claims = every_cell(
        table, of=experiment, rows=("problem", "statistic"), columns="algorithm", within=Percent(25)
    )
    return replace(PAPER, experiments=(experiment,), results=(table,), claims=claims)


def invented(tasks: tuple[Task, ...]) -> Iterator[Record]:
    """Yield a record for each task, out of thin air."""
    rng = np.random.default_rng(1)
    for task in tasks:
        history = np.sort(rng.random(ITERATIONS))[::-1]
        yield Record(
            task=task,
            cost=float(history[-1]),
            x=rng.random(2),
            history=history,
            evaluations=ITERATIONS * task.population,
            seconds=0.01,
        )


def measured(step: str, records: int, folder: Path) -> tuple[float, float, int]:
    """Return the seconds of one step, by the wall and of the processor, and its records."""
    paper = paper_of(records)
    start = time.perf_counter(), time.process_time()
    tasks = plan([paper], REPEATS)
    if step != "plan":
        with Store(folder) as store:
            start = time.perf_counter(), time.process_time()
            STEPS[step](store, paper, tasks)
    return time.perf_counter() - start[0], time.process_time() - start[1], len(tasks)


def _store(store: Store, _paper: Paper, tasks: tuple[Task, ...]) -> None:
    store.begin({})
    records = invented(tasks)
    while batch := list(islice(records, AT_ONCE)):
        store.add(batch)


def _resume(store: Store, _paper: Paper, tasks: tuple[Task, ...]) -> None:
    if store.missing(tasks):
        sys.exit("records are missing")


def _judge(store: Store, paper: Paper, tasks: tuple[Task, ...]) -> None:
    findings = findings_of(paper.claims, gather(store, paper, tasks))
    if len(findings) != len(paper.claims):
        sys.exit("a claim was not judged")


STEPS: dict[str, Callable[[Store, Paper, tuple[Task, ...]], None]] = {
    "store": _store,
    "resume": _resume,
    "judge": _judge,
}


def _report(step: str, records: int, folder: Path) -> None:
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    figures = measured(step, records, folder)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024 - memory
    sys.stdout.write(json.dumps([*figures, memory]))


def main() -> int:
    """Print the table and return 1 where a limit is broken."""
    sizes = [int(float(size)) for size in sys.argv[1:]] or [10**4, 10**5, 10**6]
    broken: list[str] = []
    sys.stdout.write(
        "| records | step | s | CPU s | CPU µs per record | MB |\n|---|---|---|---|---|---|\n"
    )
    for size in sizes:
        with tempfile.TemporaryDirectory() as folder:
            for step in ("plan", *STEPS):
                told = subprocess.run(
                    (sys.executable, __file__, step, str(size), folder),
                    capture_output=True,
                    check=True,
                ).stdout
                wall, seconds, count, memory = json.loads(told)
                sys.stdout.write(
                    f"| {count} | {step} | {wall:.1f} | {seconds:.1f} "
                    f"| {1e6 * seconds / count:.0f} | {memory:.0f} |\n"
                )
                sys.stdout.flush()
                # of the processor: what else a machine does is no cost of ours
                if seconds > LIMITS.get(step, float("inf")):
                    broken.append(f"{step} of {count} took {seconds:.0f} s")
    sys.stderr.writelines(f"{line}\n" for line in broken)
    return 1 if broken else 0


if __name__ == "__main__":
    if len(sys.argv) == 4 and sys.argv[1] in ("plan", *STEPS):
        _report(sys.argv[1], int(sys.argv[2]), Path(sys.argv[3]))
    else:
        sys.exit(main())
