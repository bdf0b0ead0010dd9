"""The engine: plans, runs, judges and shows re-runs of published papers; it knows no paper."""

from importlib import import_module
from typing import Any

_LATE = {
    "audit_table": "repro.commands.audit_table",
    "certify": "repro.commands.certify_problem",
    "compare": "repro.commands.compare_call",
    "load": "repro.commands.load",
}


def __getattr__(name: str) -> Any:  # noqa: ANN401 (whatever the name stands for)
    """Return what is loaded when it is first asked for, so that `import repro` stays light."""
    if name in _LATE:
        return getattr(import_module(_LATE[name]), name)
    message = f"module {__name__!r} has no attribute {name!r}"
    raise AttributeError(message)
