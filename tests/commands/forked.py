"""Commands one after another, each in a child of one process that loaded all modules once."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
NO_LEAVE = "--bounding-set=-dac_override,-dac_read_search"
"""Without these capabilities root is bound by permissions, as every other user is."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Said:
    """What a command said, and its exit code."""

    code: int
    out: str
    err: str


def called(folder: Path, *calls: Sequence[str], spoil: str = "", bound: bool = False) -> list[Said]:
    """Return what each call says that knows the small paper alone.

    `spoil` is a kind of fault and the number of a stream, as "full 1"; `bound` lets no call do what
    permissions forbid.
    """
    prefix = bound_call() if bound else ()
    call = (*prefix, sys.executable, "-W", "ignore", "-m", "tests.commands.forked")
    done = subprocess.run(
        (*call, spoil, json.dumps(calls)),
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return [Said(**each) for each in json.loads(done.stdout)]


def bound_call() -> tuple[str, ...]:
    """Return what stands before a call so that permissions hold for it, whoever we are."""
    if os.geteuid() != 0:
        return ()
    setpriv = shutil.which("setpriv")
    if setpriv is None:
        pytest.skip("without setpriv root may do everything")
    return (setpriv, NO_LEAVE)


def _spoilt(kind: str, number: int) -> None:
    """Let a standard stream be one whose reader left, one without room, or closed."""
    if kind == "closed":  # as Python finds it then
        os.close(number)
        name = ("stdin", "stdout", "stderr")[number]
        setattr(sys, name, None)
        setattr(sys, f"__{name}__", None)
        return
    if kind == "left":
        reading, writing = os.pipe()
        os.close(reading)
    else:
        writing = os.open("/dev/full", os.O_WRONLY)
    os.dup2(writing, number)


def _forked(arguments: list[str], spoil: str) -> dict[str, object]:
    """Return code and output of one call, made in a child."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        child = os.fork()
        if child == 0:
            os.dup2(out.fileno(), 1)
            os.dup2(err.fileno(), 2)
            kind, _, numbers = spoil.partition(" ")
            for number in numbers.split():
                _spoilt(kind, int(number))
            _end(arguments)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        texts = []
        for file in (out, err):
            file.seek(0)
            texts.append(file.read().decode())
    return {"code": code, "out": texts[0], "err": texts[1]}


def _end(arguments: list[str]) -> None:
    """Call a command and end the process as Python does after it."""
    import traceback  # noqa: PLC0415 (for a fault alone)

    code = 99
    try:
        code = main(arguments)
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else 1
    except BaseException:  # noqa: BLE001 (it is told, and fails the test)
        if sys.stderr:
            traceback.print_exc()
    finally:
        for stream in filter(None, (sys.stdout, sys.stderr)):
            try:
                stream.flush()
            except (OSError, ValueError):
                code = 120  # what Python ends with then
        os._exit(code)


if __name__ == "__main__":
    import importlib

    from repro.__main__ import main
    from repro.commands.arguments import _TEXTS
    from repro.commands.surroundings import prepare
    from tests.small_papers import PAPER, let_be_known

    prepare()
    let_be_known(pytest.MonkeyPatch(), PAPER)
    for command in _TEXTS:
        importlib.import_module(f"repro.commands.{command}")
    told = [_forked(each, sys.argv[1]) for each in json.loads(sys.argv[2])]
    sys.stdout.write(json.dumps(told))
