"""What surrounds a call, put right before anything reads it."""

import os


def prepare() -> None:
    """Let drawings be files whatever window MPLBACKEND names, in this process and its children."""
    os.environ["MPLBACKEND"] = "agg"
