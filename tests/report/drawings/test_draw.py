import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from xml.etree import ElementTree as ET

import matplotlib as mpl
import numpy as np
import pytest

from papers.liang2026 import FANUC, PAPER
from repro.determinism.seeds import generator
from repro.errors import InputError
from repro.model.evidence import Cell, Evidence, Runs
from repro.model.experiment import Experiment
from repro.model.figures import Convergence, Figure
from repro.report.drawings import draw as drawn_figures
from repro.report.drawings.draw import Drawing
from repro.report.words import number
from tests.small_papers import evidence_of
from tests.written_rows import rows_of

SVG = "{http://www.w3.org/2000/svg}"
CONVERGENCE, TOOL_PATH, SET_MOTION, MOTION, _ARM = PAPER.figures

draw = partial(drawn_figures.draw, assumptions=PAPER.assumptions)


def runs_of(experiment: Experiment, problem: str, algorithm: str) -> Runs:
    """Return two repeats of three short runs, really searched."""
    results = [
        experiment.algorithms[algorithm].minimise(
            experiment.problems[problem],
            population=20,
            iterations=60,
            rng=generator(problem, algorithm, run),
        )
        for run in range(6)
    ]
    return Runs(
        costs=np.array([result.cost for result in results]).reshape(2, 3),
        points=np.array([result.x for result in results]).reshape(2, 3, -1),
        histories=np.array([result.history for result in results]).reshape(2, 3, 60),
        evaluations=results[0].evaluations,
    )


@pytest.fixture(scope="module")
def evidence() -> Evidence:
    runs = {
        (experiment.name, problem, algorithm): runs_of(experiment, problem, algorithm)
        for experiment in PAPER.experiments
        for problem in experiment.problems
        for algorithm in experiment.algorithms
    }
    return evidence_of(PAPER, runs)


@pytest.fixture(scope="module", params=PAPER.figures, ids=lambda figure: figure.label)
def drawing(request: pytest.FixtureRequest, evidence: Evidence) -> Drawing:
    return draw(request.param, evidence, "paper-fig")


def with_histories(evidence: Evidence, cell: Cell, histories: np.ndarray) -> Evidence:
    changed = replace(evidence.runs[cell], histories=histories)
    return evidence_of(PAPER, {**evidence.runs, cell: changed})


def parsed(drawing: Drawing) -> ET.Element:
    return ET.fromstring(drawing.svg)  # noqa: S314 (our own text)


def texts(drawing: Drawing) -> list[str]:
    return [element.text or "" for element in parsed(drawing).iter(f"{SVG}text")]


@pytest.mark.parametrize("figure", PAPER.figures, ids=lambda figure: figure.label)
def test_drawing_twice_gives_the_same_bytes(figure: Figure, evidence: Evidence) -> None:
    assert draw(figure, evidence, "a") == draw(figure, evidence, "a")


def test_settings_of_the_user_change_nothing_and_stay_as_they_were(evidence: Evidence) -> None:
    expected = draw(SET_MOTION, evidence, "a")
    with mpl.rc_context({"font.size": 20, "svg.fonttype": "path", "axes.linewidth": 5}):
        assert draw(SET_MOTION, evidence, "a") == expected
        assert mpl.rcParams["font.size"] == 20


def test_drawings_made_in_threads_at_once_are_the_same(evidence: Evidence) -> None:
    expected = [draw(figure, evidence, "a") for figure in PAPER.figures]
    with ThreadPoolExecutor(4) as pool:
        drawn = list(pool.map(lambda figure: draw(figure, evidence, "a"), PAPER.figures))
    assert drawn == expected


def test_every_id_carries_the_prefix_and_stands_once(drawing: Drawing) -> None:
    ids = re.findall(r'\bid="([^"]*)"', drawing.svg)
    assert ids
    assert all(name.startswith("paper-fig-") for name in ids)
    assert len(ids) == len(set(ids))


def test_every_reference_inside_finds_its_target(drawing: Drawing) -> None:
    targets = set(re.findall(r'(?:href="|url\()#([^")]+)', drawing.svg))
    assert targets
    assert targets <= set(re.findall(r'\bid="([^"]*)"', drawing.svg))


def test_two_drawings_of_a_page_share_no_id(evidence: Evidence) -> None:
    first, second = (draw(SET_MOTION, evidence, name).svg for name in ("a", "b"))
    ids = [set(re.findall(r'\bid="([^"]*)"', svg)) for svg in (first, second)]
    assert not ids[0] & ids[1]


def test_black_is_left_to_the_page(drawing: Drawing) -> None:
    root = parsed(drawing)
    assert "#000000" not in drawing.svg
    assert root.get("fill") == "currentColor"
    assert "stroke: currentColor" in drawing.svg


def test_the_ground_is_transparent(drawing: Drawing) -> None:
    assert "#ffffff" not in drawing.svg


def test_title_and_description_are_joined_to_the_drawing(drawing: Drawing) -> None:
    root = parsed(drawing)
    title, desc = root[0], root[1]
    assert root.get("role") == "img"
    assert root.get("aria-labelledby") == f"{title.get('id')} {desc.get('id')}"
    assert (title.tag, title.text) == (f"{SVG}title", drawing.title)
    assert (desc.tag, desc.text) == (f"{SVG}desc", drawing.description)


def test_the_drawing_scales_and_asks_nothing_of_its_surroundings(drawing: Drawing) -> None:
    root = parsed(drawing)
    assert drawing.svg.startswith("<svg ")
    assert root.get("width") == "100%"
    assert root.get("height") is None
    assert root.get("viewBox")
    assert "<style" not in drawing.svg
    assert "http" not in drawing.svg.replace("http://www.w3.org/2000/svg", "")


def test_text_stays_text_of_a_readable_size(drawing: Drawing) -> None:
    sizes = [float(size) for size in re.findall(r"font-size: ([\d.]+)px", drawing.svg)]
    assert len(sizes) == len(texts(drawing)) > 0
    assert min(sizes) >= 9


def test_a_drawing_is_light(drawing: Drawing) -> None:
    assert len(drawing.svg.encode()) < 150_000


def test_rows_are_a_table_with_headings(drawing: Drawing) -> None:
    headings, *rows = rows_of(drawing.frame)
    assert rows
    assert {len(row) for row in rows} == {len(headings)}
    assert "nan" not in {text for row in rows for text in row}


def test_description_tells_the_final_medians_of_the_first_repeat(evidence: Evidence) -> None:
    told = draw(CONVERGENCE, evidence, "a").description
    for (experiment, _, algorithm), runs in evidence.runs.items():
        if experiment == "benchmark":
            assert f"{algorithm} {number(float(np.median(runs.histories[0, :, -1])))}" in told
    assert "median of 3 runs" in told
    assert "after 60 iterations" in told


def test_description_of_single_runs_speaks_of_no_median(evidence: Evidence) -> None:
    cells = [cell for cell in evidence.runs if cell[0] == "benchmark"]
    single = {cell: evidence.runs[cell].histories[:1, :1] for cell in cells}
    found = evidence
    for cell, history in single.items():
        found = with_histories(found, cell, history)
    told = draw(CONVERGENCE, found, "a").description
    assert "a line for the one run. Cost after 60 iterations" in told


def test_rows_of_convergence_hold_the_lowest_median_and_highest_run(evidence: Evidence) -> None:
    rows = rows_of(draw(CONVERGENCE, evidence, "a").frame)
    final = next(row for row in rows if row[:3] == ("F5", "WOA", "60"))
    costs = np.sort(evidence.runs["benchmark", "F5", "WOA"].histories[0, :, -1])
    assert [float(text) for text in final[3:]] == pytest.approx(costs, rel=1e-5)


def test_a_long_history_is_thinned_out_but_keeps_both_ends(evidence: Evidence) -> None:
    cell = ("benchmark", "F1", "WOA")
    long = np.geomspace(1, 1e-9, 6000).reshape(1, 1, -1)
    rows = rows_of(draw(CONVERGENCE, with_histories(evidence, cell, long), "a").frame)
    own = [row for row in rows if row[:2] == ("F1", "WOA")]
    assert len(own) <= 80
    assert (own[0][2], own[-1][2]) == ("1", "6000")


def test_costs_of_zero_stand_at_a_mark_of_their_own(evidence: Evidence) -> None:
    cell = ("benchmark", "F1", "IWOA")
    histories = evidence.runs[cell].histories.copy()
    histories[..., 30:] = 0.0
    without, drawn = (
        draw(CONVERGENCE, e, "a") for e in (evidence, with_histories(evidence, cell, histories))
    )
    assert "nan" not in drawn.svg
    assert texts(drawn).count("0") == texts(without).count("0") + 1
    assert "IWOA 0," in drawn.description
    assert "exactly 0" in drawn.description
    assert "exactly 0" not in without.description


def test_a_search_that_starts_without_a_cost_is_drawn_from_its_first(evidence: Evidence) -> None:
    cell = ("benchmark", "F1", "WOA")
    histories = evidence.runs[cell].histories.copy()
    histories[..., :5] = np.inf
    rows = rows_of(draw(CONVERGENCE, with_histories(evidence, cell, histories), "a").frame)
    assert next(row for row in rows if row[:2] == ("F1", "WOA"))[2] == "6"


def test_without_runs_the_drawing_says_so() -> None:
    drawn = draw(CONVERGENCE, evidence_of(PAPER, {}), "a")
    assert texts(drawn) == ["No runs yet"]
    assert drawn.description == "No runs yet."
    assert len(rows_of(drawn.frame)) == 1


def test_missing_runs_are_named(evidence: Evidence) -> None:
    missing = {("benchmark", "F5", "WOA"), ("motion", "FANUC", "WOA")}
    some = evidence_of(PAPER, {c: runs for c, runs in evidence.runs.items() if c not in missing})
    assert "No runs yet of WOA on F5." in draw(CONVERGENCE, some, "a").description
    assert "No runs yet of WOA." in draw(MOTION, some, "a").description


def test_a_hostile_name_is_shown_as_text(evidence: Evidence) -> None:
    names = ("<script>alert(1)", "$x_{$", "_hidden", "--> &")
    experiment = evidence.experiment("benchmark")
    woa = evidence.runs["benchmark", "F1", "WOA"]
    hostile = replace(
        experiment,
        name="hostile",
        proposed=names[0],
        problems={"]]>": experiment.problems["F1"]},
        algorithms=dict.fromkeys(names, experiment.algorithms["WOA"]),
    )
    paper = replace(PAPER, experiments=(*PAPER.experiments, hostile))
    runs = {("hostile", "]]>", name): woa for name in names}
    figure = Convergence(label="<b>", caption='"', experiment="hostile")
    drawn = draw(figure, evidence_of(paper, runs), "a")
    assert "<script" not in drawn.svg
    assert {"]]>", *names} <= set(texts(drawn))


def test_costs_of_functions_have_no_unit_and_nothing_is_said_of_those_of_motions(
    evidence: Evidence,
) -> None:
    motions = Convergence(label="a", caption="b", experiment="motion")

    assert "best cost (no unit)" in texts(draw(CONVERGENCE, evidence, "a"))
    assert "best cost" in texts(draw(motions, evidence, "a"))


@pytest.mark.parametrize("identifier", ["", "1a", 'a" onload="x', "a b"])
def test_an_identifier_that_is_none_is_refused(identifier: str) -> None:
    with pytest.raises(InputError, match="identifier"):
        draw(SET_MOTION, evidence_of(PAPER, {}), identifier)


def test_motion_has_a_column_per_algorithm_and_one_of_the_optimum(evidence: Evidence) -> None:
    drawn = draw(MOTION, evidence, "a")
    best = FANUC.shortest()
    mean = evidence.values(("motion", "FANUC", "WOA"), "total")[0].mean()
    assert {row[0] for row in rows_of(drawn.frame)[1:]} == {"WOA", "IWOA", "certified optimum"}
    assert {"WOA", "IWOA", "certified optimum"} <= set(texts(drawn))
    assert f"= {best.sum():.4g} s" in drawn.description
    assert f"= {mean:.4g} s" in drawn.description
