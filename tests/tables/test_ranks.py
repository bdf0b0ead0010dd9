"""Ranks of the text and of tables, as far as rounding and bare zeros leave them open."""

import pytest

from repro.audit import audit
from repro.model.claims import Sentence
from repro.model.measures.measure import Rank, Statistic
from repro.model.tolerances import Absolute
from repro.tables.published import Printed
from repro.tables.relations import AverageRank
from repro.tables.rows import Grade
from tests.summaries import paper_of
from tests.tables.test_relations import rows_of, table_of


@pytest.mark.parametrize(
    ("rival", "condition"),
    [("1.4", "the ranks were taken from the numbers as printed"), ("1.2", None)],
)
def test_ranks_that_more_digits_could_turn_hold_for_the_numbers_as_printed(
    rival: str, condition: str | None
) -> None:
    table = table_of("F || A | B", f"F1 || 1.4003 | {rival}\naverage || 1.0 | 2.0")
    relation = AverageRank(table=table, rows=("F1",), columns=("A", "B"), average="average")
    (row,) = rows_of(relation)
    assert (row.check, row.condition) == ("average-rank", condition)
    assert (row.grade is Grade.NOTED) is (condition is not None)


@pytest.mark.parametrize(("zero", "is_open"), [("0", True), ("0.00×10^0", False)])
def test_a_rank_that_rests_on_a_bare_zero_says_so(zero: str, *, is_open: bool) -> None:
    claim = Sentence(
        claim="A has place 2",
        where="section 9",
        printed=Printed("2", "rank"),
        measure=Rank(
            of=Statistic(experiment="test", problem="F", algorithm="A", statistic="std"),
            among=("A", "B"),
        ),
        accepted=Absolute(0),
    )
    blocks = {"A": {"std": zero}, "B": {"std": "2.00×10^-5"}}
    (row,) = audit(paper_of(blocks, n=30, claims=[claim]))
    assert row.check == "rank-in-text"
    assert str(row.condition).startswith("a bare 0 stands for") is is_open
    assert (row.condition is None) is not is_open
