"""The searches that a comparison is of: their places, names, and the page that is theirs alone."""

import ast
import hashlib
import importlib
import importlib.metadata
import importlib.util
import inspect
import json
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from importlib.machinery import ModuleSpec
from itertools import count
from pathlib import Path
from typing import Any

from repro.determinism.source_files import is_own
from repro.errors import InputError
from repro.model.identifiers import anchor
from repro.model.paper import Paper
from repro.optimisers.libraries import BASELINES
from repro.optimisers.users_search import Entrant, entrant
from repro.runs.whole_files import read_file

_PLAIN = re.compile(r"[A-Za-z0-9][\w.-]*", re.ASCII)
_TAKEN = ("results", "index", "verdicts", "another-seed")  # files that published pages have
_KINDS = ("html", "md", "json", "csv")
_LONGEST = 80  # characters of a file's name


def split(given: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the places of searches and the papers among what stands behind the command.

    Raises InputError where there is no search.
    """
    places = [word for word in given if ":" in word and not Path(word).exists()]
    if not places:
        message = f"{given[0]!r} is not MODULE:OBJECT, as in searches:anneal"
        raise InputError(message)
    return places, [word for word in given if word not in places]


def named(
    places: Sequence[str], names: Sequence[str], papers: Iterable[Paper]
) -> dict[str, Entrant]:
    """Return each search by its name; InputError for a name that is taken or cannot be one."""
    if names and len(names) != len(places):
        message = f"{len(names)} names are given by --name for {len(places)} searches"
        raise InputError(message)
    found = [entrant(in_module(place)) for place in places]
    called = list(names) or [place.rpartition(":")[2] for place in places]
    for name in called:
        if called.count(name) > 1:
            message = f"two searches have the name {name!r}: give each a --name"
            raise InputError(message)
        check_name(name, papers)
    return dict(zip(called, found, strict=True))


def in_module(place: str) -> str:
    """Return "module:object" for "file.py:object", and any other place as it is.

    A file of a package is a module of that. The folder that holds all becomes one where modules
    are looked for. Raises InputError where there is no such file, or another module has its name.
    """
    file, _, name = place.rpartition(":")
    path = Path(file).resolve()
    if path.suffix != ".py":
        return place
    if not path.is_file():
        message = f"no file {file}"
        raise InputError(message)
    home, parts = path.parent, [path.stem]
    while (home / "__init__.py").is_file():
        home, parts = home.parent, [home.name, *parts]
    for folder in (str(Path.cwd()), str(home)):
        if folder not in sys.path:
            sys.path.insert(0, folder)
    module = ".".join(parts)
    spec = _spec_of(module) if all(part.isidentifier() for part in parts) else None
    if spec is None or Path(spec.origin or "").resolve() != path:
        other = f": there is {spec.origin}" if spec else ""
        message = f"{file} cannot be imported as {module!r}{other}; give it another name"
        raise InputError(message)
    return f"{module}:{name}"


def _spec_of(module: str) -> ModuleSpec | None:
    """Return where a module would be imported from; InputError where its package cannot be."""
    try:
        return importlib.util.find_spec(module)
    except Exception as error:  # noqa: BLE001 (the user's package may do anything)
        message = f"{module!r} cannot be imported: {type(error).__name__}: {error}"
        raise InputError(message) from None


def home_of(place: str) -> str:
    """Return the folder from which the module of a place was imported."""
    module = place.partition(":")[0]
    found = getattr(sys.modules.get(module), "__file__", None)
    if found is None:
        return str(Path.cwd())
    levels = module.count(".") + (Path(found).name == "__init__.py")
    return str(Path(found).resolve().parents[levels])


def entrant_in(place: str, folder: str) -> Entrant:
    """Return the search at a place, found from the folder where it was compared.

    Raises InputError where it is there no longer.
    """
    if folder not in sys.path:
        sys.path.append(folder)
    return entrant(place)


def check_name(name: str, papers: Iterable[Paper]) -> None:
    """Raise InputError for a name that another algorithm has, or that cannot be shown."""
    taken = {
        algorithm
        for paper in papers
        for experiment in paper.experiments
        for algorithm in (*experiment.algorithms, *BASELINES)
    }
    if name in taken:
        message = f"the name {name!r} belongs to another algorithm: choose one with --name"
        raise InputError(message)
    if not name.strip() or "/" in name or not name.isprintable():
        message = f"the name {name!r} must be printable, with no '/': choose one with --name"
        raise InputError(message)


def stem(folder: Path, names: Sequence[str]) -> str:
    """Return the name of the files of a comparison: no other comparison in the folder has it."""
    plain = [name if _PLAIN.fullmatch(name) else anchor(name) or "search" for name in names]
    called = "-and-".join(plain)
    digest = hashlib.sha256("\0".join(names).encode("utf-8", "surrogatepass")).hexdigest()[:8]
    if len(called) > _LONGEST or called.lower().partition(".")[0] in _TAKEN:
        called = f"{called[:_LONGEST]}-{digest}"
    others = (f"{called}-{digest}-{number}" for number in count(2))
    for each in (called, f"{called}-{digest}"):
        if _is_free(folder, each, names):
            return each
    return next(each for each in others if _is_free(folder, each, names))


def _is_free(folder: Path, called: str, names: Sequence[str]) -> bool:
    """Return whether files so called are those of these searches, or not there in any case."""
    before = _names_in(folder / f"{called}.json")
    if before is not None:
        return before == [*names]
    own = {called.lower(), *(f"{called}.{kind}".lower() for kind in _KINDS)}
    return not folder.is_dir() or own.isdisjoint(path.name.lower() for path in folder.iterdir())


def _names_in(path: Path) -> list[str] | None:
    """Return the searches that a comparison's file is of; None where there is no such file."""
    try:
        content: Any = json.loads(read_file(path).decode())
        return [str(name) for name in content["names"]]
    except FileNotFoundError:
        return None
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return []


def libraries(places: Iterable[str]) -> Mapping[str, str]:
    """Return the version of every library that the modules of searches import, by its name."""
    seen: dict[str, None] = {}
    for place in places:
        _add_imports(place.partition(":")[0], seen)
    names = _owners(frozenset(name.partition(".")[0] for name in seen))
    return {name: importlib.metadata.version(name) for name in sorted(names)}


@cache
def _owners(packages: frozenset[str]) -> frozenset[str]:
    """Return the libraries that these packages are of.

    Kept by the packages: every installed library is read for it, and one may be installed
    between two calls.
    """
    owners = importlib.metadata.packages_distributions()
    return frozenset(owner for package in packages for owner in owners.get(package, ()))


def _add_imports(module: str, seen: dict[str, None]) -> None:
    """Add what a module of the user's own imports, and what its own modules import."""
    if module in seen:
        return
    seen[module] = None
    loaded = sys.modules.get(module)
    if loaded is None or not is_own(module):
        return
    try:
        tree = ast.parse(inspect.getsource(loaded))
    except (OSError, TypeError, SyntaxError):
        return
    for name in _imported(tree):
        _add_imports(name, seen)


def _imported(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (each.name for each in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module
