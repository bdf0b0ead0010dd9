"""Frames of drawings as their CSV files have them."""

import csv

import pandas as pd

from repro.report.frames import DIGITS, csv_text

Rows = list[tuple[str, ...]]


def rows_of(frame: pd.DataFrame) -> Rows:
    """Return the headings and the rows of a drawing's CSV file, as text."""
    return [tuple(row) for row in csv.reader(csv_text(frame, DIGITS).splitlines())]
