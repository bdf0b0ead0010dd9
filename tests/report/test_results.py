import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.report.calibration import calibration
from repro.report.results import (
    LINE,
    merged,
    merged_provenance,
    read_results,
    read_results_of_any_age,
    results_text,
)

JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
)


def entry(key: str, runs: int = 1) -> dict[str, object]:
    return {"key": key, "provenance": {"repeats": 2, "runs": runs}}


def test_a_fresh_entry_replaces_the_old_one_and_others_stay_in_the_papers_order() -> None:
    old = merged([entry("a"), entry("b", runs=1)], None, ["a", "b"])
    new = merged([entry("b", runs=5)], old, ["a", "b", "c"])
    assert [paper["key"] for paper in new["papers"]] == ["a", "b"]
    assert new["provenance"] == {"repeats": 2, "runs": 6}


def test_a_number_that_is_none_is_refused() -> None:
    with pytest.raises(ValueError, match="JSON"):
        results_text({"value": float("nan")})


def test_a_file_that_is_no_results_is_taken_as_none(tmp_path: Path) -> None:
    path = tmp_path / "results.json"
    assert read_results(path) is None
    path.write_text("{broken")
    assert read_results(path) is None
    path.write_text('{"schema": 99}')
    assert read_results(path) is None
    assert read_results_of_any_age(path) is None


def test_results_of_the_schema_before_are_compared_and_not_taken_over(tmp_path: Path) -> None:
    path = tmp_path / "results.json"
    path.write_text('{"schema": 1, "papers": []}')

    assert read_results(path) is None
    assert read_results_of_any_age(path) == {"schema": 1, "papers": []}


def test_the_calibration_is_copied_whole() -> None:
    assert merged([], None, [])["calibration"] == calibration()["rows"]


def test_provenance_of_papers_that_are_not_redone_is_kept_and_that_of_gone_ones_is_not() -> None:
    old = {"papers": {"a": {"seconds": 1}, "b": {"seconds": 2}, "gone": {"seconds": 3}}}

    found = merged_provenance({"b": {"seconds": 4}}, old, ["a", "b", "c"])

    assert found == {"papers": {"a": {"seconds": 1}, "b": {"seconds": 4}}}


@given(JSON)
def test_results_read_back_as_they_are_and_only_a_text_makes_a_line_long(content: object) -> None:
    text = results_text({"papers": content})

    assert json.loads(text) == {"papers": content}
    assert text == results_text(json.loads(text))
    long = [line for line in text.splitlines() if len(line) > LINE + 20]
    assert all(line.count('"') >= 2 for line in long)
