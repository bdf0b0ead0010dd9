"""What an object is whose code stands in no file: a function of a notebook's cell, and its like."""

import hashlib
import pickle
import types
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from repro.determinism.held_values import Teller
from repro.determinism.source_digests import Told
from repro.determinism.source_files import is_library
from repro.errors import DeclarationError

_SHELL = "__main__"
_MADE = ("__module__", "__dict__", "__weakref__", "__doc__", "__qualname__", "__firstlineno__",
         "__static_attributes__", "__slots__")  # fmt: skip


def digest_of_unwritten(value: object) -> str:
    """Return a digest of all that an object is, holds and names, code of no file as it is compiled.

    What cannot be told is what it is when it is sent to a process.
    """
    teller = _Teller()
    texts = {"value": teller.text(value, type(value).__name__)}
    return Told(values=texts, roots=frozenset(teller.roots)).digest


@dataclass
class _Teller(Teller):
    """Tells functions and classes of no file by their code; each is told once."""

    _told: dict[int, tuple[int, object]] = field(default_factory=dict)

    def text(self, value: object, place: str) -> str:
        if isinstance(value, property):
            return f"property {self.text((value.fget, value.fset, value.fdel), place)}"
        try:
            return super().text(value, place)
        except DeclarationError:
            try:
                sent = hashlib.sha256(pickle.dumps(value)).hexdigest()
            except Exception:  # noqa: BLE001 (what an object raises that cannot travel)
                sent = ""
            return f"{type(value).__module__}.{type(value).__qualname__} {sent}"

    def _function(self, value: types.FunctionType, place: str) -> str:
        if value.__module__ != _SHELL:
            return super()._function(value, place)
        return self._once(
            value, place, (self._code_text(value.__code__, place), *self._held(value))
        )

    def _class(self, kind: type, place: str) -> str:
        if not any(one.__module__ == _SHELL for one in kind.__mro__):
            return super()._class(kind, place)
        parts: list[object] = []
        for one in kind.__mro__:
            if one.__module__ == _SHELL:
                parts += [(n, v) for n, v in sorted(vars(one).items()) if n not in _MADE]
            elif not is_library(one.__module__):
                parts.append(super()._class(one, place))
        return self._once(kind, place, parts)

    def _once(self, value: types.FunctionType | type, place: str, parts: Any) -> str:  # noqa: ANN401
        if id(value) in self._told:
            return f"that of {self._told[id(value)][0]}"
        self._told[id(value)] = (len(self._told), value)
        return f"<{value.__qualname__} {[self.text(part, place) for part in parts]}>"

    def _held(self, value: types.FunctionType) -> Iterator[object]:
        """Yield what a function names, encloses and takes where nothing is given."""
        known = value.__globals__
        for name in sorted(_named(value.__code__)):
            if name in known:
                yield name, known[name]
        yield [_content(cell) for cell in value.__closure__ or ()]
        yield value.__defaults__, value.__kwdefaults__
        yield vars(value)

    def _code_text(self, code: types.CodeType, place: str) -> str:
        constants = [
            self._code_text(held, place) if isinstance(held, types.CodeType)
            else self.text(held, place)
            for held in code.co_consts
        ]  # fmt: skip
        return f"{code.co_code.hex()} {code.co_names} {code.co_varnames} {constants}"


def _named(code: types.CodeType) -> set[str]:
    inner = (held for held in code.co_consts if isinstance(held, types.CodeType))
    return set(code.co_names).union(*(_named(each) for each in inner))


def _content(cell: types.CellType) -> object:
    try:
        return cell.cell_contents
    except ValueError:  # not bound yet
        return None
