"""The rules of the house, read from the source."""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
TESTS = ROOT / "tests"
ENGINE, PAPERS = (
    tuple(sorted(path.relative_to(ROOT) for path in (ROOT / folder).rglob("*.py")))
    for folder in ("repro", "papers")
)
SOURCES = (*ENGINE, *PAPERS)
COMMAND_LINE = Path("repro/__main__.py")

LINES_OF_A_FILE = 300
LINES_OF_A_FUNCTION = 40
PURE = ("published", "verdict", "claims", "relations", "audit", "statistics")
OUTSIDE = {
    *("os", "io", "pathlib", "shutil", "tempfile", "sqlite3", "subprocess", "socket"),
    *("time", "datetime", "random", "matplotlib"),
}
VAGUE = {"utils", "util", "core", "helpers", "helper", "misc", "common", "base", "tools", "lib"}
# A module has a test file of its name, or of its folder's name, or one of these.
COVERED_ELSEWHERE = {
    "repro/__main__.py": "test_command_line.py",
    "repro/errors.py": "test_command_line.py",
    "repro/determinism/compiled.py": "test_optimisers.py",
    "repro/model/figures.py": "test_drawing.py",
    "repro/report/drawings/convergence.py": "test_drawing.py",
    "repro/report/drawings/motion.py": "test_drawing.py",
    "repro/report/drawings/style.py": "test_drawing_parts.py",
    "repro/report/drawings/svg.py": "test_drawing.py",
    "repro/report/drawings/tool_path.py": "test_drawing.py",
}


@cache
def tree(source: Path) -> ast.Module:
    return ast.parse((ROOT / source).read_text(encoding="utf-8"))


def imports(source: Path) -> Iterator[str]:
    """Yield the packages that are imported, wherever in the file."""
    for node in ast.walk(tree(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        if isinstance(node, ast.ImportFrom):
            yield "." * node.level + (node.module or "").split(".")[0]


def pure(source: Path) -> bool:
    return any(source.is_relative_to(Path("repro") / name) for name in PURE) or (
        source in [Path("repro") / f"{name}.py" for name in PURE]
    )


def test_engine_and_papers_are_found() -> None:
    assert COMMAND_LINE in ENGINE
    assert Path("papers/liang2026.py") in PAPERS
    assert all(any(name in str(source) for source in ENGINE if pure(source)) for name in PURE)
    assert not pure(Path("repro/runs/store/store.py"))


def test_engine_knows_no_paper_but_for_the_command_line() -> None:
    assert [source for source in ENGINE if "papers" in imports(source)] == [COMMAND_LINE]


def test_imports_are_absolute_and_never_of_tests() -> None:
    for source in SOURCES:
        assert not [name for name in imports(source) if name.startswith(".") or name == "tests"]


def test_pure_modules_touch_neither_files_nor_clocks_nor_figures() -> None:
    for source in filter(pure, ENGINE):
        assert OUTSIDE.isdisjoint(imports(source)), source


def test_pure_modules_open_and_print_nothing() -> None:
    for source in filter(pure, ENGINE):
        names = {node.id for node in ast.walk(tree(source)) if isinstance(node, ast.Name)}
        assert names.isdisjoint({"open", "print", "input", "eval", "exec"}), source


def test_files_are_short() -> None:
    lines = {s: len((ROOT / s).read_text(encoding="utf-8").splitlines()) for s in SOURCES}

    assert {source: n for source, n in lines.items() if n > LINES_OF_A_FILE} == {}


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


def is_covered(source: Path) -> bool:
    names = [f"test_{source.stem}.py", f"test_{source.parent.name}.py"]
    named = COVERED_ELSEWHERE.get(source.as_posix(), names[0])
    return any((TESTS / name).exists() for name in (*names, named))


def test_every_module_of_the_engine_has_a_test_file() -> None:
    modules = [source for source in ENGINE if source.stem != "__init__"]

    assert [source for source in modules if not is_covered(source)] == []


@pytest.mark.parametrize("source", COVERED_ELSEWHERE)
def test_coverage_elsewhere_is_named_only_where_it_is_needed(source: str) -> None:
    assert Path(source) in ENGINE
    assert not (TESTS / f"test_{Path(source).stem}.py").exists()
