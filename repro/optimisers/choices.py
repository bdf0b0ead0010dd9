"""Words that a parameter may hold, checked where the parameter is set."""

from dataclasses import fields
from typing import Any, Literal, get_args, get_origin

from repro.errors import InputError


def check_choices(declared: Any) -> None:  # noqa: ANN401 (any dataclass)
    """Raise InputError where a field of a Literal type holds none of its words."""
    for field in fields(declared):
        value = getattr(declared, field.name)
        if get_origin(field.type) is Literal and value not in get_args(field.type):
            words = ", ".join(map(repr, get_args(field.type)))
            message = f"{type(declared).__name__}: {field.name}={value!r} is none of {words}"
            raise InputError(message)
