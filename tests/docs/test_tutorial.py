import re
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.fresh_modules import forget

PAGE = Path(__file__).parents[2] / "docs" / "tutorial.md"
BLOCK = re.compile(
    r"^```(?:\{code-block\} \w+\n:caption: (?P<file>\S+)|console)\n(?P<body>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)
LEFT_OUT = "…"


def steps() -> Iterator[tuple[str, str]]:
    """Yield the files of the page by name, and "" with each command and what it prints."""
    for block in BLOCK.finditer(PAGE.read_text(encoding="utf-8")):
        yield block["file"] or "", block["body"]


def printed_as(promised: str) -> re.Pattern[str]:
    """Return what matches the promised text, whatever is left out of it, spaces aside."""
    parts = [re.escape(" ".join(part.split())) for part in promised.split(LEFT_OUT)]
    return re.compile(r"\s*.*\s*".join(parts), re.DOTALL)


def test_every_command_prints_what_the_page_says_of_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    commands = 0
    for file, body in steps():
        if file:
            (tmp_path / file).write_text(body, encoding="utf-8")
            continue
        command, _, promised = body.removeprefix("$ repro ").partition("\n")
        forget(tmp_path)
        main(shlex.split(command))
        shown = " ".join(capsys.readouterr().out.split())
        assert printed_as(promised).fullmatch(shown), f"{command}\n{shown}"
        commands += 1
    assert commands >= 8


def test_what_the_page_says_is_told_from_other_words() -> None:
    assert printed_as("a … c\n").fullmatch("a b c")
    assert not printed_as("a … c\n").fullmatch("a b d")
    assert not printed_as("a c\n").fullmatch("a b c")
