"""A made-up fifth paper joins with one file and no edit of the engine."""

import json
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from repro.__main__ import main

MODULE = Path(__file__).parents[1] / "doe2021.py"


@pytest.fixture
def joined(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """Yield the path of the paper's module, in an empty folder."""
    monkeypatch.setattr(sys, "path", [*sys.path])
    monkeypatch.chdir(tmp_path)
    shutil.copy(MODULE, tmp_path / "doe2021.py")
    yield "./doe2021.py"
    sys.modules.pop("doe2021", None)


def test_a_paper_joins_with_one_module(joined: str) -> None:
    assert main(["reproduce", joined, "--repeats", "1"]) == 0

    results = json.loads(Path("reports/results.json").read_text(encoding="utf-8"))
    assert [entry["key"] for entry in results["papers"]] == ["doe2021"]
    assert Path("reports/doe2021.html").exists()


def test_its_audit_and_certificates_need_no_run(
    joined: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["audit", joined, "--json"]) == 0
    assert {row["grade"] for row in json.loads(capsys.readouterr().out)} == {"impossible"}
    assert main(["certify", joined, "--json"]) == 0
    (certificate,) = json.loads(capsys.readouterr().out)
    assert certificate["problem"] == "motion/arm"


def test_a_slip_in_its_module_is_named_on_import(
    joined: str, capsys: pytest.CaptureFixture[str]
) -> None:
    module = Path(joined)
    module.write_text(module.read_text(encoding="utf-8").replace("2.357", "2.3.57"))

    assert main(["list", joined]) == 2

    said = capsys.readouterr().err
    assert "doe2021.py, line 29: Table 3, row 'WOA': '2.3.57' is not a number" in said
