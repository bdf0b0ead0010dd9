"""Old and new schemas, folders that cannot be written, and disks without room."""

import hashlib
import os
import shutil
import sqlite3
import subprocess
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from repro.errors import InputError
from repro.runs.store.file import APPLICATION, SCHEMA, open_to_read
from repro.runs.store.row import curve_of, digest, values_of
from repro.runs.store.store import Store
from tests.small_stores import INTACT, RECORDS, TASKS, filled, read, reproduced, timeless

# as version 0.1.0 made it
SCHEMA_1 = """
create table env(id integer primary key, json text unique not null);
create table run(
    id integer primary key, key text unique not null, paper text not null, experiment text not null,
    problem text not null, algorithm text not null, repeat integer not null, run integer not null,
    cost real, x blob not null, evaluations integer not null, seconds real not null,
    reason text, env integer not null references env(id), sha text not null);
create table curve(id integer primary key references run(id), y blob not null);
"""


MOUNT = shutil.which("mount") or "mount"
UNMOUNT = shutil.which("umount") or "umount"


@pytest.fixture
def old(tmp_path: Path) -> Path:
    """Return the folder of a store of schema 1 that holds every run of the small paper."""
    with closing(sqlite3.connect(tmp_path / "runs.sqlite")) as database:
        database.executescript(
            f"begin; {SCHEMA_1} pragma application_id={APPLICATION}; pragma user_version=1; commit;"
        )
        database.execute("insert into env values (1, '{}')")
        for number, record in enumerate(RECORDS, 1):
            values, curve = values_of(record, 1), curve_of(record)
            row = (number, *values, digest(values, "{}", curve))
            database.execute(f"insert into run values ({', '.join('?' * len(row))})", row)  # noqa: S608
            database.execute("insert into curve values (?, ?)", (number, curve))
        database.commit()
    return tmp_path


def version(folder: Path) -> int:
    with closing(sqlite3.connect(folder / "runs.sqlite")) as database:
        return int(database.execute("pragma user_version").fetchone()[0])


def test_digest_of_schema_1_still_holds() -> None:
    values = ("k", "p", "e", "b", "a", 1, 2, 1.5, b"\x00", 20, 0.25, None, 1)

    assert (
        digest(values, "{}", b"curve")
        == hashlib.sha256(
            b"str:'k'\0str:'p'\0str:'e'\0str:'b'\0str:'a'\0int:1\0int:2\0float:0x1.8000000000000p+0\0"
            b"bytes:00\0int:20\0float:0x1.0000000000000p-2\0NoneType:None\0int:1\0str:'{}'\0curve"
        ).hexdigest()
    )


def test_store_of_schema_1_is_read_as_it_is(old: Path) -> None:
    assert read(old) == INTACT
    assert version(old) == 1


def test_store_of_schema_1_is_migrated_by_the_next_call_that_writes(old: Path) -> None:
    assert reproduced(old) == (INTACT, [], [])
    assert version(old) == SCHEMA
    assert read(old) == INTACT


def test_damaged_row_of_schema_1_is_set_aside(old: Path) -> None:
    with closing(sqlite3.connect(old / "runs.sqlite")) as database:
        database.execute("update run set cost = 0 where id = 3")
        database.commit()

    records, made, said = reproduced(old)

    assert (records, made, len(said)) == (INTACT, [TASKS[2].name], 2)


def test_whole_runs_of_a_damaged_store_of_schema_1_are_taken_over(old: Path) -> None:
    path = old / "runs.sqlite"
    path.write_bytes(path.read_bytes().replace(b"CREATE TABLE env", b"CREATE TABLE enx"))

    records, made, said = reproduced(old)

    assert (records, len(made)) == (INTACT, 6)
    assert "set aside as" in said[0]


def test_store_in_memory_stands_for_none(tmp_path: Path) -> None:
    with closing(open_to_read(tmp_path / "runs.sqlite", alone=True)) as database:
        assert database.execute("select count(*) from run").fetchone() == (0,)
    assert list(tmp_path.iterdir()) == []


def test_read_only_folder_is_bad_input(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = filled(tmp_path / "store")
    if os.geteuid() == 0:  # root may write everywhere, so the system's refusal is imitated
        real = os.open

        def refused(path: Path, flags: int, *rest: int) -> int:
            if flags & os.O_CREAT:
                raise PermissionError(13, "Permission denied")
            return real(path, flags, *rest)

        monkeypatch.setattr(os, "open", refused)
    else:
        (folder / "repro.lock").chmod(0o400)
        folder.chmod(0o500)

    try:
        with pytest.raises(InputError, match="cannot be used: Permission denied") as end:
            reproduced(folder)
        assert end.value.exit_code == 2
        assert read(folder) == INTACT
    finally:
        monkeypatch.undo()
        folder.chmod(0o700)


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """Yield the folder of a disk of 192 KiB."""
    if os.geteuid() != 0:
        pytest.skip("only root may mount a small disk")
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = (MOUNT, "-t", "tmpfs", "-o", "size=192k", "tmpfs", str(folder))
    done = subprocess.run(mount, capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.skip(f"no small disk can be mounted here: {done.stderr.strip()}")
    yield folder
    subprocess.run((UNMOUNT, "-l", str(folder)), check=True)


@pytest.mark.faults
def test_full_disk_keeps_finished_runs_and_the_next_call_goes_on(small_disk: Path) -> None:
    reproduced(small_disk)
    noise = np.random.default_rng(1).uniform(size=4000)  # 32 kB that do not pack
    many = [replace(TASKS[0], key=f"{number:064}") for number in range(20)]
    with Store(small_disk) as store:
        store.begin({})

        def fill() -> None:
            for task in many:
                store.add([replace(RECORDS[0], task=task, history=noise)])

        with pytest.raises(InputError, match="make room and run the same command again") as end:
            fill()
        assert end.value.exit_code == 2
        stored = len(many) - len(store.missing(many))
    assert 0 < stored < 20

    with Store(small_disk, writing=False) as store:
        assert [timeless(record) for record in store.records(TASKS)] == INTACT
        assert len(store.missing(many)) == 20 - stored
    subprocess.run((MOUNT, "-o", "remount,size=4m", str(small_disk)), check=True)
    with Store(small_disk) as store:
        store.begin({})
        store.add([replace(RECORDS[0], task=task, history=noise) for task in store.missing(many)])
        assert store.missing(many) == []
