import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.tables.numbers import NoNumber, NumberForm, number_form, split_pair


def read(text: str) -> NumberForm:
    form = number_form(text)
    assert isinstance(form, NumberForm), (text, form)
    return form


@pytest.mark.parametrize(
    ("text", "value", "rounding"),
    [
        ("1.29E + 02", 129.0, 0.5),
        ("− 1.175", -1.175, 0.0005),
        ("**1.2e-3**", 1.2e-3, 0.05e-3),
        (r"\textbf{1.2e-3}", 1.2e-3, 0.05e-3),
        (r"\underline{\textbf{$1.2\times10^{-3}$}}", 1.2e-3, 0.05e-3),
        (r"$\mathbf{1.2 \cdot 10^{-3}}$", 1.2e-3, 0.05e-3),
        (r"\cellcolor{gray!20}1.5", 1.5, 0.05),
        (r"\num{1.2e-3}", 1.2e-3, 0.05e-3),
        ("<b>1.2&times;10<sup>-4</sup></b>", 1.2e-4, 0.05e-4),
        ("1.23×10⁻⁴", 1.23e-4, 0.005e-4),
        ("1.23·10^-4", 1.23e-4, 0.005e-4),
        ("1.23*10^-4", 1.23e-4, 0.005e-4),
        ("1.2×10-4", 1.2e-4, 0.05e-4),
        ("1.2D-03", 1.2e-3, 0.05e-3),
        ("10⁻³", 1e-3, 0.5e-3),
        (".5", 0.5, 0.05),
        ("1.", 1.0, 0.5),
        ("1,234.5", 1234.5, 0.05),
        ("12\u2009345", 12345.0, 0.5),
        ("4/30", 4 / 30, 0.0),
        ("pi/2", math.pi / 2, 0.0),
        (r"$-\frac{3\pi}{4}$", -3 * math.pi / 4, 0.0),
    ],
)
def test_every_form_gives_its_value_and_half_of_its_last_digit(
    text: str, value: float, rounding: float
) -> None:
    form = read(text)

    assert form.value == pytest.approx(value, rel=1e-15)
    assert form.rounding == pytest.approx(rounding, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        ("98%", 98, "%"),
        ("95.3 %", 95.3, "%"),
        (r"98.1\%", 98.1, "%"),
        ("90°", 90, "°"),
        (r"$90^\circ$", 90, "°"),
        (r"388\textmu s", 388, "µs"),
        (r"\SI{388}{\micro\second}", 388, "µs"),
        ("2.5 Nm", 2.5, "N·m"),
        ("45 deg/s²", 45, "deg/s^2"),
        ("1e5 m", 1e5, "m"),
    ],
)
def test_unit_is_parted_from_its_number(text: str, value: float, unit: str) -> None:
    form = read(text)

    assert (form.value, form.unit) == (value, unit)


@pytest.mark.parametrize(
    ("text", "mark"),
    [
        ("1.2E-12(+)", "(+)"),
        ("5.33E+00=", "="),
        ("3.94e-04†", "†"),
        (r"$3.94e{-04}^{\dagger}$", "^†"),
        ("0.002/+", "/+"),
        ("1.2e-3*", "*"),
        ("1.5 (−)", "(-)"),
        ("1.2^{a}", "^a"),
    ],
)
def test_mark_is_kept_apart_and_changes_no_value(text: str, mark: str) -> None:
    form = read(text)

    assert form.mark == mark
    assert form.value in {1.2e-12, 5.33, 3.94e-4, 0.002, 1.2e-3, 1.5, 1.2}


@pytest.mark.parametrize(
    ("text", "because"),
    [
        *((text, "no value") for text in ("N/A", "-", "−", "—", "--", "", "n.a.")),
        *((text, "not a number") for text in ("NaN", "nan", "-NaN")),
        *((text, "infinite") for text in ("Inf", "-inf", "∞", r"$\infty$")),
        *((text, "a bound") for text in ("<0.001", r"$<10^{-3}$", "p ≤ 0.05", "> 1000")),
        *((text, "approximate") for text in ("~1.2", "≈ 3")),
        *((text, "mark of a test") for text in ("=", "+", "(−)")),
        ("=1+2", "formula"),
        ("2.51×10111", "sign was lost in copying: 10111 may stand for 10^111 or 10^-11"),
        ("1.2×1011", "exponent was lost in copying: 1011 may stand for 10^11 or 10^-11"),
    ],
)
def test_usual_stand_ins_are_known_and_say_what_they_are(text: str, because: str) -> None:
    form = number_form(text)

    assert isinstance(form, NoNumber)
    assert form.known
    assert because in form.because


@pytest.mark.parametrize(
    "text", ["a ± b", "a (b)", "1 2", "1.2\t3", "1e", "1.2.3", "3,26", "0,123", "٣", "(3)"]
)
def test_what_may_be_anything_is_no_number(text: str) -> None:
    form = number_form(text)

    assert isinstance(form, NoNumber)
    assert not form.known


@pytest.mark.parametrize(
    ("text", "pair"),
    [
        ("1.2 ± 0.3", ("1.2", "0.3", "±")),
        (r"$2.1\pm0.3$", ("2.1", "0.3", "±")),
        ("1.2 +/- 0.3", ("1.2", "0.3", "±")),
        ("1.2e-3 ± 4.5e-4 (+)", ("1.2e-3(+)", "4.5e-4", "±")),
        ("1.2±0.3†", ("1.2†", "0.3", "±")),
        ("12.3 (4.5)", ("12.3", "4.5", "(")),
        ("1.2 [0.3]", ("1.2", "0.3", "[")),
        ("(1.2 ± 0.3)×10^-4", ("1.2×10^-4", "0.3×10^-4", "±")),
        ("1.2±0.3%", ("1.2%", "0.3%", "±")),
        ("1.2", None),
        ("1.2 (+)", None),
        ("a (b)", None),
    ],
)
def test_two_numbers_of_one_cell_are_parted(text: str, pair: object) -> None:
    assert split_pair(text) == pair


@given(st.text(max_size=80))
def test_any_text_is_read_or_refused(text: str) -> None:
    form = number_form(text)

    assert isinstance(form, NumberForm | NoNumber)


@given(
    st.decimals(allow_nan=False, allow_infinity=False, places=4, min_value=-9999, max_value=9999),
    st.integers(-300, 290),
    st.sampled_from([r"$%s\times10^{%s}$", "%s·10^%s", "%sE%s", "**%s × 10^%s**", "%se%s†"]),
)
def test_no_form_changes_what_is_printed(number: object, power: int, form: str) -> None:
    found = read(form % (number, power))

    assert found.value == float(f"{number}e{power}")
    assert Fraction(found.mantissa) == Fraction(str(number))
    assert found.power == power
