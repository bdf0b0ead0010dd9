"""Writing the reports folder: pages, figures, tables and results.json."""

import shlex
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from types import MappingProxyType

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from markupsafe import Markup

from repro.audit.alone import tables_alone
from repro.audit.arms import rows_of_arm
from repro.judge.findings import LEVEL
from repro.judge.judgement import Judgement
from repro.judge.verdict import Verdict
from repro.model.figures import Arm, Figure
from repro.model.identifiers import anchor
from repro.model.measures.measure import TABLES
from repro.model.paper import Paper
from repro.report.calibration import calibration
from repro.report.drawings.arm_viewer import viewer
from repro.report.drawings.draw import Drawing, draw
from repro.report.escapes import markdown_text
from repro.report.formulas import dollars, equation_links, formula_anchor, mathml, powers_of_ten
from repro.report.frames import DIGITS, FINDING, csv_text, findings_frame
from repro.report.results import (
    Environments,
    Files,
    Json,
    Made,
    impossible_rows,
    paper_result,
    provenance_entry,
    verdict_counts,
)
from repro.report.run_files import packed_runs, place_of_runs
from repro.report.verdict_pages import VERDICTS, verdict_context
from repro.report.views.baselines import standings_view
from repro.report.views.calibration import truthful
from repro.report.views.findings import Shown, bare_table, everything, table_view, tallies
from repro.report.views.heat_map import heat_map
from repro.report.views.readings import readings_view, ruled_out_by, settings_of
from repro.report.views.runs import runs_view
from repro.report.views.search_box import search_rows
from repro.report.views.times import time_cells
from repro.report.words import (
    IMPOSSIBLE,
    MEANINGS,
    RESULTS,
    SYMBOLS,
    again_command,
    command,
    markdown_cell,
    number,
)
from repro.tables.audit_words import read_lines, read_words
from repro.tables.rows import AuditRow

ANOTHER_SEED = "another-seed.json"


def made_of(
    judgement: Judgement, environments: Environments, master_seed: str = "", called: str = ""
) -> Made:
    """Return all that is written of a paper.

    `environments` says in what its runs were made; that and how long they took stands in a file of
    its own, so that equal runs give equal pages. `called` says what a paper from elsewhere than
    this checkout is called at the command line.
    """
    files: Files = {}
    entry = _paper_files(judgement, master_seed, files, called)
    provenance = provenance_entry(judgement, environments, called)
    outside = [each.says for each in judgement.outside if each.outside]
    says = [f"{judgement.paper.key}, {each}" for each in outside]
    return Made(entry=entry, provenance=provenance, files=files, says=says)


def _paper_files(judgement: Judgement, master_seed: str, files: Files, called: str) -> Json:
    paper = judgement.paper
    drawings = _drawings(judgement)
    entry = paper_result(judgement, master_seed)
    calibrated = calibration()["rows"]
    runs = runs_view(judgement)
    found = everything(judgement.findings, judgement.audit, settings_of(paper), ruled_out_by(paper))
    times = zip(judgement.certificates, judgement.found_times, strict=True)
    context = {
        "paper": paper,
        "called": called,
        "entry": entry,
        "counts": verdict_counts(entry),
        "shown_counts": Counter(finding.verdict for finding in judgement.findings),
        "truthful": truthful(judgement, calibrated),
        "not_calibrated": not calibrated,
        "tallies": tallies(found),
        **_printed(paper, found, judgement.audit),
        **runs.context(),
        "audit": judgement.audit,
        "alone": [
            (read_words(table), *read_lines(table, flag="")) for table in tables_alone(paper)
        ],
        "certificates": [(certificate, time_cells(certificate, own)) for certificate, own in times],
        "readings": readings_view(judgement),
        "besides": judgement.besides,
        "reading_repeats": judgement.reading_repeats,
        "standings": tuple(map(standings_view, judgement.standings)),
        "drawings": drawings,
        "provenance": entry["provenance"],
    }
    files[f"{paper.key}.html"] = render("paper.html", context)
    files[f"{paper.key}.md"] = render("paper.md", context)
    files |= _data(judgement, entry, drawings) | runs.files(paper.key)
    return entry


def _printed(paper: Paper, found: Sequence[Shown], audit: Sequence[AuditRow]) -> dict[str, object]:
    """Return what is printed, in tables and in sentences, with what is said of it."""
    cells = {(s.finding.table, s.finding.row, s.finding.column): s for s in found}
    results = [table_view(table, cells) for table in paper.results]
    return {
        "results": results,
        "maps": [heat_map(table) for table in results if table.judged],
        "unrun": [bare_table(each.table, audit) for each in paper.audited],
        "inputs": [table_view(table, {}) for table in paper.inputs],
        "sentences": [s for s in found if s.finding.claim],
        "everything": found,
    }


def _drawings(judgement: Judgement) -> list[Drawing]:
    paper = judgement.paper
    return [
        replace(
            draw(
                figure,
                judgement.evidence,
                anchor(paper.key, figure.label),
                assumptions=paper.assumptions,
            ),
            notes=_notes(paper.key, figure),
        )
        for figure in paper.figures
    ]


def _notes(key: str, figure: Figure) -> tuple[str, ...]:
    """Return what the audit says of an arm, for where it is drawn."""
    if not isinstance(figure, Arm):
        return ()
    rows = [
        f"{row.grade.capitalize()}: {row.explanation}"
        + (f". Holds if {row.condition}." if row.condition else ".")
        for row in rows_of_arm(key, figure)
    ]
    if figure.robot is None:
        rows.append("No public description of the machine is declared to compare this arm with.")
    return tuple(rows)


def verdict_files() -> Files:
    """Return the pages that say how verdicts are made."""
    context = verdict_context(calibration())
    return {f"{VERDICTS}.{kind}": render(f"{VERDICTS}.{kind}", context) for kind in ("html", "md")}


def index_files(
    results: Json,
    another_seed: Json | None = None,
    called: Mapping[str, str] = MappingProxyType({}),
) -> dict[str, str]:
    """Return the index pages and the table of verdicts alone.

    `another_seed` is what `repro flips --json` said of these results and those of another seed;
    `called` says what papers that are not of this checkout are called at the command line.
    """
    # controls first, as they say what the others' verdicts are worth
    papers = sorted(results["papers"], key=lambda paper: not paper["control"])
    not_run = any(verdict_counts(paper)[Verdict.NOT_RUN] for paper in papers)
    context = {
        "papers": papers,
        "controls": [paper for paper in papers if paper["control"]],
        "others": [paper for paper in papers if not paper["control"]],
        "counts_of": verdict_counts,
        "impossible_of": impossible_rows,
        "verdicts": [v for v in Verdict if v != Verdict.NOT_RUN or not_run],
        "search_rows": search_rows(papers),
        "another_seed": another_seed,
        "again": _all_again(papers, called),
    }
    return {name: render(name, context) for name in ("index.html", "index.md", "verdicts.md")}


def _all_again(papers: Sequence[Json], called: Mapping[str, str]) -> str:
    """Return what to type to have all these pages again."""
    repeats = str(max((1, *(paper["provenance"]["repeats"] for paper in papers))))
    if any(called.values()):
        names = (called.get(paper["key"]) or paper["key"] for paper in papers)
        given = ("repro", "reproduce", *dict.fromkeys(names))
    else:
        given = ("nox", "-s", "reproduce", "--")
    return shlex.join((*given, "--repeats", repeats))


@cache
def _templates(*, markdown: bool) -> Environment:
    environment = Environment(
        loader=PackageLoader("repro.report"),
        autoescape=select_autoescape(["html.jinja"]),
        undefined=StrictUndefined,
        finalize=_without_tags if markdown else None,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {
        "number": number,
        "raised": powers_of_ten,
        "mathml": mathml,
        "formula_anchor": formula_anchor,
        "equation_links": equation_links,
        "dollars": dollars,
        "anchor": anchor,
        "markup": Markup,  # for the SVG that we draw and what our macros return
        "comparison_rows": lambda c: [(problem, *texts) for problem, texts in c.rows],
        "cell": markdown_cell,
    }
    environment.globals |= {"viewer": viewer, "again_command": again_command, "command": command}
    environment.globals |= {"level": LEVEL, "tables_drawn": TABLES, "HOW": VERDICTS}
    environment.globals |= {"SYMBOLS": SYMBOLS, "MEANINGS": MEANINGS, "VERDICTS": tuple(Verdict)}
    environment.globals |= {"place_of_runs": place_of_runs}
    environment.globals |= {"NOT_REPRODUCIBLE": Verdict.NOT_REPRODUCIBLE}
    environment.globals |= {"RESULTS": RESULTS, "IMPOSSIBLE": IMPOSSIBLE}
    return environment


def render(name: str, context: Mapping[str, object]) -> str:
    """Return a page made of a template and what it shows."""
    return _templates(markdown=name.endswith(".md")).get_template(f"{name}.jinja").render(context)


def _without_tags(value: object) -> object:
    """Return what a Markdown page may show, as HTML pages escape it."""
    if isinstance(value, str) and not isinstance(value, Markup):
        return markdown_text(value)
    return value


def _data(judgement: Judgement, entry: Json, drawings: Sequence[Drawing]) -> Files:
    paper = judgement.paper
    found = findings_frame([entry])
    groups = found["table"].fillna("claims").map(anchor)
    files: Files = {
        f"tables/{paper.key}-{group}.csv": csv_text(found.loc[groups == group, list(FINDING)])
        for group in groups.unique()
    }
    for figure, drawing in zip(paper.figures, drawings, strict=True):
        files[f"tables/{paper.key}-{anchor(figure.label)}.csv"] = csv_text(drawing.frame, DIGITS)
    if paper.experiments:
        files[place_of_runs(paper.key)] = packed_runs(judgement.runs)
    return files
