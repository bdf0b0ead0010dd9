import pytest

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text
from repro.tables.possible_runs import ONE_OF_THESE

# of three runs 0, 0 and 1 the standard deviation is 0.577, of a thousand from 0 to 1 at most 0.5
FEW = "F,Best,Mean,Worst,Std\nF1,0.000,{mean},1.000,{std}\n"


def audited(mean: str, std: str, runs: int | None = None) -> AuditedTable:
    options = AuditOptions(runs=runs, precision="double")
    (table,) = audit_text(FEW.format(mean=mean, std=std), options)
    return table


def test_a_block_that_few_runs_allow_is_not_accused_for_what_many_would_not() -> None:
    assert audited("0.333", "0.577", runs=1000).proofs
    assert audited("0.333", "0.577").rows == ()


def test_a_block_that_no_number_of_runs_allows_says_for_which_it_was_tried() -> None:
    (row,) = audited("0.333", "0.8").rows

    assert row.check == "std-bound"
    assert row.condition == ONE_OF_THESE


@pytest.mark.parametrize(
    ("mean", "std", "says"),
    [
        ("0.333", "0.577", "F1 for n = 3 alone"),
        ("0.500", "0.577", "F1 from n = 2 to 4"),
        ("0.500", "0.8", "F1 for no n up to 1000"),
        ("0.500", "0.100", "F1 from n = 50"),
    ],
)
def test_the_numbers_of_runs_that_a_block_allows_are_said(mean: str, std: str, says: str) -> None:
    found = [guess.says for guess in audited(mean, std).guesses if guess.option == "runs"]

    assert found[-1] == f"without n, 0 of 1 blocks can be from n = 2 on; {says}"
