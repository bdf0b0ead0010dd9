"""Tasks as bytes, for the processes and machines that run them.

Compiled kernels travel by name: whoever unpacks them finds the machine code in its own cache,
where numba's own way would compile them anew. Nothing that is read back from disk is packed so.
"""

import io
import pickle
import sys
from dataclasses import fields
from importlib import import_module
from operator import attrgetter
from typing import Any

from numba.core.dispatcher import Dispatcher

from repro.runs.plan import Task
from repro.runs.run import Record


def pack(tasks: tuple[Task, ...]) -> bytes:
    """Return tasks as bytes; raises what pickle raises for a task that cannot travel."""
    buffer = io.BytesIO()
    _Pickler(buffer, protocol=pickle.HIGHEST_PROTOCOL).dump(tasks)
    return buffer.getvalue()


def unpack(payload: bytes) -> tuple[Task, ...]:
    """Return the tasks that were packed, by this version of the engine, in another process."""
    tasks: tuple[Task, ...] = pickle.loads(payload)  # noqa: S301 (from the driver, by pipe or TLS)
    return tasks


def stripped(record: Record) -> dict[str, Any]:
    """Return all of a record but its task, which the driver has."""
    return {
        field.name: getattr(record, field.name) for field in fields(record) if field.name != "task"
    }


class _Pickler(pickle.Pickler):
    def reducer_override(self, value: Any) -> Any:  # noqa: ANN401 (anything may be in a task)
        if isinstance(value, Dispatcher):
            module, name = value.py_func.__module__, value.py_func.__qualname__
            if getattr(sys.modules.get(module), name, None) is value:
                return _named, (module, name)
        return NotImplemented


def _named(module: str, name: str) -> Any:  # noqa: ANN401 (numba ships no types)
    return attrgetter(name)(import_module(module))
