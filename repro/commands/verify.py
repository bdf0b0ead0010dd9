"""`repro verify`: a random sample of the stored runs, made again and compared."""

import json
import sys
from argparse import Namespace

from repro.commands import catalogue
from repro.commands.compare_entrants import entrant_in
from repro.commands.compiled_code import say_whether_kept
from repro.commands.shown_rows import warn
from repro.determinism.provenance import provenance
from repro.errors import SOME_RUN_FAILED, InputError, StoreError
from repro.runs.compared import tasks_of
from repro.runs.plan import plan
from repro.runs.store.store import Store
from repro.runs.verify import Outcome, verify


def run(options: Namespace) -> int:
    """Print the sample; StoreError for damaged rows, InputError where nothing can be compared."""
    folder = options.folder or options.store
    say_whether_kept()
    with Store(folder, writing=False) as store:
        repeats = max(store.repeats(), options.repeats)
    papers = catalogue.chosen(options)
    found = verify(
        folder,
        (
            *plan(papers, repeats, options.master_seed),
            *tasks_of(folder, papers, entrant_in, warn),
        ),
        sample=options.sample,
        seed=options.seed,
        here=provenance(),
    )
    sys.stdout.write(
        json.dumps(found.as_json(), indent=2) + "\n" if options.json else found.as_text()
    )
    if found.damaged:
        message = f"{len(found.damaged)} rows are damaged; `repro reproduce` sets them aside"
        raise StoreError(message)
    if not found.sample:
        message = (
            f"nothing was compared: no run in {folder} is one that this version would make "
            "(a paper from elsewhere is named by --paper ./mine.py)"
        )
        raise InputError(message)
    return SOME_RUN_FAILED if found.count(Outcome.MISMATCH) else 0
