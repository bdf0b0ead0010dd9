from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from repro.commands.kept_evidence import OfStore, gathered
from repro.commands.kept_listing import FOLDER
from repro.model.evidence import Evidence
from repro.runs.gather import gather
from repro.runs.raw_runs import RawCell, RawRuns
from repro.runs.store.store import Store
from repro.runs.studies import studies
from tests.small_papers import PAPER
from tests.small_stores import TASKS, filled

BESIDES = studies(PAPER, 2)
Found = tuple[Evidence, tuple[RawCell, ...]]


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Return a list that grows whenever rows of the store are read."""
    found: list[int] = []
    whole = Store.records

    def noted(store: Store, tasks: object) -> object:
        found.append(1)
        return whole(store, tasks)  # type: ignore[arg-type]

    monkeypatch.setattr(Store, "records", noted)
    return found


def found(place: Path, rows: str = "rows") -> Found:
    """Return the evidence of the small paper and its runs, kept or not."""
    raw = RawRuns(BESIDES)
    with Store(place) as store:
        source = OfStore(store=store, paper=PAPER, besides=BESIDES, rows=rows)
        return gathered(source, TASKS, raw), raw.cells()


def content(evidence: Evidence) -> list[object]:
    return [
        (cell, each.costs.tolist(), each.points.tolist(), each.histories.tolist(), each.evaluations)
        for cell, each in evidence.runs.items()
    ]


def test_kept_evidence_is_what_is_gathered_to_the_last_bit(tmp_path: Path, read: list[int]) -> None:
    filled(tmp_path)
    raw = RawRuns(BESIDES)
    with Store(tmp_path) as store:
        expected = gather(store, PAPER, TASKS, BESIDES, raw.note)
    times = len(read)
    first, again = found(tmp_path), found(tmp_path)
    assert len(read) == 2 * times
    for evidence, runs in (first, again):
        assert content(evidence) == content(expected)
        assert [each.seconds for each in evidence.runs.values()] == [
            each.seconds for each in expected.runs.values()
        ]
        assert evidence.experiments == expected.experiments
        assert runs == raw.cells()
        assert all(np.isfinite(each.costs).all() for each in evidence.runs.values())


def other_rows(place: Path) -> Found:
    return found(place, "others")


def unknown_rows(place: Path) -> Found:
    return found(place, "")


def damaged(place: Path) -> Found:
    for path in (place / FOLDER).iterdir():
        path.write_bytes(path.read_bytes()[:-1])
    return found(place)


@pytest.mark.parametrize("again", [other_rows, unknown_rows, damaged])
def test_evidence_of_other_rows_or_damaged_is_gathered_anew(
    tmp_path: Path, read: list[int], again: Callable[[Path], Found]
) -> None:
    filled(tmp_path)
    evidence, runs = found(tmp_path)
    times = len(read)
    other = again(tmp_path)
    assert len(read) == 2 * times
    assert (content(other[0]), other[1]) == (content(evidence), runs)
