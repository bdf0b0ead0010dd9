"""A made-up fifth paper joins with one module and no edit of the engine."""

import json
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import papers
from repro.__main__ import main
from repro.commands.catalogue import all_papers

MODULE = Path(__file__).parents[1] / "doe2021.py"


@pytest.fixture
def joined(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    folder = tmp_path / "papers"
    folder.mkdir()
    shutil.copy(MODULE, folder / "doe2021.py")
    monkeypatch.setattr(papers, "__path__", [*papers.__path__, str(folder)])
    yield tmp_path
    sys.modules.pop("papers.doe2021", None)


def test_a_paper_joins_with_one_module(joined: Path) -> None:
    assert "doe2021" in all_papers()
    places = ["--store", str(joined / "store"), "--reports", str(joined / "reports")]
    assert main(["reproduce", "doe2021", "--repeats", "1", *places]) == 0
    results = json.loads((joined / "reports" / "results.json").read_text(encoding="utf-8"))
    assert [entry["key"] for entry in results["papers"]] == ["doe2021"]
    assert (joined / "reports" / "doe2021.html").exists()


def test_its_audit_and_certificates_need_no_run(
    joined: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert joined.exists()
    assert main(["audit", "doe2021", "--json"]) == 0
    assert {row["grade"] for row in json.loads(capsys.readouterr().out)} == {"impossible"}
    assert main(["certify", "doe2021", "--json"]) == 0
    (certificate,) = json.loads(capsys.readouterr().out)
    assert certificate["problem"] == "motion/arm"


def test_a_slip_in_its_module_is_named_on_import(
    joined: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    module = joined / "papers" / "doe2021.py"
    module.write_text(module.read_text(encoding="utf-8").replace("2.357", "2,357"))
    assert main(["list"]) == 2
    assert "Table 3, row 'WOA': '2,357' is not a number" in capsys.readouterr().err
