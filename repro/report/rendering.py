"""What templates may name, and a page made of one."""

from collections.abc import Mapping
from functools import cache, partial
from pathlib import PurePosixPath

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from markupsafe import Markup

from repro.judge.findings import IN_WORDS, LEVEL
from repro.judge.verdict import Verdict
from repro.model.identifiers import anchor
from repro.model.measures.measure import TABLES
from repro.report.drawings.arm_viewer import packed_viewer, viewer_licence
from repro.report.escapes import markdown_text
from repro.report.first_uses import first_uses, with_sources
from repro.report.formulas import dollars, equation_links, formula_anchor, mathml, powers_of_ten
from repro.report.glossary import term_link
from repro.report.packing import packed
from repro.report.rooms import OURS, address, page_of, to
from repro.report.run_files import place_of_runs
from repro.report.verdict_pages import VERDICTS
from repro.report.views.conclusions import concluded
from repro.report.words import (
    IMPOSSIBLE,
    MEANINGS,
    RESULTS,
    SYMBOLS,
    again_command,
    command,
    markdown_cell,
    number,
    seconds_raised,
)

LINKED = ("paper", "index", VERDICTS)
"""Pages beside which the glossary stands."""


@cache
def _templates(*, markdown: bool) -> Environment:
    environment = Environment(
        loader=PackageLoader("repro.report"),
        autoescape=select_autoescape([] if markdown else ["html.jinja"]),
        undefined=StrictUndefined,
        finalize=_without_tags if markdown else None,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {
        "number": number,
        "raised": powers_of_ten,
        "sources": partial(with_sources, markdown=markdown),
        "packed": packed,
        "seconds_raised": seconds_raised,
        "mathml": mathml,
        "formula_anchor": formula_anchor,
        "equation_links": equation_links,
        "dollars": dollars,
        "anchor": anchor,
        "markup": Markup,  # for the SVG that we draw and what our macros return
        "comparison_rows": lambda c: [(problem, *texts) for problem, texts in c.rows],
        "cell": markdown_cell,
    }
    twins = map(PurePosixPath, environment.list_templates(filter_func=_is_section))
    environment.globals |= {"IN_MARKDOWN": {twin.name.split(".")[0] for twin in twins}}
    environment.globals |= {"OURS": OURS, "to": to, "address": address, "page_of": page_of}
    environment.globals |= {"packed_viewer": packed_viewer, "viewer_licence": viewer_licence}
    environment.globals |= {"again_command": again_command, "command": command}
    environment.globals |= {"level": LEVEL, "tables_drawn": TABLES, "HOW": VERDICTS}
    environment.globals |= {"SYMBOLS": SYMBOLS, "MEANINGS": MEANINGS, "VERDICTS": tuple(Verdict)}
    environment.globals |= {"place_of_runs": place_of_runs, "concluded": concluded}
    environment.globals |= {"IN_WORDS": IN_WORDS}
    environment.globals |= {"NOT_REPRODUCIBLE": Verdict.NOT_REPRODUCIBLE}
    environment.globals |= {"term": partial(term_link, markdown=markdown)}
    environment.globals |= {"first_uses": partial(first_uses, markdown=markdown)}
    environment.globals |= {"RESULTS": RESULTS, "IMPOSSIBLE": IMPOSSIBLE}
    return environment


def _is_section(name: str) -> bool:
    return name.startswith("sections/") and name.endswith(".md.jinja")


def render(name: str, context: Mapping[str, object]) -> str:
    """Return a page made of a template and what it shows."""
    markdown = name.endswith(".md")
    page = _templates(markdown=markdown).get_template(f"{name}.jinja").render(context)
    if name.partition(".")[0] in LINKED:
        return first_uses(page, markdown=markdown).page
    return with_sources(page, markdown=markdown) if name.endswith((".html", ".md")) else page


def _without_tags(value: object) -> object:
    """Return what a Markdown page may show, as HTML pages escape it."""
    if isinstance(value, str) and not isinstance(value, Markup):
        return markdown_text(value)
    return value
