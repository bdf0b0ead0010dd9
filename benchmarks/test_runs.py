"""What the runs of the mission's papers take, as this checkout's store has them."""

import sqlite3
from collections import Counter
from collections.abc import Container, Mapping
from contextlib import closing

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.goals import measured
from benchmarks.measuring import timed
from benchmarks.results import Results, Section
from benchmarks.test_pages import STORE
from repro.commands.catalogue import all_papers
from repro.runs.plan import plan
from repro.runs.store.questions import Kind
from repro.runs.store.store import Store
from repro.runs.time_left import kind_of

TEN = 10  # the default number of repeats
MISSION = {key: paper for key, paper in all_papers().items() if not paper.control}
PARTS = ("protocol", "baselines", "other studies")
RUNS = Section(
    title="All runs of the mission's papers",
    text="Seconds that all planned runs take, by two cores, from what a run of each kind took in "
    "this checkout's store, where two ran at a time. Readings that seem to turn a verdict are "
    "deepened besides: the share is of the store's, of all that was run at ten repeats.",
    columns=("repeats", "on 2 cores [s]", *PARTS, "deepened"),
)


@pytest.mark.skipif(not STORE.exists(), reason="this checkout has no store")
def test_all_runs(benchmark: BenchmarkFixture, results: Results) -> None:
    mission = list(MISSION.values())
    with Store(STORE.parent, writing=False) as store:
        took = store.seconds()

    def whole(repeats: int) -> dict[str, float]:
        spent = dict.fromkeys(PARTS, 0.0)
        for kind, count in Counter(map(kind_of, plan(mission, repeats))).items():
            spent[part_of(kind)] += count * took[kind]
        return spent

    both = timed(benchmark, lambda: {repeats: whole(repeats) for repeats in (TEN, 2 * TEN)})
    deepened = beyond({task.key for task in plan(mission, TEN)}, took)
    for repeats, spent in both.items():
        seconds = sum(spent.values())
        shares = [measured(100 * part / seconds, ".0f %") for part in spent.values()]
        more = measured(100 * deepened / (deepened + seconds), ".0f %") if repeats == TEN else "—"
        results.add(RUNS, str(repeats), measured(seconds / 2, ".0f"), *shares, more)


def part_of(kind: Kind) -> str:
    """Return which part of a paper's runs a kind belongs to, by its experiment's name."""
    if "[" not in kind[1]:
        return "protocol"
    return "baselines" if "baselines]" in kind[1] else "other studies"


def beyond(planned: Container[str], took: Mapping[Kind, float]) -> float:
    """Return the seconds of the store's runs of readings of the mission that are not planned."""
    query = (
        "select key, paper, experiment, problem, algorithm from run where reason is null "
        "and experiment like '%[%' and experiment not like '%baselines]'"
    )
    with closing(sqlite3.connect(f"{STORE.as_uri()}?mode=ro", uri=True)) as database:
        return sum(
            took[paper, *rest]
            for key, paper, *rest in database.execute(query)
            if paper in MISSION and key not in planned
        )
