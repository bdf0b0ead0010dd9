"""How often the audit accuses true tables, and how often it finds planted errors.

Run as `python -m tests.false_alarms [TABLES]`, it writes docs/false_alarms.md.
"""

import math
import os
import pathlib
import sys
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from itertools import product

from tests.planted import ERRORS, SETS, WHOLE, power
from tests.planted_beside import BESIDE, power_beside
from tests.trial import KINDS, SEED, alarms

PAGE = pathlib.Path(__file__).parents[1] / "docs" / "false_alarms.md"
TABLES = 100_000
PLANTED = 300  # errors per kind and set of statistics
INTRODUCTION = """\
# False alarms and power of the checks

`nox -s false-alarms` writes this page, the same for any number of processes: each table is drawn
from a seed of the name "{seed}" and its number, written as CSV, Markdown, LaTeX, HTML or text
with tabs, and read and audited as any file is.

Of {tables:,} true tables with {numbers:,} numbers, of which {checked:,} were checked,
{impossible} are called impossible without a condition, and {inconsistent} inconsistent.
{broken:,} have a row under a condition that is said, such as double precision, and that does not
hold of them; {met} one under a condition that holds.

| tables | how many | numbers checked | impossible | inconsistent | if what does not hold \
| if what holds |
| --- | --- | --- | --- | --- | --- | --- |
"""
PIPELINES = """
What the tables are of: heavy tails, zeros, floors, equal runs, whole numbers, negative values, test
functions computed by other programs; 2 to 1,000 runs. How they were made, each choice on its own:

- runs and statistics in double precision, in single precision, or runs alone in single;
- sums in turn from either end, pairwise, or exact; spreads in two passes, in one (mean of squares,
  or sum of squares) or updated run by run, in the n or the n − 1 form, as standard deviation,
  variance or standard error;
- the median, the quartiles and the range between them, of thirteen definitions;
- rounded to 2 to 9 digits or decimals, with powers of ten or without, rounded to 4 digits as R
  does, cut off, rounded twice, each number with digits of its own;
- minimised or maximised, told or guessed; n told, in the caption, or not given at all; a known
  minimum, errors, whole numbers told or not;
- ranks of values or of prints, ties in five ways, with sums, means and places; success rates
  rounded or cut, of runs that reach a threshold or pass below it; rank tests in normal form, with
  and without a correction, or exact, one- and two-sided, with z, r and decisions in figures or
  words; tallies of all problems or a part, and sign tests;
- methods whose rows are equal, as copies or because both always reach the optimum.

## Power

The share of {planted} planted errors per cell that are found, under a condition or without ({runs}
runs, four digits, no value below 0):

"""
BESIDE_TITLE = """
The same of what stands beside statistics:

| error | found |
| --- | --- |
"""


def page(count: Counter[tuple[str, str]], errors: int, workers: int) -> str:
    """Return the page of the manual."""
    total: Counter[str] = Counter()
    for (_, what), times in count.items():
        total[what] += times
    head = INTRODUCTION.format(
        seed=SEED,
        tables=total["tables"],
        numbers=total["numbers"],
        checked=total["checked"],
        impossible=total["impossible"],
        inconsistent=total["inconsistent"],
        broken=total["condition broken"],
        met=total["condition met"],
    )
    columns = ("tables", "checked", "impossible", "inconsistent")
    conditions = ("condition broken", "condition met")
    kinds = "".join(
        f"| {kind} | {' | '.join(f'{count[kind, name]:,}' for name in (*columns, *conditions))} |\n"
        for kind in KINDS
    )
    lines = "\n".join(_power_lines(errors, workers))
    return f"{head}{kinds}{PIPELINES.format(planted=errors, runs=30)}{lines}\n"


def _power_lines(errors: int, workers: int) -> Iterator[str]:
    sets = (*SETS, WHOLE)
    places = list(product(ERRORS, sets))
    with ProcessPoolExecutor(workers) as pool:
        shares = pool.map(power, *zip(*places, strict=True), [errors] * len(places))
        found = dict(zip(places, shares, strict=True))
        others = pool.map(power_beside, BESIDE, [errors] * len(BESIDE))
        beside = dict(zip(BESIDE, others, strict=True))
    yield "| error | " + " | ".join(", ".join(names) for names in sets) + " |"
    yield "| --- | " + " | ".join("---" for _ in sets) + " |"
    for kind in ERRORS:
        yield f"| {kind} | {' | '.join(_percent(found[kind, names][1]) for names in sets)} |"
    yield BESIDE_TITLE.rstrip()
    for kind, share in beside.items():
        yield f"| {kind} | {_percent(share)} |"


def _percent(share: float) -> str:
    return "–" if math.isnan(share) else f"{100 * share:.0f} %"


if __name__ == "__main__":
    processes = len(os.sched_getaffinity(0))
    counted = alarms(int(sys.argv[1]) if len(sys.argv) > 1 else TABLES, workers=processes)
    PAGE.write_text(page(counted, PLANTED, processes), encoding="utf-8")
    sys.stdout.write(f"{dict(counted)}\n")
