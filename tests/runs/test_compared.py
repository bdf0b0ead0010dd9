from pathlib import Path

import pytest

from repro.commands.catalogue import all_papers
from repro.optimisers.random_search import RandomSearch
from repro.runs.compared import Compared, beside, narrowed, recalled, remember
from repro.runs.plan import plan
from tests.house import PAPERS

WITH_RUNS = [key for key, paper in PAPERS.items() if paper.experiments]


@pytest.mark.parametrize("key", WITH_RUNS)
def test_a_paper_is_narrowed_to_each_of_its_problems(key: str) -> None:
    paper = all_papers()[key]
    places = [(e.name, problem) for e in paper.experiments for problem in e.problems]
    keys = {task.key for task in plan([paper], 2)}

    for experiment, problem in places:
        own = narrowed(
            paper, {"own": RandomSearch()}, experiments=[experiment], problems=[problem], runs=2
        )

        assert [(t.experiment, t.problem) for t in plan([own], 1, protocol_only=True)] == [
            (experiment, problem)
        ] * 2
        others = plan([beside(paper, own)], 2)
        assert {task.problem for task in others} == {problem}
        assert {task.key for task in others} <= keys


def test_a_list_of_searches_keeps_a_folder_whose_name_is_no_text(tmp_path: Path) -> None:
    found = Compared(
        paper="p", name="鲸", place="m:f", experiments=(), problems=(), runs=None, repeats=1,
        folder="/a\udcff",
    )  # fmt: skip
    said: list[str] = []

    remember(tmp_path, [found], said.append)
    assert recalled(tmp_path) == [found]

    (tmp_path / "compared.json").write_text("<<<<<<<")
    assert recalled(tmp_path) is None
    remember(tmp_path, [found], said.append)
    assert recalled(tmp_path) == [found]
    assert "it is set aside as" in said[0]
    assert (tmp_path / "compared-set-aside-1.json").read_text() == "<<<<<<<"
