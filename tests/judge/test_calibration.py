import json
from collections import defaultdict
from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.determinism.seeds import generator
from repro.functions import FUNCTIONS
from repro.judge.calibration import (
    FACTORS,
    KINDS,
    KNOWN,
    SAID,
    KnownTable,
    Row,
    Trial,
    coverage_rows,
    drawn,
    kind_of,
    trials,
    verdict_rows,
)
from repro.judge.verdict import Verdict
from repro.optimisers import GWO, PSO, WOA, Optimiser, RandomSearch
from repro.report.calibration import calibration
from tests.calibrate import FILE, MADE_UP, PROBLEMS, REPEATS, RUNS, SEARCHES, written

Vector = NDArray[np.float64]
SPHERE = FUNCTIONS["sphere"].problem(3)
HARTMANN = FUNCTIONS["hartmann_3"].problem(3)
PAIRS: tuple[tuple[str, Optimiser], ...] = (
    ("sphere", RandomSearch()),
    ("sphere", WOA()),
    ("rastrigin", PSO()),
    ("hartmann_3", GWO()),
)
TABLES = 25  # of each pair: a hundred for each statistic
MOST_CONTRADICTED = 0.02
LEAST_HELD = 0.92
LEAST_FOUND = 0.95
LOST = {("mean", 1), ("std", 1)}


@cache
def tried(repeats: int) -> tuple[Trial, ...]:
    """Return what is said of tables of 30 runs of a few quick searches."""
    found: list[Trial] = []
    for name, search in PAIRS:
        problem = FUNCTIONS[name].problem(3)
        rngs = (generator("small", name, search, run) for run in range(30 * (repeats + 1) + 300))
        costs = np.array(
            [search.minimise(problem, population=10, iterations=20, rng=rng).cost for rng in rngs]
        )
        for table in range(TABLES):
            key = f"small/{name}/{search}/{table}"
            found += trials(
                drawn(costs, name=key, kind="small", problem=problem, repeats=repeats, runs=30)
            )
    return tuple(found)


def shares(rows: list[Row]) -> dict[tuple[object, object, object], dict[object, float]]:
    """Return the share of each verdict by repeats, statistic and factor."""
    found: defaultdict[tuple[object, object, object], dict[object, float]] = defaultdict(dict)
    for row in rows:
        share = row["share"]
        assert isinstance(share, float)
        found[row["repeats"], row["statistic"], row["factor"]][row["verdict"]] = share
    return found


def known(stored: Vector, new: Vector) -> KnownTable:
    return KnownTable(name="small", kind="made up", problem=SPHERE, stored=stored, new=new)


def narrow(repeats: int) -> KnownTable:
    costs = np.random.default_rng(1).normal(100.0, 5.0, (repeats + 1, 30))
    return known(costs[1:], costs[0])


@pytest.mark.parametrize("repeats", [1, 10])
@pytest.mark.parametrize("statistic", KNOWN)
def test_the_truth_is_rarely_contradicted_and_mostly_held(statistic: str, repeats: int) -> None:
    said = shares(verdict_rows(tried(repeats)))[repeats, statistic, 1.0]

    assert said["contradicted"] <= MOST_CONTRADICTED
    assert said["reproduced"] + said["consistent"] >= LEAST_HELD


@pytest.mark.parametrize("repeats", [1, 10])
@pytest.mark.parametrize("statistic", KNOWN)
def test_intervals_hold_what_they_promise(statistic: str, repeats: int) -> None:
    (row,) = (r for r in coverage_rows(tried(repeats)) if r["statistic"] == statistic)

    # a hundred tables: 5 % of them, and twice the standard error of that
    assert row["reached"] >= 0.95 - 2 * (0.05 * 0.95 / (TABLES * len(PAIRS))) ** 0.5


@pytest.mark.parametrize(
    ("statistic", "factor"),
    [("mean", 100.0), ("mean", 0.01), ("std", 100.0), ("best", 100.0), ("worst", 0.01)],
)
def test_values_a_hundred_times_off_are_contradicted_where_costs_are_narrow(
    statistic: str, factor: float
) -> None:
    said = {(t.statistic, t.factor): t.verdict for t in trials(narrow(10))}

    assert said[statistic, factor] is Verdict.CONTRADICTED


def test_a_best_that_is_too_low_by_less_than_runs_vary_is_not_contradicted() -> None:
    wide = np.random.default_rng(1).lognormal(0.0, 5.0, (11, 30))
    said = {(t.statistic, t.factor): t.verdict for t in trials(known(wide[1:], wide[0]))}

    assert said["best", 0.1] is not Verdict.CONTRADICTED


def test_every_value_is_tried_at_every_factor_unless_its_print_is_that_of_the_truth() -> None:
    everything = [(t.statistic, t.factor) for t in trials(narrow(2))]
    zero = [(t.statistic, t.factor) for t in trials(known(np.zeros((2, 30)), np.zeros(30)))]
    near = HARTMANN.function.minimum + 1e-9 * np.arange(90.0).reshape(3, 30)
    same = KnownTable(name="near", kind="", problem=HARTMANN, stored=near[1:], new=near[0])

    assert sorted(everything) == sorted((name, f) for f in FACTORS for name in KNOWN)
    assert zero == [(name, 1.0) for name in KNOWN]
    # three digits show no distance from −3.86 but a std does
    assert {t.statistic for t in trials(same) if t.factor != 1} == {"std"}


def test_stored_and_new_runs_are_drawn_without_replacement() -> None:
    costs = np.arange(100.0)

    found = drawn(costs, name="a", kind="", problem=SPHERE, repeats=2, runs=30)
    other = drawn(costs, name="b", kind="", problem=SPHERE, repeats=2, runs=30)

    assert (found.stored.shape, found.new.shape) == ((2, 30), (30,))
    assert len({*found.stored.ravel(), *found.new} & set(costs)) == 90
    assert found.new.tolist() != other.new.tolist()


def test_costs_are_of_the_kind_that_their_distances_from_the_minimum_show() -> None:
    minimum, away = HARTMANN.function.minimum, np.linspace(1.0, 2.0, 400)
    far, wide = np.where(np.arange(400) < 4, 1000.0, away), np.logspace(-5.0, 0.0, 400)

    kinds = [kind_of(minimum + costs, HARTMANN) for costs in (away, far, wide, np.round(away))]
    assert kinds == list(KINDS)
    assert kind_of(minimum + 1e-16 * away, HARTMANN) == "quantised"


def test_shares_of_verdicts_add_up_to_one() -> None:
    for said in shares(verdict_rows(tried(1))).values():
        assert list(said) == [str(verdict) for verdict in SAID]
        assert sum(said.values()) == pytest.approx(1.0, abs=2e-3)


def test_equal_runs_are_covered_and_reproduced() -> None:
    found = list(trials(known(np.full((3, 30), 1.1), np.full(30, 1.1))))

    true = [trial for trial in found if trial.factor == 1]
    assert {trial.verdict for trial in true} == {Verdict.REPRODUCED}
    assert all(trial.covered and trial.resampled for trial in true)


# what the package ships


def test_the_shipped_calibration_is_small_and_as_it_is_written() -> None:
    text = FILE.read_text(encoding="utf-8")

    assert len(text.encode()) < 60_000
    assert written(calibration()) == text
    assert json.loads(text) == calibration()


def test_the_shipped_calibration_is_of_every_depth_search_and_function() -> None:
    shipped = calibration()
    by = shipped["by"]

    assert sorted(shares(shipped["rows"])) == sorted(
        (repeats, name, factor) for repeats in REPEATS for name in KNOWN for factor in FACTORS
    )
    assert (by["searches"], list(by["functions"])) == (list(SEARCHES), list(PROBLEMS))
    assert by["tables of a pair"] * len(SEARCHES) * len(PROBLEMS) >= 1000
    assert (by["repeats"], by["runs"]) == (list(REPEATS), RUNS)
    assert {row["kind"] for row in shipped["coverage"]} == {*KINDS, *MADE_UP}


# A kind of run that none of N stored ones is of, and some of n new ones are, comes by chance
# (1 - x) x^(N/n), x being that none of n is: up to 1/4 at one repeat, 3.5 % at ten. Nothing that 30
# runs show tells how far off it lies. At one repeat the judge leaves extremes undecided for it.
UNSEEN = pytest.mark.xfail(reason="at one repeat 2.5 % of true means, 3 % of true stds are ✖")


@pytest.mark.parametrize(
    ("statistic", "repeats"),
    [
        pytest.param(name, repeats, marks=UNSEEN if (name, repeats) in LOST else ())
        for name in KNOWN
        for repeats in REPEATS
    ],
)
def test_shipped_tables_hold_the_truth(statistic: str, repeats: int) -> None:
    said = shares(calibration()["rows"])[repeats, statistic, 1.0]

    assert said["contradicted"] <= MOST_CONTRADICTED
    assert said["reproduced"] + said["consistent"] >= LEAST_HELD


@pytest.mark.parametrize(
    ("statistic", "factor"), [("mean", 100.0), ("std", 100.0), ("best", 100.0), ("worst", 0.01)]
)
@pytest.mark.parametrize("repeats", REPEATS[1:])
def test_shipped_tables_show_what_is_a_hundred_times_off(
    statistic: str, factor: float, repeats: int
) -> None:
    said = shares(calibration()["narrow"])[repeats, statistic, factor]

    assert said["contradicted"] >= LEAST_FOUND
