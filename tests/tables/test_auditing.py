import pytest

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import NO_NEGATIVE, audit_text

ZERO_SPREAD = "F,Best,Worst,Std\nF1,0,1.00E-25,0.00E+00\n"
FOUR_DIGITS = "F,Best,Mean,Worst,Std\nF1,12340,12350,12350,4.123\n"
ERRORS = '"Mean error over 51 runs"\nFunction,Mean,Std\nF1,1.0,100\nF2,1.0,1.0\n'


def test_single_precision_takes_back_what_needs_doubles() -> None:
    (open_one,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2))
    (single,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2, precision="single"))
    (double,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2, precision="double"))

    assert open_one.rows
    assert not open_one.proofs
    assert not single.rows
    assert len(double.rows) == len(open_one.rows)


def test_digits_that_are_told_settle_how_whole_numbers_are_rounded() -> None:
    (open_one,) = audit_text(FOUR_DIGITS, AuditOptions(runs=30, precision="double"))
    (four,) = audit_text(FOUR_DIGITS, AuditOptions(runs=30, precision="double", significant=4))
    (five,) = audit_text(FOUR_DIGITS, AuditOptions(runs=30, precision="double", significant=5))

    assert [row.condition for row in open_one.rows] == [
        "no digit of a whole number is rounded away"
    ]
    assert four.rows == ()
    assert [row.is_proof for row in five.rows] == [True]


def test_numbers_with_more_digits_than_told_are_counted() -> None:
    text = FOUR_DIGITS.replace("12350", "12349")
    (found,) = audit_text(text, AuditOptions(runs=30, significant=4))

    says = "whole numbers may be rounded to 4 digits, as told; 2 numbers have more digits"
    assert says in [guess.says for guess in found.guesses]


def test_errors_of_a_caption_are_a_condition_and_told_ones_a_fact() -> None:
    (guessed,) = audit_text(ERRORS, AuditOptions())
    (told,) = audit_text(ERRORS, AuditOptions(errors=True))

    assert [row.condition for row in guessed.rows] == [NO_NEGATIVE]
    assert [row.is_proof for row in told.rows] == [True]
    assert "values ≥ 0 from 'error' in the caption" in [guess.says for guess in guessed.guesses]


@pytest.mark.parametrize(
    "text", [ERRORS.replace("error", "standard error"), ERRORS + "F3,-1.0,2.0\n"]
)
def test_no_errors_are_guessed_of_standard_errors_or_below_0(text: str) -> None:
    (found,) = audit_text(text, AuditOptions())

    assert not any(row.condition == NO_NEGATIVE for row in found.rows)
    assert "errors" not in [guess.option for guess in found.guesses]


def test_without_n_only_blocks_that_are_shown_are_tried_further() -> None:
    lines = "".join(f"F{k},1.0,2.0,3.0,0.1\n" for k in range(9))
    (found,) = audit_text(f"F,Best,Mean,Worst,Std\n{lines}", AuditOptions())

    (says,) = [g.says for g in found.guesses if g.says.startswith("without n")]
    assert says.startswith("without n, 0 of 9 blocks can be from n = 2 on; F0 from n = 40")
    assert says.endswith("F5 from n = 40; …")


def test_of_two_spreads_only_the_one_that_checks_read_is_counted() -> None:
    (found,) = audit_text("F,Mean,Std,SEM\nF1,1.0,0.3,0.1\n", AuditOptions(runs=9))

    assert (found.cells, found.checked) == (3, 2)


def test_the_title_of_a_table_is_said_without_markup() -> None:
    text = (
        r"\caption{Costs of \textit{set\_a}} \begin{tabular}{lr} F & Mean \\ F1 & 1.5 \end{tabular}"
    )
    (found,) = audit_text(text, AuditOptions())

    assert found.label == "Costs of set_a"
