"""The tests of hypotheses that a table from anywhere prints: p with z, r and the decision."""

from collections.abc import Iterator, Mapping, Sequence

from repro.tables.audit_options import AuditOptions
from repro.tables.facts import Decision
from repro.tables.gathered import Entry
from repro.tables.levels import USUAL, Level
from repro.tables.relations import RankTest

_TESTS: Mapping[str, RankTest] = {"ranksum": "rank-sum", "signedrank": "signed-rank"}
_BESIDE = ("z", "r", "h")


def decisions_of(
    found: Mapping[str, Sequence[Entry]], options: AuditOptions, level: Level, runs: int | None
) -> Iterator[Decision]:
    """Yield each p with what stands beside it."""
    ps = found["p-value"]
    beside = {name: _partners(ps, found[name]) for name in _BESIDE}
    for entry in ps:
        place = entry.i, entry.j
        z, r, h = (beside[name].get(place) for name in _BESIDE)
        decides = _rejects(entry, h) if level.alpha is not None else None
        yield Decision(
            p=entry.number,
            z=z.number if z else None,
            r=r.number if r else None,
            rejects=decides,
            decided=h.number if h and decides is not None else None,
            sides=level.sides,
            test=_TESTS.get(options.test or ""),
            n=runs,
            alpha=level.alpha or USUAL,
        )


def _partners(ps: Sequence[Entry], others: Sequence[Entry]) -> dict[tuple[int, int], Entry]:
    """Return what belongs to each p: the one of its problem and algorithm, or of its place.

    Several p of one line are each followed, or each preceded, by what belongs to them.
    """
    found: dict[tuple[int, int], Entry] = {}
    for p in ps:
        own = [e for e in others if (e.problem, e.algorithm) == (p.problem, p.algorithm)]
        twins = [e for e in ps if (e.problem, e.algorithm) == (p.problem, p.algorithm)]
        if len(own) == 1 == len(twins):
            found[p.i, p.j] = own[0]
    for i in {p.i for p in ps}:
        found |= _in_order([e for e in ps if e.i == i], [e for e in others if e.i == i], found)
    for j in {p.j for p in ps}:
        found |= _in_order([e for e in ps if e.j == j], [e for e in others if e.j == j], found)
    return found


def _in_order(
    ps: Sequence[Entry], others: Sequence[Entry], found: Mapping[tuple[int, int], Entry]
) -> dict[tuple[int, int], Entry]:
    if len(ps) != len(others) or any((p.i, p.j) in found for p in ps):
        return {}
    return {(p.i, p.j): other for p, other in zip(ps, others, strict=True)}


def _rejects(p: Entry, h: Entry | None) -> bool | None:
    """Return the decision by h, else by the mark at p; None where there is neither."""
    if h is not None:
        said = h.number.printed.value
        return bool(abs(said)) if said in {-1.0, 0.0, 1.0} else None
    mark = p.number.printed.mark.strip("/() ")
    if mark in {"=", "≈", "~"}:
        return False
    return True if mark in {"+", "-"} else None
