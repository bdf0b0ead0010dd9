from dataclasses import replace

import pytest

from papers.liang2026 import PAPER as LIANG
from repro.model.assumptions import Alternative, Assumption
from repro.optimisers.libraries import BASELINES
from repro.optimisers.random_search import RandomSearch
from repro.runs.baseline_study import AS_LONG, with_baselines
from repro.runs.moved_optima import CONTROL, FLOOR
from repro.runs.plan import deeper_tasks, plan
from repro.runs.studies import Study, kinds_of, studies, study_name
from tests.runs.test_equal_budget import PROTOCOL
from tests.small_papers import PAPER

OPEN = Assumption(
    what="width",
    chosen="ours",
    alternatives=(
        Alternative(
            name="wider", says="three times", algorithms={("search", "guess"): {"width": 3.0}}
        ),
    ),
    because="so",
    where="p. 3",
)
OPEN_PAPER = replace(PAPER, assumptions=(OPEN,))


def test_single_repeat_is_a_quick_look_without_studies() -> None:
    assert studies(OPEN_PAPER, 1) == ()


def test_other_reading_runs_what_it_changes_under_a_name_of_its_own() -> None:
    reading = next(study for study in studies(OPEN_PAPER, 2) if study.kind == "reading")

    assert (reading.of, reading.departs) == ("search", "wider")
    assert reading.experiment.name == study_name("search", "wider") == "search [wider]"
    assert set(reading.experiment.algorithms) == {"guess"}


def test_reading_is_run_once_however_often_the_protocol_is_until_it_seems_to_turn() -> None:
    repeats = {
        count: {study.repeats for study in studies(OPEN_PAPER, count) if study.kind == "reading"}
        for count in (2, 10, 20)
    }

    assert repeats == {2: {1}, 10: {1}, 20: {1}}


def test_control_has_no_studies_but_its_readings() -> None:
    control = replace(LIANG, control=True)

    assert {study.kind for study in studies(control, 10)} == {"reading"}


def test_reading_at_full_depth_is_repeated_as_the_protocol_is() -> None:
    (alternative,) = OPEN.alternatives
    beside = replace(OPEN, alternatives=(replace(alternative, full_depth=True),))
    paper = replace(PAPER, assumptions=(beside,))

    (reading,) = (study for study in studies(paper, 10) if study.kind == "reading")

    assert reading.repeats == 10


def test_deeper_tasks_are_those_of_the_plan_and_more_of_the_same() -> None:
    others = studies(OPEN_PAPER, 10)
    cell = ("search [wider]", "bowl", "guess")
    planned = [task for task in plan([OPEN_PAPER], 10) if task.experiment == cell[0]]

    deeper = deeper_tasks(OPEN_PAPER, others, {cell: 2})

    assert len(deeper) == 2 * len(planned)
    assert [task.key for task in deeper[: len(planned)]] == [task.key for task in planned]
    assert {(t.experiment, t.problem, t.algorithm) for t in deeper} == {cell}


def test_runs_of_a_study_come_after_every_protocol_and_have_seeds_of_their_own() -> None:
    tasks = plan([OPEN_PAPER, replace(OPEN_PAPER, key="other2021")], 2)
    names = [task.name for task in tasks]

    first = next(i for i, task in enumerate(tasks) if "[" in task.experiment)
    assert all("[" in task.experiment for task in tasks[first:])
    assert len(set(names)) == len(names)


def test_functions_with_their_optimum_about_the_centre_are_run_with_it_moved_aside() -> None:
    found = [study for study in studies(LIANG, 10) if study.kind == "shift"]

    assert [study.departs for study in found] == ["shift 0", "shift 0.1", "shift 0.2", "shift 0.4"]
    assert {(study.of, study.repeats) for study in found} == {("benchmark", 1)}
    assert found[2].experiment.name == "benchmark [shift 0.2]"
    assert set(found[0].experiment.algorithms) == {CONTROL, FLOOR}
    assert isinstance(found[2].experiment.algorithms[FLOOR], RandomSearch)


def fair(repeats: int) -> dict[str, Study]:
    paper = replace(PAPER, experiments=(PROTOCOL,), results=(), claims=())
    return {s.departs: s for s in studies(paper, repeats) if s.kind in ("baseline", "equal budget")}


def test_baselines_and_equal_budgets_wait_for_ten_repeats() -> None:
    assert fair(9) == {}
    assert {study.repeats for study in fair(20).values()} == {1}


def test_every_baseline_runs_on_every_problem_and_a_compiled_one_as_often_as_the_protocol() -> None:
    few, compiled = (fair(10)[name].experiment for name in ("baselines", "compiled baselines"))

    assert (few.name, few.runs) == ("search [baselines]", 1)
    assert (list(compiled.algorithms), compiled.runs) == (["random search"], PROTOCOL.runs)
    assert {**few.algorithms, **compiled.algorithms} == BASELINES
    assert few.problems == compiled.problems == PROTOCOL.problems


@pytest.mark.parametrize("repeats", [10, 20, 50])
def test_baselines_in_python_cost_at_most_a_quarter_of_them_and_the_protocol(repeats: int) -> None:
    experiment = next(each for each in LIANG.experiments if each.name == "benchmark")

    few = with_baselines(experiment, repeats)["baselines"]

    protocol = repeats * experiment.runs * len(experiment.algorithms)
    in_python, one_more = (
        AS_LONG * runs * len(few.algorithms) for runs in (few.runs, few.runs + 1)
    )
    assert in_python / (in_python + protocol) <= 0.25 < one_more / (one_more + protocol)


def test_algorithms_of_another_budget_run_as_often_as_in_the_protocol() -> None:
    study = fair(10)["equal budget"].experiment

    assert (study.name, set(study.algorithms)) == ("search [equal budget]", {"DE", "GA"})
    assert (study.runs, study.evaluations) == (PROTOCOL.runs, 240)


def test_kinds_that_were_run_are_told_and_no_others() -> None:
    found = studies(OPEN_PAPER, 10)
    names = {study.kind: study.experiment.name for study in found}

    assert kinds_of(found, set(names.values())) == ("other readings", "baselines")
    assert kinds_of(found, {names["reading"]}) == ("other readings",)
    assert kinds_of(found, ()) == ()
