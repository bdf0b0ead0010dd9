"""What searches of other people do, each case once: counted, checked, narrowed, named."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.commands.own_searches import Run, let_be_trusted, results, standing_in
from tests.determinism.edited_packages import forget
from tests.small_papers import PAPER
from tests.unlinked import unlinked

MODULE = """
import os, random, time
from concurrent.futures import ThreadPoolExecutor
import numpy as np
from scipy.optimize import direct, differential_evolution
from repro.optimisers import Result

def centre(cost, bounds, budget, rng): return bounds.mean(axis=1)
def guess(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    return min(points, key=cost)
def threads(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(10 * budget, len(bounds)))
    with ThreadPoolExecutor(8) as pool:
        return points[int(np.argmin(list(pool.map(cost, points))))]
def hidden(cost, bounds, budget, rng):
    return min([[random.uniform(*pair) for pair in bounds] for _ in range(budget)], key=cost)
seen = []
def remembers(cost, bounds, budget, rng):
    seen.append(rng.uniform(*bounds.T))
    return min(seen, key=cost)
def reads(cost, bounds, budget, rng):
    import papers.syji
    return bounds.mean(axis=1)
def one(cost, bounds, budget, rng):
    x = rng.uniform(*bounds.T)
    cost(x)
    return x
def batch(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    return points[np.argmin(cost(points))]
def boxed(cost, bounds, budget, rng): return direct(cost, bounds, maxfun=budget).x
def loud(cost, bounds, budget, rng):
    print("LOUD")
    return guess(cost, bounds, budget, rng)
def wanders(cost, bounds, budget, rng):
    os.mkdir(f"{budget}-{rng.integers(1 << 40)}")
    os.chdir("/")
    return guess(cost, bounds, budget, rng)
def never(cost, bounds, budget, rng):
    while True: time.sleep(0.01)

class Hungry:
    def __init__(self, spent): self.spent = spent
    def minimise(self, problem, population, evaluations, rng):
        points = rng.uniform(*problem.bounds.T, size=(self.spent, len(problem.bounds)))
        costs = [problem.kernel(x, problem.data) for x in points]
        best = int(np.argmin(costs))
        return Result(x=points[best], cost=costs[best], history=np.array(costs[best:best + 1]),
                      evaluations=1)
hungry, modest = Hungry(200_000), Hungry(9)

class Asking:
    def __init__(self, bounds, budget, rng): self.bounds, self.rng = bounds, rng
    def ask(self): return self.rng.uniform(*self.bounds.T, size=(4, len(self.bounds)))
    def tell(self, points, costs): pass
"""
PROGRAM = """
import runpy, signal
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have it ignored
runpy.run_module("repro", run_name="__main__", alter_sys=True)
"""


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> Iterator[Run]:
    """Yield what compares searches of a module with a small paper."""

    def command(*arguments: str) -> tuple[int, str, str]:
        code = main(("compare", *arguments, "--workers", "1", "--quiet"))
        return (code, *capfd.readouterr())

    with standing_in(tmp_path, monkeypatch, module=MODULE, paper=PAPER):
        yield command


@pytest.fixture
def trusted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no run be made again to see whether it comes out."""
    let_be_trusted(monkeypatch)


def mkdir(folder: Path) -> Path:
    folder.mkdir()
    return folder


def kinds(name: str) -> set[str]:
    return {warned["kind"] for warned in results(name)["warnings"]}


def evaluations(name: str) -> set[int]:
    return {row["evaluations"] for row in results(name)["runs"] if row["algorithm"] == name}


@pytest.mark.usefixtures("trusted")
def test_every_form_of_a_search_is_counted_as_its_cost_is_asked(run: Run) -> None:
    names = ("threads", "one", "batch", "Asking")

    code, *_ = run(*(f"mine:{name}" for name in names), "--runs", "1")

    found = results("-and-".join(names))["runs"]
    counted = {row["algorithm"]: row["evaluations"] for row in found}
    assert code == 0
    assert counted == {"threads": 20, "one": 1, "batch": 20, "Asking": 20}


def test_search_that_counts_otherwise_than_its_cost_is_told(run: Run) -> None:
    code, *_ = run("mine:modest", "mine:hungry", "mine:threads", "--runs", "1")

    found = results("modest-and-hungry-and-threads")
    counted = {row["algorithm"]: row["evaluations"] for row in found["runs"]}
    assert code == 0
    assert counted == {"modest": 9, "hungry": 20, "threads": 20}
    told = [w["says"] for w in found["warnings"] if w["kind"] == "uncounted evaluations"]
    assert any("modest" in says and "declares 1 evaluations" in says for says in told)
    assert any("hungry" in says and "stopped" in says for says in told)
    assert len(told) == 2


def test_bounds_are_taken_by_scipys_direct(run: Run) -> None:
    assert run("mine:boxed", "--runs", "2", "--no-centre-bias")[0] == 0
    assert kinds("boxed") == {"identical runs"}


def test_run_that_does_not_come_out_again_is_named_everywhere(run: Run) -> None:
    code, _, err = run("mine:hidden", "mine:remembers")

    page = unlinked(Path("reports-private/hidden-and-remembers.html").read_text())
    assert code == 0
    for told in ("hidden randomness: hidden", "state between runs: remembers"):
        kind, _, name = told.partition(": ")
        says = [w["says"] for w in results("hidden-and-remembers")["warnings"] if w["kind"] == kind]
        assert [each.partition(" ")[0] for each in says] == [name]
        assert f"repro: {told}" in err
        assert kind in page


def test_honest_search_alone_has_no_warning_no_rank_and_its_prints_go_nowhere(run: Run) -> None:
    code, out, err = run("mine:loud", "--name", "own")

    assert (code, err.count("\n")) == (0, 1)
    assert out == "page: reports-private/own.html\n"
    assert "repro: no runs of guess, wide in small2020/search: `repro reproduce small2020`" in err
    assert results("own")["warnings"] == []
    assert {row["rank"] for row in results("own")["standings"]} == {None}
    page = Path("reports-private/own.html").read_text()
    assert "small2020/search: <code>repro reproduce small2020</code> makes them" in page
    assert "`repro reproduce small2020`" in Path("reports-private/own.md").read_text()


def test_a_file_beside_a_search_is_not_taken_for_what_we_import(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PYTHONPATH", raising=False)  # which may name the folder itself
    Path("papers").mkdir()
    for name in ("repro.py", "numpy.py", "papers/__init__.py"):
        Path(name).write_text("raise SystemExit(9)")

    code, _, err = run("mine:reads", "--name", "own", "--runs", "1", "--no-centre-bias")

    assert code == 0, err


def test_a_folder_called_papers_is_not_taken_for_ours(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(MODULE)
    (tmp_path / "papers").mkdir()
    (tmp_path / "papers" / "__init__.py").write_text("raise SystemExit(9)")
    options = ("mine:reads", "syji", "--runs", "1", "--workers", "1", "--no-centre-bias", "--quiet")
    call = (sys.executable, "-m", "repro")  # which looks into the current folder first
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    for command in (("compare", *options), ("list", "syji"), ("list", "syji")):
        done = subprocess.run(
            (*call, *command),
            cwd=tmp_path, env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip

        assert done.returncode == 0, done.stderr
    assert "motion: WOA on SYJI-0035" in done.stdout


def test_search_that_never_returns_is_a_failed_run(run: Run) -> None:
    code, _, err = run("mine:never", "--timeout", "0.3", "--runs", "1")

    assert code == 1
    assert "run small2020/search/bowl/never/1/1 failed: it did not return within 0.3 s" in err


@pytest.mark.usefixtures("trusted")
def test_work_is_narrowed_to_what_is_named(run: Run) -> None:
    run("mine:guess", "--name", "own", "--problem", "bowl", "--experiment", "search", "--runs", "2")

    assert len(results("own")["runs"]) == 2
    code, _, err = run("mine:guess", "--name", "own", "--problem", "bowls")
    assert (code, err.count("\n")) == (2, 1)
    assert "--problem 'bowls' is in none of these papers; they have bowl" in err


@pytest.mark.usefixtures("trusted")
def test_compared_runs_are_verified_and_made_again(
    run: Run, capfd: pytest.CaptureFixture[str]
) -> None:
    run("mine:guess", "--name", "own")

    assert main(("verify",)) == 0
    assert "match: 3" in capfd.readouterr().out
    assert main(("again", "small2020", "search/bowl/own/1/2")) == 0
    assert "the same" in capfd.readouterr().out


@pytest.mark.usefixtures("trusted")
def test_search_is_named_by_its_file_and_found_again_from_elsewhere(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "mine.py").rename(mkdir(tmp_path / "aside") / "mine.py")

    assert run("./aside/mine.py:guess", "--name", "own")[0] == 0

    assert results("own")["places"] == {"own": "mine:guess"}
    monkeypatch.setattr(sys, "path", [p for p in sys.path if not p.startswith(str(tmp_path))])
    sys.modules.pop("mine")
    forget()
    assert main(("verify",)) == 0
    assert "match: 3" in capfd.readouterr().out


@pytest.mark.usefixtures("trusted")
def test_file_of_a_package_is_a_module_of_it(run: Run, tmp_path: Path) -> None:
    inner = mkdir(mkdir(tmp_path / "pack") / "inner")
    for folder in (inner, inner.parent):
        (folder / "__init__.py").touch()
    (inner.parent / "parts.py").write_text(MODULE)
    (inner / "own.py").write_text("from ..parts import guess as near\n")

    assert run("./pack/inner/own.py:near")[0] == 0

    assert results("near")["places"] == {"near": "pack.inner.own:near"}


def test_every_run_begins_in_the_same_folder(run: Run, tmp_path: Path) -> None:
    code, *_ = run("mine:wanders", "--runs", "3", "--no-centre-bias")

    assert code == 0
    assert len(list(tmp_path.glob("20-*"))) == 3


@pytest.mark.parametrize(
    ("place", "says"),
    [
        ("./none.py:guess", "no file ./none.py"),
        ("./json.py:guess", "./json.py cannot be imported as 'json': there is /"),
        ("./a-b.py:guess", "./a-b.py cannot be imported as 'a-b'; give it another name"),
    ],
)
def test_file_that_is_no_module_is_told_in_a_line(
    run: Run, tmp_path: Path, place: str, says: str
) -> None:
    for name in ("json", "a-b"):
        (tmp_path / f"{name}.py").write_text(MODULE)

    code, _, err = run(place)

    assert (code, err.count("\n")) == (2, 1)
    assert says in err


@pytest.mark.usefixtures("trusted")
def test_code_that_cannot_be_kept_is_said_once(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("repro.determinism.compiled.KEPT", None)

    code, _, err = run("mine:guess", "--name", "own", "--runs", "1")

    assert code == 0
    assert err.count("repro: compiled code cannot be kept") == 1


@pytest.mark.parametrize(("sent", "code"), [(signal.SIGTERM, 143), (signal.SIGINT, 130)])
def test_what_ends_it_is_told_by_its_exit_code(
    tmp_path: Path, sent: signal.Signals, code: int
) -> None:
    (tmp_path / "mine.py").write_text(MODULE)
    process = subprocess.Popen(
        (sys.executable, "-c", PROGRAM, "compare", "mine:never", "liang2026", "--problem", "F1",
         "--runs", "1"),
        cwd=tmp_path, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
    )  # fmt: skip
    while not (tmp_path / ".repro" / "runs.sqlite").exists():
        time.sleep(0.05)
    time.sleep(0.5)
    process.send_signal(sent)

    _, err = process.communicate(timeout=60)
    assert process.returncode == code
    assert "Traceback" not in err
