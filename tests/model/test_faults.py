from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from repro.errors import DeclarationError
from repro.model.cells import every_cell
from repro.model.claims import CellClaim
from repro.model.contract import contract_faults
from repro.model.faults import protocol_faults
from repro.model.open_points import Gap
from repro.model.tolerances import Between, Percent
from tests.small_papers import CLAIMS, EXPERIMENT, PAPER, TABLE, Bowl


def faults_of(paper: Any, **changes: Any) -> list[str]:  # noqa: ANN401 (whatever a paper declares)
    with pytest.raises(DeclarationError) as error:
        replace(paper, **changes)
    return str(error.value).splitlines()


def with_first(**changes: Any) -> tuple[CellClaim, ...]:  # noqa: ANN401
    return (replace(CLAIMS[0], **changes), *CLAIMS[1:])


def measuring(**changes: Any) -> tuple[CellClaim, ...]:  # noqa: ANN401
    return with_first(measure=replace(CLAIMS[0].measure, **changes))  # type: ignore[type-var]


def test_all_faults_are_told_at_once_each_on_a_line_of_its_own() -> None:
    wrong = replace(EXPERIMENT, population=0, runs=2.5)  # type: ignore[arg-type]

    said = faults_of(PAPER, experiments=(wrong,), key="a/b")

    assert said == [
        "the key 'a/b' cannot name a file: give letters, digits and _",
        "a/b, experiment 'search', population is 0; it must be a whole number, 1 or more",
        "a/b, experiment 'search', runs is 2.5; it must be a whole number, 1 or more",
    ]


@pytest.mark.parametrize("count", [0, -1, 2.0, True, "3", None])
def test_a_count_is_a_whole_number_above_0(count: object) -> None:
    wrong = replace(EXPERIMENT, runs=count)  # type: ignore[arg-type]

    assert faults_of(PAPER, experiments=(wrong,))[0].endswith(
        "it must be a whole number, 1 or more"
    )


@pytest.mark.parametrize(
    ("claims", "says"),
    [
        (with_first(measure=None), "it needs a measure, or a gap that says why"),
        (with_first(accepted=Between(2.0, 1.0)), "nothing lies in the accepted band from 2 to 1"),
        (with_first(accepted=Percent(float("nan"))), "nothing lies in the accepted band"),
        (with_first(accepted=3), "3 is no tolerance, such as Percent(10)"),
        (measuring(experiment="serch"), "no experiment 'serch'; did you mean 'search'?"),
        (measuring(problem="bowls"), "has no problem 'bowls'; did you mean 'bowl'?"),
        (measuring(algorithm="gues"), "has no algorithm 'gues'; did you mean 'guess'?"),
        (measuring(statistic="maen"), "no statistic 'maen'; did you mean 'mean'?"),
        (measuring(quantity="total"), "problem 'bowl' has no quantity 'total', only the cost"),
    ],
)
def test_a_claim_that_cannot_be_judged_is_named_with_what_there_is(
    claims: tuple[CellClaim, ...], says: str
) -> None:
    (said,) = faults_of(PAPER, claims=claims)

    assert said.startswith("small2020, Table 1, bowl mean, guess: ")
    assert says in said


@pytest.mark.parametrize(
    ("problem", "says"),
    [
        (Bowl, "is a class: give an object of it"),
        (3, "a problem has bounds, kernel, data and identity"),
        (Bowl(centre=()), "not pairs of shape (n, 2)"),
    ],
)
def test_a_problem_that_is_none_is_named(problem: object, says: str) -> None:
    wrong = replace(EXPERIMENT, problems={"bowl": problem})

    assert says in faults_of(PAPER, experiments=(wrong,))[0]


def test_names_with_line_breaks_keep_a_fault_on_its_line() -> None:
    wrong = replace(EXPERIMENT, name="two\nlines\rof\x1b[2J", runs=0)

    assert len(faults_of(PAPER, experiments=(wrong,), claims=(), results=())) == 1


def test_a_protocol_puts_forward_an_algorithm_that_it_runs() -> None:
    wrong = replace(EXPERIMENT, proposed="gues", problems={})

    assert list(protocol_faults(EXPERIMENT)) == []
    empty, unknown = protocol_faults(wrong)
    assert empty == "experiment 'search' has no problems: leave out an experiment that runs nothing"
    assert unknown.endswith("no algorithm of it; did you mean 'guess'? there is 'guess', 'wide'")


def test_lists_and_arrays_are_taken_where_tuples_are_meant() -> None:
    taken = replace(PAPER, claims=list(CLAIMS), experiments=np.array([EXPERIMENT]))  # type: ignore[arg-type]

    assert (taken.claims, taken.experiments) == (CLAIMS, (EXPERIMENT,))
    assert faults_of(PAPER, claims=3) == ["small2020, claims is 3, not a tuple"]


def test_a_role_that_no_cell_has_is_refused_with_the_known_ones() -> None:
    rows: Any = ("problem", "dimension")

    with pytest.raises(DeclarationError, match="Table 1: no role 'dimension'; there is problem"):
        every_cell(TABLE, of=EXPERIMENT, rows=rows, columns="algorithm", within=Percent(1))


LEFT = Gap(what="costs of the owl", where="p. 3", because="its equations are not printed")


def test_a_proposed_algorithm_may_be_one_that_is_left_out_to_a_gap() -> None:
    owls = replace(EXPERIMENT, proposed="owl", left_out={"owl": LEFT})

    assert list(protocol_faults(owls)) == []
    assert list(contract_faults(replace(PAPER, experiments=(owls,), gaps=(LEFT,)))) == []
    (said,) = contract_faults(replace(PAPER, experiments=(owls,)))
    assert said.endswith("its gap 'costs of the owl' is not among the paper's gaps")


def test_what_is_left_out_is_left_to_a_gap_and_not_run_besides() -> None:
    left: Any = {"owl": "no gap", "wide": LEFT}
    wrong = replace(EXPERIMENT, left_out=left)

    assert faults_of(PAPER, experiments=(wrong,)) == [
        "small2020, experiment 'search', left_out 'owl': 'no gap' is no Gap",
        "small2020, experiment 'search', left_out: 'wide' is one of its algorithms, too",
    ]


def test_a_claim_on_an_algorithm_that_is_left_out_is_told_to_be_left_to_its_gap() -> None:
    owls = replace(EXPERIMENT, proposed="owl", left_out={"owl": LEFT})

    (said,) = faults_of(PAPER, experiments=(owls,), claims=measuring(algorithm="owl"))

    assert "'owl' of experiment 'search' is left out, so nothing is measured of it" in said


@pytest.mark.parametrize("name", ["algorithms", "problems", "left_out"])
def test_a_list_in_place_of_a_dict_is_refused_with_what_is_meant(name: str) -> None:
    given: Any = {name: ["WOA"]}

    with pytest.raises(DeclarationError, match=f"search, {name} is .'WOA'.; it must be a dict: "):
        replace(EXPERIMENT, **given)
