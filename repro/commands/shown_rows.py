"""Rows on standard output: a line each, or JSON."""

import dataclasses
import json
import sys
from collections.abc import Sequence
from typing import Any

from repro.commands.streams import one_line


def show(rows: Sequence[Any], lines: Sequence[str], *, as_json: bool) -> int:
    """Print the lines, or the rows, which are dataclasses, as JSON; return exit code 0."""
    sys.stdout.write(text_of(rows, lines, as_json=as_json))
    return 0


def text_of(rows: Sequence[Any], lines: Sequence[str], *, as_json: bool) -> str:
    """Return the lines, or the rows, which are dataclasses, as JSON."""
    if as_json:
        return json_of([dataclasses.asdict(row) for row in rows])
    return "".join(f"{one_line(line)}\n" for line in lines)


def show_json(content: object) -> None:
    """Print JSON for programs."""
    sys.stdout.write(json_of(content))


def json_of(content: object) -> str:
    """Return JSON for programs, in letters that the standard output has."""
    encoding = str(getattr(sys.stdout, "encoding", None) or "utf-8")
    few = not encoding.lower().startswith("utf")  # letters that it lacks are spelt as JSON does
    return json.dumps(content, indent=2, ensure_ascii=few) + "\n"


def warn(line: str) -> None:
    """Say something to whoever called, apart from what was asked for."""
    sys.stderr.write(f"repro: {one_line(line)}\n")  # a text of a file is no line of its own
