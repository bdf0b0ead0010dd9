import re
from pathlib import Path

from repro.audit import AuditRow, CellPlace, Grade
from repro.report.views.reasons import PLACES, strengths

ROOT = Path(__file__).parents[3]
REASONS = ROOT / "repro" / "report" / "templates" / "sections" / "reasons.jinja"


def row(name: str, *, check: str = "std-bound", condition: str | None = None,
        grade: Grade = Grade.IMPOSSIBLE, cells: int = 0) -> AuditRow:  # fmt: skip
    many = tuple(CellPlace(row=name, column=f"c{k}") for k in range(cells))
    return AuditRow(
        paper="doe2021", table="T", row=None if cells else name, column=None if cells else "WOA",
        cells=many, check=check, grade=grade, explanation=f"because of {name}",
        condition=condition,
    )  # fmt: skip


def test_one_check_is_one_reason_with_every_number_that_it_concerns() -> None:
    (proofs,) = strengths([row("F1"), row("F2"), row("F3")], ())
    (reason,) = proofs.reasons
    ((condition, rows),) = reason.cases

    assert (proofs.name, reason.check, condition) == ("proof", "std-bound", "")
    assert [c.number for c in rows] == [1, 2, 3]
    assert (proofs.rows, reason.rows) == (3, 3)


def test_proofs_come_first_and_what_is_noted_last() -> None:
    audit = [
        row("F1", grade=Grade.NOTED),
        row("F2", grade=Grade.INCONSISTENT),
        row("F3", condition="runs are kept in doubles"),
        row("F4"),
    ]

    found = strengths(audit, ())

    assert [each.name for each in found] == ["proof", "conditional", "inconsistent", "noted"]
    assert [each.rows for each in found] == [1, 1, 1, 1]


def test_the_most_frequent_reason_comes_first_with_its_conditions_apart() -> None:
    audit = [row("F1", check="order"), row("F2", condition="a"), row("F3", condition="b")]

    (_, conditional) = strengths(audit, ())
    (reason,) = conditional.reasons

    assert [(condition, len(rows)) for condition, rows in reason.cases] == [("a", 1), ("b", 1)]


def test_many_numbers_of_one_row_are_counted_and_no_longer_listed() -> None:
    ((few,), (many,)) = (
        [c for _, rows in strengths([each], ())[0].reasons[0].cases for c in rows]
        for each in (row("F1", cells=PLACES), row("F1", cells=PLACES + 1))
    )

    assert few.label == "F1, c0; F1, c1; F1, c2; F1, c3"
    assert many.label == "5 numbers"


def test_every_check_of_the_audit_has_its_sentence() -> None:
    source = [
        p.read_text() for room in ("tables", "audit") for p in (ROOT / "repro" / room).glob("*.py")
    ]
    named = {name for text in source for name in re.findall(r'check="([a-z-]+)"', text)}
    named |= {name for text in source for name in re.findall(r'\("([a-z]+-[a-z]+)", \(', text)}
    named |= {name for text in source for name in re.findall(r'"(arm-[a-z-]+)"', text)}

    said = set(re.findall(r'^  "([a-z-]+)":', REASONS.read_text(), re.MULTILINE))

    assert len(named) > 40
    assert named <= said
