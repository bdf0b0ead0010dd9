import random
from pathlib import Path

import pytest

from repro.errors import ReproError, StoreError
from repro.plan import Task
from repro.store import Store
from tests.small_stores import RECORDS, TASKS, change, content, filled, stored


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the folder of a store that holds every run of the small paper."""
    return filled(tmp_path / "store")


@pytest.mark.parametrize(
    "damage",
    [
        "update run set cost = cost + 1e-16 where id = 3",
        "update run set cost = null where id = 3",
        "update run set x = zeroblob(16) where id = 3",
        "update run set evaluations = 21 where id = 3",
        "update run set seconds = seconds * 2 where id = 3",
        "update run set repeat = 2 where id = 3",
        "update run set algorithm = 'wide' where id = 3",
        "update run set algorithm = cast(x'ff' as text) where id = 3",
        "update run set sha = '0' where id = 3",
        "update curve set y = zeroblob(40) where id = 3",
        "update curve set y = 'flat' where id = 3",
        "delete from curve where id = 3",
        "update env set json = '{}'",
        "delete from env",
    ],
)
def test_damaged_row_is_refused_by_name(folder: Path, damage: str) -> None:
    change(folder, damage)

    with pytest.raises(
        StoreError, match=r"the row of small2020/search/bowl/guess/1/[13] is damaged"
    ):
        stored(folder)


def test_environment_that_is_no_json_is_refused(folder: Path) -> None:
    change(folder, "update env set json = '{'")

    with pytest.raises(StoreError, match="is damaged"), Store(folder) as store:
        store.environments(TASKS)


def after_damage(folder: Path) -> tuple[list[Task], list[tuple[object, ...]]] | None:
    """Return what is missing and what is stored, or None where the damage is reported."""
    try:
        with Store(folder) as store:
            store.environments(TASKS)
            records = [content(record) for record in store.records(TASKS)]
            return store.missing(TASKS), records
    except ReproError:
        return None


@pytest.mark.parametrize("seed", range(4))
def test_flipped_bit_is_reported_or_changes_nothing(folder: Path, seed: int) -> None:
    path = folder / "runs.sqlite"
    whole = path.read_bytes()
    intact = {record.task.name: content(record) for record in RECORDS}
    rng = random.Random(seed)  # noqa: S311 (places of damage, not secrets)
    reported = 0
    for _ in range(50):
        place = rng.randrange(len(whole))
        flipped = whole[place] ^ (1 << rng.randrange(8))
        path.write_bytes(whole[:place] + bytes([flipped]) + whole[place + 1 :])
        for leftover in folder.glob("runs.sqlite-*"):
            leftover.unlink()

        found = after_damage(folder)

        reported += found is None
        if found is not None:
            missing = {task.name for task in found[0]}
            expected = [text for name, text in intact.items() if name not in missing]
            assert [text for text in found[1] if text[0] not in missing] == expected
    assert reported > 0


@pytest.mark.parametrize("share", [0.25, 0.5, 0.9])
def test_truncated_store_is_refused(folder: Path, share: float) -> None:
    path = folder / "runs.sqlite"
    whole = path.read_bytes()
    path.write_bytes(whole[: int(share * len(whole))])

    with pytest.raises(StoreError):
        stored(folder)
