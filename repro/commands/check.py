"""`repro check`: what any paper must satisfy and, apart, what the papers of this house have."""

import sys
from argparse import Namespace
from collections.abc import Iterable, Iterator

from repro.commands import catalogue
from repro.errors import SOME_RUN_FAILED
from repro.model.contract import contract_faults, house_notes
from repro.model.functions_tried import bound_faults
from repro.runs.reading_checks import reading_plan_faults


def run(options: Namespace) -> int:
    """Print a line a fault; exit code 1 where a paper does what none may."""
    faults = 0
    for paper in catalogue.chosen(options):
        found = (*contract_faults(paper), *bound_faults(paper), *reading_plan_faults(paper))
        faults += len(found)
        sys.stdout.writelines(_lines(paper.key, found, tuple(house_notes(paper))))
    return SOME_RUN_FAILED if faults else 0


def _lines(key: str, faults: Iterable[str], notes: Iterable[str]) -> Iterator[str]:
    said = [f"  fault: {_one_line(fault)}\n" for fault in faults]
    yield (
        f"{key}: {len(said)} fault{'s' * (len(said) != 1)}\n"
        if said
        else f"{key}: all that a paper must satisfy holds\n"
    )
    yield from said
    if notes := tuple(notes):
        yield "  of this house's papers one would also ask:\n"
        yield from (f"    {_one_line(note)}\n" for note in notes)


def _one_line(text: str) -> str:
    return " ".join(text.split())
