from fractions import Fraction

import pytest

from repro.errors import InputError
from repro.tables.arithmetic import IN_DOUBLES
from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import NO_NEGATIVE, audit_text
from repro.tables.possible_runs import ONE_OF_THESE

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


def test_what_is_told_of_a_problem_that_no_table_has_is_refused() -> None:
    known = AuditOptions(runs=30, minimum={"f1": Fraction(0)})
    audit_text(FOUR_DIGITS, known)

    with pytest.raises(InputError, match=r"^-: no problem is called 'F7'; there is F1$"):
        audit_text(FOUR_DIGITS, AuditOptions(runs=30, minimum={"F7": Fraction(0)}))


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


def test_without_n_what_few_runs_can_have_is_no_contradiction_up_to_a_thousand() -> None:
    text = "F,Best,Mean,Worst,Std\nF1,3278,417800,945500,470000\n"  # n/(n-1) more for few runs
    (found,) = audit_text(text, AuditOptions(maximise=False))

    assert "std-bound" not in [row.check for row in found.rows]


def test_without_n_what_holds_for_some_numbers_of_runs_says_for_which() -> None:
    (none,) = audit_text("F,Mean\nF1,106.16129\n", AuditOptions(integers=True))  # 3291/31
    (some,) = audit_text("F,Mean\nF1,106.33333\n", AuditOptions(integers=True))  # 3190/30

    assert [row.condition for row in none.rows] == [f"{IN_DOUBLES}, and {ONE_OF_THESE}"]
    assert some.rows == ()


def test_equal_numbers_of_unequal_digits_do_not_say_which_sense_is_better() -> None:
    lines = ("F1,0.001443,0.00144290,0.0014429,0", "F2,190,186.73,186.731,0")
    (found,) = audit_text("\n".join(["F,Best,Mean,Worst,Std", *lines]), AuditOptions(runs=30))

    assert found.proofs == ()
    assert "minimisation, though no best is surely the lower value" in [
        guess.says for guess in found.guesses
    ]


def test_numbers_apart_by_little_or_from_a_bare_zero_say_which_sense_is_better() -> None:
    for line in ("32467.99414,32467.96,32467.95312", "0.0004222,2.9e-05,0", "10013,10006,10000"):
        (found,) = audit_text(f"F,Best,Mean,Worst\nF1,{line}\n", AuditOptions(runs=30))

        assert found.proofs == ()
        assert any(guess.says.startswith("maximisation?") for guess in found.guesses)


def test_a_mean_of_equal_floats_does_not_say_which_sense_is_better() -> None:
    lines = ("F1,112867824.0,6131945.0,188.0", "F2,239980.328125,239980.343750,239980.328125")
    (found,) = audit_text("\n".join(["F,Best,Mean,Worst", *lines]), AuditOptions(runs=30))

    assert found.proofs == ()
    assert any(guess.says.startswith("maximisation?") for guess in found.guesses)


def test_of_equal_floats_alone_a_mean_below_the_best_does_not_mean_maximisation() -> None:
    text = "F,Best,Mean,Worst\nF1,2.7846096e-7,2.7846093e-7,2.7846096e-7\n"
    (found,) = audit_text(text, AuditOptions(runs=43))

    assert "minimisation, though no best is surely the lower value" in [
        guess.says for guess in found.guesses
    ]
