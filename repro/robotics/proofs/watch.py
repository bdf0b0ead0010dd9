"""How long a search for a proof may take, by a clock that is passed in, and whom it tells."""

from collections.abc import Callable
from dataclasses import dataclass, replace


def _silent(_lower: float, _attained: float) -> None:
    """Tell nobody."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Watch:
    """A search is over when `clock` shows `until`, both in s.

    `tell` is called now and then with the bound proved so far and the time of the best motion so
    far, in s.
    """

    clock: Callable[[], float]
    until: float
    tell: Callable[[float, float], None] = _silent

    @property
    def over(self) -> bool:
        """Whether no time is left."""
        return self.clock() >= self.until

    def scaled(self, seconds: float) -> "Watch":
        """Return the watch of a search whose unit of time is so many seconds."""

        def tell(lower: float, attained: float) -> None:
            self.tell(lower * seconds, attained * seconds)

        return replace(self, tell=tell)


ENDLESS = Watch(clock=float, until=1.0)
"""The clock of this one stands still at 0."""
