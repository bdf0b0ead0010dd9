"""Streams that break, know few letters or show a terminal: the work ends as ever."""

import io
import json
import os
import subprocess
import sys
import unicodedata
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.__main__ import main
from repro.commands.shown_rows import warn
from repro.commands.streams import FitForTerminal, Unread, for_terminal
from tests.commands.test_surroundings import called
from tests.hostile import STRINGS, hostile_paper
from tests.small_papers import let_be_known


def test_what_nobody_reads_is_written_to_nowhere() -> None:
    reading, writing = os.pipe()
    os.close(reading)

    with Unread(writing, "w") as stream:
        assert stream.write(b"first") == 5
        assert stream.write(b"second") == 6


def test_what_finds_no_room_is_written_to_nowhere() -> None:
    with Unread("/dev/full", "w") as stream:
        assert stream.write(b"first") == 5
        assert stream.write(b"second") == 6


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """Return a table that is impossible, so that its audit ends with 1."""
    path = tmp_path / "table.csv"
    path.write_text("F,Best,Mean,Worst\nF1,2.0,1.0,3.0\n", encoding="utf-8")
    return path


def left(number: int) -> Callable[[], None]:
    """Return what makes a standard stream one whose reader left, in a new process."""

    def leave() -> None:
        reading, writing = os.pipe()
        os.close(reading)
        os.dup2(writing, number)

    return leave


def full(number: int) -> Callable[[], None]:
    """Return what lets a standard stream find no room."""

    def fill() -> None:
        os.dup2(os.open("/dev/full", os.O_WRONLY), number)

    return fill


def closed(number: int) -> Callable[[], None]:
    """Return what closes a standard stream."""
    return lambda: os.close(number)


@pytest.mark.parametrize("spoil", [left, full, closed])
def test_a_broken_output_ends_with_the_code_of_the_work(
    table: Path, spoil: Callable[[int], Callable[[], None]]
) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "repro", "audit", str(table)],
        stderr=subprocess.PIPE,
        check=False,
        preexec_fn=spoil(1),
    )

    assert (done.returncode, done.stderr) == (1, b"")


@pytest.mark.parametrize("spoil", [left, full, closed])
def test_progress_that_cannot_be_shown_stops_no_run_and_no_page(
    tmp_path: Path, spoil: Callable[[int], Callable[[], None]]
) -> None:
    done = called("reproduce", "--repeats", "1", "--protocol-only", cwd=tmp_path, before=spoil(2))

    assert done.returncode == 0
    assert "pages: reports/index.html" in done.stdout
    assert (tmp_path / "reports" / "index.html").exists()


def test_both_streams_closed_write_into_no_file(tmp_path: Path) -> None:
    def both() -> None:
        os.close(1)
        os.close(2)

    done = called("reproduce", "--repeats", "1", "--protocol-only", cwd=tmp_path, before=both)

    assert done.returncode == 0
    assert (tmp_path / ".repro" / "repro.lock").read_bytes() == b""
    assert (tmp_path / ".repro" / "runs.sqlite").read_bytes().startswith(b"SQLite format 3")


def test_letters_that_the_output_lacks_are_replaced_and_json_stays_json(tmp_path: Path) -> None:
    table = tmp_path / "t.csv"
    table.write_text("F é鲸🐋,Best,Mean,Worst\nF1é鲸🐋,2.0,1.0,3.0\n", encoding="utf-8")
    call = [sys.executable, "-m", "repro", "audit", str(table)]
    for encoding in ("ascii", "latin-1", "cp437"):
        environment = {**os.environ, "PYTHONIOENCODING": encoding}
        texts = [
            subprocess.run([*call, *more], env=environment, capture_output=True, check=False)
            for more in ([], ["--json"])
        ]

        assert [done.returncode for done in texts] == [1, 1]
        assert [done.stderr for done in texts] == [b"", b""]
        assert json.loads(texts[1].stdout.decode(encoding))


@given(text=st.text() | st.sampled_from(STRINGS))
def test_no_text_moves_the_cursor_or_turns_a_line(text: str) -> None:
    found = for_terminal(text)

    unseen = {"Cc", "Cf", "Cs", "Zl", "Zp"}
    assert not [c for c in found if unicodedata.category(c) in unseen and c not in "\n\t"]
    assert for_terminal(found) == found
    assert found.encode().decode() == found


@given(value=st.dictionaries(st.text(), st.text() | st.sampled_from(STRINGS)))
def test_json_that_is_fit_for_a_terminal_says_the_same(value: dict[str, str]) -> None:
    assert json.loads(for_terminal(json.dumps(value, ensure_ascii=False))) == value


@pytest.mark.parametrize("error", [BrokenPipeError(), OSError(28, "full"), ValueError("closed")])
def test_a_stream_that_fails_says_nothing(error: Exception) -> None:
    class Broken(io.StringIO):
        def write(self, _: str) -> int:
            raise error

        def flush(self) -> None:
            raise error

    stream = FitForTerminal(Broken())

    assert stream.write("text") == 4
    stream.flush()


def test_a_warning_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    warn("a\nrepro: done")

    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("text", STRINGS)
def test_no_text_of_a_paper_reaches_the_terminal_as_it_is(
    text: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    let_be_known(monkeypatch, replace(hostile_paper(text), key="hostile2020"))

    for command in ("list", "audit", "certify"):
        main([command, "hostile2020"])

    said = capsys.readouterr()
    assert for_terminal(said.out + said.err) == said.out + said.err


@pytest.mark.parametrize("command", ["list", "audit", "certify"])
def test_a_text_of_a_paper_is_no_line_of_its_own(
    command: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
) -> None:
    monkeypatch.chdir(tmp_path)
    lines = {}
    for text in ("x", "x\nrepro: all is well\r\n"):
        let_be_known(monkeypatch, replace(hostile_paper(text), key="hostile2020"))
        main([command, "hostile2020"])
        lines[text] = capsys.readouterr().out.count("\n")

    assert len({*lines.values()}) == 1, lines


def test_a_file_that_cannot_be_used_is_one_line_whatever_it_is_called(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def gone(_: object) -> int:
        raise FileNotFoundError(2, "No such file", "a\nrepro: done\x1b[2J")

    monkeypatch.setattr("repro.__main__._called", gone)

    assert main(["list"]) == 2
    assert capsys.readouterr().err == r"repro: a\nrepro: done\u001b[2J: No such file" + "\n"


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("-x.csv", "'-x.csv' reads like an option; a file of this name is ./-x.csv"),
        (f"{'a' * 300}.csv", "cannot be read: "),
        ("b" * 300, "unknown paper"),
    ],
)
def test_a_strange_name_is_one_line(
    name: str, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code = main(["audit", name])

    error = capsys.readouterr().err
    assert code == 2
    assert says in error
    assert error.count("\n") == 1
