from typing import Any

import pytest

from repro.errors import InputError
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
        (("contradicted", "lower"), ("contradicted", "higher"), True),
        (("reproduced", None), ("undecided", None), False),
        (("undecided", None), ("contradicted", "higher"), False),
    ],
)
def test_only_two_decided_verdicts_are_opposite(
    first: tuple[str, str | None], second: tuple[str, str | None], *, opposite: bool
) -> None:
    found = compare(results(first), results(second))

    assert [flip.opposite for flip in found.flips] == [opposite]
    assert found.as_json()["opposite"] == int(opposite)
    assert found.flips[0].place == "Table 1, F1, WOA (p. 3)"


def test_results_of_other_numbers_are_refused() -> None:
    with pytest.raises(InputError, match="do not speak of the same numbers"):
        compare(results(("reproduced", None)), results())
