"""The adapters of the manual, each where its library is installed (`nox -s adapters`)."""

import json
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.small_papers import EXPERIMENT, PAPER, let_be_known

FOLDER = Path(__file__).parents[2] / "docs" / "adapters"
PLACES = {
    "scipy": ("with_scipy:EVOLUTION", "with_scipy:ANNEALING", "with_scipy:divided"),
    "cma": ("with_cma:evolve",),
    "pymoo": ("with_pymoo:evolve",),
    "mealpy": ("with_mealpy:whale",),
    "niapy": ("with_niapy:wolves",),
    "nevergrad": ("with_nevergrad:one_plus_one",),
    "optuna": ("with_optuna:parzen",),
}
WHOLE = replace(PAPER, experiments=(replace(EXPERIMENT, population=20, iterations=10),))


def test_every_adapter_of_the_manual_is_tried() -> None:
    assert {path.stem for path in FOLDER.glob("*.py")} == {f"with_{name}" for name in PLACES}


@pytest.mark.adapters
@pytest.mark.parametrize("library", PLACES)
def test_library_runs_within_its_budget_and_comes_out_again(
    library: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip(library)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path, str(FOLDER)])

    let_be_known(monkeypatch, WHOLE)

    assert main(("compare", *PLACES[library], "--timeout", "120", "--quiet")) == 0

    (page,) = Path("reports-private").glob("*.json")
    found = json.loads(page.read_text())
    assert all(0 < row["evaluations"] <= 200 for row in found["runs"])
    kinds = {warned["kind"] for warned in found["warnings"]}
    assert kinds <= ({"identical runs"} if library == "scipy" else set())
