"""A search that no module has: a function of a notebook's cell, sent to processes by its value."""

import hashlib
import pickle
import types
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from repro.determinism.held_values import SAID
from repro.errors import InputError
from repro.optimisers.search_forms import check_form
from repro.optimisers.users_search import Entrant, entrant, load

_PLAIN = (bool, int, float, complex, str, bytes, type(None))


@dataclass(frozen=True, slots=True, kw_only=True)
class HeldSearch(Entrant):
    """An entrant that is held as bytes; `source` is the digest of its code and what that names."""

    payload: bytes = field(metadata=SAID, repr=False)

    def found(self) -> Any:  # noqa: ANN401 (whatever the user wrote)
        """Return the search, made anew from its bytes."""
        return pickle.loads(self.payload)  # noqa: S301 (made by this call of the user's)


def entrant_of(search: Any, name: str) -> Entrant:  # noqa: ANN401 (whatever the user wrote)
    """Return what was given as an entrant: "module:object", an object of a module, or any other.

    Raises InputError for what is no search, and for what cannot be sent to a process.
    """
    if isinstance(search, str):
        return entrant(search)
    check_form(search, name)
    module, qualified = getattr(search, "__module__", ""), getattr(search, "__qualname__", "")
    if module and qualified and module != "__main__" and "<" not in qualified:
        place = f"{module}:{qualified}"
        if load(place) is search:
            return entrant(place)
    try:
        import cloudpickle  # noqa: PLC0415

        payload = cloudpickle.dumps(search)
    except ImportError:
        message = f"{name} stands in no module: to send it, pip install 'repro-whales[notebook]'"
        raise InputError(message) from None
    except Exception as error:  # noqa: BLE001 (what an object raises that cannot travel)
        message = f"{name} cannot be sent to a process: {error}"
        raise InputError(message) from None
    text = "\0".join(_texts(search, set()))
    return HeldSearch(place="", source=hashlib.sha256(text.encode()).hexdigest(), payload=payload)


def _texts(value: Any, seen: set[int]) -> Iterator[str]:  # noqa: ANN401
    """Yield what an object is: code with all that it names, plain values, fields."""
    if id(value) in seen:
        return
    seen.add(id(value))
    if isinstance(value, types.ModuleType):
        yield f"module {value.__name__}"
    elif isinstance(value, _PLAIN):
        yield repr(value)
    elif isinstance(value, np.ndarray):
        yield value.tobytes().hex()
    else:
        yield f"{type(value).__module__}.{type(value).__qualname__}"
        yield from _code(value.__code__) if isinstance(value, types.FunctionType) else ()
        for name, held in _parts(value):
            yield name
            yield from _texts(held, seen)


def _parts(value: Any) -> Iterator[tuple[str, Any]]:  # noqa: ANN401
    """Yield what an object holds, each part under its name."""
    if isinstance(value, types.FunctionType):
        known = value.__globals__
        yield from ((n, known[n]) for n in sorted(_named(value.__code__)) if n in known)
        yield from (("", cell.cell_contents) for cell in value.__closure__ or ())
        yield from (("", value.__defaults__), ("", value.__kwdefaults__))
    elif isinstance(value, tuple | list | set | frozenset):
        yield from (("", held) for held in value)
    elif isinstance(value, dict):
        yield from ((repr(key), held) for key, held in value.items())
    elif isinstance(value, type):
        own = value.__module__ == "__main__"
        yield from (pair for pair in sorted(vars(value).items()) if own and _is_written(pair[0]))
    else:
        yield ("", type(value))
        yield from sorted(getattr(value, "__dict__", {}).items())


def _is_written(name: str) -> bool:
    return not name.startswith("__") or name in ("__init__", "__call__")


def _code(code: types.CodeType) -> Iterator[str]:
    yield from (code.co_code.hex(), repr(code.co_names), repr(code.co_varnames))
    for held in code.co_consts:
        if isinstance(held, types.CodeType):
            yield from _code(held)
        else:
            yield repr(held)


def _named(code: types.CodeType) -> set[str]:
    inner = (held for held in code.co_consts if isinstance(held, types.CodeType))
    return set(code.co_names).union(*(_named(each) for each in inner))
