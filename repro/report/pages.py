"""The files of a paper's reports, and those of all papers together: pages, figures, tables."""

import shlex
from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from repro.audit.arms import rows_of_arm
from repro.judge.judgement import Judgement
from repro.judge.verdict import Verdict
from repro.model.figures import Arm, Figure
from repro.model.identifiers import anchor
from repro.model.paper import Paper
from repro.report.calibration import calibration
from repro.report.drawings.draw import Drawing, draw
from repro.report.drawings.svg import standalone
from repro.report.frames import DIGITS, FINDING, csv_text, findings_frame
from repro.report.glossary import PAGE, glossary
from repro.report.rendering import render
from repro.report.results import (
    Environments,
    Files,
    Json,
    Made,
    cell_counts,
    impossible_rows,
    paper_result,
    provenance_entry,
    verdict_counts,
)
from repro.report.rooms import Room, neighbours, page_of, rooms_with
from repro.report.run_files import packed_runs, place_of_runs
from repro.report.verdict_pages import VERDICTS, verdict_context
from repro.report.views.baselines import standings_view
from repro.report.views.calibration import truthful
from repro.report.views.findings import Shown, bare_table, everything, table_view, tallies
from repro.report.views.heat_map import heat_map
from repro.report.views.line_plot import least_values
from repro.report.views.picture import picture
from repro.report.views.readings import ruled_out_by, settings_of
from repro.report.views.runs import RunsView, runs_view
from repro.report.views.search_box import search_index
from repro.report.views.sizes import sized
from repro.report.views.times import times_drawn
from repro.report.views.weighed import weighed
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
    entry, files = _paper_files(judgement, master_seed, called)
    provenance = provenance_entry(judgement, environments, called)
    outside = [each.says for each in judgement.outside if each.outside]
    says = [f"{judgement.paper.key}, {each}" for each in outside]
    return Made(entry=entry, provenance=provenance, files=files, says=says)


def _paper_files(judgement: Judgement, master_seed: str, called: str) -> tuple[Json, Files]:
    key = judgement.paper.key
    drawings = _drawings(judgement)
    entry = paper_result(judgement, master_seed)
    runs = runs_view(judgement)
    times = times_drawn(judgement)
    rooms = _rooms(judgement, drawings, runs, timed=bool(times))
    entry["rooms"] = [room.name for room in rooms]
    context = _context(judgement, entry, drawings, called) | runs.context()
    context["times_drawn"] = times
    files: Files = {}
    for before, here, after in neighbours(rooms):
        own = {"here": here, "before": before, "after": after, "rooms": rooms}
        files[page_of(key, here)] = render("paper.html", context | own)
    files[f"{key}.md"] = render("paper.md", context | {"rooms": rooms})
    files |= _data(judgement, entry, drawings) | runs.files(key)
    files |= {f"tables/{key}-{name}.csv": csv_text(d.frame, DIGITS) for name, d in times}
    files |= {f"figures/{key}-{name}.svg": standalone(d.svg) for name, d in times}
    return entry, files


def _context(
    judgement: Judgement, entry: Json, drawings: Sequence[Drawing], called: str
) -> dict[str, object]:
    """Return what the templates of a paper's pages name, less what is drawn of the runs."""
    paper = judgement.paper
    calibrated = calibration()["rows"]
    told = everything(
        *(judgement.findings, judgement.audit, settings_of(paper), ruled_out_by(paper)),
        least=least_values(paper.claims, judgement.certificates),
    )
    found = sized(told, paper)
    return {
        "paper": paper,
        "called": called,
        "entry": entry,
        "cited": entry["cited"],
        "counts": verdict_counts(entry),
        "shown_counts": cell_counts(entry),
        "truthful": truthful(judgement, calibrated),
        "not_calibrated": not calibrated,
        "tallies": tallies(found),
        **_printed(paper, found, judgement.audit),
        **weighed(judgement, found),
        "standings": tuple(map(standings_view, judgement.standings)),
        "drawings": [  # with the names of their data
            (drawing, anchor(figure.label))
            for figure, drawing in zip(paper.figures, drawings, strict=True)
        ],
        "provenance": entry["provenance"],
    }


def _rooms(
    judgement: Judgement, drawings: Sequence[Drawing], runs: RunsView, *, timed: bool
) -> tuple[Room, ...]:
    """Return the rooms that the paper fills; `timed` where times are drawn."""
    live = [drawing for drawing in drawings if drawing.scene]
    filled = {
        "times": timed,
        "heat_map": any(finding.table for finding in judgement.findings),
        "optimum": judgement.certificates,
        "figures": len(drawings) > len(live),
        "arm": live,
        "distributions": runs.distributions,
        "centre_bias": runs.centre_biases or runs.shiftable,
        "formulas": judgement.paper.formulas,
    }
    return rooms_with(lambda section: bool(filled.get(section, True)))


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
    """Return the pages that say how verdicts are made, and what the words mean."""
    pages: dict[str, Mapping[str, object]] = {
        VERDICTS: verdict_context(calibration()),
        PAGE: {"terms": glossary().terms},
    }
    return {
        f"{name}.{kind}": render(f"{name}.{kind}", context)
        for name, context in pages.items()
        for kind in ("html", "md")
    }


def index_files(
    results: Json,
    another_seed: Json | None = None,
    called: Mapping[str, str] = MappingProxyType({}),
) -> dict[str, str]:
    """Return the index pages, and what the README has of them: table, findings and picture.

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
        "shown_of": cell_counts,
        "impossible_of": impossible_rows,
        "verdicts": [v for v in Verdict if v != Verdict.NOT_RUN or not_run],
        "search": search_index(papers, glossary()),
        "another_seed": another_seed,
        "again": _all_again(papers, called),
    }
    names = ("index.html", "index.md", "verdicts.md", "finding.md")
    return {
        **{name: render(name, context) for name in names},
        "figures/at-a-glance.svg": render("at-a-glance.svg", picture(papers)),
    }


def _all_again(papers: Sequence[Json], called: Mapping[str, str]) -> str:
    """Return what to type to have all these pages again."""
    repeats = str(max((1, *(paper["provenance"]["repeats"] for paper in papers))))
    if any(called.values()):
        names = (called.get(paper["key"]) or paper["key"] for paper in papers)
        given = ("repro", "reproduce", *dict.fromkeys(names))
    else:
        given = ("nox", "-s", "reproduce", "--")
    return shlex.join((*given, "--repeats", repeats))


def _data(judgement: Judgement, entry: Json, drawings: Sequence[Drawing]) -> Files:
    paper = judgement.paper
    found = findings_frame([entry])
    groups = found["table"].fillna("claims").map(anchor)
    files: Files = {
        f"tables/{paper.key}-{group}.csv": csv_text(found.loc[groups == group, list(FINDING)])
        for group in groups.unique()
    }
    for figure, drawing in zip(paper.figures, drawings, strict=True):
        name = f"{paper.key}-{anchor(figure.label)}"
        files[f"tables/{name}.csv"] = csv_text(drawing.frame, DIGITS)
        files[f"figures/{name}.svg"] = standalone(drawing.svg)
    if paper.experiments:
        files[place_of_runs(paper.key)] = packed_runs(judgement.runs)
    return files
