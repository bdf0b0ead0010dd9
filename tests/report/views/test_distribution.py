import re
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from papers.liang2026 import PAPER as LIANG
from papers.smwoa2022 import PAPER as SMWOA
from repro.model.evidence import Evidence, Runs
from repro.model.paper import Paper
from repro.report.drawings.draw import Drawing
from repro.report.views.distribution import PANELS, distributions
from tests.small_papers import evidence_of
from tests.written_rows import rows_of

SVG = "{http://www.w3.org/2000/svg}"
MOST_BYTES = 60_000


def runs(costs: np.ndarray) -> Runs:
    return Runs(
        costs=costs,
        points=np.ones((*costs.shape, 3)),
        histories=np.ones((*costs.shape, 2)),
        evaluations=72,
    )


def evidence(paper: Paper, *, zeros: bool = False) -> Evidence:
    """Return two repeats of thirty costs over many decades for the paper's benchmark."""
    rng = np.random.default_rng(6)
    experiment = paper.experiments[0]
    found = {}
    for problem in experiment.problems:
        for name in experiment.algorithms:
            costs = 10 ** rng.normal(-30, 9, size=(2, 30))
            costs[:, :12] *= not zeros
            found[experiment.name, problem, name] = runs(costs)
    return evidence_of(paper, found)


TABLE_II = distributions(LIANG, evidence(LIANG))[0].drawing
WITH_ZEROS = distributions(LIANG, evidence(LIANG, zeros=True))[0].drawing
TABLE_3 = [each.drawing for each in distributions(SMWOA, evidence(SMWOA))]


def texts(shown: Drawing) -> list[str]:
    root = ET.fromstring(shown.svg)  # noqa: S314 (our own text)
    return [element.text or "" for element in root.iter(f"{SVG}text")]


def test_every_table_with_runs_is_drawn_and_no_other() -> None:
    names = [each.name for each in distributions(LIANG, evidence(LIANG))]

    assert names == ["runs-table-ii"]
    assert distributions(LIANG, evidence_of(LIANG, {})) == ()


def test_a_long_table_is_drawn_in_parts_in_the_order_of_its_rows() -> None:
    names = [each.name for each in distributions(SMWOA, evidence(SMWOA))]
    problems = [
        list(dict.fromkeys(row[0] for row in rows_of(shown.frame)[1:])) for shown in TABLE_3
    ]

    assert names == [f"runs-table-3-part-{part}" for part in (1, 2, 3)]
    assert [name for part in problems for name in part] == [f"F{k}" for k in range(1, 16)]
    assert max(map(len, problems)) == PANELS


def test_data_hold_quartiles_of_all_repeats_and_what_is_printed() -> None:
    headings, *rows = rows_of(TABLE_II.frame)
    row = next(dict(zip(headings, r, strict=True)) for r in rows if r[0] == "F5" and r[2] == "WOA")
    costs = np.sort(evidence(LIANG).values(("benchmark", "F5", "WOA")).ravel())

    assert (row["runs"], row["zeros"]) == ("60", "0")
    assert float(row["lowest"]) == pytest.approx(costs[0], rel=1e-5)
    assert costs[28] <= float(row["median"]) <= costs[31]
    assert costs[13] <= float(row["lower quartile"]) <= costs[16]
    assert float(row["highest"]) == pytest.approx(costs[-1], rel=1e-5)
    assert (row["printed mean"], row["printed best"]) == ("2.536", "2.53")


def test_algorithms_problems_and_marks_are_named() -> None:
    assert {"F1", "F12", "IWOA", "DBO", "all runs", "middle half", "median"} <= set(texts(TABLE_II))
    assert {"printed mean", "printed best"} <= set(texts(TABLE_II))
    assert "printed best" not in texts(TABLE_3[0])


def test_description_says_medians_and_printed_means() -> None:
    assert "All 60 runs" in TABLE_II.description
    assert "(printed mean 2.536)" in TABLE_II.description
    assert "exactly 0" not in TABLE_II.description


def test_zeros_stand_at_a_mark_of_their_own() -> None:
    headings, *rows = rows_of(WITH_ZEROS.frame)

    assert texts(WITH_ZEROS).count("0") == 4
    assert "stand at the mark 0" in WITH_ZEROS.description
    assert {dict(zip(headings, row, strict=True))["zeros"] for row in rows} == {"24"}


@pytest.mark.parametrize("shown", [TABLE_II, WITH_ZEROS, *TABLE_3])
def test_each_drawing_is_light_and_its_marks_stay_inside(shown: Drawing) -> None:
    box = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', shown.svg)
    marks = re.findall(r'<use [^>]*x="([^"]+)" y="([^"]+)"', shown.svg)

    assert len(shown.svg) < MOST_BYTES
    assert box
    assert marks
    assert all(0 <= float(x) <= float(box[1]) for x, _ in marks)
    assert all(0 <= float(y) <= float(box[2]) for _, y in marks)


def test_the_same_runs_give_the_same_bytes() -> None:
    assert distributions(LIANG, evidence(LIANG))[0].drawing == TABLE_II
