"""A comparison whose runs a real Dask cluster makes; `nox -s cluster` runs it."""

import json
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.determinism.edited_packages import forget
from tests.runs.workers.test_real_cluster import Dask
from tests.small_papers import PAPER, let_be_known

MODULE = """
def sample(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    return min(points, key=cost)
"""


@pytest.fixture
def dask(tmp_path: Path) -> Iterator[Dask]:
    """Return a cluster that is started by the test and killed after it."""
    dask = Dask(tmp_path)
    yield dask
    dask.stop()


def rows(folder: str) -> list[dict[str, object]]:
    found = json.loads(Path(folder, "sample.json").read_text())["runs"]
    return [{name: row[name] for name in row if name != "seconds"} for row in found]


@pytest.mark.cluster
def test_a_cluster_makes_the_runs_that_this_machine_makes(
    dask: Dask, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    let_be_known(monkeypatch, PAPER)
    (tmp_path / "mine.py").write_text(MODULE)
    forget()
    dask.start(2)
    at = (("--dask", dask.address), ("--workers", "1"))
    places = [("--store", f"store-{k}", "--reports", f"pages-{k}") for k in range(2)]

    codes = [
        main(("compare", "mine:sample", *how, *to)) for how, to in zip(at, places, strict=True)
    ]
    sys.modules.pop("mine", None)

    assert codes == [0, 0]
    assert capfd.readouterr().err.count("3/3 runs (100 %)") == 2
    assert rows("pages-0") == rows("pages-1")
    assert len(rows("pages-0")) == 3
