"""Rows on standard output: a line each, or JSON."""

import dataclasses
import json
import sys
from collections.abc import Sequence
from typing import Any

from repro.commands.streams import one_line


def show(rows: Sequence[Any], lines: Sequence[str], *, as_json: bool) -> int:
    """Print the lines, or the rows, which are dataclasses, as JSON; return exit code 0."""
    if as_json:
        show_json([dataclasses.asdict(row) for row in rows])
    else:
        sys.stdout.writelines(f"{one_line(line)}\n" for line in lines)
    return 0


def show_json(content: object) -> None:
    """Print JSON for programs."""
    encoding = str(getattr(sys.stdout, "encoding", None) or "utf-8")
    few = not encoding.lower().startswith("utf")  # letters that it lacks are spelt as JSON does
    sys.stdout.write(json.dumps(content, indent=2, ensure_ascii=few) + "\n")


def warn(line: str) -> None:
    """Say something to whoever called, apart from what was asked for."""
    sys.stderr.write(f"repro: {one_line(line)}\n")  # a text of a file is no line of its own
