import json
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from repro.__main__ import main
from repro.commands.catalogue import all_papers
from repro.model.paper import Paper
from repro.runs.store.file import SCHEMA
from repro.runs.store.store import Store
from tests.house import PAPERS
from tests.small_papers import PAPER, Failing, Guessing, let_be_known, searching

KEYS = tuple(PAPERS)

AUDIT = {"paper", "table", "row", "column", "cells", "check", "grade", "explanation", "condition"}
CERTIFICATE = {
    *("paper", "problem", "minimum", "lower_bound", "attained", "method", "at", "binding"),
    *("printed", "explanation"),
}

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Return what runs a command in an empty folder and returns exit code, output and errors."""
    monkeypatch.chdir(tmp_path)

    def command(*arguments: str) -> tuple[int, str, str]:
        code = main(arguments)
        return (code, *capsys.readouterr())

    return command


def declared(monkeypatch: pytest.MonkeyPatch, paper: Paper) -> None:
    """Let the command line know one paper alone."""
    let_be_known(monkeypatch, paper)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    declared(monkeypatch, PAPER)


@pytest.mark.parametrize("command", ["reproduce", "report", "list", "audit", "certify"])
def test_unknown_paper_is_named_with_the_known_ones(run: Run, command: str) -> None:
    code, out, err = run(command, KEYS[0], "nobody1900")

    assert (code, out) == (2, "")
    known = f"repro: unknown paper 'nobody1900'; known: {', '.join(KEYS)} (looked for in "
    assert err.startswith(known)
    assert err.count("\n") == 1
    assert list(Path().iterdir()) == []


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize(
    ("arguments", "fault"),
    [
        (("reproduce", "--repeats", "0"), "repeats is 0; it must be 1 or more"),
        (("report", "--repeats", "-1"), "repeats is -1; it must be 1 or more"),
        (("list", "--repeats", "0"), "repeats is 0; it must be 1 or more"),
        (("reproduce", "--workers", "0"), "workers is 0; it must be 1 or more"),
        (("reproduce", "--store", "file"), "the store folder file cannot be used: File exists"),
        (("reproduce", "--store", "file/in"), "file/in cannot be used: Not a directory"),
        (("report", "--store", "file"), "the store folder file cannot be used: it is a file"),
        (("list", "--store", "file"), "the store folder file cannot be used: it is a file"),
        (("reproduce", "--reports", "file"), "the reports folder file cannot be used: File exists"),
        (("report",), "there is no store in .repro; `repro reproduce` makes one"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(
    run: Run, arguments: tuple[str, ...], fault: str
) -> None:
    Path("file").write_text("in the way")

    code, out, err = run(*arguments)

    assert (code, out) == (2, "")
    assert err.startswith("repro: ")
    assert err.endswith(f"{fault}\n")
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [(), ("undo",), ("reproduce", "--repeats", "few"), ("list", "--workers", "2"), ("audit", "-x")],
)
def test_bad_usage_is_explained_with_exit_code_2(run: Run, arguments: tuple[str, ...]) -> None:
    with pytest.raises(SystemExit) as end:
        run(*arguments)

    assert end.value.code == 2


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("command", ["reproduce", "report", "list"])
def test_newer_store_is_refused_with_exit_code_3(run: Run, command: str) -> None:
    run("reproduce", "--repeats", "1")
    with closing(sqlite3.connect(".repro/runs.sqlite")) as database:
        database.execute(f"pragma user_version = {SCHEMA + 1}")

    code, out, err = run(command, "--repeats", "1")

    assert (code, out) == (3, "")
    assert err == "repro: .repro/runs.sqlite has schema 3, newer than 2: update repro\n"


@pytest.mark.usefixtures("small")
def test_reproduce_runs_what_is_missing_and_writes_pages(run: Run) -> None:
    first = run("reproduce", "--repeats", "1")
    again = run("reproduce", "--repeats", "1")
    more = run("reproduce", "--repeats", "2", "--workers", "1")

    assert first[0] == again[0] == more[0] == 0
    assert first[1] == again[1]
    pages, headings, verdicts, compared = more[1].splitlines()
    assert pages == "pages: reports/index.html"
    assert headings.split()[:3] == ["paper", "reproduced", "consistent"]
    assert verdicts.split()[0] == "small2020"
    assert verdicts.split()[-1] == "2"
    assert compared == (
        "small2020 has no list of expected verdicts to compare with (small2020.verdicts.csv beside "
        "its module, which is optional)"
    )
    assert "6/6 runs (100 %)" in first[2]
    assert again[2] == ""
    assert "6/6 runs (100 %)" in more[2]
    assert Path("reports/small2020.html").exists()


@pytest.mark.usefixtures("small")
def test_report_writes_the_pages_that_reproduce_wrote(run: Run) -> None:
    run("reproduce", "--repeats", "2", "--reports", "one")

    code, out, _ = run("report", "--repeats", "2", "--reports", "two")

    assert (code, out) == (0, "pages: two/index.html\n")
    for page in Path("one").rglob("*.*"):
        assert (Path("two") / page.relative_to("one")).read_bytes() == page.read_bytes()


@pytest.mark.usefixtures("small")
def test_report_refuses_a_file_as_reports_folder(run: Run) -> None:
    with Store(Path(".repro")):
        pass
    Path("file").write_text("", encoding="utf-8")

    code, _, err = run("report", "--reports", "file")

    assert code == 2
    assert err == "repro: the reports folder file cannot be used: File exists\n"


@pytest.mark.usefixtures("small")
def test_report_without_runs_says_so_of_every_number(run: Run) -> None:
    with Store(Path(".repro")):
        pass

    assert run("report")[0] == 0

    (paper,) = json.loads(Path("reports/results.json").read_text(encoding="utf-8"))["papers"]
    assert [finding["verdict"] for finding in paper["findings"]] == ["not run"] * 4


def test_failed_runs_are_named_with_exit_code_1_and_others_are_kept(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    declared(monkeypatch, searching(good=Guessing(), bad=Failing()))

    code, _, err = run("reproduce", "--repeats", "1")

    assert code == 1
    assert "repro: run small2020/search/bowl/bad/1/2 failed: ValueError: lost the way (" in err
    assert "good" not in err
    (row,) = json.loads(run("list", "--repeats", "1", "--json")[1])
    assert (row["done"], row["missing"]) == (3, 3)


def test_list_as_json_says_what_is_done_and_missing(run: Run) -> None:
    rows = json.loads(run("list", "--json", "--repeats", "2")[1])

    assert [row["key"] for row in rows] == list(KEYS)
    for row in rows:
        paper = all_papers()[row["key"]]
        assert row["title"] == paper.source.title
        assert row["tables"] == [table.label for table in (*paper.inputs, *paper.results)]
        assert [part["name"] for part in row["experiments"]] == [e.name for e in paper.experiments]
        assert row["done"] == 0
        parts = (*row["experiments"], *row["studies"])
        assert row["missing"] == sum(part["missing"] for part in parts) > 0
    assert list(Path().iterdir()) == []


def test_list_as_text_names_every_paper_and_experiment(run: Run) -> None:
    code, out, err = run("list")

    assert (code, err) == (0, "")
    for paper in all_papers().values():
        assert f"{paper.key}: {paper.source.title}\n" in out
        assert all(f"  {experiment.name}: " in out for experiment in paper.experiments)


@pytest.mark.parametrize(("command", "keys"), [("audit", AUDIT), ("certify", CERTIFICATE)])
def test_json_is_a_list_of_rows_with_the_keys_of_the_contract(
    run: Run, command: str, keys: set[str]
) -> None:
    code, out, err = run(command, "--json")
    rows = json.loads(out)

    assert (code, err) == (0, "")
    assert rows
    assert {row["paper"] for row in rows} <= set(KEYS)
    assert all(row.keys() >= keys - {"cells"} for row in rows)


def test_row_of_the_audit_concerns_one_cell_or_lists_several(run: Run) -> None:
    for row in json.loads(run("audit", "--json")[1]):
        assert (row["row"] is None) == (row["column"] is None)
        assert not (row["column"] and row["cells"])


@pytest.mark.parametrize("command", ["audit", "certify"])
def test_text_has_a_line_for_every_row_of_the_json(run: Run, command: str) -> None:
    rows = json.loads(run(command, KEYS[0], "--json")[1])

    code, out, _ = run(command, KEYS[0])

    assert code == 0
    assert len(out.splitlines()) == len(rows)
    assert all(KEYS[0] in line for line in out.splitlines())


def test_text_of_the_audit_says_under_which_condition_a_row_holds(run: Run) -> None:
    rows = json.loads(run("audit", "syji", "--json")[1])
    lines = run("audit", "syji")[1].splitlines()

    assert {bool(row["condition"]) for row in rows} == {True, False}
    for row, line in zip(rows, lines, strict=True):
        assert line.endswith(f"; holds if {row['condition']}") or not row["condition"]
        assert ("holds if" in line) is bool(row["condition"])


def test_grades_of_the_audit_are_the_contract(run: Run) -> None:
    rows = json.loads(run("audit", "--json")[1])

    assert {row["grade"] for row in rows} <= {"impossible", "inconsistent", "noted"}


def test_interrupt_says_that_the_same_call_goes_on(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupt() -> Any:  # noqa: ANN401
        raise KeyboardInterrupt

    monkeypatch.setattr("repro.commands.catalogue.known", interrupt)

    code, out, err = run("list")

    assert (code, out) == (130, "")
    assert "the same call goes on" in err
