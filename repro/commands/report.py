"""`repro report`: pages from the store, without running anything."""

import shlex
import sys
from argparse import Namespace
from collections.abc import Sequence
from functools import partial

from repro.commands import catalogue
from repro.commands.arguments import STORE
from repro.commands.kept_pages import Request, planned_extent
from repro.commands.shown_rows import warn
from repro.commands.written_pages import made_pages, write_made
from repro.errors import InputError
from repro.model.paper import Paper
from repro.report.earlier import check_folder
from repro.runs.plan import check_repeats, planned
from repro.runs.store.store import Store
from repro.runs.whole_files import usable_folder


def run(options: Namespace) -> int:
    """Write the pages; InputError where there is no store."""
    chosen = catalogue.chosen(options)
    check_repeats(options.repeats)
    known = catalogue.order(chosen)
    check_folder(options.reports, [paper.key for paper in chosen], known)
    with Store(options.store, writing=False) as store:
        if not store.path.exists():
            message = f"there is no store in {options.store}; `repro reproduce` makes one"
            raise InputError(message)
        usable_folder(options.reports)
        asked = [_asked(paper, options) for paper in chosen]
        made = made_pages(store, asked, options.places, known)
        write_made(made, options.reports, known)
    if missing := sum(each.missing for each in made):
        total = sum(each.tasks for each in made)
        warn(
            f"{missing} run{'s' * (missing != 1)} of {total} are not in {options.store}: "
            f"`{_command(chosen, options)}` makes them"
        )
    sys.stdout.write(f"pages: {options.reports / 'index.html'}\n")
    return 0


def _command(chosen: Sequence[Paper], options: Namespace) -> str:
    """Return what to type so that the runs of these pages are made."""
    papers = [options.called.get(paper.key, paper.key) for paper in chosen]
    more = ["--repeats", str(options.repeats)]
    if options.master_seed:
        more.append(f"--master-seed={options.master_seed}")
    if options.store != STORE:
        more.append(f"--store={options.store}")
    return shlex.join(["repro", "reproduce", *papers, *more])


def _asked(paper: Paper, options: Namespace) -> Request:
    only = {"protocol_only": options.protocol_only}
    return Request(
        paper=paper,
        tasks=partial(planned, [paper], options.repeats, options.master_seed, **only),
        extent=planned_extent(paper, options.repeats, options.master_seed, **only),
        called=options.called.get(paper.key, ""),
    )
