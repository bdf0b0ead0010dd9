"""SMWOA: the algorithm, and the two experiments that the paper runs it in."""

from dataclasses import replace

from papers.smwoa2022.printed import TABLE_2, TABLE_4, TABLE_5
from repro.functions import FUNCTIONS, BenchmarkProblem
from repro.model.experiment import Experiment
from repro.model.measures.ranks import Contest
from repro.optimisers import DE, GSA, PSO, SMA, WOA, SlimeWOA
from repro.robotics import MinimumTimeSpline
from repro.tables.published import Printed

SMWOA = SlimeWOA(
    control="arctanh",  # Eq. (10)
    weight="of the whale",  # Eqs. (11) and (15)
    weights="per dimension",
    logarithm="decimal",
    swing="per dimension",  # v_b of Eqs. (8) and (13)
    coefficients="scalar",  # Eqs. (4) and (15)
    leader="per whale",  # Eqs. (7) and (14)
    spiral_range="symmetric",  # Eq. (5)
)

# The row of Table 2, and the function that it means (see the errata).
FUNCTION_OF = {
    "Sphere": FUNCTIONS["sphere"],
    "Schwefel 2.22": FUNCTIONS["schwefel_2_22"],
    "Schwefel 1.12": FUNCTIONS["schwefel_1_2"],
    "Schwefel 2.21": FUNCTIONS["schwefel_2_21"],
    "Rosenbrock": FUNCTIONS["rosenbrock"],
    "Rastrigin": FUNCTIONS["rastrigin"],
    "Ackley": FUNCTIONS["ackley"],
    "Alpine": FUNCTIONS["alpine_1"],
    "Penalized 1.1": FUNCTIONS["penalized_1"],
    "Penalized 1.2": FUNCTIONS["penalized_2"],
    "Michalewicz": FUNCTIONS["foxholes"],
    "Branin": replace(FUNCTIONS["branin"], box=((-5.0, 5.0), (-5.0, 5.0))),
    "Goldstein-Price": FUNCTIONS["goldstein_price"],
    "Hartmann-3D": FUNCTIONS["hartmann_3"],
    "Shekel 5": FUNCTIONS["shekel_5"],
}
DIMENSION_OF_ALPINE = 30  # none is printed


def _problem(name: str) -> BenchmarkProblem:
    if name == "Alpine":
        return FUNCTION_OF[name].problem(DIMENSION_OF_ALPINE)
    return FUNCTION_OF[name].problem(int(TABLE_2[name, "Dimension"].value))


BENCHMARK = Experiment(
    name="benchmark",
    where="section 3.3",
    proposed="SMWOA",
    problems={
        f"F{number}": _problem(name) for number, name in enumerate(TABLE_2.row_names, start=1)
    },
    algorithms={
        "SMWOA": SMWOA,
        "WOA": WOA(),
        "PSO": PSO(),
        "GSA": GSA(),
        "DE": DE(),
        "SMA": SMA(),
    },
    population=30,
    iterations=500,
    runs=30,
)


def _limits(row: int, unit: str) -> tuple[float, ...]:
    """Return one row of Table 5, whose units stand in the row headings, in SI units."""
    name = TABLE_5.row_names[row]
    return tuple(Printed(TABLE_5[name, j].text, unit).si for j in TABLE_5.column_names)


ANGLE = _limits(0, "deg")
UR5 = MinimumTimeSpline(
    nodes=TABLE_4.points(),
    velocity=_limits(1, "deg/s"),
    acceleration=_limits(2, "deg/s^2"),
    durations=(0.1, 10.0),
    ends="repeated",  # Eq. (20)
    time_ends="repeated",
)
TRAJECTORY = Experiment(
    name="trajectory",
    where="section 4.3",
    proposed="SMWOA",
    problems={"UR5": UR5},
    algorithms={"SMA": SMA(), "WOA": WOA(), "SMWOA": SMWOA},
    population=100,
    iterations=100,
    runs=30,
)

F = tuple(BENCHMARK.problems)
UNIMODAL, MULTIMODAL, FIXED = F[:5], F[5:10], F[10:]


def contest(*problems: str) -> Contest:
    """Return the six algorithms ranked on the problems by the average of their runs."""
    return Contest(
        experiment=BENCHMARK.name, problems=problems, algorithms=tuple(BENCHMARK.algorithms)
    )
