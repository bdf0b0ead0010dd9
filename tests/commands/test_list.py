from pathlib import Path

from repro.commands.listed_papers import listing
from repro.commands.listing_text import listing_text
from repro.runs.plan import plan
from repro.runs.run import execute
from repro.runs.store.store import Store
from tests.small_papers import PAPER
from tests.small_stores import filled


def test_listing_of_an_empty_store_misses_every_run_and_makes_no_store(tmp_path: Path) -> None:
    (row,) = listing([PAPER], 2, tmp_path / "store")

    assert (row["done"], row["missing"]) == (0, 12)
    assert list(tmp_path.iterdir()) == []


def test_listing_counts_runs_done_and_missing(tmp_path: Path) -> None:
    (row,) = listing([PAPER], 3, filled(tmp_path))

    assert (row["done"], row["missing"]) == (6, 12)
    assert row["experiments"] == [
        {
            "name": "search",
            "problems": ["bowl"],
            "algorithms": ["guess", "wide"],
            "done": 6,
            "missing": 12,
            "changed": [],
        }
    ]


def test_listing_counts_no_run_of_another_version(tmp_path: Path) -> None:
    with Store(tmp_path) as store:
        store.begin({})
        store.add(map(execute, plan([PAPER], 2)[:2]))

    (row,) = listing([PAPER], 1, tmp_path)

    assert (row["done"], row["missing"]) == (2, 4)


def test_listing_names_paper_tables_and_claims() -> None:
    (row,) = listing([PAPER], 1, Path("nowhere"))

    assert {name: row[name] for name in ("key", "title", "tables", "claims")} == {
        "key": "small2020",
        "title": "A small paper",
        "tables": ["Table 1"],
        "claims": 4,
    }


def test_listing_as_text_says_the_same(tmp_path: Path) -> None:
    text = listing_text(listing([PAPER, PAPER], 2, filled(tmp_path)))

    assert text.splitlines()[:3] == [
        "small2020: A small paper",
        "  tables: Table 1; claims: 4",
        "  search: guess wide on bowl, 6 runs done, 6 missing",
    ]
    assert text.count("small2020") == 2
