import sys
from dataclasses import replace

import pytest

from repro.audit.blocks import blocks
from repro.model.cells import every_cell
from repro.model.tolerances import Absolute
from repro.tables.checks import rows_of_blocks
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER

TABLE = PublishedTable.read("""
    Table 1, p. 3
    problem | statistic                   || guess | wide
    bowl    | mean                        || 0.05  | 0.5
            | median                      || 0.04  | 0.4
            | success rate at 0.1 [%]     || 90    | 0
            | rank [rank]                 || 1     | 2
""")


def test_counts_and_ranks_of_runs_are_no_costs_of_a_block() -> None:
    claims = every_cell(
        TABLE, of=EXPERIMENT, rows=("problem", "statistic"), columns="algorithm", within=Absolute(0)
    )

    found = blocks(replace(PAPER, results=(TABLE,), claims=claims))

    assert [set(block.cells) for block in found] == [{"mean", "median"}] * 2


def test_a_table_is_looked_through_once_whatever_its_blocks(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    looked: list[str] = []

    def looks(table: PublishedTable) -> bool:
        looked.append(table.label)
        return False

    # the package has a function of the name of the module
    monkeypatch.setattr(sys.modules["repro.audit.blocks"], "is_scientific", looks)
    claims = every_cell(
        TABLE, of=EXPERIMENT, rows=("problem", "statistic"), columns="algorithm", within=Absolute(0)
    )

    assert len(blocks(replace(PAPER, results=(TABLE,), claims=claims))) == 2
    assert looked == ["Table 1"]


MAXIMISED = PublishedTable.read("""
    Table 2, p. 3
    problem | statistic || guess | wide
    bowl    | best      || 1190  | 1180
            | mean      || 1184  | 1170
            | worst     || 1175  | 1160
""")


def test_a_true_table_of_maximised_costs_raises_no_alarm_where_its_experiment_says_so() -> None:
    told = replace(EXPERIMENT, maximise=True)
    claims = every_cell(
        MAXIMISED, of=told, rows=("problem", "statistic"), columns="algorithm", within=Absolute(0)
    )

    found = blocks(replace(PAPER, experiments=(told,), results=(MAXIMISED,), claims=claims))

    assert list(rows_of_blocks("small", found)) == []
