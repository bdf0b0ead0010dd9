"""The engine: plans, runs, judges and shows re-runs of published papers; it knows no paper."""

from typing import Any


def __getattr__(name: str) -> Any:  # noqa: ANN401 (whatever the name stands for)
    """Return what is loaded when it is first asked for, so that `import repro` stays light."""
    if name == "audit_table":
        from repro.commands.audit_table import audit_table  # noqa: PLC0415

        return audit_table
    if name == "certify":
        from repro.commands.certify_problem import certify  # noqa: PLC0415

        return certify
    message = f"module {__name__!r} has no attribute {name!r}"
    raise AttributeError(message)
