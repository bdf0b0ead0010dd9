import math
import shutil
import sqlite3
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from threading import Event, Thread
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.errors import InputError, StoreError
from repro.runs.plan import plan
from repro.runs.run import execute, failed
from repro.runs.store import questions
from repro.runs.store.file import APPLICATION, SCHEMA
from repro.runs.store.store import Store
from tests.small_papers import LOST, Failing, searching
from tests.small_stores import (
    ENVIRONMENT,
    RECORDS,
    TASKS,
    change,
    content,
    filled,
    finished_keys,
    stored,
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the folder of a store that holds every run of the small paper."""
    return filled(tmp_path / "store")


@pytest.fixture(scope="module")
def scratch() -> Iterator[Store]:
    """Yield an open store for many examples."""
    with tempfile.TemporaryDirectory() as name, Store(Path(name)) as store:
        store.begin(ENVIRONMENT)
        yield store


ANY_FLOAT = st.floats(allow_subnormal=True)
VECTOR = st.lists(ANY_FLOAT, max_size=5).map(lambda values: np.array(values, dtype=np.float64))


@settings(deadline=None)
@given(st.floats(allow_nan=False, allow_infinity=False), VECTOR, VECTOR, st.floats(0, 1e9))
def test_any_number_comes_back_bit_by_bit(
    scratch: Store,
    cost: float,
    x: NDArray[np.float64],
    history: NDArray[np.float64],
    seconds: float,
) -> None:
    record = replace(RECORDS[0], cost=cost, x=x, history=history, seconds=seconds)

    scratch.add([record])

    (found,) = scratch.records(TASKS)
    assert content(found) == content(record)


@pytest.mark.parametrize("cost", [-0.0, 5e-324, -5e-324, 2.2e-308, 1.7976931348623157e308])
def test_numbers_at_the_ends_of_the_range_do_not_look_damaged(scratch: Store, cost: float) -> None:
    scratch.add([replace(RECORDS[0], cost=cost)])

    assert [record.cost for record in scratch.records(TASKS)] == [cost]


def test_numbers_of_numpy_are_stored_as_numbers(scratch: Store) -> None:
    record: Any = replace(RECORDS[0], cost=np.float64(1.5), evaluations=np.int64(7))  # type: ignore[arg-type]

    scratch.add([record])

    (found,) = scratch.records(TASKS)
    assert (found.cost, found.evaluations) == (1.5, 7)


def test_store_is_found_as_it_was_left(folder: Path) -> None:
    assert stored(folder) == [content(record) for record in RECORDS]
    assert stored(folder) == [content(record) for record in RECORDS]


def test_records_come_in_the_order_of_the_tasks(folder: Path) -> None:
    with Store(folder) as store:
        found = [record.task for record in store.records(reversed(TASKS))]

    assert found == list(reversed(TASKS))


def test_missing_are_the_tasks_without_a_run_in_their_order(tmp_path: Path) -> None:
    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        assert store.missing(TASKS) == list(TASKS)
        store.add([RECORDS[4], RECORDS[1]])
    with Store(tmp_path) as store:
        assert store.missing(TASKS) == [TASKS[0], TASKS[2], TASKS[3], TASKS[5]]


def test_keys_that_are_too_many_to_hold_are_looked_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(questions, "HELD", 1)
    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        store.add([RECORDS[4], RECORDS[1], failed(TASKS[0], "lost", 0.0)])

        assert store.missing(TASKS) == [TASKS[0], TASKS[2], TASKS[3], TASKS[5]]


def test_seconds_of_a_kind_leave_its_longest_run_out(tmp_path: Path) -> None:
    took = (7.0, 1.0, 3.0)
    alike = [r for r in RECORDS if r.task.algorithm == RECORDS[0].task.algorithm][:3]
    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        store.add([replace(r, seconds=s) for r, s in zip(alike, took, strict=True)])

        assert list(store.seconds().values()) == [2.0]


def test_failed_run_is_kept_with_its_reason_and_tried_again(tmp_path: Path) -> None:
    tasks = plan([searching(bad=Failing())], 1)
    lost = execute(tasks[0])
    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        store.add([lost])
        (found,) = store.records(tasks)
        assert (found.reason, math.isnan(found.cost)) == (LOST, True)
        assert store.missing(tasks) == list(tasks)
        store.add([replace(RECORDS[0], task=tasks[0])])
        (found,) = store.records(tasks)
        assert (found.reason, found.cost) == (None, RECORDS[0].cost)
    with closing(sqlite3.connect(tmp_path / "runs.sqlite")) as database:
        assert database.execute("select count(*) from curve").fetchone() == (1,)


def test_run_under_another_key_is_missing(folder: Path) -> None:
    changed = replace(TASKS[0], key="0" * 64)

    with Store(folder) as store:
        assert store.missing([changed, *TASKS[1:]]) == [changed]
        assert list(store.records([changed])) == []


def test_batch_that_cannot_be_written_leaves_nothing_behind(tmp_path: Path) -> None:
    broken: Any = replace(RECORDS[1], seconds="long")  # type: ignore[arg-type]

    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        with pytest.raises(ValueError, match="long"):
            store.add([RECORDS[0], broken])
        assert store.missing(TASKS) == list(TASKS)


def test_environments_are_those_of_the_asked_runs_in_order(tmp_path: Path) -> None:
    with Store(tmp_path) as store:
        for record, cores in zip(RECORDS, (2, 8, 2, 4, 4, 2), strict=True):
            store.begin({"cores": cores})
            store.add([record])
        assert store.environments(TASKS) == [{"cores": 2}, {"cores": 8}, {"cores": 4}]
        assert store.environments(TASKS[1:2]) == [{"cores": 8}]


def test_newer_store_is_refused(folder: Path) -> None:
    change(folder, f"pragma user_version = {SCHEMA + 1}")

    for use in (stored, finished_keys):
        with pytest.raises(StoreError, match="has schema 3, newer than 2: update repro") as error:
            use(folder)
        assert error.value.exit_code == 3


@pytest.mark.parametrize("mark", ["pragma journal_mode = wal", "select 1"])
def test_store_whose_making_was_cut_short_is_made_anew(tmp_path: Path, mark: str) -> None:
    change(tmp_path, mark)

    assert finished_keys(tmp_path) == frozenset()
    assert stored(tmp_path) == []
    assert stored(tmp_path) == []


def test_store_is_made_whole_or_not_at_all(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "repro.runs.store.file.TABLES", "create table env(id); create table env(id);"
    )
    with pytest.raises(StoreError, match="already exists"), Store(tmp_path):
        pass
    monkeypatch.undo()

    assert stored(tmp_path) == []


def test_second_writer_waits_for_the_first_and_says_so_and_readers_do_not(folder: Path) -> None:
    said: list[str] = []
    waiting, entered = Event(), Event()

    def say(line: str) -> None:
        said.append(line)
        waiting.set()

    def enter() -> None:
        with Store(folder, say=say):
            entered.set()

    with Store(folder):
        second = Thread(target=enter)
        second.start()
        assert waiting.wait(10)
        assert len(finished_keys(folder)) == len(TASKS)
        assert not entered.is_set()
    second.join(10)
    assert entered.is_set()
    assert said == [f"the store {folder} is in use by another call; waiting until it is free"]


def test_store_that_was_refused_is_not_left_locked(folder: Path) -> None:
    change(folder, "pragma user_version = 99")
    with pytest.raises(StoreError, match="newer"), Store(folder):
        pass
    change(folder, f"pragma user_version = {SCHEMA}")

    assert len(stored(folder)) == len(TASKS)


def reading(folder: Path) -> list[tuple[object, ...]]:
    """Return the content of every record in a store that is only read."""
    with Store(folder, writing=False) as store:
        return [content(record) for record in store.records(TASKS)]


def test_reader_changes_nothing_and_leaves_no_file(folder: Path) -> None:
    before = {path.name: path.read_bytes() for path in folder.iterdir()}

    assert reading(folder) == [content(record) for record in RECORDS]

    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_reader_sees_one_state_while_another_call_writes(folder: Path) -> None:
    with Store(folder) as store:
        store.begin(ENVIRONMENT)
        with Store(folder, writing=False) as reader:
            before = reader.finished()
            store.add([replace(RECORDS[0], task=replace(TASKS[0], key="0" * 64))])
            assert reader.finished() == before
        assert finished_keys(folder) == before | {"0" * 64}


def test_reader_finds_what_a_killed_call_left_in_its_journal(folder: Path, tmp_path: Path) -> None:
    with Store(folder) as store:
        store.begin(ENVIRONMENT)
        store.add([replace(RECORDS[0], task=replace(TASKS[0], key="0" * 64))])
        shutil.copytree(folder, tmp_path / "killed")

    assert finished_keys(tmp_path / "killed") == {task.key for task in TASKS} | {"0" * 64}


@pytest.mark.parametrize("use", [stored, finished_keys])
def test_file_in_place_of_the_folder_is_bad_input(
    tmp_path: Path, use: Callable[[Path], object]
) -> None:
    (tmp_path / "store").write_text("in the way")

    with pytest.raises(InputError, match=r"the store folder .*store cannot be used") as error:
        use(tmp_path / "store")
    assert error.value.exit_code == 2


@pytest.mark.parametrize("use", [stored, finished_keys])
def test_folder_in_place_of_the_file_is_bad_input(
    tmp_path: Path, use: Callable[[Path], object]
) -> None:
    (tmp_path / "runs.sqlite").mkdir()

    with pytest.raises(InputError, match=r"runs.sqlite cannot be used as a store"):
        use(tmp_path)


def test_folder_below_a_file_is_bad_input(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")

    with (
        pytest.raises(InputError, match="cannot be used: Not a directory"),
        Store(tmp_path / "file" / "store"),
    ):
        pass


def test_nothing_is_finished_where_there_is_no_store(tmp_path: Path) -> None:
    assert finished_keys(tmp_path / "store") == frozenset()
    assert list(tmp_path.iterdir()) == []


def test_finished_keys_are_those_of_runs_that_did_not_fail(folder: Path) -> None:
    tasks = plan([searching(bad=Failing())], 1)
    with Store(folder) as store:
        store.begin(ENVIRONMENT)
        store.add([execute(tasks[0])])

    assert finished_keys(folder) == {task.key for task in TASKS}


def test_store_says_what_it_is(folder: Path) -> None:
    with closing(sqlite3.connect(folder / "runs.sqlite")) as database:
        marks = [
            database.execute(f"pragma {name}").fetchone()[0]
            for name in ("application_id", "user_version", "journal_mode", "integrity_check")
        ]

    assert marks == [APPLICATION, SCHEMA, "wal", "ok"]
    assert APPLICATION.to_bytes(4, "big") == b"REPR"


def fingerprint(folder: Path) -> str | None:
    with Store(folder) as store:
        return store.fingerprint()


def test_a_fingerprint_is_that_of_the_same_bytes(folder: Path) -> None:
    before = fingerprint(folder)

    assert before is not None
    with Store(folder) as store:
        assert store.missing(TASKS) == []
        assert store.fingerprint() == store.fingerprint() == before
        store.begin(ENVIRONMENT)
        assert store.fingerprint() == before
        store.add(RECORDS[:1])
        assert store.fingerprint() != before


def test_a_fingerprint_changes_with_any_byte_of_the_file(folder: Path) -> None:
    path = folder / "runs.sqlite"
    before, content = fingerprint(folder), path.read_bytes()

    for place in (len(content) // 2, len(content) - 1):
        path.write_bytes(content[:place] + bytes([content[place] ^ 1]) + content[place + 1 :])
        assert fingerprint(folder) != before
    path.write_bytes(content)
    assert fingerprint(folder) == before


def test_there_is_no_fingerprint_while_a_reader_keeps_runs_in_the_journal(folder: Path) -> None:
    with Store(folder) as store:
        store.begin(ENVIRONMENT)
        with closing(sqlite3.connect(folder / "runs.sqlite")) as reader:
            reader.execute("begin")
            reader.execute("select count(*) from run").fetchone()
            store.add(RECORDS[:1])

            assert store.fingerprint() is None

        assert store.fingerprint() is not None


def test_a_fingerprint_leaves_the_lock_of_the_database(folder: Path) -> None:
    # closing another handle of the file would let go of SQLite's locks
    with Store(folder) as store:
        store.fingerprint()
        program = (
            "import fcntl, sys; file = open(sys.argv[1], 'r+b'); "
            "fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)"
        )
        command = (sys.executable, "-c", program, str(folder / "runs.sqlite"))
        assert subprocess.run(command, capture_output=True, check=False).returncode != 0
    assert subprocess.run(command, capture_output=True, check=False).returncode == 0
