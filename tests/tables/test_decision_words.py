import pytest

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text


def audited(*lines: str) -> AuditedTable:
    (table,) = audit_text("\n".join(lines), AuditOptions(runs=30))
    return table


@pytest.mark.parametrize(
    ("heading", "yes", "no"),
    [
        ("h", "TRUE", "FALSE"),
        ("Reject H0", "True", "False"),
        ("Significant?", "yes", "no"),
        ("Decision", "rejected", "not rejected"),
        ("Conclusion", "reject H0", "fail to reject H0"),
        ("H0", "Rejected", "Accepted"),
        ("Accept H0", "No", "Yes"),
        ("Sign", "+", "="),
    ],
)
def test_a_word_that_decides_is_held_against_p(heading: str, yes: str, no: str) -> None:
    true = audited(f"F,p-value,{heading}", f"F1,0.012,{yes}", f"F2,0.4,{no}")
    wrong = audited(f"F,p-value,{heading}", f"F1,0.012,{no}", f"F2,0.4,{yes}")
    lines = audited("Test,F1,F2", "p-value,0.012,0.4", f"{heading},{no},{yes}")

    assert (true.rows, true.checked, true.skipped) == ((), 4, ())
    assert [row.check for row in wrong.rows] == ["p-decision"] * 2
    assert [row.check for row in lines.rows] == ["p-decision"] * 2


@pytest.mark.parametrize(
    ("heading", "texts"),
    [("H0", "True,False"), ("Converged", "yes,no"), ("Sign", "-,-")],
)
def test_a_word_that_does_not_say_what_it_decides_is_skipped_and_counted(
    heading: str, texts: str
) -> None:
    one, other = texts.split(",")
    table = audited(f"F,p-value,{heading}", f"F1,0.012,{one}", f"F2,0.4,{other}")

    assert table.rows == ()
    assert [each.text for each in table.skipped] == [one, other]


def test_words_that_are_read_as_decisions_are_said() -> None:
    table = audited("F,p-value,Significant", "F1,0.012,yes")

    assert any('"Significant" is whether a hypothesis is' in guess.says for guess in table.guesses)
