"""Every paper's protocol once, at full size, against the committed pages and verdict lists."""

import json
from pathlib import Path
from typing import Any

import pytest

from repro.__main__ import main
from repro.commands.catalogue import all_papers
from repro.runs.plan import plan
from tests.verdict_list import committed_results, expected_rows, verdict_rows

pytestmark = pytest.mark.full_size
KEYS = tuple(all_papers())
OPPOSITE = {("reproduced", "contradicted"), ("contradicted", "reproduced")}


def pages(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


@pytest.fixture(scope="module")
def once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("once")
    places = ["--store", str(folder / "store"), "--reports", str(folder / "reports")]
    assert main(["reproduce", "--repeats", "1", *places]) == 0
    return folder


@pytest.fixture(scope="module")
def results(once: Path) -> dict[str, dict[str, Any]]:
    content = json.loads((once / "reports" / "results.json").read_text(encoding="utf-8"))
    return {entry["key"]: entry for entry in content["papers"]}


@pytest.mark.parametrize("key", KEYS)
def test_the_committed_pages_show_the_verdicts_that_the_list_expects(key: str) -> None:
    assert verdict_rows(committed_results()[key]) == expected_rows(key)


@pytest.mark.parametrize("key", KEYS)
def test_no_verdict_of_the_committed_list_turns_into_its_opposite(
    key: str, results: dict[str, dict[str, Any]]
) -> None:
    fresh, expected = verdict_rows(results[key]), expected_rows(key)
    assert [row[:5] for row in fresh] == [row[:5] for row in expected]
    turned = [
        (new, old[5])
        for new, old in zip(fresh, expected, strict=True)
        if (new[5], old[5]) in OPPOSITE
    ]
    assert turned == []


@pytest.mark.parametrize("key", KEYS)
def test_every_run_of_the_protocol_was_made_and_every_verdict_says_provisional(
    key: str, results: dict[str, dict[str, Any]]
) -> None:
    entry = results[key]
    assert entry["provenance"]["runs"] == len(plan([all_papers()[key]], 1))
    assert not [f for f in entry["findings"] if f["verdict"] == "not run"]
    assert all("provisional" in f["note"] for f in entry["findings"] if f["repeats"] == 1)


@pytest.mark.parametrize("key", KEYS)
def test_the_first_repeat_is_the_one_on_the_committed_pages(
    key: str, results: dict[str, dict[str, Any]]
) -> None:
    committed = committed_results()[key]
    fresh = results[key]
    here = fresh["provenance"]["environments"][0]
    there = committed["provenance"]["environments"][0]
    decisive = ("packages", "libc", "vector_instructions", "system")
    if any(here[name] != there[name] for name in decisive):
        pytest.skip("another processor or library: the last bits may differ")
    assert [f["value"] for f in fresh["findings"]] == [f["value"] for f in committed["findings"]]


def test_a_second_call_runs_nothing_and_writes_the_same_bytes(
    once: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = pages(once / "reports")
    places = ["--store", str(once / "store"), "--reports", str(once / "reports")]
    assert main(["reproduce", "--repeats", "1", *places]) == 0
    assert pages(once / "reports") == before
    assert " runs (" not in capsys.readouterr().err
