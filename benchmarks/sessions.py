"""What whole sessions of nox took, as they last ran in this checkout: too long to run again."""

from collections.abc import Iterator
from pathlib import Path

from benchmarks.goals import measured
from benchmarks.results import Section

TOOK = Path(__file__).parent.parent / ".nox" / "took.tsv"
SESSIONS = Section(
    title="Whole sessions",
    text="Seconds by the clock, installing included, as each last ran to its end in this checkout: "
    "`reproduce` with no store and nothing compiled. Written by noxfile.py and `.ci/run`; of "
    "`nox -s bench` it is this run, without installing.",
    columns=("command", "s", "on"),
)


def last_runs(path: Path = TOOK) -> Iterator[tuple[str, ...]]:
    """Yield a row for each command that is noted; none where nothing is."""
    if not path.exists():
        return
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = {command: rest for command, *rest in (line.split("\t") for line in lines)}
    for command, (seconds, day) in rows.items():
        yield f"`{command}`", measured(float(seconds), ".0f"), day
