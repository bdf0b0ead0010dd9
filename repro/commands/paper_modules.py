"""Modules that declare a paper, found in files and folders and imported as Python would."""

import ast
import contextlib
import importlib
import re
import sys
import traceback
from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from types import ModuleType

from repro.errors import InputError
from repro.model.faults import protocol_faults
from repro.model.known_words import known_words
from repro.model.paper import Paper

PAPER = "PAPER"
LARGEST = 20_000_000  # bytes of a module
_UNKNOWN_ARGUMENT = re.compile(
    r"(?P<kind>\S+?)\.__init__\(\) got an unexpected keyword argument '(?P<word>\w+)'"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Declared:
    """A paper and the file that declares it; one that is `installed` is an entry point's."""

    paper: Paper
    place: Path
    installed: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Failed:
    """A file that declares no paper that can be used, and why, a line for each fault."""

    place: Path
    says: str


def modules_in(path: Path) -> list[Path]:
    """Return the files that are to be read as papers, of a file or a folder, in order.

    A folder whose `__init__.py` declares a paper is that paper. Of any other folder those files and
    packages are papers that declare one, and those that no paper of the folder imports and that
    declare none either: they are named as what they lack. Raises InputError for a place that cannot
    be read and for a folder without a module.
    """
    try:
        if path.is_dir():
            return _in_folder(path.resolve())
        if path.is_file():
            return [path.resolve()]
    except (OSError, RuntimeError) as error:
        message = f"{path} cannot be read: {error}"
        raise InputError(message) from None
    message = f"{path}: there is no such file or folder"
    raise InputError(message)


def declared_in(path: Path) -> Declared:
    """Return the paper that a file declares; InputError says in a line why it declares none.

    The folder of the file, or of the outermost package that it is in, takes the first place among
    those that modules are imported from, here and in every process that makes runs.
    """
    tree = _tree(path)
    if not _declares(tree):
        message = f"{path}: it declares no {PAPER}"
        raise InputError(message)
    name, root = _named(path)
    _refuse_other_modules_of_a_name(name, root, tree, path)
    module = _imported(name, root, path)
    paper = getattr(module, PAPER, None)
    if not isinstance(paper, Paper):
        message = f"{path}: {PAPER} is {type(paper).__name__}, not repro.model.Paper"
        raise InputError(message)
    faults = [fault for each in paper.experiments for fault in protocol_faults(each)]
    if faults:
        says = (f"{path}: {' '.join(fault.split())}" for fault in faults)
        raise InputError("\n".join(says))
    return Declared(paper=paper, place=path)


def failure(error: BaseException, path: Path) -> str:
    """Return what importing a module raised, with the user's last line before it, as lines."""
    place = str(path)
    if isinstance(error, SyntaxError):
        return f"{error.filename or place}, line {error.lineno or 1}: {error.msg}"
    own = str(path.parent)
    lines = [
        (frame.filename, frame.lineno)
        for frame in traceback.extract_tb(error.__traceback__)
        if frame.filename.startswith(own)
    ]
    file, line = lines[-1] if lines else (place, None)
    where = f"{file}, line {line}" if line else file
    if unknown := _unknown_argument(error):
        return f"{where}: {unknown}"
    kind = "" if _is_ours(error) else f"{type(error).__name__}: "
    said = str(error).splitlines() if _is_ours(error) else [str(error)]  # ours: a fault a line
    return "\n".join(f"{where}: {kind}{_plain(each)}" for each in said or [""])


def _unknown_argument(error: BaseException) -> str:
    """Return which arguments a dataclass has, where it was called with another; "" elsewhere."""
    match = _UNKNOWN_ARGUMENT.match(str(error)) if isinstance(error, TypeError) else None
    frames = list(traceback.walk_tb(error.__traceback__)) if match else []
    if match is None or not frames:
        return ""
    values = frames[-1][0].f_globals.values()
    for kind in (each for each in values if isinstance(each, type) and is_dataclass(each)):
        if kind.__qualname__ == match["kind"]:
            known = known_words(match["word"], (each.name for each in fields(kind) if each.init))
            return f"{kind.__name__} has no argument {match['word']!r}; {known}"
    return ""


def _plain(text: str) -> str:
    """Return text on one line that moves no cursor and changes no colour of a terminal."""
    line = " ".join(text.split())
    return line if line.isprintable() else ascii(line)[1:-1]


def _is_ours(error: BaseException) -> bool:
    return type(error).__module__ == "repro.errors"


def _in_folder(folder: Path) -> list[Path]:
    package = folder / "__init__.py"
    if package.is_file() and _may_declare(package):
        return [package]
    files = [path for path in sorted(folder.glob("*.py")) if path.name != "__init__.py"]
    files += [
        path
        for path in sorted(folder.glob("*/__init__.py"))
        if path.is_file() and _may_declare(path)
    ]
    papers = [path for path in files if path.is_file() and _may_declare(path)]
    helpers = {name for path in papers for name in _names_imported(path)}
    lacking = [path for path in files if path not in papers and path.stem not in helpers]
    if not papers:
        message = f"{folder}: no module in this folder declares {PAPER}"
        raise InputError(message)
    return sorted((*papers, *lacking))


def _may_declare(path: Path) -> bool:
    """Say whether a file declares a paper, or cannot be read, which importing it will tell."""
    try:
        return _declares(_tree(path))
    except InputError:
        return True


def _names_imported(path: Path) -> set[str]:
    """Return the last part of every name that a module imports, of modules and from them."""
    try:
        tree = _tree(path)
    except InputError:
        return set()
    return {name.rpartition(".")[2] for name in _imports(tree)}


def _tree(path: Path) -> ast.Module:
    try:
        if path.stat().st_size > LARGEST:
            message = f"{path}: it has more than {LARGEST:,} bytes"
            raise InputError(message)
        return ast.parse(path.read_bytes(), filename=str(path))
    except SyntaxError as error:
        raise InputError(failure(error, path)) from None
    except (OSError, ValueError, RecursionError, MemoryError) as error:
        message = f"{path}: it cannot be read as Python: {error}"
        raise InputError(message) from None


def _declares(tree: ast.Module) -> bool:
    return any(PAPER in _bound(node) for statement in tree.body for node in ast.walk(statement))


def _bound(node: ast.AST) -> set[str]:
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        return {node.id}
    if isinstance(node, (ast.Import, ast.ImportFrom)):
        return {alias.asname or alias.name for alias in node.names}
    return set()


def _imports(tree: ast.Module) -> Iterator[str]:
    """Yield the modules that are imported, and names that may be modules of a package."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        if isinstance(node, ast.ImportFrom):
            if node.module:
                yield node.module
            yield from (f".{alias.name}" for alias in node.names)


def _named(path: Path) -> tuple[str, Path]:
    """Return the name that a module is imported by, and the folder that it is looked for in."""
    parts = [] if path.name == "__init__.py" else [path.stem]
    folder = path.parent
    while (folder / "__init__.py").is_file():
        parts.insert(0, folder.name)
        folder = folder.parent
    if not all(part.isidentifier() for part in parts):
        message = f"{path}: a module must be named as Python names are, with letters, digits and _"
        raise InputError(message)
    return ".".join(parts), folder


def _refuse_other_modules_of_a_name(name: str, root: Path, tree: ast.Module, path: Path) -> None:
    """Raise InputError where the module, or one beside it that it imports, would be another's."""
    waiting, seen = [(name.partition(".")[0], tree)], set[str]()
    while waiting:
        first, own = waiting.pop()
        seen.add(first)
        _refuse_another(first, root, path)
        for wanted in {each.partition(".")[0] for each in _imports(own)} - seen:
            beside = _beside(wanted, root) if wanted else None
            if beside is not None:
                _refuse_another(wanted, root, path)
            if beside is not None and wanted not in sys.modules:
                with contextlib.suppress(InputError):
                    waiting.append((wanted, _tree(beside)))


def _beside(name: str, root: Path) -> Path | None:
    for candidate in (root / name / "__init__.py", root / f"{name}.py"):
        if candidate.is_file():
            return candidate
    return None


def _refuse_another(name: str, root: Path, path: Path) -> None:
    loaded, own = sys.modules.get(name), _beside(name, root)
    if loaded is None or own is None:
        return
    file = getattr(loaded, "__file__", None)
    if file is None or Path(file).resolve() != own.resolve():
        message = (
            f"{path}: it needs {own}, but the name {name!r} belongs to "
            f"{file or 'a part of Python'}: rename one of them"
        )
        raise InputError(message)


def _imported(name: str, root: Path, path: Path) -> ModuleType:
    place = str(root)
    if place not in sys.path:
        sys.path.insert(0, place)
    try:
        # what it prints is not what the command was asked for
        with contextlib.redirect_stdout(sys.stderr):
            importlib.invalidate_caches()
            return importlib.import_module(name)
    except (Exception, SystemExit) as error:  # noqa: BLE001 (a stranger's module may do anything)
        raise InputError(failure(error, path)) from None
