from pathlib import Path

import pytest

from benchmarks import (
    test_audit,
    test_engine,
    test_limit,
    test_outlook,
    test_pages,
    test_peers,
    test_runs,
    test_scale,
)
from benchmarks.goals import GOALS, Goal, held_against, measured
from benchmarks.results import Results, Section
from benchmarks.scale import exponent
from benchmarks.sessions import SESSIONS, last_runs

SECTIONS = (
    *(test_engine.WHOLE, test_runs.RUNS, test_engine.CORES, test_outlook.OUTLOOK),
    *(test_audit.AUDIT, test_limit.LIMIT, test_peers.PEERS, test_pages.REPORTS),
    *(test_scale.STUDIES, SESSIONS),
)
SPEED = Goal(says="a", section="Speed", where={"who": "a"}, column="times", bound=1000, unit=" ×")


@pytest.mark.parametrize("goal", GOALS, ids=lambda goal: goal.says)
def test_every_goal_names_a_table_and_columns_that_the_benchmarks_write(goal: Goal) -> None:
    (columns,) = (section.columns for section in SECTIONS if section.title == goal.section)

    assert {goal.column, *goal.where, *goal.unless} <= set(columns)


@pytest.mark.parametrize(
    ("cells", "came_to"),
    [
        (["1,000"], "1,000 ×"),
        (["999", "7.5"], "7.5 to 999 ×"),
        (["7", "1,001"], "**missed**: 7 to 1,001 ×"),
        ([], "not measured"),
    ],
)
def test_a_goal_is_held_against_the_whole_range(cells: list[str], came_to: str) -> None:
    rows = [{"who": "a", "times": cell} for cell in cells]

    assert SPEED.came_to([*rows, {"who": "b", "times": "1,000,000"}]) == came_to


def test_a_goal_that_asks_for_more_is_missed_by_less() -> None:
    more = Goal(says="b", section="S", column="x", bound=0.9, unit="", at_least=True)

    assert more.came_to([{"x": "0.91"}]) == "0.91"
    assert more.came_to([{"x": "0.91"}, {"x": "0.89"}]) == "**missed**: 0.89 to 0.91"


def test_rows_are_left_out_by_name() -> None:
    goal = Goal(says="c", section="S", column="x", bound=1, unit=" %", unless={"who": "b"})

    assert goal.came_to([{"who": "a", "x": "0.5 %"}, {"who": "b", "x": "2 %"}]) == "0.5 %"


def test_the_page_holds_its_own_numbers_against_the_goals() -> None:
    results = Results()
    results.add(
        Section(title="Whole calls", text="", columns=("call", "s")), "nothing to do", "2.5"
    )

    assert "| `reproduce` with nothing to do | ≤ 2 s | **missed**: 2.5 s |" in results.text()
    assert next(held_against({}))[2] == "not measured"


def test_a_goal_is_held_against_what_was_measured_and_not_against_what_is_shown() -> None:
    goal = Goal(says="d", section="S", column="x", bound=0.9, unit="", at_least=True)

    shown = measured(0.896, ".2f")

    assert shown == "0.90"
    assert goal.came_to([{"x": shown}]) == "**missed**: 0.896"


def test_a_session_is_shown_as_it_last_ran(tmp_path: Path) -> None:
    noted = tmp_path / "took.tsv"
    assert not [*last_runs(noted)]
    noted.write_text("nox -s a\t9.4\t2026-01-01\nb\t3\t2026-01-02\nnox -s a\t8.6\t2026-01-03\n")

    assert [*last_runs(noted)] == [("`nox -s a`", "9", "2026-01-03"), ("`b`", "3", "2026-01-02")]


@pytest.mark.parametrize("power", [0.5, 1.0, 2.0])
def test_the_exponent_is_that_of_a_power_law(power: float) -> None:
    assert exponent([(n, 3.0 * n**power) for n in (10, 100, 1000)]) == pytest.approx(power)


@pytest.mark.parametrize(
    ("said", "seconds"),
    [("7 s", 7), ("3 min 20 s", 200), ("2 h 5 min", 7500)],
)
def test_the_bar_is_read_as_it_is_said(said: str, seconds: int) -> None:
    found = test_outlook.read(f"\r███·· 12/98 runs (12 %), {said} left: syji, motion\x1b[K")

    assert found == (12, seconds)
    assert test_outlook.read("pages: reports/index.html") is None
