"""What another master seed, or another version, does to the verdicts: two results side by side."""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from repro.judge.verdict import HELD, Verdict

Json = Mapping[str, Any]
Place = tuple[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Flip:
    """A number or claim whose verdict is another one in the second results.

    Of one that `depends` on a reading in either, neither says that it holds or is contradicted.
    """

    paper: str
    place: str
    first: str
    second: str
    depends: bool = False

    @property
    def opposite(self) -> bool:
        """Whether one says that the number holds, and the other that it is contradicted."""
        words = [text.split(",")[0] for text in (self.first, self.second)]
        return (
            not self.depends
            and Verdict.CONTRADICTED in words
            and any(word in HELD for word in words)
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class TwoResults:
    """How many verdicts were compared, and those that are not the same.

    `only_first` and `only_second` are (paper, place) of what one of the results alone speaks of.
    """

    compared: int
    repeats: tuple[int, int]
    flips: tuple[Flip, ...]
    only_first: tuple[Place, ...] = ()
    only_second: tuple[Place, ...] = ()

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
            "depending": sum(flip.depends for flip in self.flips),
            "changes": dict(Counter(f"{flip.first} → {flip.second}" for flip in self.flips)),
            "flips": [{**asdict(flip), "opposite": flip.opposite} for flip in self.flips],
            "only_first": [f"{paper}, {place}" for paper, place in self.only_first],
            "only_second": [f"{paper}, {place}" for paper, place in self.only_second],
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
        for which, places in (("first", self.only_first), ("second", self.only_second)):
            if places:
                lines.append(f"{len(places)} in the {which} results alone:")
                lines += [f"{paper}, {place}" for paper, place in places]
        return "\n".join(lines) + "\n"


def compare(first: Json, second: Json) -> TwoResults:
    """Return how the verdicts of two results.json differ on what both speak of.

    Where not the same readings were tried in both, on which verdicts turn, what the re-run says
    without them is compared.
    """
    alone = _tried(first) != _tried(second)
    ours, theirs = (dict(_verdicts(each, alone=alone)) for each in (first, second))
    depending = {
        place
        for each in (first, second)
        for place, verdict in _verdicts(each, alone=False)
        if verdict == Verdict.DEPENDS
    }
    flips = tuple(
        Flip(
            paper=paper,
            place=place,
            first=verdict,
            second=theirs[paper, place],
            depends=(paper, place) in depending,
        )
        for (paper, place), verdict in ours.items()
        if verdict != theirs.get((paper, place), verdict)
    )
    repeats = (first["provenance"]["repeats"], second["provenance"]["repeats"])
    return TwoResults(
        compared=len(ours.keys() & theirs.keys()),
        repeats=repeats,
        flips=flips,
        only_first=tuple(place for place in ours if place not in theirs),
        only_second=tuple(place for place in theirs if place not in ours),
    )


def _tried(results: Json) -> set[tuple[str, str]]:
    return {
        (paper["key"], outcome["reading"])
        for paper in results["papers"]
        for finding in paper["findings"]
        for outcome in finding.get("readings", ())
    }


def _verdicts(results: Json, *, alone: bool) -> Iterator[tuple[Place, str]]:
    for paper in results["papers"]:
        for finding in paper["findings"]:
            place = finding["claim"] or ", ".join(
                (finding["table"], finding["row"], finding["column"])
            )
            verdict, side = finding["verdict"], finding["side"]
            if alone and finding.get("as_run"):
                verdict, side = finding["as_run"], finding["as_run_side"]
            said = f"{verdict}, {side}" if side else verdict
            yield (paper["key"], f"{place} ({finding['where']})"), said
