import os
import subprocess
import sys
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.commands.streams import Unread


def test_what_nobody_reads_is_written_to_nowhere() -> None:
    reading, writing = os.pipe()
    os.close(reading)

    with Unread(writing, "w") as stream:
        assert stream.write(b"first") == 5
        assert stream.write(b"second") == 6


def test_a_command_whose_reader_left_ends_with_the_code_of_its_work(tmp_path: Path) -> None:
    table = tmp_path / "table.csv"
    table.write_text("F,Best,Mean,Worst\nF1,2.0,1.0,3.0\n", encoding="utf-8")
    reading, writing = os.pipe()
    os.close(reading)

    ended = subprocess.run(
        [sys.executable, "-m", "repro", "audit", str(table)],
        stdout=writing,
        stderr=subprocess.PIPE,
        check=False,
    )
    os.close(writing)

    assert (ended.returncode, ended.stderr) == (1, b"")


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
