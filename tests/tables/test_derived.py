"""Numbers that follow from others: true ones pass, however they are rounded; false ones do not."""

import math
from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from repro.audit import AuditRow, Grade, audit
from repro.errors import DeclarationError
from repro.tables.derived import number_span
from repro.tables.published import Printed, PublishedTable
from repro.tables.relations import (
    ByFormula,
    Equal,
    Less,
    Mean,
    Relation,
    Sum,
    TextNumber,
    Times,
    row_sums,
)
from repro.tables.true_numbers import Span
from tests.summaries import paper_of

BLOCK = {"A": {"mean": "2.000", "std": "1.000"}}
VALUES = st.floats(0.5, 1e4)
DECIMALS = st.integers(0, 4)


def text(number: str, unit: str = "") -> TextNumber:
    return TextNumber(printed=Printed(number, unit), where="section 9")


def rows_of(relation: Relation) -> tuple[AuditRow, ...]:
    return audit(paper_of(BLOCK, n=30, relations=(relation,)))


def printed(value: float, decimals: int) -> TextNumber:
    return text(f"{value:.{decimals}f}")


@given(st.lists(VALUES, min_size=1, max_size=5), DECIMALS, DECIMALS)
def test_a_true_mean_is_never_inconsistent(values: list[float], of: int, to: int) -> None:
    mean = math.fsum(values) / len(values)

    relation = Mean(mean=printed(mean, to), numbers=tuple(printed(v, of) for v in values))

    assert rows_of(relation) == ()


@given(VALUES, VALUES, DECIMALS, DECIMALS)
def test_a_true_ratio_is_never_inconsistent(of: float, to: float, first: int, last: int) -> None:
    relation = Times(printed=printed(of / to, last), of=printed(of, first), to=printed(to, first))

    assert rows_of(relation) == ()


@given(VALUES, VALUES, DECIMALS)
def test_a_true_formula_is_never_inconsistent(a: float, b: float, decimals: int) -> None:
    value = math.sqrt(a * a + b * b) / (a + b) - 0.5

    relation = ByFormula(
        printed=printed(value, decimals),
        formula="sqrt(a * a + b * b) / (a + b) - 0.5",
        numbers={"a": printed(a, decimals), "b": printed(b, decimals)},
    )

    assert rows_of(relation) == ()


@given(VALUES, DECIMALS, DECIMALS)
def test_one_number_printed_twice_is_never_inconsistent(value: float, one: int, other: int) -> None:
    assert rows_of(Equal(numbers=(printed(value, one), printed(value, other)))) == ()


@pytest.mark.parametrize(
    ("relation", "check", "says"),
    [
        (Mean(mean=text("2.5"), numbers=(text("1.0"), text("3.0"))), "mean",
         "(1.0 + 3.0)/2 = 2, between 1.944444444 and 2.1 with every rounding; printed is 2.5"),
        (Times(printed=text("3.2"), of=text("10.0"), to=text("4.0")), "ratio",
         "10.0/4.0 = 2.5, between"),
        (ByFormula(printed=text("30.0", "%"), formula="100 * (old - new) / old",
                   numbers={"new": text("3.00"), "old": text("4.00")}), "formula",
         "100 * (4.00 - 3.00) / 4.00 = 25, between"),
        (Equal(numbers=(text("3.86"), text("3.89"))), "equal",
         "3.86 (section 9) = 3.86, between"),
    ],
)  # fmt: skip
def test_a_false_number_is_found_with_its_arithmetic(
    relation: Relation, check: str, says: str
) -> None:
    (row,) = rows_of(relation)

    assert (row.check, row.grade, row.condition) == (check, Grade.INCONSISTENT, None)
    assert says in row.explanation


def test_what_single_precision_allows_needs_doubles() -> None:
    (row,) = rows_of(Equal(numbers=(text("1234567.8"), text("1234568.0"))))

    assert row.condition == "runs and statistics are kept in double precision"


@given(st.lists(st.integers(0, 40), min_size=2, max_size=10), st.integers(-5, 5))
def test_counts_and_ranks_are_exact(counts: list[int], off: int) -> None:
    for unit in ("count", "rank"):
        relation = Sum(
            total=text(f"{sum(counts) + off}", unit),
            addends=tuple(text(f"{count}", unit) for count in counts),
        )

        assert len(rows_of(relation)) == (off != 0)


def test_whole_numbers_are_exact_where_the_relation_says_so() -> None:
    counts = Sum(total=text("26"), addends=(text("17"), text("2"), text("9")))

    (row,) = rows_of(replace(counts, exact=True))

    assert "17 + 2 + 9 = 28, and no number in it is rounded; printed is 26" in row.explanation
    assert rows_of(counts) == ()  # four rounded numbers may be off by two
    assert rows_of(Less(printed=text("7"), before=text("9"), after=text("3"), exact=True)) != ()


def test_mean_of_whole_ranks_is_rounded_as_it_is_printed() -> None:
    ranks = tuple(text(rank, "rank") for rank in ("1", "2", "4"))

    assert rows_of(Mean(mean=text("2.33", "rank"), numbers=ranks)) == ()
    assert rows_of(Mean(mean=text("2", "rank"), numbers=ranks)) == ()
    assert rows_of(Mean(mean=text("2.36", "rank"), numbers=ranks)) != ()


def test_numbers_of_one_kind_may_be_printed_in_several_units() -> None:
    table = PublishedTable.read("""
        Table 3, p. 3
        method || move [ms] | turn [s] | total [min]
        slow   || 30000     | 90.0     | 2.00
        quick  || 30000     | 90.0     | 3.00
    """)

    rows = [row for sum_of in row_sums(table, total="total", addends=("move", "turn"))
            for row in rows_of(sum_of)]  # fmt: skip

    assert [row.cells[0]["row"] for row in rows] == ["quick"]
    assert "30000 ms + 90.0 s = 2, between" in rows[0].explanation
    assert rows_of(Equal(numbers=(text("90", "deg"), text("1.5708", "rad")))) == ()
    assert rows_of(Times(printed=text("2"), of=text("1.000", "s"), to=text("500.0", "ms"))) == ()


def test_formula_may_be_a_function_of_spans() -> None:
    def product(a: Span, b: Span) -> Span:
        return a * b

    numbers = {"a": text("2.0"), "b": text("3.0")}

    assert rows_of(ByFormula(printed=text("6.1"), formula=product, numbers=numbers)) == ()
    (row,) = rows_of(ByFormula(printed=text("7.0"), formula=product, numbers=numbers))
    assert "the formula of a = 2.0, b = 3.0 = 6, between" in row.explanation


@pytest.mark.parametrize("formula", ["1 / (a - b)", "sqrt(b - a - 9)"])
def test_formula_that_may_have_no_value_says_nothing(formula: str) -> None:
    numbers = {"a": text("2.0"), "b": text("2.0")}

    assert rows_of(ByFormula(printed=text("7.0"), formula=formula, numbers=numbers)) == ()


def test_formula_of_other_names_is_refused() -> None:
    with pytest.raises(DeclarationError, match="has the names a, c; given are a, b"):
        ByFormula(printed=text("1"), formula="a + c", numbers={"a": text("1"), "b": text("1")})


@given(*[st.fractions(-9, 9, max_denominator=8)] * 6)
def test_span_of_a_product_or_quotient_holds_that_of_every_two_numbers(
    a: Fraction, b: Fraction, c: Fraction, d: Fraction, s: Fraction, t: Fraction
) -> None:
    one, other = Span(min(a, b), max(a, b)), Span(min(c, d), max(c, d))
    share, part = abs(s) / 9, abs(t) / 9
    x, y = a + share * (b - a), c + part * (d - c)

    assert (one * other).low <= x * y <= (one * other).high
    assume(not other.low <= 0 <= other.high)
    assert (one / other).low <= x / y <= (one / other).high


@pytest.mark.parametrize("number", ["3", "-12", "1,204"])
def test_whole_number_that_is_exact_is_itself_alone(number: str) -> None:
    around = number_span(Printed(number), whole=True)

    assert around.low == around.high == Fraction(Printed(number).value)


@pytest.mark.parametrize("number", ["3.0", "3e2", "2.33"])
def test_number_with_decimals_or_a_power_is_rounded(number: str) -> None:
    around = number_span(Printed(number), whole=True)

    assert around.low < around.high
