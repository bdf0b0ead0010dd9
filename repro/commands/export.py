"""`repro export`: runs, curves and tables, for other programs."""

import importlib.util
import sys
from argparse import Namespace
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path

import pandas as pd

from repro.commands import catalogue
from repro.commands.load import RESULTS, Results, load
from repro.commands.shown_rows import warn
from repro.commands.stored_results import NoRunsError, Stored
from repro.errors import InputError
from repro.model.identifiers import anchor
from repro.report.frames import csv_text
from repro.report.ioh_files import ioh_files
from repro.report.latex_tables import latex_table
from repro.runs.store.settled import NAME
from repro.runs.whole_files import usable_folder, write_file

Written = Iterator[Path]
KINDS = ("findings", "audit", "certificates", "tests", "standings")


def run(options: Namespace) -> int:
    """Write the files and print the place of each; InputError where there is nothing to export."""
    source = _source(options)
    results = load(source, options.keys)
    keys = _keys(results, options.keys, source)
    usable_folder(options.to, "the folder")
    written = False
    for key in keys:
        try:
            for path in _WRITERS[options.format](results, key, options.to):
                sys.stdout.write(f"{path}\n")
                written = True
        except NoRunsError as error:  # of all papers some may never have been run
            if options.keys:
                raise
            warn(str(error))
    if not written:
        message = f"nothing to export in {source}"
        raise InputError(message)
    return 0


def _source(options: Namespace) -> Path:
    """Return what is read: pages for tables, the store for curves, for runs what there is."""
    has = {
        options.store: (options.store / NAME).exists(),
        options.reports: (options.reports / RESULTS).exists(),
    }
    wanted = {"ioh": [options.store]}.get(options.format, [options.reports, options.store])
    for place in wanted:
        if has[place]:
            return Path(place)
    places = " nor ".join(map(str, wanted))
    message = f"nothing to export in {places}: `repro reproduce` makes runs and pages"
    raise InputError(message)


def _keys(results: Results, asked: Iterable[str], source: Path) -> list[str]:
    """Return the keys of the papers to export; InputError for one that is not there."""
    wanted = [paper.key for paper in catalogue.found_papers(asked)] if asked else results.papers
    for key in wanted:
        if key not in results.papers:
            message = f"no paper {key!r} in {source}; it has {', '.join(results.papers)}"
            raise InputError(message)
    return list(wanted)


def _frames(results: Results, key: str) -> Iterator[tuple[str, pd.DataFrame]]:
    """Yield the name and the rows of each file; of a store the runs alone, as judging is slow."""
    yield f"{key}-runs", results.runs(key)
    if not isinstance(results.source, Stored):
        for kind in KINDS:
            frame = getattr(results, kind)
            yield f"{key}-{kind}", frame[frame["paper"] == key]


def _csv(results: Results, key: str, to: Path) -> Written:
    for name, frame in _frames(results, key):
        write_file(to, f"{name}.csv", csv_text(frame))
        yield to / f"{name}.csv"


def _parquet(results: Results, key: str, to: Path) -> Written:
    if importlib.util.find_spec("pyarrow") is None:
        message = "Parquet needs pyarrow: install it with pip install 'repro-whales[parquet]'"
        raise InputError(message)
    for name, frame in _frames(results, key):
        # 128 bits of a seed fit no number of Parquet, and lists of several kinds no column
        texts = {
            column: frame[column].map(_text) for column in frame if frame[column].dtype == object
        }
        write_file(to, f"{name}.parquet", frame.assign(**texts).to_parquet(index=False))
        yield to / f"{name}.parquet"


def _text(value: object) -> str | None:
    missing = value is None or (isinstance(value, float) and value != value)  # noqa: PLR0124 (NaN)
    return None if missing else str(value)


def _ioh(results: Results, key: str, to: Path) -> Written:
    source = results.source
    if not isinstance(source, Stored):  # of this format no other is taken
        message = f"{source.place} is no store"
        raise InputError(message)
    places: dict[str, str] = {}
    for experiment, records in source.cells(key):
        name = f"{len(places) + 1}-{anchor(experiment.name)}"
        folder = places.setdefault(experiment.name, f"{key}-ioh/{name}")
        for file, text in ioh_files(experiment, records).items():
            write_file(to, f"{folder}/{file}", text)
    yield to / f"{key}-ioh"


def _latex(results: Results, key: str, to: Path) -> Written:
    found = results.findings
    own = found[(found["paper"] == key) & found["table"].notna()]
    for table, findings in own.groupby("table", sort=False):
        name = f"{key}-{anchor(table)}"
        write_file(to, f"{name}.tex", latex_table(findings, name))
        yield to / f"{name}.tex"


_WRITERS: Mapping[str, Callable[[Results, str, Path], Written]] = {
    "csv": _csv,
    "parquet": _parquet,
    "ioh": _ioh,
    "latex": _latex,
}
