import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from repro.__main__ import main
from repro.errors import InputError
from repro.runs.plan import plan
from repro.runs.run import Record, execute
from repro.runs.store.store import Store
from repro.runs.verify import LAST_BITS, Outcome, Verification, compare, verify
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import ENVIRONMENT, RECORDS, TASKS, change, filled


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder of a store that holds every run of the small paper, which is known."""
    let_be_known(monkeypatch, PAPER)
    return filled(tmp_path / "store")


def verified(folder: Path, *, sample: int = 6, seed: str = "1") -> Verification:
    return verify(folder, TASKS, sample=sample, seed=seed, here=dict(ENVIRONMENT))


def store(folder: Path, record: Record) -> None:
    with Store(folder) as opened:
        opened.begin(ENVIRONMENT)
        opened.add([record])


def test_stored_runs_come_out_again(folder: Path) -> None:
    found = verified(folder)

    assert (found.stored, found.current, found.damaged, found.elsewhere) == (6, 6, (), ())
    assert {row.run for row in found.sample} == {task.name for task in TASKS}
    assert found.count(Outcome.MATCH) == 6


def test_each_package_and_setting_that_was_another_is_named(folder: Path) -> None:
    was = {"packages": {"numpy": "1.0", "scipy": "2"}, "settings": {"NPY_X": "1"}, "system": "A"}
    with Store(folder) as opened:
        opened.begin(was)
        opened.add(RECORDS)
    now: dict[str, object] = {
        "packages": {"numpy": "1.1", "scipy": "2"},
        "settings": {},
        "system": "A",
    }

    found = verify(folder, TASKS, sample=6, seed="1", here=now)

    assert found.elsewhere == (
        "packages, numpy was 1.0, is 1.1",
        "settings, NPY_X was 1, is not noted",
    )


def test_where_two_histories_part_first_is_named(folder: Path) -> None:
    (stored, *_) = RECORDS
    history = stored.history.copy()
    history[2:] += 1.0
    store(folder, replace(stored, history=history))

    (row,) = (row for row in verified(folder).sample if row.outcome is not Outcome.MATCH)

    assert f"first at iteration 3: {stored.history[2].item()!r}, stored" in row.note


def test_sample_is_named_by_its_seed_and_does_not_depend_on_the_order(folder: Path) -> None:
    one, two = verified(folder, sample=3), verified(folder, sample=3)
    back = verify(folder, TASKS[::-1], sample=3, seed="1", here={})
    others = {tuple(r.run for r in verified(folder, sample=3, seed=s).sample) for s in "abcdefgh"}

    assert one.sample == two.sample == back.sample
    assert len(one.sample) == 3
    assert len(others) > 4


@pytest.mark.parametrize(
    ("changed", "outcome"),
    [
        (lambda r: r, Outcome.MATCH),
        (lambda r: replace(r, cost=np.nextafter(r.cost, 9.0)), Outcome.LAST_BITS),
        (lambda r: replace(r, x=r.x * (1.0 + 4e-16)), Outcome.LAST_BITS),
        (lambda r: replace(r, cost=r.cost * (1.0 + 3 * LAST_BITS)), Outcome.MISMATCH),
        (lambda r: replace(r, x=-r.x), Outcome.MISMATCH),
        (lambda r: replace(r, history=r.history[:-1]), Outcome.MISMATCH),
        (lambda r: replace(r, history=r.history * np.nan), Outcome.MISMATCH),
        (lambda r: replace(r, evaluations=21), Outcome.MISMATCH),
    ],
)
def test_difference_of_a_run_is_graded(
    folder: Path, changed: Callable[[Record], Record], outcome: Outcome
) -> None:
    store(folder, changed(RECORDS[2]))

    found = verified(folder)

    assert {row.run: row.outcome for row in found.sample if row.outcome is not Outcome.MATCH} == (
        {} if outcome is Outcome.MATCH else {TASKS[2].name: outcome}
    )


def test_run_that_fails_now_is_a_mismatch() -> None:
    assert compare(RECORDS[0], replace(RECORDS[0], reason="broke")).note == "broke"
    assert compare(RECORDS[0], replace(RECORDS[0], reason="broke")).outcome is Outcome.MISMATCH


@pytest.mark.parametrize(("factor", "code"), [(1.0, 0), (1.0 + 4e-16, 0), (1.5, 1)])
def test_command_says_by_its_exit_code_whether_a_run_mismatches(
    folder: Path, factor: float, code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    store(folder, replace(RECORDS[0], cost=RECORDS[0].cost * factor))
    before = {path.name: path.read_bytes() for path in folder.iterdir()}

    assert main(["verify", str(folder), "--repeats", "1", "--seed", "mine", "--json"]) == code

    found = json.loads(capsys.readouterr().out)
    assert (found["seed"], found["stored"], found["current"], len(found["sample"])) == (
        "mine",
        6,
        6,
        6,
    )
    assert sum(found["counts"].values()) == 6
    assert found["counts"]["match"] == (6 if factor == 1.0 else 5)
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_infinite_difference_is_null_in_json(folder: Path) -> None:
    store(folder, replace(RECORDS[0], x=np.zeros(3)))

    text = json.dumps(verified(folder).as_json(), allow_nan=False)

    assert sorted(row["difference"] is None for row in json.loads(text)["sample"])[-2:] == [
        False,
        True,
    ]


def test_command_tells_what_differs_in_lines(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    store(folder, replace(RECORDS[0], cost=7.0))

    main(["verify", "--store", str(folder), "--repeats", "1"])

    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith(
        "6 finished runs, 6 of them of this version; sample of 6 by the seed '1'"
    )
    assert any(
        line.startswith("another environment: packages was not noted, is ") for line in lines
    )
    assert any(line.startswith(f"mismatch: {TASKS[0].name}, cost 0.1") for line in lines)
    assert lines[-1] == "match: 5, last bits: 0, mismatch: 1"


def test_runs_of_another_version_are_counted_and_not_compared(folder: Path) -> None:
    found = verify(folder, plan([replace(PAPER, key="other")], 1), sample=5, seed="1", here={})

    assert (found.stored, found.current, found.sample) == (6, 0, ())


@pytest.mark.parametrize(("seed", "current"), [("", 72), ("other", 0)])
def test_every_repeat_of_the_store_can_be_in_the_sample(
    tmp_path: Path, seed: str, current: int, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with Store(tmp_path / "twelve") as opened:
        opened.begin(ENVIRONMENT)
        opened.add(execute(task) for task in plan([PAPER], 12, protocol_only=True))
    assert folder

    command = ("verify", str(tmp_path / "twelve"), "--master-seed", seed, "--sample", "1", "--json")
    code = main(command)

    text, errors = capsys.readouterr()
    found = json.loads(text)
    assert (found["stored"], found["current"]) == (72, current)
    assert (code == 0, "nothing was compared" in errors) == (current > 0, current == 0)


def test_damaged_rows_are_named_with_exit_code_3(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    change(folder, "update run set cost = 0 where id in (2, 3)")

    assert main(["verify", str(folder), "--repeats", "1"]) == 3

    out, err = capsys.readouterr()
    assert out.count("damaged: small2020/search/bowl/guess/1/") == 2
    assert err == "repro: 2 rows are damaged; `repro reproduce` sets them aside\n"


def test_impossible_sample_and_missing_store_are_bad_input(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="sample is 0; it must be 1 or more"):
        verified(folder, sample=0)
    with pytest.raises(InputError, match="there is no store in"):
        verified(tmp_path / "nowhere")
