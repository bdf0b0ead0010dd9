import csv
from pathlib import Path
from typing import Any

import pytest

from repro.commands.expected_verdicts import COLUMNS, expected_rows, summary, verdict_rows
from repro.errors import InputError

FINDING = {
    "table": "Table 1", "row": "F1 mean", "column": "WOA", "claim": None, "printed": "0.05",
    "verdict": "reproduced", "side": None, "value": 0.1 + 0.2, "repeats": 10,
    "group": "Table 1, F1 mean, WOA",
}  # fmt: skip
SENTENCE = FINDING | {
    "table": None, "row": None, "column": None, "claim": "it is so", "repeats": 0,
    "group": "it is so",
}  # fmt: skip


def results(*findings: dict[str, Any], repeats: int = 10) -> dict[str, Any]:
    provenance = {"repeats": repeats}
    entry = {"key": "doe2021", "findings": findings, "audit": [], "provenance": provenance}
    return {"papers": [entry]}


@pytest.fixture
def listed(tmp_path: Path) -> Path:
    """Return the list of an invented paper, which expects a number and a sentence."""
    path = tmp_path / "doe2021.verdicts.csv"
    (entry,) = results(FINDING, SENTENCE)["papers"]
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([COLUMNS, *verdict_rows(entry)])
    return path


def last_line(found: dict[str, Any], listed: Path, master_seed: str = "") -> str:
    return summary(found, {"doe2021": listed}, master_seed).splitlines()[-1]


def test_list_is_read_as_it_was_written(listed: Path) -> None:
    (entry,) = results(FINDING, SENTENCE)["papers"]

    assert expected_rows(listed) == verdict_rows(entry)
    assert verdict_rows(entry)[0][7] == "0.30000000000000004"


def test_results_that_are_as_expected_are_said_to_be_so(listed: Path) -> None:
    assert last_line(results(FINDING, SENTENCE), listed) == "2 of 2 as expected"


def test_what_differs_is_named_with_what_is_said_of_it_now(listed: Path) -> None:
    other = FINDING | {"verdict": "contradicted", "side": "lower"}

    line = last_line(results(other, SENTENCE), listed)

    place = "doe2021, Table 1, F1 mean, WOA: contradicted lower"
    assert line == f"1 of 2 as expected; not: {place}"


def test_a_number_that_the_list_lacks_and_one_that_is_gone_are_differences(listed: Path) -> None:
    assert last_line(results(FINDING, SENTENCE, FINDING), listed).startswith(
        "2 of 3 as expected; not: "
    )
    assert last_line(results(FINDING), listed).startswith(
        "1 of 2 as expected; not: doe2021, it is so"
    )


def test_other_values_of_the_first_repeat_are_counted_unless_another_seed_was_asked_for(
    listed: Path,
) -> None:
    other = results(FINDING | {"value": 0.3}, SENTENCE)

    assert "the first repeat gives 1 other values" in last_line(other, listed)
    assert last_line(other, listed, "another") == "2 of 2 as expected"


def test_another_depth_than_that_of_the_list_is_said(listed: Path) -> None:
    line = last_line(results(FINDING, SENTENCE, repeats=2), listed)

    assert line.endswith("; doe2021 is expected of 10 repeats, these are 2")


def test_table_counts_verdicts_and_repeats_by_paper() -> None:
    headings, row, *_ = summary(
        results(FINDING, SENTENCE), {"doe2021": Path("no list")}
    ).splitlines()

    shown = dict(zip(headings.replace("not re", "re").split(), row.split(), strict=False))
    assert shown["paper"] == "doe2021"
    assert (shown["reproduced"], shown["contradicted"]) == ("2", "0")


def test_what_is_impossible_under_a_condition_only_is_not_counted() -> None:
    found = results(FINDING)
    found["papers"][0]["audit"] = [
        {"grade": "impossible", "condition": None},
        {"grade": "impossible", "condition": "it rains"},
        {"grade": "noted", "condition": None},
        {"grade": "impossible"},  # of an older file, which knew no conditions
    ]
    headings, row, *_ = summary(found, {"doe2021": Path("no list")}).splitlines()

    assert headings.split()[-2:] == ["impossible", "repeats"]
    assert row.split()[-2:] == ["2", "10"]


def test_file_that_is_no_list_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "list.csv"
    for text, line in (("", 1), ("a,b\n1,2\n", 1), (f"{','.join(COLUMNS)}\n1,2\n", 2)):
        path.write_text(text)

        with pytest.raises(InputError, match=f"list.csv, line {line}, is no row of verdicts"):
            expected_rows(path)
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(InputError, match=r"list.csv cannot be read"):
        expected_rows(path)
    assert expected_rows(tmp_path / "none.csv") is None
