"""What the command line accepts."""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

from repro.commands.audit_settings import add_audit_options, audit_command, is_table_file
from repro.commands.compare_settings import add_compare_options
from repro.errors import InputError

DEFAULT_REPEATS = 10
STORE, REPORTS, PRIVATE = Path(".repro"), Path("reports"), Path("reports-private")
FORMATS = ("csv", "parquet", "ioh", "latex")
_AGAIN = (
    "Run what one printed number needs, once, and say what comes out, with the verdict by this one "
    "repeat and beside it what the pages say by all of theirs. The first call compiles the "
    "searches, which takes longer than the runs; later ones need seconds, or what the runs take. "
    "Nothing is stored, unless a store is named: what it has is not run, and what it lacks is kept "
    "in it."
)
_PAPER = "a key, a file or folder that declares papers, or the key of an installed package"
_PAPERS = f"{_PAPER} (default: all)"
_TEXTS = {
    "reproduce": "run what is missing, then write pages",
    "report": "write pages from the store, run nothing",
    "list": "papers, experiments, tables, runs done and missing",
    "compare": "run a search of your own on every problem and write a private report",
    "new": "write a module and its prose to fill in: KEY.py and KEY.toml",
    "check": "what a paper must satisfy, and what this house asks besides",
    "again": "run one printed number again",
    "export": "runs, curves and tables for other programs",
    "audit": "what the printed tables say about themselves",
    "certify": "proved minima of the motion problems",
    "motion": "the proved minimum of a motion of one's own",
    "references": "what other planners say of them",
    "verify": "re-run a random sample of the stored runs and compare",
    "flips": "compare the verdicts of two results.json, of two master seeds say",
}


def parsed(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """Return the options; what a command does not know ends the program with that one's usage."""
    options, unknown = parser().parse_known_args(arguments)
    if files := [name for name in unknown if is_table_file(name)]:
        message = f"{files[0]!r} reads like an option; a file of this name is ./{files[0]}"
        raise InputError(message)
    if options.several and not any(name.startswith("-") for name in unknown):
        # argparse takes what stands before the first option alone
        getattr(options, options.several).extend(unknown)
    elif unknown:
        options.named.error(f"unrecognized arguments: {' '.join(unknown)}")
    if options.command == "audit":
        options.command = audit_command(options.keys, vars(options))
    return options


def parser() -> argparse.ArgumentParser:
    """Return the parser; the options that it gives have the name of the `command` to call."""
    whole = argparse.ArgumentParser(
        prog="repro", description="Re-run published papers and say, number by number, what holds."
    )
    added = whole.add_subparsers(required=True, metavar="COMMAND")
    parsers = {}
    for name, text in _TEXTS.items():
        description = _AGAIN if name == "again" else text
        parsers[name] = added.add_parser(name, help=text, description=description)
        parsers[name].set_defaults(command=name, named=parsers[name], several="")
    _add_names(parsers)
    _add_runs(parsers)
    _add_places(parsers)
    add_audit_options(parsers["audit"])
    _add_motion(parsers["motion"])
    for name in ("list", "audit", "certify", "motion", "references", "verify", "flips"):
        parsers[name].add_argument("--json", action="store_true", help="print JSON")
    return whole


def _add_motion(motion: argparse.ArgumentParser) -> None:
    """Add the files of motions, and what becomes of them."""
    motion.add_argument("files", nargs="+", metavar="FILE.toml", help="a motion and its limits")
    motion.set_defaults(several="files")
    motion.add_argument(
        "--seconds",
        type=float,
        default=60.0,
        metavar="S",
        help="how long a proof may take; one that is cut short has bounds (default: 60)",
    )
    motion.add_argument(
        "--csv", type=Path, metavar="FILE", help="write the motion, in rad, m and s"
    )
    motion.add_argument("--html", type=Path, metavar="FILE", help="write a page with drawings")


def _add_names(parsers: Mapping[str, argparse.ArgumentParser]) -> None:
    """Add what stands behind a command: papers, a number, a store, a search, two results."""
    add_compare_options(parsers["compare"])
    for name in ("reproduce", "report", "list", "audit", "certify", "references", "export"):
        parsers[name].add_argument("keys", nargs="*", metavar="PAPER", help=_PAPERS)
        parsers[name].set_defaults(several="keys")
    parsers["new"].add_argument("key", metavar="KEY", help="names the paper: its author and year")
    parsers["check"].add_argument("keys", nargs="+", metavar="PAPER", help=_PAPER)
    again, verify, flips = parsers["again"], parsers["verify"], parsers["flips"]
    again.add_argument("keys", nargs=1, metavar="PAPER", help=_PAPER)
    again.add_argument("name", metavar="NAME", help="the number, as its page and its CSV call it")
    verify.add_argument("folder", nargs="?", type=Path, metavar="STORE", help=f"default: {STORE}")
    verify.add_argument(
        "--paper",
        action="append",
        default=[],
        dest="keys",
        metavar="PAPER",
        help=_PAPERS,
    )
    verify.add_argument("--sample", type=int, default=20, metavar="N", help="runs (default: 20)")
    verify.add_argument("--seed", default="1", metavar="TEXT", help="what names the sample")
    flips.add_argument("first", type=Path, metavar="FIRST", help="a results.json")
    flips.add_argument("second", type=Path, metavar="SECOND", help="another")


def _add_runs(parsers: Mapping[str, argparse.ArgumentParser]) -> None:
    """Add how often runs are made, and where."""
    times = "how often the whole protocol runs"
    for name in ("reproduce", "report", "list", "compare"):
        default = 1 if name == "compare" else DEFAULT_REPEATS
        text = f"{times} (default: {default})"
        parsers[name].add_argument("--repeats", type=int, default=default, metavar="N", help=text)
    parsers["verify"].add_argument(
        "--repeats", type=int, default=DEFAULT_REPEATS, help=argparse.SUPPRESS
    )
    for name in ("reproduce", "compare", "again"):
        parsers[name].add_argument(
            "--workers", type=int, help="workers on this machine (default: cores)"
        )
    reproduce = parsers["reproduce"]
    reproduce.add_argument(
        "--processes", action="store_true", help="every run in a process, safe from its crash"
    )
    for name in ("reproduce", "compare"):
        text = "use the Dask cluster at this address"
        parsers[name].add_argument("--dask", metavar="ADDRESS", help=text)
    for name in ("reproduce", "report", "again", "verify"):
        parsers[name].add_argument(
            "--master-seed", default="", metavar="TEXT", help="makes every run another one"
        )
    for name in ("reproduce", "report"):
        parsers[name].add_argument(
            "--protocol-only", action="store_true", help="no readings, shifts or baselines besides"
        )


def _add_places(parsers: Mapping[str, argparse.ArgumentParser]) -> None:
    """Add the folders that a command uses."""
    for name in ("reproduce", "report", "list", "compare", "verify", "export"):
        parsers[name].add_argument("--store", type=Path, default=STORE, metavar="DIR")
    parsers["again"].add_argument("--store", type=Path, metavar="DIR", help="default: none")
    _add_export(parsers["export"])
    for name in ("reproduce", "report", "compare", "export", "again"):
        default = PRIVATE if name == "compare" else REPORTS
        parsers[name].add_argument("--reports", type=Path, default=default, metavar="DIR")


def _add_export(export: argparse.ArgumentParser) -> None:
    """Add what is written, and where."""
    help_text = "csv and parquet: runs and what is said of them; ioh: curves; latex: printed tables"
    export.add_argument("--format", choices=FORMATS, default=FORMATS[0], help=help_text)
    text = "where files are written (default: the current folder)"
    export.add_argument("--to", type=Path, default=Path(), metavar="DIR", help=text)
