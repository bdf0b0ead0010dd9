"""What becomes of a damaged store: named, set aside, run again; never trusted, never deleted."""

import re
import shutil
import sqlite3
from collections import Counter
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from repro.errors import DamageError, StoreError
from repro.runs.plan import plan
from repro.runs.run import execute
from repro.runs.store.damage import name_of
from repro.runs.store.store import Store
from tests.damages import LONG, damaged, tried
from tests.small_papers import Failing, searching
from tests.small_stores import (
    ENVIRONMENT,
    INTACT,
    TASKS,
    change,
    content,
    filled,
    read,
    reproduced,
)

ROWS = [
    "update run set cost = cost + 1e-16 where id = 3",
    "update run set cost = null where id = 3",
    "update run set x = zeroblob(16) where id = 3",
    "update run set evaluations = 21 where id = 3",
    "update run set seconds = seconds * 2 where id = 3",
    "update run set repeat = 2 where id = 3",
    "update run set reason = 'none' where id = 3",
    "update run set algorithm = 'wide' where id = 3",
    "update run set algorithm = cast(x'ff' as text) where id = 3",
    "update run set sha = '0' where id = 3",
    "update run set env = 'one' where id = 3",
    "update curve set y = zeroblob(40) where id = 3",
    "update curve set y = 'flat' where id = 3",
    "update curve set packed = 0 where id = 3",
    "update curve set packed = 2 where id = 3",
    "update curve set y = y || x'00' where id = 3",
    "delete from curve where id = 3",
]
ENVIRONMENTS = ["update env set json = '{}'", "update env set json = '{'", "delete from env"]
THIRD = TASKS[2].name


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the folder of a store that holds every run of the small paper."""
    return filled(tmp_path / "store")


@pytest.mark.parametrize("damage", ROWS)
def test_reader_refuses_a_damaged_row_by_name_with_the_cure(folder: Path, damage: str) -> None:
    change(folder, damage)

    place = f"row of {THIRD}|environment of a run"
    with pytest.raises(DamageError, match=rf"the ({place}) is damaged; `repro reproduce`") as end:
        read(folder)
    assert end.value.exit_code == 3


@pytest.mark.parametrize("damage", ENVIRONMENTS)
def test_reader_refuses_a_damaged_environment(folder: Path, damage: str) -> None:
    change(folder, damage)

    with pytest.raises(DamageError, match=r"the (row|environment) of .* is damaged; `repro"):
        read(folder)


@pytest.mark.parametrize("damage", ROWS)
def test_damaged_row_is_named_and_run_again_alone(folder: Path, damage: str) -> None:
    change(folder, damage)

    records, made, said = reproduced(folder)

    assert records == INTACT
    assert made == [THIRD]
    named, aside = said
    assert named.startswith(f"{folder / 'runs.sqlite'}: the row of small2020/search/bowl/")
    assert "5 whole runs are taken over from it" in aside
    assert aside.endswith("any other is made again where it is asked for")


def test_damaged_key_is_named_by_readers_and_its_run_made_again(folder: Path) -> None:
    path = folder / "runs.sqlite"
    whole, key = path.read_bytes(), TASKS[2].key.encode()
    places = [found.start() for found in re.finditer(key, whole)]
    trials = []
    for place in places:
        shutil.rmtree(folder)
        folder.mkdir()
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :])
        trials.append(tried(folder))

    assert [trial.records for trial in trials] == [INTACT, INTACT]
    in_index, in_row = sorted(trials, key=lambda trial: len(trial.made))
    assert (in_index.shown, in_index.made, len(in_index.said)) == (None, [], 2)
    assert "the index is damaged" in in_index.said[0]
    assert (in_row.shown, in_row.made, len(in_row.said)) == (None, [THIRD], 3)
    assert THIRD in in_row.said[0]


@pytest.mark.parametrize("damage", ENVIRONMENTS)
def test_rows_of_a_damaged_environment_are_all_run_again(folder: Path, damage: str) -> None:
    change(folder, damage)

    records, made, said = reproduced(folder)

    assert records == INTACT
    assert made == [task.name for task in TASKS]
    assert len(said) == 6 + 1


def test_damaged_file_is_kept_as_it_was(folder: Path) -> None:
    change(folder, "update run set algorithm = cast(x'ff' as text), cost = -1 where id = 3")
    before = (folder / "runs.sqlite").read_bytes()

    reproduced(folder)

    assert (folder / "set-aside-1" / "runs.sqlite").read_bytes() == before


def test_many_damaged_rows_are_counted_after_the_first_twenty(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("repro.runs.store.store._NAMED", 2)
    change(folder, "update run set cost = 0")

    said = reproduced(folder)[2]

    assert len(said) == 4
    assert said[2].endswith("runs.sqlite: 4 more rows are damaged")


def test_failed_run_is_no_damage(tmp_path: Path) -> None:
    tasks = plan([searching(bad=Failing())], 1)
    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        store.add([execute(tasks[0])])
        assert store.missing(tasks) == list(tasks)
        assert list(store.damaged()) == []


def overwrite(text: bytes) -> Callable[[Path], None]:
    def write(path: Path) -> None:
        path.write_bytes(text)

    return write


def foreign(statement: str) -> Callable[[Path], None]:
    def make(path: Path) -> None:
        path.unlink()
        change(path.parent, statement)

    return make


FOREIGN = {
    "text": overwrite(b"not a database, but long enough to be looked at" * 99),
    "header alone": overwrite(b"SQLite format 3\0"),
    "zeros": overwrite(bytes(8192)),
    "another program's": foreign("create table run(id)"),
    "another version": foreign("pragma user_version = 7"),
    "another mark": foreign("pragma application_id = 7"),
}


@pytest.mark.parametrize("kind", FOREIGN)
def test_foreign_file_is_refused_by_readers_and_left_alone(folder: Path, kind: str) -> None:
    path = folder / "runs.sqlite"
    FOREIGN[kind](path)
    before = path.read_bytes()

    with pytest.raises(StoreError, match=r"runs\.sqlite is (damaged|not a store of repro)"):
        read(folder)

    assert path.read_bytes() == before


@pytest.mark.parametrize("kind", FOREIGN)
def test_foreign_file_is_set_aside_whole_and_everything_run_again(folder: Path, kind: str) -> None:
    path = folder / "runs.sqlite"
    FOREIGN[kind](path)
    before = path.read_bytes()

    records, made, said = reproduced(folder)

    assert records == INTACT
    assert len(made) == 6
    (line,) = said
    assert f"set aside as {folder / 'set-aside-1' / 'runs.sqlite'}, 0 whole runs" in line
    assert (folder / "set-aside-1" / "runs.sqlite").read_bytes() == before


def test_side_folders_are_numbered(folder: Path) -> None:
    for number in (1, 2, 3):
        (folder / "runs.sqlite").write_bytes(bytes([number]) * 600)
        reproduced(folder)

    for number in (1, 2, 3):
        side = folder / f"set-aside-{number}" / "runs.sqlite"
        assert side.read_bytes() == bytes([number]) * 600


def test_foreign_journal_is_set_aside_and_no_run_is_lost(folder: Path) -> None:
    (folder / "runs.sqlite-wal").write_bytes(b"a poem" * 99)

    records, made, said = reproduced(folder)

    assert (records, made) == (INTACT, [])
    assert "runs.sqlite-wal is no journal of a store" in said[0]
    assert (folder / "set-aside-1" / "runs.sqlite-wal").read_bytes() == b"a poem" * 99


def test_whole_runs_are_taken_over_from_a_damaged_file(folder: Path) -> None:
    with closing(sqlite3.connect(folder / "runs.sqlite")) as database:
        page = database.execute(
            "select rootpage from sqlite_master where name = 'sqlite_autoindex_run_1'"
        ).fetchone()[0]
        size = database.execute("pragma page_size").fetchone()[0]
    change(folder, "delete from run where id = 3")
    with (folder / "runs.sqlite").open("r+b") as file:
        file.seek((page - 1) * size)
        file.write(b"\xff" * size)

    records, made, said = reproduced(folder)

    assert (records, made) == (INTACT, [THIRD])
    assert "5 whole runs are taken over from it" in said[0]


@pytest.mark.parametrize(
    ("row", "name"),
    [
        (None, "a run without a name"),
        (("k", "p", "e", "b", "a", 1, 2), "p/e/b/a/1/2"),
        (("k", "\x1b[2J", "e", "b", "a", 1, 2), r"'\x1b[2J/e/b/a/1/2'"),
        (("k", "p" * 500, "e", "b", "a", 1, 2), "'" + "p" * 199),
    ],
)
def test_name_of_a_damaged_row_is_fit_for_a_terminal(
    row: tuple[object, ...] | None, name: str
) -> None:
    assert name_of(row) == name


@pytest.mark.faults
def test_flipped_bit_or_cut_is_reported_or_changes_nothing(
    folder: Path, tally: Counter[str]
) -> None:
    whole = (folder / "runs.sqlite").read_bytes()
    for seed in range(400 if LONG else 40):
        shutil.rmtree(folder)
        folder.mkdir()
        (folder / "runs.sqlite").write_bytes(damaged(whole, str(seed)))

        trial = tried(folder)

        assert trial.shown in (None, INTACT), seed
        assert trial.records in (None, INTACT), seed
        assert all(str(folder / "runs.sqlite") in line for line in trial.said), seed
        assert trial.said or (trial.shown == INTACT and not trial.made), seed
        tally["damaged stores"] += 1
        tally["damages reported"] += bool(trial.said)
        tally["damages that no reader can see"] += not trial.said
        tally["bytes of damaged stores"] += len(whole)


def test_content_tells_records_apart() -> None:
    assert len({str(text) for text in INTACT}) == len(TASKS)
    assert content(execute(TASKS[0]))[0] == TASKS[0].name


@pytest.mark.parametrize(
    "damage",
    [
        ("CREATE TABLE run(", "CREATE TABLE rum("),
        ("CREATE TABLE curve(", "CREATE TABLE curv\xe5("),
        ("id integer primary key, key", "id integer prjmary key, key"),
        ("id integer primary key, json", "id intmger primary key, json"),
        ("packed integer not null default 0", "packee integer not null default 0"),
    ],
)
def test_damaged_schema_is_named_and_everything_is_there_again(
    folder: Path, damage: tuple[str, str]
) -> None:
    path = folder / "runs.sqlite"
    whole = path.read_bytes()
    path.write_bytes(whole.replace(damage[0].encode(), damage[1].encode("latin-1")))
    assert path.read_bytes() != whole

    records, _, said = reproduced(folder)

    assert records == INTACT
    assert all(str(path) in line for line in said)
    assert said
