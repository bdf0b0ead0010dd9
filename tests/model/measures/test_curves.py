import math
from dataclasses import replace

import numpy as np
import pytest

from repro.model.evidence import Evidence, Runs
from repro.model.experiment import Experiment
from repro.model.measures.curves import Effort, PlaceAmong, Sensitivity, Together, planned
from repro.model.measures.measure import Computed
from repro.model.paper import Paper, Source
from repro.optimisers import GA, WOA
from repro.robotics import PathFitting, quintic
from tests.small_papers import evidence_of

FIT = PathFitting(
    start=0.0, end=1.0, law=quintic, duration=2.0, intervals=10, box=((-50.0, 50.0),) * 6
)
FITS = {"left": FIT, "right": replace(FIT, end=-2.0)}
EXPERIMENT = Experiment(
    name="arm",
    where="here",
    proposed="WOA",
    problems=FITS,
    algorithms={"WOA": WOA(), "GA": GA()},
    population=10,
    iterations=4,
    runs=3,
)
PAPER = Paper(
    key="made-up",
    source=Source(authors="nobody", title="nothing"),
    summary="",
    experiments=(EXPERIMENT, replace(EXPERIMENT, name="shifted")),
    inputs=(),
    results=(),
    claims=(),
    assumptions=(),
    errata=(),
    gaps=(),
)
FLAT = ((9.0, 9.0, 9.0, 9.0),) * 3
Table = tuple[tuple[float, ...], ...]


def runs(histories: Table, points: np.ndarray | None = None) -> Runs:
    """Return one repeat of three runs of 40 evaluations."""
    return Runs(
        costs=np.array([[history[-1] for history in histories]]),
        points=np.zeros((1, 3, 6)) if points is None else points,
        histories=np.array([histories]),
        evaluations=40,
    )


def evidence(**histories: Table) -> Evidence:
    """Return evidence in which the left joint has these histories and the right one costs 0."""
    found = {}
    for algorithm, table in histories.items():
        found["arm", "left", algorithm] = runs(table)
        found["arm", "right", algorithm] = runs(((0.0,) * 4,) * len(table))
    return evidence_of(PAPER, found)


def together(quantity: str = "cost", statistic: str = "median", **other: str) -> Together:
    combination = other.get("combination", "norm")
    return Together(
        experiment="arm",
        problems=("left", "right"),
        algorithm="WOA",
        quantity=quantity,
        combination=combination,  # type: ignore[arg-type]
        statistic=statistic,
    )


def finals(left: tuple[float, ...], right: tuple[float, ...]) -> Evidence:
    tables = {"left": left, "right": right}
    return evidence_of(
        PAPER,
        {
            ("arm", name, "WOA"): runs(tuple((cost,) for cost in costs))
            for name, costs in tables.items()
        },
    )


@pytest.mark.parametrize(("combination", "value"), [("norm", 5), ("sum", 7), ("largest", 4)])
def test_problems_are_combined_run_by_run(combination: str, value: float) -> None:
    found = together(combination=combination).measure(finals((3, 30, 0), (4, 40, 0)))

    assert found.value == value
    assert found.repeats == 1


@pytest.mark.parametrize(
    ("statistic", "value"), [("best", 1), ("median", 2), ("mean", 4), ("worst", 9)]
)
def test_statistic_is_taken_over_the_runs(statistic: str, value: float) -> None:
    found = together(statistic=statistic).measure(finals((1, 9, 2), (0, 0, 0)))

    assert found.value == value
    assert np.isfinite(found.draws).all()
    assert found.repeats == 1
    assert found.thin == (statistic in {"best", "worst"})


def test_quantities_of_one_algorithm_are_drawn_from_the_same_tables() -> None:
    data = finals((1, 9, 2), (0, 0, 0))

    cost, last = (
        together(name).measure(data).draws for name in ("cost", "cost after 1 iterations")
    )

    assert cost.tolist() == last.tolist()


def value(number: float) -> Computed:
    return Computed(how=str(number), value=lambda: number)


@pytest.mark.parametrize(
    ("own", "place"), [(0.5, 1), (1.0, 1), (1.5, 2), (2.0, 2), (9.0, 3), (math.inf, 3)]
)
def test_place_is_one_more_than_the_number_of_lower_measures(own: float, place: int) -> None:
    measure = PlaceAmong(of=value(own), others=(value(1.0), value(2.0)))

    found = measure.measure(evidence_of(PAPER, {}))

    assert found.value == place
    assert found.draws.tolist() == [place]
    assert measure.cells() == ()


def test_place_of_runs_varies_with_their_tables() -> None:
    measure = PlaceAmong(of=together(), others=(value(1.5),))

    found = measure.measure(finals((1, 9, 1), (0, 0, 0)))

    assert found.value == 1
    assert set(np.unique(found.draws)) == {1, 2}
    assert found.repeats == 1


def test_place_rests_on_the_fewest_repeats_of_any_measure() -> None:
    few, many = replace(together(), problems=("left",)), replace(together(), problems=("right",))

    found = PlaceAmong(of=many, others=(few, value(1.0))).measure(uneven(1, 3))

    assert found.repeats == 1


def effort(algorithm: str) -> Effort:
    return Effort(
        experiment="arm",
        problems=("left", "right"),
        algorithm=algorithm,
        among=("WOA", "GA"),
    )


def test_effort_counts_evaluations_until_the_worse_of_the_median_finals() -> None:
    quick: Table = ((9.0, 5.0, 1.0, 1.0),) * 3
    slow: Table = ((9.0, 9.0, 9.0, 5.0),) * 3
    data = evidence(WOA=quick, GA=slow)

    assert effort("WOA").measure(data).value == 20  # of 40 in 4 iterations
    assert effort("GA").measure(data).value == 40
    assert {cell[2] for cell in effort("WOA").cells()} == {"WOA", "GA"}


def test_run_that_never_reaches_the_target_counts_as_infinite() -> None:
    stuck: Table = ((9.0, 9.0, 9.0, 9.0), (9.0, 5.0, 5.0, 5.0), (9.0, 5.0, 5.0, 5.0))
    data = evidence(WOA=stuck, GA=((9.0, 5.0, 5.0, 5.0),) * 3)

    found = effort("WOA").measure(data)

    assert found.value == 20
    assert found.draws.max() == math.inf


def test_effort_of_an_even_number_of_runs_is_finite_for_all() -> None:
    quick: Table = ((9.0, 3.0, 3.0, 1.0),) * 4
    slow: Table = ((9.0, 4.0, 4.0, 4.0),) * 2 + ((9.0, 9.0, 9.0, 6.0),) * 2
    data = evidence(WOA=quick, GA=slow)

    assert effort("WOA").measure(data).value == 20  # of 40 in 4 iterations
    assert effort("GA").measure(data).value == 20  # two of its four runs are below 5, their median


def uneven(left: int, right: int) -> Evidence:
    """Return evidence in which the joints have so many repeats of three runs."""
    data = {}
    for experiment in ("arm", "shifted"):
        for name, repeats in (("left", left), ("right", right)):
            for algorithm in ("WOA", "GA"):
                costs = np.full((repeats, 3), 3.0 if name == "left" else 4.0)
                data[experiment, name, algorithm] = Runs(
                    costs=costs,
                    points=np.zeros((repeats, 3, 6)),
                    histories=costs[..., None],
                    evaluations=40,
                )
    return evidence_of(PAPER, data)


@pytest.mark.parametrize(("left", "right"), [(2, 2), (3, 2), (2, 3)])
def test_joints_are_taken_together_over_the_repeats_that_all_have(left: int, right: int) -> None:
    data = uneven(left, right)
    shift = Sensitivity(
        experiment="arm", shifted="shifted", problems=("left", "right"), algorithm="WOA", shift=0.01
    )

    found = [measure.measure(data) for measure in (together(), effort("WOA"), shift)]

    assert [each.value for each in found] == [5.0, 40.0, 0.0]
    assert [each.repeats for each in found] == [2, 2, 2]


def passed_on(before: float, after: float) -> float:
    measure = Sensitivity(
        experiment="arm", shifted="shifted", problems=("left", "right"), algorithm="WOA", shift=0.01
    )
    data = {}
    for experiment, offset in (("arm", before), ("shifted", after)):
        for name in FITS:
            points = np.zeros((1, 3, 6))
            points[..., 0] = offset if name == "left" else 0.0
            points[..., 1] = 1.0
            data[experiment, name, "WOA"] = runs(FLAT, points)
    assert set(measure.cells()) == set(data)
    return measure.measure(evidence_of(PAPER, data)).value


def test_sensitivity_is_the_change_of_the_curve_over_the_shift() -> None:
    assert passed_on(0.3, 0.3) == 0.0
    assert passed_on(0.3, 0.31) == pytest.approx(1.0)
    assert passed_on(0.3, 0.27) == pytest.approx(3.0)


def test_sensitivity_pairs_the_repeats_that_both_experiments_have() -> None:
    rng = np.random.default_rng(1)
    few, many = rng.normal(size=(1, 3, 6)), rng.normal(size=(2, 3, 6))
    measure = Sensitivity(
        experiment="arm", shifted="shifted", problems=("left",), algorithm="WOA", shift=0.01
    )

    found, first = (
        measure.measure(
            evidence_of(
                PAPER,
                {
                    ("arm", "left", "WOA"): runs(FLAT, points),
                    ("shifted", "left", "WOA"): runs(FLAT, few),
                },
            )
        )
        for points in (many, many[:1])
    )

    assert (found.value, found.repeats) == (first.value, 1)


def test_planned_quantity_is_that_of_the_desired_paths() -> None:
    paths = tuple(FITS.values())

    assert planned(paths, "peak jerk", "largest")() == pytest.approx(60 * 2.0 / 2.0**3)
    assert planned(paths, "start acceleration", "norm")() == 0.0


def test_words_name_what_is_measured() -> None:
    assert "median norm of cost over 2 problems of arm, WOA" in together().words
    assert "place of 1.0 among 2.0" in PlaceAmong(of=value(1.0), others=(value(2.0),)).words
    assert "evaluations of GA" in effort("GA").words
