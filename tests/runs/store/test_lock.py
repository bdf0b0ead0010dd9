"""The lock and the files beside it: nobody else's file is touched for them."""

import errno
import os
import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest

from repro.errors import InputError, StoreError
from repro.runs.store.lock import LOCK
from repro.runs.store.settled import settled_digest
from repro.runs.store.store import Store
from tests.small_stores import INTACT, filled, read, reproduced

TEXT = "somebody else's"


@pytest.mark.parametrize("name", ["lock", LOCK])
def test_a_link_in_the_place_of_the_lock_is_not_followed(tmp_path: Path, name: str) -> None:
    theirs = tmp_path / "theirs"
    theirs.write_text(TEXT)
    folder = tmp_path / "store"
    folder.mkdir()
    (folder / name).symlink_to(theirs)

    if name == LOCK:
        with pytest.raises(InputError, match="is a link"):
            filled(folder)
    else:
        filled(folder)

    assert theirs.read_text() == TEXT
    assert (folder / name).is_symlink()


def test_a_link_to_nothing_makes_nothing(tmp_path: Path) -> None:
    (tmp_path / LOCK).symlink_to(tmp_path / "new")

    with pytest.raises(InputError, match="is a link"):
        filled(tmp_path)

    assert not (tmp_path / "new").exists()


def test_a_file_of_the_locks_name_is_locked_and_not_emptied(tmp_path: Path) -> None:
    (tmp_path / LOCK).write_text(TEXT)

    filled(tmp_path)

    assert (tmp_path / LOCK).read_text() == TEXT


@pytest.mark.parametrize("kind", ["folder", "pipe"])
def test_what_is_no_file_is_no_lock(tmp_path: Path, kind: str) -> None:
    place = tmp_path / LOCK
    place.mkdir() if kind == "folder" else os.mkfifo(place)

    with pytest.raises(InputError, match="cannot be used"):
        filled(tmp_path)
    with Store(tmp_path, writing=False) as store:  # nobody ever wrote there
        assert store.finished() == frozenset()


def test_a_database_of_another_program_is_refused_and_left(tmp_path: Path) -> None:
    with closing(sqlite3.connect(tmp_path / "runs.sqlite")) as database:
        database.execute("create table marathon(name text)")
        database.commit()
    before = (tmp_path / "runs.sqlite").read_bytes()

    with pytest.raises(StoreError, match="of another program"):
        reproduced(tmp_path)
    with pytest.raises(StoreError, match="of another program"):
        read(tmp_path)

    assert (tmp_path / "runs.sqlite").read_bytes() == before


def test_only_the_files_of_the_store_are_set_aside(tmp_path: Path) -> None:
    filled(tmp_path)
    (tmp_path / "runs.sqlite.mine").write_text(TEXT)
    (tmp_path / "runs.sqlite").write_bytes(b"a poem " * 999)

    records, _, said = reproduced(tmp_path)

    assert records == INTACT
    assert "set aside" in said[0]
    assert (tmp_path / "runs.sqlite.mine").read_text() == TEXT


@pytest.mark.parametrize("kind", ["ENOLCK", "EOPNOTSUPP", "ENOSYS", "EINVAL", "EIO"])
def test_a_disk_that_refuses_locks_is_one_line_for_whoever_writes_and_reads(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    filled(tmp_path)
    number = getattr(errno, kind)

    def refuse(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr("fcntl.flock", refuse)

    says = os.strerror(number) if kind == "EIO" else "its disk locks no files"
    for use in (filled, read, settled_digest):
        with pytest.raises(InputError, match=says) as error:
            use(tmp_path)
        assert error.value.exit_code == 2
        assert "\n" not in str(error.value)


@pytest.mark.parametrize("kind", ["itself", "parent"])
def test_a_store_may_be_named_by_a_link(tmp_path: Path, kind: str) -> None:
    (tmp_path / "disk" / "store").mkdir(parents=True)
    link = tmp_path / "link"
    link.symlink_to(tmp_path / "disk" / ("store" if kind == "itself" else ""))
    store = link if kind == "itself" else link / "store"

    filled(store)

    assert read(store) == read(tmp_path / "disk" / "store") == INTACT
    assert {path.name for path in tmp_path.iterdir()} == {"disk", "link"}
    assert link.is_symlink()


@pytest.mark.parametrize("name", ["runs.sqlite", "runs.sqlite-wal", "runs.sqlite-shm"])
@pytest.mark.parametrize("to", ["theirs", "nothing"])
def test_a_link_in_the_place_of_the_database_is_refused(tmp_path: Path, name: str, to: str) -> None:
    store = filled(tmp_path / "store")
    (tmp_path / "theirs").touch()
    (store / name).unlink(missing_ok=True)
    (store / name).symlink_to(tmp_path / to)

    for use in (filled, read):
        with pytest.raises(InputError, match=f"{name} cannot be used as a store: it is a link"):
            use(store)

    assert (tmp_path / "theirs").read_bytes() == b""
    assert not (tmp_path / "nothing").exists()


def test_a_database_with_a_second_name_is_read_and_not_written(tmp_path: Path) -> None:
    store = filled(tmp_path / "store")
    (tmp_path / "copy").hardlink_to(store / "runs.sqlite")
    before = (tmp_path / "copy").read_bytes()

    with pytest.raises(InputError, match="it has a second name, so copy it"):
        filled(store)

    assert read(store) == INTACT
    assert (tmp_path / "copy").read_bytes() == before


def test_a_system_without_such_locks_is_told_so_in_a_sentence() -> None:
    code = "import sys; sys.modules['fcntl'] = None; import repro.runs.store.store"
    done = subprocess.run((sys.executable, "-c", code), capture_output=True, text=True, check=False)

    assert "InputError: the store cannot be locked on this system: " in done.stderr
