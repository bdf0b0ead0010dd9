"""What a comparison's page, its Markdown and its folder of figures show."""

import csv
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.functions import FUNCTIONS
from repro.optimisers import WOA
from tests.commands.own_searches import Run, let_be_trusted, results, standing_in
from tests.small_papers import EXPERIMENT, PAPER
from tests.small_stores import change
from tests.unlinked import unlinked

MODULE = """
import numpy as np
def guess(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    return points[np.argmin(cost(points))]
def drawn_in(cost, bounds, budget, rng):
    centre, width = bounds.mean(axis=1), np.ptp(bounds, axis=1) / 2
    points = rng.uniform(-width, width, size=(budget, len(bounds)))
    points = centre + points * np.geomspace(1.0, 1e-6, budget)[:, None]
    return points[np.argmin(cost(points))]
def lost(cost, bounds, budget, rng): raise ValueError("no way")
"""
SPHERES = replace(
    EXPERIMENT,
    problems={"F1": FUNCTIONS["sphere"].problem(3), "F9": FUNCTIONS["rastrigin"].problem(3),
              **EXPERIMENT.problems},
    algorithms={"WOA": WOA(), **EXPERIMENT.algorithms},
    runs=3,
)  # fmt: skip
CENTRED = replace(PAPER, experiments=(SPHERES,), results=(), claims=())


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> Iterator[Run]:
    """Yield what runs a command in a folder with a module of searches."""

    def command(*arguments: str) -> tuple[int, str, str]:
        alone = () if arguments[0] in ("verify", "again") else ("--workers", "1")
        code = main((*arguments, *alone))
        return (code, *capfd.readouterr())

    let_be_trusted(monkeypatch)
    with standing_in(tmp_path, monkeypatch, module=MODULE, paper=CENTRED):
        yield command


def test_search_drawn_to_the_centre_is_told_from_one_that_is_not(run: Run) -> None:
    code, *_ = run("compare", "mine:guess", "mine:drawn_in", "--name", "fair", "--name", "biased")

    rows = results("fair-and-biased")["centre_bias"]
    flagged = {name: {r["flagged"] for r in rows if r["algorithm"] == name}
               for name in ("fair", "biased")}  # fmt: skip
    assert code == 0
    assert flagged == {"fair": {False}, "biased": {True}}
    assert {(r["shift"], r["runs"]) for r in rows} == {(0.1, 3), (0.2, 3), (0.4, 3)}
    page = unlinked(Path("reports-private/fair-and-biased.html").read_text())
    assert "Biased to the centre by the rule below: <strong>biased</strong>" in page
    assert "on F1, F9 moved" in page
    assert "Not moved, because the optimum lies off the centre already: bowl" in page
    twin = Path("reports-private/fair-and-biased.md").read_text()
    assert "Biased to the centre: biased." in unlinked(twin)


def test_moved_optima_are_narrowed_as_the_rest_and_verified(run: Run) -> None:
    _, _, err = run("compare", "mine:guess", "--name", "fair", "--problem", "F1", "--runs", "2")

    assert "2/2 runs" in err
    assert "6/6 runs" in err
    found = results("fair")
    assert len(found["runs"]) == 2
    assert {row["runs"] for row in found["centre_bias"]} == {2}
    code, out, _ = run("verify")
    assert code == 0
    assert "match: 8" in out
    code, out, _ = run("again", "small2020", "search [shift 0.2]/F1/fair/1/1")
    assert code == 0


def test_nothing_is_moved_where_that_is_not_wanted_or_a_search_fails(run: Run) -> None:
    code, _, err = run("compare", "mine:guess", "--name", "fair", "--no-centre-bias")
    assert (code, err.count("runs (100 %)")) == (0, 1)
    assert results("fair")["centre_bias"] == []
    assert "Centre bias" not in Path("reports-private/fair.html").read_text()

    code, _, err = run("compare", "mine:lost")
    assert (code, err.count("failed: ValueError")) == (1, 9)


def test_others_of_the_store_stand_beside_with_as_many_runs(run: Run) -> None:
    run("reproduce", "--repeats", "2")
    run("compare", "mine:guess", "--name", "fair", "--runs", "2", "--algorithm", "WOA")

    rows = results("fair")["centre_bias"]
    names = list(dict.fromkeys(row["algorithm"] for row in rows))
    assert names == ["fair", "WOA", "DE (control)", "random search (floor)"]
    assert {row["runs"] for row in rows} == {2}
    shown = {row["algorithm"] for row in results("fair")["standings"]}
    assert shown == {"fair", "WOA"}


def test_runs_of_what_is_not_asked_for_are_not_read(run: Run) -> None:
    run("reproduce", "--repeats", "2")
    change(
        Path(".repro"),
        "update run set cost = cost + 1 "
        "where problem = 'bowl' or algorithm = 'wide' or experiment like '%shift%'",
    )

    narrow = ("--problem", "F1", "--algorithm", "WOA", "--no-centre-bias")
    code, *_ = run("compare", "mine:guess", "--name", "fair", *narrow)

    assert code == 0
    assert {row["algorithm"] for row in results("fair")["standings"]} == {"fair", "WOA"}


def test_figures_stand_on_the_page_and_as_files_beside_it(run: Run) -> None:
    run("reproduce", "--repeats", "1")
    run("compare", "mine:guess", "--name", "own")

    page = Path("reports-private/own.html").read_text()
    words = Path("reports-private/own.md").read_text()
    for kind in ("convergence", "targets", "ranks", "centre-bias"):
        name = f"own/1-small2020-search-{kind}"
        assert f'href="{name}.csv"' in page
        assert f"]({name}.svg)" in words
        assert f"[CSV]({name}.csv)" in words
        picture = Path("reports-private", f"{name}.svg").read_text()
        assert picture.startswith("<svg ")
        assert "background: #ffffff" in picture
        with Path("reports-private", f"{name}.csv").open() as file:
            assert len(list(csv.reader(file))) > 1
    assert page.count("<figure>") == 4
    assert "critical difference" in page


def test_several_searches_are_told_apart_in_every_table(run: Run) -> None:
    names = ("--name", "one", "--name", "two")
    run("compare", "mine:guess", "mine:drawn_in", *names, "--problem", "F1", "--no-centre-bias")

    words = Path("reports-private/one-and-two.md").read_text()
    assert "| problem | search | against | run as | its mean |" in words
    assert "| F1 | one | two | yours |" in words
    assert "| F1 | two | none |" in words
