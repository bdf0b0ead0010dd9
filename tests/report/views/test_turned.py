from dataclasses import replace

from repro.judge.judgement import Judgement, judge
from repro.report.views.findings import everything
from repro.report.views.readings import readings_view, settings_of
from repro.report.views.turned import Matrix, turned_by
from tests.judge.test_other_readings import WIDER, evidence, open_paper


def judgement(**costs: float) -> Judgement:
    paper = open_paper(WIDER)
    return judge(paper, evidence(paper, **costs))


def matrix(found: Judgement) -> Matrix:
    settings = settings_of(found.paper)
    shown = everything(found.findings, found.audit, settings)
    return turned_by(readings_view(found).rows, shown, settings)


def test_a_cell_names_the_numbers_that_a_reading_turns_and_both_verdicts() -> None:
    found = matrix(judgement(guess=5.0, wider=0.05))

    assert found.columns == ("Table 1",)
    ((row, (crossing,)),) = found.rows
    (turned,) = crossing.turned
    assert (row.name, crossing.bears, crossing.counts) == ("wider", 2, (("held", 1),))
    assert turned.before.startswith("✖ contradicted")
    assert turned.after.split()[1] in {"reproduced", "consistent"}
    assert (turned.section, turned.label) == ("tables", "bowl mean, guess")


def test_numbers_that_turn_are_listed_by_their_table() -> None:
    found = matrix(judgement(guess=5.0, wider=0.05))

    ((column, numbers),) = found.depending
    assert (column, [n.finding.row for n in numbers]) == ("Table 1", ["bowl mean"])


def test_a_value_of_a_setting_that_leads_past_a_number_is_told_from_one_that_holds_it() -> None:
    paper = open_paper(replace(WIDER, at=3.0))
    (width,) = paper.assumptions
    paper = replace(paper, assumptions=(replace(width, open=True, at=1.0),))

    found = matrix(judge(paper, evidence(paper, guess=5.0, wider=0.0005)))

    ((_, (crossing,)),) = found.rows
    assert crossing.counts == (("passed", 1),)


def test_a_table_on_which_no_reading_bears_is_no_column() -> None:
    assert turned_by((), everything(judgement(guess=5.0).findings, ()), {}).columns == ()
