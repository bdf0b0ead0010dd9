"""What the first sentences of a paper say, of every kind of paper."""

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from repro.commands.written_pages import write_pages
from repro.model.cells import every_cell
from repro.model.open_points import Gap
from repro.model.paper import Paper
from repro.model.table_alone import TableAlone
from repro.model.tolerances import Percent
from repro.report.pages import index_files
from repro.runs.plan import plan
from repro.runs.store.store import Store
from repro.tables.published import PublishedTable
from tests.doe2021 import COSTS, MOTION, PAPER, TEST, TIMES
from tests.made_up import pages_of
from tests.unlinked import unlinked


def with_times(*times: str) -> Paper:
    """Return the invented paper with other printed times of WOA and PSO, and no other claim."""
    rows = (f"{name} || {time}" for name, time in zip(("WOA", "PSO"), times, strict=True))
    table = PublishedTable.read(
        "\n".join(("Table 3, p. 9 (4 runs)", "algorithm || mean [s]", *rows))
    )
    claims = every_cell(
        table, of=MOTION, rows=("algorithm",), columns="statistic",
        given={"problem": "arm", "quantity": "total"}, within=Percent(1),
    )  # fmt: skip
    return replace(
        PAPER, experiments=(MOTION,), results=(table,), claims=tuple(claims), figures=(), gaps=(),
        assumptions=(), together=(),
    )  # fmt: skip


def benchmark(**changes: Any) -> Paper:  # noqa: ANN401 (of each field its own)
    """Return the invented paper with its table of costs alone."""
    costs = tuple(c for c in PAPER.claims if c.place and c.place[0] == COSTS.label)
    own = replace(
        PAPER, experiments=(TEST,), results=(COSTS,), claims=costs, figures=(), gaps=(),
        assumptions=(), together=(),
    )  # fmt: skip
    return replace(own, **changes)


def entry_of(pages: dict[str, str]) -> dict[str, Any]:
    (entry,) = json.loads(pages["results.json"])["papers"]
    return dict(entry)


def said(pages: dict[str, str], key: str = "doe2021") -> list[str]:
    """Return the sentences, without links."""
    place = pages[f"{key}.html"].partition('id="conclusions"')[2].partition("</div>")[0]
    lines = re.findall(r"<p[^>]*>(.*?)</p>", place, re.DOTALL)
    return [" ".join(re.sub(r"<[^>]+>", "", line).split()) for line in lines]


def without_runs(folder: Path, paper: Paper) -> dict[str, str]:
    with Store(folder / "store") as store:
        write_pages(store, [paper], plan([paper], 1), folder / "reports", [paper.key])
    return {path.name: path.read_text() for path in (folder / "reports").glob("*.*")}


@pytest.fixture(scope="module")
def doe(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    return pages_of(tmp_path_factory.mktemp("doe"))


def test_a_time_that_can_be_had_stands_beside_the_least(doe: dict[str, str]) -> None:
    assert said(doe)[0] == "2.357 s can be had, and 2.356 s is proved to be the least."


def test_a_time_below_the_bound_cannot_be_had(tmp_path: Path) -> None:
    pages = without_runs(tmp_path, with_times("2.1", "2.4"))

    assert said(pages)[0] == (
        "2.1 s cannot be had if the printed limits are kept: 2.356 s is proved to be the least."
    )


def test_the_rival_is_beaten_by_what_the_runs_say_and_not_by_the_print(doe: dict[str, str]) -> None:
    (rival,) = entry_of(doe)["conclusions"]["rivals"]

    assert (rival["proposed"], rival["other"]) == ("WOA", "PSO")
    assert rival["printed"] == pytest.approx(100 * (1 - 2.357 / 2.1))
    assert rival["interval"][0] <= rival["value"] <= rival["interval"][1]
    assert said(doe)[1].startswith(
        "WOA and PSO are not told apart in time; printed is 12.2 % more for WOA"
    )
    assert said(doe)[1].endswith("%, 2 repeats).")


def test_one_repeat_is_called_provisional(tmp_path: Path) -> None:
    pages = pages_of(tmp_path, benchmark(), repeats=1)

    assert all("one repeat only, so provisional" in each for each in said(pages)[:2])


def test_tables_of_benchmarks_say_how_many_hold_and_who_is_first(tmp_path: Path) -> None:
    pages = pages_of(tmp_path, benchmark())

    first, second = said(pages)[:2]
    assert re.fullmatch(r"Of 4 results \d hold.*\(2 repeats\)\.", first)
    assert second.startswith("WOA has the lowest mean of 2 searches on 1 of 1 problem, as printed")


def test_where_nothing_is_run_yet_it_says_so(tmp_path: Path) -> None:
    assert said(without_runs(tmp_path, benchmark()))[0] == (
        "Nothing is run yet: 4 results wait for runs."
    )


def test_tables_that_no_run_stands_behind_are_audited_alone(tmp_path: Path) -> None:
    alone = replace(
        benchmark(), experiments=(), results=(), claims=(), audited=(TableAlone(table=TIMES),)
    )

    sentences = said(without_runs(tmp_path, alone))

    assert sentences[0] == "No run stands behind this page: what is printed is audited alone."
    assert sentences[1] == "The audit finds no printed number that cannot be."


def test_a_proposed_algorithm_that_is_not_run_is_named_with_the_reason(tmp_path: Path) -> None:
    gap = Gap(what="WOA", where="section 3", because="no equation of it is printed")
    alone = replace(TEST, algorithms={"PSO": TEST.algorithms["PSO"]}, left_out={"WOA": gap})
    claims = [c for c in benchmark().claims if c.place and c.place[2] == "PSO"]
    claims += [replace(c, gap=gap) for c in benchmark().claims if c.place and c.place[2] == "WOA"]

    pages = pages_of(tmp_path, benchmark(experiments=(alone,), claims=tuple(claims)))

    assert said(pages)[0].endswith(
        "WOA, which the paper puts forward, is not re-run: no equation of it is printed."
    )
    assert not entry_of(pages)["conclusions"]["firsts"]


def test_where_all_is_reproduced_it_is_said_in_one_sentence(tmp_path: Path) -> None:
    wide = tuple(replace(c, accepted=Percent(1e12)) for c in benchmark().claims)

    pages = pages_of(tmp_path, benchmark(claims=wide))

    assert said(pages)[0] == "All 4 results are reproduced (2 repeats)."


def test_every_number_of_a_sentence_leads_to_evidence_on_a_page(doe: dict[str, str]) -> None:
    place = doe["doe2021.html"].partition('id="conclusions"')[2].partition("</ul>")[0]
    links = re.findall(r'href="([^"#]+)#([^"]+)"', place)

    assert len(links) >= 6
    assert all(f'id="{name}"' in doe[page] for page, name in links)


def test_the_index_has_the_first_sentence_of_each_paper(doe: dict[str, str]) -> None:
    old = {k: v for k, v in entry_of(doe).items() if k != "conclusions"} | {"key": "roe2020"}

    index = index_files({"papers": [entry_of(doe), old]})["index.html"]

    assert unlinked(index).count("is proved to be the least") == 1


def test_markdown_says_the_same_with_links(doe: dict[str, str]) -> None:
    assert (
        "[2.357 s](doe2021.tables.html#table-3-woa-mean) can be had, and "
        "[2.356 s](doe2021.optimum.html#optimum-motion-arm) is proved to be the least."
        in unlinked(doe["doe2021.md"])
    )
