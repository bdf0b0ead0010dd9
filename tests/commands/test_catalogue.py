"""A paper is found by key, file, folder and entry point; what fails is one line."""

import json
import sys
from argparse import Namespace
from collections.abc import Callable, Iterator
from importlib.metadata import EntryPoint
from pathlib import Path
from types import ModuleType

import pytest

from repro.__main__ import main
from repro.commands import catalogue
from repro.runs.plan import plan
from repro.runs.run import execute
from repro.runs.workers.process import WorkerProcess
from tests.fresh_modules import drop, forget
from tests.runs.test_run import same

Listed = Callable[..., tuple[int, list[str], str]]

MODULE = """
from dataclasses import replace
from tests.small_papers import PAPER as SMALL

PAPER = replace(SMALL, key="{key}")
"""

SEARCH = """
from dataclasses import replace
from aid import HALF
from tests.small_papers import EXPERIMENT, searching


def halving(cost, bounds, budget, rng):
    x = HALF * bounds[:, 0]
    for _ in range(budget):
        cost(x)
        x = x * rng.random()
    return x


PAPER = replace(searching(halving=halving), key="one")
"""
AID = """
import os

with open("processes", "a") as file:
    print(os.getpid(), file=file)
HALF = 0.5
"""


def write(path: str, text: str = "") -> Path:
    """Write a file and the folders above it; the text of a paper is that of its own name."""
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text or MODULE.format(key=file.stem), encoding="utf-8")
    return file


@pytest.fixture
def listed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Iterator[Listed]:
    """Yield what lists papers in an empty folder: exit code, keys of papers, lines of errors."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])

    def command(*arguments: str) -> tuple[int, list[str], str]:
        code = main(["list", "--json", *arguments])
        out, err = capsys.readouterr()
        return code, [paper["key"] for paper in json.loads(out or "[]")], err

    yield command
    drop(tmp_path)


def refusal(answer: tuple[int, list[str], str]) -> str:
    """Return the one line of a call that found no paper."""
    code, keys, err = answer
    assert (code, keys, err.count("\n"), err[:7]) == (2, [], 1, "repro: "), answer
    return err


@pytest.mark.parametrize(
    "path", ["one.py", "a folder/one.py", "größe/one.py", "-dash/one.py", "x.py/one.py"]
)
def test_a_file_is_a_paper_wherever_it_stands(listed: Listed, path: str) -> None:
    write(path)

    assert listed(f"./{path}") == (0, ["one"], "")
    assert (
        listed(f"{Path(path).resolve().parent}/../{Path(path).resolve().parent.name}/one.py")[0]
        == 0
    )


def test_every_module_of_a_folder_that_declares_a_paper_is_one(listed: Listed) -> None:
    write("folder/two.py")
    write("folder/one.py", "import aid\n" + MODULE.format(key="one"))
    write("folder/aid.py", "HALF = 0.5\n")

    assert listed("folder/") == (0, ["one", "two"], "")


def test_a_package_that_declares_a_paper_is_that_paper(listed: Listed) -> None:
    paper = MODULE.format(key="whole").replace("tests.small_papers", ".parts")
    write("whole/__init__.py", paper)
    write("whole/parts.py", "from tests.small_papers import PAPER\n")

    assert listed("./whole") == (0, ["whole"], "")
    assert sys.modules["whole.parts"].__name__ == "whole.parts"


def test_a_file_of_a_package_may_import_relatively(listed: Listed) -> None:
    write("pack/__init__.py", "#")
    write("pack/aid.py", "from tests.small_papers import PAPER as SMALL\n")
    write("pack/one.py", MODULE.format(key="one").replace("tests.small_papers", ".aid")
          .replace("PAPER as SMALL", "SMALL"))  # fmt: skip

    assert listed("./pack/one.py") == (0, ["one"], "")


def test_a_file_of_this_house_is_the_paper_of_that_key(listed: Listed) -> None:
    path = Path(catalogue.folders()[0]) / "syji.py"

    assert listed(str(path)) == listed("syji")


def test_an_entry_point_is_a_paper_or_a_module_that_has_one(
    listed: Listed, monkeypatch: pytest.MonkeyPatch
) -> None:
    write("installed.py")
    monkeypatch.syspath_prepend(".")
    for value in ("installed", "installed:PAPER"):
        points = [EntryPoint("installed", value, catalogue.GROUP)]
        monkeypatch.setattr("importlib.metadata.entry_points", lambda points=points, **_: points)

        assert listed("installed") == (0, ["installed"], "")


@pytest.mark.parametrize("value", ["nowhere_at_all", "json:dumps", "json:no_such"])
def test_an_entry_point_that_fails_is_a_line(
    listed: Listed, monkeypatch: pytest.MonkeyPatch, value: str
) -> None:
    points = [EntryPoint("lost", value, catalogue.GROUP)]
    monkeypatch.setattr("importlib.metadata.entry_points", lambda **_: points)

    assert f"entry point lost = {value}" in refusal(listed("lost"))
    code, keys, err = listed("syji")
    assert (code, keys) == (0, ["syji"]), err


def test_a_broken_module_stops_no_other(listed: Listed) -> None:
    write("folder/good.py")
    write("folder/bad.py", MODULE.format(key="bad") + "\n1 / 0\n")

    code, keys, err = listed("folder/")

    assert (code, keys, err.count("\n")) == (2, ["good"], 1)
    assert "bad.py, line 7: ZeroDivisionError: division by zero" in err


FAULTS = {
    "no paper": ("X = 1\n", "mine.py: it declares no PAPER"),
    "another type": ("PAPER = 5\n", "PAPER is int, not repro.model.Paper"),
    "syntax": ("PAPER = (\n", "mine.py, line 1: '(' was never closed"),
    "NUL": ("PAPER = 1\0\n", "mine.py"),
    "leaves": ("PAPER = 1\nraise SystemExit(0)\n", "mine.py, line 2: SystemExit: 0"),
    "import": ("import no_such_thing\nPAPER = 1\n", "mine.py, line 1: ModuleNotFoundError"),
    "several lines": (
        "PAPER = 1\nraise ValueError('a\\n\\x1b[31mb')\n",
        r"line 2: ValueError: a \x1b[31mb",
    ),
    "unusual": ("PAPER = 1\nraise KeyError('k')\n", "mine.py, line 2: KeyError: 'k'"),
    "empty": ("#\n", "mine.py: it declares no PAPER"),
    "endless": ("PAPER = 1\ndef f(): f()\nf()\n", "RecursionError"),
    "deep": ("PAPER = " + "-" * 100_000 + "1\n", "mine.py"),
}


@pytest.mark.parametrize("kind", FAULTS)
def test_a_module_that_is_no_paper_is_a_line(listed: Listed, kind: str) -> None:
    text, says = FAULTS[kind]
    write("mine.py", text)

    line = refusal(listed("./mine.py"))

    assert says in line
    assert line[:-1].isprintable()


def test_a_module_in_another_encoding_is_a_line(listed: Listed) -> None:
    Path("mine.py").write_bytes("PAPER = 'größe'\n".encode("latin-1"))

    assert "mine.py" in refusal(listed("./mine.py"))


def test_equal_keys_are_refused_with_both_places(listed: Listed) -> None:
    write("a/one.py")
    write("b/other.py", MODULE.format(key="one"))

    line = refusal(listed("a/one.py", "b/other.py"))

    assert all(str(Path(path).resolve()) in line for path in ("a/one.py", "b/other.py"))


def test_a_key_of_this_house_is_refused_to_others(listed: Listed) -> None:
    write("mine.py", MODULE.format(key="syji"))

    assert "two papers have the key 'syji'" in refusal(listed("./mine.py"))


def test_helpers_of_one_name_are_not_mistaken_for_each_other(listed: Listed) -> None:
    for folder, paper in (("a", "one"), ("b", "two")):
        write(f"{folder}/{paper}.py", "import aid\n" + MODULE.format(key=paper))
        write(f"{folder}/aid.py", f"WHERE = {folder!r}\n")

    code, keys, err = listed("a/one.py", "b/two.py")

    assert (code, keys, err.count("\n")) == (2, ["one"], 1)
    assert all(str(Path(folder, "aid.py").resolve()) in err for folder in "ab")


def test_what_a_module_prints_is_not_what_the_command_prints(listed: Listed) -> None:
    write("one.py", MODULE.format(key="one") + "print('hello')\n")

    assert listed("./one.py") == (0, ["one"], "hello\n")


@pytest.mark.parametrize(
    "path", ["./none.py", "none/", "a/b/c.py", "loop.py", "loop/", "empty/", "n" * 300 + ".py"]
)
def test_a_place_without_a_module_is_a_line(listed: Listed, path: str) -> None:
    Path("loop.py").symlink_to("loop.py")
    Path("loop").symlink_to("loop")
    Path("empty").mkdir()

    assert Path(path).name in refusal(listed(path))


def test_a_name_that_python_cannot_import_is_a_line(listed: Listed) -> None:
    write("a-b.py", MODULE.format(key="ab"))

    assert "a module must be named as Python names are" in refusal(listed("./a-b.py"))


def test_an_unknown_key_is_told_where_it_was_looked_for(listed: Listed) -> None:
    line = refusal(listed("syjii"))

    assert "did you mean syji?" in line
    assert catalogue.folders()[0] in line
    assert catalogue.GROUP in line


@pytest.mark.usefixtures("listed")
def test_a_paper_of_a_file_gives_the_same_bits_in_a_process() -> None:
    forget(Path.cwd())
    write("folder/one.py", SEARCH)
    write("folder/aid.py", AID)

    (paper,) = catalogue.chosen(Namespace(keys=["folder/one.py"]))
    tasks = plan([paper], 1, protocol_only=True)
    worker = WorkerProcess()
    try:
        apart = [worker.execute(task) for task in tasks]
    finally:
        worker.kill()

    assert all(map(same, apart, map(execute, tasks)))
    assert len(set(Path("processes").read_text().split())) == 2


def test_an_argument_that_a_search_lacks_is_told_with_those_it_has(listed: Listed) -> None:
    write("one.py", "from repro.optimisers import WOA\n\nPAPER = WOA(c=3)\n")

    said = refusal(listed("./one.py"))

    assert "one.py, line 3: WOA has no argument 'c'; there is 'b'" in said


def test_papers_of_somebody_else_that_are_loaded_are_named(
    monkeypatch: pytest.MonkeyPatch, listed: Listed
) -> None:
    theirs = ModuleType("papers")
    theirs.__file__ = "elsewhere/papers/__init__.py"
    monkeypatch.setitem(sys.modules, "papers", theirs)

    line = refusal(listed("syji"))

    assert "the name 'papers' belongs to elsewhere/papers/__init__.py: rename one of them" in line
    assert sys.modules["papers"] is theirs
