from dataclasses import replace
from typing import Any

import pytest

from repro.errors import DeclarationError
from repro.model.cells import computed_cells, every_cell
from repro.model.claims import CellClaim
from repro.model.measures.measure import Computed, Statistic
from repro.model.open_points import Gap
from repro.model.tolerances import Absolute, Percent
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER, TABLE, Bowl

GAP = Gap(what="costs of old", where="Table 2", because="nobody says how it walks")
SIZED = replace(EXPERIMENT, problems={"bowl 2": Bowl(), "bowl 3": Bowl(centre=(0.1, 0.2, 0.3))})
SUMMED = PublishedTable.read("""
    Table 3, p. 4
    problem | statistic || guess | wide
    bowl    | mean      || 0.05  | 0.5
            | std       || 0.02  | 0.4
    Sum     | –         || 0.07  | 0.9
""")


def claimed(table: PublishedTable = TABLE, **changes: Any) -> tuple[CellClaim, ...]:  # noqa: ANN401
    told: dict[str, Any] = {
        "of": EXPERIMENT,
        "rows": ("problem", "statistic"),
        "columns": "algorithm",
        "within": Percent(1),
    }
    return every_cell(table, **(told | changes))


def faults(table: PublishedTable = TABLE, **changes: Any) -> list[str]:  # noqa: ANN401
    with pytest.raises(DeclarationError) as error:
        claimed(table, **changes)
    return str(error.value).splitlines()


def statistics(claims: tuple[CellClaim, ...]) -> list[tuple[str, str, str]]:
    measures = [claim.measure for claim in claims if isinstance(claim.measure, Statistic)]
    return [(each.problem, each.algorithm, each.statistic) for each in measures]


def test_two_row_headings_name_one_problem_together() -> None:
    table = PublishedTable.read("""
        Table 2, p. 4
        F    | Dim | statistic || guess | wide
        bowl | 2   | mean      || 0.05  | 0.5
             | 3   | mean      || 0.06  | 0.6
    """)

    claims = claimed(table, of=SIZED, rows=("problem", "problem", "statistic"))

    assert statistics(claims)[::2] == [("bowl 2", "guess", "mean"), ("bowl 3", "guess", "mean")]


def test_a_row_and_a_column_heading_name_one_problem_that_names_translate() -> None:
    table = PublishedTable.read("""
        Table 2, p. 4
        F  | algorithm || Dim 2 | Dim 3
        F1 | guess     || 0.05  | 0.06
        F1 | wide      || 0.5   | 0.6
    """)

    claims = claimed(
        table,
        of=SIZED,
        rows=("problem", "algorithm"),
        columns="problem",
        given={"statistic": "mean"},
        names={"F1 Dim 2": "bowl 2", "F1": "bowl", "Dim 3": "3"},
    )

    assert statistics(claims)[:2] == [("bowl 2", "guess", "mean"), ("bowl 3", "guess", "mean")]


def test_two_row_names_may_mean_one_problem() -> None:
    table = PublishedTable.read("""
        Table 2, p. 4
        problem | statistic || guess | wide
        bowl    | mean      || 0.05  | 0.5
        F1      | std       || 0.02  | 0.4
    """)

    claims = claimed(table, names={"F1": "bowl"})

    assert {problem for problem, *_ in statistics(claims)} == {"bowl"}


def test_a_whole_row_is_left_to_a_gap_whatever_it_is_of() -> None:
    claims = claimed(SUMMED, without={"Sum": GAP})

    assert [claim.gap for claim in claims] == [None] * 4 + [GAP] * 2
    assert [claim.measure for claim in claims[4:]] == [None] * 2
    paper = replace(PAPER, results=(SUMMED,), claims=claims, gaps=(GAP,))
    assert len(paper.said) == 6


@pytest.mark.parametrize(
    ("name", "left"),
    [
        (("bowl std", "wide"), [("bowl std", "wide")]),
        ("bowl std", [("bowl std", "guess"), ("bowl std", "wide")]),
        ("std", [("bowl std", "guess"), ("bowl std", "wide")]),
        ("wide", [("bowl mean", "wide"), ("bowl std", "wide")]),
    ],
)
def test_a_cell_a_row_a_heading_and_a_column_are_left_to_a_gap(
    name: object, left: list[tuple[str, str]]
) -> None:
    claims = claimed(without={name: GAP})

    assert [(claim.row, claim.column) for claim in claims if claim.gap] == left


def test_the_narrowest_gap_goes_first() -> None:
    own = replace(GAP, what="one cell")

    claims = claimed(without={"wide": GAP, ("bowl std", "wide"): own})

    assert [claim.gap for claim in claims] == [None, GAP, None, own]


def test_every_name_that_a_table_lacks_is_a_line_with_the_names_it_has() -> None:
    told, name, cell, gap = faults(
        only=("bowl mean", "bowl sdt"),
        without={"wied": GAP, ("bowl std", "far"): GAP, "bowl": "no gap"},
    )

    assert told.startswith("Table 1, only: no row 'bowl sdt'; did you mean 'bowl std'? there is")
    assert name.startswith("Table 1, without: no name, heading, row or column 'wied'; did you mean")
    assert name.endswith(
        "'wide'? there is 'bowl', 'mean', 'guess', 'bowl mean', 'wide', 'std', 'bowl std'"
    )
    assert cell.startswith("Table 1, without: no cell ('bowl std', 'far'); did you mean ('bowl ")
    assert gap == "Table 1, without 'bowl': 'no gap' is no Gap"


def test_each_word_that_the_experiment_lacks_is_told_once_in_one_pass() -> None:
    said = faults(SUMMED, names={"guess": "gess", "std": "sdt"})

    assert [fault.partition(" is none of")[0] for fault in said] == [
        "Table 3, row 'bowl mean', column 'guess': algorithm 'gess'",
        "Table 3, row 'bowl std', column 'guess': statistic 'sdt'",
        "Table 3, row 'Sum', column 'guess': problem 'Sum'",
        "Table 3, row 'Sum', column 'guess': statistic ''",
    ]


def test_computed_cells_keep_only_rows_that_there_are() -> None:
    def measure(row: str, column: str) -> Computed:
        raise AssertionError(row, column)

    with pytest.raises(DeclarationError, match="Table 1, only: no row 'bowl'; did you mean"):
        computed_cells(TABLE, measure=measure, within=Absolute(0), only=("bowl",))


def test_headings_that_stand_under_others_name_a_statistic_of_each_algorithm() -> None:
    table = PublishedTable.read("""
        Table 2, p. 4
        problem || guess |        | wide |
                || mean  | std    | mean | std
        bowl    || 0.05  | 0.02   | 0.5  | 0.4
    """)

    claims = claimed(table, rows=("problem",), columns=("algorithm", "statistic"))

    assert statistics(claims) == [
        ("bowl", "guess", "mean"),
        ("bowl", "guess", "std"),
        ("bowl", "wide", "mean"),
        ("bowl", "wide", "std"),
    ]
    assert [claim.column for claim in claims] == [
        "guess mean",
        "guess std",
        "wide mean",
        "wide std",
    ]


@pytest.mark.parametrize("columns", ["algorithm", ("algorithm", "statistic", "problem")])
def test_headings_one_above_the_other_need_a_role_each(columns: object) -> None:
    table = PublishedTable.read("""
        Table 2, p. 4
        problem || guess |
                || mean  | std
        bowl    || 0.05  | 0.02
    """)

    (said,) = faults(table, rows=("problem",), columns=columns)

    assert said.startswith("Table 2 has the column headings ('guess', 'mean'), not one per ")


LEFT = Gap(what="costs of the owl", where="p. 3", because="its equations are not printed")
OWLS = replace(EXPERIMENT, proposed="owl", left_out={"owl": LEFT})
OF_OWLS = PublishedTable.read("""
    Table 4, p. 5
    problem | statistic || guess | wide | owl
    bowl    | mean      || 0.05  | 0.5  | 0.01
            | rank      || 2     | 3    | 1
            | rank-sum p || 0.01 | 0.02 | –
""")


def test_a_proposed_algorithm_that_is_left_out_leaves_what_compares_with_it_to_its_gap() -> None:
    claims = claimed(OF_OWLS, of=OWLS)

    assert [claim.gap for claim in claims] == [None, None, *[LEFT] * 6]
    assert replace(PAPER, experiments=(OWLS,), results=(OF_OWLS,), claims=claims, gaps=(LEFT,))


def test_a_rival_that_is_left_out_leaves_only_its_own_cells_and_ranks_to_its_gap() -> None:
    claims = claimed(OF_OWLS, of=replace(OWLS, proposed="guess"), only=("bowl mean", "bowl rank"))

    assert [claim.gap for claim in claims] == [None, None, LEFT, LEFT, LEFT, LEFT]


def test_an_unknown_problem_is_told_with_the_problems_alone() -> None:
    (said,) = faults(
        SUMMED,
        only=("Sum",),
        without={"wide": GAP, ("bowl std", "wide"): GAP},
        given={},
        names={"Sum": "Sum mean"},
    )[:1]

    assert said.endswith("problem 'Sum mean' is none of bowl")


def test_a_statistic_in_other_letters_is_told_how_names_translate_it() -> None:
    (said,) = faults(names={"mean": "Mean"})

    assert said.endswith("; names={'Mean': 'mean'} translates it")


@pytest.mark.parametrize("word", ["without", "names", "given"])
def test_a_list_in_place_of_a_dict_is_one_line(word: str) -> None:
    given: dict[str, Any] = {word: ["wide"]}

    assert faults(**given) == [f"Table 1, {word} is ['wide']; it must be a dict"]
