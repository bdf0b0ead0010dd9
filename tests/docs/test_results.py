import csv
import json
import re
import sqlite3
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import pytest

from repro.report.plain_rows import STANDING, TEST
from repro.runs.store.file import TABLES
from tests.made_up import pages_of

PAGE = (Path(__file__).parents[2] / "docs" / "results.md").read_text(encoding="utf-8")
NAMES = re.compile(r"`([^`]+)`")
Rows = Iterable[Mapping[str, Any]]


def lines(section: str) -> list[list[str]]:
    """Return the cells of the tables of a section, line by line."""
    text = re.split(rf"^## {section}$", PAGE, flags=re.MULTILINE)[1].split("\n## ")[0]
    return [line.strip("|").split("|") for line in text.splitlines() if line.startswith("|")]


def described(section: str) -> set[str]:
    """Return the names in the first column of the tables of a section."""
    return {name for first, *_ in lines(section) for name in NAMES.findall(first)}


def written(rows: Rows) -> set[str]:
    return {name for row in rows for name in row}


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    return pages_of(tmp_path_factory.mktemp("doe"))


@pytest.fixture(scope="module")
def results(files: dict[str, str]) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(files["results.json"])
    return found


def test_every_field_at_the_top_and_of_a_paper_is_described(results: dict[str, Any]) -> None:
    (paper,) = results["papers"]
    assert described("results.json") == set(results)
    assert described("A paper") == set(paper)


@pytest.mark.parametrize(
    ("section", "field"),
    [
        ("A finding", "findings"),
        ("An audit row", "audit"),
        ("A certificate", "certificates"),
    ],
)
def test_every_field_of_the_rows_is_described(
    results: dict[str, Any], section: str, field: str
) -> None:
    (paper,) = results["papers"]
    assert described(section) == written(paper[field])


def test_every_field_of_a_test_and_of_a_standing_is_described() -> None:
    tests = {name for *_, last in lines("Tests") for name in NAMES.findall(last)}
    assert tests | described("Tests") == set(TEST)
    assert described("Standings") == set(STANDING)


def test_every_field_of_what_is_left_open_is_described(results: dict[str, Any]) -> None:
    (paper,) = results["papers"]
    rows = [row for kind in ("assumptions", "errata", "gaps") for row in paper[kind]]
    assert described("Assumptions, errata, gaps") == written(rows)


def test_the_fields_of_a_reading_and_of_an_alternative_are_described(
    results: dict[str, Any],
) -> None:
    (paper,) = results["papers"]
    readings = [each for finding in paper["findings"] for each in finding["readings"]]
    others = [each for one in paper["assumptions"] for each in one["alternatives"]]
    assert f"`{{{', '.join(readings[0])}}}`" in PAGE
    assert f"`{{{', '.join(others[0])}}}`" in PAGE


def test_every_column_of_the_findings_in_csv_is_described(files: dict[str, str]) -> None:
    (name,) = (name for name in files if name.endswith("-claims.csv"))
    assert described("The tables in CSV") == set(next(csv.reader(files[name].splitlines())))


def test_every_column_of_the_store_is_described() -> None:
    database = sqlite3.connect(":memory:")
    database.executescript(TABLES)
    tables = [name for (name,) in database.execute("select name from sqlite_master where sql > ''")]
    columns = {
        (table, row[1])
        for table in tables
        for row in database.execute(f"pragma table_info({table})")
    }
    told = {
        (table, name)
        for cells in lines("The store")
        for table in NAMES.findall(cells[0])
        for name in NAMES.findall(cells[1])
    }
    assert told == columns
    database.close()
