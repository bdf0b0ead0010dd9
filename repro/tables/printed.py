"""A number as it is printed: text, unit and rounding."""

import math
from dataclasses import dataclass

from repro.errors import DeclarationError
from repro.tables.numbers import NoNumber, NumberForm, number_form
from repro.tables.units import UNITS, is_same_unit

WORDS = "text"

_SHOWN = 60  # characters of a text in a message


@dataclass(frozen=True, slots=True)
class Printed:
    """A number as it stands on the page: the text is the datum, the value follows from it.

    A mark of significance may follow it, as in "0.002/+", and a unit, which is then the number's.
    """

    text: str
    unit: str = ""

    def __post_init__(self) -> None:
        """Raise DeclarationError for an unknown unit or a text that is no number."""
        if self.unit not in UNITS:
            raise DeclarationError(unknown_unit(self.text, self.unit))
        form = number_form(self.text)
        if isinstance(form, NoNumber):
            because = f": {form.because}" if form.because else ""
            message = f"{self.text[:_SHOWN]!r} is not a number{because}"
            raise DeclarationError(message)
        if not math.isfinite(form.value):
            message = f"{self.text!r} is greater than any double"
            raise DeclarationError(message)
        if form.unit and not self.unit:
            object.__setattr__(self, "unit", form.unit)
        elif form.unit and not is_same_unit(form.unit, self.unit):
            message = f"{self.text!r} is in {form.unit}, but its place says {self.unit}"
            raise DeclarationError(message)

    @property
    def value(self) -> float:
        """Value in the printed unit."""
        return self._form.value

    @property
    def rounding(self) -> float:
        """Half a unit of the last printed digit, in the printed unit; 0 for π/2 and for 4/30."""
        return self._form.rounding

    @property
    def mantissa(self) -> str:
        """Digits with sign and point, without the power of ten; empty for π/2 and for 4/30."""
        return self._form.mantissa

    @property
    def power(self) -> int | None:
        """Power of ten that is printed; None where there is none."""
        return self._form.power

    @property
    def mark(self) -> str:
        """What stands behind the number, such as "/+" or "†"; it says nothing of the value."""
        return self._form.mark

    @property
    def si(self) -> float:
        """Value in SI units."""
        return self.value * UNITS[self.unit]

    @property
    def _form(self) -> NumberForm:
        form = number_form(self.text)
        if isinstance(form, NoNumber):  # excluded when the number was made
            raise DeclarationError(self.text)
        return form


def unknown_unit(place: str, unit: str) -> str:
    """Return what is said of a unit that there is not."""
    return f"{place}: unknown unit {unit!r}; known: {', '.join(filter(None, UNITS))}, {WORDS}"
