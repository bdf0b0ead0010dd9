"""Bad inputs, each with its exit code or exception and what is said of it."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from repro.errors import StoreError
from repro.functions import FUNCTIONS
from repro.model.claims import Sentence
from repro.model.open_points import Gap
from repro.model.paper import MotionReading
from repro.model.tolerances import Percent
from repro.optimisers import DBO, DE, GA, GSA, GWO, PSO, WOA, HybridWOA, SteadyStateGA
from repro.robotics.path_fitting import PathFitting
from repro.robotics.polynomials import quintic
from repro.robotics.rest_to_rest import MinimumTime
from repro.runs.plan import plan
from repro.runs.verify import verify
from repro.runs.workers.dask_cluster import cluster
from repro.runs.workers.local import checked_workers
from repro.statistics.summary import standard_deviation
from repro.tables.published import Printed, PublishedTable
from repro.tables.relations import TableCell
from tests.small_papers import CLAIMS, EXPERIMENT, PAPER, TABLE, Bowl, evidence
from tests.small_stores import TASKS, change, filled

SPHERE = FUNCTIONS["sphere"]
PROBLEM = SPHERE.problem(3)
RNG = np.random.default_rng(1)

COMMANDS: dict[str, tuple[tuple[str, ...], int, str]] = {
    "unknown paper": (("list", "nobody"), 2, "unknown paper 'nobody'; known: small2020"),
    "hostile key": (("audit", "\x1b[2J"), 2, r"unknown paper '\x1b[2J'; known"),
    "no such path": (("certify", "../papers"), 2, "../papers: there is no such file or folder"),
    "no repeats": (("reproduce", "--repeats", "0"), 2, "repeats is 0; it must be 1 or more"),
    "negative repeats": (("list", "--repeats", "-7"), 2, "repeats is -7"),
    "no workers": (("reproduce", "--workers", "0"), 2, "workers is 0; it must be 1 or more"),
    "negative workers": (("reproduce", "--workers", "-1"), 2, "workers is -1"),
    "file as store": (("reproduce", "--store", "file"), 2, "the store folder file cannot be used"),
    "file as store, report": (("report", "--store", "file"), 2, "cannot be used: it is a file"),
    "file as store, list": (("list", "--store", "file"), 2, "cannot be used: it is a file"),
    "file as store, verify": (("verify", "file"), 2, "cannot be used: it is a file"),
    "below a file": (("reproduce", "--store", "file/x"), 2, "cannot be used: Not a directory"),
    "file as reports": (("reproduce", "--reports", "file"), 2, "the reports folder file cannot be"),
    "no such store": (("verify", "nowhere"), 2, "there is no store in nowhere"),
    "no such store, report": (("report", "--store", "nowhere"), 2, "there is no store in nowhere"),
    "empty sample": (("verify", "--sample", "0"), 2, "sample is 0; it must be 1 or more"),
    "foreign store, report": (("report", "--store", "foreign"), 3, "runs.sqlite is damaged"),
    "foreign store, list": (("list", "--store", "foreign"), 3, "runs.sqlite is damaged"),
    "foreign store, verify": (("verify", "foreign"), 3, "`repro reproduce` sets it aside"),
    "newer store, reproduce": (("reproduce", "--store", "newer"), 3, "newer than 2: update repro"),
    "newer store, list": (("list", "--store", "newer"), 3, "newer than 2: update repro"),
    "damaged row, report": (("report", "--store", "harmed"), 3, "guess/1/2 is damaged; `repro re"),
    "damaged row, verify": (("verify", "harmed"), 3, "1 rows are damaged; `repro reproduce`"),
    "folder as database": (("report", "--store", "hollow"), 2, "cannot be used as a store"),
}
USAGES: dict[str, tuple[tuple[str, ...], str]] = {
    "no command": ((), "the following arguments are required: COMMAND"),
    "unknown command": (("undo",), "invalid choice: 'undo'"),
    "words for a number": (("list", "--repeats", "few"), "invalid int value: 'few'"),
    "a fraction of a worker": (("reproduce", "--workers", "1.5"), "invalid int value: '1.5'"),
    "unknown option": (("audit", "--force"), "unrecognized arguments: --force"),
    "option of another command": (("audit", "--repeats", "2"), "usage: repro audit"),
    "option without value": (("report", "--store"), "expected one argument"),
    "two stores": (("verify", "one", "two"), "unrecognized arguments: two"),
    "sample of words": (("verify", "--sample", "all"), "invalid int value: 'all'"),
}
HEAD = "Table 1, p. 3\n"
MOTION: dict[str, Any] = {
    "waypoints": ((0.0,), (1.0,)),
    "law": quintic,
    "velocity": (1.0,),
    "acceleration": (1.0,),
    "durations": (0.1, 9.0),
}
PATH: dict[str, Any] = {
    "start": 0.0,
    "end": 1.0,
    "law": quintic,
    "duration": 1.0,
    "intervals": 9,
    "box": ((-1.0, 1.0),) * 3,
}


def motion(**changed: Any) -> MinimumTime:  # noqa: ANN401
    return MinimumTime(**(MOTION | changed))


def paper(**changed: Any) -> object:  # noqa: ANN401
    return replace(PAPER, **changed)


DECLARATIONS: dict[str, tuple[Callable[[], object], str]] = {
    "no number": (lambda: Printed("4,7"), "'4,7' is not a number"),
    "empty number": (lambda: Printed(""), "'' is not a number"),
    "infinite": (lambda: Printed("1e999"), "'1e999' is greater than any double"),
    "minus infinite": (lambda: Printed("-9e400"), "is greater than any double"),
    "the word nan": (lambda: Printed("nan"), "'nan' is not a number"),
    "the word inf": (lambda: Printed("inf"), "'inf' is not a number"),
    "endless digits": (lambda: Printed("1e" + "9" * 9999), "is not a number"),
    "over nothing": (lambda: Printed("π/0"), "'π/0' is not a number"),
    "two points": (lambda: Printed("1.2.3"), "'1.2.3' is not a number"),
    "unknown unit": (
        lambda: Printed("1", "furlong"),
        "unknown unit 'furlong'; known: %, rank, count, s",
    ),
    "no table": (lambda: PublishedTable.read("Table 1"), "is no table: it needs its place"),
    "no bar": (lambda: PublishedTable.read(f"{HEAD}a | b\n1 2"), "no '|' in the line '1 2'"),
    "too many cells": (
        lambda: PublishedTable.read(f"{HEAD}a | b\nx | 1 | 2"),
        "row 'x': 1 + 2 cel",
    ),
    "words in a cell": (
        lambda: PublishedTable.read(f"{HEAD}a | b\nx | few"),
        "row 'x': 'few' is no",
    ),
    "bad heading": (
        lambda: PublishedTable.read(f"{HEAD}a | b]\nx | 1"),
        "heading 'b]' is not 'nam",
    ),
    "bad unit": (lambda: PublishedTable.read(f"{HEAD}a | b [ell]\nx | 1"), "unknown unit 'ell'"),
    "blank first row": (
        lambda: PublishedTable.read(f"{HEAD}a | b\n | 1"),
        "none above it to repeat",
    ),
    "row twice": (
        lambda: PublishedTable.read(f"{HEAD}a | b\nx | 1\nx | 2"),
        "'x' stands there twice",
    ),
    "column twice": (
        lambda: PublishedTable.read(f"{HEAD}a | b | b\nx | 1 | 2"),
        "'b' stands there t",
    ),
    "no such row": (lambda: TABLE["bowl best", "guess"], "Table 1 has no row 'bowl best'; it has"),
    "no such column": (lambda: TABLE["bowl mean", "luck"], "Table 1 has no column 'luck'; it has"),
    "no such cell": (lambda: TableCell(table=TABLE, row="x", column="y"), "has no row 'x'"),
    "slash in a name": (lambda: paper(experiments=(replace(EXPERIMENT, name="a/b"),)), "no '/'"),
    "two of one name": (
        lambda: paper(experiments=(EXPERIMENT,) * 2),
        "no two experiments share one",
    ),
    "unclaimed cell": (lambda: paper(claims=CLAIMS[1:]), "cell (bowl mean, guess) has no claim"),
    "cell claimed twice": (lambda: paper(claims=(*CLAIMS, CLAIMS[0])), "has 2 claims"),
    "runs of nothing": (lambda: paper(experiments=()), "no experiment 'search'; there is none"),
    "reading of nothing": (
        lambda: paper(
            motion_readings=(MotionReading(name="r", of=("no", "where"), problem=Bowl()),)
        ),
        "no problem no/where; problems: search/bowl",
    ),
    "claim without measure or gap": (
        lambda: Sentence(
            claim="c", where="p", printed=Printed("1"), measure=None, accepted=Percent(1)
        ),
        "needs either a measure or a Gap",
    ),
    "claim with measure and gap": (
        lambda: Sentence(
            claim="c",
            where="p",
            printed=Printed("1"),
            measure=CLAIMS[0].measure,
            accepted=Percent(1),
            gap=Gap(what="w", where="p", because="b"),
        ),
        "needs either a measure or a Gap",
    ),
    "one waypoint": (lambda: motion(waypoints=((0.0,),)), "a motion needs two or more, not 1"),
    "joints disagree": (
        lambda: motion(velocity=(1.0, 2.0)),
        "number of joints: waypoints have 1, velocity has 2",
    ),
    "endless waypoint": (lambda: motion(waypoints=((0.0,), (np.inf,))), "must be finite angles"),
    "limit of zero": (lambda: motion(velocity=(0.0,)), "limits must be above 0 and finite"),
    "negative limit": (lambda: motion(acceleration=(-1.0,)), "limits must be above 0 and finite"),
    "limit that is no number": (lambda: motion(jerk=(np.nan,)), "limits must be above 0"),
    "durations reversed": (lambda: motion(durations=(9.0, 0.1)), "must be 0 < shortest <= longest"),
    "duration of zero": (lambda: motion(durations=(0.0, 1.0)), "must be 0 < shortest <= longest"),
    "endless duration": (
        lambda: motion(durations=(0.1, np.inf)),
        "must be 0 < shortest <= longest",
    ),
    "negative penalty": (lambda: motion(penalties=(-1.0, 0.0, 0.0)), "must be 0 or more"),
    "negative weight": (lambda: motion(weight=-1.0), "weight -1.0 and penalties"),
    "path in no time": (lambda: PathFitting(**(PATH | {"duration": 0.0})), "must be above 0"),
    "path of few instants": (
        lambda: PathFitting(**(PATH | {"intervals": 1})),
        "at least the 3 coeff",
    ),
    "path in a reversed box": (
        lambda: PathFitting(**(PATH | {"box": ((1.0, -1.0),)})),
        "one pair lower <= upper per coefficient",
    ),
    "unknown quantity": (
        lambda: evidence(guess=[[1.0]]).values(("search", "bowl", "guess"), "speed"),
        "no quantity 'speed', only the cost",
    ),
}


def minimised(optimiser: Any, problem: Any = PROBLEM, **budget: Any) -> object:  # noqa: ANN401
    return optimiser.minimise(problem, **({"population": 30, "rng": RNG} | budget))


class Boxed:
    """A problem with bounds of one's own."""

    def __init__(self, *bounds: tuple[float, ...]) -> None:
        """Keep the bounds."""
        self.bounds = np.array(bounds)
        self.kernel, self.data, self.identity = PROBLEM.kernel, PROBLEM.data, ()


API: dict[str, tuple[Callable[[], object], str]] = {
    "matrix as point": (lambda: SPHERE(np.zeros((2, 2))), "not an array of (2, 2)"),
    "empty point": (lambda: SPHERE(np.zeros(0)), "dimension 0 is impossible"),
    "no dimension": (SPHERE.problem, "give dimension=30, say"),
    "negative dimension": (lambda: SPHERE.problem(-1), "dimension -1 is impossible"),
    "another dimension": (lambda: FUNCTIONS["branin"].problem(3), "it may be 2"),
    "no budget": (lambda: minimised(WOA()), "give either iterations or evaluations"),
    "two budgets": (lambda: minimised(WOA(), iterations=1, evaluations=30), "not both or neither"),
    "no iteration": (lambda: minimised(WOA(), iterations=0), "pay for no iteration"),
    "negative iterations": (lambda: minimised(GWO(), iterations=-3), "pay for no iteration"),
    "few evaluations": (lambda: minimised(DE(), evaluations=31), "one costs 30 evaluations"),
    "no population": (lambda: minimised(PSO(), population=0, iterations=1), "0 is too small"),
    "few agents, DE": (lambda: minimised(DE(), population=3, iterations=1), "needs 4 or more"),
    "few agents, DBO": (lambda: minimised(DBO(), population=19, iterations=1), "needs 20 or more"),
    "few agents, GA": (lambda: minimised(GA(), population=2, iterations=1), "needs 3 or more"),
    "bounds reversed": (lambda: minimised(WOA(), Boxed((1.0, 0.0)), iterations=1), "be finite"),
    "bounds endless": (lambda: minimised(WOA(), Boxed((0.0, np.inf)), iterations=1), "finite"),
    "bounds that are no number": (
        lambda: minimised(WOA(), Boxed((np.nan, 1.0)), iterations=1), "bounds must be finite pairs"
    ),
    "no bounds": (lambda: minimised(WOA(), Boxed(), iterations=1), "bounds must be finite pairs"),
    "three bounds": (lambda: minimised(WOA(), Boxed((0, 1, 2)), iterations=1), "of shape (n, 2)"),
    "crossover above 1": (lambda: DE(crossover=1.5), "crossover=1.5 is a chance"),
    "negative rate": (lambda: GA(mutation=-0.1), "mutation=-0.1 is a rate"),
    "negative elites": (lambda: GA(elites=-1), "elites=-1 is impossible"),
    "rate that is no number": (lambda: SteadyStateGA(crossover=np.nan), "crossover=nan is a rate"),
    "share above 1": (lambda: DBO(producers=2), "producers=2 is a share"),
    "percentage above 100": (lambda: GSA(final_percent=101), "final_percent=101 is impossible"),
    "unknown word": (lambda: GSA(bounds="bounce"), "bounce"),  # type: ignore[arg-type]
    "unknown word, PSO": (lambda: PSO(clip="none"), "none"),  # type: ignore[arg-type]
    "unknown start": (lambda: HybridWOA(start="chaos"), "chaos"),  # type: ignore[arg-type]
    "no repeats": (lambda: plan([PAPER], 0), "repeats is 0; it must be 1 or more"),
    "no workers": (lambda: checked_workers(0), "workers is 0; it must be 1 or more"),
    "no scheduler": (lambda: cluster("nowhere").__enter__(), "distributed|scheduler|address"),
    "spread of one run": (lambda: standard_deviation(np.ones((3, 1))), "needs two runs or more"),
    "impossible sample": (
        lambda: verify(Path(), TASKS, sample=-1, seed="", here={}), "sample is -1; it must be 1"
    ),
}  # fmt: skip


def rewritten(statement: str) -> Callable[[Path], object]:
    return lambda folder: change(filled(folder), statement)


def bytes_in(name: str, text: bytes) -> Callable[[Path], object]:
    def write(folder: Path) -> None:
        filled(folder)
        (folder / name).write_bytes(text)

    return write


STORES: dict[str, tuple[Callable[[Path], object], type[Exception], str]] = {
    "newer": (rewritten("pragma user_version = 3"), StoreError, "has schema 3, newer than 2"),
    "much newer": (rewritten("pragma user_version = 2147483647"), StoreError, "newer than 2"),
    "before the first": (rewritten("pragma user_version = -1"), StoreError, "it has schema -1"),
    "without a schema": (rewritten("pragma user_version = 0"), StoreError, "it has schema 0"),
    "another mark": (rewritten("pragma application_id = 1"), StoreError, "is not a store of repro"),
    "no runs": (rewritten("drop table run"), StoreError, "no such table: run"),
    "no curves": (rewritten("drop table curve"), StoreError, "no such table"),
    "no environments": (rewritten("drop table env"), StoreError, "no such table"),
    "text": (bytes_in("runs.sqlite", b"a poem " * 999), StoreError, "is damaged"),
    "nothing but zeros": (bytes_in("runs.sqlite", bytes(9999)), StoreError, "is damaged"),
    "header alone": (bytes_in("runs.sqlite", b"SQLite format 3\0"), StoreError, "is damaged"),
    "another cost": (rewritten("update run set cost = 0"), StoreError, "is damaged; `repro repro"),
    "cost of text": (rewritten("update run set cost = 'low'"), StoreError, "is damaged; `repro"),
    "hostile text": (rewritten("update run set paper = char(27)"), StoreError, "is damaged; `rep"),
    "no digest": (rewritten("update run set sha = ''"), StoreError, "is damaged; `repro"),
    "curve of text": (rewritten("update curve set y = 'up'"), StoreError, "is damaged; `repro"),
    "curve that is a bomb": (
        rewritten("update curve set y = zeroblob(1 << 20)"), StoreError, "is damaged; `repro"
    ),
    "environment of text": (rewritten("update env set json = '{'"), StoreError, "is damaged; `rep"),
}  # fmt: skip
