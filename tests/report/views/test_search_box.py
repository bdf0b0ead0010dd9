import gzip
import json
from base64 import b64decode

import pytest

from repro.model.identifiers import anchor
from repro.report.glossary import glossary
from repro.report.results import Json
from repro.report.views.search_box import search_index
from tests.made_up import pages_of


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    return pages_of(tmp_path_factory.mktemp("doe"))


@pytest.fixture(scope="module")
def index(pages: dict[str, str]) -> Json:
    return search_index(json.loads(pages["results.json"])["papers"], glossary())


def rows_of(index: Json, kind: str) -> list[list[str | int]]:
    return [row for group in index["groups"] if group["kind"] == kind for row in group["rows"]]


def test_every_number_claim_audit_row_and_word_can_be_found(
    pages: dict[str, str], index: Json
) -> None:
    (paper,) = json.loads(pages["results.json"])["papers"]

    numbers = rows_of(index, "number") + rows_of(index, "claim")
    assert len(numbers) == len(paper["findings"])
    assert len(rows_of(index, "audit")) == len(paper["audit"])
    assert len(rows_of(index, "word")) == len(glossary().terms)


def test_a_number_is_found_as_printed_and_as_rerun_with_its_verdict(index: Json) -> None:
    (found,) = (row for row in rows_of(index, "number") if row[0] == "F1 Mean, WOA")

    assert found[1] == "2.500, re-run 477.3"
    assert index["marks"][found[2]] == "✖ contradicted (re-run higher)"


@pytest.mark.parametrize(
    ("kind", "text", "says"),
    [
        ("paper", "Motion of an <arm> & a whale", "A whale moves an arm."),
        ("algorithm", "PSO", "ranks and tests against others"),
        ("reading", "wide box", "0.1 s to 20 s"),
        ("assumption", "box of the durations", "0.5 s to 9 s"),
        ("part", "provenance", "raw runs, data, CSV, seeds, versions, machine"),
    ],
)
def test_what_is_no_number_can_be_found_too(index: Json, kind: str, text: str, says: str) -> None:
    assert [text, says] in [row[:2] for row in rows_of(index, kind)]


def test_a_proved_optimum_is_found_by_its_value(index: Json) -> None:
    (found,) = rows_of(index, "optimum")[:1]

    assert found[0] == "certified optimum of motion/arm"
    assert str(found[1]).endswith(" s, proved")


def test_every_address_is_there_on_its_page(pages: dict[str, str], index: Json) -> None:
    for group in index["groups"]:
        for row in group["rows"]:
            name = row[3] if len(row) > 3 else anchor(group["of"], str(row[0]))
            assert not name or f' id="{name}"' in pages[group["page"]], (group["page"], row)


def test_what_is_searched_stands_on_the_index_and_can_end_no_script(
    pages: dict[str, str], index: Json
) -> None:
    text = pages["index.html"].partition(' id="search-rows">')[2].partition("</script>")[0]

    assert json.loads(gzip.decompress(b64decode(text))) == index
    assert "<" not in text


def test_a_row_of_the_search_says_nothing_twice(index: Json) -> None:
    for group in index["groups"]:
        if group["kind"] == "number":
            assert all(len(row) == 3 for row in group["rows"])
