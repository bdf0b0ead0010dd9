"""Units in the headings of tables of data."""

import csv
import re

import pytest

from tests.made_up import pages_of

QUANTITY = r"\b(time|duration|velocity|speed|acceleration|jerk|angle|length)s?\b"


def test_columns_of_what_has_a_unit_name_it_in_every_file_of_data(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    pages = pages_of(tmp_path_factory.mktemp("doe"))
    headings = {
        heading
        for name, text in pages.items()
        if name.endswith(".csv")
        for heading in next(csv.reader(text.splitlines()))
    }

    with_units = {each for each in headings if re.search(QUANTITY, each)}
    assert "time [s]" in with_units
    assert [each for each in with_units if "[" not in each] == []
