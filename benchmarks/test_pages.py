"""`report` at the depth of the committed pages, from this checkout's store where it has one."""

import os
import shutil
import sqlite3
import subprocess
import sys
from contextlib import closing
from functools import partial
from pathlib import Path
from time import perf_counter

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.goals import measured
from benchmarks.measuring import seconds, timed
from benchmarks.results import Results, Section

ROOT = Path(__file__).parent.parent
STORE = ROOT / ".repro" / "runs.sqlite"
REPORTS = Section(
    title="Pages of the committed depth",
    text="Seconds of `repro report` by the clock, as a program of its own, at this checkout's "
    "store: with nothing kept, with one run of syji fewer, with nothing changed.",
    columns=("what", "s"),
)


@pytest.mark.skipif(not STORE.exists(), reason="this checkout has no store")
def test_report(benchmark: BenchmarkFixture, results: Results, tmp_path: Path) -> None:
    shutil.copy(STORE, tmp_path)
    places = ("--store", tmp_path, "--reports", tmp_path / "reports")
    call = partial(
        subprocess.run, (sys.executable, "-m", "repro", "report", *places),
        check=True, capture_output=True, env=os.environ | {"PYTHONPATH": str(ROOT)},
    )  # fmt: skip

    def one_run_fewer() -> None:
        with closing(sqlite3.connect(tmp_path / STORE.name)) as database, database:
            database.execute("delete from run where id = (select max(id) from run "
                             "where paper = 'syji')")  # fmt: skip

    def all_three() -> dict[str, float]:
        taken = {"nothing kept": seconds(call, perf_counter)}
        one_run_fewer()
        taken["one paper changed"] = seconds(call, perf_counter)
        taken["nothing changed"] = seconds(call, perf_counter)
        return taken

    for what, took in timed(benchmark, all_three).items():
        results.add(REPORTS, what, measured(took, ".1f"))
