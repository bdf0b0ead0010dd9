"""Coverage-guided fuzzing with atheris: python -m tests.fuzzing table|store|page [-options]."""

import sys

import atheris

with atheris.instrument_imports(include=["repro.published", "repro.store", "repro.rows"]):
    from tests.hostile import TARGETS


def main() -> None:
    """Feed texts to one target until the time is over."""
    target = TARGETS[sys.argv.pop(1)]

    def once(data: bytes) -> None:
        target(atheris.FuzzedDataProvider(data).ConsumeUnicodeNoSurrogates(len(data)))

    atheris.Setup(sys.argv, once)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
