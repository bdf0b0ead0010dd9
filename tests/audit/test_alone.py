import json
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import pytest

from repro.__main__ import main
from repro.audit import audit
from repro.audit.alone import tables_alone
from repro.commands.audit_settings import NAMES
from repro.errors import DeclarationError
from repro.functions import FUNCTIONS
from repro.model.paper import Paper, Source
from repro.model.table_alone import TableAlone
from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import audit_text
from repro.tables.published import PublishedTable
from repro.tables.rows import AuditRow
from tests.small_papers import PAPER, TABLE, let_be_known
from tests.unlinked import unlinked

PAGE = PublishedTable.read("""
    Table 1, p. 5
    No. | Index || WOA       | Walk
    F1  | Best  || 1.660E-04 | 1.106E+00
        | Mean  || 1.979E-01 | 1.031E+01
        | Worst || 5.123E-01 | 3.429E+01
        | Std   || 2.022E-01 | 9.780E+01
        | Rank  || 2         | 1
""")
FILE = (
    "No.,Index,WOA,Walk\n"
    "F1,Best,1.660E-04,1.106E+00\nF1,Mean,1.979E-01,1.031E+01\nF1,Worst,5.123E-01,3.429E+01\n"
    "F1,Std,2.022E-01,9.780E+01\nF1,Rank,2,1\n"
)


def alone(table: PublishedTable, **told: Any) -> Paper:  # noqa: ANN401 (whatever is told of it)
    return Paper(
        key="page2020",
        source=Source(authors="A. Nobody", title="A page"),
        summary="A table alone.",
        audited=(TableAlone(table=table, **told),),
    )


def said(rows: tuple[AuditRow, ...]) -> list[tuple[str, str, str | None]]:
    return [(row.grade, row.explanation, row.condition) for row in rows]


@pytest.mark.parametrize("runs", [10, None])
def test_a_declared_table_gets_every_row_that_its_file_gets(runs: int | None) -> None:
    (file,) = audit_text(FILE, AuditOptions(runs=runs, maximise=False))
    found = audit(alone(PAGE, runs=runs, maximise=False))

    assert {row.check for row in found} >= {"std-bound", "rank"}
    assert said(found) == said(file.rows)
    assert {(row.paper, row.table) for row in found} == {("page2020", "Table 1")}
    assert ("F1 Std", "Walk") in {(row.row, row.column) for row in found}


def test_what_can_be_told_of_a_table_has_the_names_of_the_options_of_files() -> None:
    assert {each.name for each in fields(TableAlone)} == {"table", *NAMES}


def test_number_of_runs_is_read_where_the_table_says_it_and_told_ones_go_before() -> None:
    table = replace(PAGE, where="Table 1, p. 5 (10 runs)")

    (read,) = tables_alone(alone(table))
    (told,) = tables_alone(alone(table, runs=30))

    assert (read.runs, told.runs) == (10, 30)
    assert (read.cells, read.checked) == (10, 10)


def test_what_is_told_of_a_problem_is_what_its_numbers_are_checked_by() -> None:
    low = replace(PAGE, cells=(PAGE.cells[0], *PAGE.cells[1:4], PAGE.cells[0]))
    free = audit(alone(low, runs=10))

    least = audit(alone(low, runs=10, minimum={"F1": 0.5}))
    function = audit(alone(low, runs=10, function={"F1": FUNCTIONS["schwefel_2_26"].problem(5)}))
    wide = audit(alone(low, runs=10, function={"F1": FUNCTIONS["sphere"].problem(5)}))

    checks = [{row.check for row in rows} for rows in (free, least, function, wide)]
    assert "below-minimum" in checks[1] - checks[0]
    assert checks[2] == checks[3] == checks[0]


def test_more_that_may_be_told_reaches_the_checks() -> None:
    whole = PublishedTable.read("""
        Table 2, p. 5
        Function || Mean  | Std
        F1       || 1.55  | 0.5
    """)

    assert not audit(alone(whole, runs=3))
    assert "impossible" in {row.grade for row in audit(alone(whole, runs=3, integers=True))}


def test_numbers_in_several_units_are_not_taken_for_statistics_of_the_same_runs() -> None:
    times = PublishedTable.read("""
        Table 3, p. 6 (10 runs)
        algorithm || best [s] | mean [ms] | worst [s]
        WOA       || 1.5      | 2000      | 2.5
    """)
    one_unit = replace(times, columns=tuple(replace(c, unit="s") for c in times.columns))

    assert not audit(alone(times))
    (block,) = tables_alone(alone(one_unit))
    assert block.checked == 3


@pytest.mark.parametrize(
    ("told", "says"),
    [
        ({"runs": 0}, "Table 1, runs 0 is no whole number from 1 to 1000000000"),
        ({"ties": "mean"}, "Table 1, ties 'mean' is none of average, min, max, dense, ordinal"),
        ({"alpha": 2}, "Table 1, alpha 2 does not lie between 0 and 1"),
        ({"maximise": 1}, "Table 1, maximise 1 is neither true nor false"),
        ({"minimum": "low"}, "Table 1, minimum of '' is 'low', not a number"),
        (
            {"minimum": {"F2": 0}},
            "Table 1, minimum of 'F2': the table has no such problem; there is 'F1'",
        ),
        ({"function": "sphere"}, "Table 1, function is 'sphere'; give one by problem"),
    ],
)
def test_what_cannot_be_told_is_a_line_with_what_can(told: dict[str, Any], says: str) -> None:
    with pytest.raises(DeclarationError) as error:
        alone(PAGE, **told)

    assert str(error.value) == f"page2020, {says}"


def test_a_function_that_is_none_is_shown_one() -> None:
    with pytest.raises(DeclarationError, match=r"F1' is 'sphere'; give .* FUNCTIONS\['sphere'\]"):
        alone(PAGE, function={"F1": "sphere"})


def test_a_table_is_audited_once_and_by_its_claims_where_it_has_them() -> None:
    with pytest.raises(DeclarationError, match="Table 1: audited alone, and its claims have it"):
        replace(PAPER, audited=(TableAlone(table=TABLE),))
    with pytest.raises(DeclarationError, match="Table 1: audited twice, and once is enough"):
        replace(alone(PAGE), audited=(TableAlone(table=PAGE), TableAlone(table=PAGE, runs=2)))


def test_a_table_without_numbers_is_refused() -> None:
    words = PublishedTable.read("""
        Table 4, p. 6
        algorithm || note [text]
        WOA       || fast
    """)

    with pytest.raises(DeclarationError, match="Table 4: it has no numbers to audit"):
        alone(words)


def test_two_numbers_in_a_cell_of_words_are_read_as_in_a_file() -> None:
    pairs = PublishedTable.read("""
        Table 5, p. 6 (10 runs)
        function || WOA [text]
        F1       || 1.0 ± 0.2
        F2       || 1.0 ± -0.2
    """)

    (found,) = tables_alone(alone(pairs))

    assert (found.cells, found.blocks) == (4, 2)
    assert [(row.row, row.column) for row in found.rows] == [("F2", "WOA")]


def test_what_was_read_and_guessed_is_printed_and_stands_on_the_page(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    let_be_known(monkeypatch, alone(PAGE, runs=10))
    monkeypatch.chdir(tmp_path)

    codes = [main(["audit", "page2020"]), main(["reproduce", "page2020"])]

    out = capsys.readouterr().out
    read = "page2020, Table 1: checked 10 of 10 numbers in 2 blocks; 0 skipped; n = 10 as told"
    assert codes == [0, 0]
    assert "impossible: page2020, Table 1, F1 Std, Walk: 10 runs with best 1.106E+00" in out
    assert f"{read}\n  told: n = 10 as told (runs)\n" in out
    for page in ("page2020.audit.html", "page2020.md"):
        text = unlinked((tmp_path / "reports" / page).read_text(encoding="utf-8"))
        assert read in text
        assert "guess: minimisation (maximise)" in text
        assert "6.53 times the bound" in text
        assert "prints no table" not in text
    results = json.loads((tmp_path / "reports" / "results.json").read_text(encoding="utf-8"))
    assert [row["check"] for row in results["papers"][0]["audit"]] == ["std-bound"]
