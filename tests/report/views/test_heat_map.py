import math
from dataclasses import replace
from typing import Any

import pytest

from repro.judge.findings import Finding
from repro.judge.verdict import Verdict
from repro.report.views.findings import Place, Shown, everything, table_view
from repro.report.views.heat_map import MOST, HeatMap, heat_map, powers_off
from repro.tables.published import PublishedTable

NAMES = ("F1", "F2", "F3")


def finding(row: str, printed: str, value: float | None, **changes: Any) -> Finding:  # noqa: ANN401 (of each field its own)
    exact = float(printed)
    own = Finding(
        table="T", row=row, column="WOA", claim=None, where="p. 1", printed=printed, unit="",
        measured=None, value=value, accepted=(exact - 0.1 * abs(exact), exact + 0.1 * abs(exact)),
        verdict=Verdict.CONTRADICTED, side=None, note="",
    )  # fmt: skip
    return replace(own, **changes)


def mapped(*findings: Finding) -> HeatMap:
    lines = "\n".join(f"{each.row} || {each.printed}" for each in findings)
    table = PublishedTable.read(f"T\nF || WOA\n{lines}")
    found: dict[Place, Shown] = {
        ("T", shown.finding.row, "WOA"): shown for shown in everything(findings, ())
    }
    return heat_map(table_view(table, found))


def squares(*findings: Finding) -> list[tuple[str, str]]:
    return [(s.look, s.text) for _, (s,) in mapped(*findings).rows if s]


def test_sign_and_number_say_what_the_colour_says() -> None:
    assert squares(finding("F1", "1.0", 250.0), finding("F2", "1.0", 0.0009)) == [
        ("high by-3", "+2"),
        ("low by-4", "−3"),
    ]


def test_a_number_within_the_tolerance_is_grey_whatever_its_verdict() -> None:
    held = finding("F1", "1.0", 1.05)
    turned = finding("F2", "1.0", 0.95, verdict=Verdict.DEPENDS, turns_on=("a reading",))

    assert squares(held, turned) == [("same", "="), ("same", "=◐")]


@pytest.mark.parametrize(("printed", "value"), [("0", 1.0), ("1.0", 0.0), ("1.0", -1.0)])
def test_what_has_no_ratio_is_hatched(printed: str, value: float) -> None:
    ((look, text),) = squares(finding("F1", printed, value))

    assert look == "apart"
    assert text == ("0" if 0.0 in (float(printed), value) else "±")


def test_what_was_not_run_shows_its_verdict_alone() -> None:
    gap = finding("F1", "1.0", None, verdict=Verdict.NOT_REPRODUCIBLE)

    assert squares(gap) == [("none", "∅")]


def test_further_off_than_the_scale_looks_like_its_end_and_says_so() -> None:
    ((_, (square,)),) = mapped(finding("F1", "1.0", 1e-200)).rows

    assert square is not None
    assert (square.look, square.text) == (f"low by-{MOST}", f"−{MOST}")
    assert "6.0 powers of ten or more lower" in square.says


def test_powers_are_those_of_the_ratio_in_both_directions() -> None:
    assert powers_off(100.0, 1.0) == 2.0
    assert powers_off(-1.0, -100.0) == -2.0
    assert powers_off(5e-324, 1.0) == -MOST
    assert powers_off(math.inf, 1.0) is None
    assert powers_off(5e-324, 5e-324) == 0.0


def test_a_column_that_lies_on_one_side_is_said_and_a_mixed_or_short_one_is_not() -> None:
    lower = [finding(name, "1.0", 0.1) for name in NAMES]

    assert mapped(*lower).one_sided == ("every number of WOA (3) re-runs lower than printed",)
    assert mapped(*lower[:2]).one_sided == ()
    assert mapped(*lower, finding("F4", "1.0", 2.0)).one_sided == ()
    assert mapped(*lower, finding("F4", "1.0", 1.0)).one_sided == ()


def test_columns_on_the_same_side_are_said_together() -> None:
    both = [finding(name, "1.0", 0.1, column=of) for name in NAMES for of in ("WOA", "PSO")]
    table = PublishedTable.read(
        "T\nF || WOA | PSO\nF1 || 1.0 | 1.0\nF2 || 1.0 | 1.0\nF3 || 1.0 | 1.0"
    )
    found: dict[Place, Shown] = {
        ("T", s.finding.row, s.finding.column): s for s in everything(both, ())
    }

    assert heat_map(table_view(table, found)).one_sided == (
        "every number of WOA (3), PSO (3) re-runs lower than printed",
    )
