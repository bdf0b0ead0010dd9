"""Nothing that is read back can run code: no pickle and no eval, in the engine or the papers."""

import ast

from tests.test_architecture import SOURCES, imports, tree

UNSAFE = {"pickle", "cPickle", "_pickle", "marshal", "shelve", "dill", "cloudpickle", "joblib"}
CALLS = {"eval", "exec", "compile", "__import__"}


def test_no_module_imports_what_can_unpickle() -> None:
    assert [source for source in SOURCES if UNSAFE & set(imports(source))] == []


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
