"""The machine that a paper names, as its maker's or its maintainers' description gives it."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.tables.published import PublishedTable

Vector = NDArray[np.float64]
RANGES, SPEED, ACCELERATION = ("least", "greatest"), "speed", "acceleration"
LINKS = ("a", "α", "d")


@dataclass(frozen=True, slots=True, kw_only=True)
class NamedRobot:
    """A machine that stands beside a printed arm; the runs never use its numbers.

    `axes` has a row for each joint and the columns least and greatest (angles), speed and, where
    the source gives it, acceleration; `links` the columns a, α and d of the standard
    Denavit-Hartenberg convention, from the floor that the machine stands on to its flange. The
    label of each table says where it is from. An axis reads `signs` times what the joint's angle
    exceeds `zeros` (rad) by; where an entry of `zeros` is None it is not known, and only the
    length of the way that the joint goes is compared.
    """

    name: str
    axes: PublishedTable
    links: PublishedTable | None = None
    zeros: tuple[float | None, ...] = ()
    signs: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        """Raise DeclarationError for tables that lack a column, or disagree on the joints."""
        for fault in self._faults():
            message = f"robot {self.name!r}: {fault}"
            raise DeclarationError(message)

    def _faults(self) -> Iterator[str]:
        if not isinstance(self.name, str) or not self.name:
            yield "its name must be a text"
        yield from _missing(self.axes, (*RANGES, SPEED))
        if self.links is not None:
            yield from _missing(self.links, LINKS)
            if len(self.links.row_names) != self.joints:
                yield (
                    f"{self.links.label} has {len(self.links.row_names)} rows and "
                    f"{self.axes.label} {self.joints}"
                )
        for name, given in (("zeros", self.zeros), ("signs", self.signs)):
            if given and len(given) != self.joints:
                yield f"{name} has {len(given)} entries for {self.joints} joints"
        if any(sign not in (-1, 1) for sign in self.signs):
            yield f"signs are 1 or -1, not {self.signs}"
        for axis in self.axes.row_names:
            least, greatest = (self.axes[axis, column].si for column in RANGES)
            if not least < greatest:
                yield f"{self.axes.label}: axis {axis} goes from {least:.4g} to {greatest:.4g} rad"

    @property
    def source(self) -> str:
        """Where its ranges and speeds are from."""
        return self.axes.where

    @property
    def links_source(self) -> str:
        """Where its links are from, empty where none are given."""
        return self.links.where if self.links else ""

    @property
    def joints(self) -> int:
        """How many axes it has."""
        return len(self.axes.row_names)

    @property
    def ranges(self) -> Vector:
        """Least and greatest angle of each axis, shape (joints, 2), in rad."""
        return np.array([self.axes.column(name) for name in RANGES]).T

    def limit(self, derivative: int) -> tuple[float, ...] | None:
        """Return each axis's greatest speed (1) or acceleration (2), SI; None where not given."""
        column = {1: SPEED, 2: ACCELERATION}.get(derivative)
        return self.axes.column(column) if column in self.axes.column_names else None

    def reads(self, joint: int, angles: Vector) -> Vector | None:
        """Return what an axis (from 0) reads at joint angles, in rad; None where not known."""
        zero = self.zeros[joint] if self.zeros else None
        if zero is None:
            return None
        return np.asarray((angles - zero) * (self.signs[joint] if self.signs else 1))

    def outside(self, *postures: tuple[float, ...]) -> int:
        """Return how many axes are out of their range in any of some postures of the axes, rad."""
        angles = np.array(postures)
        least, greatest = self.ranges.T
        return int(((angles < least) | (angles > greatest)).any(axis=0).sum())


def _missing(table: PublishedTable, columns: tuple[str, ...]) -> Iterator[str]:
    if not isinstance(table, PublishedTable):
        yield f"{table!r:.60} is no PublishedTable"
        return
    for column in columns:
        if column not in table.column_names:
            there = ", ".join(table.column_names)
            yield f"{table.label} has no column {column!r}; there is {there}"
