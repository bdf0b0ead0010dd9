"""What the speed of the engine was asked to be, beside what a run of the benchmarks found."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

Row = Mapping[str, str]
"""Cells of a table by the headings of their columns."""


class Measured(str):
    """A number as a table shows it, which knows what it was before it was rounded."""

    __slots__ = ("value",)
    value: float


def measured(value: float, form: str) -> Measured:
    """Return a number in a form of `format`, perhaps with a unit after it: ".1f", ".1f %"."""
    digits, _, unit = form.partition(" ")
    shown = Measured(f"{value:{digits}}{' ' if unit else ''}{unit}")
    shown.value = value
    return shown


def _value(cell: str) -> float:
    return cell.value if isinstance(cell, Measured) else float(cell.replace(",", "").rstrip(" %"))


@dataclass(frozen=True, slots=True, kw_only=True)
class Goal:
    """A bound on one column of a section, over the rows that hold all of `where`.

    `at_least` says on which side of the bound the numbers have to lie. `unless` leaves rows out.
    """

    says: str
    section: str
    column: str
    bound: float
    unit: str
    at_least: bool = False
    where: Row = field(default_factory=dict)
    unless: Row = field(default_factory=dict)

    @property
    def asked(self) -> str:
        """The bound as words."""
        return f"{'≥' if self.at_least else '≤'} {self.bound:,g}{self.unit}"

    def came_to(self, rows: list[Row]) -> str:
        """Return the range of what was measured, and whether all of it is on the right side."""
        found = [
            _value(row[self.column])
            for row in rows
            if self.where.items() <= row.items()
            and not any(row[name] == value for name, value in self.unless.items())
        ]
        if not found:
            return "not measured"
        least, most = min(found), max(found)
        met = least >= self.bound if self.at_least else most <= self.bound
        shown = f"{least:,g}" if least == most else f"{least:,g} to {most:,g}"
        return f"{shown}{self.unit}" if met else f"**missed**: {shown}{self.unit}"


_PEERS, _LIMIT = "Against other packages", "Against C"
_WHOLE, _CORES = "Whole calls", "Scaling and overhead"
_AUDIT, _RUNS = "Auditing a table", "All runs of the mission's papers"
_PAGES = "Pages of the committed depth"
_MISSION = "nox -s reproduce -- liang2026 mousa2023 smwoa2022 syji"
_WHALE = {"algorithm": "WOA", "function": "sphere"}
GOALS = (
    Goal(
        says="WOA on the sphere against mealpy's",
        section=_PEERS,
        where={"peer": "mealpy", **_WHALE},
        column="ours / peer",
        bound=600,
        unit=" ×",
        at_least=True,
    ),
    Goal(
        says="WOA on the sphere against EvoloPy's",
        section=_PEERS,
        where={"peer": "evolopy", **_WHALE},
        column="ours / peer",
        bound=2000,
        unit=" ×",
        at_least=True,
    ),
    Goal(
        says="time of any pair by that of the plain C loop",
        section=_LIMIT,
        column="ours / plain C `-O3`",
        bound=1,
        unit="",
    ),
    Goal(
        says="by that of `-Ofast` with libmvec, where sines, cosines and exponentials dominate",
        section=_LIMIT,
        unless={"function": "sphere"},
        column="ours / C `-Ofast` with libmvec",
        bound=2,
        unit="",
    ),
    Goal(
        says="parallel efficiency on 2 cores",
        section=_CORES,
        column="efficiency",
        bound=0.9,
        unit="",
        at_least=True,
    ),
    Goal(
        says="everything compiled from cold",
        section=_WHOLE,
        where={"call": "compiling everything, nothing else"},
        column="s",
        bound=30,
        unit=" s",
    ),
    Goal(
        says="`reproduce` with nothing to do",
        section=_WHOLE,
        where={"call": "nothing to do"},
        column="s",
        bound=2,
        unit=" s",
    ),
    Goal(
        says="`repro list`",
        section=_WHOLE,
        where={"call": "`list`"},
        column="s",
        bound=1,
        unit=" s",
    ),
    Goal(
        says="`repro audit KEY`",
        section=_WHOLE,
        where={"call": "`audit syji`"},
        column="s",
        bound=1,
        unit=" s",
    ),
    Goal(
        says="`import repro`",
        section=_WHOLE,
        where={"call": "`import repro`"},
        column="s",
        bound=0.2,
        unit=" s",
    ),
    Goal(
        says="`repro report` at the committed depth, nothing kept",
        section=_PAGES,
        where={"what": "nothing kept"},
        column="s",
        bound=8,
        unit=" s",
    ),
    Goal(
        says="the same where one paper changed",
        section=_PAGES,
        where={"what": "one paper changed"},
        column="s",
        bound=3,
        unit=" s",
    ),
    Goal(
        says="first pages, from cold",
        section=_WHOLE,
        where={"call": "cold"},
        column="s",
        bound=60,
        unit=" s",
    ),
    Goal(
        says="the bar's time left, from 10 % on",
        section="The time left",
        column="farthest off",
        bound=30,
        unit=" %",
    ),
    *(
        Goal(
            says=says,
            section="Whole sessions",
            where={"command": f"`{command}`"},
            column="s",
            bound=bound,
            unit=" s",
        )
        for says, command, bound in (
            ("`reproduce` of the mission's papers at 10 repeats", _MISSION, 240),
            ("the same at 20 repeats", f"{_MISSION} --repeats 20", 480),
            ("`nox -s tests`", "nox -s tests", 180),
            ("`.ci/run`", ".ci/run", 420),
            ("`nox -s bench`, installing not included", "nox -s bench", 600),
        )
    ),
    Goal(
        says="exponent of the time of planning, running, storing, judging and writing",
        section="Studies of many runs",
        column="exponent",
        bound=1,
        unit="",
    ),
    Goal(
        says="memory that a run more adds: 10^7 runs would take 100 MB",
        section="Studies of many runs",
        column="memory a run [B]",
        bound=10,
        unit=" B",
    ),
    Goal(
        says="runs of the mission's papers at 10 repeats",
        section=_RUNS,
        where={"repeats": "10"},
        column="on 2 cores [s]",
        bound=240,
        unit=" s",
    ),
    Goal(
        says="runs of the mission's papers at 20 repeats",
        section=_RUNS,
        where={"repeats": "20"},
        column="on 2 cores [s]",
        bound=480,
        unit=" s",
    ),
    Goal(
        says="share of baselines in them",
        section=_RUNS,
        column="baselines",
        bound=25,
        unit=" %",
    ),
    Goal(
        says="share of deepened readings",
        section=_RUNS,
        where={"repeats": "10"},
        column="deepened",
        bound=25,
        unit=" %",
    ),
    Goal(
        says="the engine's own part of a run",
        section=_CORES,
        column="overhead on 1 worker",
        bound=5,
        unit=" %",
    ),
    Goal(
        says="a table of 2,000 blocks",
        section=_AUDIT,
        where={"what": "2,000 blocks"},
        column="s",
        bound=5,
        unit=" s",
    ),
    Goal(
        says="the same where n is not told",
        section=_AUDIT,
        where={"what": "2,000 blocks, n not told"},
        column="s",
        bound=5,
        unit=" s",
    ),
    Goal(
        says="start-up of `repro audit FILE`",
        section=_AUDIT,
        where={"what": "`repro audit FILE`, two blocks"},
        column="s",
        bound=1.5,
        unit=" s",
    ),
    Goal(
        says="the page of the manual, from load to rows",
        section=_AUDIT,
        where={"what": "the page of the manual, from load to rows"},
        column="s",
        bound=10,
        unit=" s",
    ),
)


def held_against(measured: Mapping[str, list[Row]]) -> Iterator[tuple[str, str, str]]:
    """Yield every goal, what it asks, and what the rows of the sections by title came to."""
    for goal in GOALS:
        yield goal.says, goal.asked, goal.came_to(measured.get(goal.section, []))
