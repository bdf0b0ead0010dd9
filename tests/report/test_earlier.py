"""Nothing that an earlier call said, or somebody else wrote, vanishes without a word."""

import json
import os
import tempfile
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from repro.__main__ import main
from repro.errors import InputError
from repro.report.earlier import check_folder, keep_earlier, unreadable
from tests.budgets import examples
from tests.small_papers import PAPER, let_be_known

OTHER = replace(PAPER, key="other2021")
CONFLICT = '{\n "schema": 2,\n<<<<<<< HEAD\n "findings": 1,\n=======\n'
FILES = ("results.json", "provenance.json")
QUICK = ("--repeats", "1", "--protocol-only")


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Go to a folder with the pages of two papers."""
    monkeypatch.chdir(tmp_path)
    let_be_known(monkeypatch, PAPER, OTHER)
    assert main(["reproduce", *QUICK]) == 0
    return tmp_path


def everything(folder: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def keys(folder: Path) -> list[str]:
    content = json.loads((folder / "reports" / "results.json").read_text(encoding="utf-8"))
    return [paper["key"] for paper in content["papers"]]


def test_one_paper_reproduced_keeps_what_is_said_of_the_other(here: Path) -> None:
    assert main(["reproduce", "small2020", *QUICK]) == 0

    assert keys(here) == ["small2020", "other2021"]


@pytest.mark.parametrize("command", ["reproduce", "report"])
@pytest.mark.parametrize("name", FILES)
def test_one_paper_is_refused_where_the_other_would_vanish(
    here: Path, name: str, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (here / "reports" / name).write_text(CONFLICT, encoding="utf-8")
    before = everything(here / "reports")
    capsys.readouterr()

    assert main([command, "small2020", *QUICK]) == 2

    error = capsys.readouterr().err
    assert f"{name} cannot be read (line 3: " in error
    assert "what it says of other2021 would be lost" in error
    assert error.count("\n") == 1
    assert everything(here / "reports") == before


@pytest.mark.parametrize("name", FILES)
def test_all_papers_set_what_cannot_be_read_aside_and_say_so(
    here: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (here / "reports" / name).write_text(CONFLICT, encoding="utf-8")
    capsys.readouterr()

    assert main(["reproduce", *QUICK]) == 0

    (line,) = (line for line in capsys.readouterr().err.splitlines() if "set aside" in line)
    kept = Path(line.rpartition("set aside as ")[2])
    assert kept.read_text(encoding="utf-8") == CONFLICT
    assert keys(here) == ["small2020", "other2021"]


def test_a_comparison_of_seeds_that_cannot_be_read_is_named_and_kept(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = here / "reports" / "another-seed.json"
    path.write_text("{", encoding="utf-8")

    assert main(["reproduce", *QUICK]) == 0

    assert "another-seed.json cannot be read (line 1: " in capsys.readouterr().err
    assert path.read_text(encoding="utf-8") == "{"


@pytest.mark.parametrize("name", ["index.html", "index.md", "small2020.html", "provenance.json"])
def test_a_folder_with_somebody_elses_pages_is_refused_before_any_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    let_be_known(monkeypatch, PAPER)
    (tmp_path / name).write_text("theirs")
    (tmp_path / "results.json").write_text('{"mine": 1}')

    for folder in (".", ""):
        assert main(["reproduce", *QUICK, "--reports", folder]) == 2

    assert f"{name} is not of repro" in capsys.readouterr().err
    assert everything(tmp_path) == {
        str(tmp_path / name): b"theirs",
        str(tmp_path / "results.json"): b'{"mine": 1}',
    }


def test_a_folder_in_the_place_of_a_page_is_refused_before_any_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    let_be_known(monkeypatch, PAPER)
    (tmp_path / "reports" / "small2020.html").mkdir(parents=True)

    assert main(["reproduce", *QUICK]) == 2

    assert "small2020.html is a folder, and a file of this name is to be" in capsys.readouterr().err
    assert not (tmp_path / ".repro").exists()


def test_a_folder_of_ones_own_keeps_every_other_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    let_be_known(monkeypatch, PAPER)
    theirs = ("lock", "pages", "README.md", "made-of.json", "results.txt")
    for name in theirs:
        (tmp_path / name).write_text("theirs")

    assert main(["reproduce", *QUICK, "--reports", ".", "--store", ""]) == 0

    for name in theirs:
        kept = tmp_path / name.replace("made-of", "made-of-set-aside-1")
        assert kept.read_text() == "theirs"


def test_a_list_that_cannot_be_read_is_said_before_any_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    let_be_known(monkeypatch, PAPER)
    listed = tmp_path / "small2020.verdicts.csv"
    listed.write_bytes(b"\xff")
    monkeypatch.setattr("repro.commands.catalogue.expected_file", lambda *_: listed)

    assert main(["reproduce", *QUICK]) == 2

    assert "small2020.verdicts.csv cannot be read" in capsys.readouterr().err
    assert not (tmp_path / ".repro").exists()


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_results_that_may_not_be_read_are_named(here: Path) -> None:
    (here / "reports" / "results.json").chmod(0)

    with pytest.raises(InputError, match="Permission denied"):
        check_folder(here / "reports", ["small2020"], ["small2020", "other2021"])


JSON = st.recursive(
    st.none() | st.booleans() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner),
)


@settings(max_examples=examples(20))
@given(content=st.binary(max_size=60) | JSON.map(lambda value: json.dumps(value).encode()))
def test_whatever_stands_there_is_refused_or_set_aside_whole(content: bytes) -> None:
    with tempfile.TemporaryDirectory() as name:
        _check_whatever_stands_there(Path(name), content)


def _check_whatever_stands_there(folder: Path, content: bytes) -> None:
    (folder / "results.json").write_bytes(content)
    (folder / "verdicts.md").touch()

    with pytest.raises(InputError, match=r"results\.json cannot be read"):
        check_folder(folder, ["a"], ["a", "b"])
    assert (folder / "results.json").read_bytes() == content
    said: list[str] = []
    keep_earlier(folder, ["a", "b"], ["a", "b"], said.append)

    assert len(said) == 1
    assert (folder / "results-set-aside-1.json").read_bytes() == content
    assert list(unreadable(folder)) == []
