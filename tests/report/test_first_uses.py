"""Words of the glossary and sources as links, on pages of either kind."""

import re

import pytest

from repro.report.first_uses import first_uses, with_sources
from tests.made_up import pages_of
from tests.unlinked import unlinked

LINK = '<a class="term" href="glossary.html#reading">{}</a>'


def linked(page: str) -> str:
    return str(first_uses(page, markdown=False).page)


def in_markdown(page: str) -> str:
    return str(first_uses(page, markdown=True).page)


def test_only_the_first_use_of_a_word_is_a_link_however_it_is_written() -> None:
    told = first_uses("<p>Readings, then a reading.</p>", markdown=False)

    assert told.page == f"<p>{LINK.format('Readings')}, then a reading.</p>"
    assert [term.name for term in told.terms] == ["reading"]


def test_the_longer_word_goes_before_the_one_within_it() -> None:
    assert ">rank-sum test</a>" in linked("<p>a rank-sum test</p>")
    assert ">prediction\ninterval</a>" in linked("<p>the prediction\ninterval</p>")
    told = first_uses("<p>a setting that it does not print</p>", markdown=False)
    assert [term.name for term in told.terms] == ["open setting"]
    assert linked("<p>pre-reading, misreadings, reading-room</p>").count("<a") == 0


@pytest.mark.parametrize(
    "aside",
    ["<a href='x'>{}</a>", "<h2>{}</h2>", "<code>{}</code>", "<math><mi>{}</mi></math>",
     "<svg><text>{}</text></svg>", "<summary>{}</summary>", "<table><thead><tr><th>{}</th></tr>",
     "<nav><ul><li>{}</li></ul></nav>", "<script>{}</script>", '<td class="claim">{}</td>',
     '<div class="a" hidden><div>{}</div> {}</div>', '<p title="{}">'],
)  # fmt: skip
def test_what_is_no_running_text_is_left_as_it_is(aside: str) -> None:
    before = aside.format(*["a reading"] * 2)

    assert linked(f"{before}<p>a reading</p>") == f"{before}<p>a {LINK.format('reading')}</p>"


def test_what_is_in_sight_goes_before_what_is_folded() -> None:
    folded = "<details><summary>more</summary><p>a reading</p></details>"

    assert linked(f"{folded}<p>a reading</p>").startswith(folded)
    assert LINK.format("reading") in linked(folded)


@pytest.mark.parametrize(
    "aside",
    ["# A reading\n", "`a reading`", "[a reading](x.md)", "![reading](x.svg)", "$reading$",
     "```\na reading\n```", '<a id="reading"></a>', "| reading |\n| --- |\n"],
)  # fmt: skip
def test_markdown_that_is_no_running_text_is_left_as_it_is(aside: str) -> None:
    page = f"{aside}\n\nA reading."

    assert in_markdown(page) == f"{aside}\n\nA [reading](glossary.md#reading)."


def test_a_source_is_a_link_wherever_it_stands_but_in_one() -> None:
    page = "<p>(X 1997, doi:10.1016/S0375-9601(97)00474-X), arXiv:2301.01984.</p>"
    first = "https://doi.org/10.1016/S0375-9601%2897%2900474-X"

    found = with_sources(page, markdown=False)
    assert f'<a href="{first}">doi:10.1016/S0375-9601(97)00474-X</a>), ' in found
    assert '<a href="https://arxiv.org/abs/2301.01984">arXiv:2301.01984</a>.' in found
    assert with_sources(found, markdown=False) == found
    assert f"[doi:10.1016/S0375-9601(97)00474-X]({first}))" in with_sources(page, markdown=True)


def test_each_word_that_a_page_uses_is_a_link_once(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    pages = pages_of(tmp_path_factory.mktemp("doe"))
    told = [name for name in pages if name.startswith(("doe2021", "index", "how-"))]

    for name in (name for name in told if name.endswith((".html", ".md"))):
        markdown = name.endswith(".md")
        link = r"\[([^]]*)\]\(glossary\.md#([^)]*)\)"
        link = link if markdown else r'<a class="term" href="glossary\.html#([^"]*)">'
        places = [m[m.re.groups] for m in re.finditer(link, pages[name])]
        bare = unlinked(pages[name])
        used = [term.anchor for term in first_uses(bare, markdown=markdown).terms]
        assert sorted(places) == sorted(used), name
        assert len(places) > 10 or name not in {"doe2021.html", "doe2021.md", "doe2021.tables.html"}
