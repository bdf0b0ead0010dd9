"""A search that no module has: a function of a notebook's cell, sent to processes by its value."""

import pickle
from dataclasses import dataclass, field
from typing import Any

from repro.determinism.held_values import SAID
from repro.determinism.unwritten_values import digest_of_unwritten
from repro.errors import InputError
from repro.optimisers.search_forms import check_form
from repro.optimisers.users_search import Entrant, entrant, load


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
    return HeldSearch(place="", source=digest_of_unwritten(search), payload=payload)
