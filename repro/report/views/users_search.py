"""What the private report shows of a user's search beside the others."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from repro.judge.beside_baselines import ProblemStandings
from repro.judge.users_search import UsersSearch, UsersTest, mean_against_chance
from repro.report.views.baselines import StandingsView, standings_view
from repro.report.words import number
from repro.tables.published import Printed

Texts = tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class UsersSearchView:
    """The user's search in one experiment: standings, places among the printed, and tests.

    Where there are `several` searches, each row of the last two names its own behind the problem.
    """

    standings: StandingsView
    printed: tuple[Texts, ...]
    tests: tuple[Texts, ...]
    several: bool


def users_search_view(found: UsersSearch) -> UsersSearchView:
    """Return where the search stands, in words."""
    problems = found.standings.problems
    several = max(len(_owns(standing)) for standing in problems) > 1
    printed = [
        (name, _printed(found.printed[standing.problem], standing, name))
        for standing in problems
        for name in _owns(standing)
    ]
    tests = [(test.own.algorithm, _test(test)) for test in found.tests]
    return UsersSearchView(
        standings=standings_view(found.standings, seconds=True),
        printed=_named(printed) if several else tuple(row for _, row in printed),
        tests=_named(tests) if several else tuple(row for _, row in tests),
        several=several,
    )


def _named(rows: Iterable[tuple[str, Texts]]) -> tuple[Texts, ...]:
    return tuple((problem, name, *rest) for name, (problem, *rest) in rows)


def _owns(standing: ProblemStandings) -> tuple[str, ...]:
    """Return the searches of the user's own that have runs; one without a name where none has."""
    return tuple(row.algorithm for row in standing.rows if row.kind == "yours") or ("",)


def _printed(printed: Mapping[str, Printed], standing: ProblemStandings, name: str) -> Texts:
    """Return problem, printed means, the search's own mean, and its place among them."""
    rows = (row for row in standing.rows if (row.algorithm, row.kind) == (name, "yours"))
    own = next(rows, None)
    texts = "; ".join(f"{name} {p.text} {p.unit}".strip() for name, p in printed.items())
    if own is None or not printed:
        return standing.problem, texts or "none", "–" if own is None else number(own.mean), "–"
    place = 1 + sum(p.si < own.mean for p in printed.values())
    return standing.problem, texts, number(own.mean), f"{place} of {len(printed) + 1}"


def _test(test: UsersTest) -> Texts:
    return (
        test.problem,
        test.other.algorithm,
        test.other.kind,
        number(test.own.mean),
        number(test.other.mean),
        number(test.p),
        number(test.holm),
        f"{test.wins:.2f}" + (", against the mean" if mean_against_chance(test) else ""),
    )
