"""What the statements at the top level of a module bind, change and use, read from the source."""

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

from repro.determinism.names_used import Chain, Names, arguments_of, walk
from repro.determinism.source_files import is_package, tree_of

_BODIES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)


class Target(NamedTuple):
    """What an import names: a module, and a name in it unless that is empty."""

    module: str
    name: str


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Statement:
    """One statement at the top level, `node` without what does not run.

    It `binds` names, `changes` what is bound elsewhere, `calls` what may change more, and `uses`
    chains of names. `imports` are the names that it imports, wherever in it. It `computes` names
    where no analysis can follow.
    """

    node: ast.stmt
    binds: frozenset[str]
    changes: frozenset[Chain]
    calls: frozenset[Chain]
    uses: frozenset[Chain]
    imports: tuple[tuple[str, Target], ...]
    computes: bool

    @property
    def is_import(self) -> bool:
        """Whether it imports and does nothing else."""
        return isinstance(self.node, ast.Import | ast.ImportFrom)

    @property
    def is_body(self) -> bool:
        """Whether it is a function or a class: what it changes, it may change later."""
        return isinstance(self.node, _BODIES)


@cache
def meaning(statement: Statement) -> str:
    """Return all of a statement that runs, as text."""
    return ast.dump(statement.node)


def lambdas_of(module: str, line: int) -> tuple[Statement, ...]:
    """Return the functions without a name that begin on a line of a module."""
    found = (part for part in walk(tree_of(module)) if isinstance(part, ast.Lambda))
    return tuple(_statement(ast.Expr(part), module) for part in found if part.lineno == line)


@cache
def statements_of(module: str) -> tuple[Statement, ...]:
    """Return the statements of a module, an import of several names as several statements."""
    return tuple(_statement(node, module) for node in _single(tree_of(module).body))


def _single(nodes: Iterable[ast.stmt]) -> Iterator[ast.stmt]:
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (ast.Import(names=[alias]) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (ast.ImportFrom(node.module, [alias], node.level) for alias in node.names)
        elif not _is_idle(node):
            yield node


def _statement(node: ast.stmt, module: str) -> Statement:
    nodes = _stripped(node)
    found = Names()
    found.visit(node, frozenset(), "top")
    imports = tuple(pair for part in nodes for pair in _imports(part, module))
    inside = isinstance(node, _BODIES)
    bound = set() if inside else {name for name, _ in imports}
    return Statement(
        node=node,
        binds=frozenset(found.binds | bound),
        changes=frozenset(found.changes),
        calls=frozenset(found.calls),
        uses=frozenset(found.uses),
        imports=imports,
        computes=found.computes,
    )


def _stripped(node: ast.stmt) -> list[ast.AST]:
    """Take away what does not run: texts that stand alone, and annotations but those of fields.

    Returns the parts of what is left, and of what was in annotations.
    """
    nodes = walk(node)
    fields: set[int] = set()
    for part in nodes:
        for name in ("body", "orelse", "finalbody"):
            body = getattr(part, name, None)
            if isinstance(body, list):
                body[:] = [statement for statement in body if not _is_idle(statement)]
        if isinstance(part, ast.ClassDef):
            fields.update(map(id, part.body))
        if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef) and not _dispatches(part):
            part.returns = None
            for argument in arguments_of(part):
                argument.annotation = None
        if isinstance(part, ast.AnnAssign) and id(part) not in fields:
            part.annotation = ast.Constant(None)
    return nodes


def _dispatches(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Return whether a decorator may choose by the annotations, as `singledispatch` does."""
    return any("register" in ast.dump(decorator) for decorator in function.decorator_list)


def _is_idle(node: ast.stmt) -> bool:
    if isinstance(node, ast.Pass):
        return True
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )


def _imports(part: ast.AST, module: str) -> Iterator[tuple[str, Target]]:
    if isinstance(part, ast.Import):
        for alias in part.names:
            name = alias.asname or alias.name.partition(".")[0]
            yield name, Target(alias.name if alias.asname else name, "")
    if isinstance(part, ast.ImportFrom):
        source = _absolute(part, module)
        for alias in part.names:
            yield alias.asname or alias.name, Target(source, alias.name)


def _absolute(node: ast.ImportFrom, module: str) -> str:
    if not node.level:
        return node.module or ""
    parts = module.split(".")
    kept = parts[: len(parts) - node.level + is_package(module)]
    return ".".join([*kept, *([node.module] if node.module else [])])
