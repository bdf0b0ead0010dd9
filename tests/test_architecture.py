"""The rules of the house, read from the source."""

import ast
import re
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parent.parent
TESTS = ROOT / "tests"
ENGINE, PAPERS = (
    tuple(sorted(path.relative_to(ROOT) for path in (ROOT / folder).rglob("*.py")))
    for folder in ("repro", "papers")
)
SOURCES = (*ENGINE, *PAPERS)
CATALOGUE = Path("repro/commands/catalogue.py")

ROOMS = (
    *("errors", "tables", "determinism", "statistics", "functions", "robotics", "optimisers"),
    *("model", "audit", "runs", "judge", "report", "commands", "__main__"),
)
"""From the lowest to the highest: a room imports only rooms before it."""
LINES_OF_A_FILE = 300
LINES_OF_A_PAPER = 500
LINES_OF_A_FUNCTION = 40
PURE = ("tables", "statistics", "model", "audit", "judge")
READS_PROSE = Path("repro/model/prose.py")  # the one file of a pure room that opens another
OUTSIDE = {
    *("os", "io", "pathlib", "shutil", "tempfile", "sqlite3", "subprocess", "socket"),
    *("time", "datetime", "random", "matplotlib"),
}
VAGUE = {"utils", "util", "core", "helpers", "helper", "misc", "common", "base", "tools", "lib"}


@cache
def tree(source: Path) -> ast.Module:
    return ast.parse((ROOT / source).read_text(encoding="utf-8"))


def imported(source: Path) -> Iterator[str]:
    """Yield every module that a file names, wherever, for types alone too, as importlib does too.

    A name that is imported from a package may be a module of it.
    """
    for node in ast.walk(tree(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        if isinstance(node, ast.ImportFrom):
            module = "." * node.level + (node.module or "")
            yield module
            yield from (f"{module}.{alias.name}" for alias in node.names)
        text = node.value if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and re.fullmatch(r"(repro|papers)(\.\w+)+", text):
            yield text


def imports(source: Path) -> Iterator[str]:
    """Yield the packages that are imported, wherever in the file."""
    yield from (name if name.startswith(".") else name.split(".")[0] for name in imported(source))


def dotted(source: Path) -> str:
    parts = source.with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {dotted(source): source for source in ENGINE}


@cache
def below() -> dict[str, set[str]]:
    """Return what each module imports of the engine; every worker would wait for a constant."""
    return {
        name: {module for module in imported(source) if module in MODULES} - {name, "repro"}
        for name, source in MODULES.items()
    }


def room(module: str) -> str:
    return module.split(".")[1]


def pure(source: Path) -> bool:
    return any(source.is_relative_to(Path("repro") / name) for name in PURE)


def test_engine_and_papers_are_found() -> None:
    assert CATALOGUE in ENGINE
    assert Path("papers/liang2026.py") in PAPERS
    assert {source.parts[1].removesuffix(".py") for source in ENGINE} == {*ROOMS, "__init__"}
    assert not pure(Path("repro/runs/store/store.py"))


def test_a_room_imports_only_rooms_below_it() -> None:
    upward = [
        (module, other)
        for module, names in below().items()
        if module != "repro"
        for other in names
        if ROOMS.index(room(other)) > ROOMS.index(room(module))
    ]

    assert upward == []


def test_pages_are_made_of_judgements_and_not_of_the_store() -> None:
    store = ("repro.runs.store", "repro.runs.session", "repro.runs.gather")

    readers = [name for name, found in below().items() if any(b.startswith(store) for b in found)]

    assert [name for name in readers if room(name) not in {"runs", "commands"}] == []


def test_no_module_is_part_of_a_circle() -> None:
    waiting = dict(below())
    while free := [name for name, below in waiting.items() if not below & waiting.keys()]:
        for name in free:
            del waiting[name]

    assert waiting == {}


def test_modules_of_the_engine_are_imported_at_the_head_of_a_file() -> None:
    late = [
        source
        for source in ENGINE
        if source != Path("repro/__init__.py")
        for function in ast.walk(tree(source))
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef)
        for node in ast.walk(function)
        if (isinstance(node, ast.ImportFrom) and (node.module or "").startswith("repro"))
        or (isinstance(node, ast.Import) and any(a.name.startswith("repro") for a in node.names))
    ]

    assert late == []


def test_command_line_alone_imports_by_name_and_commands_alone() -> None:
    by_name = [
        (source, ast.unparse(node.args[0]))
        for source in ENGINE
        for node in ast.walk(tree(source))
        if isinstance(node, ast.Call) and ast.unparse(node.func).endswith("import_module")
    ]

    assert sorted(by_name) == [
        (Path("repro/__init__.py"), "_LATE[name]"),  # what is loaded when it is asked for
        (Path("repro/__main__.py"), "f'repro.commands.{options.command}'"),
        (Path("repro/commands/paper_modules.py"), "name"),  # the user's paper
        (Path("repro/functions/__init__.py"), "f'{__name__}.{info.name}'"),  # files of its folder
        (Path("repro/optimisers/users_search.py"), "module"),  # the user's
        (Path("repro/runs/workers/pickling.py"), "module"),  # whatever a task was made of
    ]


def test_no_two_classes_have_one_name() -> None:
    names = Counter(
        node.name
        for source in ENGINE
        for node in tree(source).body
        if isinstance(node, ast.ClassDef)
    )

    assert [name for name, times in names.items() if times > 1] == []


def test_engine_knows_no_paper_but_for_the_catalogue() -> None:
    loading = [source for source in ENGINE if "own_papers.loaded" in (ROOT / source).read_text()]

    assert [source for source in ENGINE if "papers" in imports(source)] == []
    assert loading == [CATALOGUE]


def test_ground_floor_needs_nothing_but_the_standard_library() -> None:
    for source in ENGINE:
        if source.is_relative_to("repro/tables"):
            assert set(imports(source)) - {"repro"} <= sys.stdlib_module_names, source


def test_a_paper_is_one_module_with_its_prose_and_its_expected_verdicts() -> None:
    modules = [source for source in PAPERS if source.stem != "__init__"]

    assert all(source.parent == Path("papers") for source in PAPERS)
    for source in modules:
        assert (ROOT / source).with_suffix(".toml").exists(), source
        assert (ROOT / source).with_suffix(".verdicts.csv").exists(), source


def test_imports_are_absolute_and_never_of_tests() -> None:
    for source in SOURCES:
        assert not [name for name in imports(source) if name.startswith(".") or name == "tests"]


def test_pure_modules_touch_neither_files_nor_clocks_nor_figures() -> None:
    for source in filter(pure, ENGINE):
        allowed = {"pathlib"} if source == READS_PROSE else set()
        assert OUTSIDE.isdisjoint(set(imports(source)) - allowed), source


def test_pure_modules_open_and_print_nothing() -> None:
    for source in filter(pure, ENGINE):
        calls = [node.func for node in ast.walk(tree(source)) if isinstance(node, ast.Call)]
        names = {called.id for called in calls if isinstance(called, ast.Name)}
        assert names.isdisjoint({"open", "print", "input", "eval", "exec"}), source


def test_files_are_short() -> None:
    lines = {s: len((ROOT / s).read_text(encoding="utf-8").splitlines()) for s in SOURCES}

    most = {source: LINES_OF_A_PAPER if source in PAPERS else LINES_OF_A_FILE for source in lines}
    assert {source: n for source, n in lines.items() if n > most[source]} == {}


def test_functions_are_short() -> None:
    long = [
        f"{source}: {node.name}"
        for source in SOURCES
        for node in ast.walk(tree(source))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        and (node.end_lineno or 0) - node.lineno >= LINES_OF_A_FUNCTION
    ]

    assert long == []


def test_rooms_are_named_by_what_is_in_them() -> None:
    parts = {part.removesuffix(".py") for source in SOURCES for part in source.parts}

    assert VAGUE.isdisjoint(parts)


def test_input_is_never_checked_by_assert() -> None:
    assert not [s for s in SOURCES if any(isinstance(n, ast.Assert) for n in ast.walk(tree(s)))]


def test_functions_change_no_state_of_their_module() -> None:
    assert not [s for s in SOURCES if any(isinstance(n, ast.Global) for n in ast.walk(tree(s)))]


def test_every_module_says_what_it_is() -> None:
    assert [source for source in SOURCES if not ast.get_docstring(tree(source))] == []


def test_tests_mirror_the_rooms() -> None:
    tested = {path.relative_to(TESTS).parts[0] for path in TESTS.rglob("test_*.py")}

    assert {name for name in ROOMS if (ROOT / "repro" / name).is_dir()} <= tested
    for path in TESTS.rglob("test_*.py"):
        folder = path.parent.relative_to(TESTS)
        beside = {"browser", "papers", "benchmarks", "docs"}
        assert (ROOT / "repro" / folder).is_dir() or folder.parts[0] in beside, path
