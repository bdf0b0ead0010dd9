"""What the audit of a table costs: by itself, as a command, and in the page of the manual."""

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from statistics import median
from threading import Thread
from time import perf_counter
from typing import Any

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.measuring import seconds, timed
from benchmarks.results import Results, Section
from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import audit_text

ROOT = Path(__file__).parent.parent
MANUAL = ROOT / "docs" / "_build" / "html"
BROWSERS = (os.environ.get("REPRO_BROWSER", ""), "chromium", "chromium-browser", "google-chrome")
FUNCTIONS, ALGORITHMS, RUNS = 400, 5, 30

AUDIT = Section(
    title="Auditing a table",
    text="Seconds by the clock on the wall. The table is of runs drawn at random: best, mean, "
    "worst and standard deviation of 30. The page of the manual is loaded over loopback, with "
    "nothing in the browser's cache, and given two blocks.",
    columns=("what", "s"),
)


def table(functions: int, algorithms: int) -> str:
    """Return a table of true statistics as CSV."""
    costs = np.exp(np.random.default_rng(1).normal(size=(functions, algorithms, RUNS)))
    found = {
        "Best": costs.min(-1),
        "Mean": costs.mean(-1),
        "Worst": costs.max(-1),
        "Std": costs.std(-1, ddof=1),
    }
    lines = [f"Table 1: {RUNS} runs", "Function,Index," + ",".join("ABCDE"[:algorithms])]
    for k in range(functions):
        for name, values in found.items():
            lines.append(f"F{k + 1},{name}," + ",".join(f"{value:.4E}" for value in values[k]))
    return "\n".join(lines)


def measured(
    benchmark: BenchmarkFixture, results: Results, what: str, call: Callable[[], object]
) -> None:
    taken: list[float] = []
    timed(benchmark, lambda: taken.append(seconds(call, perf_counter)), rounds=3)
    results.add(AUDIT, what, f"{median(taken):.2f}")


def test_blocks(benchmark: BenchmarkFixture, results: Results) -> None:
    text = table(FUNCTIONS, ALGORITHMS)
    (found,) = audit_text(text, AuditOptions())
    assert found.blocks == FUNCTIONS * ALGORITHMS
    measured(
        benchmark, results, f"{found.blocks:,} blocks", lambda: audit_text(text, AuditOptions())
    )


def test_blocks_without_n(benchmark: BenchmarkFixture, results: Results) -> None:
    _, _, text = table(FUNCTIONS, ALGORITHMS).partition("\n")  # without its title, which tells n
    (found,) = audit_text(text, AuditOptions())
    assert found.runs is None
    call = partial(audit_text, text, AuditOptions())
    measured(benchmark, results, f"{found.blocks:,} blocks, n not told", call)


def test_command(benchmark: BenchmarkFixture, results: Results, tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text(table(1, 2), encoding="utf-8")
    command = (sys.executable, "-m", "repro", "audit", str(file))
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    call = partial(subprocess.run, command, env=environment, check=True, capture_output=True)
    measured(benchmark, results, "`repro audit FILE`, two blocks", call)


def test_page(benchmark: BenchmarkFixture, results: Results) -> None:
    playwright = pytest.importorskip("playwright.sync_api").sync_playwright
    executable = next(filter(None, map(shutil.which, filter(None, BROWSERS))), None)
    if executable is None or not (MANUAL / "pyodide").exists():
        pytest.skip("the page needs a Chromium, and the manual: nox -s docs")
    handler = partial(SimpleHTTPRequestHandler, directory=str(MANUAL))
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    Thread(target=server.serve_forever, daemon=True).start()
    with playwright() as driver:
        browser = driver.chromium.launch(executable_path=executable, args=["--no-sandbox"])
        call = partial(load_to_rows, browser, f"http://127.0.0.1:{server.server_port}")
        measured(benchmark, results, "the page of the manual, from load to rows", call)
        browser.close()
    server.shutdown()
    server.server_close()


def load_to_rows(browser: Any, address: str) -> None:  # noqa: ANN401 (playwright is an extra)
    """Open the page in a context of its own and have a table audited."""
    context = browser.new_context()
    page = context.new_page()
    page.goto(f"{address}/audit_here.html")
    page.get_by_label("The table").fill(table(1, 2))
    page.locator("#audit:enabled").click()
    page.wait_for_selector("#answer section")
    context.close()
