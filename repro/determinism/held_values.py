"""What an object is, as text: its value, the objects that it holds, and the source that it names.

Fields are taken from `__dict__` and `__slots__`; left out are results that `cached_property` keeps,
names that begin with `_cached`, which are for caches, and fields of a dataclass whose metadata is
`SAID`: they say something of an object, and decide no run. What an `identity` says counts besides.
"""

import enum
import functools
import re
import sys
import types
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import PurePath
from typing import Any

import numpy as np

from repro.determinism.definitions import Definition, exists, resolved
from repro.determinism.source_files import is_library, path_of
from repro.determinism.statements import lambdas_of, meaning
from repro.errors import DeclarationError

CACHE = "_cached"
SAID = types.MappingProxyType({"repro": "decides no run"})
"""Metadata of a dataclass field that holds words, or facts that no run uses."""
_PLAIN = (bool, int, float, complex, str, bytes, type(None), type(Ellipsis), type(NotImplemented))
_BUILT_IN = (types.BuiltinFunctionType, types.WrapperDescriptorType, types.MethodDescriptorType)
_UFUNC = "_dispatcher"
_COMPILED = ("py_func", "_pyfunc", _UFUNC, "pyfunc", "__wrapped__")
_REMEDY = "make it a frozen dataclass of numbers and texts, or give it an `identity`"
_DRAWING = re.compile(r"(numpy\.random|random)\b")
_SHOWN = 60


@dataclass(slots=True)
class Teller:
    """Tells objects apart, and collects the definitions that they rest on in `roots`.

    With `soft` an object that cannot be told is its type alone; else it is refused.
    """

    soft: bool = False
    roots: set[Definition] = field(default_factory=set)
    _open: dict[int, int] = field(default_factory=dict)

    def text(self, value: object, place: str) -> str:
        """Return what a value is; DeclarationError, naming the place, where that cannot be told."""
        if type(value) in _PLAIN:
            return f"{type(value).__name__} {value!r}"
        if id(value) in self._open:
            return f"as {len(self._open) - self._open[id(value)]} above"
        self._open[id(value)] = len(self._open)
        try:
            return (
                self._code(value, place)
                or self._value(value, place)
                or self._compiled(value, place)
                or self._object(value, place)
            )
        except DeclarationError:
            if not self.soft:
                raise
            return f"{type(value).__module__}.{type(value).__qualname__}"
        finally:
            del self._open[id(value)]

    def _code(self, value: Any, place: str) -> str:  # noqa: ANN401 (anything)
        """Return what a class, a module or a function is, "" for anything else."""
        if isinstance(value, type):
            return self._class(value, place)
        if isinstance(value, types.ModuleType):
            self.roots.add(Definition(value.__name__, ""))
            return f"module {value.__name__}"
        if isinstance(value, types.FunctionType):
            return self._function(value, place)
        if isinstance(value, types.MethodType):
            return f"{self.text(value.__func__, place)} of {self.text(value.__self__, place)}"
        if isinstance(value, _BUILT_IN):
            owner = getattr(value, "__self__", None)
            held = "" if isinstance(owner, types.ModuleType) else self.text(owner, place)
            return f"built in {value.__qualname__} {held}"
        return ""

    def _value(self, value: Any, place: str) -> str:  # noqa: ANN401
        """Return what a value of a kind that Python or numpy brings is, "" for another."""
        kind = type(value)
        if isinstance(value, enum.Enum):
            return f"{self._class(kind, place)}.{value.name}"
        if isinstance(value, np.ndarray) and not value.dtype.hasobject:
            numbers = np.ascontiguousarray(value).tobytes().hex()
            return f"{self._class(kind, place)} {value.dtype.str} {value.shape} {numbers}"
        if isinstance(value, np.generic | np.dtype | range | slice | PurePath | re.Pattern):
            return f"{kind.__name__} {value!r}"
        return ""

    def _compiled(self, value: Any, place: str) -> str:  # noqa: ANN401
        """Return the function that machine code, or what a library wraps, was made from."""
        kind = type(value)
        for name in _COMPILED if is_library(kind.__module__) else ():
            inner = getattr(value, name, None)
            if isinstance(inner, types.FunctionType) or (inner is not None and name == _UFUNC):
                options = self.text(getattr(value, "targetoptions", None), place)
                return f"{kind.__name__} {self.text(inner, place)} {options}"
        return ""

    def _object(self, value: Any, place: str) -> str:  # noqa: ANN401
        """Return what an object is by its type, its items and its fields."""
        kind = type(value)
        if _DRAWING.match(kind.__module__):
            message = (
                f"{place} holds random numbers ({kind.__qualname__}), so that no run would come "
                "out again: draw from the `rng` that a run is given"
            )
            raise DeclarationError(message)
        texts = [self._class(kind, place), *self._items(value, place)]
        if is_library(kind.__module__):
            if not isinstance(value, _CONTAINERS):
                texts.append(self._reduced(value, place))
            return f"<{' '.join(texts)}>"
        named = hasattr(kind, "identity")
        if named:
            texts.append(f"identity={self.text(value.identity, f'{place}.identity')}")
        within = Teller(soft=self.soft or named, roots=self.roots, _open=self._open)
        texts += [f"{n}={within.text(held, f'{place}.{n}')}" for n, held in fields_of(value)]
        return f"<{' '.join(texts)}>"

    def _items(self, value: object, place: str) -> Iterator[str]:
        if isinstance(value, Mapping):
            for key, held in value.items():
                yield f"{self.text(key, place)}: {self.text(held, f'{place}[{key!r:.{_SHOWN}}]')}"
        elif isinstance(value, set | frozenset):
            yield from sorted(self.text(held, place) for held in value)
        elif isinstance(value, tuple | list):
            for number, held in enumerate(value):
                yield self.text(held, f"{place}[{number}]")
        elif isinstance(value, np.ndarray):
            yield self.text(value.tolist(), place)
        elif isinstance(value, int | float | complex | str | bytes):  # a class made from it
            base = next(base for base in type(value).__mro__ if base in _PLAIN)
            yield f"{vars(base)['__repr__'](value)}"

    def _reduced(self, value: object, place: str) -> str:
        """Return what an object without fields says of itself when it is copied."""
        try:
            made: object = value.__reduce_ex__(4)
        except Exception:  # noqa: BLE001 (an object of C may do anything)
            made = None
        if not isinstance(made, tuple):
            message = f"{place} is {value!r:.{_SHOWN}}, whose value cannot be told: {_REMEDY}"
            raise DeclarationError(message)
        parts = [list(part) if isinstance(part, Iterator) else part for part in made]
        return self.text(parts, place)

    def _class(self, kind: type, place: str) -> str:
        for one in kind.__mro__:
            if is_library(one.__module__):
                continue
            definition = Definition(one.__module__, one.__qualname__.partition(".")[0])
            if not exists(definition):
                self._refuse(f"the class {one.__qualname__}", one.__module__, place)
            self.roots.add(definition)
            if "<locals>" in one.__qualname__:
                held = [v for v in vars(one).values() if _is_written(v, one.__module__)]
                return f"{kind.__qualname__} {[self._cells(v, place) for v in held]}"
        return f"{kind.__module__}.{kind.__qualname__}"

    def _function(self, value: types.FunctionType, place: str) -> str:
        module = _module_of(value)
        name = value.__code__.co_qualname
        if is_library(module):
            return f"{module}.{name} {self._cells(value, place)}"
        top, _, _ = name.partition(".")
        texts = [name, self._cells(value, place)]
        texts.append(self.text((value.__defaults__, value.__kwdefaults__), place))
        texts.append(self.text(vars(value), place))
        if exists(Definition(module, top)):
            self.roots.add(Definition(module, top))
        elif found := lambdas_of(module, value.__code__.co_firstlineno):
            for one in found:
                self.roots.update(d for chain in one.uses for d in resolved(module, chain))
                texts.append(meaning(one))
        else:
            self._refuse(f"the function {value.__qualname__}", module, place)
        if value.__globals__ is not vars(sys.modules.get(module, sys)):
            used = (n for n in value.__code__.co_names if n in value.__globals__)
            texts += [f"{n}={self.text(value.__globals__[n], f'{place}.{n}')}" for n in used]
        return f"<{' '.join(texts)}>"

    def _cells(self, function: types.FunctionType, place: str) -> str:
        names = function.__code__.co_freevars
        cells = zip(names, function.__closure__ or (), strict=True)
        return str([f"{n}={self.text(_content(c), f'{place}.{n}')}" for n, c in cells])

    @staticmethod
    def _refuse(what: str, module: str, place: str) -> None:
        where = f" in {module!r}" if module else ""
        message = (
            f"{place} rests on {what}, whose source cannot be found{where}: define it by name in a "
            "file"
        )
        raise DeclarationError(message)


_CONTAINERS = (Mapping, set, frozenset, tuple, list, np.ndarray, int, float, complex, str, bytes)


def fields_of(value: object) -> Iterable[tuple[str, object]]:
    """Return the names and values that an object holds, without caches and what is but said."""
    kind = type(value)
    said = {n for n, f in getattr(kind, "__dataclass_fields__", {}).items() if f.metadata == SAID}
    names = [
        name
        for one in kind.__mro__
        for name in _slots(one)
        if name not in ("__dict__", "__weakref__")
    ]
    names += list(getattr(value, "__dict__", ()))
    return [
        (name, getattr(value, name))
        for name in dict.fromkeys(names)
        if not name.startswith(CACHE)
        and name not in said
        and not isinstance(getattr(kind, name, None), functools.cached_property)
        and hasattr(value, name)
    ]


@functools.cache
def _slots(kind: type) -> tuple[str, ...]:
    slots = vars(kind).get("__slots__", ())
    names = (slots,) if isinstance(slots, str) else tuple(slots)
    private = f"_{kind.__name__.lstrip('_')}"
    return tuple(
        f"{private}{name}" if name.startswith("__") and not name.endswith("__") else name
        for name in names
    )


def _module_of(function: types.FunctionType) -> str:
    """Return the module in whose file a function stands, whatever it calls itself.

    One that `exec` made in names of no module is of none, and has no file either.
    """
    file, own = function.__code__.co_filename, function.__module__ or ""
    if (path := path_of(own)) is not None and str(path) == file:
        return own
    return next(
        (n for n, m in list(sys.modules.items()) if getattr(m, "__file__", None) == file), own
    )


def _is_written(value: object, module: str) -> bool:
    """Return whether a value is a function of the file of a module: no dataclass made it."""
    return isinstance(value, types.FunctionType) and value.__code__.co_filename == str(
        path_of(module)
    )


def _content(cell: types.CellType) -> object:
    try:
        return cell.cell_contents
    except ValueError:  # not bound yet
        return None
