from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from repro.errors import DeclarationError
from repro.model import (
    WOA_BY_EQUATIONS,
    WOA_BY_VECTORS,
    WOA_READINGS,
    Gap,
    Paper,
    everywhere,
    prose,
    woa_readings,
)
from repro.optimisers import WOA, Optimiser
from tests.small_papers import EXPERIMENT
from tests.small_papers import PAPER as SMALL

TEXT = """
summary = "A bowl has a bottom."
together = ["wider", "narrower"]

[source]
authors = "Jane Doe"
title = "Bowls"

[[assumption]]
what = "width"
where = "p. 3"
chosen = "ours"
because = "so"
[[assumption.or]]
name = "wider"
says = "three times"
[[assumption.or]]
name = "narrower"
says = "a third"
[[assumption.or]]
says = "none"
untried = "nothing to try"

[[gap]]
name = "speed"
what = "how fast"
where = "p. 4"
because = "no time is printed"

[[formula]]
label = "Eq. (1)"
where = "p. 2"
latex = '''x^2
    + 1'''
says = "A square."
code = "repro.functions"
"""
CHANGES = {
    "wider": {"algorithms": {("search", "guess"): {"width": 3.0}}},
    "narrower": {"algorithms": {("search", "guess"): {"width": 0.3}}},
}


WITH_WOA = replace(EXPERIMENT, algorithms={"WOA": WOA()})


def module(folder: Path, text: str = TEXT, name: str = "doe2021") -> str:
    """Return where a module beside such prose would stand."""
    (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    return str(folder / f"{name}.py")


def paper(place: str, changes: dict[str, Any] = CHANGES) -> Paper:
    return prose(place).paper(
        changes=changes,
        experiments=SMALL.experiments,
        inputs=(),
        results=SMALL.results,
        claims=SMALL.claims,
    )


def test_paper_is_the_prose_beside_its_module_and_what_the_module_declares(tmp_path: Path) -> None:
    found = paper(module(tmp_path))

    assert (found.key, found.source.title, found.together) == (
        "doe2021", "Bowls", ("wider", "narrower"),
    )  # fmt: skip
    assert found.gaps == (Gap(what="how fast", where="p. 4", because="no time is printed"),)
    (assumption,) = found.assumptions
    assert [each.name for each in assumption.alternatives] == ["wider", "narrower", ""]
    assert assumption.alternatives[0].algorithms == CHANGES["wider"]["algorithms"]
    assert found.formulas[0].latex == "x^2\n+ 1"  # indented in the file alone
    assert found.claims == SMALL.claims


def test_a_package_has_its_prose_under_its_own_name(tmp_path: Path) -> None:
    folder = tmp_path / "roe2022"
    folder.mkdir()
    module(folder, name="roe2022")

    assert prose(str(folder / "__init__.py")).key == "roe2022"


def test_gap_is_found_by_its_name_and_another_is_refused_with_those_that_there_are(
    tmp_path: Path,
) -> None:
    text = prose(module(tmp_path))

    assert text.gap("speed").what == "how fast"
    with pytest.raises(DeclarationError, match=r"doe2021.toml: no gap 'sped'; there is speed"):
        text.gap("sped")


@pytest.mark.parametrize(
    ("wrong", "right", "message"),
    [
        ("[source]", "[sauce]", r"doe2021.toml: sauce means nothing here; known: summary, toget"),
        (
            'because = "so"',
            'why = "so"',
            r"assumption 'width': 'why' means nothing here; it has wh",
        ),
        ('where = "p. 4"\n', "", r"doe2021.toml, gap 1: 'where' is missing; it has what, where"),
        ('authors = "Jane Doe"\n', "", r"doe2021.toml, source: 'authors' is missing; it has auth"),
        ('authors = "Jane Doe"', "authors = 4", r"doe2021.toml, source, authors is 4: it must be"),
        ('says = "a third"', 'say = "a third"', r"'width', alternative 2: 'say' means nothing he"),
        ('says = "a third"', 'says = " "', r"alternative 2, says is ' ': it must be a text"),
        ('name = "speed"', 'name = ["speed"]', r"gap 1, name is \['speed'\]: it must be a text"),
        ('name = "wider"', 'name = ["wider"]', r"alternative 1, name is \['wider'\]: it must be a"),
        (
            "[[gap]]",
            "[gap]",
            r"gap is \{'.*write \[\[gap\]\], in two pairs of brackets, ",
        ),
        ("[source]", "[[source]]", r"source is \[\{.*: it stands once, as \[source\]"),
        (
            "[[gap]]",
            '[[gap]]\nname = "speed"\nwhat = "w"\nwhere = "p"\nbecause = "b"\n[[gap]]',
            r"doe2021.toml, gap 2: another gap is called 'speed' too",
        ),
        ('together = ["wider", "narrower"]', 'together = "wider"', r"together is 'wider', not a l"),
        ('summary = "A bowl has a bottom."', "", r"doe2021.toml, summary is not there: it must be"),
        ('summary = "', "summary = ", r"doe2021.toml cannot be read: Invalid value"),
    ],
)
def test_a_slip_in_the_prose_is_named_with_its_place(
    tmp_path: Path, wrong: str, right: str, message: str
) -> None:
    place = module(tmp_path, TEXT.replace(wrong, right, 1))

    with pytest.raises(DeclarationError, match=message):
        paper(place)


def test_a_module_without_prose_says_where_it_was_looked_for(tmp_path: Path) -> None:
    with pytest.raises(DeclarationError, match=r"lost.toml is not there: the prose of a "):
        prose(str(tmp_path / "lost.py"))


def test_changes_that_no_alternative_has_are_refused(tmp_path: Path) -> None:
    with pytest.raises(
        DeclarationError,
        match=r"changes of 'wilder', which no alternative is; there is 'wider', 'narrower'",
    ):
        paper(module(tmp_path), {**CHANGES, "wilder": {}})


def test_an_alternative_that_changes_nothing_and_says_not_why_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DeclarationError, match="'a third' needs either something that it changes"):
        paper(module(tmp_path), {"wider": CHANGES["wider"]})


def test_readings_of_woa_change_it_wherever_it_runs_and_nothing_else() -> None:
    name = "WOA by its equations, numbers"
    found = woa_readings([EXPERIMENT], name, algorithm="guess")

    assert found == {name: {"algorithms": {("search", "guess"): WOA_BY_EQUATIONS}}}
    assert everywhere([EXPERIMENT], "nobody", {}) == {}


@pytest.mark.parametrize(
    ("default", "its_own"),
    [
        (WOA(), "WOA's program"),
        (WOA_BY_EQUATIONS, "WOA by its equations, numbers"),
        (WOA_BY_VECTORS, "WOA by its equations, vectors"),
    ],
    ids=repr,
)
def test_what_a_paper_takes_for_woa_is_no_other_reading_of_it(
    default: Optimiser, its_own: str
) -> None:
    found = woa_readings([replace(WITH_WOA, algorithms={"WOA": default})])

    assert WOA_READINGS.keys() - found.keys() == {its_own}


def test_a_reading_of_woa_keeps_what_it_says_nothing_of() -> None:
    by_vectors = replace(WITH_WOA, algorithms={"WOA": WOA_BY_VECTORS})

    found = woa_readings([by_vectors], "reflection")

    assert found["reflection"] == {
        "algorithms": {("search", "WOA"): WOA_BY_VECTORS(bounds="reflect")}
    }


def test_a_source_that_is_no_table_is_refused(tmp_path: Path) -> None:
    text = 'source = "Bowls"\nsummary = "A bowl has a bottom."'

    with pytest.raises(
        DeclarationError, match=r"doe2021.toml, source is 'Bowls': it stands once, as \[source"
    ):
        prose(module(tmp_path, text))
