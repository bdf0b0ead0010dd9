import math
import re
from decimal import Decimal
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.errors import DeclarationError
from repro.tables.published import UNITS, Printed, PublishedTable
from repro.tables.read_published import read_published

TIMES = """
    Table VI, p. 9 (50 runs)
    Method | t1 [s] | t2 [s]
    WOA    | 3.26   | 2.48
    IWOA   | 2.76   | 1.93
"""


@pytest.mark.parametrize(
    ("text", "value", "rounding"),
    [
        ("4.69", 4.69, 0.005),
        ("0", 0.0, 0.5),
        ("100", 100.0, 0.5),
        ("+2.50", 2.5, 0.005),
        ("1.474×10", 14.74, 0.005),
        ("2.721×10^1", 27.21, 0.005),
        ("7.91×10^-74", 7.91e-74, 0.005e-74),
        ("7.91×10^−74", 7.91e-74, 0.005e-74),
        ("0.00×10^0", 0.0, 0.005),
        ("3 x 10^2", 300.0, 50.0),
        ("4.65E-05", 4.65e-5, 0.005e-5),
        ("1.2e+3", 1200.0, 50.0),
        ("1.2E-3 ", 1.2e-3, 0.05e-3),
        ("−1.2", -1.2, 0.05),
        ("π", math.pi, 0.0),
        ("-π/2", -math.pi / 2, 0.0),
        ("−3π/4", -3 * math.pi / 4, 0.0),
        ("4/30", 4 / 30, 0.0),
        ("1,234.5", 1234.5, 0.05),
    ],
)
def test_printed_text_gives_value_and_half_of_its_last_digit(
    text: str, value: float, rounding: float
) -> None:
    printed = Printed(text)

    assert printed.value == pytest.approx(value, rel=1e-15)
    assert printed.rounding == pytest.approx(rounding, rel=1e-15)


@given(
    st.floats(allow_nan=False, allow_infinity=False, min_value=-1e300, max_value=1e300),
    st.integers(0, 15),
    st.sampled_from(["e", "E", "×10^", " x 10^"]),
)
def test_number_that_was_printed_lies_within_the_rounding(
    number: float, decimals: int, times: str
) -> None:
    text = f"{number:.{decimals}e}"
    mantissa, _, power = text.partition("e")

    printed = Printed(f"{mantissa}{times}{power}")

    assert printed.value == float(text)
    distance = abs(Fraction(number) - Fraction(Decimal(text)))
    assert distance <= Fraction(10) ** (int(power) - decimals) / 2
    # smaller roundings than the smallest double are printed by nobody
    if abs(number) > 1e-290:
        assert printed.rounding == pytest.approx(float(f"5e{int(power) - decimals - 1}"))


@pytest.mark.parametrize(
    "text",
    [
        "3,26",
        "",
        "N/A",
        "nan",
        "inf",
        "1.2.3",
        "1e",
        "--1",
        "1 2",
        "10^",
        "π/0",
        "1.5π",
        "0.5 q",
        "0,123",
    ],
)
def test_text_that_is_no_number_is_refused(text: str) -> None:
    with pytest.raises(DeclarationError, match="is not a number"):
        Printed(text)


def test_fault_in_a_cell_is_named_with_table_and_row() -> None:
    with pytest.raises(DeclarationError, match=r"^Table VI, row 'WOA': '3,26' is not a number$"):
        PublishedTable.read(TIMES.replace("3.26", "3,26"))


def test_unknown_unit_is_named_with_the_known_ones() -> None:
    with pytest.raises(DeclarationError, match=r"Table VI, heading 't1 \[mile\]'.*'mile'") as error:
        PublishedTable.read(TIMES.replace("t1 [s]", "t1 [mile]"))

    assert all(unit in str(error.value) for unit in UNITS)


def test_unknown_unit_of_a_single_number_is_named_with_the_known_ones() -> None:
    with pytest.raises(DeclarationError, match=r"3: unknown unit 'furlong'; known: .*rad/s\^2"):
        Printed("3", "furlong")


@pytest.mark.parametrize(("line", "cells"), [("IWOA | 2.76", 1), ("IWOA | 2 | 3 | 4", 3)])
def test_ragged_row_is_named_with_both_counts(line: str, cells: int) -> None:
    wrong = rf"^Table VI, row 'IWOA': 1 \+ {cells} cells, but the heading has 1 \+ 2$"
    with pytest.raises(DeclarationError, match=wrong):
        PublishedTable.read(TIMES.replace("IWOA   | 2.76   | 1.93", line))


def test_repeated_row_is_refused() -> None:
    with pytest.raises(DeclarationError, match="Table VI: 'WOA' stands there twice"):
        PublishedTable.read(TIMES.replace("IWOA", "WOA "))


def test_repeated_column_is_refused() -> None:
    with pytest.raises(DeclarationError, match="Table VI: 't1' stands there twice"):
        PublishedTable.read(TIMES.replace("t2", "t1"))


@pytest.mark.parametrize(
    ("page", "fault"),
    [
        ("", "is no table"),
        ("Table 1, p. 2\nrow | value", "is no table"),
        ("Table 1, p. 2\nrow, value\na | 1", "no '|' in the line 'row, value'"),
        ("Table 1, p. 2\nrow | value\na 1", "no '|' in the line 'a 1'"),
        ("Table 1, p. 2\nrow | [s]\na | 1", "heading '[s]' is not"),
        ("Table 1, p. 2\nrow | value\n | 1", "a blank heading has none above it"),
    ],
)
def test_page_that_is_no_table_is_refused(page: str, fault: str) -> None:
    with pytest.raises(DeclarationError) as error:
        PublishedTable.read(page)

    assert fault in str(error.value)


def test_blank_row_heading_repeats_the_one_above() -> None:
    table = PublishedTable.read("""
        Table II, section III-D
        No. | Index || IWOA
        F1  | Best  || 0
            | Worst || 1.5
        F5  | Best  || 2
    """)

    assert table.headings == ("No.", "Index")
    assert table.row_names == ("F1 Best", "F1 Worst", "F5 Best")


def test_label_is_what_stands_before_the_comma_of_the_place() -> None:
    table = PublishedTable.read(TIMES)

    assert (table.label, table.where) == ("Table VI", "Table VI, p. 9 (50 runs)")


def test_cells_are_found_by_row_and_column_and_keep_their_text() -> None:
    cell = PublishedTable.read(TIMES)["IWOA", "t2"]

    assert cell == Printed("1.93", "s")


def test_unknown_place_is_named_with_the_known_ones() -> None:
    table = PublishedTable.read(TIMES)

    with pytest.raises(DeclarationError, match="Table VI has no row 'PSO'; it has 'WOA', 'IWOA'"):
        table["PSO", "t1"]
    with pytest.raises(DeclarationError, match="Table VI has no column 't3'; it has 't1', 't2'"):
        table["WOA", "t3"]


def test_columns_and_points_are_in_si_units() -> None:
    table = PublishedTable.read("""
        Table 5, p. 12
        joint | d [mm] | range [deg] | peak [deg/s^3] | share [%]
        1     | 490    | 180         | -90            | 50
        2     | -1     | 0           | 360            | 100
    """)

    assert table.column("d") == pytest.approx((0.49, -0.001))
    assert table.column("range") == pytest.approx((math.pi, 0))
    assert table.points()[0] == pytest.approx((0.49, math.pi, -math.pi / 2, 50))


def test_words_are_no_numbers() -> None:
    table = PublishedTable.read("""
        Table III, p. 5
        joint | angle [text] | d [mm]
        1     | θ1           | 490
    """)

    assert list(table.places()) == [("1", "d")]
    with pytest.raises(DeclarationError, match="column 'angle': 'θ1' is not a number"):
        table["1", "angle"]


def test_mark_of_significance_after_a_slash_does_not_change_the_number() -> None:
    assert Printed("8.24×10^-6/+").value == 8.24e-6
    assert Printed("0.002/=").rounding == 0.0005
    with pytest.raises(DeclarationError, match="is not a number"):
        Printed("0.002/p")


def test_dash_is_an_empty_cell_or_heading() -> None:
    table = PublishedTable.read("""
        Table 3, p. 7
        No. | Index || WOA | GA
        F1  | Mean  || 1   | 2
        p   | –     || –   | 0.03
    """)

    assert table.row_names == ("F1 Mean", "p")
    assert table.rows[1] == ("p", "")
    assert list(table.places()) == [("F1 Mean", "WOA"), ("F1 Mean", "GA"), ("p", "GA")]
    with pytest.raises(DeclarationError, match="row 'p', column 'WOA': '' is not a number"):
        table["p", "WOA"]


NUMBERS = st.decimals(allow_nan=False, allow_infinity=False, places=3).map(str)


@given(st.integers(1, 4).flatmap(lambda n: st.lists(st.lists(NUMBERS, min_size=n, max_size=n))))
def test_what_is_drawn_is_read_cell_by_cell(rows: list[list[str]]) -> None:
    rows = [*rows, rows[0] if rows else ["1"]]
    headings = [f"c{j} [s]" for j in range(len(rows[0]))]
    lines = [" | ".join([f"r{i}", *row]) for i, row in enumerate(rows)]

    table = PublishedTable.read("\n".join(["Table 1", " | ".join(["", *headings]), *lines]))

    read = [table[place].text for place in table.places()]
    assert read == [text for row in rows for text in row]
    assert [list(row) for row in table.points()] == [[float(text) for text in r] for r in rows]


def test_unit_behind_a_number_is_the_numbers() -> None:
    assert Printed("90°").si == pytest.approx(math.pi / 2)
    assert Printed("98%") == Printed("98%", "%")
    assert Printed("90°", "deg").unit == "deg"
    with pytest.raises(DeclarationError, match=r"^'90°' is in °, but its place says rad$"):
        Printed("90°", "rad")


def test_lost_sign_of_an_exponent_is_said() -> None:
    with pytest.raises(DeclarationError, match=r"sign was lost in copying: 10111 .* or 10\^-11$"):
        Printed("2.51×10111")


OF_UNITS = """
    Table 4, p. 9
    quantity    | statistic || PSO [12] | winner [text]
    time [ms]   | mean      || 3.5      | PSO
                | std       || 0.5      | –
    error [deg] | worst     || 90       | –
    runs        | –         || 30       | –
"""


def test_row_heading_may_name_the_unit_of_its_row() -> None:
    table = PublishedTable.read(OF_UNITS.replace("PSO [12]", "PSO"))

    assert table.row_names == ("time mean", "time std", "error worst", "runs")
    assert table.column("PSO") == pytest.approx((3.5e-3, 5e-4, math.pi / 2, 30.0))
    assert table.row_units == ("ms", "ms", "deg", "")
    assert table.cells[0][1] == "PSO"


def test_number_of_a_reference_behind_a_row_heading_is_part_of_the_name() -> None:
    table = PublishedTable.read("Table 5\n| x\nPSO [3, 12] | 1\nGA [7–9] | 2")

    assert table.row_names == ("PSO [3, 12]", "GA [7–9]")
    assert table.row_units == ()


@pytest.mark.parametrize(
    ("page", "message"),
    [
        ("T\n| x\ntime [fortnight] | 1", "heading 'time \\[fortnight\\]': unknown unit"),
        ("T\n| x [s]\ntime [ms] | 1", "row 'time': its unit is ms, but column 'x' is in s"),
        ("T\na | b || x\nt [ms] | m [s] || 1", "two units, ms and s"),
        ("T\n| x\ntime [ms] | 1 s", "'1 s' is in s, but its place says ms"),
    ],
)
def test_unit_of_a_row_that_cannot_be_is_refused(page: str, message: str) -> None:
    with pytest.raises(DeclarationError, match=message):
        PublishedTable.read(page)


def test_headings_may_stand_under_others_that_are_blank_where_they_go_on() -> None:
    table = PublishedTable.read("""
        Table 1, p. 2
        F  | Dim || WOA  |          | Time [ms]
           |     || Best | Mean [s] | –
        F1 | 30  || 1    | 2        | 3
    """)

    assert [(each.name, each.unit) for each in table.columns] == [
        ("WOA Best", ""), ("WOA Mean", "s"), ("Time", "ms"),
    ]  # fmt: skip
    assert [each.levels for each in table.columns] == [
        ("WOA", "Best"), ("WOA", "Mean"), ("Time", ""),
    ]  # fmt: skip
    assert table["F1 30", "WOA Mean"].text == "2"


@pytest.mark.parametrize(
    ("upper", "lower", "says"),
    [
        ("      | WOA ", "Best | Mean", "headings ' | WOA': each of the 2 columns needs one"),
        ("WOA   |     ", "Best |     ", "headings 'Best | ': each of the 2 columns needs one"),
        ("WOA   |     ", "Best       ", "headings 'Best': each of the 2 columns"),
        ("WOA [s] |   ", "Best [ms] | Mean", "heading 'WOA [s] Best [ms]': two units, s and ms"),
        ("WOA   |     ", "Best | Best", "'WOA Best' stands there twice"),
    ],
)
def test_headings_under_others_that_cannot_be_read_are_shown(
    upper: str, lower: str, says: str
) -> None:
    page = f"""
        Table 1, p. 2
        F  || {upper}
           || {lower}
        F1 || 1 | 2
    """

    with pytest.raises(DeclarationError, match=re.escape(says)):
        PublishedTable.read(page)


def test_a_table_with_headings_under_others_is_read_as_one_with_them_in_its_rows() -> None:
    table = PublishedTable.read("""
        Table 1, p. 2 (10 runs)
        F  || WOA       |           | PSO       |
           || Mean      | Std       | Mean      | Std
        F1 || 1.660E-04 | 1.106E+00 | 1.660E-04 | 1.106E+00
    """)

    found = [
        (entry.problem, entry.algorithm, entry.number.column)
        for entry in read_published(table).entries
    ]

    assert found == [
        ("F1", "WOA", "WOA Mean"), ("F1", "WOA", "WOA Std"),
        ("F1", "PSO", "PSO Mean"), ("F1", "PSO", "PSO Std"),
    ]  # fmt: skip


def test_a_number_of_a_long_table_is_found_without_reading_its_rows_again() -> None:
    rows = "\n".join(f"F{k} | {k}.5" for k in range(3000))
    table = PublishedTable.read(f"Table 1, p. 1\nfunction || mean\n{rows}")
    assert table["F0", "mean"].value == 0.5

    assert table.row_names is table.row_names
    assert [table[place].value for place in table.places()][-1] == 2999.5
