from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.commands.unchanged import Written
from repro.commands.written_pages import write_pages
from repro.runs.store.store import Store
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import ENVIRONMENT, RECORDS, TASKS, change, filled

Change = Callable[[Path], object]


@pytest.fixture
def written(tmp_path: Path) -> Written:
    declarations = tmp_path / "papers"
    declarations.mkdir()
    (declarations / "small2020.py").write_text("PAPER = 1\n", encoding="utf-8")
    pages = Written(
        tasks=TASKS,
        chosen=[PAPER.key],
        known=[PAPER.key],
        declarations=[str(declarations)],
        reports=tmp_path / "reports",
    )
    with Store(filled(tmp_path / "store")) as store:
        write_pages(store, [PAPER], TASKS, pages.reports, [PAPER.key])
        pages.remember(store)
    return pages


def stand(pages: Written) -> bool:
    with Store(pages.reports.parent / "store") as store:
        return pages.stand(store)


def again(record_of: int, folder: Path) -> None:
    with Store(folder / "store") as store:
        store.begin(ENVIRONMENT)
        store.add([replace(RECORDS[record_of], cost=RECORDS[record_of].cost + 1.0)])


def test_pages_stand_as_written_and_would_be_written_the_same(written: Written) -> None:
    def content() -> dict[Path, bytes]:
        return {path: path.read_bytes() for path in written.reports.rglob("*") if path.is_file()}

    before = content()
    assert stand(written)
    with Store(written.reports.parent / "store") as store:
        write_pages(store, [PAPER], TASKS, written.reports, [PAPER.key])
    assert content() == before
    assert stand(written)


@pytest.mark.parametrize(
    "changed",
    [
        lambda folder: (folder / "reports" / "small2020.md").write_text("other"),
        lambda folder: (folder / "reports" / "results.json").unlink(),
        lambda folder: (folder / "reports" / "more.txt").touch(),
        lambda folder: (folder / "papers" / "small2020.py").write_text("PAPER = 2\n"),
        lambda folder: (folder / "papers" / "more.py").touch(),
        lambda folder: (folder / "store" / "repro-pages").unlink(),
        lambda folder: (folder / "store" / "repro-pages").write_bytes(b"\xff"),
        lambda folder: again(0, folder),
        lambda folder: again(-1, folder),
        lambda folder: change(folder / "store", "delete from run where id = 1"),
    ],
    ids=[
        *("page edited", "page lost", "file added", "declaration edited", "declaration added"),
        *("never written", "digest damaged", "first run another", "last run another", "run lost"),
    ],
)
def test_any_change_has_pages_written_again(written: Written, changed: Change) -> None:
    changed(written.reports.parent)
    assert not stand(written)


def test_other_papers_tasks_or_folders_have_pages_written_again(written: Written) -> None:
    elsewhere = written.reports.with_name("elsewhere")
    written.reports.rename(elsewhere)
    assert not stand(replace(written, reports=elsewhere))
    elsewhere.rename(written.reports)
    assert not stand(replace(written, known=[PAPER.key, "other2021"]))
    assert not stand(replace(written, chosen=[]))
    assert not stand(replace(written, tasks=TASKS[1:]))
    assert stand(written)


def test_a_package_of_another_version_has_pages_written_again(
    written: Written, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.metadata.distributions", lambda: iter(()))
    assert not stand(written)


def test_pages_of_another_machine_are_written_again(
    written: Written, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("repro.commands.unchanged.provenance", lambda: {"processor": "other"})
    assert not stand(written)


def test_damaged_run_is_found_though_nothing_else_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    let_be_known(monkeypatch, PAPER)
    places = ["--store", str(tmp_path / "store"), "--reports", str(tmp_path / "reports")]
    command = ["reproduce", "--repeats", "1", "--protocol-only", *places]
    assert main(command) == 0

    change(tmp_path / "store", "update run set cost = cost + 1 where id = 1")

    assert main(command) == 0
    assert "is damaged; it is set aside" in capsys.readouterr().err


def test_reproduce_with_nothing_to_do_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    let_be_known(monkeypatch, PAPER)
    places = ["--store", str(tmp_path / "store"), "--reports", str(tmp_path / "reports")]
    command = ["reproduce", "--repeats", "1", *places]
    assert main(command) == 0

    def fail(*_: object) -> None:
        pytest.fail("pages were written again")

    monkeypatch.setattr("repro.commands.written_pages.write_report", fail)
    assert main(command) == 0
