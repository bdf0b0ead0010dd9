from collections.abc import Callable
from fractions import Fraction

import pytest

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text
from repro.tables.order import ONE_DEFINITION

DESCRIBED = """,GWO,PSO
count,30.000000,30.000000
mean,2.0,2.0
std,0.5,0.5
min,1.0,1.0
25%,1.6,1.6
50%,2.0,2.0
75%,2.4,1.4
max,3.1,3.1
"""


def audited(text: str, **told: object) -> AuditedTable:
    (table,) = audit_text(text, AuditOptions(**told))  # type: ignore[arg-type]
    return table


def transposed(text: str) -> str:
    lines = [line.split(",") for line in text.strip().splitlines()]
    return "\n".join(",".join(line) for line in zip(*lines, strict=True))


@pytest.mark.parametrize("turn", [str, transposed])
@pytest.mark.parametrize(
    "shares", ["25% 50% 75%", "0.25 0.5 0.75", ".250 .500 .750", "25 % 50 % 75 %"]
)
def test_a_frame_that_pandas_describes_is_read_whole(
    turn: Callable[[str], str], shares: str
) -> None:
    text = DESCRIBED
    for old, new in zip(("25%", "50%", "75%"), shares.replace(" %", "~").split(), strict=True):
        text = text.replace(old, new.replace("~", " %"))
    table = audited(turn(text))

    assert (table.runs, table.checked, len(table.skipped)) == (30, 14, 0)
    assert {row.check for row in table.proofs} == {"order", "quantile-bound"}
    assert not any("no heading names" in guess.says for guess in table.guesses)


@pytest.mark.parametrize(
    "text",
    [
        "Noise,10%,25%,75%\nGWO,1.0,3.0,2.0\nPSO,1.1,3.1,2.2\n",  # levels, beside no statistic
        "F,Best 25%,Best 75%,Mean 25%,Mean 75%\nF1,3.0,1.0,3.5,2.0\n",  # of a budget
        "F,Best,Worst,10%\nF1,1.0,2.0,7.0\n",  # one alone
    ],
)
def test_shares_that_are_no_quantiles_are_left_alone(text: str) -> None:
    assert audited(text, runs=30).rows == ()


@pytest.mark.parametrize(
    ("text", "wrong", "right", "check", "condition"),
    [
        ("F,Median,IQR\nF1,1.00,{}\n", "-2.00", "2.00", "negative-range", None),
        ("F,Best,Worst,IQR\nF1,1.00,2.00,{}\n", "1.50", "1.00", "range-bound", None),
        ("F,Q1,Q3,IQR\nF1,1.00,2.00,{}\n", "1.50", "1.00", "range-quartiles", ONE_DEFINITION),
        ("F,Mean,Std,IQR\nF1,1.00,0.10,{}\n", "1.50", "0.20", "range-std", None),
    ],
)
def test_an_interquartile_range_is_held_against_all_beside_it(
    text: str, wrong: str, right: str, check: str, condition: str | None
) -> None:
    (row,) = audited(text.format(wrong), runs=30).rows

    assert (row.check, row.condition) == (check, condition)
    assert audited(text.format(right), runs=30).rows == ()


def test_a_range_of_errors_need_not_reach_the_least_value() -> None:
    text = "F,Median,IQR\nF1,120.0,0.5\n"

    assert audited(text, runs=30, minimum={"": Fraction(100)}).rows == ()


def test_the_second_of_two_numbers_is_what_heading_or_caption_say() -> None:
    headed = audited("F,Median (IQR),Best\nF1,5.0 (9.0),4.0\n", runs=30)
    told = audited("Table 2: Median and IQR of 30 runs\nF,GWO,PSO\nF1,5.0 (9.0),4.0 (1.0)\n")
    errors = audited("Mean ± standard error of 30 runs\nF,GWO,PSO\nF1,5.0 ± 9.0,4.0 ± 1.0\n")

    assert headed.rows == told.rows == errors.rows == ()
    says = [guess.says for table in (headed, told, errors) for guess in table.guesses]
    assert "of two numbers in one cell the second is the iqr" in says
    assert "of two numbers in one cell the first is the median, the second is the iqr" in says
    assert "of two numbers in one cell the second is the sem" in says


def test_negative_medians_of_runs_are_no_errors() -> None:
    text = "Errors of 30 runs\nF,mean,25%,75%\nF1,5.0,-1.0,6.0\n"

    assert "errors" not in {guess.option for guess in audited(text).guesses}


def test_a_range_of_runs_of_unknown_size_says_nothing_of_their_spread() -> None:
    # of runs near 1 in doubles, the mean of squares less the square of the mean is 0
    assert audited("F,IQR,Std\nF1,2.320192e-17,0.0e+0\n", runs=36).rows == ()
