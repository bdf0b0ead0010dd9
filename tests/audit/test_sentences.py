"""Printed ranks against the printed numbers that they rank."""

from dataclasses import replace

import pytest

from repro.audit import audit
from repro.model.cells import every_cell
from repro.model.tolerances import Absolute
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER, Guessing

THREE = replace(EXPERIMENT, algorithms={name: Guessing() for name in ("a", "b", "c")}, runs=9)
MEANS = "problem | statistic || a | b | c\nbowl | mean || 1.0 | 2.0 | 2.00"


def checks(word: str, ranks: str, means: str = MEANS) -> list[tuple[str, str | None]]:
    """Return what is found, and in which column of the ranks."""
    table = PublishedTable.read(f"Table 1, p. 3\n{means}\n | {word} || {ranks}")
    claims = every_cell(
        table, of=THREE, rows=("problem", "statistic"), columns="algorithm", within=Absolute(0)
    )
    paper = replace(PAPER, experiments=(THREE,), results=(table,), claims=claims)
    return [(row.check, row.cells[0]["column"]) for row in audit(paper)]


@pytest.mark.parametrize(
    ("word", "ranks"),
    [
        ("rank", "1 | 2 | 2"),
        ("rank, ties average", "1 | 2.5 | 2.5"),
        ("rank, ties ordinal", "1 | 2 | 3"),
        ("rank", "1 | 3 | 2"),  # the digits that are not printed may order them
        ("rank by median", "3 | 1 | 2"),  # of what the table does not print
    ],
)
def test_printed_ranks_that_can_be_are_left_alone(word: str, ranks: str) -> None:
    assert checks(word, ranks) == []


def test_printed_rank_that_the_printed_means_refuse_is_found() -> None:
    assert checks("rank", "2 | 1 | 3") == [("rank-in-table", "a"), ("rank-in-table", "b")]


def test_ranks_without_gaps_are_left_alone() -> None:
    tied = MEANS.replace("2.0 | 2.00", "1.0 | 2.00")

    assert checks("rank, ties dense", "1 | 1 | 2", tied) == []
    assert checks("rank", "1 | 1 | 2", tied) == [("rank-in-table", "c")]
