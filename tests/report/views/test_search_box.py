import json

import pytest

from repro.report.views.search_box import search_rows
from tests.made_up import pages_of


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    return pages_of(tmp_path_factory.mktemp("doe"))


def test_every_paper_table_cell_claim_and_audit_row_can_be_found(pages: dict[str, str]) -> None:
    (paper,) = json.loads(pages["results.json"])["papers"]

    rows = search_rows([paper])

    assert len(rows) == 1 + 2 + len(paper["findings"]) + len(paper["audit"])
    assert (
        "doe2021",
        "doe2021.tables.html#table-2-f1-mean-woa",
        "Table 2, F1 Mean, WOA: 2.500",
        "✖ contradicted (re-run higher)",
    ) in rows


def test_every_address_is_there_on_the_page(pages: dict[str, str]) -> None:
    for _, address, _, _ in search_rows(json.loads(pages["results.json"])["papers"]):
        page, _, name = address.partition("#")
        assert f' id="{name}"' in pages[page] or not name


def test_what_is_searched_stands_on_the_index_and_can_end_no_script(pages: dict[str, str]) -> None:
    papers = json.loads(pages["results.json"])["papers"]
    text = pages["index.html"].partition(' id="search-rows">')[2].partition("</script>")[0]

    assert json.loads(text) == [list(row) for row in search_rows(papers)]
    assert "<arm>" not in text
