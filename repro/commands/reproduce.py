"""`repro reproduce`: run what is missing, write the pages, and say what came out."""

import sys
from argparse import Namespace
from collections.abc import Callable, Sequence
from pathlib import Path

from repro.commands import catalogue
from repro.commands.compiled_code import compiling_ahead, say_whether_kept
from repro.commands.expected_verdicts import expected_rows, summary
from repro.commands.interrupts import terminable
from repro.commands.kept_output import tell
from repro.commands.made_before import remember
from repro.commands.progress import Progress
from repro.commands.running import run_lacking
from repro.commands.shown_rows import warn
from repro.commands.written_pages import Run, write_pages
from repro.errors import SOME_RUN_FAILED, Terminated
from repro.report.earlier import check_folder
from repro.report.results import Json
from repro.runs.plan import Task, plan, planned
from repro.runs.run import Record
from repro.runs.session import mended
from repro.runs.store.store import Store
from repro.runs.whole_files import usable_folder
from repro.runs.workers.local import checked_workers


def run(options: Namespace) -> int:
    """Run, judge, write; the last line says what differs from the expected verdicts."""
    chosen = catalogue.chosen(options)
    keys, known = [paper.key for paper in chosen], catalogue.order(chosen)
    tasks = planned(
        chosen, options.repeats, options.master_seed, protocol_only=options.protocol_only
    )
    at_first = plan(chosen, 1, options.master_seed, protocol_only=True)
    lists = _looked_at(options, keys, known)

    def pages(of: Sequence[Task], deeper: Run | None = None) -> Json:
        said = {"called": options.called, "places": options.places}
        return write_pages(store, chosen, of, options.reports, known, deeper, **said)

    def work() -> tuple[list[Record], Json]:
        failed = _run(store, tasks, at_first, options, pages)
        remember(options.store, chosen)
        results = pages(
            tasks, lambda more: failed.extend(run_lacking(store, more, options, Progress()))
        )
        return failed, results

    here = () if options.dask else (at_first, tasks)
    # a copy that is made before the store is locked cannot hold the lock
    with terminable(), compiling_ahead(*here), Store(options.store, say=warn) as store:
        failed, results = mended(store, work)
    for record in failed:
        warn(f"run {record.task.name} failed: {record.reason}")
    said = f"pages: {options.reports / 'index.html'}\n"
    said += summary(results, lists, options.master_seed)
    for paper in chosen:
        if not paper.experiments:
            said += f"{paper.key} has no experiments: nothing was to be run\n"
    if failed:
        sys.stdout.write(said)
        return SOME_RUN_FAILED
    tell(options, said)
    return 0


def _run(
    store: Store,
    tasks: Sequence[Task],
    at_first: Sequence[Task],
    options: Namespace,
    pages: Callable[[Sequence[Task]], Json],
) -> list[Record]:
    """Run what is missing and return the failed runs.

    `at_first`, the first repeat of every protocol, comes first, and provisional pages are written
    of it. Where the call is interrupted after that, they are written again of what there is.
    """
    lacks_first = any(store.lacking(at_first))
    progress = Progress()
    progress.expect(store.lacking(tasks), store.seconds())
    failed: list[Record] = []
    if lacks_first:
        failed = run_lacking(store, at_first, options, progress)
        if progress.expecting:
            with progress.paused():
                pages(at_first)
            _say_provisional(options.reports, "of one repeat; the runs go on")
    tried = {record.task.key for record in failed}
    rest = [task for task in tasks if task.key not in tried] if tried else tasks
    try:
        return [*failed, *run_lacking(store, rest, options, progress)]
    except Terminated:
        raise
    except KeyboardInterrupt:
        pages(tasks)
        _say_provisional(options.reports, "of what was run")
        raise


def _say_provisional(reports: Path, of: str) -> None:
    warn(f"provisional pages, {of}: {reports / 'index.html'}")


def _looked_at(options: Namespace, keys: Sequence[str], known: Sequence[str]) -> dict[str, Path]:
    """Return the lists of expected verdicts; say or raise before any run what is wrong with it."""
    checked_workers(options.workers)
    usable_folder(options.reports)
    check_folder(options.reports, keys, known)
    lists = {key: catalogue.expected_file(key, place) for key, place in options.places.items()}
    for path in lists.values():
        expected_rows(path)
    say_whether_kept()
    return lists
