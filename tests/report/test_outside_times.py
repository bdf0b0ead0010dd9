import json
from dataclasses import replace
from pathlib import Path

import pytest

from repro.commands.catalogue import all_papers
from repro.judge.certificates import Certificate, certify
from repro.judge.outside_planners import outside_references
from repro.report import outside_times as module
from repro.report.outside_times import outside_times, planners
from tests.doe2021 import PAPER

(CERTIFICATE,) = certify(PAPER)
MINIMUM = CERTIFICATE.minimum or 0.0
ROW = {
    "paper": CERTIFICATE.paper,
    "problem": CERTIFICATE.problem,
    "planner": "ruckig",
    "what": "Time along any curve, in s",
    "time": 0.5 * MINIMUM,
    "minimum": MINIMUM,
}


def shown(folder: Path, certificate: Certificate) -> list[tuple[str, float, float]]:
    text = json.dumps({"versions": {"ruckig": "1.2"}, "rows": [ROW]})
    (folder / "planners.json").write_text(text, encoding="utf-8")
    return list(outside_times(certificate))


def test_answer_of_a_planner_stands_beside_the_minimum_with_its_version(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "files", lambda _: tmp_path)

    assert list(outside_times(CERTIFICATE)) == []
    assert shown(tmp_path, CERTIFICATE) == [
        ("ruckig 1.2: time along any curve", 0.5 * MINIMUM, 0.5)
    ]


@pytest.mark.parametrize(
    "other", [{"minimum": 1.01 * MINIMUM}, {"minimum": None}, {"problem": "a"}, {"paper": "b"}]
)
def test_answer_to_another_problem_is_not_shown(
    other: dict[str, object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "files", lambda _: tmp_path)

    assert shown(tmp_path, replace(CERTIFICATE, **other)) == []  # type: ignore[arg-type]


def test_what_the_package_ships_is_of_every_motion_of_the_papers_of_today() -> None:
    papers = list(all_papers().values())
    minima = {
        (row.paper, row.problem): row.minimum
        for paper in papers
        for row in certify(paper)
        if row.minimum is not None
    }
    asked = {
        (row.paper, row.problem, row.planner)
        for row in outside_references(papers)
        if (row.paper, row.problem) in minima
    }
    found = planners()

    assert asked
    assert {(row["paper"], row["problem"], row["planner"]) for row in found["rows"]} == asked
    assert set(found["versions"]) == {planner for *_, planner in asked}
    for row in found["rows"]:
        assert row["minimum"] == pytest.approx(minima[row["paper"], row["problem"]], rel=1e-5)
