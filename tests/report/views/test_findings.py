import math
from dataclasses import replace
from typing import Any

from repro.audit import AuditRow, Grade
from repro.judge.findings import Finding
from repro.judge.turning import ReadingOutcome
from repro.judge.verdict import Verdict
from repro.report.views.findings import everything, marks_by_cell, table_view, tallies
from repro.tables.published import PublishedTable


def finding(row: str, **changes: Any) -> Finding:  # noqa: ANN401 (of each field its own)
    own = Finding(
        table="Table 2", row=row, column="WOA", claim=None, where="p. 5", printed="2.0", unit="",
        measured=(3.0, 4.0), value=3.5, accepted=(1.5, 2.5), verdict=Verdict.CONTRADICTED,
        side="higher", note="", repeats=10, group=row, as_run=Verdict.CONTRADICTED,
        as_run_side="higher",
    )  # fmt: skip
    return replace(own, **changes)


def outcome(name: str, verdict: Verdict, side: str | None = None) -> ReadingOutcome:
    return ReadingOutcome(reading=name, verdict=verdict, side=side, measured=(1.0, 4.0), repeats=4)


def test_what_turns_a_verdict_stands_with_its_outcome_and_all_that_was_tried_is_counted() -> None:
    tried = (
        outcome("scalar", Verdict.CONSISTENT),
        outcome("clipped", Verdict.CONTRADICTED, "higher"),
    )

    (shown,) = everything(
        [
            finding(
                "F1",
                verdict=Verdict.DEPENDS,
                as_run=Verdict.CONTRADICTED,
                as_run_side="higher",
                side=None,
                readings=tried,
                turns_on=("scalar",),
            )
        ],
        [],
    )

    ((turn),) = shown.turns
    assert (turn.name, [one.verdict for one in turn.outcomes]) == ("scalar", ["≈ consistent"])
    assert shown.own == "✖ contradicted (re-run higher)"
    assert shown.brief == "on scalar"
    assert shown.turning == 1
    assert [one.repeats for one in shown.readings] == [4, 4]


def test_a_setting_that_turns_a_verdict_stands_with_the_outcome_of_each_value() -> None:
    tried = (
        outcome("t30", Verdict.CONTRADICTED, "lower"),
        outcome("t90", Verdict.CONTRADICTED, "higher"),
    )
    found = finding("F1", verdict=Verdict.DEPENDS, readings=tried, turns_on=("iterations",))

    (shown,) = everything([found], [], {"iterations": ("t30", "t90")})

    assert [one.reading for one in shown.turns[0].outcomes] == ["t30", "t90"]


def test_a_reading_that_may_turn_nothing_holds_nothing_and_says_why() -> None:
    few = replace(outcome("few", Verdict.CONSISTENT), measured=(0.0, math.inf))
    found = finding("F1", readings=(few, outcome("other title", Verdict.CONSISTENT)))

    (shown,) = everything([found], [], {}, {"other title"})

    assert [one.note for one in shown.readings] == [
        "too few runs to rule anything out",
        "the text rules it out",
    ]
    assert shown.turning == 0


def test_of_the_readings_those_that_turn_the_verdict_are_counted() -> None:
    tried = (
        outcome("t30", Verdict.CONTRADICTED, "lower"),
        outcome("t90", Verdict.CONSISTENT),
        outcome("scalar", Verdict.CONTRADICTED, "lower"),
    )
    found = finding(
        "F1", verdict=Verdict.DEPENDS, readings=tried, turns_on=("iterations",),
        as_run=Verdict.CONTRADICTED,
    )  # fmt: skip

    (shown,) = everything([found], [], {"iterations": ("t30", "t90")})

    assert (shown.turning, len(shown.readings)) == (1, 3)


def test_results_are_tallied_once_in_each_table_and_uncounted_ones_nowhere() -> None:
    held = {"verdict": Verdict.REPRODUCED, "side": None}
    found = [
        finding("F1", group="limits"),
        finding("F2", group="limits", **held),
        finding("F3", table="Table 3", group="limits", **held),
        finding("F4", table="Table 3", **held),
        finding("F5", table="Table 3", group=None),
    ]

    shown = everything(found, [])

    assert [(t.label, t.total, dict(t.counts)) for t in tallies(shown)] == [
        ("Table 2", 1, {"contradicted": 1}),
        ("Table 3", 2, {"contradicted": 1, "reproduced": 1}),
    ]
    assert [one.counted for one in shown] == [
        *(3 * ["counts once with 2 others: limits"]),
        "",
        "input or true by definition: shown, not counted",
    ]


def test_an_audit_row_on_several_cells_marks_each() -> None:
    row = AuditRow(
        paper="doe2021", table="Table 2", row=None, column=None,
        cells=({"row": "F1 Best", "column": "WOA"}, {"row": "F1 Mean", "column": "WOA"}),
        check="repeats", grade=Grade.NOTED, explanation="",
    )  # fmt: skip
    marks = marks_by_cell([row])
    assert marks["Table 2", "F1 Best", "WOA"] == [row]
    assert marks["Table 2", "F1 Mean", "WOA"] == [row]


def test_unit_of_a_row_stands_behind_its_heading() -> None:
    table = PublishedTable.read("Table 9\nquantity || PSO\ntime [ms] || 3\nruns || 30")

    assert [headings for headings, _ in table_view(table, {}).rows] == [("time [ms]",), ("runs",)]
