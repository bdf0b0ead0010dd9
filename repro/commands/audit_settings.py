"""What is told of a table, on the command line or in a TOML file beside it."""

import argparse
import tomllib
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from repro.commands.table_files import FORMS, STANDARD_INPUT, WORKBOOKS, is_workbook
from repro.errors import InputError
from repro.tables.audit_options import (
    CHOICES,
    FLAGS,
    NUMBERS,
    PRECISIONS,
    SPREADS,
    TESTS,
    TIES,
    AuditOptions,
    option_faults,
)
from repro.tables.blocks import FunctionBounds

BoundsOf = Callable[[str], FunctionBounds]  # of "sphere@30"
_NAMED = ("minimum", "function")
NAMES = (*FLAGS, *NUMBERS, *CHOICES, *_NAMED)
_SUFFIXES = (*FORMS, *WORKBOOKS, ".txt", ".dat")


def add_audit_options(audit: argparse.ArgumentParser) -> None:
    """Add what may be told of the tables of files."""
    told = audit.add_argument_group("of tables in files (or NAME.toml beside NAME.csv)")
    told.add_argument("--runs", type=int, metavar="N", help="runs behind every statistic")
    told.add_argument("--maximise", action="store_true", default=None, help="greater is better")
    told.add_argument("--minimise", action="store_false", dest="maximise", help="lower is better")
    told.add_argument(
        "--minimum", action="append", metavar="F1=100", help="least value of a problem, or of all"
    )
    told.add_argument("--errors", action="store_true", default=None, help="no value is below 0")
    told.add_argument(
        "--function", action="append", metavar="F1=sphere@30", help="function, and its dimension"
    )
    told.add_argument(
        "--integers", action="store_true", default=None, help="every run is a whole number"
    )
    told.add_argument("--precision", choices=PRECISIONS, help="what the runs were computed in")
    told.add_argument("--significant", type=int, metavar="4", help="digits rounded to")
    told.add_argument("--spread", choices=SPREADS, help="what a spread is (default: std)")
    told.add_argument("--test", choices=TESTS, help="what p-values are of")
    told.add_argument("--sided", type=int, choices=(1, 2), help="sides of the test")
    told.add_argument("--alpha", type=float, metavar="0.05", help="level of the test")
    told.add_argument("--ties", choices=TIES, help="how ranks share ties")
    told.add_argument("--html", type=Path, metavar="FILE", help="write the tables with their flags")


def is_table_file(argument: str) -> bool:
    """Say whether an argument of `audit` is a file of tables, not a paper."""
    suffix = Path(argument).suffix.lower()
    if argument == STANDARD_INPUT or suffix in _SUFFIXES:
        return True
    return suffix != ".py" and _is_file(Path(argument))


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a name too long, say
        return False


def audit_command(arguments: Sequence[str], told: Mapping[str, Any]) -> str:
    """Return the command module that audits these: of papers, files, sheets, or with functions."""
    if not any(map(is_table_file, arguments)):
        return "audit"
    if told["function"] or any("function" in _beside(name, strict=False) for name in arguments):
        return "audit_functions"
    return "audit_sheets" if any(map(is_workbook, arguments)) else "audit_files"


def options_of(name: str, told: Mapping[str, Any], bounds: BoundsOf | None) -> AuditOptions:
    """Return what is told of a file's tables; the command line goes before the TOML beside it."""
    beside = _beside(name, strict=True)
    unknown = [each for each in beside if each not in NAMES]
    if unknown:
        message = f"{_toml(name)}: unknown name {unknown[0]!r}; known: {', '.join(NAMES)}"
        raise InputError(message)
    given = {**beside, **{key: told[key] for key in NAMES if told.get(key) is not None}}
    place = str(_toml(name)) if beside else "the options"
    for fault in option_faults(given):
        message = f"{place}: {fault}"
        raise InputError(message)
    functions = _named(given.get("function"), "function")
    if functions and bounds is None:  # the command module with functions is called for those
        message = f"{place}: functions are not known here"
        raise InputError(message)
    return AuditOptions(
        **{key: given[key] for key in NAMES if key in given and key not in _NAMED},
        minimum={
            problem: _number(text) for problem, text in _named(given.get("minimum"), "minimum")
        },
        functions={problem: bounds(text) for problem, text in functions} if bounds else {},
    )


def _named(told: object, key: str) -> list[tuple[str, str]]:
    """Return problem and text of F1=100, of a number for all problems, or of a TOML table."""
    if told is None:
        return []
    if isinstance(told, Mapping):
        return [(str(name), str(value)) for name, value in told.items()]
    each = told if isinstance(told, list) else [told]
    pairs = [str(text).rpartition("=") for text in each]
    if any(not value for _, _, value in pairs):
        message = f"--{key} {each[0]!r}: it is to be NAME=VALUE, or VALUE for all problems"
        raise InputError(message)
    return [(name.strip(), value.strip()) for name, _, value in pairs]


def _number(text: str) -> Fraction:
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        message = f"--minimum: {text!r} is not a number"
        raise InputError(message) from None


def _toml(name: str) -> Path:
    return Path(name).with_suffix(".toml")


def _beside(name: str, *, strict: bool) -> dict[str, Any]:
    """Return what the TOML beside a file tells; nothing where there is none."""
    if name == STANDARD_INPUT or not Path(name).suffix or not _is_file(_toml(name)):
        return {}
    try:
        with _toml(name).open("rb") as file:
            return tomllib.load(file)
    except (OSError, ValueError) as error:
        if not strict:
            return {}
        message = f"{_toml(name)}: {' '.join(str(error).split())}"
        raise InputError(message) from None
