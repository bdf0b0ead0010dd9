import json
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.model.cells import every_cell
from repro.model.open_points import Gap
from repro.model.tolerances import Percent
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER, let_be_known

LEFT = Gap(what="costs of the owl", where="p. 3", because="its equations are not printed")
OWLS = replace(EXPERIMENT, proposed="owl", left_out={"owl": LEFT})
TABLE = PublishedTable.read("""
    Table 1, p. 3
    problem | statistic  || guess | wide | owl
    bowl    | mean       || 0.05  | 0.5  | 0.01
            | rank       || 2     | 3    | 1
            | rank-sum p || 0.01  | 0.02 | –
""")
CLAIMS = every_cell(
    TABLE, of=OWLS, rows=("problem", "statistic"), columns="algorithm", within=Percent(25)
)
OF_OWLS = replace(PAPER, experiments=(OWLS,), results=(TABLE,), claims=CLAIMS, gaps=(LEFT,))


def test_a_paper_whose_proposed_algorithm_is_left_out_claims_nothing_about_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    let_be_known(monkeypatch, OF_OWLS)
    monkeypatch.chdir(tmp_path)

    assert main(["reproduce", PAPER.key, "--repeats", "2"]) == 0

    results = json.loads(Path("reports/results.json").read_text(encoding="utf-8"))
    (entry,) = results["papers"]
    left = [each["row"] for each in entry["findings"] if each["verdict"] == "not reproducible"]
    assert left == ["bowl mean", *["bowl rank"] * 3, *["bowl rank-sum p"] * 2]
    assert {each["group"] for each in entry["findings"] if each["row"] == "bowl rank"} == {
        LEFT.what
    }
    assert not [test for test in entry["tests"] if test["test"] != "Friedman"]
    for page in (f"reports/{PAPER.key}.statistics.html", f"reports/{PAPER.key}.md"):
        text = Path(page).read_text(encoding="utf-8")
        assert "compared with nothing: owl (its equations are not printed)." in text
        assert "owl against the others" not in text
    assert main(["check", PAPER.key]) == 0
    assert main(["list", PAPER.key]) == 0
    assert capsys.readouterr().err.count("Traceback") == 0
