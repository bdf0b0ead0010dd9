"""The page of results: sections with a table each, filled as the benchmarks run."""

import os
import platform
import shutil
import subprocess
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from benchmarks.goals import Row, held_against
from repro.determinism.provenance import provenance

TRIED = Path(__file__).with_name("tried.md")
_OF_THE_DAY = ("date", "commit", "seed_rule")


@dataclass(frozen=True, slots=True, kw_only=True)
class Section:
    """A heading, what the numbers are, and the headings of their table."""

    title: str
    text: str
    columns: tuple[str, ...]


@dataclass(slots=True)
class Results:
    """What was measured, by section in the order of the first row of each."""

    rows: dict[Section, list[tuple[str, ...]]] = field(default_factory=dict)
    curves: dict[str, list[tuple[float, float]]] = field(default_factory=dict)

    def add(self, section: Section, *cells: str) -> None:
        """Add a row."""
        self.rows.setdefault(section, []).append(cells)

    def point(self, curve: str, evaluations: float, seconds: float) -> None:
        """Add a point to a curve of the chart."""
        self.curves.setdefault(curve, []).append((evaluations, seconds))

    def text(self) -> str:
        """Return the page."""
        return "\n".join(self._lines()) + "\n"

    def _lines(self) -> Iterator[str]:
        yield "# How fast it runs"
        yield ""
        yield "Written by `nox -s bench`; do not edit (what was tried is written in tried.md)."
        yield "Contenders take turns in one process or in processes that wait for each other, on"
        yield "the same cores; every number is a median of rounds. A ratio is the median over the"
        yield "rounds, not the ratio of the medians. What runs on one thread is measured in"
        yield "processor time; whole calls, storing and scaling by the clock on the wall."
        yield ""
        for name, value in machine().items():
            yield f"- {name}: {value}"
        for section, rows in self.rows.items():
            yield from ("", f"## {section.title}", "", section.text, "")
            yield _row(section.columns)
            yield _row("---" for _ in section.columns)
            yield from map(_row, rows)
        if self.curves:
            yield from ("", "## Cost against work", "", "![Seconds by evaluations](cost.svg)")
        yield from ("", "## What the goals came to", "")
        yield from map(_row, (("goal", "asked", "came to"), ("---",) * 3))
        yield from map(_row, held_against(self._by_heading()))
        yield from ("", TRIED.read_text(encoding="utf-8").rstrip())

    def _by_heading(self) -> dict[str, list[Row]]:
        return {
            section.title: [dict(zip(section.columns, row, strict=True)) for row in rows]
            for section, rows in self.rows.items()
        }


def machine() -> Mapping[str, str]:
    """Return what decides the speed: processor, libraries, compiler, how busy the machine was."""
    told = {name: str(value) for name, value in provenance().items() if name not in _OF_THE_DAY}
    packages = provenance()["packages"]
    if isinstance(packages, dict):
        told["packages"] = ", ".join(f"{name} {version}" for name, version in packages.items())
    told["compiler of the C loops"] = _compiler()
    told["kernel"] = platform.release()
    told["load when written"] = f"{os.getloadavg()[0]:.1f} runnable processes"
    return told


def _compiler() -> str:
    path = shutil.which("cc")
    if path is None:
        return "none"
    said = subprocess.run([path, "--version"], capture_output=True, text=True, check=True)
    return said.stdout.splitlines()[0]


def _row(cells: "tuple[str, ...] | Iterator[str]") -> str:
    return "| " + " | ".join(cells) + " |"
