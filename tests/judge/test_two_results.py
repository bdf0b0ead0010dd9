from typing import Any

import pytest

from repro.judge.two_results import compare


def results(*verdicts: tuple[str, str | None]) -> dict[str, Any]:
    findings = [
        {
            "table": "Table 1",
            "row": f"F{number}",
            "column": "WOA",
            "claim": None,
            "where": "p. 3",
            "verdict": verdict,
            "side": side,
        }
        for number, (verdict, side) in enumerate(verdicts, start=1)
    ]
    return {"provenance": {"repeats": 20}, "papers": [{"key": "doe2021", "findings": findings}]}


def test_equal_results_have_no_flip() -> None:
    same = results(("reproduced", None), ("contradicted", "lower"))

    found = compare(same, same)

    assert (found.compared, found.flips, found.repeats) == (2, (), (20, 20))
    assert found.as_text() == (
        "2 verdicts compared: 2 the same, 0 changed, 0 of them into their opposite\n"
    )


@pytest.mark.parametrize(
    ("first", "second", "opposite"),
    [
        (("reproduced", None), ("contradicted", "lower"), True),
        (("contradicted", "lower"), ("consistent", None), True),
        (("contradicted", "lower"), ("contradicted", "higher"), False),
        (("depends", None), ("contradicted", "higher"), False),
        (("reproduced", None), ("consistent", None), False),
        (("reproduced", None), ("undecided", None), False),
        (("undecided", None), ("contradicted", "higher"), False),
    ],
)
def test_only_held_and_contradicted_are_opposite(
    first: tuple[str, str | None], second: tuple[str, str | None], *, opposite: bool
) -> None:
    found = compare(results(first), results(second))

    assert [flip.opposite for flip in found.flips] == [opposite]
    assert found.as_json()["opposite"] == int(opposite)
    assert found.flips[0].place == "Table 1, F1, WOA (p. 3)"


def test_what_one_of_the_results_alone_speaks_of_is_said_and_not_compared() -> None:
    fewer = results(("reproduced", None))
    more = results(("reproduced", None), ("undecided", None))

    found = compare(fewer, more)

    assert (found.compared, found.flips, found.only_first) == (1, (), ())
    assert found.only_second == (("doe2021", "Table 1, F2, WOA (p. 3)"),)
    assert found.as_json()["only_second"] == ["doe2021, Table 1, F2, WOA (p. 3)"]
    assert compare(more, fewer).as_text().splitlines()[1:] == [
        "1 in the first results alone:",
        "doe2021, Table 1, F2, WOA (p. 3)",
    ]


def test_where_other_readings_were_tried_the_re_run_alone_is_compared() -> None:
    turned, plain = results(("depends", None)), results(("contradicted", "lower"))
    (finding,) = turned["papers"][0]["findings"]
    finding |= {"as_run": "contradicted", "as_run_side": "lower"}
    finding["readings"] = [{"reading": "wider", "repeats": 10}]

    assert compare(turned, plain).flips == ()
    (other,) = plain["papers"][0]["findings"]
    other["readings"] = finding["readings"]
    assert [flip.first for flip in compare(turned, plain).flips] == ["depends"]


def test_number_that_depends_is_neither_held_nor_contradicted() -> None:
    turned, plain = results(("depends", None)), results(("consistent", None))
    (finding,) = turned["papers"][0]["findings"]
    finding |= {"as_run": "contradicted", "as_run_side": "lower"}
    finding["readings"] = [{"reading": "wider", "repeats": 10}]

    (flip,) = compare(turned, plain).flips

    assert (flip.first, flip.second) == ("contradicted, lower", "consistent")
    assert (flip.depends, flip.opposite) == (True, False)
    assert compare(turned, plain).as_json()["depending"] == 1
