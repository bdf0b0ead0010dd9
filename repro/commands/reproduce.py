"""`repro reproduce`: run what is missing, write the pages, and say what came out."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from repro.commands import catalogue
from repro.commands.compiled_code import say_whether_kept
from repro.commands.expected_verdicts import expected_rows, summary
from repro.commands.interrupts import terminable
from repro.commands.made_before import remember
from repro.commands.progress import Progress
from repro.commands.shown_rows import warn
from repro.commands.unchanged import Written
from repro.commands.written_pages import write_pages
from repro.determinism.provenance import provenance
from repro.errors import SOME_RUN_FAILED
from repro.report.earlier import check_folder
from repro.report.files import usable_folder
from repro.report.results import Json, read_results
from repro.runs.plan import Task, plan
from repro.runs.run import Record
from repro.runs.session import mended, run_missing
from repro.runs.store.store import Store
from repro.runs.workers import dask_cluster
from repro.runs.workers.local import checked_workers, local


def run(options: Namespace) -> int:
    """Run, judge, write; the last line says what differs from the expected verdicts."""
    chosen = catalogue.chosen(options)
    keys, known = [paper.key for paper in chosen], catalogue.order(chosen)
    tasks = plan(chosen, options.repeats, options.master_seed, protocol_only=options.protocol_only)
    lists = _looked_at(options, keys, known)
    written = Written(
        tasks=tasks, chosen=keys, known=known,
        declarations=catalogue.folders(), reports=options.reports,
    )  # fmt: skip

    def work() -> tuple[list[Record], Json | None]:
        if catalogue.of_this_house(options.places.values()) and written.stand(store):
            return [], read_results(options.reports / "results.json")
        failed = _run(store, tasks, options)
        remember(options.store, chosen)

        def deeper(more: Sequence[Task]) -> None:
            failed.extend(_run(store, more, options))

        results = write_pages(
            store, chosen, tasks, options.reports, known, deeper, called=options.called
        )
        written.remember(store)
        return failed, results

    with terminable(), Store(options.store, say=warn) as store:
        failed, results = mended(store, work)
    for record in failed:
        warn(f"run {record.task.name} failed: {record.reason}")
    sys.stdout.write(f"pages: {options.reports / 'index.html'}\n")
    sys.stdout.write(summary(results or {"papers": []}, lists, options.master_seed))
    for paper in chosen:
        if not paper.experiments:
            sys.stdout.write(f"{paper.key} has no experiments: nothing was to be run\n")
    return SOME_RUN_FAILED if failed else 0


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


def _run(store: Store, tasks: Sequence[Task], options: Namespace) -> list[Record]:
    """Run what the store lacks, here or on a cluster, and return the failed runs."""
    missing = partial(run_missing, store, tasks, environment=provenance, report=Progress())
    if options.dask:
        with dask_cluster.cluster(options.dask) as (executor, threads):
            batch = dask_cluster.BATCH_SECONDS
            return missing(executor=executor, workers=threads, batch_seconds=batch)
    workers = checked_workers(options.workers)
    with local(workers, processes=options.processes) as executor:
        return missing(executor=executor, workers=workers)
