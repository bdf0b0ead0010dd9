"""What another master seed does to the verdicts: two results of the same papers side by side."""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from repro.errors import InputError
from repro.judge.verdict import HELD, Verdict

Json = Mapping[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Flip:
    """A number or claim whose verdict is another one in the second results."""

    paper: str
    place: str
    first: str
    second: str

    @property
    def opposite(self) -> bool:
        """Whether one says that the number holds, and the other that it is contradicted."""
        words = [text.split(",")[0] for text in (self.first, self.second)]
        return Verdict.CONTRADICTED in words and any(word in HELD for word in words)


@dataclass(frozen=True, slots=True, kw_only=True)
class TwoResults:
    """How many verdicts were compared, and those that are not the same."""

    compared: int
    repeats: tuple[int, int]
    flips: tuple[Flip, ...]

    @property
    def opposite(self) -> tuple[Flip, ...]:
        """The verdicts that turned into their opposite."""
        return tuple(flip for flip in self.flips if flip.opposite)

    def as_json(self) -> dict[str, Any]:
        """Return what programs read."""
        return {
            "compared": self.compared,
            "repeats": list(self.repeats),
            "same": self.compared - len(self.flips),
            "opposite": len(self.opposite),
            "changes": dict(Counter(f"{flip.first} → {flip.second}" for flip in self.flips)),
            "flips": [{**asdict(flip), "opposite": flip.opposite} for flip in self.flips],
        }

    def as_text(self) -> str:
        """Return what a person reads."""
        same = self.compared - len(self.flips)
        first = (
            f"{self.compared} verdicts compared: {same} the same, {len(self.flips)} changed, "
            f"{len(self.opposite)} of them into their opposite"
        )
        lines = [first]
        lines += [f"{f.paper}, {f.place}: {f.first} → {f.second}" for f in self.flips]
        return "\n".join(lines) + "\n"


def compare(first: Json, second: Json) -> TwoResults:
    """Return how the verdicts of two results.json differ.

    Raises InputError where they do not speak of the same numbers.
    """
    ours, theirs = dict(_verdicts(first)), dict(_verdicts(second))
    if ours.keys() != theirs.keys():
        odd = sorted(ours.keys() ^ theirs.keys())
        message = f"the results do not speak of the same numbers: {odd[0]} is in one of them only"
        raise InputError(message)
    flips = tuple(
        Flip(paper=paper, place=place, first=verdict, second=theirs[paper, place])
        for (paper, place), verdict in ours.items()
        if verdict != theirs[paper, place]
    )
    repeats = (first["provenance"]["repeats"], second["provenance"]["repeats"])
    return TwoResults(compared=len(ours), repeats=repeats, flips=flips)


def _verdicts(results: Json) -> Iterator[tuple[tuple[str, str], str]]:
    for paper in results["papers"]:
        for finding in paper["findings"]:
            place = finding["claim"] or ", ".join(
                (finding["table"], finding["row"], finding["column"])
            )
            side = f", {finding['side']}" if finding["side"] else ""
            yield (paper["key"], f"{place} ({finding['where']})"), finding["verdict"] + side
