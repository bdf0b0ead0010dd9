from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from repro.functions import FUNCTIONS
from repro.model.evidence import Evidence
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.optimisers import WOA
from repro.runs.gather import gather
from repro.runs.plan import Task, plan
from repro.runs.run import Record
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.studies import Study
from tests.small_papers import CLAIMS, EXPERIMENT, LOST, PAPER, Failing, Guessing, searching
from tests.small_stores import content

CELLS = {("search", "bowl", "guess"), ("search", "bowl", "wide")}


def run(folder: Path, tasks: list[Task], *, workers: int = 2, **options: Any) -> list[Record]:  # noqa: ANN401
    """Run what is missing in the store of a folder and return the failed runs."""
    options = {"environment": dict, "report": lambda _done, _total: None, **options}
    with Store(folder) as store, ThreadPoolExecutor(workers) as executor:
        return run_missing(store, tasks, executor=executor, workers=workers, **options)


def stored(folder: Path, tasks: list[Task]) -> list[tuple[object, ...]]:
    """Return the content of the stored records but the seconds that they took."""
    with Store(folder) as store:
        return [content(replace(record, seconds=0.0)) for record in store.records(tasks)]


def gathered(folder: Path, paper: Paper, tasks: list[Task]) -> Evidence:
    with Store(folder) as store:
        return gather(store, paper, tasks)


@pytest.fixture
def tasks() -> list[Task]:
    """Return plain and compiled searches."""
    compiled = replace(
        EXPERIMENT,
        name="compiled",
        problems={"rosenbrock": FUNCTIONS["rosenbrock"].problem(3)},
        algorithms={"WOA": WOA()},
        runs=8,
    )
    return list(plan([replace(PAPER, experiments=(EXPERIMENT, compiled))], 2, protocol_only=True))


def test_records_are_the_same_with_any_number_of_workers(tmp_path: Path, tasks: list[Task]) -> None:
    for workers in (1, 2, 4):
        assert run(tmp_path / str(workers), tasks, workers=workers) == []

    one, two, four = (stored(tmp_path / name, tasks) for name in ("1", "2", "4"))
    assert len(one) == len(tasks) == 28
    assert one == two == four


def test_records_are_the_same_in_any_order(tmp_path: Path, tasks: list[Task]) -> None:
    run(tmp_path / "forth", tasks)
    run(tmp_path / "back", tasks[::-1])

    assert stored(tmp_path / "forth", tasks) == stored(tmp_path / "back", tasks)


def test_second_session_runs_nothing(tmp_path: Path, tasks: list[Task]) -> None:
    run(tmp_path, tasks)

    def environment() -> dict[str, object]:
        pytest.fail("a run was to be made")

    assert run(tmp_path, tasks, environment=environment) == []


def test_session_runs_what_is_missing_alone(tmp_path: Path, tasks: list[Task]) -> None:
    states: list[tuple[int, int]] = []
    run(tmp_path, tasks[:20])

    run(tmp_path, tasks, report=lambda done, total: states.append((done, total)))

    assert states[-1] == (8, 8)
    assert [done for done, _ in states] == sorted(done for done, _ in states)


def test_environment_is_that_of_the_session_that_ran(tmp_path: Path, tasks: list[Task]) -> None:
    run(tmp_path, tasks[:2], environment=lambda: {"cores": 2})
    run(tmp_path, tasks[:3], environment=lambda: {"cores": 8})

    with Store(tmp_path) as store:
        assert store.environments(tasks[:2]) == [{"cores": 2}]
        assert store.environments(tasks[2:]) == [{"cores": 8}]


def test_failed_runs_are_returned_and_tried_again(tmp_path: Path) -> None:
    tasks = list(plan([searching(good=Guessing(), bad=Failing())], 1))

    for _ in range(2):
        failed = run(tmp_path, tasks)
        assert {record.reason for record in failed} == {LOST}
        assert sorted(record.task.name[-5:] for record in failed) == ["d/1/1", "d/1/2", "d/1/3"]


@pytest.mark.parametrize("batch", [1, 3])
def test_interrupted_session_goes_on_as_if_nothing_had_happened(
    tmp_path: Path, tasks: list[Task], batch: int
) -> None:
    states: list[int] = []

    def stop(done: int, _total: int) -> None:
        states.append(done)
        if len(states) == batch:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(tmp_path / "cut", tasks, report=stop, batch_seconds=0.0)
    kept = len(stored(tmp_path / "cut", tasks))
    run(tmp_path / "cut", tasks)
    run(tmp_path / "whole", tasks)

    assert 0 < kept < len(tasks)
    assert stored(tmp_path / "cut", tasks) == stored(tmp_path / "whole", tasks)


def test_evidence_has_every_run_in_its_place(tmp_path: Path) -> None:
    tasks = list(plan([PAPER], 2))
    run(tmp_path, tasks[::-1])

    found = gathered(tmp_path, PAPER, tasks)

    assert found.runs.keys() == CELLS
    runs = found.runs["search", "bowl", "wide"]
    assert (runs.costs.shape, runs.points.shape) == ((2, 3), (2, 3, 2))
    assert (runs.histories.shape, runs.evaluations) == ((1, 3, 5), 20)
    with Store(tmp_path) as store:
        first, second = store.records(
            [t for t in tasks if t.name.endswith(("wide/1/3", "wide/2/3"))]
        )
    assert (runs.costs[:, 2] == [first.cost, second.cost]).all()
    assert (runs.points[1, 2] == second.x).all()
    assert (runs.histories[0, 2] == first.history).all()


def test_histories_of_every_repeat_are_kept_where_a_claim_follows_the_search(
    tmp_path: Path,
) -> None:
    measure = Statistic(
        experiment="search",
        problem="bowl",
        algorithm="guess",
        statistic="mean",
        quantity="cost after 2 iterations",
    )
    claim = replace(CLAIMS[0], measure=measure)
    paper = replace(PAPER, claims=(claim, *CLAIMS[1:]))
    tasks = list(plan([paper], 2))
    run(tmp_path, tasks)

    found = gathered(tmp_path, paper, tasks)

    assert found.runs["search", "bowl", "guess"].histories.shape == (2, 3, 5)
    assert found.runs["search", "bowl", "wide"].histories.shape == (1, 3, 5)
    assert found.values(("search", "bowl", "guess"), "cost after 2 iterations").shape == (2, 3)


def test_histories_of_every_repeat_of_a_reading_are_kept_where_a_claim_follows_the_search(
    tmp_path: Path,
) -> None:
    measure = Statistic(
        experiment="search",
        problem="bowl",
        algorithm="guess",
        statistic="mean",
        quantity="cost after 2 iterations",
    )
    paper = replace(PAPER, claims=(replace(CLAIMS[0], measure=measure), *CLAIMS[1:]))
    other = replace(EXPERIMENT, name="search [other]")
    reading = Study(kind="reading", of="search", departs="other", experiment=other, repeats=2)
    tasks = list(plan([replace(paper, experiments=(EXPERIMENT, other))], 2, protocol_only=True))
    run(tmp_path, tasks)

    with Store(tmp_path) as store:
        found = gather(store, paper, tasks, [reading])

    assert found.runs["search [other]", "bowl", "guess"].histories.shape == (2, 3, 5)
    assert found.runs["search [other]", "bowl", "wide"].histories.shape == (1, 3, 5)


def test_repeat_that_is_not_whole_is_no_evidence(tmp_path: Path) -> None:
    tasks = list(plan([PAPER], 2))
    run(tmp_path, [task for task in tasks if not task.name.endswith(("guess/2/3", "wide/1/1"))])

    found = gathered(tmp_path, PAPER, tasks)

    assert {cell[2]: len(runs.costs) for cell, runs in found.runs.items()} == {
        "guess": 1,
        "wide": 1,
    }
    whole = gathered(tmp_path, PAPER, tasks[-3:]).runs["search", "bowl", "wide"]
    assert (found.runs["search", "bowl", "wide"].costs == whole.costs).all()


def test_failed_run_makes_its_repeat_no_evidence(tmp_path: Path) -> None:
    paper = searching(guess=Guessing(), bad=Failing())
    tasks = list(plan([paper], 1))
    run(tmp_path, tasks)

    assert gathered(tmp_path, paper, tasks).runs.keys() == {("search", "bowl", "guess")}


def test_evidence_of_one_paper_holds_no_run_of_another(tmp_path: Path) -> None:
    other = replace(PAPER, key="other2021")
    tasks = list(plan([PAPER, other], 1))
    run(tmp_path, tasks)

    costs = [
        gathered(tmp_path, p, tasks).runs["search", "bowl", "guess"].costs for p in (PAPER, other)
    ]

    assert costs[0].shape == costs[1].shape == (1, 3)
    assert not np.isin(costs[0], costs[1]).any()
