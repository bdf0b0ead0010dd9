import re
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest

import repro
from repro.report.frames import FINDINGS
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import RECORDS, with_pages

PAGE = (Path(__file__).parents[2] / "docs" / "data.md").read_text(encoding="utf-8")
NAMES = re.compile(r"`([^`]+)`")


def described(section: str) -> list[str]:
    """Return the names in the first column of the tables of a section."""
    text = PAGE.split(f"\n## {section}\n")[1].split("\n## ")[0]
    rows = [line.strip("|").split("|")[0] for line in text.splitlines() if line.startswith("|")]
    return [name for first in rows for name in NAMES.findall(first)]


@pytest.fixture(scope="module", autouse=True)
def known() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, PAPER)
        yield


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a store and the reports of it."""
    return with_pages(tmp_path_factory.mktemp("data"), ".repro")


@pytest.mark.parametrize("name", ["reports", ".repro"])
def test_columns_of_runs_and_findings_are_those_of_the_manual(place: Path, name: str) -> None:
    results = repro.load(place / name)

    assert list(results.runs(PAPER.key)) == described("runs(KEY)")
    assert list(results.findings) == described("findings") == list(FINDINGS)


def test_calls_that_draw_and_formats_are_those_of_the_manual(place: Path) -> None:
    calls = [call.split("(")[0] for call in described("Figures")]
    plot = repro.load(place / "reports").plot

    assert sorted(calls) == sorted(n for n in dir(plot) if n[0] != "_" and n != "results")


def test_the_lines_that_read_the_store_give_a_curve(
    place: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(place)
    block = PAGE.split("These lines read a curve from it:\n\n")[1].split("\n\n")[0]
    lines = "\n".join(line.removeprefix("    ") for line in block.splitlines())

    namespace: dict[str, object] = {}
    exec(lines, namespace)  # noqa: S102 (the manual's own lines)

    assert isinstance(namespace["store"], sqlite3.Connection)
    namespace["store"].close()
    assert capsys.readouterr().out.startswith(f"{RECORDS[0].task.algorithm} [")
    packed = namespace["y"]
    assert isinstance(packed, bytes)
