"""How the steps of a study grow with its runs, in processes of their own; see scale.py."""

from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.goals import measured as shown
from benchmarks.measuring import timed
from benchmarks.results import Results, Section
from benchmarks.scale import STEPS, exponent, measured

SIZES = (10**4, 10**5)
STUDIES = Section(
    title="Studies of many runs",
    text="Seconds by the clock of one step of a made-up study of short runs, each in a process of "
    "its own that loads and compiles first; `nox -s scale` goes on from here (docs/scale.md). The "
    "exponent is that of the seconds by the runs, the last column what each run more adds to the "
    "most memory that the process had: a plan of up to 200,000 runs is held, a longer one is not.",
    columns=("step", "runs", "s", "runs, more", "s, more", "exponent", "memory a run [B]"),
)


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    return {size: tmp_path_factory.mktemp("study") for size in SIZES}


@pytest.mark.parametrize("step", STEPS)
def test_step(
    benchmark: BenchmarkFixture, results: Results, folders: dict[int, Path], step: str
) -> None:
    def both() -> list[dict[str, float]]:
        return [measured(step, size, folder) for size, folder in folders.items()]

    found = timed(benchmark, both)
    points = [(each["runs"], each["seconds"]) for each in found]
    cells = [cell for count, taken in points for cell in (f"{count:.0f}", f"{taken:.1f}")]
    few, many = found
    more = (many["memory"] - few["memory"]) * 2**20 / (many["runs"] - few["runs"])
    results.add(STUDIES, step, *cells, shown(exponent(points), ".2f"), shown(more, ".0f"))
