import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

from repro.commands.again import Again, RunFailedError, named_claim, run_again
from repro.errors import InputError
from repro.model.paper import Paper
from tests.doe2021 import PAPER, TEST
from tests.made_up import pages_of
from tests.small_papers import Failing


def again(
    name: str, paper: Paper = PAPER, master_seed: str = "", folder: Path | None = None
) -> Again:
    with ThreadPoolExecutor(2) as executor:
        return run_again(
            paper, name, executor=executor, workers=2, master_seed=master_seed, folder=folder
        )


def test_the_number_comes_out_as_the_page_shows_it(tmp_path: Path) -> None:
    pages = pages_of(tmp_path)
    results = json.loads(pages["results.json"])
    values = {
        f["row"]: f["value"] for f in results["papers"][0]["findings"] if f["column"] == "WOA"
    }

    found = again("table-2-f1-mean-woa")

    assert found.value == values["F1 Mean"]
    assert found.runs == TEST.runs
    assert "re-run    477.30 (mean cost of WOA on F1; first repeat, 4 runs)" in found.text
    assert "<br>477.30<br>" in pages["doe2021.md"]


def test_the_text_says_where_the_number_stands_and_what_is_accepted() -> None:
    lines = again("table-3-woa-mean").text.splitlines()

    assert lines[0] == "Table 3, WOA, mean"
    assert lines[1].split() == ["printed", "2.357", "s"]
    assert lines[3].split() == ["accepted", "2.3329", "…", "2.3811", "s"]


def test_a_claim_in_words_is_run_again_on_all_that_it_compares() -> None:
    found = again("claim-woa-is-best-on-f1")

    assert found.runs == 2 * TEST.runs
    assert "printed   in words" in found.text


def test_a_part_of_a_name_is_enough_where_only_one_has_it() -> None:
    assert named_claim(PAPER, "f1-mean-pso") == named_claim(PAPER, "table-2-f1-mean-pso")


@pytest.mark.parametrize(("name", "count"), [("table-2-f1-mean", "2"), ("F9", "no")])
def test_a_name_of_none_or_of_several_is_refused_with_names_that_fit(name: str, count: str) -> None:
    with pytest.raises(InputError, match=f"has {count} numbers named '{name}'.*\\n +table-2-f1-"):
        named_claim(PAPER, name)


def test_a_number_that_the_paper_gives_no_way_to_run_says_so() -> None:
    with pytest.raises(InputError, match="cannot be run: no motion is printed"):
        again("claim-the-simulator-shows-3-s")


def test_a_run_that_fails_is_named() -> None:
    broken = replace(TEST, algorithms={**TEST.algorithms, "WOA": Failing()})
    others = PAPER.experiments[1:]
    paper = replace(PAPER, experiments=(broken, *others), assumptions=(), together=(), figures=())

    with pytest.raises(RunFailedError, match=r"doe2021/test/F1/WOA/1/. failed: .*lost the way"):
        again("table-2-f1-mean-woa", paper)


def test_another_master_seed_gives_another_number_and_the_same_one_each_time() -> None:
    first, second = (again("table-2-f1-mean-woa", master_seed="b").value for _ in range(2))

    assert first == second != again("table-2-f1-mean-woa").value


def test_a_store_gives_the_runs_that_it_has_and_keeps_those_that_it_lacks(tmp_path: Path) -> None:
    first, second = (again("table-2-f1-mean-woa", folder=tmp_path) for _ in range(2))

    assert (first.stored, second.stored) == (0, TEST.runs)
    assert first.value == second.value == again("table-2-f1-mean-woa").value
    assert "first repeat, 4 runs, 4 of them from the store" in second.text
