"""Nothing that is read back from a file can run code: no pickle and no eval."""

import ast
from pathlib import Path

import pytest

from repro.determinism.definitions import imported_modules
from tests.test_architecture import SOURCES, imports, tree

UNSAFE = {"pickle", "cPickle", "_pickle", "marshal", "shelve", "dill", "cloudpickle", "joblib"}
CALLS = {"eval", "exec", "compile", "__import__"}


READERS = (
    "repro.runs.store.store",
    "repro.runs.verify",
    "repro.report.results",
    "repro.runs.whole_files",
)


def closure(module: str) -> set[str]:
    found: set[str] = set()
    waiting = {module}
    while waiting:
        found |= waiting
        waiting = {name for one in waiting for name in imported_modules(one)} - found
    return found


@pytest.mark.parametrize("reader", READERS)
def test_what_reads_files_back_imports_nothing_that_can_unpickle(reader: str) -> None:
    modules = closure(reader)
    files = [
        source
        for source in SOURCES
        if source.with_suffix("").as_posix().replace("/", ".") in modules
    ]

    assert Path(f"{reader.replace('.', '/')}.py") in files
    assert [source for source in files if UNSAFE & set(imports(source))] == []


def test_pickles_are_for_workers_of_ones_own_alone() -> None:
    assert {source.stem for source in SOURCES if UNSAFE & set(imports(source))} <= {
        "pickling",  # tasks on their way to a worker
        "held_search",  # what no module has, in a call of the user's own
        "unwritten_values",  # digests of what no module has, in a call of the user's own
        "process",  # records on their way back through a pipe
    }


def test_no_array_is_loaded_with_pickles_allowed() -> None:
    names = [
        source
        for source in SOURCES
        for node in ast.walk(tree(source))
        if (isinstance(node, ast.keyword) and node.arg == "allow_pickle")
        or (isinstance(node, ast.Attribute) and node.attr in {"load", "fromfile", "loads_pickle"})
        # settings in TOML, an arm in XML, the module that an installed package's entry point names
        if ast.unparse(node) not in {"tomllib.load", "point.load", "URDF.load"}
    ]

    assert names == []


def test_nothing_is_evaluated() -> None:
    called = [
        (source, node.func.id)
        for source in SOURCES
        for node in ast.walk(tree(source))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    ]

    assert [place for place in called if place[1] in CALLS] == []
