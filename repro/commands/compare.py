"""`repro compare`: searches of a user's own under every protocol, and a private report of them."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from repro.commands import catalogue
from repro.commands.compare_entrants import named, split, stem
from repro.commands.comparing import compared, silence
from repro.commands.interrupts import terminable
from repro.commands.progress import Progress
from repro.commands.shown_rows import warn
from repro.errors import SOME_RUN_FAILED, InputError
from repro.judge.comparison import Asked
from repro.model.paper import Paper
from repro.report.compared_pages import write_comparison
from repro.runs.whole_files import usable_folder
from repro.runs.workers.local import checked_workers


def run(options: Namespace) -> int:
    """Run the searches, write their report, and say where that is."""
    places, options.keys = split(options.given)
    checked_workers(options.workers)
    papers = _with_protocols(catalogue.chosen(options))
    searches = named(places, options.names, papers)
    _refuse_published(options.reports)
    asked = Asked(
        searches=searches,
        experiments=tuple(options.experiments),
        problems=tuple(options.problems),
        against=tuple(options.against),
        runs=options.runs,
        repeats=options.repeats,
        timeout=options.timeout,
        centre_bias=options.centre_bias,
    )
    options.say = warn
    with terminable():
        reporting = silence if options.quiet else Progress
        found = compared(
            asked, papers, options, reporting, ready=partial(usable_folder, options.reports)
        )
        called = stem(options.reports, list(searches))
        page = write_comparison(options.reports, called, found)
    for record in found.failed:
        warn(f"run {record.task.name} failed: {record.reason}")
    for warned in found.warnings:
        warn(f"{warned.kind}: {warned.says}")
    for missing in found.missing:
        warn(missing.says)
    sys.stdout.write(f"page: {page}\n")
    return SOME_RUN_FAILED if found.failed else 0


def _with_protocols(papers: Sequence[Paper]) -> list[Paper]:
    """Return the papers that run something; InputError where none does."""
    found = [paper for paper in papers if paper.experiments]
    without = [paper.key for paper in papers if not paper.experiments]
    if not found:
        message = f"no experiments in {', '.join(without)}: no protocol to run a search under"
        raise InputError(message)
    for key in without:
        warn(f"{key} has no experiments: it is left out")
    return found


def _refuse_published(folder: Path) -> None:
    """Raise InputError for a folder of published pages, which a private report must not enter."""
    if (folder / "results.json").exists() or folder.resolve() == Path("reports").resolve():
        message = f"the folder {folder} holds published pages: choose another with --reports"
        raise InputError(message)
