"""What is wrong in print, and what is missing."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Erratum:
    """A place where the print cannot be meant: what it says, what is used, and why."""

    where: str
    printed: str
    used: str
    because: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Gap:
    """A result that cannot be re-run from the paper, and what is missing.

    One that is about no `result` is shown, and counted nowhere.
    """

    what: str
    where: str
    because: str
    result: bool = True
