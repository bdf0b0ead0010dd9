"""What surrounds a call, put right before anything reads it."""

import os
import re


def prepare() -> None:
    """Let variables break no library, in this process and its children.

    Drawings are files whatever window MPLBACKEND names, and numba takes no fewer threads than 1.
    """
    os.environ["MPLBACKEND"] = "agg"
    if not re.fullmatch(r"0*[1-9][0-9]*", os.environ.get("NUMBA_NUM_THREADS", "1")):
        del os.environ["NUMBA_NUM_THREADS"]
    if not re.fullmatch(r"[0-9]+", os.environ.get("SOURCE_DATE_EPOCH", "1")):
        del os.environ["SOURCE_DATE_EPOCH"]  # numpy reads it for a number
