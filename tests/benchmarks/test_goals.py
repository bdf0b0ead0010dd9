import pytest

from benchmarks import test_audit, test_engine, test_limit, test_peers
from benchmarks.goals import GOALS, Goal, held_against, measured
from benchmarks.results import Results, Section

SECTIONS = (
    *(test_engine.WHOLE, test_engine.RUNS, test_engine.CORES),
    *(test_audit.AUDIT, test_limit.LIMIT, test_peers.PEERS),
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
