from dataclasses import asdict

import numpy as np
import pytest

from papers.liang2026 import (
    ACCELERATION,
    BENCHMARK,
    FANUC,
    IWOA,
    MOTION,
    PAPER,
    TABLE_II,
    TABLE_VI,
    TRAP,
    VELOCITY,
    greatest_jump,
)
from repro.functions import FUNCTIONS
from repro.model.claims import CellClaim, Sentence
from repro.robotics import peak
from repro.runs.readings import applied, readings

SHARED = ("coefficients", "leader", "spiral_range", "shared_draw", "bounds")
ACKLEY = FUNCTIONS["ackley"]
SINGLE = [reading for reading in readings(PAPER) if len(reading.alternatives) == 1]


@pytest.mark.parametrize("reading", SINGLE, ids=lambda reading: reading.name)
def test_the_compared_whale_stands_on_the_footing_of_iwoa_under_every_reading(
    reading: object,
) -> None:
    for experiment in (BENCHMARK, MOTION):
        under = applied(experiment, reading).algorithms  # type: ignore[arg-type]
        ours, whale = asdict(under["IWOA"]), asdict(under["WOA"])

        assert [ours[name] for name in SHARED] == [whale[name] for name in SHARED]


def test_whales_follow_the_printed_equations_and_not_the_program() -> None:
    whale = BENCHMARK.algorithms["WOA"]

    assert [asdict(whale)[name] for name in SHARED] == [
        "scalar", "per whale", "symmetric", False, "clip",
    ]  # fmt: skip
    assert "WOA's program" in {reading.name for reading in SINGLE}


@pytest.mark.parametrize("method", TABLE_VI.row_names)
def test_printed_motions_keep_both_limits(method: str) -> None:
    durations = (TABLE_VI[method, "t1"].si, TABLE_VI[method, "t2"].si)

    assert peak(FANUC, durations, 1) < VELOCITY.si
    assert peak(FANUC, durations, 2) < ACCELERATION.si


def test_velocity_and_acceleration_are_zero_on_both_sides_of_every_waypoint() -> None:
    assert greatest_jump(1) < 1e-12
    assert greatest_jump(2) < 1e-12
    assert greatest_jump(3) > 1


def test_no_other_minimum_of_ackley_in_40_dimensions_costs_less_than_twice_the_trap() -> None:
    inner = []
    for moved in range(1, 41):
        x = np.zeros((601, 40))
        x[:, :moved] = np.linspace(0.5, 1.1, 601)[:, None]
        cost = np.array([ACKLEY(row) for row in x])
        lower = (cost[1:-1] < cost[:-2]) & (cost[1:-1] < cost[2:])
        inner += cost[1:-1][lower].tolist()

    assert inner
    assert min(inner) == pytest.approx(2 * TRAP, rel=0.01)


def test_woa_and_gwo_print_what_iwoa_prints_on_f10_as_the_erratum_says() -> None:
    rows = [row for row in TABLE_II.row_names if row.startswith("F10")]
    (erratum,) = [each for each in PAPER.errata if "F10" in each.where]

    for name in ("WOA", "GWO"):
        assert name in erratum.printed
        assert [TABLE_II[row, name] for row in rows] == [TABLE_II[row, "IWOA"] for row in rows]


def test_times_that_are_set_are_shown_and_not_counted() -> None:
    cells = [c for c in PAPER.claims if isinstance(c, CellClaim) and c.table is TABLE_VI]

    assert {c.row for c in cells if not c.counts} == {"Fifth-order polynomial"}
    assert all(c.counts for c in cells if c.row != "Fifth-order polynomial")


@pytest.mark.parametrize("method", ["WOA", "IWOA"])
def test_a_total_time_counts_once_in_table_and_text(method: str) -> None:
    printed = TABLE_VI[method, "Total Time t"]
    said = [c for c in PAPER.claims if c.printed == printed]

    assert {type(c) for c in said} == {CellClaim, Sentence}
    assert {c.group for c in said} == {f"{printed.text} s"}


def test_what_the_text_rules_out_is_a_note() -> None:
    alternatives = [each for own in PAPER.assumptions for each in own.alternatives]

    assert [each.name for each in alternatives if each.ruled_out] == ["F5 in 30 dimensions"]


def test_iwoa_closes_in_on_the_minimum_of_the_sphere() -> None:
    found = IWOA.minimise(
        BENCHMARK.problems["F1"], population=50, iterations=500, rng=np.random.default_rng(1)
    )

    assert found.cost < 1e-20
