"""The page of words that a table may print says what there is, and nothing else."""

import re
from pathlib import Path

import pytest

import repro.model
from repro.model.cell_measures import is_printable
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
    drawn = "\n".join(re.findall(r"^    (.+\|\|.+)$", PAGE, flags=re.MULTILINE))

    table = PublishedTable.read(f"Table 1\n{drawn}")

    assert table["time std", "WOA"].si == pytest.approx(4e-4)
    assert table.row_names[-1] == "successes"
