from dataclasses import replace
from typing import Any

import pytest

from repro.errors import DeclarationError
from repro.model import Absolute, Gap, Printed, Sentence, TextNumber
from repro.model.paper import Paper
from repro.tables.relations import Equal, Less
from tests.small_papers import EXPERIMENT, PAPER

GAP = Gap(what="field", where="p. 6", because="it is not printed", result=False)
HALF = TextNumber(printed=Printed("50", "%"), where="p. 3")


def sentence(**changes: Any) -> Sentence:  # noqa: ANN401 (slips of every kind)
    told: dict[str, Any] = {"claim": "it is fast", "where": "p. 2", "measure": None, "gap": GAP}
    told |= {"printed": Printed("2", "s"), "accepted": Absolute(0.1)}
    return Sentence(**(told | changes))


def with_parts(**parts: object) -> Paper:
    return replace(PAPER, gaps=(GAP,), **{k: (*getattr(PAPER, k), v) for k, v in parts.items()})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("parts", "says"),
    [
        ({"claims": sentence(gap="field")}, "('it is fast'), gap: 'field' is no Gap or None"),
        ({"claims": sentence(measure="mean", gap=None)}, "measure: 'mean' is no Measure or None"),
        ({"claims": sentence(where=4)}, "where: 4 is no text"),
        ({"claims": sentence(counts="yes")}, "counts: 'yes' is no bool"),
        (
            {"relations": Less(printed=HALF.printed, before=HALF, after=HALF)},  # type: ignore[arg-type]
            "relations 1, printed: Printed(text='50', unit='%') is no TableCell, PlacedNumber or",
        ),
        (
            {"relations": Equal(numbers=(HALF, replace(HALF, printed="50 %")))},  # type: ignore[arg-type]
            "relations 1, numbers 2, printed: '50 %' is no Printed",
        ),
        ({"experiments": replace(EXPERIMENT, name="other", where=4)}, "('other'), where: 4 is no"),  # type: ignore[arg-type]
    ],
)
def test_a_field_of_another_kind_is_a_line_with_its_place(
    parts: dict[str, object], says: str
) -> None:
    with pytest.raises(DeclarationError) as raised:
        with_parts(**parts)

    (line,) = str(raised.value).splitlines()
    assert line.startswith(f"{PAPER.key}, ")
    assert says in line


def test_fields_of_the_kind_that_is_meant_are_taken() -> None:
    paper = with_parts(claims=sentence(), relations=Equal(numbers=[HALF, HALF]))  # type: ignore[arg-type]

    assert len(paper.relations) == len(PAPER.relations) + 1
