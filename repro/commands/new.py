"""`repro new`: a module and its prose that run as they stand, to be filled in."""

import keyword
import sys
from argparse import Namespace
from importlib.resources import files
from pathlib import Path

from repro.commands import catalogue
from repro.errors import InputError

_STARTED = files("repro.commands") / "started"
_SUFFIXES = ("py", "toml")


def run(options: Namespace) -> int:
    """Write KEY.py and KEY.toml into this folder; InputError for a bad name and for what exists."""
    key = options.key
    if not key.isidentifier() or keyword.iskeyword(key):
        message = f"the key {key!r} cannot name a module: give letters, digits and _, as in doe2024"
        raise InputError(message)
    if taken := catalogue.taken(key):
        message = f"the key {key!r} is taken by {taken}: choose another"
        raise InputError(message)
    paths = [Path(f"{key}.{suffix}") for suffix in _SUFFIXES]
    for path in paths:
        if path.exists() or path.is_symlink():
            message = f"{path} is there already: choose another key, or move it away"
            raise InputError(message)
    for path in paths:
        text = (_STARTED / f"KEY{path.suffix}.txt").read_text(encoding="utf-8")
        try:
            with path.open("x", encoding="utf-8") as file:
                file.write(text.replace("KEY", key))
        except OSError as error:
            message = f"{path} cannot be written: {error.strerror}"
            raise InputError(message) from None
    sys.stdout.write(f"{paths[0]} and {paths[1]}: now `repro reproduce ./{paths[0]} --repeats 2`\n")
    return 0
