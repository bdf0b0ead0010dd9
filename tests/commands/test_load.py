import json
import shutil
import subprocess
import sys
import tracemalloc
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import repro
from repro.commands.written_pages import write_pages
from repro.determinism.seeds import generator
from repro.errors import InputError, StoreError
from repro.report.frames import FINDING, RUNS
from repro.runs.plan import plan
from repro.runs.run import Record
from repro.runs.store.store import Store
from tests.commands.forked import bound_call
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import ENVIRONMENT, RECORDS, change, filled, with_pages

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module", autouse=True)
def known() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, PAPER)
        yield


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a store and the reports of it."""
    return with_pages(tmp_path_factory.mktemp("loaded"))


def results_of(place: Path) -> dict[str, Any]:
    (entry,) = json.loads((place / "reports" / "results.json").read_text())["papers"]
    return dict(entry)


@pytest.mark.parametrize("kind", ["findings", "audit", "certificates", "tests", "standings"])
def test_frames_of_reports_are_the_rows_of_results_json(place: Path, kind: str) -> None:
    frame = getattr(repro.load(place / "reports"), kind)

    rows = results_of(place)[kind]
    shared = [name for name in frame if rows and name in rows[0] and name != "turns_on"]
    assert frame[shared].astype(object).where(frame[shared].notna(), None).to_dict("records") == [
        {name: row[name] for name in shared} for row in rows
    ]
    assert set(frame["paper"]) == ({PAPER.key} if rows else set())


def test_findings_are_the_rows_of_the_csv_files(place: Path) -> None:
    found = repro.load(place / "reports").findings

    path = place / "reports" / "tables" / "small2020-table-1.csv"
    exact = ("printed", "value", "measured_low")  # of which older pandas loses a last bit
    file = pd.read_csv(path, dtype=dict.fromkeys(exact, str))
    own = found[list(FINDING)].reset_index(drop=True)
    assert list(file) == list(FINDING)
    assert len(own) == 4
    for name in ("printed", "value", "measured_low", "verdict", "id"):
        assert file[name].astype(str).tolist() == own[name].astype(str).tolist()


@pytest.mark.parametrize("kind", ["findings", "audit", "certificates", "tests", "standings"])
def test_a_store_is_judged_as_its_pages_are(place: Path, kind: str) -> None:
    from_pages, from_store = (
        getattr(repro.load(place / name), kind) for name in ("reports", "store")
    )

    pd.testing.assert_frame_equal(from_pages, from_store, check_dtype=False)


def test_runs_of_reports_and_of_the_store_are_equal_but_for_the_seconds(place: Path) -> None:
    published, stored = (repro.load(place / n).runs(PAPER.key) for n in ("reports", "store"))

    assert list(published) == list(stored) == list(RUNS)
    assert len(stored) == len(RECORDS)
    assert published["seconds"].isna().all()
    assert stored["seconds"].tolist() == [record.seconds for record in RECORDS]
    pd.testing.assert_frame_equal(*(f.drop(columns="seconds") for f in (published, stored)))


def test_runs_are_the_stored_ones_with_the_seeds_that_made_them(place: Path) -> None:
    runs = repro.load(place / "store").runs(PAPER.key)

    for row, record in zip(runs.itertuples(), RECORDS, strict=True):
        task = record.task
        assert (row.paper, row.study, row.experiment) == ("small2020", "protocol", "search")
        assert (row.problem, row.algorithm) == (task.problem, task.algorithm)
        assert (row.repeat, row.run, row.cost) == (task.repeat, task.run, record.cost)
        assert np.random.default_rng(row.seed).random() == generator(task.name).random()


def test_curves_are_the_histories_of_a_cell_a_row_a_run(place: Path) -> None:
    curves = repro.load(place / "store").curves(PAPER.key, "search", "bowl", "guess")

    own = [record for record in RECORDS if record.task.algorithm == "guess"]
    assert curves.index.tolist() == [(1, 1), (1, 2), (1, 3)]
    assert curves.columns.tolist() == [1, 2, 3, 4, 5]
    assert np.array_equal(curves.to_numpy(), [record.history for record in own])


def test_curves_of_reports_are_refused_with_the_place_that_has_them(place: Path) -> None:
    with pytest.raises(InputError, match=r"only a store has them"):
        repro.load(place / "reports").curves(PAPER.key, "search", "bowl", "guess")


@pytest.mark.parametrize("name", ["reports", "store"])
def test_an_unknown_paper_is_refused_with_those_that_there_are(place: Path, name: str) -> None:
    with pytest.raises(InputError, match=r"no paper 'nobody2020' in .*; it has small2020"):
        repro.load(place / name).runs("nobody2020")


def test_an_unknown_cell_is_refused_by_its_name(place: Path) -> None:
    with pytest.raises(InputError, match="no runs of search/bowl/nothing of small2020"):
        repro.load(place / "store").curves(PAPER.key, "search", "bowl", "nothing")


def test_a_folder_that_is_neither_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"neither a folder of reports with results\.json nor"):
        repro.load(tmp_path)


def test_files_themselves_may_be_named(place: Path) -> None:
    for name in ("reports/results.json", "store/runs.sqlite"):
        assert repro.load(str(place / name)).papers == (PAPER.key,)


def test_runs_of_a_repeat_that_is_not_whole_are_published_too(tmp_path: Path) -> None:
    with Store(tmp_path / "store") as store:
        store.begin(ENVIRONMENT)
        store.add(RECORDS[:-1])
        write_pages(store, [PAPER], plan([PAPER], 1), tmp_path / "reports", [PAPER.key])

    assert len(repro.load(tmp_path / "reports").runs(PAPER.key)) == len(RECORDS) - 1
    assert len(repro.load(tmp_path / "store").runs(PAPER.key)) == len(RECORDS) - 1


def test_a_store_that_someone_writes_to_is_read(place: Path) -> None:
    alone = repro.load(place / "store").runs(PAPER.key)

    with Store(place / "store"):
        beside = repro.load(place / "store").runs(PAPER.key)

    pd.testing.assert_frame_equal(beside, alone)


def test_a_store_that_may_only_be_read_is_read(place: Path, tmp_path: Path) -> None:
    copy = tmp_path / "store"
    shutil.copytree(place / "store", copy)
    before = {path.name: path.stat().st_mtime_ns for path in copy.iterdir()}
    for path in (*copy.iterdir(), copy):
        path.chmod(0o555 if path.is_dir() else 0o444)
    told = (
        "import pytest, repro; from tests.small_papers import PAPER, let_be_known; "
        "let_be_known(pytest.MonkeyPatch(), PAPER); "
        f"print(*repro.load({str(copy)!r}).runs(PAPER.key)['cost'].map(repr))"
    )

    done = subprocess.run(
        (*bound_call(), sys.executable, "-c", told),
        cwd=ROOT, check=False, capture_output=True, text=True,
    )  # fmt: skip
    copy.chmod(0o755)

    costs = repro.load(place / "store").runs(PAPER.key)["cost"]
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == [*costs.map(repr)]
    assert before == {path.name: path.stat().st_mtime_ns for path in copy.iterdir()}


def test_failed_runs_have_no_row(tmp_path: Path) -> None:
    failed = replace(RECORDS[0], reason="lost the way")
    with Store(tmp_path / "store") as store:
        store.begin(ENVIRONMENT)
        store.add([failed, *RECORDS[1:]])
        write_pages(store, [PAPER], plan([PAPER], 1), tmp_path / "reports", [PAPER.key])

    for name in ("reports", "store"):
        runs = repro.load(tmp_path / name).runs(PAPER.key)
        assert (1, "guess") not in set(zip(runs["run"], runs["algorithm"], strict=True))
        assert len(runs) == len(RECORDS) - 1


def test_runs_of_an_earlier_key_are_not_mixed_in(tmp_path: Path) -> None:
    earlier = replace(RECORDS[0], task=replace(RECORDS[0].task, key="0" * 64), cost=9.0)
    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        store.add([*RECORDS, earlier])

    runs = repro.load(tmp_path).runs(PAPER.key)

    assert runs["cost"].tolist() == [record.cost for record in RECORDS]


def test_a_damaged_row_is_an_error_and_no_number(tmp_path: Path) -> None:
    change(filled(tmp_path), "update run set cost = cost + 1 where id = 2")

    with pytest.raises(StoreError, match=r"the row of .* is damaged"):
        repro.load(tmp_path).runs(PAPER.key)


def test_reports_of_another_schema_are_told_from_none(tmp_path: Path) -> None:
    (tmp_path / "results.json").write_text('{"schema": 1, "papers": []}')

    with pytest.raises(InputError, match=r"results\.json is of schema 1, and this version"):
        repro.load(tmp_path)


def test_reports_of_another_master_seed_give_its_seeds(place: Path, tmp_path: Path) -> None:
    results = json.loads((place / "reports" / "results.json").read_text())
    results["papers"][0]["provenance"]["master_seed"] = "another"
    (tmp_path / "runs").mkdir()
    (tmp_path / "results.json").write_text(json.dumps(results))
    packed = (place / "reports" / "runs" / "small2020.csv.gz").read_bytes()
    (tmp_path / "runs" / "small2020.csv.gz").write_bytes(packed)

    (seed, *_) = repro.load(tmp_path).runs(PAPER.key)["seed"]

    expected = generator("another", "small2020/search/bowl/guess/1/1").random()
    assert np.random.default_rng(seed).random() == expected


def test_reading_a_store_holds_no_more_than_a_cell_beside_the_frame(tmp_path: Path) -> None:
    paper = replace(PAPER, experiments=(replace(PAPER.experiments[0], runs=40),))
    curve = np.linspace(1.0, 0.0, 20_000)  # 160 kB a run, 13 MB in all
    tasks = plan([paper], 1)
    with Store(tmp_path) as store:
        store.begin(ENVIRONMENT)
        for task in tasks:
            store.add([Record(task=task, cost=0.5, x=np.zeros(2), history=curve,
                              evaluations=20, seconds=0.1)])  # fmt: skip
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, paper)
        results = repro.load(tmp_path)
        results.runs(paper.key)
        tracemalloc.start()
        results.runs(paper.key)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()

    assert peak < 3_000_000


@pytest.mark.parametrize(
    "statement",
    [
        "import repro",
        "from repro.__main__ import main; main(['list', 'syji'])",
        "from repro.__main__ import main; main(['audit', 'syji'])",
    ],
)
def test_pandas_and_matplotlib_load_only_where_they_are_asked_for(
    statement: str, tmp_path: Path
) -> None:
    asked = f"import sys; {statement}; print({{'pandas', 'matplotlib'}} & set(sys.modules))"

    done = subprocess.run(
        [sys.executable, "-c", asked],
        capture_output=True, text=True, check=True, cwd=tmp_path, env={"PYTHONPATH": str(ROOT)},
    )  # fmt: skip

    assert done.stdout.splitlines()[-1] == "set()"


def test_runs_of_earlier_code_are_told_from_none(tmp_path: Path) -> None:
    filled(tmp_path)
    change(tmp_path, "update run set key = 'earlier ' || key")

    results = repro.load(tmp_path)

    with pytest.raises(
        InputError,
        match=rf"no run of small2020 as it stands, and {len(RECORDS)} of other papers, of compared"
        r" searches or of earlier code: `repro reproduce small2020 --store .*` makes them",
    ):
        results.runs(PAPER.key)
