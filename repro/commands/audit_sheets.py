"""`repro audit FILE.xlsx`: as of any file, with the library that reads workbooks."""

from argparse import Namespace

from repro.commands.audit_files import run_with
from repro.commands.sheets import workbook_grids


def run(options: Namespace) -> int:
    """Print what every table says."""
    return run_with(options, sheets=workbook_grids, bounds=None)
