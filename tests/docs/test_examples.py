"""The examples of the manual, run as they stand."""

import importlib.util
import runpy
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from repro.model.evidence import Evidence, Runs
from repro.robotics.proofs.least_time import least_time
from repro.runs.plan import plan
from repro.runs.run import execute
from tests.small_papers import searching

FOLDER = Path(__file__).parents[2] / "docs" / "examples"
PARTS = sorted(path.name for path in FOLDER.glob("*.py"))


def example(name: str) -> dict[str, Any]:
    """Return what an example defines, as a module whose source can be found."""
    spec = importlib.util.spec_from_file_location(f"example_{name}", FOLDER / f"{name}.py")
    assert spec
    assert spec.loader
    module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return vars(module)


@pytest.mark.parametrize("name", ["own_cost", "compiled_kernel", "own_function", "own_law"])
def test_example_prints_a_small_number_when_it_is_run(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    runpy.run_path(str(FOLDER / f"{name}.py"), run_name="__main__")

    assert 0.0 <= float(capsys.readouterr().out.split()[0]) < 3.0


def test_both_searches_of_the_example_keep_the_rules() -> None:
    experiment = example("own_search")["EXPERIMENT"]
    paper = replace(searching(), experiments=(experiment,))

    records = [execute(task) for task in plan([paper], 1, protocol_only=True)]

    assert [record.reason for record in records] == [None] * 6
    assert {record.evaluations for record in records} == {50}


def test_least_time_along_the_law_of_the_example_is_proved() -> None:
    motion = example("own_law")["MOTION"]

    assert least_time(motion).minimum == pytest.approx(motion.shortest().sum())


def test_measure_of_the_example_is_the_share_and_its_draws_vary_about_it() -> None:
    cell = ("search", "bowl", "guess")
    costs = np.linspace(0.0, 1.0, 40).reshape(2, 20)
    runs = Runs(costs=costs, points=costs[..., None], histories=costs[..., None], evaluations=20)
    measure = example("own_measure")["ShareBelow"](cell=cell, threshold=0.25)

    found = measure.measure(Evidence(key="small2020", experiments=(), runs={cell: runs}))

    assert found.value == 50.0
    assert found.draws.min() < 25.0 < found.draws.max()


@pytest.mark.parametrize("name", PARTS)
def test_example_is_short_and_stands_in_the_manual(name: str) -> None:
    page = (FOLDER.parent / "own_parts.md").read_text(encoding="utf-8")

    assert len((FOLDER / name).read_text(encoding="utf-8").splitlines()) <= 40
    assert f"literalinclude}} examples/{name}" in page
