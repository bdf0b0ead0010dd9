import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.report.drawings.distribution import Panel, Strip, distribution_plot
from repro.report.drawings.draw import Drawing, drawing
from tests.written_rows import rows_of


def strip(name: str, values: list[float], **printed: float) -> Strip:
    return Strip(algorithm=name, values=np.array(values), printed=printed)


def drawn(*strips: Strip, unit: str = "") -> Drawing:
    panel = Panel(title="F1", unit=unit, strips=strips)
    return drawing(lambda: distribution_plot([panel]), title="Runs", identifier="runs")


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=40))
def test_quantiles_are_values_of_runs_in_order(values: list[float]) -> None:
    found = strip("A", values).quantiles

    assert set(found) <= set(values)
    assert (np.diff(found) >= 0).all()
    assert (found[0], found[4]) == (min(values), max(values))


@pytest.mark.parametrize(
    "values",
    [[0.0, 0.0], [2.0, 2.0], [-3.0, -2.5, 4.0], [5e-324, 1e300], [0.0, 1e-300]],
    ids=["all zero", "all equal", "below zero", "as far as it goes", "zero and tiny"],
)
def test_any_runs_can_be_drawn(values: list[float]) -> None:
    shown = drawn(strip("A", values, mean=1.0), strip("B", values))

    assert rows_of(shown.frame)[1][2] == "A"
    assert "nan" not in shown.svg.lower()


def test_the_unit_stands_in_the_title() -> None:
    assert ">F1 [s]<" in drawn(strip("A", [1.0, 2.0]), unit="s").svg
    assert ">F1<" in drawn(strip("A", [1.0, 2.0])).svg


def test_a_printed_single_run_is_named_as_such() -> None:
    shown = drawn(strip("A", [1.0, 2.0], single=1.5))

    assert "A 1 (printed (one run) 1.500)" in shown.description
    assert rows_of(shown.frame)[1][-3:] == ("", "", "1.5")


def test_long_names_are_broken_into_lines() -> None:
    shown = drawn(strip("random search", [1.0, 2.0]))

    assert ">random<" in shown.svg
    assert ">search<" in shown.svg
