"""The notebook of the manual, run in a kernel of its own."""

import asyncio
import warnings
from pathlib import Path
from typing import Any

import pytest

from tests.made_up import pages_of

ROOT = Path(__file__).parents[2]
NOTEBOOK = ROOT / "docs" / "examples" / "results.ipynb"


def outputs(folder: Path, notebook: Path) -> list[Any]:
    """Run a notebook in a folder, and return what its cells show."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the kernel's own libraries
        import nbformat  # noqa: PLC0415
        from nbclient import NotebookClient  # noqa: PLC0415

        content = nbformat.read(notebook, as_version=4)
        client = NotebookClient(content, timeout=120, resources={"metadata": {"path": folder}})
        done = asyncio.run(client.async_execute())
    return [output for cell in done.cells for output in cell["outputs"]]


def test_the_notebook_loads_results_and_draws_two_figures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pages_of(tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    monkeypatch.delenv("MPLBACKEND", raising=False)

    shown = outputs(tmp_path, NOTEBOOK)

    kinds = [set(output.get("data", {})) for output in shown]
    assert sum("image/png" in kind for kind in kinds) == 2
    assert "consistent" in str(shown[0])
