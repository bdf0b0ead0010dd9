from dataclasses import replace

import pytest

from repro.errors import DeclarationError
from repro.model.assumptions import Alternative, Assumption
from repro.model.measures.measure import Computed
from repro.model.paper import Paper
from repro.runs.readings import applied, changed_part, claims_under, own_part, readings
from tests.small_papers import CLAIMS, EXPERIMENT, PAPER, Bowl, Guessing

WIDER = Alternative(
    name="wider", says="three times", algorithms={("search", "guess"): {"width": 3.0}}
)
OTHER = Alternative(
    name="other", says="another search", algorithms={("search", "guess"): Guessing(width=5.0)}
)
MOVED = Alternative(
    name="moved", says="elsewhere", problems={("search", "bowl"): {"centre": (0.0, 0.0)}}
)
LONGER = Alternative(name="longer", says="9 iterations", protocol={"search": {"iterations": 9}})
IN_WORDS = Alternative(says="as a poet would", untried="it has no number")


def assumption(what: str, *alternatives: Alternative) -> Assumption:
    return Assumption(
        what=what, chosen="ours", alternatives=alternatives, because="so", where="p. 3"
    )


def paper(*assumptions: Assumption, together: tuple[str, ...] = ()) -> Paper:
    return replace(PAPER, assumptions=assumptions, together=together)


def test_every_alternative_that_changes_anything_is_a_variation() -> None:
    found = readings(paper(assumption("width", WIDER, OTHER), assumption("style", IN_WORDS)))

    assert [reading.name for reading in found] == ["wider", "other"]
    assert found[0].says == "width: three times"


def test_alternatives_are_combined_but_not_two_of_one_assumption() -> None:
    declared = paper(
        assumption("width", WIDER, OTHER),
        assumption("place", MOVED),
        together=("wider", "other", "moved"),
    )

    names = [reading.name for reading in readings(declared)]

    assert names == ["wider", "other", "moved", "wider + moved", "other + moved"]


def test_all_that_are_named_together_are_combined_in_every_size() -> None:
    declared = paper(
        *(assumption(a.name, a) for a in (WIDER, MOVED, LONGER)),
        together=("wider", "moved", "longer"),
    )

    assert len(readings(declared)) == 3 + 3 + 1


def test_fields_are_replaced_and_objects_take_the_place_of_others() -> None:
    wider, other = readings(paper(assumption("width", WIDER, OTHER)))

    assert applied(EXPERIMENT, wider).algorithms["guess"] == Guessing(width=3.0)
    assert applied(EXPERIMENT, other).algorithms["guess"] == Guessing(width=5.0)
    assert applied(EXPERIMENT, wider).algorithms["wide"] is EXPERIMENT.algorithms["wide"]


def test_combined_alternatives_all_apply() -> None:
    declared = paper(
        assumption("width", WIDER), assumption("place", MOVED), together=("wider", "moved")
    )

    both = applied(EXPERIMENT, readings(declared)[-1])

    assert both.algorithms["guess"] == Guessing(width=3.0)
    assert both.problems["bowl"] == Bowl(centre=(0.0, 0.0))


def test_only_what_changes_runs_again() -> None:
    wider, moved, longer = readings(paper(*(assumption(a.name, a) for a in (WIDER, MOVED, LONGER))))
    parts = [changed_part(EXPERIMENT, each) for each in (wider, moved, longer)]

    assert [part and set(part.algorithms) for part in parts] == [
        {"guess"},
        {"guess", "wide"},
        {"guess", "wide"},
    ]
    assert parts[2] is not None
    assert parts[2].iterations == 9
    assert changed_part(replace(EXPERIMENT, name="another"), wider) is None


def test_claims_of_an_alternative_take_the_place_of_those_on_the_same_cell() -> None:
    computed = replace(CLAIMS[1], measure=Computed(how="by hand", value=lambda: 1.0))
    (reading,) = readings(
        paper(assumption("rule", Alternative(name="rule", says="by hand", claims=(computed,))))
    )

    found = claims_under(PAPER, reading)

    assert found == (CLAIMS[0], computed, *CLAIMS[2:])
    assert changed_part(EXPERIMENT, reading) is None


@pytest.mark.parametrize(
    ("alternative", "fault"),
    [
        (Alternative(says="idle"), "'idle' needs either something that it changes"),
        (replace(WIDER, untried="lazy"), "'three times' needs either something"),
        (replace(WIDER, name=""), "needs a name without '/'"),
        (replace(WIDER, name="a/b"), "needs a name without '/', not 'a/b'"),
        (replace(WIDER, algorithms={("search", "nobody"): {}}), "no algorithm 'nobody'; there is"),
        (replace(WIDER, algorithms={"guess": {}}), "algorithms: 'guess' is no pair"),  # type: ignore[dict-item]
        (replace(LONGER, protocol={"walk": {"runs": 2}}), "no experiment 'walk'"),
    ],
)
def test_alternative_that_changes_nothing_or_nobody_is_refused(
    alternative: Alternative, fault: str
) -> None:
    with pytest.raises(DeclarationError, match=fault):
        paper(assumption("width", alternative))


def test_two_alternatives_of_one_name_are_refused() -> None:
    with pytest.raises(DeclarationError, match="another alternative has the name 'wider' too"):
        paper(assumption("width", WIDER), assumption("place", replace(MOVED, name="wider")))


def test_unknown_name_among_those_tried_together_is_refused() -> None:
    with pytest.raises(DeclarationError, match=r"together: no .* is 'nobody'; there is"):
        paper(assumption("width", WIDER), together=("nobody",))


def test_combination_runs_an_experiment_only_if_all_of_it_bears_on_it() -> None:
    walk = replace(EXPERIMENT, name="walk")
    moved = replace(MOVED, problems={("walk", "bowl"): {"centre": (0.0, 0.0)}})
    declared = replace(
        PAPER,
        experiments=(EXPERIMENT, walk),
        assumptions=(assumption("width", WIDER), assumption("place", moved)),
        together=("wider", "moved"),
    )
    both = readings(declared)[-1]

    assert [both.touching(name).name for name in ("search", "walk")] == ["wider", "moved"]


@pytest.mark.parametrize(("beside", "own"), [("apart", None), ("moved", (["bowl"], ["guess"]))])
def test_combination_has_runs_of_its_own_only_where_all_of_it_bears_on_a_cell(
    beside: str, own: tuple[list[str], list[str]] | None
) -> None:
    apart = replace(WIDER, name="apart", algorithms={("search", "wide"): {"width": 2.0}})
    other = {"apart": apart, "moved": MOVED}[beside]
    declared = paper(
        assumption("width", WIDER), assumption("place", other), together=("wider", beside)
    )
    both = readings(declared)[-1]

    part = own_part(EXPERIMENT, both)

    assert (part and (list(part.problems), list(part.algorithms))) == own
    assert both.touching("search", "bowl", "wide").name == beside
