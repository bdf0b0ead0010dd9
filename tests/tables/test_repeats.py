"""Numbers that recur."""

import numpy as np
import pytest

from repro.audit import audit
from repro.functions import FUNCTIONS
from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import audit_text
from tests.summaries import paper_of


@pytest.mark.parametrize(("text", "is_fixed"), [("-10.153", True), ("-10.154", False)])
def test_only_what_rounds_to_a_value_that_the_function_fixes_may_recur(
    text: str, *, is_fixed: bool
) -> None:
    function = FUNCTIONS["shekel_5"]
    least = function(function.minimiser())
    assert np.isclose(least, -10.1532, atol=5e-5)  # rounds to the first print alone
    rows = audit(paper_of({"A": {"mean": text}, "B": {"mean": text}}, n=30, function="shekel_5"))
    assert ("repeat" in {row.check for row in rows}) is not is_fixed


def repeats(text: str) -> list[str]:
    (table,) = audit_text(text, AuditOptions())
    return [row.explanation for row in table.rows if row.check == "repeat"]


@pytest.mark.parametrize(("cost", "recurs"), [("314.000", False), ("314.159", True)])
def test_zeros_behind_the_point_of_a_whole_number_are_no_digits_that_agree(
    cost: str, *, recurs: bool
) -> None:
    text = f"Algorithm,Mean,Worst\nGA,{cost},400.5\nPSO,{cost},500.7\n"

    assert bool(repeats(text)) is recurs


@pytest.mark.parametrize(("heading", "recurs"), [("Best", False), ("Mean", True)])
def test_different_searches_may_find_one_optimum(heading: str, *, recurs: bool) -> None:
    assert bool(repeats(f"Algorithm,{heading}\nGA,7542.13\nPSO,7542.13\n")) is recurs
