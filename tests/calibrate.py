"""Calibrate the judge anew: `nox -s calibrate` writes repro/judge/calibration.json.

Seven searches on twelve functions run 1,260 times each, and made-up costs with known tails are
drawn; tables of 30 of these runs are printed and judged by others of them. Every random number is
named, so the same file comes out everywhere but for last digits of costs.
"""

import json
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from itertools import product
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from repro.determinism.seeds import generator
from repro.functions import FUNCTIONS, BenchmarkProblem
from repro.judge.calibration import (
    FACTORS,
    KINDS,
    KNOWN,
    Row,
    Trial,
    coverage_rows,
    drawn,
    kind_of,
    trials,
    verdict_rows,
)
from repro.optimisers import DE, GWO, PSO, SMA, WOA, HybridWOA, Optimiser, RandomSearch

Vector = NDArray[np.float64]
FILE = Path(__file__).parent.parent / "repro" / "judge" / "calibration.json"
RUNS = 30
REPEATS = (1, 10, 20)
POOL = 1260  # runs of a pair: twice what the deepest table and its own runs take
TABLES = 15  # of each pair at each depth: 1,260 of all
MADE_UP_TABLES = 200  # of each kind at each depth
ENDS = (0.01, 1.0, 100.0)  # the factors that the rows of narrow costs are about
NAMES = (
    "calibration/function/search/run for a run, calibration/function/search/table/repeats for the "
    "runs that a table has"
)
POPULATION, ITERATIONS, DIMENSION = 30, 300, 10

SEARCHES: Mapping[str, Optimiser] = {
    "WOA by the equations": HybridWOA(
        leader="per whale", spiral_range="symmetric", coefficients="vector"
    ),
    "WOA by the program": WOA(),
    "GWO": GWO(),
    "PSO": PSO(clip="last particle"),
    "DE": DE(),
    "SMA": SMA(),
    "random search": RandomSearch(),
}
PROBLEMS: Mapping[str, BenchmarkProblem] = {
    name: FUNCTIONS[name].problem(FUNCTIONS[name].fixed_dimension or DIMENSION)
    for name in (
        *("sphere", "schwefel_2_22", "rosenbrock", "rastrigin", "ackley", "penalized_1"),
        *("alpine_1", "foxholes", "branin", "goldstein_price", "hartmann_3", "shekel_5"),
    )
}


def _normal(rng: np.random.Generator, size: int) -> Vector:
    return rng.normal(100.0, 5.0, size)


def _ten_decades(rng: np.random.Generator, size: int) -> Vector:
    # 95 of 100 runs within ten decades
    return np.asarray(10.0 ** rng.normal(-10.0, 2.5, size))


def _heavy(rng: np.random.Generator, size: int) -> Vector:
    return 1.0 + rng.pareto(1.5, size)  # a finite mean, no finite variance


def _outliers(rng: np.random.Generator, size: int) -> Vector:
    return np.where(rng.random(size) < 0.01, 1000.0, 1.0) * rng.normal(1.0, 0.05, size)


def _two_values(rng: np.random.Generator, size: int) -> Vector:
    return np.where(rng.random(size) < 0.05, 4.0, 1.0)


MADE_UP: Mapping[str, Callable[[np.random.Generator, int], Vector]] = {
    "made up: normal": _normal,
    "made up: lognormal over ten decades": _ten_decades,
    "made up: Pareto, index 1.5": _heavy,
    "made up: one run in 100 a thousand times worse": _outliers,
    "made up: two values, one in 20 runs": _two_values,
}
Task = tuple[str, str]


def pool(problem: str, search: str) -> Vector:
    """Return the final costs of every run of a pair, shape (POOL,)."""
    found = []
    for run in range(POOL):
        rng = generator("calibration", problem, search, run)
        result = SEARCHES[search].minimise(
            PROBLEMS[problem], population=POPULATION, iterations=ITERATIONS, rng=rng
        )
        found.append(result.cost)
    return np.array(found)


def of_pair(task: Task) -> list[Trial]:
    """Return what the judge says of tables of one search on one function."""
    costs, problem = pool(*task), PROBLEMS[task[0]]
    kind = kind_of(costs, problem)
    return [
        trial
        for repeats, table in product(REPEATS, range(TABLES))
        for trial in trials(
            drawn(
                costs,
                name="/".join((*task, str(table))),
                kind=kind,
                problem=problem,
                repeats=repeats,
                runs=RUNS,
            )
        )
    ]


def of_made_up(task: tuple[str, int]) -> list[Trial]:
    """Return what the judge says of tables of made-up costs, fresh ones for every table."""
    kind, repeats = task
    found: list[Trial] = []
    for table in range(MADE_UP_TABLES):
        name = f"{kind}/{table}"
        costs = MADE_UP[kind](generator("calibration", name, repeats), (repeats + 1) * RUNS)
        known = drawn(
            costs,
            name=name,
            kind=kind,
            problem=PROBLEMS["sphere"],  # whose minimum is 0
            repeats=repeats,
            runs=RUNS,
        )
        found += trials(known)
    return found


def document(real: list[Trial], made_up: list[Trial]) -> dict[str, object]:
    """Return what the file holds."""
    return {
        "rows": verdict_rows(real),
        "narrow": verdict_rows(
            trial for trial in real if trial.kind == "narrow" and trial.factor in ENDS
        ),
        "coverage": [*coverage_rows(real), *coverage_rows(made_up)],
        "by": {
            "searches": list(SEARCHES),
            "functions": {name: problem.dimension for name, problem in PROBLEMS.items()},
            "made up": list(MADE_UP),
            "population": POPULATION,
            "iterations": ITERATIONS,
            "runs": RUNS,
            "repeats": list(REPEATS),
            "runs of a pair": POOL,
            "tables of a pair": TABLES,
            "tables of a made-up kind": MADE_UP_TABLES,
            "pairs of a kind": {kind: _pairs(real, kind) for kind in KINDS},
            "told apart": {f"{factor:g}": _told_apart(real, factor) for factor in FACTORS},
            "seeds": f"as runs of papers, by name: {NAMES}",
        },
    }


def _told_apart(real: list[Trial], factor: float) -> float:
    """Return the share of values whose print shows that they are so many times as far off."""
    tried = Counter(trial.factor for trial in real)
    return round(tried[factor] / tried[1.0], 4)


def _pairs(real: list[Trial], kind: str) -> int:
    every = len(REPEATS) * len(KNOWN) * TABLES
    return sum(trial.kind == kind and trial.factor == 1 for trial in real) // every


def written(contents: Mapping[str, object]) -> str:
    """Return JSON with one row a line."""

    def lines() -> Iterator[str]:
        for key, value in contents.items():
            if isinstance(value, list):
                rows: list[Row] = value
                inside = ",\n  ".join(json.dumps(row, ensure_ascii=False) for row in rows)
                yield f' "{key}": [\n  {inside}\n ]'
            else:
                yield f' "{key}": {json.dumps(value, ensure_ascii=False)}'

    return "{\n" + ",\n".join(lines()) + "\n}\n"


def main(file: Path = FILE) -> None:
    """Run everything on every core, and write the file."""
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as executor:
        made_up = [executor.submit(of_made_up, task) for task in product(MADE_UP, REPEATS)]
        real = []
        for task, found in zip(
            product(PROBLEMS, SEARCHES),
            executor.map(of_pair, product(PROBLEMS, SEARCHES)),
            strict=True,
        ):
            real += found
            sys.stdout.write(f"{' on '.join(reversed(task))}: {found[0].kind}\n")
            sys.stdout.flush()
        others = [trial for future in made_up for trial in future.result()]
    file.write_text(written(document(real, others)), encoding="utf-8")


if __name__ == "__main__":
    main()
