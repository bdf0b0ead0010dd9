"""The page of words that a table may print says what there is, and nothing else."""

import re
from pathlib import Path

import pytest

import repro.model
from repro.functions import FUNCTIONS
from repro.model.cell_measures import is_printable
from repro.model.experiment import Experiment
from repro.optimisers import WOA
from repro.optimisers.random_search import RandomSearch
from repro.statistics.summary import STATISTICS
from repro.tables.published import PublishedTable

PAGE = (Path(__file__).parents[2] / "docs" / "printed.md").read_text(encoding="utf-8")
WORDS = re.findall(r"`([^`]+)`", "".join(re.findall(r"^\| (`.+?) \|", PAGE.partition("## Units")[0],
                                                   flags=re.MULTILINE)))  # fmt: skip
CALLS = re.findall(
    r"`([A-Za-z]\w+)\(", PAGE.partition("## What printed")[2].partition("## Near")[0]
)


@pytest.mark.parametrize("word", [*WORDS, *STATISTICS])
def test_every_word_of_the_page_is_known(word: str) -> None:
    assert is_printable(word)


def test_every_usual_statistic_stands_on_the_page() -> None:
    assert set(STATISTICS) <= set(WORDS)
    assert len(WORDS) > 20


@pytest.mark.parametrize("name", CALLS)
def test_every_relation_and_measure_of_the_page_can_be_imported(name: str) -> None:
    assert name in vars(repro.model)


def test_table_of_the_page_is_read() -> None:
    part = PAGE.partition("## Units")[2]
    drawn = "\n".join(re.findall(r"^    (.+\|\|.+)$", part, flags=re.MULTILINE))

    table = PublishedTable.read(f"Table 1\n{drawn}")

    assert table["time std", "WOA"].si == pytest.approx(4e-4)
    assert table.row_names[-1] == "successes"


def test_headings_under_others_are_read_as_the_page_says() -> None:
    part = PAGE.partition("Headings that stand under others")[2]
    drawn = "\n".join(
        re.findall(r"^      (.*\|\|.+)$", part.partition("- Two headings")[0], flags=re.MULTILINE)
    )
    (call,) = re.findall(r"`(every_cell\(.+?\)\))`", part)
    table = PublishedTable.read(f"Table 1\n{drawn}")
    searches = {"WOA": WOA(), "Walk": RandomSearch()}
    test = Experiment(
        name="test", where="p. 1", proposed="WOA", problems={"F1": FUNCTIONS["sphere"].problem(5)},
        algorithms=searches, population=10, iterations=40, runs=10,
    )  # fmt: skip

    claims = eval(call, vars(repro.model) | {"COSTS": table, "TEST": test})  # noqa: S307

    assert [(claim.column, claim.printed.text) for claim in claims] == [
        ("WOA best", "1.7e-04"), ("WOA mean", "2.0e-01"),
        ("Walk best", "1.1e+00"), ("Walk mean", "1.0e+01"),
    ]  # fmt: skip
    assert [claim.measure.statistic for claim in claims] == ["best", "mean"] * 2
