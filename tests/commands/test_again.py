import json
import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
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
    assert "<br>477.30, " in pages["doe2021.md"]


def test_the_text_says_where_the_number_stands_and_what_is_accepted() -> None:
    lines = again("table-3-woa-mean").text.splitlines()

    assert lines[0] == "Table 3, WOA, mean"
    assert lines[1].split() == ["printed", "2.357", "s"]
    assert lines[3].split()[0] == "interval"
    assert lines[4] == "  accepted  2.3329 … 2.3811 s (within 1 % and the printed rounding)"
    assert lines[5].startswith("  verdict   ")
    assert "provisional: one repeat only" in lines[5]


def test_the_verdict_says_on_which_side_the_rerun_lies() -> None:
    text = again("table-2-f1-mean-pso").text

    assert "  interval  173.1 … 2070\n" in text
    assert "  verdict   ✖ contradicted (re-run higher); provisional: one repeat only\n" in text


def test_what_the_pages_say_stands_beside_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pages = pages_of(tmp_path)
    (finding,) = (
        one
        for one in json.loads(pages["results.json"])["papers"][0]["findings"]
        if (one["row"], one["column"]) == ("F1 Mean", "PSO")
    )
    monkeypatch.setattr("repro.commands.catalogue.chosen_one", lambda _: PAPER)
    asked = ["again", "doe2021", "table-2-f1-mean-pso", "--workers", "1"]

    codes = [
        main([*asked, "--reports", str(tmp_path / "reports")]),
        main([*asked, "--master-seed", "b"]),
    ]
    first, other = capsys.readouterr().out.split("Table 2, F1 Mean, PSO\n")[1:]

    assert codes == [0, 0]
    repeats = f"by {finding['repeats']} repeats; re-run 689.8, as here"
    assert re.search(
        rf"  its page  ✖ contradicted \(re-run higher\); interval .* {repeats}\n", first
    )
    assert "its page" not in other


def test_a_claim_in_words_is_run_again_on_all_that_it_compares() -> None:
    found = again("claim-woa-is-best-on-f1")

    assert found.runs == 2 * TEST.runs
    assert "printed   in words" in found.text


def test_a_part_of_a_name_is_enough_where_only_one_has_it() -> None:
    assert named_claim(PAPER, "f1-mean-pso") == named_claim(PAPER, "table-2-f1-mean-pso")


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("table-2-f1-mean", "2 numbers named .*; these: table-2-f1-mean-woa, table-2-f1-mean-pso"),
        ("table-2", "4 numbers named 'table-2'; these: (table-2[^,]*, ){2}[^,]* and 1 more"),
        ("Tabel 3 WOA mean", "no number named .*; the most like it: table-3-woa-mean, "),
        ("the-woa-of-f1-best", "no number named .*; the most like it: table-2-f1-best-woa, "),
        ("#", "no number named '#'; the most like it: "),
    ],
)
def test_a_name_of_none_or_of_several_is_refused_in_a_line_with_names_like_it(
    name: str, said: str
) -> None:
    with pytest.raises(InputError, match=rf"^doe2021 has {said}[^\n]*$"):
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
