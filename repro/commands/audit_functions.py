"""`repro audit FILE --function F1=sphere@30`: as of any file, with what is known of functions."""

from argparse import Namespace

from repro.audit.blocks import bounds_of
from repro.commands.audit_files import run_with
from repro.commands.sheets import workbook_grids
from repro.errors import InputError, ReproError
from repro.functions import FUNCTIONS
from repro.tables.blocks import FunctionBounds


def run(options: Namespace) -> int:
    """Print what every table says."""
    return run_with(options, sheets=workbook_grids, bounds=named_bounds)


def named_bounds(text: str) -> FunctionBounds:
    """Return what is known of a function by its name and dimension, as in "sphere@30"."""
    name, _, dimension = text.partition("@")
    if name not in FUNCTIONS:
        message = f"unknown function {name!r}; known: {', '.join(FUNCTIONS)}"
        raise InputError(message)
    if dimension and not (dimension.isascii() and dimension.isdigit() and len(dimension) < 7):
        message = f"function {text!r}: its dimension {dimension!r} is no whole number"
        raise InputError(message)
    try:
        return bounds_of(FUNCTIONS[name].problem(int(dimension) if dimension else None))
    except ReproError as error:
        message = f"function {text!r}: {error}"
        raise InputError(message) from None
