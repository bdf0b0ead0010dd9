"""Printed ranks against the values that they rank, and their sums, means and places."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby

from repro.tables.facts import RankedRows, Ties
from repro.tables.relations import Cell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import Span, exact, shown, span

FEWEST = 3  # columns whose average ranks are summed
KINDS: tuple[Ties, ...] = ("least", "greatest", "mean", "dense", "order")


def ranking_rows(paper: str, ranking: RankedRows) -> Iterator[AuditRow]:
    """Yield a row per printed rank, sum, mean and place that no treatment of ties allows."""
    yield from _row_by_row(paper, ranking)
    if not ranking.values or not any(ranking.values):
        yield from _by_themselves(paper, ranking)
    for cells, runs in ((ranking.sums, 1), (ranking.means, _rows(ranking))):
        if cells is not None and runs:
            yield from _totals(paper, ranking, cells, runs)
    if ranking.means is not None and not _rows(ranking):
        yield from _means_by_themselves(paper, ranking.means)
    if ranking.places is not None and (ranking.means or ranking.sums):
        yield from _places(paper, ranking.places, ranking.means or ranking.sums or {})


def rank_span(value: Span, rivals: Sequence[Span], ties: Ties) -> Span:
    """Return every rank of a value among its rivals, itself one of them, by their least and most.

    What lies behind two prints that meet may be equal, or stand in either order.
    """
    lower = [rival for rival in rivals if rival.high < value.low]
    same = sum(rival.meets(value) for rival in rivals)
    first, last = 1 + len(lower), len(lower) + same
    surely_tied = all(
        not rival.meets(value) or rival.low == rival.high == value.low == value.high
        for rival in rivals
    )
    if ties in ("any", "dense"):
        first = 1 + _distinct(lower)
        last = first if ties == "dense" and surely_tied else last
    elif surely_tied and ties == "least":
        last = first
    elif surely_tied and ties == "greatest":
        first = last
    elif surely_tied and ties == "mean":
        return Span(Fraction(first + last, 2), Fraction(first + last, 2))
    return Span(Fraction(first), Fraction(last))


def _distinct(spans: Sequence[Span]) -> int:
    """Return how many different values stand behind the prints, at the least."""
    count, end = 0, None
    for each in sorted(spans, key=lambda each: each.high):
        if end is None or each.low > end:
            count, end = count + 1, each.high
    return count


def _rows(ranking: RankedRows) -> int:
    return len(ranking.ranks) or len(ranking.values)


def _spans(row: Mapping[str, Cell], ranking: RankedRows) -> dict[str, Span]:
    spans = {name: span(cell.printed) for name, cell in row.items()}
    if not ranking.greatest_first:
        return spans
    return {name: Span(-each.high, -each.low) for name, each in spans.items()}


def _row_by_row(paper: str, ranking: RankedRows) -> Iterator[AuditRow]:
    for values, ranks in zip(ranking.values, ranking.ranks, strict=False):
        spans = _spans(values, ranking)
        if not spans.keys() >= ranks.keys():
            continue
        kinds = KINDS if ranking.ties == "any" else (ranking.ties,)
        wrong = [_wrong(ranks, spans, kind) for kind in kinds]
        fewest = min(wrong, key=len)
        if not fewest:
            continue
        cells = [ranks[name] for name in fewest]
        found = "; ".join(
            f"{name} {values[name].printed.text} has rank "
            f"{_in_words(rank_span(spans[name], list(spans.values()), 'any'))}, printed "
            f"{ranks[name].printed.text}"
            for name in fewest
        )
        yield audit_row(
            paper,
            (*cells, *(values[name] for name in fewest)),
            check="rank",
            grade=Grade.INCONSISTENT,
            explanation=f"by the values of the row, whichever way ties are ranked: {found}",
        )


def _by_themselves(paper: str, ranking: RankedRows) -> Iterator[AuditRow]:
    """Check rows of ranks that are printed without values, where most rank just what they print."""
    kinds = KINDS if ranking.ties == "any" else (ranking.ties,)
    wrong = [
        row
        for row in ranking.ranks
        if not any(_is_ranking([exact(cell.printed.value) for cell in row.values()], kind)
                   for kind in kinds)
    ]  # fmt: skip
    for row in wrong if 3 * len(wrong) <= len(ranking.ranks) else ():
        cells = tuple(row.values())
        yield audit_row(
            paper,
            cells,
            check="ranks-of-a-row",
            grade=Grade.INCONSISTENT,
            explanation=(
                f"{', '.join(cell.printed.text for cell in cells)} are no ranks of {len(cells)}, "
                "whichever way ties are ranked"
            ),
        )


def _means_by_themselves(paper: str, means: Mapping[str, Cell]) -> Iterator[AuditRow]:
    """Check the sum of average ranks, which is that of the places where ties share theirs."""
    cells, count = tuple(means.values()), len(means)
    total = sum((span(cell.printed) for cell in cells), Span(Fraction(0), Fraction(0)))
    right = Fraction(count * (count + 1), 2)
    if count < FEWEST or total.low <= right <= total.high:
        return
    yield audit_row(
        paper,
        cells,
        check="rank-means",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{' + '.join(cell.printed.text for cell in cells)} = "
            f"{shown(sum(exact(cell.printed.value) for cell in cells))}; the average ranks of "
            f"{count} have the sum {shown(right)}"
        ),
        condition="just these are ranked, and ties share the mean of their places",
    )


def _is_ranking(ranks: Sequence[Fraction], ties: Ties) -> bool:
    """Say whether a whole row of ranks can be: by one treatment of ties."""
    place = 1
    for k, (rank, group) in enumerate(groupby(sorted(ranks)), 1):
        same = len(list(group))
        last = place + same - 1
        right = {
            "least": Fraction(place),
            "greatest": Fraction(last),
            "mean": Fraction(place + last, 2),
            "dense": Fraction(k),
        }.get(ties)
        if rank != (right if right is not None else place) or (ties == "order" and same > 1):
            return False
        place = last + 1
    return True


def _wrong(ranks: Mapping[str, Cell], spans: Mapping[str, Span], ties: Ties) -> list[str]:
    rivals = list(spans.values())
    return [
        name
        for name, cell in ranks.items()
        if not number_behind(cell).meets(rank_span(spans[name], rivals, ties))
    ]


def number_behind(cell: Cell) -> Span:
    """Return what can stand behind a rank or a sum of ranks: whole and half numbers are exact."""
    value = exact(cell.printed.value)
    return Span(value, value) if (2 * value).denominator == 1 else span(cell.printed)


def _totals(
    paper: str, ranking: RankedRows, cells: Mapping[str, Cell], runs: int
) -> Iterator[AuditRow]:
    """Check sums of ranks (`runs` 1) or means of them, by printed ranks or else by the values."""
    for name, cell in cells.items():
        possible = _sum(ranking, name)
        if possible is None:
            continue
        around = number_behind(cell) if runs == 1 else span(cell.printed)
        scaled = Span(around.low * runs, around.high * runs)
        if scaled.meets(possible):
            continue
        what = "sum" if runs == 1 else "mean"
        whose = "printed ranks" if ranking.ranks else "ranks by the printed values"
        yield audit_row(
            paper,
            (cell, *(row[name] for row in ranking.ranks)),
            check=f"rank-{what}",
            grade=Grade.INCONSISTENT,
            explanation=(
                f"the {_rows(ranking)} {whose} of {name} have the {what} "
                f"{_in_words(Span(possible.low / runs, possible.high / runs))}; printed is "
                f"{cell.printed.text}"
            ),
        )


def _sum(ranking: RankedRows, name: str) -> Span | None:
    """Return what the ranks of a column can add up to; None where a row has none."""
    if ranking.ranks:
        found = [number_behind(row[name]) for row in ranking.ranks if name in row]
        rows = len(ranking.ranks)
    else:
        rows = len(ranking.values)
        found = [
            rank_span(spans[name], list(spans.values()), ranking.ties)
            for spans in (_spans(row, ranking) for row in ranking.values)
            if name in spans
        ]
    return sum(found, Span(Fraction(0), Fraction(0))) if len(found) == rows else None


def _places(paper: str, places: Mapping[str, Cell], by: Mapping[str, Cell]) -> Iterator[AuditRow]:
    """Check the ranks of the sums or means against what is printed of these."""
    spans = {name: span(cell.printed) for name, cell in by.items() if name in places}
    for name, own in spans.items():
        possible = rank_span(own, list(spans.values()), "any")
        if not number_behind(places[name]).meets(possible):
            yield audit_row(
                paper,
                (places[name], by[name]),
                check="total-rank",
                grade=Grade.INCONSISTENT,
                explanation=(
                    f"{by[name].printed.text} of {name} has place {_in_words(possible)} among "
                    f"{', '.join(cell.printed.text for cell in by.values())}; printed is "
                    f"{places[name].printed.text}"
                ),
            )


def _in_words(ranks: Span) -> str:
    low, high = shown(ranks.low), shown(ranks.high)
    return low if low == high else f"{low} to {high} by the treatment of ties"
