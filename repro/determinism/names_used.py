"""Which names a piece of source binds, changes, calls and uses, those of no function's own."""

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Literal

Chain = tuple[str, ...]
"""A name and the attributes that are asked of it: `helper.law.peak` is (helper, law, peak)."""
Place = Literal["top", "class", "function"]

_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
_COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
_CHANGES = frozenset(
    {
        *("append", "appendleft", "extend", "insert", "add", "update", "setdefault", "register"),
        *("pop", "popitem", "remove", "discard", "clear", "sort", "reverse", "fill", "put"),
        *("itemset", "resize", "__setitem__", "__setattr__"),
    }
)
_COMPUTED = frozenset({"globals", "locals", "eval", "exec", "__import__", "import_module"})
_SETS = frozenset({"setattr", "delattr", "__setattr__", "__delattr__"})


def children(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the parts of a node that say something; whether a name is stored is asked of it."""
    for name in _fields(node._fields):
        value = getattr(node, name, None)
        if isinstance(value, list):
            yield from (part for part in value if isinstance(part, ast.AST))
        elif isinstance(value, ast.AST):
            yield value


@cache
def _fields(names: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(name for name in names if name not in ("ctx", "op", "ops"))


def walk(node: ast.AST) -> list[ast.AST]:
    """Return a node and all that is in it, from the outside to the inside."""
    found = [node]
    for part in found:
        found.extend(children(part))
    return found


def chain_of(node: ast.AST) -> Chain:
    """Return the chain that an expression starts from, () where it starts from no name."""
    names: list[str] = []
    while isinstance(node, ast.Attribute | ast.Subscript | ast.Starred):
        names = [node.attr, *names] if isinstance(node, ast.Attribute) else []
        node = node.value
    return (node.id, *names) if isinstance(node, ast.Name) else ()


@dataclass(slots=True)
class Names:
    """What a walk over one statement finds; names that are local to a function are left out.

    `computes` says that names are computed where no analysis can follow.
    """

    binds: set[str] = field(default_factory=set)
    changes: set[Chain] = field(default_factory=set)
    calls: set[Chain] = field(default_factory=set)
    uses: set[Chain] = field(default_factory=set)
    computes: bool = False

    def visit(self, node: ast.AST, bound: frozenset[str], place: Place) -> None:
        """Take in a node, in which the names `bound` are local."""
        if isinstance(node, _FUNCTIONS):
            self._function(node, bound, place)
            return
        if isinstance(node, ast.ClassDef):
            self._name(node.name, bound, place)
            for part in children(node):
                self.visit(part, bound, "class" if part in node.body else place)
            self._called(node.decorator_list, bound)
            return
        if isinstance(node, _COMPREHENSIONS):
            bound |= {name for each in node.generators for name in _stored(each.target)}
        if isinstance(node, ast.Expr) and place != "function":
            self._bare(node, bound)
        self._expression(node, bound, place)

    def _expression(self, node: ast.AST, bound: frozenset[str], place: Place) -> None:
        if isinstance(node, ast.Name | ast.Attribute | ast.Subscript):
            chain = chain_of(node)
            if self._asked(node, chain, bound, place):
                return
        if isinstance(node, ast.Call):
            self._call(node, bound, place)
        for name in _captured(node):
            self._name(name, bound, place)
        for part in children(node):
            self.visit(part, bound, place)

    def _asked(
        self, node: ast.Name | ast.Attribute | ast.Subscript, chain: Chain,
        bound: frozenset[str], place: Place,
    ) -> bool:  # fmt: skip
        """Take in a chain; return whether all of the node is in it."""
        stored = isinstance(node.ctx, ast.Store | ast.Del)
        if isinstance(node, ast.Name) and stored:
            self._name(node.id, bound, place)
        elif chain and chain[0] not in bound:
            if stored:
                self.changes.add(chain)
            self._used(chain)
        return isinstance(node, ast.Name) or (bool(chain) and len(chain) == _depth(node))

    def _used(self, chain: Chain) -> None:
        self.uses.add(chain)
        self.computes |= chain[-1] in _COMPUTED or chain[:2] == ("sys", "modules")

    def _name(self, name: str, bound: frozenset[str], place: Place) -> None:
        if place == "top":
            self.binds.add(name)
        elif place == "function" and name not in bound:  # declared global
            self.changes.add((name,))
            self.uses.add((name,))  # `+=` reads it, too

    def _function(
        self, node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda,
        bound: frozenset[str], place: Place,
    ) -> None:  # fmt: skip
        if not isinstance(node, ast.Lambda):
            self._name(node.name, bound, place)
            self._called(node.decorator_list, bound)
            for decorator in node.decorator_list:
                self.visit(decorator, bound, place)
        self.visit(node.args, bound, place)  # defaults are computed outside
        inside = (bound - _globals(node)) | _locals(node)
        for part in node.body if isinstance(node.body, list) else [node.body]:
            self.visit(part, inside, "function")

    def _called(self, decorators: Iterable[ast.expr], bound: frozenset[str]) -> None:
        for decorator in decorators:
            chain = chain_of(decorator.func if isinstance(decorator, ast.Call) else decorator)
            if chain and chain[0] not in bound:
                self.calls.add(chain)
                if (
                    len(chain) > 1 and chain[-1] in _CHANGES
                ):  # a method that keeps what it decorates
                    self.changes.add(chain[:-1])

    def _call(self, node: ast.Call, bound: frozenset[str], place: Place) -> None:
        chain = chain_of(node.func)
        if chain and chain[0] not in bound:
            if place != "function":
                self.calls.add(chain)
            if len(chain) > 1 and chain[-1] in _CHANGES:
                self.changes.add(chain[:-1])
        if chain and chain[-1] in _SETS and node.args:
            changed = chain_of(node.args[0])
            if changed and changed[0] not in bound:
                self.changes.add(changed)

    def _bare(self, node: ast.Expr, bound: frozenset[str]) -> None:
        """Take a statement that throws its value away to change whatever it is given."""
        called = chain_of(node.value.func) if isinstance(node.value, ast.Call) else ()
        if len(called) > 1:
            self.changes.add(called[:-1])
        for part in walk(node):
            chain = chain_of(part)
            if chain and chain[0] not in bound and chain != called:
                self.changes.add(chain)


def _depth(node: ast.AST) -> int:
    depth = 1
    while isinstance(node, ast.Attribute):
        node, depth = node.value, depth + 1
    return depth if isinstance(node, ast.Name) else 0


def _locals(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> frozenset[str]:
    """Return the names that are local to a function; what it imports is none of them."""
    arguments = {argument.arg for argument in arguments_of(node)}
    if isinstance(node, ast.Lambda):
        return frozenset(arguments)
    names = {name for statement in node.body for name in _stored(statement)}
    return frozenset((names - _globals(node)) | arguments)


def arguments_of(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> list[ast.arg]:
    """Return all arguments of a function."""
    given = node.args
    every = (*given.posonlyargs, *given.args, *given.kwonlyargs, given.vararg, given.kwarg)
    return [argument for argument in every if argument]


def _globals(node: ast.AST) -> frozenset[str]:
    return frozenset(
        name for part in walk(node) if isinstance(part, ast.Global) for name in part.names
    )


def _stored(node: ast.AST) -> Iterator[str]:
    """Yield the names that a part of a function binds, not those of functions in it."""
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store | ast.Del):
        yield node.id
    yield from _captured(node)
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
        yield node.name
    elif not isinstance(node, (*_COMPREHENSIONS, ast.Lambda)):
        for part in children(node):
            yield from _stored(part)


def _captured(node: ast.AST) -> Iterator[str]:
    """Yield the name that an `except` or a `case` binds by itself."""
    if isinstance(node, ast.ExceptHandler | ast.MatchAs | ast.MatchStar) and node.name:
        yield node.name
    if isinstance(node, ast.MatchMapping) and node.rest:
        yield node.rest
