from collections import Counter

import pytest

from repro.judge.counting import GRAVEST, by_group, counts
from repro.judge.verdict import Verdict


def test_findings_of_one_group_count_once() -> None:
    said = [("a", "reproduced"), ("a", "reproduced"), ("b", "contradicted")]

    assert counts(said) == Counter({"reproduced": 1, "contradicted": 1})


def test_findings_without_a_group_are_not_counted() -> None:
    assert counts([(None, "reproduced")]) == Counter()


@pytest.mark.parametrize("verdict", GRAVEST)
def test_sentence_has_the_gravest_verdict_of_its_parts_in_any_order(verdict: Verdict) -> None:
    lighter = GRAVEST[GRAVEST.index(verdict) :]

    assert by_group([("a", each) for each in lighter]) == {"a": verdict}
    assert by_group([("a", each) for each in reversed(lighter)]) == {"a": verdict}


def test_every_verdict_has_a_weight() -> None:
    assert sorted(GRAVEST) == sorted(Verdict)
