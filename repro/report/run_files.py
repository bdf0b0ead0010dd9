"""The published runs of a paper: a packed CSV file, of equal bytes for equal runs."""

import csv
import gzip
import io
from collections.abc import Iterable, Iterator
from pathlib import Path

import pandas as pd

from repro.errors import InputError
from repro.judge.centre_bias import Bias
from repro.model.identifiers import anchor
from repro.report.escapes import csv_value
from repro.report.frames import PUBLISHED
from repro.runs.raw_runs import RawCell

LEVEL = 9  # written once and read often
_WHOLE = ("repeat", "run", "evaluations")


def place_of_runs(key: str) -> str:
    """Return where the runs of a paper stand in the reports folder."""
    return f"runs/{key}.csv.gz"


def place_of_biases(key: str, experiment: str) -> str:
    """Return where the table of an experiment's centre biases stands in the reports folder."""
    return f"tables/{key}-{anchor('centre bias', experiment)}.csv"


def read_biases(path: Path) -> list[Bias]:
    """Return what a table of centre biases holds; nothing where there is none."""
    if not path.exists():
        return []
    try:
        frame = pd.read_csv(path, dtype={"algorithm": str, "problem": str}, keep_default_na=False)
        means = frame[frame["problem"] == "geometric mean"]
        return [
            Bias(
                algorithm=name, shift=float(shift), ratios={}, ratio=float(ratio),
                interval=(float(low), float(high)), p=float(p),
            )
            for name, shift, _, ratio, low, high, p in means.itertuples(index=False, name=None)
        ]  # fmt: skip
    except (OSError, ValueError, LookupError) as error:
        message = f"{path} holds no centre biases: {error}"
        raise InputError(" ".join(message.split())) from None


def packed_runs(cells: Iterable[RawCell]) -> bytes:
    """Return the file of these runs; neither a time nor a file's name is kept in it."""
    packed = io.BytesIO()
    with gzip.GzipFile("", "wb", LEVEL, packed, mtime=0) as file:
        file.write((",".join(PUBLISHED) + "\n").encode())
        for cell in cells:
            text = io.StringIO()  # frames of some hundred cells would take ten times as long
            csv.writer(text, lineterminator="\n").writerows(_rows(cell))
            file.write(text.getvalue().encode())
    return packed.getvalue()


def _rows(cell: RawCell) -> Iterator[tuple[object, ...]]:
    """Yield the runs of a cell by repeat and run, each once, its last if there are several."""
    names = (cell.study, cell.experiment, cell.problem, cell.algorithm)
    shown = tuple(map(csv_value, names))
    places = zip(cell.repeat, cell.run, strict=True)
    ended = dict(zip(places, zip(cell.cost, cell.evaluations, strict=True), strict=True))
    return ((*shown, *place, *ended[place]) for place in sorted(ended))


def read_runs(path: Path) -> pd.DataFrame:
    """Return what a file of runs holds, costs to the last bit; InputError where it is none."""
    kinds = dict.fromkeys(PUBLISHED, str) | dict.fromkeys(_WHOLE, "int64")
    try:
        frame = pd.read_csv(path, dtype=kinds, keep_default_na=False)  # a search may be called NA
        if list(frame) == list(PUBLISHED):
            # not every version of pandas reads every float to its last bit
            return frame.assign(cost=frame["cost"].map(float).astype("float64"))
    except FileNotFoundError:
        message = f"{path} is not there: `repro report` writes it from a store"
        raise InputError(message) from None
    except (OSError, EOFError, ValueError) as error:
        message = f"{path} holds no published runs: {error}"
        raise InputError(" ".join(message.split())) from None
    message = f"{path} holds no published runs: its columns are {', '.join(frame)}"
    raise InputError(message)
