import pytest

from repro.tables.audit_options import AuditOptions
from repro.tables.audit_words import paragraph
from repro.tables.auditing import AuditedTable, audit_text
from repro.tables.counts import ALL_COUNTED, ALL_SHOWN, ONCE

TALLIES = """
Results on 26 functions

| Function | PSO | GWO |
|---|---|---|
| F1 mean | 1.0 | 2.0 |
| +/=/- | {first} | 17/2/7 |
"""
RANKS = """
Function,PSO rank,GWO rank,WOA rank
F1,1,2,3
F2,1,3,2
F3,2,1,3
Total rank,{total},6,8
Average rank,1.33,{mean},2.67
"""
TESTS = """
Function,p-value,h
F1,{p},0
F2,0.2,0
F3,0.001,1
"""
RATES = """
"Table 2: 50 runs, success threshold 1e-4"
Function,Mean,Std,SR [%]
F1,{mean},1e-6,100
F2,1e-3,1e-3,{rate}
"""


def audited(text: str, **told: str) -> AuditedTable:
    (table,) = audit_text(text.format(**told), AuditOptions())
    return table


@pytest.mark.parametrize(
    ("text", "right", "wrong", "says"),
    [
        (TALLIES, {"first": "17/2/7"}, {"first": "17/2/9"}, "17 + 2 + 9 = 28, for 26 problems"),
        (RANKS, {"total": "4", "mean": "2.00"}, {"total": "5", "mean": "2.00"}, "sum 4"),
        (RANKS, {"total": "4", "mean": "2.00"}, {"total": "4", "mean": "2.33"}, "2.33"),
        (TESTS, {"p": "0.06"}, {"p": "0.022972544"}, "is not rejected"),
        (
            RATES,
            {"mean": "1e-6", "rate": "34"},
            {"mean": "9.32e+03", "rate": "34"},
            "at most 0.0001",
        ),
        (RATES, {"mean": "1e-6", "rate": "34"}, {"mean": "1e-6", "rate": "33.0"}, "33.0"),
    ],
)
def test_what_stands_beside_the_statistics_is_checked(
    text: str, right: dict[str, str], wrong: dict[str, str], says: str
) -> None:
    assert audited(text, **right).rows == ()

    rows = audited(text, **wrong).rows

    assert [says in row.explanation for row in rows] == [True]


def test_a_tally_of_more_problems_than_a_part_of_a_table_shows_is_no_contradiction() -> None:
    part = TALLIES.replace("on 26 functions", "in part")

    assert audited(part, first="17/2/9").rows == ()


def test_only_numbers_that_a_check_looks_at_count_as_checked() -> None:
    table = audited(TESTS.replace("h\n", "time\n"), p="0.2")

    assert (table.cells, table.checked) == (6, 3)
    assert "checked 3 of 6 numbers" in paragraph(table)


COLUMNS = '"Tests over 26 functions"\nComparison,wins,ties,losses\nWOA vs PSO,17,2,{losses}\n'


def test_columns_of_wins_ties_and_losses_are_counted() -> None:
    right, wrong = audited(COLUMNS, losses="7"), audited(COLUMNS, losses="9")

    assert right.rows == ()
    assert [row.explanation for row in wrong.rows] == ["17 + 2 + 9 = 28, for 26 problems"]


def test_a_column_of_losses_alone_is_a_cost() -> None:
    table = audited("Algorithm,Loss\nPSO,0.25\nGWO,0.5\n")

    assert (table.rows, table.checked) == ((), 0)


UNKNOWN = """# Sphere

* Error threshold (admissible error) = 1e-4

| | PSO | GA |
|---|---|---|
| Success rate | {rate} | 100 |
| Average fitness | 3.9e-4 | 5e-5 |
"""


@pytest.mark.parametrize("rate", ["100", "96"])
def test_all_runs_or_none_that_succeed_say_the_same_of_any_number_of_runs(rate: str) -> None:
    table = audited(UNKNOWN, rate=rate)

    assert table.label == "Sphere · Error threshold (admissible error) = 1e-4"
    assert [(row.explanation, row.condition) for row in table.rows] == [
        (
            "where 100 % of the runs reach 0.0001, the mean is at most 0.0001; printed is 3.9e-4",
            "the number of runs is at most 100",
        )
    ] * (rate == "100")


def test_a_threshold_of_errors_is_held_against_values_under_a_condition() -> None:
    (row,) = audited(RATES, mean="400.1", rate="34").rows

    assert row.condition == "success is told by the values that are printed"


LINES = "\n".join(f"F{k},1.5,2.5" for k in range(1, 6))


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        ("on 26 functions\nIndex,GWO\n+/=/-,17/2/9\n", None),
        ("on 26 functions\nIndex,GWO\n+/=/-,17/2/6\n", ALL_COUNTED),
        ("on 26 functions\nIndex,GWO\n+/=/-,40/6/6\n", ONCE),
        (f"Function,GWO,PSO\n{LINES}\n+/=/-,3/1/2,3/1/2\n", ALL_SHOWN),
        (f"Function,GWO,PSO\n{LINES}\n+/=/-,3/1/0,3/1/0\n", ALL_SHOWN),
        (f"Function,GWO,PSO\n{LINES}\n+/=/-,3/1/1,3/1/2\n", None),  # the other one agrees
        (f"Function,GWO,PSO\n{LINES}\n+/=/-,3/1/1,3/1/0\n", ALL_COUNTED),
    ],
)
def test_a_tally_of_other_than_all_problems_says_what_it_would_be_wrong_under(
    text: str, condition: str | None
) -> None:
    (table,) = audit_text(text, AuditOptions())

    assert {(row.check, row.condition) for row in table.rows} == {("tally", condition)}


@pytest.mark.parametrize(
    "text",
    [
        "Results on 26 functions\n,GWO vs PSO\n+/=/-,17/2/9\n",
        "Comparison of 26 problems\nAlgorithm,Better,Equal,Worse\nDE,17,2,9\nPSO,17,2,7\n",
        "Summary for 26 functions\nVs,W,T,L\nDE,17,2,9\nPSO,17,2,7\n",
        "Summary for 26 functions\nVs,+,≈,−\nDE,17,2,9\nPSO,17,2,7\n",
        "Summary for 26 functions\nOutcome,DE,PSO\nWins,17,17\nTies,2,2\nLosses,9,7\n",
        "| CEC (26 functions) | PSO | DE |\n|---|---|---|\n| w/t/l | 17/2/7 | 17/2/9 |\n",
    ],
)
def test_tallies_are_counted_wherever_they_and_the_number_of_problems_stand(text: str) -> None:
    (table,) = audit_text(text, AuditOptions())

    assert [row.explanation for row in table.rows] == ["17 + 2 + 9 = 28, for 26 problems"]


def test_a_width_and_a_length_are_no_tally() -> None:
    (table,) = audit_text("Design,W,L\nGWO,1.5,2.5\nPSO,1.6,2.6\n", AuditOptions())

    assert (table.rows, table.checked) == ((), 0)
