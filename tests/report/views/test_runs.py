import pytest

from repro.judge.judgement import judge
from repro.model.evidence import Evidence
from repro.model.paper import Paper
from repro.report.views.runs import RunsView, runs_view
from tests.doe2021 import PAPER
from tests.report.views.test_centre_bias import WIDER, evidence
from tests.small_papers import PAPER as SMALL
from tests.small_papers import evidence_of


def shown(evidence: Evidence, paper: Paper = WIDER) -> RunsView:
    return runs_view(judge(paper, evidence))


def test_data_of_everything_shown_has_a_file_of_its_own() -> None:
    tables = shown(evidence()).tables()

    assert {"centre-bias-test", "runs-table-2"} <= set(tables)
    assert list(tables["centre-bias-test"].columns[:2]) == ["algorithm", "shift"]


@pytest.mark.parametrize(("paper", "shiftable"), [(PAPER, True), (SMALL, False)])
def test_a_paper_without_runs_shows_none(paper: Paper, *, shiftable: bool) -> None:
    view = shown(evidence_of(paper, {}), paper)

    assert (view.comparisons, view.centre_biases, view.distributions) == ((), (), ())
    assert view.shiftable == shiftable
    assert not view.tables()
    assert not view.files("doe2021")


def test_templates_get_everything_by_name() -> None:
    assert set(shown(evidence()).context()) >= {
        "comparisons",
        "centre_biases",
        "distributions",
        "shiftable",
    }


def test_files_are_named_by_paper_and_table() -> None:
    text = shown(evidence()).files("doe2021")["tables/doe2021-centre-bias-test.csv"]

    assert text.startswith("algorithm,shift,problem,ratio")
