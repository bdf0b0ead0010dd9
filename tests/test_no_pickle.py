"""Nothing that is read back can run code: no eval, and pickle only between own processes."""

import ast

from tests.test_architecture import SOURCES, imports, tree

UNSAFE = {"pickle", "cPickle", "_pickle", "marshal", "shelve", "dill", "cloudpickle", "joblib"}
TO_WORKERS = {"packing.py", "processes.py"}  # tasks and records on their way, never on disk
CALLS = {"eval", "exec", "compile", "__import__"}


def test_only_what_talks_to_workers_can_unpickle() -> None:
    assert {source.name for source in SOURCES if UNSAFE & set(imports(source))} == TO_WORKERS


def test_what_reads_the_store_knows_nothing_of_workers() -> None:
    readers = {"store.py", "rows.py", "salvage.py", "schema.py", "results.py"}
    packers = {f"repro.{name.removesuffix('.py')}" for name in TO_WORKERS}

    found = {source.name: set(imports(source)) for source in SOURCES if source.name in readers}

    assert found.keys() == readers
    assert all(packers.isdisjoint(names) for names in found.values())


def test_no_array_is_loaded_with_pickles_allowed() -> None:
    names = [
        source
        for source in SOURCES
        for node in ast.walk(tree(source))
        if (isinstance(node, ast.keyword) and node.arg == "allow_pickle")
        or (isinstance(node, ast.Attribute) and node.attr in {"load", "fromfile", "loads_pickle"})
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
