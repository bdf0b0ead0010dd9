"""Coverage-guided fuzzing with atheris: python -m tests.fuzzing table|store|page [-options]."""

import sys
import tempfile
from pathlib import Path

import atheris

with atheris.instrument_imports(
    include=["repro.tables.published", "repro.runs.store.store", "repro.runs.store.row"]
):
    from tests.hostile import STRINGS, TARGETS


def main() -> None:
    """Feed texts to one target until the time is over."""
    target = TARGETS[sys.argv.pop(1)]

    def once(data: bytes) -> None:
        target(data.decode(errors="replace"))

    with tempfile.TemporaryDirectory() as seeds:
        for number, text in enumerate(STRINGS):
            (Path(seeds) / str(number)).write_bytes(text.encode())
        atheris.Setup([*sys.argv, seeds], once)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
