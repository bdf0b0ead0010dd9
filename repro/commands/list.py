"""`repro list`: papers, experiments, tables, and how many runs are done."""

from argparse import Namespace

from repro.commands import catalogue
from repro.commands.kept_listing import keep_listing, show
from repro.commands.listed_papers import listing


def run(options: Namespace) -> int:
    """Print the papers; the runs in the store are read and not changed."""
    rows = listing(catalogue.chosen(options), options.repeats, options.store)
    if not options.faulty:
        keep_listing(options, rows)
    return show(rows, as_json=options.json)
