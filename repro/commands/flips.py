"""`repro flips`: the verdicts of two results.json side by side."""

import sys
from argparse import Namespace
from pathlib import Path

from repro.commands.shown_rows import show_json
from repro.errors import InputError
from repro.judge.two_results import compare
from repro.report.results import read_results_of_any_age


def run(options: Namespace) -> int:
    """Print what differs; InputError where a file holds no results."""
    both = []
    for path in (options.first, options.second):
        found = read_results_of_any_age(path)
        if found is None:
            message = f"{path}: {_why_none(path)}"
            raise InputError(message)
        both.append(found)
    compared = compare(*both)
    if options.json:
        show_json(compared.as_json())
    else:
        sys.stdout.write(compared.as_text())
    return 0


def _why_none(path: Path) -> str:
    try:
        path.open("rb").close()
    except FileNotFoundError:
        return "no results are there"
    except OSError as error:
        return f"it cannot be read: {error.strerror}"
    return "it holds no results of repro"
