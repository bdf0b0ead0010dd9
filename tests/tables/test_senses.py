import pytest

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text
from repro.tables.blocks import Block
from repro.tables.possible_runs import ONE_OF_THESE
from repro.tables.printed import Printed
from repro.tables.relations import PlacedNumber
from repro.tables.senses import LEAST_IS_BEST, with_senses

RISING = "F{k},{name},1.5,2.5,3.5\n"
FALLING = "F{k},{name},3.5,2.5,1.5\n"
HEAD = "Function,Algorithm,Best,Mean,Worst\n"


def audited(text: str, **told: object) -> AuditedTable:
    (table,) = audit_text(text, AuditOptions(**{"runs": 30, **told}))  # type: ignore[arg-type]
    return table


def sense(table: AuditedTable) -> str:
    return next(guess.says for guess in table.guesses if guess.option == "maximise")


@pytest.mark.parametrize(
    "line",
    [
        "-1.029,-1.02883,-1.0288403",  # of -1.0289 and -1.0288403, each number with own digits
        "8.750512e-4,8.7505053e-4,8.7e-4",
    ],
)
def test_what_holds_of_the_guessed_sense_alone_says_so(line: str) -> None:
    table = audited(f"F,Best,Mean,Worst\nF1,{line}\n")

    assert sense(table) == "minimisation, though no best is surely the lower value"
    assert table.rows
    for row in table.rows:
        assert LEAST_IS_BEST in str(row.condition)
    assert audited(f"F,Best,Mean,Worst\nF1,{line}\n", maximise=True).rows == ()


def test_what_holds_in_either_sense_needs_no_sense() -> None:
    table = audited("F,Best,Mean,Worst,Std\nF1,5.0,5.00,5.000,3\nF2,5.0,7.0,5.00,0.1\n")

    assert {row.check for row in table.proofs} == {"std-bound", "mean-bound"}


@pytest.mark.parametrize("line", ["10010,10010,9990", "1.01e+3,1.01e+3,1.00e+3", "0.2,0.2,0.1"])
def test_numbers_rounded_alike_keep_their_order(line: str) -> None:
    assert sense(audited(f"F,Best,Mean,Worst\nF1,{line}\n")).startswith("maximisation?")


def test_whole_numbers_with_zeros_at_their_ends_may_be_rounded_unlike() -> None:
    text = "F,Best,Worst\nF1,10010,10000\n"

    assert sense(audited(text)).startswith("minimisation, though")
    assert sense(audited(text, significant=4)).startswith("maximisation?")


def test_two_blocks_of_a_problem_that_agree_have_a_sense_of_their_own() -> None:
    lines = [RISING.format(k=k, name=name) for k in (1, 2) for name in ("A", "B")]
    lines += [FALLING.format(k=3, name=name) for name in ("A", "B")]
    table = audited(HEAD + "".join(lines))

    assert table.rows == ()
    assert sense(table) == (
        "maximisation of F3? there the best is the greater value; minimisation elsewhere"
    )


def test_one_reversed_block_is_out_of_order_in_either_kind_of_table() -> None:
    for usual, other in ((RISING, FALLING), (FALLING, RISING)):
        lines = [usual.format(k=k, name=name) for k in (1, 2) for name in ("A", "B")]
        table = audited(HEAD + "".join(lines) + other.format(k=3, name="A"))

        assert {row.row for row in table.proofs} <= {"F3 A", None}
        assert "order" in {row.check for row in table.proofs}


def test_an_accuracy_is_the_better_the_greater_it_is() -> None:
    heads = ("Fitness Best", "Fitness Mean", "Fitness Worst", "Accuracy Best", "Accuracy Mean")
    text = f"Data,{','.join(heads)},Accuracy Worst\nIris,0.02,0.03,0.05,0.98,0.97,0.95\n"
    table = audited(text)

    assert table.rows == ()
    assert sense(table).startswith("maximisation of Accuracy?")


def test_a_success_beyond_a_threshold_needs_the_sense_of_its_block() -> None:
    text = "target: below 1e-3\nF,Best,Worst,Success rate (%)\nF1,5.0e-3,5.00e-3,100\n"
    table = audited(text)

    assert [LEAST_IS_BEST in str(row.condition) for row in table.rows] == [True] * 2


def test_a_spread_that_some_numbers_of_runs_forbid_has_the_conditions_of_each() -> None:
    # of 30 runs in single precision: 1,000 forbid the spread in any, 30 in doubles alone
    line = "F2,85847.3984,92518.84375000,285990.7500,36541.0117"
    table = audited(f"F,Best,Mean,Worst,Std\n{line}\n", runs=None)

    (row,) = table.rows
    assert row.condition == (
        f"runs and statistics are kept in double precision, and {ONE_OF_THESE}"
    )


def test_what_summing_loses_in_a_mean_does_not_reverse_a_declared_block() -> None:
    # 30 runs of 239980.328125 in single precision, summed in turn
    equal = {"best": "239980.328125", "mean": "239980.312500", "worst": "239980.328125"}
    falling = {"best": "3.5", "mean": "2.5", "worst": "1.5"}

    blocks, questions = with_senses("doe", [block_of(falling), block_of(equal)])

    assert [block.maximise for block in blocks] == [True, True]
    assert [row.check for row in questions] == ["maximisation"]
    assert with_senses("doe", [block_of(equal)])[1] == []


def block_of(texts: dict[str, str]) -> Block:
    return Block(
        problem_name="F1",
        algorithm="A",
        quantity="cost",
        n=30,
        cells={
            name: PlacedNumber(printed=Printed(text), label="t", row="F1", column=name)
            for name, text in texts.items()
        },
        scientific=False,
    )


def test_a_best_that_is_the_maximum_tells_the_sense() -> None:
    table = audited("Instance,Min,Mean,Max,Best\nk1,1175,1187,1190,1190\nk2,20,21,22,22\n")

    assert table.rows == ()
    assert sense(table).startswith("maximisation?")


def test_of_a_block_in_order_in_neither_sense_best_and_worst_tell() -> None:
    table = audited("F,Best,Mean,Median,Worst\nF1,1.5,9.5,2.0,3.5\n")

    assert sense(table) == "minimisation"
    assert {row.check for row in table.proofs} == {"mean-bound", "quantile-mean"}
