"""Definitions, and which others they reach: followed by name through the modules that are ours.

A definition is a name at the top level of a module, with every statement that binds or changes it.
What cannot be followed counts as a whole module with all that it imports: a digest may change too
often and never too seldom.
"""

import builtins
import hashlib
from collections.abc import Iterable, Iterator
from functools import cache
from typing import NamedTuple

from repro.determinism.names_used import Chain
from repro.determinism.source_files import (
    is_of_engine,
    is_own,
    path_of,
)
from repro.determinism.statements import Statement, Target, meaning, statements_of

_DEPTH = 50  # imports that hand a name on; more is a circle


class Definition(NamedTuple):
    """A name at the top level of a module; no name stands for the whole module."""

    module: str
    name: str

    def __str__(self) -> str:
        """Return it in words."""
        return f"{self.name or 'all'} of {self.module}"


Reached = dict[Definition, str]
"""Definitions, each with a digest of what it says and of what its names stand for."""


def reached(roots: Iterable[Definition]) -> Reached:
    """Return all that some definitions reach, with what changes any of it from elsewhere."""
    found: set[Definition] = set()
    changes: Reached = {}
    waiting = set(roots)
    while waiting:
        found = found.union(*map(_closure, waiting))
        waiting = set()
        for module in _beside(found):
            text, names = _changes(module, found)
            if text:
                changes[Definition(module, "changes")] = text
                waiting |= names - found
    own = {one: _expanded(one)[0] for one in found if is_own(one.module)}
    return own | changes | _orders(own)


@cache
def _closure(root: Definition) -> frozenset[Definition]:
    found: set[Definition] = set()
    waiting = {root}
    while waiting:
        found |= waiting
        waiting = {name for one in waiting for name in _expanded(one)[1]} - found
    return frozenset(found)


def _orders(found: Reached) -> Reached:
    """Return the order of what is reached in each module where a name is bound more than once."""
    made: dict[str, list[Definition]] = {}
    for one in found:
        if one.name:
            made.setdefault(one.module, []).append(one)
    orders: Reached = {}
    for module, definitions in made.items():
        groups = [_making(one) for one in definitions]
        if any(len(group) > 1 for group in groups):
            kept = {id(statement) for group in groups for statement in group}
            texts = [meaning(s) for s in statements_of(module) if id(s) in kept]
            orders[Definition(module, "order")] = digest("\0".join(texts))
    return orders


def digest(text: str) -> str:
    """Return a short digest."""
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def exists(definition: Definition) -> bool:
    """Return whether a module binds a name otherwise than by an import."""
    bound = _bound(definition.module).get(definition.name, ())
    return any(not statement.is_import for statement in bound)


def changes_in_runs(one: Definition) -> bool:
    """Return whether a function of its module changes what a name stands for."""
    return any(s.is_body and one.name not in s.binds for s in _making(one))


@cache
def _bound(module: str) -> dict[str, list[Statement]]:
    bound: dict[str, list[Statement]] = {}
    for statement in statements_of(module):
        for name in statement.binds:
            bound.setdefault(name, []).append(statement)
    return bound


@cache
def _expanded(one: Definition) -> tuple[str, frozenset[Definition]]:
    """Return the digest of one definition, and the definitions that it names."""
    if not is_own(one.module):  # its version is the provenance's
        return digest(str(one)), frozenset()
    if not one.name:
        text, names = _said(statements_of(one.module), one.module)
        return text, names | {Definition(m, "") for m in imported_modules(one.module)}
    text, names = _said(_making(one), one.module)
    changing = (s.binds for s in _making(one) if one.name not in s.binds)
    return text, names | {Definition(one.module, name) for binds in changing for name in binds}


@cache
def _making(one: Definition) -> tuple[Statement, ...]:
    """Return the statements of its own module that bind or change a definition, in their order."""
    return tuple(
        statement
        for statement in statements_of(one.module)
        if not statement.is_import
        and (one.name in statement.binds or one in _changed_by(one.module, statement))
    )


def _said(statements: Iterable[Statement], module: str) -> tuple[str, frozenset[Definition]]:
    texts: list[str] = []
    names: set[Definition] = set()
    for statement in statements:
        stands_for = {chain: frozenset(_uses(module, chain, statement)) for chain in statement.uses}
        names |= frozenset[Definition]().union(*stands_for.values())
        names.update(d for _, target in statement.imports for d in _imported(target))
        if statement.computes:
            names.add(Definition(module, ""))
        edges = sorted((chain, sorted(found)) for chain, found in stands_for.items())
        texts.append(f"{meaning(statement)}\0{edges}")
    return digest("\0".join(texts)), frozenset(names)


def _uses(module: str, chain: Chain, statement: Statement) -> Iterator[Definition]:
    return resolved(module, chain, statement.imports)


def _imported(target: Target) -> Iterator[Definition]:
    """Yield what an import inside a statement brings where it names one thing."""
    if target.name and target.name != "*":
        yield from _asked(target.module, (target.name,), 0)


@cache
def imported_modules(module: str) -> frozenset[str]:
    """Return the modules of the engine or of users that a module imports, wherever in it."""
    targets = {target for s in statements_of(module) for _, target in s.imports}
    names = {t.module for t in targets} | {f"{t.module}.{t.name}" for t in targets if t.name}
    return frozenset(name for name in names if name != module and is_own(name))


def import_closure(module: str) -> frozenset[str]:
    """Return a module and all of its user's own that it imports, directly or not."""
    found: set[str] = set()
    waiting = {module}
    while waiting:
        found |= waiting
        waiting = {
            name for m in waiting for name in imported_modules(m) if not is_of_engine(name)
        } - found
    return frozenset(found)


def resolved(
    module: str, chain: Chain, imports: tuple[tuple[str, Target], ...] = (), depth: int = 0
) -> Iterator[Definition]:
    """Yield the definitions that a chain of names stands for in a module."""
    name, rest = chain[0], chain[1:]
    bound = _bound(module).get(name, [])
    targets = {target for n, target in imports if n == name}
    targets |= {t for s in bound if s.is_import for n, t in s.imports if n == name}
    if any(not statement.is_import for statement in bound):
        yield Definition(module, name)
    if depth < _DEPTH:
        for target in targets:
            asked = (target.name, *rest) if target.name else rest
            yield from _asked(target.module, asked, depth + 1)
        if not targets and not bound:
            yield from _starred(module, chain, depth + 1)


def _asked(module: str, chain: Chain, depth: int) -> Iterator[Definition]:
    """Yield what the names that are asked of a module stand for."""
    if not is_own(module):
        yield Definition(module, chain[0] if chain else "")
    elif not chain:
        yield Definition(module, "")
    elif chain[0] in _bound(module):
        yield from resolved(module, chain, depth=depth)
    elif path_of(f"{module}.{chain[0]}"):
        yield from _asked(f"{module}.{chain[0]}", chain[1:], depth)
    elif found := list(_starred(module, chain, depth)):
        yield from found
    else:  # made by __getattr__, or by something that no analysis follows
        yield Definition(module, "")


def _starred(module: str, chain: Chain, depth: int) -> Iterator[Definition]:
    """Yield what a name that a module does not bind may stand for."""
    if depth >= _DEPTH:
        return
    for statement in _bound(module).get("*", []):
        for _, target in statement.imports:
            if target.name == "*" and is_own(target.module):
                if chain[0] in _bound(target.module):
                    yield from resolved(target.module, chain, depth=depth)
                else:
                    yield from _starred(target.module, chain, depth + 1)
            elif target.name == "*" and not hasattr(builtins, chain[0]):
                yield Definition(target.module, chain[0])


@cache
def _changed_by(module: str, statement: Statement) -> frozenset[Definition]:
    return frozenset(
        found for chain in statement.changes for found in resolved(module, chain, statement.imports)
    )


def _changes(module: str, found: set[Definition]) -> tuple[str, frozenset[Definition]]:
    """Return what a module says that changes what is reached, where it is of other modules."""
    outside = {one.module for one in found if not is_own(one.module)}
    kept = [
        statement
        for statement, changed in _changing(module)
        if any(one in found or (not one.name and one.module in outside) for one in changed)
    ]
    return _said(kept, module) if kept else ("", frozenset())


@cache
def _changing(module: str) -> tuple[tuple[Statement, frozenset[Definition]], ...]:
    """Return the statements of a module that may change something, each with what.

    A function that changes what stands at the top level changes it where it is called.
    """
    pairs = []
    for statement in statements_of(module):
        called = (d for c in statement.calls for d in resolved(module, c, statement.imports))
        changed = _changed_by(module, statement) | {one for one in called if _has_state(one)}
        if changed and not statement.is_import:
            pairs.append((statement, frozenset(changed)))
    return tuple(pairs)


@cache
def _has_state(one: Definition) -> bool:
    bound = _bound(one.module).get(one.name, ())
    return any(_changed_by(one.module, s) for s in bound if not s.is_import)


def _beside(found: set[Definition]) -> list[str]:
    """Return the modules that may change what is reached: those of it, and what a user's import.

    No others, whatever is loaded: else a run had another key beside other papers.
    """
    inside = {one.module for one in found if is_own(one.module)}
    users = {name for name in inside if not is_of_engine(name)}
    around = {name for module in users for name in import_closure(module)}
    return sorted(inside | around)
