from dataclasses import replace

import pytest

from repro.judge.judgement import Judgement, judge
from repro.judge.verdict import Verdict
from repro.model.measures.measure import Statistic
from repro.report.views.calibration import coverage_sheet, share_sheets, truthful
from tests.judge.test_other_readings import WIDER, evidence, open_paper


def rows(**shares: float) -> list[dict[str, object]]:
    return [
        {
            "repeats": repeats, "statistic": statistic, "factor": factor, "verdict": verdict,
            "share": share if factor == 1 and repeats == 1 else 0.25,
        }
        for repeats in (1, 10)
        for statistic in ("mean", "std")
        for factor in (1, 100)
        for verdict, share in shares.items()
    ]  # fmt: skip


SHARES = {"reproduced": 0.1, "consistent": 0.62, "undecided": 0.13, "contradicted": 0.15}


def judgement() -> Judgement:
    paper = open_paper(WIDER)  # four cells: mean and std of two columns, two repeats each
    return judge(paper, evidence(paper, guess=5.0, wider=0.05))


def test_what_a_truthful_paper_would_have_scored_follows_from_its_own_mix_of_statistics() -> None:
    found = truthful(judgement(), rows(**SHARES))

    assert found is not None
    assert (found.cells, found.repeats) == (4, 1)  # 10 repeats would be deeper than the paper's 2
    assert found.expected == {
        Verdict.REPRODUCED: 0,
        Verdict.CONSISTENT: 2,
        Verdict.UNDECIDED: 1,
        Verdict.CONTRADICTED: 1,
    }
    assert sum(found.own.values()) == 4
    assert "about 0 reproduced, 2 consistent, 1 undecided, 1 contradicted of these 4 cells" in (
        found.says
    )


def test_cells_that_are_not_judged_are_no_part_of_it() -> None:
    whole = judgement()
    first, *others = whole.findings
    some = replace(whole, findings=(replace(first, verdict=Verdict.NOT_RUN), *others))

    found = truthful(some, rows(**SHARES))

    assert found is not None
    assert found.cells == 3


def test_statistics_that_are_not_calibrated_are_no_part_of_it() -> None:
    whole = judgement()
    first, *others = whole.paper.claims
    assert isinstance(first.measure, Statistic)
    median = replace(first, measure=replace(first.measure, statistic="median"))
    some = replace(whole, paper=replace(whole.paper, claims=(median, *others)))

    found = truthful(some, rows(**SHARES))

    assert found is not None
    assert found.cells == 3


def test_nothing_is_said_of_a_truthful_paper_before_the_verdicts_are_calibrated() -> None:
    assert truthful(judgement(), []) is None


def test_shares_stand_by_depth_statistic_and_factor() -> None:
    once, ten = share_sheets(rows(**SHARES))

    assert (once.name, ten.name) == ("1 repeat", "10 repeats")
    assert once.rows[0] == ("mean", "true", "10.0 %", "62.0 %", "13.0 %", "15.0 %")
    assert [row[1] for row in once.rows] == ["true", "×100"] * 2


def test_a_value_below_the_true_one_is_called_nearer() -> None:
    nearer = [{**row, "factor": 0.01} for row in rows(consistent=1.0)]

    assert share_sheets(nearer)[0].rows[0][1] == "÷100"


@pytest.mark.parametrize(
    ("more", "cell"), [({}, "96.0 %"), ({"resampled": 0.6}, "96.0 % (60.0 %)")]
)
def test_coverage_has_a_column_for_each_depth_and_plain_resampling_in_brackets(
    more: dict[str, float], cell: str
) -> None:
    row = {"kind": "narrow", "repeats": 10, "statistic": "mean", "promised": 0.95, "reached": 0.96}

    sheet = coverage_sheet([{**row, **more}, {**row, "repeats": 1, "statistic": "std"}])

    assert sheet.headings == ("costs", "statistic", "1 repeat", "10 repeats")
    assert sheet.rows == (("narrow", "mean", "–", cell), ("narrow", "std", "96.0 %", "–"))
