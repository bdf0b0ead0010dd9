"""`repro list`: papers, experiments, tables, and how many runs are done."""

import json
from argparse import Namespace

from repro.commands import catalogue
from repro.commands.kept_output import tell
from repro.commands.listed_papers import listing
from repro.commands.listing_text import listing_text


def run(options: Namespace) -> int:
    """Print the papers; the runs in the store are read and not changed."""
    rows = listing(catalogue.chosen(options), options.repeats, options.store)
    tell(options, json.dumps(rows, indent=2) + "\n" if options.json else listing_text(rows))
    return 0
