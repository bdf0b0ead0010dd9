"""Writing the reports folder: pages, figures, tables and results.json."""

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from markupsafe import Markup

from repro.audit import audit
from repro.judge.certificates import certify
from repro.judge.findings import LEVEL, Finding, judge_paper
from repro.judge.other_readings import evidence_under_readings, fingerprints, reached
from repro.judge.times_found import found_times, time_rows
from repro.judge.verdict import Verdict
from repro.model.evidence import Evidence
from repro.model.measures.measure import TABLES
from repro.model.paper import Paper
from repro.report.drawings.arm_viewer import viewer
from repro.report.drawings.draw import Drawing, draw
from repro.report.files import csv_text, usable_folder, write_file
from repro.report.formulas import dollars, equation_links, formula_anchor, mathml, powers_of_ten
from repro.report.results import (
    Json,
    merged,
    paper_result,
    read_json,
    read_results,
    results_text,
    verdict_counts,
)
from repro.report.views.baselines import baselines_view
from repro.report.views.findings import Shown, everything, table_view, tallies
from repro.report.views.readings import readings_view
from repro.report.views.runs import runs_view
from repro.report.views.search_box import search_rows
from repro.report.words import MEANINGS, SYMBOLS, again_command, anchor, markdown_cell, number
from repro.runs.plan import Task
from repro.runs.session import gather
from repro.runs.store.store import Store
from repro.runs.studies import Study, kinds_of, studies

Files = dict[str, str]
ANOTHER_SEED = "another-seed.json"
_COLUMNS = (
    *("table", "row", "column", "claim", "where", "printed", "unit", "value"),
    *("measured_low", "measured_high", "accepted_low", "accepted_high", "quantile", "repeats"),
    *("verdict", "side", "note", "readings_tried", "within_reach_of", "id"),
)


def write_report(
    store: Store,
    chosen: Sequence[Paper],
    tasks: Sequence[Task],
    folder: Path,
    known: Iterable[Paper],
) -> Json:
    """Write the pages of the chosen papers, the index and results.json; return the results."""
    usable_folder(folder)
    files: Files = {}
    entries = []
    for paper in chosen:
        own = [task for task in tasks if task.paper == paper.key]
        others = studies(paper, max(task.repeat for task in own))
        evidence = gather(store, paper, own, others)
        provenance = _provenance(evidence, store.environments(own))
        provenance["master_seed"] = own[0].seed
        entries.append(_paper_files(evidence, others, provenance, files))
    old = read_results(folder / "results.json")
    results = merged(entries, old, [paper.key for paper in known])
    files["results.json"] = results_text(results)
    files |= index_files(results, read_json(folder / ANOTHER_SEED))
    for name, text in files.items():
        write_file(folder / name, text)
    return results


def _provenance(evidence: Evidence, environments: list[dict[str, object]]) -> dict[str, object]:
    runs = evidence.runs.values()
    protocol = {experiment.name for experiment in evidence.paper.experiments}
    return {
        "repeats": max((len(cell.costs) for cell in runs), default=0),
        "runs": sum(cell.costs.size for cell in runs),
        "protocol_runs": sum(
            found.costs.size for (name, *_), found in evidence.runs.items() if name in protocol
        ),
        "environments": environments,
    }


def _paper_files(
    evidence: Evidence, others: Sequence[Study], provenance: Mapping[str, object], files: Files
) -> Json:
    paper = evidence.paper
    varied = evidence_under_readings(evidence)
    findings = judge_paper(evidence, varied)
    rows = audit(paper)
    certificates = certify(paper)
    drawings = [draw(figure, evidence, anchor(paper.key, figure.label)) for figure in paper.figures]
    entry = paper_result(
        paper, findings=findings, audit=rows, certificates=certificates, provenance=provenance
    )
    runs = runs_view(evidence, findings)
    found = everything(findings, rows)
    cells = {(s.finding.table, s.finding.row, s.finding.column): s for s in found}
    context = {
        "paper": paper,
        "entry": entry,
        "counts": verdict_counts(entry),
        "tallies": tallies(found),
        "results": [table_view(table, cells) for table in paper.results],
        "inputs": [table_view(table, {}) for table in paper.inputs],
        "sentences": [s for s in found if s.finding.claim],
        "everything": found,
        **runs.context(),
        "audit": rows,
        "certificates": [
            (certificate, time_rows(certificate, found_times(certificate, evidence)))
            for certificate in certificates
        ],
        "readings": readings_view(paper, findings, varied, fingerprints(evidence, varied)),
        **_studied(evidence, others),
        "standings": baselines_view(paper, evidence.runs, certificates),
        "drawings": drawings,
        "provenance": provenance,
    }
    files[f"{paper.key}.html"] = render("paper.html", context)
    files[f"{paper.key}.md"] = render("paper.md", context)
    files |= _tables(paper, found, drawings) | runs.files(paper.key)
    return entry


def _studied(evidence: Evidence, others: Sequence[Study]) -> dict[str, object]:
    return {
        "besides": kinds_of(others, {name for name, *_ in evidence.runs}),
        "reading_repeats": max((s.repeats for s in others if s.kind == "reading"), default=0),
    }


def index_files(results: Json, another_seed: Json | None = None) -> Files:
    """Return the index pages and the table of verdicts alone.

    `another_seed` is what `repro flips --json` said of these results and those of another seed.
    """
    papers = results["papers"]
    not_run = any(verdict_counts(paper)[Verdict.NOT_RUN] for paper in papers)
    context = {
        "papers": papers,
        "counts_of": verdict_counts,
        "verdicts": [v for v in Verdict if v != Verdict.NOT_RUN or not_run],
        "search_rows": search_rows(papers),
        "another_seed": another_seed,
    }
    return {name: render(name, context) for name in ("index.html", "index.md", "verdicts.md")}


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
        "time_cells": _time_cells,
        "comparison_rows": lambda c: [(problem, *texts) for problem, texts in c.rows],
        "cell": markdown_cell,
    }
    environment.globals |= {"viewer": viewer, "again_command": again_command}
    environment.globals |= {"level": LEVEL, "resampled_tables": TABLES}
    environment.globals |= {"SYMBOLS": SYMBOLS, "MEANINGS": MEANINGS, "VERDICTS": tuple(Verdict)}
    return environment


def render(name: str, context: Mapping[str, object]) -> str:
    """Return a page made of a template and what it shows."""
    return _templates(markdown=name.endswith(".md")).get_template(f"{name}.jinja").render(context)


def _without_tags(value: object) -> object:
    """Return what a Markdown page may show: text can open no tag there, as HTML pages escape it."""
    if isinstance(value, str) and not isinstance(value, Markup):
        return value.replace("<", "&lt;")
    return value


def _time_cells(rows: Iterable[tuple[str, float, float]]) -> list[tuple[str, str, str]]:
    return [(label, number(time), f"{ratio:.4f}") for label, time, ratio in rows]


def _tables(paper: Paper, found: Sequence[Shown], drawings: Sequence[Drawing]) -> Files:
    by_table: dict[str, list[tuple[object, ...]]] = {}
    for one in found:
        by_table.setdefault(one.group, []).append((*_csv_row(one.finding), one.anchor))
    files = {
        f"tables/{paper.key}-{group}.csv": csv_text([_COLUMNS, *own])
        for group, own in by_table.items()
    }
    for figure, drawing in zip(paper.figures, drawings, strict=True):
        files[f"tables/{paper.key}-{anchor(figure.label)}.csv"] = csv_text(drawing.rows)
    return files


def _csv_row(finding: Finding) -> tuple[object, ...]:
    low, high = finding.measured or ("", "")
    return (
        finding.table, finding.row, finding.column, finding.claim, finding.where, finding.printed,
        finding.unit, finding.value, low, high, *finding.accepted, finding.quantile,
        finding.repeats, finding.verdict, finding.side, finding.note,
        len(finding.readings), "; ".join(reached(finding)),
    )  # fmt: skip
