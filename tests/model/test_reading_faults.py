from dataclasses import replace
from typing import Any

import pytest

from repro.errors import DeclarationError
from repro.model.assumptions import Alternative, Assumption
from repro.model.experiment import Experiment
from repro.model.figures import Convergence, Motion
from repro.model.tolerances import Percent
from repro.optimisers import DBO, GA, WOA, HybridWOA
from repro.optimisers.differential_evolution import DE
from repro.optimisers.search import Optimiser
from repro.tables.published import PublishedTable
from repro.tables.relations import Equal, TableCell
from tests.small_papers import CLAIMS, EXPERIMENT, PAPER, TABLE, Guessing

SLOWER = Alternative(says="slower", name="slow", protocol={"search": {"iterations": 9}})
CURVES = Convergence(label="Fig. 1", caption="Costs.", experiment="search")
OTHER = PublishedTable.read("Table 9, p. 3\nx || y\na || 1\nb || 2")


def faults(*alternatives: Alternative, **changes: Any) -> list[str]:  # noqa: ANN401
    assumption = Assumption(
        what="speed", chosen="fast", alternatives=alternatives, because="it is", where="p. 3"
    )
    assumptions = (assumption,) if alternatives else ()
    with pytest.raises(DeclarationError) as error:
        replace(PAPER, assumptions=assumptions, **changes)
    return str(error.value).splitlines()


def corner(cost: Any, bounds: Any, budget: Any, rng: Any) -> Any:  # noqa: ANN401, ARG001
    return bounds[:, 0]


def experiment(**changes: Any) -> Experiment:  # noqa: ANN401
    return replace(EXPERIMENT, **changes)


@pytest.mark.parametrize(
    ("optimiser", "least"),
    [(DE(), 4), (GA(elites=5), 6), (HybridWOA(), 4), (DBO(groups="proportional"), 5), (DBO(), 20)],
)
def test_a_population_is_no_smaller_than_each_search_says_itself(
    optimiser: Optimiser, least: int
) -> None:
    runs = {"guess": optimiser, "wide": Guessing()}

    (said,) = faults(experiments=(experiment(algorithms=runs, population=least - 1),))

    assert said == (
        f"small2020, experiment 'search', algorithm 'guess': population {least - 1} is too small; "
        f"this search needs {least} or more"
    )
    replace(PAPER, experiments=(experiment(algorithms=runs, population=least),))


def test_a_budget_pays_for_an_iteration_of_every_search() -> None:
    algorithms = {"guess": WOA(), "wide": corner}

    assert faults(experiments=(experiment(algorithms=algorithms, evaluations=3),)) == [
        "small2020, experiment 'search', evaluations is 3; one iteration of 'guess' takes 4",
        "small2020, experiment 'search', evaluations is 3; one iteration of 'wide' takes 4",
    ]


def test_what_a_reading_changes_must_be_able_to_run() -> None:
    wrong = [
        ({"protocol": {"search": {"runs": 0, "iteration": 3}}}, "has no 'iteration' to replace"),
        ({"protocol": {"search": {"runs": 0}}}, "experiment 'search', runs is 0; it must be a"),
        ({"algorithms": {("search", "guess"): {"widht": 2.0}}}, "'guess' has no field 'widht'"),
        ({"algorithms": {("search", "guess"): DE()}, "protocol": {"search": {"population": 3}}},
         "population 3 is too small; this search needs 4 or more"),
        ({"problems": {("search", "bowl"): {"centre": ()}}}, "not pairs of shape (n, 2)"),
        ({"problems": {("search", "bowl"): 3}}, "a problem has bounds, kernel, data and identity"),
    ]  # fmt: skip
    alternatives = [
        Alternative(says=f"reading {k}", name=f"r{k}", **changes)  # type: ignore[arg-type]
        for k, (changes, _) in enumerate(wrong)
    ]

    said = faults(*alternatives)

    assert len(said) == len(wrong)
    for k, (fault, (_, words)) in enumerate(zip(said, wrong, strict=True)):
        assert fault.startswith(f"small2020, alternative 'reading {k}': ")
        assert words in fault


def test_claims_of_a_reading_are_checked_as_those_of_the_paper() -> None:
    measure: Any = CLAIMS[0].measure
    unknown = replace(CLAIMS[0], measure=replace(measure, statistic="maen"))
    elsewhere = replace(CLAIMS[0], table=replace(TABLE, label="Table 9"), accepted=Percent(1))
    told = replace(SLOWER, claims=(unknown, elsewhere))

    statistic, place = faults(told)

    assert statistic.startswith(
        "small2020, alternative 'slower': Table 1, bowl mean, guess: no statistic 'maen'; did you"
    )
    assert place == (
        "small2020, alternative 'slower': its claim 'Table 9, bowl mean, guess' takes the place of "
        "none of the paper's"
    )


def test_every_name_of_together_that_is_none_is_a_line_in_words() -> None:
    assert faults(SLOWER, together=("slwo", "fast")) == [
        f"small2020, together: no alternative that changes anything is {words}"
        for words in ("'slwo'; did you mean 'slow'? there is 'slow'", "'fast'; there is 'slow'")
    ]


def test_figures_show_runs_that_there_are() -> None:
    motion = Motion(
        label="Fig. 2", caption="Angles.", problem=object(), experiment="search",  # type: ignore[arg-type]
        algorithms=("gues",),
    )  # fmt: skip

    known = "did you mean 'guess'? there is 'guess', 'wide'"

    assert faults(figures=(replace(CURVES, experiment="serch"), CURVES, motion)) == [
        "small2020, 2 figures are called 'Fig. 1': a label names one figure",
        "small2020, Fig. 1: no experiment 'serch'; did you mean 'search'? there is 'search'",
        f"small2020, Fig. 2: experiment 'search' has no algorithm 'gues'; {known}",
        "small2020, Fig. 2: its problem is none of experiment 'search', which has 'bowl'",
    ]


def test_relations_speak_of_tables_that_the_paper_declares() -> None:
    cells = tuple(TableCell(table=OTHER, row=row, column="y") for row in "ab")

    assert faults(relations=(Equal(numbers=cells),)) == [
        "small2020, Equal: no table 'Table 9'; did you mean 'Table 1'? there is 'Table 1'"
    ]
    replace(PAPER, relations=(Equal(numbers=cells),), inputs=(OTHER,))


@pytest.mark.parametrize("name", ["figures", "relations"])
def test_what_is_no_figure_or_relation_is_said(name: str) -> None:
    (said,) = faults(**{name: (3,)})

    assert said.startswith(f"small2020, {name} 1: ")
    assert (" is no " in said, " or " in said) == (True, True)
