import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import pytest

from repro.commands.written_pages import write_pages
from repro.judge.verdict import Verdict
from repro.report.pages import index_files
from repro.report.words import SYMBOLS
from repro.runs.plan import plan
from repro.runs.store.store import Store
from tests.doe2021 import PAPER
from tests.made_up import pages_of, rooms_of
from tests.unlinked import unlinked

GOLDEN = Path(__file__).parents[1] / "golden" / "doe2021.md"
FINDING = {
    *("table", "row", "column", "claim", "where", "printed", "unit", "measured", "value"),
    *("accepted", "verdict", "side", "note", "readings", "turns_on", "unseen", "group"),
}
READING = {"reading", "verdict", "side", "measured", "repeats"}
AUDIT = {"paper", "table", "row", "column", "check", "grade", "explanation", "condition"}
CERTIFICATE = {
    *("paper", "problem", "minimum", "lower_bound", "attained", "method", "at", "binding"),
    "printed",
}


CALIBRATED = {
    "rows": [
        {"repeats": 1, "statistic": name, "factor": 1, "verdict": "consistent", "share": 1.0}
        for name in ("best", "worst", "mean", "std")
    ],
    "coverage": [],
    "by": {"runs": "none: these shares are invented"},
}


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("repro.report.pages.calibration", lambda: CALIBRATED)
        return pages_of(tmp_path_factory.mktemp("doe"))


class Page(HTMLParser):
    """Tags, identifiers, links and loaded resources of a page."""

    def __init__(self, text: str) -> None:
        """Read the page."""
        super().__init__()
        self.identifiers: list[str] = []
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.tags: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note what a tag carries."""
        self.tags.append(tag)
        for name, value in attrs:
            if name == "id":
                self.identifiers.append(value or "")
            if name == "href":
                self.links.append(value or "")
            if name == "src" or (name == "href" and tag in {"link", "image", "use"}):
                self.loaded.append(value or "")


def test_the_markdown_page_is_the_one_that_a_person_read(pages: dict[str, str]) -> None:
    assert pages["doe2021.md"] == GOLDEN.read_text(encoding="utf-8")


def test_results_follow_the_contract(pages: dict[str, str]) -> None:
    results = json.loads(pages["results.json"])
    assert results["schema"] == 2
    (entry,) = results["papers"]
    assert entry["key"] == "doe2021"
    assert len(entry["findings"]) == len(PAPER.said)
    assert all(set(finding) >= FINDING for finding in entry["findings"])
    assert all(set(row) >= AUDIT for row in entry["audit"])
    assert all(set(row) >= CERTIFICATE for row in entry["certificates"])
    assert {"assumptions", "errata", "gaps", "title", "tests", "standings"} <= set(entry)
    for finding in entry["findings"]:
        assert finding["verdict"] in set(Verdict)
        assert all(set(outcome) == READING for outcome in finding["readings"])
        unseen = finding["unseen"]
        assert (finding["verdict"] == "consistent") == (unseen is not None)
        assert unseen in {None, "unbounded"} or unseen >= 1.0


def test_an_older_results_json_is_written_anew(tmp_path: Path) -> None:
    reports = tmp_path / "reports"
    reports.mkdir()
    (reports / "results.json").write_text(
        '{"schema": 1, "provenance": {}, "papers": [{"key": "roe2022", "findings": []}]}'
    )

    results = json.loads(pages_of(tmp_path)["results.json"])

    assert results["schema"] == 2
    assert [entry["key"] for entry in results["papers"]] == ["doe2021"]


@pytest.mark.parametrize("name", ["index.html", "index.md"])
def test_controls_come_first_and_are_called_so(tmp_path: Path, name: str) -> None:
    control = replace(PAPER, key="roe2022", control=True)
    plain, controlled = pages_of(tmp_path / "a"), pages_of(tmp_path / "b", control, repeats=1)
    both = [json.loads(pages["results.json"])["papers"][0] for pages in (plain, controlled)]

    index = index_files({"papers": both})[name]

    assert index.index("roe2022.") < index.index("doe2021.")
    called = "(control)" if name == "index.md" else '<h2 id="controls">'
    assert called in unlinked(index)
    assert called not in plain[name]


@pytest.mark.parametrize("kind", ["html", "md"])
def test_every_page_leads_to_how_verdicts_are_made(pages: dict[str, str], kind: str) -> None:
    for page in (pages[f"index.{kind}"], pages[f"doe2021.{kind}"]):
        assert f"how-verdicts-are-made.{kind}" in page
    how = pages[f"how-verdicts-are-made.{kind}"]
    assert all(f"{SYMBOLS[verdict]}" in how and verdict in how for verdict in Verdict)


@pytest.mark.parametrize("kind", ["html", "md"])
def test_a_paper_says_what_a_truthful_one_would_have_scored(
    pages: dict[str, str], kind: str
) -> None:
    would = "0 reproduced, 4 consistent, 0 undecided, 0 contradicted of these 4 cells"
    assert would in pages[f"doe2021.{kind}"]
    assert "these shares are invented" in pages[f"how-verdicts-are-made.{kind}"]


def test_without_a_calibration_pages_say_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "repro.report.pages.calibration", lambda: {"rows": [], "coverage": [], "by": {}}
    )

    pages = pages_of(tmp_path, repeats=1)

    for name in ("doe2021.html", "doe2021.md", "how-verdicts-are-made.html"):
        assert "not calibrated yet" in pages[name]


def test_flag_marks_what_no_runs_whatever_give_and_nothing_else(pages: dict[str, str]) -> None:
    audit = json.loads(pages["results.json"])["papers"][0]["audit"]
    assert [(row["grade"], bool(row["condition"])) for row in audit] == [
        ("impossible", False),
        ("impossible", False),
        ("impossible", True),
    ]
    cells = re.findall(r'<a class="mark[^>]*>(.*?)</a>', pages["doe2021.tables.html"])
    assert [re.sub("<.*?>", "", cell) for cell in cells] == [
        *["⚑ impossible"] * 2,
        "audit: impossible",
    ]
    assert pages["doe2021.tables.html"].count(" data-marked") == 2
    assert "<dt>audit: impossible</dt>" in unlinked(pages["doe2021.tables.html"])
    own = pages["doe2021.audit.html"]
    assert re.findall(r'<h3 id="audit-\w+">(.*?)</h3>', own) == [
        "⚑ 2 rows: cannot be, whatever was run",
        "1 row: cannot be if a condition holds",
    ]
    reasons = re.findall(r"<h4>(.*?)</h4>", own)
    assert [reason.startswith("⚑") for reason in reasons] == [True, True, False]
    for name in ("index.html", "verdicts.md"):
        flagged = r'<td data-name="⚑ impossible">2</td>|\| 2 \| 2 \|'
        assert re.search(flagged, pages[name]), name
    for page in pages.values():
        assert "arithmetic alone forbids" not in page
        assert "holds without any run" not in page


def test_a_page_loads_nothing_and_every_link_leads_somewhere(pages: dict[str, str]) -> None:
    for name in (name for name in pages if name.endswith(".html")):
        page = Page(pages[name])
        assert [place for place in page.loaded if not place.startswith(("#", "data:"))] == []
        for link in page.links:
            if link.startswith(("https://doi.org/", "https://arxiv.org/")):
                continue  # a reader's click
            path, _, part = link.partition("#")
            there = path.partition("?")[0] or name
            assert there in pages, link
            assert not part or part in Page(pages[there]).identifiers, link
        assert "http://" not in re.sub(r'xmlns(:\w+)?="[^"]+"', "", pages[name])
        beside = re.sub(r'href="https://(doi|arxiv)\.org/', "", pages[name])
        assert "https://" not in beside or name == "doe2021.arm.html"


def test_no_identifier_stands_twice_on_a_page(pages: dict[str, str]) -> None:
    for name in (name for name in pages if name.endswith(".html")):
        identifiers = Page(pages[name]).identifiers
        assert sorted(identifiers) == sorted(set(identifiers)), name


def test_text_of_a_paper_cannot_become_markup(pages: dict[str, str]) -> None:
    assert "<arm>" not in rooms_of(pages)
    assert "Motion of an &lt;arm&gt; &amp; a whale" in pages["doe2021.html"]


@pytest.mark.parametrize(
    "hostile", ["<script>alert(1)</script>", '"><img src=x>', "{{ 7 * 7 }}", "</style>"]
)
def test_a_hostile_title_stays_text(tmp_path: Path, hostile: str) -> None:
    source = replace(PAPER.source, title=hostile)
    pages = pages_of(tmp_path, replace(PAPER, source=source, summary=hostile), repeats=1)
    tags = Page(rooms_of(pages)).tags
    plain = Page(rooms_of(pages_of(tmp_path / "plain", repeats=1))).tags
    assert tags == plain
    assert "<p>49</p>" not in rooms_of(pages)


def test_every_verdict_is_shown_by_word_and_symbol(pages: dict[str, str]) -> None:
    results = json.loads(pages["results.json"])
    verdicts = {finding["verdict"] for finding in results["papers"][0]["findings"]}
    assert len(verdicts) >= 3
    for verdict in verdicts:
        assert re.search(
            rf"{re.escape(SYMBOLS[Verdict(verdict)])} {verdict}", pages["doe2021.html"]
        )
        assert re.search(rf"{re.escape(SYMBOLS[Verdict(verdict)])} {verdict}", pages["doe2021.md"])


def test_every_table_and_figure_has_its_csv(pages: dict[str, str]) -> None:
    tables = {"table-2", "table-3", "claims", "fig-1", "fig-2"}
    assert {f"tables/doe2021-{name}.csv" for name in tables} <= set(pages)
    assert len(pages["tables/doe2021-table-2.csv"].splitlines()) == 1 + 4


def test_the_same_store_gives_the_same_bytes(tmp_path: Path) -> None:
    first = pages_of(tmp_path)
    assert pages_of(tmp_path) == first


def test_one_repeat_is_called_provisional(tmp_path: Path) -> None:
    pages = pages_of(tmp_path, repeats=1)
    assert "Provisional" in pages["doe2021.html"]
    assert "Provisional" in pages["doe2021.md"]


def test_a_paper_whose_tables_were_read_once_is_called_provisional(tmp_path: Path) -> None:
    twice = pages_of(tmp_path / "twice", replace(PAPER, read_twice=True))
    once = pages_of(tmp_path / "once")
    for name in ("doe2021.html", "doe2021.md"):
        assert "transcribed once only" in once[name]
        assert "transcribed once only" not in twice[name]


def test_pages_of_other_papers_stay_in_the_index(tmp_path: Path) -> None:
    pages_of(tmp_path)
    other = replace(PAPER, key="roe2022")
    with Store(tmp_path / "store") as store:
        tasks = plan([other], 1)
        results = write_pages(store, [other], tasks, tmp_path / "reports", [PAPER.key, other.key])
    assert [entry["key"] for entry in results["papers"]] == ["doe2021", "roe2022"]
    assert {finding["verdict"] for finding in results["papers"][1]["findings"]} >= {"not run"}


def test_index_says_what_another_master_seed_changes(pages: dict[str, str]) -> None:
    results = json.loads(pages["results.json"])
    told = {
        "compared": 9,
        "repeats": [2, 2],
        "same": 8,
        "opposite": 0,
        "depending": 1,
        "changes": {"consistent → undecided": 1},
        "flips": [],
    }

    for name in ("index.html", "index.md"):
        index = index_files(results, told)[name]
        assert "consistent → undecided (1)" in index
        assert "another-seed.json" in index
        assert "another-seed.json" not in index_files(results)[name]


def test_a_caption_is_short_and_folds_its_numbers(pages: dict[str, str]) -> None:
    captions = [
        caption
        for name, page in pages.items()
        if name.startswith("doe2021.") and name.endswith(".html")
        for caption in re.findall(r"<figcaption>(.*?)</figcaption>", page, re.DOTALL)
    ]

    assert len(captions) > 4
    for caption in captions:
        shown, fold, _ = caption.partition("<details>")
        text = re.sub("<.*?>", "", shown).strip()
        assert len(re.findall(r"\. |\.$", text)) <= 4, text  # title and data are two
        assert fold
