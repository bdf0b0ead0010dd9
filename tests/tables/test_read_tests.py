from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text

PAIRS = """Table 3. Rank-sum test at the {level} level

| Function | WOA vs PSO p | h | WOA vs GWO p | h |
|---|---|---|---|---|
| F1 | {first} | 0 | 0.5 | 0 |
| F2 | 0.2 | 0 | 0.001 | 1 |
"""
LINES = '"{caption}"\nIndex,F1,F2\np-value,{first},0.2\nh,0,0\n'
MARKED = "Function,p-value\nF1,{first}=\nF2,0.001+\n"
EFFECTS = "Function,p-value,z,r\nF1,{first},-2.27,{r}\n"


def audited(text: str, options: AuditOptions | None = None, **told: str) -> AuditedTable:
    (table,) = audit_text(text.format(**told), options or AuditOptions())
    return table


def checks(table: AuditedTable) -> list[str]:
    return [row.check for row in table.rows]


def test_each_p_of_a_line_has_its_own_decision() -> None:
    wrong = audited(PAIRS, level="5 %", first="0.0230")

    assert checks(audited(PAIRS, level="5 %", first="0.0530")) == []
    assert checks(wrong) == ["p-decision"]
    assert wrong.rows[0].cells[0]["row"] == "F1"
    assert wrong.checked == 8


def test_pairs_of_p_and_h_that_nothing_names_apart_are_read_in_order() -> None:
    text = "Function,p,h,p,h\nF1,0.3,0,{second},1\n"

    assert checks(audited(text, second="0.001")) == []
    assert checks(audited(text, second="0.3")) == ["p-decision"]


def test_a_decision_is_held_against_the_level_of_the_caption() -> None:
    assert checks(audited(PAIRS, level="1 %", first="0.0230")) == []
    assert checks(audited(PAIRS, AuditOptions(alpha=0.05), level="1 %", first="0.0230")) == [
        "p-decision"
    ]


def test_a_caption_of_several_levels_decides_nothing() -> None:
    table = audited(PAIRS, level="1 % level and the 5 %", first="0.0230")

    assert checks(table) == []
    assert "the caption tells several levels of tests" in [g.says for g in table.guesses]


def test_lines_of_p_and_h_are_read_like_columns() -> None:
    (row,) = audited(LINES, caption="one-sided test, level 0.05", first="0.022972544").rows

    assert row.explanation.startswith("printed is one-sided p = 0.022972544, which is below")
    assert checks(audited(LINES, caption="level 0.05", first="0.06")) == []


def test_a_mark_at_p_is_a_decision() -> None:
    assert checks(audited(MARKED, first="0.3")) == []
    assert checks(audited(MARKED, first="0.02")) == ["p-decision"]


def test_p_is_held_against_z_and_the_effect_size() -> None:
    ten = AuditOptions(runs=10)

    assert checks(audited(EFFECTS, ten, first="0.0232", r="-0.72")) == []
    assert checks(audited(EFFECTS, ten, first="0.3", r="-0.72")) == ["p-z"]
    assert checks(audited(EFFECTS, ten, first="0.0232", r="-0.11")) == ["effect-size"]
