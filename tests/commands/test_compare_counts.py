"""What a comparison measures of a search: its evaluations, its seconds, its chance to win."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.commands.own_searches import Run, let_be_trusted, results, standing_in
from tests.small_papers import EXPERIMENT, PAPER

MODULE = """
import os, time
from pathlib import Path
import numpy as np

began = time.perf_counter()
time.sleep(0.4)  # as loading a library would
calls = []
def asking(wanted):
    def search(cost, bounds, budget, rng):
        points = rng.uniform(*bounds.T, size=(wanted, len(bounds)))
        return min(points, key=cost)
    return search
one, fifty, hundred = asking(1), asking(50), asking(100)
def compiles(cost, bounds, budget, rng):
    if not calls:
        time.sleep(0.4)  # as compiling would
    calls.append(1)
    found = one(cost, bounds, budget, rng)
    spent = time.perf_counter() - began
    if len(calls) == 1:
        Path(f"cold-{os.getpid()}").write_text(str(spent))
    return found
def steady(cost, bounds, budget, rng):
    x = 0.1 * rng.uniform(size=len(bounds))
    cost(x)
    return x
def lucky(cost, bounds, budget, rng):
    x = np.array([0.5, -0.25]) if rng.uniform() < 0.7 else bounds[:, 0]
    x = x + 1e-3 * rng.uniform(size=len(bounds))
    cost(x)
    return x
"""
DEEPER = replace(EXPERIMENT, population=10, iterations=10, runs=12)
SHORT = replace(PAPER, experiments=(DEEPER,), results=(), claims=())


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> Iterator[Run]:
    """Yield what compares searches of a module with a small paper of 100 evaluations a run."""

    def command(*arguments: str) -> tuple[int, str, str]:
        code = main(("compare", *arguments, "--workers", "1", "--quiet"))
        return (code, *capfd.readouterr())

    let_be_trusted(monkeypatch)
    with standing_in(tmp_path, monkeypatch, module=MODULE, paper=SHORT):
        yield command


def test_a_point_that_was_asked_for_and_returned_is_counted_once(run: Run) -> None:
    names = ("one", "fifty", "hundred")

    run(*(f"mine:{name}" for name in names), "--runs", "2")

    rows = results("one-and-fifty-and-hundred")["runs"]
    counted = {name: {r["evaluations"] for r in rows if r["algorithm"] == name} for name in names}
    assert counted == {"one": {1}, "fifty": {50}, "hundred": {100}}


def test_time_of_a_run_is_free_of_loading_and_compiling(run: Run, tmp_path: Path) -> None:
    run("mine:compiles", "--runs", "3")

    seconds = [row["seconds"] for row in results("compiles")["runs"]]
    cold = min(float(path.read_text()) for path in tmp_path.glob("cold-*"))
    assert len(seconds) == 3
    assert 0.0 < max(seconds) < cold / 2


def test_mean_against_chance_is_warned_of_everywhere(run: Run) -> None:
    code, _, err = run("mine:lucky", "mine:steady")

    found = results("lucky-and-steady")
    (test,) = [each for each in found["tests"] if each["against"] == "steady"]
    means = [
        sum(costs) / len(costs)
        for name in ("lucky", "steady")
        if (costs := [r["cost"] for r in found["runs"] if r["algorithm"] == name])
    ]
    assert code == 0
    assert means[0] > means[1]
    assert test["wins"] > 0.5
    assert test["mean_against_chance"]
    (warned,) = found["warnings"]
    assert warned["kind"] == "mean against chance"
    assert f"repro: mean against chance: {warned['says']}" in err
    assert f"with chance {test['wins']:.2f}" in warned["says"]
    page = Path("reports-private/lucky-and-steady.html").read_text()
    assert warned["says"] in page
    assert "against the mean" in page.partition('<h2 id="small2020">')[2]
    assert warned["says"] in Path("reports-private/lucky-and-steady.md").read_text()
