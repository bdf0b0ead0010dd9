"""Units that numbers are printed in, and other ways to write them."""

import math

# Factors from the printed unit to SI. Percent stays percent: it is compared with percent.
UNITS = {
    "": 1.0,
    "%": 1.0,
    "rank": 1.0,
    "count": 1.0,
    "s": 1.0,
    "ms": 1e-3,
    "us": 1e-6,
    "µs": 1e-6,
    "ns": 1e-9,
    "min": 60.0,
    "h": 3600.0,
    "m": 1.0,
    "mm": 1e-3,
    "cm": 1e-2,
    "km": 1e3,
    "rad": 1.0,
    "rad/s": 1.0,
    "rad/s^2": 1.0,
    "rad/s^3": 1.0,
    "deg": math.pi / 180,
    "°": math.pi / 180,
    "deg/s": math.pi / 180,
    "°/s": math.pi / 180,
    "deg/s^2": math.pi / 180,
    "°/s^2": math.pi / 180,
    "deg/s^3": math.pi / 180,
    "°/s^3": math.pi / 180,
    "m/s": 1.0,
    "mm/s": 1e-3,
    "cm/s": 1e-2,
    "km/h": 1 / 3.6,
    "m/s^2": 1.0,
    "mm/s^2": 1e-3,
    "m/s^3": 1.0,
    "rpm": math.pi / 30,
    "g": 1e-3,
    "kg": 1.0,
    "N": 1.0,
    "kN": 1e3,
    "N·m": 1.0,
    "N·mm": 1e-3,
    "J": 1.0,
    "mJ": 1e-3,
    "kJ": 1e3,
    "W": 1.0,
    "mW": 1e-3,
    "kW": 1e3,
    "Wh": 3600.0,
    "V": 1.0,
    "A": 1.0,
    "Hz": 1.0,
    "kHz": 1e3,
    "K": 1.0,
    "Pa": 1.0,
    "kPa": 1e3,
    "MPa": 1e6,
}
_SPELLINGS = {
    "μs": "µs",
    "sec": "s",
    "secs": "s",
    "sec.": "s",
    "second": "s",
    "seconds": "s",
    "msec": "ms",
    "minute": "min",
    "minutes": "min",
    "mins": "min",
    "hr": "h",
    "hour": "h",
    "hours": "h",
    "degree": "deg",
    "degrees": "deg",
    "radian": "rad",
    "radians": "rad",
    "Nm": "N·m",
    "N.m": "N·m",
    "N*m": "N·m",
    "N m": "N·m",
    "N⋅m": "N·m",
    "percent": "%",
}


def known_unit(text: str) -> str | None:
    """Return the unit that a text writes, as `UNITS` calls it; None where it is none of them."""
    spelled = text.strip().replace("²", "^2").replace("³", "^3")
    spelled = _SPELLINGS.get(spelled, spelled)
    return spelled if spelled in UNITS else None


def is_same_unit(one: str, other: str) -> bool:
    """Say whether two names of units, both in `UNITS`, mean one unit."""
    return _plain(one) == _plain(other)


def _plain(unit: str) -> str:
    return unit.replace("°", "deg").replace("µ", "u")
