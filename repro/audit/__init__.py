"""What printed tables say about themselves, before any run.

Grades: `impossible` is a proof where the row has no condition: no runs in double or single
precision, in any usual order of summing, rounded or cut off, give the print; else it is one if the
condition holds. `inconsistent` means that two printed places disagree; `noted` is a coincidence or
a place to look.
"""

from collections.abc import Callable, Iterator
from typing import Any

from repro.audit.alone import tables_alone
from repro.audit.arms import arm_rows
from repro.audit.blocks import blocks
from repro.audit.poses import pose_rows
from repro.audit.sentences import sentence_rows
from repro.audit.times import time_rows
from repro.model.paper import Paper
from repro.tables.checks import rows_of_blocks
from repro.tables.derived import equal_rows, formula_rows, ratio_rows
from repro.tables.inputs import range_rows, same_rows, spacing_rows
from repro.tables.probabilities import p_value_rows
from repro.tables.ranks import rank_rows
from repro.tables.relations import (
    AverageRank,
    ByFormula,
    Equal,
    EqualSpacing,
    InRange,
    Less,
    Mean,
    PercentLower,
    PrintedPoses,
    PValues,
    Relation,
    SameNumbers,
    Sum,
    Times,
)
from repro.tables.repeats import repeat_rows
from repro.tables.rows import AuditRow, CellPlace, Grade
from repro.tables.sums import difference_rows, mean_rows, percentage_rows, sum_rows

__all__ = ["AuditRow", "CellPlace", "Grade", "audit"]


def audit(paper: Paper) -> tuple[AuditRow, ...]:
    """Return every row that the paper's printed numbers give, tables first, then relations."""
    return tuple(_rows(paper))


def _rows(paper: Paper) -> Iterator[AuditRow]:
    found = blocks(paper)
    yield from rows_of_blocks(paper.key, found)
    for table in tables_alone(paper):
        yield from table.rows
    yield from time_rows(paper)
    yield from arm_rows(paper)
    yield from sentence_rows(paper)
    for relation in paper.relations:
        yield from _relation_rows(paper.key, relation)
    yield from repeat_rows(paper.key, found)


def _relation_rows(paper: str, relation: Relation) -> Iterator[AuditRow]:
    checks: dict[type, Callable[[str, Any], Iterator[AuditRow]]] = {
        Sum: sum_rows,
        Less: difference_rows,
        Mean: mean_rows,
        Equal: equal_rows,
        Times: ratio_rows,
        ByFormula: formula_rows,
        PercentLower: percentage_rows,
        AverageRank: rank_rows,
        PValues: p_value_rows,
        EqualSpacing: spacing_rows,
        InRange: range_rows,
        SameNumbers: same_rows,
        PrintedPoses: pose_rows,
    }
    return checks[type(relation)](paper, relation)
