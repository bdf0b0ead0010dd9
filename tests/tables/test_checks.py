"""What a table alone says: one block, or one fact, a test."""

from collections.abc import Mapping
from fractions import Fraction

import pytest

from repro.tables.arithmetic import IN_DOUBLES
from repro.tables.blocks import Block, FunctionBounds, known_minimum
from repro.tables.checks import fact_rows, rows_of_blocks
from repro.tables.facts import Decision, RankedRows, Success, WinsAndLosses
from repro.tables.order import ONE_DEFINITION
from repro.tables.printed import Printed
from repro.tables.relations import PlacedNumber
from repro.tables.rows import AuditRow, Grade

ERRORS = known_minimum("an error", Fraction(0))


def cell(text: str, row: str = "F1", column: str = "A") -> PlacedNumber:
    return PlacedNumber(printed=Printed(text), label="t", row=row, column=column)


def block_of(
    cells: Mapping[str, str],
    *,
    n: int = 30,
    function: FunctionBounds | None = None,
    maximise: bool = False,
    whole_numbers: bool = False,
) -> Block:
    return Block(
        problem_name="F1",
        algorithm="A",
        quantity="cost",
        n=n,
        cells={name: cell(text, column=name) for name, text in cells.items()},
        scientific=any("e" in text for text in cells.values()),
        function=function,
        maximise=maximise,
        whole_numbers=whole_numbers,
    )


def found(*blocks: Block) -> list[tuple[str, str]]:
    rows = rows_of_blocks("doe", blocks)
    return [(row.check, row.grade.value) for row in rows]


def told(fact: WinsAndLosses | Success | Decision | RankedRows) -> list[AuditRow]:
    return list(fact_rows("doe", fact))


RISING = {"worst": "1175", "mean": "1187", "best": "1190"}


def test_where_every_block_is_reversed_the_sense_is_asked_and_nobody_accused() -> None:
    assert found(block_of(RISING), block_of(RISING | {"best": "1192"})) == [
        ("maximisation", "noted")
    ]


def test_a_block_that_maximises_has_its_greatest_run_as_its_best() -> None:
    assert found(block_of(RISING, maximise=True)) == []
    swapped = block_of(RISING | {"mean": "1193"}, maximise=True)
    assert found(swapped) == [("mean-bound", "impossible")]


def test_one_reversed_block_among_upright_ones_is_out_of_order() -> None:
    upright = block_of({"best": "1.5", "mean": "2.5", "worst": "3.5"})
    reversed_one = block_of({"best": "9.5", "mean": "8.5", "worst": "7.5"})
    assert ("order", "impossible") in found(upright, reversed_one)


@pytest.mark.parametrize("name", ["best", "mean", "median", "q3", "worst"])
def test_a_ceiling_bounds_every_statistic_that_is_a_value(name: str) -> None:
    ceiling = FunctionBounds(
        title="Sphere",
        minimum=Fraction(0),
        floor=Fraction(0),
        floor_in_singles=Fraction(0),
        ceiling=Fraction(300000),
    )
    assert found(block_of({name: "2.99e+10"}, function=ceiling)) == [
        ("above-ceiling", "impossible")
    ]
    assert found(block_of({name: "2.99e+05"}, function=ceiling)) == []


def test_a_floor_alone_bounds_the_std_beside_a_mean() -> None:
    cells = {"mean": "1.00e+01", "std": "1.00e+03"}
    assert found(block_of(cells, n=51, function=ERRORS)) == [("std-bound", "impossible")]
    assert found(block_of(cells | {"std": "7.00e+01"}, n=51, function=ERRORS)) == []
    assert found(block_of(cells, n=51)) == []


@pytest.mark.parametrize(("std", "holds"), [("1", False), ("80", False), ("92", True)])
def test_mean_and_median_lie_no_further_apart_than_the_std(std: str, *, holds: bool) -> None:
    rows = found(block_of({"mean": "100", "median": "10", "std": std}))
    assert (rows == []) is holds
    assert {check for check, _ in rows} <= {"quantile-bound"}


def test_a_quartile_holds_the_mean_between_what_best_and_worst_allow() -> None:
    cells = {"best": "0.00", "q3": "9.00", "worst": "10.00"}
    assert found(block_of(cells | {"mean": "1.00"})) == [("quantile-mean", "impossible")]
    assert found(block_of(cells | {"mean": "5.00"})) == []


def test_the_mean_of_whole_numbers_is_a_whole_sum_over_n() -> None:
    assert found(block_of({"mean": "3.48"}, n=28, whole_numbers=True)) == [
        ("whole-mean", "impossible")
    ]
    assert found(block_of({"mean": "3.46"}, n=28, whole_numbers=True)) == []


def test_the_spread_of_whole_numbers_comes_from_a_whole_sum_of_squares() -> None:
    cells = {"mean": "2.000", "std": "1.000"}  # of 1, 2, 3
    assert found(block_of(cells, n=3, whole_numbers=True)) == []
    assert found(block_of(cells | {"std": "1.200"}, n=3, whole_numbers=True)) == [
        ("whole-std", "impossible")
    ]


def test_a_variance_and_a_standard_error_say_a_standard_deviation() -> None:
    ends = {"best": "1.00", "worst": "3.00"}
    assert found(block_of(ends | {"variance": "1.0"})) == []
    assert found(block_of(ends | {"variance": "9.0"})) == [("std-bound", "impossible")]
    assert found(block_of(ends | {"standard error": "0.90"})) == [("std-bound", "impossible")]


def test_nearly_equal_runs_may_have_any_spread_that_single_precision_gives() -> None:
    cells = {"best": "1000.00", "worst": "1001.00", "std": "0.00"}
    (row,) = rows_of_blocks("doe", [block_of(cells)])
    assert (row.grade, row.is_proof) == (Grade.IMPOSSIBLE, False)


@pytest.mark.parametrize(("problems", "checks"), [(26, ["tally"]), (28, []), (None, [])])
def test_wins_ties_and_losses_are_those_of_all_problems(
    problems: int | None, checks: list[str]
) -> None:
    tally = WinsAndLosses(wins=cell("17"), ties=cell("2"), losses=cell("9"), problems=problems)
    assert [row.check for row in told(tally)] == checks


def test_where_all_runs_succeed_none_ends_above_the_threshold() -> None:
    block = block_of({"mean": "9.32e+03"}, function=ERRORS)
    success = Success(
        rate=cell("100"), runs=30, threshold=Fraction(1, 10**4), block=block, percent=True
    )
    assert [row.check for row in told(success)] == ["success-threshold"]


def test_a_success_rate_is_a_share_of_the_runs() -> None:
    assert [row.check for row in told(Success(rate=cell("98.0"), runs=30))] == ["success-rate"]
    assert told(Success(rate=cell("96.7"), runs=30)) == []


@pytest.mark.parametrize(
    ("p", "rejects", "conditions"),
    [
        ("0.022972544", False, [None]),
        ("0.03", False, ["p and the decision are of the same number of sides"]),
        ("0.022972544", True, []),
        ("0.2", True, [None]),
    ],
)
def test_a_decision_follows_from_p_and_the_level(
    p: str, *, rejects: bool, conditions: list[str | None]
) -> None:
    rows = told(Decision(p=cell(p), rejects=rejects, sides=1))
    assert [row.condition for row in rows] == conditions


def test_z_gives_p_and_the_effect_size() -> None:
    assert told(Decision(p=cell("0.0500"), z=cell("-1.96"), r=cell("0.358"), n=30)) == []
    rows = told(Decision(p=cell("0.5"), z=cell("-1.96"), r=cell("0.9"), n=30))
    assert [row.check for row in rows] == ["p-z", "effect-size"]


def test_p_of_a_sign_test_follows_from_wins_and_losses() -> None:
    tally = WinsAndLosses(wins=cell("9"), ties=None, losses=cell("1"))
    assert told(Decision(p=cell("0.0215"), tally=tally)) == []
    assert [row.check for row in told(Decision(p=cell("0.3"), tally=tally))] == ["sign-test"]


def test_a_sum_of_whole_ranks_is_exact() -> None:
    ranks = tuple({"A": cell("1"), "B": cell("2")} for _ in range(10))
    right = RankedRows(ranks=ranks, sums={"A": cell("10"), "B": cell("20")})
    wrong = RankedRows(ranks=ranks, sums={"A": cell("11"), "B": cell("20")})
    assert told(right) == []
    assert [row.check for row in told(wrong)] == ["rank-sum"]


@pytest.mark.parametrize("ranks", [("2", "2"), ("3", "3"), ("2.5", "2.5"), ("2", "3")])
def test_equal_values_may_share_ranks_in_any_way(ranks: tuple[str, str]) -> None:
    values = {"A": cell("1.0"), "B": cell("4.0"), "C": cell("4.0")}
    printed = {"A": cell("1"), "B": cell(ranks[0]), "C": cell(ranks[1])}
    assert told(RankedRows(values=(values,), ranks=(printed,))) == []


def test_a_rank_that_no_order_of_the_values_gives_is_told() -> None:
    values = {"A": cell("1.0"), "B": cell("2.0")}
    printed = {"A": cell("2"), "B": cell("1")}
    assert [row.check for row in told(RankedRows(values=(values,), ranks=(printed,)))] == ["rank"]


@pytest.mark.parametrize(
    ("cells", "rate"),
    [
        ({"best": "1.00000002e-1"}, "76"),  # 0.1 as a float of single precision
        ({"mean": "422889.96875", "worst": "422889.90625"}, "0"),  # a mean of equal floats
    ],
)
def test_a_success_is_one_in_the_precision_of_the_runs(cells: dict[str, str], rate: str) -> None:
    block = block_of(cells, n=50, function=ERRORS)
    rows = told(Success(rate=cell(rate), runs=50, threshold=Fraction(1, 10), block=block))

    assert all(row.condition and IN_DOUBLES in row.condition for row in rows)


@pytest.mark.parametrize(("n", "condition"), [(2, ONE_DEFINITION), (8, None)])
def test_quartiles_and_median_of_two_definitions_cross_only_where_few_runs_let_them(
    n: int, condition: str | None
) -> None:
    block = block_of({"median": "6.67e-08", "q3": "8.07e-10"}, n=n)  # the upper and the lower run
    rows = list(rows_of_blocks("doe", [block]))

    assert [(row.check, row.condition) for row in rows] == [("order", condition)]


@pytest.mark.parametrize(
    ("cells", "n"),
    [
        ({"worst": "1.98e-22", "mean": "5.82e-24", "standard error": "6.42e-24"}, 34),
        ({"worst": "1.475e-21", "mean": "3.686e-23", "variance": "5.465e-44"}, 40),
    ],
)
def test_a_variance_of_floats_below_their_normal_range_is_a_coarse_one(
    cells: dict[str, str], n: int
) -> None:
    rows = list(rows_of_blocks("doe", [block_of({"best": "0.00e+00"} | cells, n=n)]))

    assert [(row.check, row.condition) for row in rows] == [("std-bound", IN_DOUBLES)]
