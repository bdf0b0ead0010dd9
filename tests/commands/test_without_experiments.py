"""What commands say of a paper that runs nothing."""

import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.model.assumptions import Alternative, Assumption
from repro.model.cells import every_cell
from repro.model.open_points import Gap
from repro.model.paper import Paper, Source
from repro.model.table_alone import TableAlone
from repro.model.tolerances import Percent
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER, TABLE, let_be_known
from tests.unlinked import unlinked

BARE = PublishedTable.read("Table 1, p. 3 (3 runs)\nproblem || mean\nF1 || 1.5\nF2 || 2.5")
ALONE = Paper(
    key="alone2020",
    source=Source(authors="A. Nobody", title="A table"),
    summary="Two means.",
    audited=(TableAlone(table=BARE),),
)
EMPTY = replace(ALONE, key="empty2020", audited=())
GAP = Gap(what="its walk", where="p. 3", because="its steps are not printed")


@pytest.fixture(autouse=True)
def folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    left = every_cell(
        TABLE, of=EXPERIMENT, rows=("problem", "statistic"), columns="algorithm",
        within=Percent(25), without={("bowl std", "wide"): GAP},
    )  # fmt: skip
    partly = replace(PAPER, key="partly2020", claims=left, gaps=(GAP,))
    let_be_known(monkeypatch, ALONE, EMPTY, partly)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    yield
    sys.modules.pop("mine", None)


def told(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, list[str], list[str]]:
    code = main(list(arguments))
    said = capsys.readouterr()
    return code, said.out.splitlines(), said.err.splitlines()


def test_list_says_that_nothing_is_to_be_run(capsys: pytest.CaptureFixture[str]) -> None:
    code, lines, _ = told(capsys, "list", "alone2020", "empty2020")

    assert code == 0
    assert lines == [
        *("alone2020: A table", "  tables: Table 1; claims: 0"),
        "  no experiments: nothing to run",
        *("empty2020: A table", "  tables: none; claims: 0"),
        "  no experiments: nothing to run",
    ]


def test_one_study_is_no_studies(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    slower = Alternative(says="slower", name="slow", protocol={"search": {"iterations": 9}})
    assumption = Assumption(
        what="speed", chosen="fast", alternatives=(slower,), because="it is", where="p. 3"
    )
    let_be_known(monkeypatch, replace(PAPER, assumptions=(assumption,)))

    _, lines, _ = told(capsys, "list", "small2020")

    (line,) = [line for line in lines if "besides" in line]
    count, noun = line.split()[:2]
    assert noun == ("study" if count == "1" else "studies")


def test_audit_counts_tables_and_numbers_in_words_that_fit(
    capsys: pytest.CaptureFixture[str],
) -> None:
    _, lines, _ = told(capsys, "audit", "alone2020", "empty2020")

    assert lines[0] == "alone2020: nothing found; 1 table of 2 numbers is declared"
    assert lines[1].startswith("alone2020, Table 1: checked 2 of 2 numbers in 2 blocks")
    assert lines[-1] == "empty2020: nothing found; 0 tables of 0 numbers are declared"


def test_references_say_that_there_is_no_motion_to_ask_for(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert told(capsys, "references", "alone2020") == (
        0, ["alone2020: no motion in least time, no planner to ask"], [],
    )  # fmt: skip


def test_compare_needs_a_protocol_and_leaves_out_papers_without_one(
    capsys: pytest.CaptureFixture[str],
) -> None:
    Path("mine.py").write_text(
        "def centre(cost, bounds, budget, rng): return bounds.mean(axis=1)\n", encoding="utf-8"
    )
    options = ("--repeats", "1", "--workers", "1", "--reports", "mine")

    none = told(capsys, "compare", "mine:centre", "alone2020", *options)
    some = told(capsys, "compare", "mine:centre", "alone2020", "partly2020", *options)

    assert none == (
        2, [], ["repro: no experiments in alone2020: no protocol to run a search under"],
    )  # fmt: skip
    assert some[0] == 0
    assert "repro: alone2020 has no experiments: it is left out" in some[2]


def test_reproduce_says_that_nothing_was_to_be_run_and_so_do_the_pages(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, lines, _ = told(capsys, "reproduce", "alone2020", "--repeats", "1")

    assert code == 0
    assert lines[-1] == "alone2020 has no experiments: nothing was to be run"
    for suffix in ("md", "html"):
        page = unlinked(Path(f"reports/alone2020.{suffix}").read_text(encoding="utf-8"))
        assert "Nothing was to be run: no experiment is declared." in page
        assert "No result is claimed." in page
        assert "Nothing that the audit found." in page
        assert "No sentence of the text is declared." in page
        assert "0 of 0" not in page
        assert "No run yet" not in page
        assert "alone2020-claims.csv" not in page


def test_again_says_why_there_is_nothing_to_run(capsys: pytest.CaptureFixture[str]) -> None:
    assert told(capsys, "again", "alone2020", "table-1") == (
        2, [], ["repro: alone2020 claims no printed number: there is none to run again"],
    )  # fmt: skip
    assert told(capsys, "again", "partly2020", "table-1-bowl-std-wide") == (
        2, [], ["repro: table-1-bowl-std-wide cannot be run: its steps are not printed"],
    )  # fmt: skip


def test_pages_show_the_tables_that_no_run_stands_behind_and_nothing_that_is_empty(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    wide = "Table 1, p. 3 (3 runs)\nproblem || best | mean | std\nF1 || 1.5 | 1.2 | 0.1"
    alone = TableAlone(table=PublishedTable.read(wide), maximise=False)
    let_be_known(monkeypatch, replace(ALONE, audited=(alone,)))

    assert told(capsys, "reproduce", "alone2020", "--repeats", "1")[0] == 0
    html, markdown = (
        Path(f"reports/alone2020.{suffix}").read_text(encoding="utf-8")
        for suffix in ("tables.html", "md")
    )
    index = Path("reports/index.html").read_text(encoding="utf-8")
    assert '<span>1.2<a class="mark impossible"' in html
    assert re.search(r">0\.1(</span>)?</td>", html)
    assert "| F1 | 1.5 | 1.2<br>⚑ impossible | 0.1 |" in markdown
    for page in (html, index):
        assert '<div class="bar"' not in page
        assert '<ul class="counts">' not in page
    for absent in ('id="tools"', "numbers and claims shown", "<legend>"):
        assert absent not in html


def test_the_index_of_two_calls_names_what_both_papers_are_called(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.undo()  # papers of files, not those that are let be known
    monkeypatch.chdir(tmp_path)
    for key in ("first2020", "second2020"):
        text = (
            "from repro.model import Paper, Source\n"
            f"PAPER = Paper(key={key!r}, source=Source(authors='N', title='T'), summary='S.')\n"
        )
        Path(f"{key}.py").write_text(text, encoding="utf-8")
        assert told(capsys, "reproduce", f"./{key}.py", "--repeats", "1")[0] == 0

    for suffix in ("html", "md"):
        page = Path(f"reports/index.{suffix}").read_text(encoding="utf-8")
        (called,) = re.findall(r"repro reproduce (\S+) (\S+) --repeats 1\b", page)
        assert set(called) == {"./first2020.py", "./second2020.py"}
        assert "nox -s" not in page
