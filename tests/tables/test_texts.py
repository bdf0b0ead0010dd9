"""Every form that a table comes in gives the same blocks."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from repro.errors import InputError
from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text, audited
from repro.tables.gathered import gathered
from repro.tables.grids import grid
from repro.tables.headings import runs_in, statistics_in
from repro.tables.numbers import NoNumber, number_form
from repro.tables.texts import Form, form_of, tables_in
from tests.budgets import examples

CSV = "F,Algorithm,Best,Mean,Worst,Std\nF1,WOA,1.0,2.0,3.0,0.5\n,PSO,1.5,2.5,3.5,0.6\n"
FORMS: dict[Form, str] = {
    "separated": CSV,
    "markdown": """
| F | Algorithm | Best | Mean | Worst | Std |
|---|:---------:|------|------|-------|-----|
| F1 | WOA | **1.0** | 2.0 | 3.0 | 0.5 |
|    | PSO | 1.5 | 2.5 | 3.5 | 0.6 |
""",
    "latex": r"""
\\begin{table}\caption{Results} % of 7 runs
\begin{tabular}{ll|rrrr} \toprule
F & Algorithm & Best & Mean & Worst & Std \\ \midrule
\multirow{2}{*}{$F_1$} & WOA & \textbf{1.0} & 2.0 & 3.0 & \num{0.5} \\ \cline{2-6}
 & PSO & 1.5 & $2.5$ & 3.5 & 0.6 \\[2pt] \bottomrule
\end{tabular}\end{table}""",
    "html": """<p>text</p><table><thead><tr><th>F<th>Algorithm<th>Best<th>Mean<th>Worst<th>Std
</thead>
<tr><td rowspan=2>F1</td><td>WOA</td><td><b>1.0</b></td><td>2.0</td><td>3.0</td><td>0.5</td></tr>
<tr><td>PSO</td><td>1.5</td><td>2.5</td><td>3.5</td><td>0.6</td></tr></table><script>9</script>""",
    "pasted": """
F    Algorithm   Best   Mean   Worst  Std
-----------------------------------------
F1   WOA         1.0    2.0    3.0    0.5
     PSO         1.5    2.5    3.5    0.6
""",
}


def only(text: str, form: Form | None = None, **told: object) -> AuditedTable:
    (found,) = audit_text(text, AuditOptions(**told), form=form)  # type: ignore[arg-type]
    return found


@pytest.mark.parametrize("form", FORMS)
def test_every_form_gives_the_same_blocks(form: Form) -> None:
    found = only(FORMS[form], runs=7)

    assert form_of(FORMS[form]) == form
    assert (found.cells, found.blocks, found.skipped) == (8, 2, ())
    assert {row[0] for row in found.places if "PSO" in row[0]} <= {"F1 PSO", "F_1 PSO"}
    assert found.rows == ()


@pytest.mark.parametrize("form", FORMS)
def test_planted_error_is_found_in_every_form(form: Form) -> None:
    found = only(FORMS[form].replace("2.0", "3.7"), runs=7)

    (row,) = found.proofs
    assert row.check == "mean-bound"
    assert found.grid.lines[found.places[row.row or "", row.column or ""][0]].index("3.7") == 3


ALGORITHMS_ABOVE = """
| | | WOA | PSO |
|-|-|-|-|
| F1 | Best | 1.0 | 1.5 |
| | Mean | 2.0 | 2.5 |
| | Worst | 3.0 | 3.5 |
| | Std | 0.5 | 0.6 |
"""
TWO_HEADINGS = """
| | WOA | | PSO | |
|-|-|-|-|-|
| F | Mean | Std | Mean | Std |
| F1 | 2.0 | 0.5 | 2.5 | 0.6 |
| F2 | 2.1 | 0.5 | 2.6 | 0.6 |
"""
PAIRS = """
| F | WOA | PSO |
|-|-|-|
| F1 | 2.0 ± 0.5 | 2.5e+0±6.0e-1 (+) |
| F2 | 2.1 (0.5) | N/A |
"""
GROUPS = """
Algorithm,Best,Mean,Worst
F1,,,
WOA,1.0,2.0,3.0
PSO,1.5,2.5,3.5
F2,,,
WOA,4.0,5.0,6.0
PSO,4.5,5.5,6.5
"""
WITH_STATISTICS_IN_NAMES = "Function,WOA_mean,WOA_std,PSO mean,PSO std\nF1,2.0,0.5,2.5,0.6\n"
REPEATED_HEADINGS = """
| F | Best | Mean |
|-|-|-|
| F1 | 1.0 | 2.0 |
| F | Best | Mean |
| F2 | 1.5 | 2.5 |
"""


@pytest.mark.parametrize(
    ("text", "blocks", "cells"),
    [
        (ALGORITHMS_ABOVE, 2, 8),
        (TWO_HEADINGS, 4, 8),
        (PAIRS, 3, 6),
        (GROUPS, 4, 12),
        (WITH_STATISTICS_IN_NAMES, 2, 4),
        (REPEATED_HEADINGS, 2, 4),
        ("Method WOA PSO\nBest 1.0 1.5\nMean 2.0 2.5\nWorst 3.0 3.5\n", 2, 6),
        ("F;Mittelwert;Schlechtester\nF1;1,5;1.234,5\nF2;2,5;3,5\n", 2, 4),
    ],
)
def test_either_orientation_is_read_in_blocks(text: str, blocks: int, cells: int) -> None:
    found = only(text)

    assert (found.blocks, found.cells) == (blocks, cells)
    assert not found.rows


def test_what_is_no_number_is_counted_with_its_place_and_reason() -> None:
    found = only(PAIRS.replace("2.1 (0.5)", "<0.001").replace("2.0 ± 0.5", "2.51×10111"))

    assert [(each.text, each.because.split(":")[0]) for each in found.skipped] == [
        ("2.51×10111", "the exponent's sign was lost in copying"),
        ("<0.001", "it is a bound (<), not a value"),
        ("N/A", "no value is printed"),
    ]
    assert found.skipped[2].where.endswith("F2, PSO")


def test_several_tables_of_one_text_are_apart() -> None:
    found = audit_text(f"Table 1: first\n{PAIRS}\nTable 2: 30 runs\n{TWO_HEADINGS}", AuditOptions())

    assert [table.blocks for table in found] == [3, 4]
    assert found[1].runs == 30


def test_text_of_a_script_is_no_table() -> None:
    assert tables_in("<script>let a = '<table><tr><td>1'</script>", "html") == []


def test_half_a_file_is_read_as_far_as_it_goes() -> None:
    for form, text in FORMS.items():
        found = audit_text(text[: len(text) * 2 // 3], AuditOptions(runs=7), form=form)

        assert not any(table.proofs for table in found), form


def test_too_many_cells_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("repro.tables.texts.MOST_CELLS", 600)

    assert tables_in("1,2\n" * 300, "separated")
    with pytest.raises(InputError, match="cells; at most"):
        tables_in("1,2\n" * 301, "separated")


@settings(max_examples=examples(20), deadline=None)
@given(st.text(alphabet="|&\\<>tdr{}a1.5e-,;\t\n \"'±()", max_size=200), st.sampled_from([*FORMS]))
def test_no_text_stops_the_reader(text: str, form: Form) -> None:
    for table in audit_text(text, AuditOptions(), form=form):
        assert table.cells > 0


def test_formula_is_text() -> None:
    (table,) = audited(
        [grid("", [["F", "Mean"], ["F1", "=1+2"], ["F2", "2.5"]])], AuditOptions(), file="-"
    )

    assert [(each.text, table.cells) for each in table.skipped] == [("=1+2", 1)]


@pytest.mark.parametrize(
    ("heading", "statistics"),
    [
        ("mean_rank", ("average rank",)),
        ("std_of_mean", ("sem",)),
        ("success_rate", ("success rate",)),
        ("std_dev", ("std",)),
        ("# wins", ("wins",)),
        ("No. of losses", ("losses",)),
        ("Mean loss", ("mean",)),
    ],
)
def test_headings_with_underscores_and_counts_are_known(
    heading: str, statistics: tuple[str, ...]
) -> None:
    assert statistics_in(heading)[0] == statistics


@pytest.mark.parametrize(
    "text",
    [
        "<table><tr><th>F<th>Mean<tr><td>F1<td>1,2×10<sup>−3</sup><tr><td>F2<td>2,5 ± 0,5</table>",
        r"F & Mean \\ F1 & $1,2\times10^{-3}$ \\ F2 & 2,5 (0,5) \\",
        "| F | Mean |\n|---|---|\n| F1 | 1,2e-3 |\n| F2 | 2,5 ± 0,5 |\n",
    ],
)
def test_decimal_commas_are_read_in_every_form_of_a_table(text: str) -> None:
    (grid,) = tables_in(text)
    read = gathered(grid, "")

    assert [entry.number.printed.value for entry in read.entries] == [0.0012, 2.5, 0.5]
    assert read.notes == ("decimal commas, as in 1,2, are read as points",)


@pytest.mark.parametrize("other", ["1.5", "2,345,678"])
def test_commas_that_part_groups_stay(other: str) -> None:
    (grid,) = tables_in(f"| F | Mean |\n|---|---|\n| F1 | 1,234 |\n| F2 | {other} |\n")

    assert gathered(grid, "").entries[0].number.printed.value == 1234


@pytest.mark.parametrize(
    ("text", "n"),
    [
        ("aus 30 unabhängigen Läufen", 30),
        ("sur 25 exécutions", 25),
        ("50 ejecuciones", 50),
        ("Ejecuciones independientes: 50", 50),
    ],
)
def test_numbers_of_runs_are_told_in_other_languages(text: str, n: int) -> None:
    assert [told for told, _ in runs_in(text)] == [n]


def test_a_sign_that_was_lost_in_copying_is_said() -> None:
    form = number_form("6.59E(cid:4)28")

    assert form == NoNumber("a sign was lost in copying, most likely a minus")


@pytest.mark.parametrize(
    "headings",
    [
        "関数,最良値,平均値,最悪値,標準偏差",
        "함수,최적값,평균,최악값,표준편차",
        "Fonksiyon,En iyi,Ortalama,En kötü,Standart sapma",
        "Funkcja,Najlepszy,Średnia,Najgorszy,Odchylenie standardowe",
        "Funzione,Migliore,Media,Peggiore,Dev. std",
        "Functie,Beste,Gemiddelde,Slechtste,Standaardafwijking",
    ],
)
def test_headings_of_more_languages_name_the_same_statistics(headings: str) -> None:
    (table,) = audit_text(f"{headings}\nF1,1.5,9.5,3.5,0.5\n", AuditOptions(runs=30))

    assert (table.blocks, table.checked) == (1, 4)
    assert [row.check for row in table.proofs] == ["mean-bound"]


def test_a_title_with_commas_above_separated_lines_is_the_caption() -> None:
    text = "Error values, 51 runs\nF,GWO mean,GWO std\nF1,1.2E+02,9.9E+04\n"
    (table,) = audit_text(text, AuditOptions(), form="separated")

    assert (table.label, table.runs) == ("Error values, 51 runs", 51)
    assert [row.condition for row in table.rows] == ["no value is below 0"]


def test_a_short_line_of_headings_is_no_title() -> None:
    text = "Test function,GWO\n,Best,Mean,Worst\nF1,1.5,9.5,3.5\n"
    (table,) = audit_text(text, AuditOptions(runs=30), form="separated")

    assert [row.check for row in table.proofs] == ["mean-bound"]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (",".join(["1.5"] * 6000) + "\n" + ",".join(["1.5"] * 6000), "6000 columns; at most 5000"),
        ("<table><tr>" + "<td>1.5" * 500_001, "500001 cells or lines; at most"),
        ('F,Best\nF1,"' + "1,2\n" * 500_001, "500002 cells or lines; at most"),
    ],
)
def test_what_no_printed_table_holds_is_refused_before_it_is_read(text: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        audit_text(text, AuditOptions())


@pytest.mark.parametrize(
    "text",
    [
        "a" * 3_000_000,
        "1" * 3_000_000,
        f"| a | {'*' * 100_000} |\n|---|---|\n| b | {'*_' * 9**5} |",
    ],
)
def test_a_text_without_end_takes_no_time_that_grows_with_its_square(text: str) -> None:
    assert audit_text(text, AuditOptions()) == []
