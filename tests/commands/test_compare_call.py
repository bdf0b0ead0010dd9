"""Comparing from Python, and a notebook that does it with a function of a cell."""

import os
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

import repro
from repro.errors import InputError

CELLS = (
    (
        "import repro, numpy as np\n"
        "SHARE = 1.0\n"
        "def from_cell(cost, bounds, budget, rng):\n"
        "    points = rng.uniform(*bounds.T, size=(int(SHARE * budget), len(bounds)))\n"
        "    return points[np.argmin(cost(points))]"
    ),
    (
        "found = repro.compare(from_cell, papers=['liang2026'], experiments=['benchmark'],\n"
        "                      problems=['F1'], runs=2)\n"
        "found"
    ),
    "print(len(found.runs), sorted(set(found.runs.problem)), [w.kind for w in found.warnings])",
)


def test_function_of_a_cell_is_compared_and_its_result_draws_itself(tmp_path: Path) -> None:
    v4: Any = nbformat.v4
    notebook = v4.new_notebook(cells=[v4.new_code_cell(c) for c in CELLS])
    client = NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}})

    root = str(Path(__file__).parents[2])
    client.execute(env={**os.environ, "PYTHONPATH": root})

    drawn, printed = (cell["outputs"] for cell in notebook["cells"][1:])
    pages = [out["data"].get("text/html", "") for out in drawn if "data" in out]
    assert any("<progress" in page and "2 of 2 runs" in page for page in pages)
    assert any("iframe" in page and "from_cell" in page for page in pages)
    assert printed[0]["text"] == "2 ['F1'] []\n"


def test_what_is_no_search_is_refused() -> None:
    with pytest.raises(InputError, match="number is neither an object with minimise"):
        repro.compare(3, papers=["liang2026"], name="number")
