"""Numbers that recur."""

import numpy as np
import pytest

from repro.audit import audit
from repro.functions import FUNCTIONS
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
