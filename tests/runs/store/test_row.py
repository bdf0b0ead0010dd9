import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.runs.store.row import (
    LONGEST,
    curve_of,
    digest,
    pack,
    record_of,
    unpack,
    values_of,
    vector,
)
from tests.small_stores import RECORDS, TASKS, content


@given(st.binary(max_size=200))
def test_curve_comes_back_byte_by_byte(curve: bytes) -> None:
    assert unpack(pack(curve), 1) == curve
    assert unpack(curve, 0) == curve


@pytest.mark.parametrize(
    ("blob", "packed"),
    [
        ("text", 0),
        (None, 1),
        (b"x", None),
        (b"x", 2),
        (b"x", 1),
        (zlib.compress(b"x")[:-1], 1),
        (zlib.compress(b"x") + b"x", 1),
    ],
)
def test_curve_that_is_not_what_was_packed_is_none(blob: object, packed: object) -> None:
    assert unpack(blob, packed) is None


def test_curve_that_would_fill_the_memory_is_damage(monkeypatch: pytest.MonkeyPatch) -> None:
    assert LONGEST >= 8 * 10**7
    monkeypatch.setattr("repro.runs.store.row.LONGEST", 100)

    assert unpack(pack(bytes(100)), 1) == bytes(100)
    assert unpack(pack(bytes(101)), 1) is None


def test_row_is_the_record_again_and_any_other_row_is_none() -> None:
    record = RECORDS[0]
    values, curve = values_of(record, 1), curve_of(record)
    row = (*values, digest(values, "{}", curve), "{}", pack(curve), 1)

    found = record_of(TASKS[0], row)

    assert found is not None
    assert content(found) == content(record)
    assert record_of(TASKS[0], None) is None
    for place in range(len(row)):
        other = "0" if row[place] != "0" else "1"
        assert record_of(TASKS[0], (*row[:place], other, *row[place + 1 :])) is None


def test_vector_of_what_is_no_blob_is_empty() -> None:
    assert vector("text").size == 0
    assert vector(np.array([1.5, -0.0]).tobytes()).tolist() == [1.5, 0.0]
