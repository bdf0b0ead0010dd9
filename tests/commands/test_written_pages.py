import os
import threading
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

from repro.commands import written_pages
from repro.judge.deepening import Fetch
from repro.judge.judgement import Judgement, judge
from repro.model.evidence import Cell, Evidence, Runs
from repro.model.paper import Paper
from repro.runs.plan import Task, plan
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.studies import Study
from tests.runs.test_studies import OPEN_PAPER
from tests.small_stores import ENVIRONMENT

PAPERS = (replace(OPEN_PAPER, key="other2021"), OPEN_PAPER)
READING = ("search [wider]", "bowl", "guess")


@pytest.mark.parametrize("cores", [1, 2])
def test_a_paper_that_wants_deeper_runs_is_judged_once_and_gets_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, cores: int
) -> None:
    tasks = plan(PAPERS, 3)
    depths: list[int] = []
    where = tmp_path / "judged.txt"

    def deepening(
        paper: Paper, evidence: Evidence, others: Sequence[Study], fetch: Fetch
    ) -> Judgement:
        def noted(wanted: Mapping[Cell, int]) -> Mapping[Cell, Runs]:
            found = fetch(wanted)
            with where.open("a", encoding="utf-8") as file:
                file.write(f"{paper.key} {len(found[READING].costs)} {os.getpid()}\n")
            return found

        noted({READING: 2})
        evidence = evidence.deeper(noted({READING: 3}))
        return judge(paper, evidence, others)

    def run(more: Sequence[Task]) -> None:
        depths.append(max(task.repeat for task in more))
        fill(store, more)

    monkeypatch.setattr(threading, "active_count", lambda: 1)  # the runner's are none of ours
    monkeypatch.setattr(written_pages, "usable_cores", lambda: cores)
    monkeypatch.setattr(written_pages, "judge", deepening)
    with Store(tmp_path / "store") as store:
        fill(store, tasks)
        written_pages.write_pages(
            store, PAPERS, tasks, tmp_path / "reports", [paper.key for paper in PAPERS], run
        )
    said = [line.split() for line in where.read_text(encoding="utf-8").splitlines()]
    assert sorted(each[:2] for each in said) == [
        [paper.key, depth] for paper in PAPERS for depth in ("2", "3")
    ]
    assert sorted(depths) == [2, 2, 3, 3]
    assert (str(os.getpid()) in {each[2] for each in said}) == (cores == 1)


def fill(store: Store, tasks: Sequence[Task]) -> None:
    with ThreadPoolExecutor(1) as executor:
        run_missing(
            store,
            tasks,
            executor=executor,
            workers=1,
            environment=lambda: ENVIRONMENT,
            report=lambda *_: None,
        )
