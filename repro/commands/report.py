"""`repro report`: pages from the store, without running anything."""

import sys
from argparse import Namespace

from repro.commands import catalogue
from repro.commands.shown_rows import warn
from repro.commands.written_pages import write_pages
from repro.errors import InputError
from repro.report.earlier import check_folder
from repro.runs.plan import plan
from repro.runs.store.store import Store, finished_keys


def run(options: Namespace) -> int:
    """Write the pages; InputError where there is no store."""
    chosen = catalogue.chosen(options)
    tasks = plan(chosen, options.repeats, options.master_seed, protocol_only=options.protocol_only)
    known = catalogue.order(chosen)
    check_folder(options.reports, [paper.key for paper in chosen], known)
    missing = len({task.key for task in tasks} - finished_keys(options.store))
    with Store(options.store, writing=False) as store:
        if not store.path.exists():
            message = f"there is no store in {options.store}; `repro reproduce` makes one"
            raise InputError(message)
        write_pages(
            store,
            chosen,
            tasks,
            options.reports,
            known,
            called=options.called,
        )
    if missing:
        papers = " ".join(options.called.get(paper.key, paper.key) for paper in chosen)
        runs = f"{missing} run{'s' * (missing != 1)} of {len(tasks)}"
        warn(
            f"{runs} are not in {options.store}: "
            f"`repro reproduce {papers} --repeats {options.repeats}` makes "
            "them"
        )
    sys.stdout.write(f"pages: {options.reports / 'index.html'}\n")
    return 0
