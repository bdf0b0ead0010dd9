import importlib
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.commands.catalogue import all_papers
from repro.determinism.seeds import generator
from repro.errors import InputError
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.runs.plan import Task, plan
from repro.runs.studies import studies
from tests.determinism.edited_packages import forget
from tests.house import PAPERS
from tests.small_papers import EXPERIMENT, PAPER, Bowl, Guessing, searching

KERNEL = """
def slope(x, data):
    return float(x.sum())
"""
PROBLEM = f"""
from tests.small_papers import Bowl
{KERNEL}
class Slope(Bowl):
    @property
    def kernel(self):
        return slope
"""


@dataclass(frozen=True)
class Lent(Bowl):
    """A problem whose kernel comes from another module."""

    module: Any = None

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (as in the protocol)
        """The cost."""
        return self.module.slope


def with_experiment(**changes: Any) -> Paper:  # noqa: ANN401 (fields of several types)
    return replace(PAPER, experiments=(replace(EXPERIMENT, **changes),), results=(), claims=())


def keys(*papers: Paper, repeats: int = 2) -> dict[str, str]:
    return {task.name: task.key for task in plan(papers, repeats)}


def test_every_run_of_every_repeat_is_planned_once() -> None:
    tasks = plan([PAPER], 2)

    places = [(task.algorithm, task.repeat, task.run) for task in tasks]
    assert places == [(a, k, n) for a in ("guess", "wide") for k in (1, 2) for n in (1, 2, 3)]


def test_task_has_what_its_run_needs() -> None:
    task = plan([PAPER], 1)[3]

    assert task.name == "small2020/search/bowl/wide/1/1"
    assert (task.optimiser, task.subject) == (Guessing(width=4.0), Bowl())
    assert (task.population, task.iterations) == (4, 5)


def test_names_and_keys_are_unique() -> None:
    tasks = plan([*all_papers().values(), PAPER], 2)

    assert len({task.name for task in tasks}) == len(tasks)
    assert len({task.key for task in tasks}) == len(tasks)


@given(st.integers(1, 4), st.integers(1, 4))
def test_more_repeats_change_no_earlier_task(fewer: int, more: int) -> None:
    few, many = keys(PAPER, repeats=fewer), keys(PAPER, repeats=fewer + more)

    assert few.items() < many.items()


@pytest.mark.parametrize(
    "more",
    [
        with_experiment(runs=9),
        with_experiment(algorithms={"new": Guessing(width=2.0), **EXPERIMENT.algorithms}),
        with_experiment(problems={"new": Bowl(centre=(0.0,)), **EXPERIMENT.problems}),
        replace(PAPER, experiments=(replace(EXPERIMENT, name="new"), EXPERIMENT)),
    ],
    ids=["runs", "algorithm", "problem", "experiment"],
)
def test_addition_to_a_paper_changes_no_other_task(more: Paper) -> None:
    assert keys(PAPER).items() < keys(more).items()


def test_addition_of_a_paper_changes_no_other_task() -> None:
    other = replace(PAPER, key="other2021")

    assert keys(PAPER).items() < keys(other, PAPER).items()
    assert not keys(PAPER).items() & keys(other).items()


@pytest.mark.parametrize(
    "changed",
    [
        {"population": 5},
        {"iterations": 6},
        {"problems": {"bowl": Bowl(centre=(0.5, -0.2500001))}},
        {"algorithms": {"guess": Guessing(width=1.0000001), "wide": Guessing(width=4.0000001)}},
    ],
    ids=lambda changes: next(iter(changes)),
)
def test_change_of_what_decides_a_run_changes_its_key(changed: dict[str, object]) -> None:
    before, after = keys(PAPER), keys(with_experiment(**changed))

    assert before.keys() == after.keys()
    assert not before.items() & after.items()


def test_change_of_one_algorithm_changes_its_keys_alone() -> None:
    algorithms = {**EXPERIMENT.algorithms, "wide": Guessing(width=5.0)}

    same = keys(PAPER).items() & keys(with_experiment(algorithms=algorithms)).items()

    assert {name.split("/")[3] for name, _ in same} == {"guess"}


@pytest.fixture
def slope_keys(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """Yield what gives the keys of a problem whose module has some text."""
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr("sys.dont_write_bytecode", True)

    def found(text: str) -> dict[str, str]:
        (tmp_path / "borrowed_slope.py").write_text(text, encoding="utf-8")
        forget()
        module = importlib.reload(importlib.import_module("borrowed_slope"))
        problem = module.Slope() if "Slope" in text else Lent(module=module)
        return keys(with_experiment(problems={"slope": problem}))

    yield found
    forget()


@pytest.mark.parametrize("text", [KERNEL, PROBLEM], ids=["kernel", "problem"])
def test_change_in_the_code_of_a_problem_changes_its_keys(slope_keys: Any, text: str) -> None:  # noqa: ANN401
    before = slope_keys(text)

    assert not before.items() & slope_keys(text.replace("x.sum()", "-x.sum()")).items()


@pytest.mark.parametrize("text", [KERNEL, PROBLEM], ids=["kernel", "problem"])
def test_change_of_words_about_a_problem_changes_no_key(slope_keys: Any, text: str) -> None:  # noqa: ANN401
    before = slope_keys(text)

    assert slope_keys('"""A slope."""\n' + text + "# the end\n") == before


def test_change_of_texts_in_a_paper_changes_no_key() -> None:
    source = replace(PAPER.source, title="Another title")
    reworded = replace(PAPER, source=source, summary="Other words.", claims=(), results=())

    assert keys(reworded) == keys(PAPER)


def test_runs_that_are_drawn_as_others_share_their_stream_but_no_name_or_key() -> None:
    own = PAPER.experiments[0]
    aside = replace(own, name="aside", drawn_as=own.name)
    apart = replace(own, name="aside")
    first, second, third = (
        plan([replace(PAPER, experiments=(experiment,), results=(), claims=())], 1)[0]
        for experiment in (own, aside, apart)
    )

    assert first.stream == second.stream == first.name
    assert third.stream == third.name == second.name
    assert len({first.key, second.key, third.key}) == 3


def test_name_alone_seeds_a_run() -> None:
    def numbers(tasks: tuple[Task, ...]) -> dict[str, float]:
        return {task.name: generator(task.stream).random() for task in tasks}

    few, many = numbers(plan([PAPER], 1)), numbers(plan([searching(b=Guessing()), PAPER], 3))

    assert few.items() < many.items()
    assert len(set(many.values())) == len(many)


@pytest.mark.parametrize("repeats", [0, -1])
def test_less_than_one_repeat_is_refused(repeats: int) -> None:
    with pytest.raises(InputError, match=f"repeats is {repeats}; it must be 1 or more"):
        plan([PAPER], repeats)


@pytest.mark.parametrize("key", PAPERS)
def test_plan_of_a_paper_has_the_sizes_that_it_declares(key: str) -> None:
    paper = all_papers()[key]

    def size(experiment: Experiment) -> int:
        return len(experiment.problems) * len(experiment.algorithms) * experiment.runs

    besides = sum(study.repeats * size(study.experiment) for study in studies(paper, 2))
    assert len(plan([paper], 2)) == 2 * sum(map(size, paper.experiments)) + besides
