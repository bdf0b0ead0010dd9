from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import pytest

from repro.commands import compiled_code
from repro.commands.compiled_code import compiling_ahead
from repro.determinism import compiled
from repro.functions import FUNCTIONS
from repro.optimisers import PSO, WOA
from repro.runs.plan import Task, plan
from repro.runs.run import execute
from tests.small_papers import EXPERIMENT, PAPER, Guessing

PROBLEMS = {name: FUNCTIONS[name].problem(2) for name in ("sphere", "rastrigin")}
SEARCHES = {"WOA": WOA(), "other WOA": WOA(b=2.0), "PSO": PSO(), "guess": Guessing()}
SEARCH = replace(EXPERIMENT, problems=PROBLEMS, algorithms=SEARCHES, proposed="WOA", population=8)
TASKS = plan([replace(PAPER, experiments=(SEARCH,), results=(), claims=())], 1)


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[Task]:
    """Return the runs that a copy makes, which are made here."""
    found: list[Task] = []

    @contextmanager
    def at_once(call: Callable[[], object]) -> Iterator[None]:
        call()
        yield

    monkeypatch.setattr(compiled_code, "usable_cores", lambda: 2)
    monkeypatch.setattr(compiled_code, "beside", at_once)
    monkeypatch.setattr(compiled_code, "execute", found.append)
    return found


def test_each_search_of_ours_is_made_once_on_each_function_last_first(
    made: list[Task], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(compiled, "KEPT", tmp_path)
    with compiling_ahead(TASKS):
        pass
    assert [(task.algorithm, task.problem) for task in made] == [
        (search, function) for function in ("rastrigin", "sphere") for search in ("PSO", "WOA")
    ]
    assert all(execute(task).reason is None and task.iterations == 1 for task in made)


def test_nothing_is_compiled_ahead_where_searches_are_compiled(
    made: list[Task], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    execute(TASKS[0])
    assert compiled.KEPT is not None
    with compiling_ahead(TASKS):
        pass
    assert made == []
    monkeypatch.setattr(compiled, "KEPT", tmp_path)
    monkeypatch.setattr(compiled_code, "usable_cores", lambda: 1)
    with compiling_ahead(TASKS):
        pass
    assert made == []


def test_nothing_is_compiled_here_for_runs_that_are_made_elsewhere(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(compiled, "KEPT", tmp_path)
    monkeypatch.setattr(compiled_code, "beside", pytest.fail)
    with compiling_ahead():
        pass


def test_a_copy_whose_process_died_compiles_nothing_more(
    made: list[Task], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    parents = iter([1, 1, 2])
    monkeypatch.setattr("os.getppid", lambda: next(parents))
    monkeypatch.setattr(compiled, "KEPT", tmp_path)
    with compiling_ahead(TASKS):
        pass
    assert len(made) == 1
