"""The papers that there are, and the only one that finds them.

They are modules of `papers`, keys of the entry points `repro.papers` of installed packages, and
files and folders that a command names.
"""

import difflib
import importlib.metadata
import importlib.util
import os
import sys
from argparse import Namespace
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from repro.commands import own_papers
from repro.commands.paper_modules import PAPER, Declared, Failed, declared_in, failure, modules_in
from repro.commands.shown_rows import warn
from repro.errors import InputError
from repro.model.paper import Paper

GROUP = "repro.papers"


def all_papers() -> dict[str, Paper]:
    """Return every paper of this house and of installed packages, by key; faults are left out."""
    return {each.paper.key: each.paper for each in known() if isinstance(each, Declared)}


def known() -> list[Declared | Failed]:
    """Return the papers of this house and of installed packages, and those that fail."""
    return [*_of_this_house(), *map(_of_entry_point, importlib.metadata.entry_points(group=GROUP))]


def chosen(options: Namespace) -> list[Paper]:
    """Return the papers that `options.keys` name: keys, files and folders; all if there is none.

    One that fails is named in a line and stops no other; `options.faulty` says that one failed
    that was asked for. Raises InputError where none is left, for an unknown key, and for two
    papers of one key.
    """
    found, faults = _asked_for(list(options.keys))
    if not found and faults:
        raise InputError("\n".join(fault.says for fault in faults))
    for fault in faults:
        for line in fault.says.splitlines():
            warn(line)
    options.faulty = bool(faults)
    options.places = {each.paper.key: each.place for each in found}
    options.called = {e.paper.key: _called(e) for e in found if not of_this_house([e.place])}
    return [each.paper for each in found]


def found_papers(arguments: Iterable[str] = ()) -> list[Paper]:
    """Return the papers that keys, files and folders name, all that are known here for none.

    InputError for one that fails, where it is asked for.
    """
    wanted = list(arguments)
    found, faults = _asked_for(wanted)
    if faults and wanted:
        raise InputError("\n".join(fault.says for fault in faults))
    return [each.paper for each in found]


def _called(one: Declared) -> str:
    """Return what a paper from elsewhere is called here: its file, or its key where installed."""
    if one.installed:
        return one.paper.key
    if one.place.is_relative_to(Path.cwd()):
        return f"./{one.place.relative_to(Path.cwd())}"
    return str(one.place)


def chosen_one(options: Namespace) -> Paper:
    """Return the one paper that is asked for; InputError where a folder has several."""
    found = chosen(options)
    if len(found) != 1:
        message = (
            f"{options.keys[0]} holds {len(found)} papers: name one of {', '.join(options.places)}"
        )
        raise InputError(message)
    return found[0]


def order(found: Iterable[Paper]) -> list[str]:
    """Return the keys of all papers that are known here, those that were found among them."""
    return list(dict.fromkeys([*all_papers(), *(paper.key for paper in found)]))


def taken(key: str) -> str:
    """Return what has a key already: a paper of this house, or a module; "" where nothing has."""
    for folder in folders():
        if (file := Path(folder) / f"{key}.py").exists():
            return str(file)
    spec = importlib.util.find_spec(key) if key not in sys.modules else sys.modules[key].__spec__
    origin = spec.origin if spec else None
    return "" if spec is None or origin == str(Path(f"{key}.py").resolve()) else f"module {key}"


def is_path(argument: str) -> bool:
    """Say whether an argument names a file or folder of papers, not a key."""
    separators = (os.sep, os.altsep) if os.altsep else (os.sep,)
    return (
        argument in {".", ".."}
        or argument.endswith(".py")
        or any(mark in argument for mark in separators)
    )


def expected_file(key: str, place: Path | None = None) -> Path:
    """Return where the list of the verdicts expected of a paper stands, if there is one.

    It stands beside the file that declares the paper, in this house's folder where none is given.
    """
    folder = place.parent if place else Path(folders()[0])
    return folder / f"{key}.verdicts.csv"


def folders() -> tuple[str, ...]:
    """Return where the papers of this house are declared."""
    return tuple(own_papers.loaded().__path__)


def of_this_house(places: Iterable[Path]) -> bool:
    """Say whether all these files are modules of this house."""
    own = {Path(folder).resolve() for folder in folders()}
    return all(place.parent in own for place in places)


def _asked_for(arguments: Sequence[str]) -> tuple[list[Declared], list[Failed]]:
    """Return the papers that are asked for, each once, and those that fail."""
    here = known()
    wanted: list[Declared | Failed] = [] if arguments else here
    for argument in dict.fromkeys(arguments):
        wanted += _of_path(Path(argument)) if is_path(argument) else [_of_key(argument, here)]
    found = {each.place: each for each in wanted if isinstance(each, Declared)}
    _refuse_equal_keys([*found.values(), *here])
    return list(found.values()), [each for each in wanted if isinstance(each, Failed)]


def _of_key(key: str, here: Sequence[Declared | Failed]) -> Declared | Failed:
    papers_of_key = [each for each in here if isinstance(each, Declared) and each.paper.key == key]
    if papers_of_key:
        return papers_of_key[0]
    for each in here:  # it may be the one that fails
        if isinstance(each, Failed) and each.place.stem == key:
            return each
    keys = [each.paper.key for each in here if isinstance(each, Declared)]
    near = difflib.get_close_matches(key, keys, n=1)
    hint = f"; did you mean {near[0]}?" if near else ""
    message = (
        f"unknown paper {key!r}; known: {', '.join(keys)}{hint} (looked for in "
        f"{', '.join(folders())} and in the entry points {GROUP!r}; "
        "a file or folder is named by its path, "
        "as in ./mine.py)"
    )
    raise InputError(message)


def _of_path(path: Path) -> Iterator[Declared | Failed]:
    try:
        files = modules_in(path)
    except InputError as error:
        yield Failed(place=path, says=str(error))
        return
    for file in files:
        yield _declared(file)


def _declared(file: Path) -> Declared | Failed:
    try:
        return declared_in(file)
    except InputError as error:
        return Failed(place=file, says=str(error))


def _of_this_house() -> Iterator[Declared | Failed]:
    for folder in folders():
        yield from _of_path(Path(folder))


def _of_entry_point(point: importlib.metadata.EntryPoint) -> Declared | Failed:
    name = f"entry point {point.name} = {point.value}"
    try:
        loaded = point.load()
    except (Exception, SystemExit) as error:  # noqa: BLE001 (a stranger's module may do anything)
        return Failed(place=Path(point.name), says=failure(error, Path(name)))
    paper = getattr(loaded, PAPER, loaded)
    if not isinstance(paper, Paper):
        return Failed(place=Path(point.name), says=f"{name}: it is no paper and has no {PAPER}")
    file = getattr(sys.modules.get(point.module), "__file__", None)
    return Declared(paper=paper, place=Path(file or name), installed=True)


def _refuse_equal_keys(found: Iterable[Declared | Failed]) -> None:
    places: dict[str, Path] = {}
    for each in found:
        if isinstance(each, Failed):
            continue
        key = each.paper.key
        if places.setdefault(key, each.place) != each.place:
            message = f"two papers have the key {key!r}: {places[key]} and {each.place}"
            raise InputError(message)
