import numpy as np

from repro.audit import AuditRow, Grade
from repro.evidence import Evidence, Runs
from repro.report.view import comparisons, marks_by_cell
from tests.doe2021 import PAPER


def runs(costs: list[float]) -> Runs:
    return Runs(
        costs=np.array([costs]), points=np.ones((1, 4, 3)), histories=np.ones((1, 4, 12)),
        evaluations=72,
    )  # fmt: skip


def test_experiments_without_all_their_runs_are_not_compared() -> None:
    evidence = Evidence(PAPER, {("test", "F1", "WOA"): runs([1.0, 2.0, 3.0, 4.0])})
    assert comparisons(PAPER, evidence) == ()


def test_a_comparison_counts_wins_of_the_proposed_algorithm() -> None:
    evidence = Evidence(
        PAPER,
        {
            ("test", "F1", "WOA"): runs([1.0, 2.0, 3.0, 4.0]),
            ("test", "F1", "PSO"): runs([5.0, 6.0, 7.0, 8.0]),
        },
    )
    (comparison,) = comparisons(PAPER, evidence)
    ((problem, texts),) = comparison.rows
    assert problem == "F1"
    assert texts[0].endswith("wins 1.00")
    assert comparison.budgets == (("WOA", 72), ("PSO", 72))


def test_an_audit_row_on_several_cells_marks_each() -> None:
    row = AuditRow(
        paper="doe2021", table="Table 2", row=None, column=None,
        cells=({"row": "F1 Best", "column": "WOA"}, {"row": "F1 Mean", "column": "WOA"}),
        check="repeats", grade=Grade.NOTED, explanation="",
    )  # fmt: skip
    marks = marks_by_cell([row])
    assert marks["Table 2", "F1 Best", "WOA"] == [row]
    assert marks["Table 2", "F1 Mean", "WOA"] == [row]
