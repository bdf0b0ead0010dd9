from repro.audit import AuditRow, Grade
from repro.report.views.findings import marks_by_cell


def test_an_audit_row_on_several_cells_marks_each() -> None:
    row = AuditRow(
        paper="doe2021", table="Table 2", row=None, column=None,
        cells=({"row": "F1 Best", "column": "WOA"}, {"row": "F1 Mean", "column": "WOA"}),
        check="repeats", grade=Grade.NOTED, explanation="",
    )  # fmt: skip
    marks = marks_by_cell([row])
    assert marks["Table 2", "F1 Best", "WOA"] == [row]
    assert marks["Table 2", "F1 Mean", "WOA"] == [row]
