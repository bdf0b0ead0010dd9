"""`repro audit FILE…`: what the tables of any file say about themselves."""

import sys
from argparse import Namespace
from dataclasses import replace

from repro.commands.audit_settings import BoundsOf, is_table_file, options_of
from repro.commands.shown_rows import show_json, warn
from repro.commands.streams import one_line
from repro.commands.table_files import SheetReader, read_tables
from repro.errors import SOME_RUN_FAILED, InputError
from repro.report.audited_page import page
from repro.runs.whole_files import write_named
from repro.tables.audit_options import Guess
from repro.tables.audit_words import lines
from repro.tables.auditing import AuditedTable, audited

_NO_TABLE = "no table with numbers in it was found"


def run(options: Namespace) -> int:
    """Print what every table says, a file that cannot be read in one line."""
    return run_with(options, sheets=None, bounds=None)


def run_with(options: Namespace, *, sheets: SheetReader | None, bounds: BoundsOf | None) -> int:
    """As `run`, with readers of what needs a library."""
    papers = [name for name in options.keys if not is_table_file(name)]
    if papers:
        message = f"{papers[0]!r} is no file of tables: papers and files are audited one by one"
        raise InputError(message)
    found: list[AuditedTable] = []
    refused = 0
    for name in options.keys:
        try:
            found.extend(audit_file(name, vars(options), sheets=sheets, bounds=bounds))
        except InputError as error:
            refused = error.exit_code
            warn(str(error))
    if options.json:
        show_json([table.as_json() for table in found])
    else:
        sys.stdout.writelines(f"{one_line(line)}\n" for table in found for line in lines(table))
    if options.html and found:  # after what is said, which it must not take away
        write_named(options.html, page(found))
    return refused or (SOME_RUN_FAILED if any(table.proofs for table in found) else 0)


def audit_file(
    name: str, told: dict[str, object], *, sheets: SheetReader | None, bounds: BoundsOf | None
) -> list[AuditedTable]:
    """Return the audit of a file's tables; InputError where there is none that can be read."""
    file = read_tables(name, sheets)
    found = audited(
        file.grids, options_of(name, told, bounds), file=file.name, context=file.context
    )
    if not found:
        message = f"{file.name}: {_NO_TABLE}"
        raise InputError(message)
    notes = tuple(Guess(says=note) for note in file.notes)
    return [replace(table, guesses=(*notes, *table.guesses)) for table in found]
