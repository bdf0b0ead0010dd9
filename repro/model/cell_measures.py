"""What a cell of a results table prints, by the word for it: a statistic, a rank, a p-value."""

import re
from typing import cast

from repro.errors import DeclarationError
from repro.model.experiment import Experiment
from repro.model.measures.measure import Measure, Rank, Statistic
from repro.model.measures.ranks import RankSum
from repro.statistics.named import KNOWN, is_known
from repro.statistics.places import TIES, Ties
from repro.tables.relations import RankTest

_RANK = re.compile(r"rank(?: by (?P<by>[^,]+))?(?:, ties (?P<ties>\w+))?")
_P_VALUE = re.compile(r"(?P<test>rank-sum|signed-rank) p(?: against (?P<against>.+))?")
WORDS = (*KNOWN, "rank", "rank by median, ties dense", "rank-sum p", "signed-rank p against X")
"""What a cell may be said to print."""


def is_printable(word: str) -> bool:
    """Say whether `measure_of` knows the word, but for the names of algorithms in it."""
    if match := _RANK.fullmatch(word):
        return is_known(match["by"] or "mean") and (match["ties"] or "min") in TIES
    return _P_VALUE.fullmatch(word) is not None or is_known(word)


def measure_of(cell: Statistic, of: Experiment) -> Measure:
    """Return what the cell's `statistic` means; the cell itself where it is one of runs.

    "rank" is the place of the algorithm's mean among all of the experiment, 1 for the lowest;
    "rank by median, ties dense" that of another statistic, ties shared in another way than "min".
    "rank-sum p" is the p-value of the proposed algorithm against the cell's, "signed-rank p
    against X" that of the cell's algorithm against X, run by run. Raises DeclarationError where an
    algorithm would be compared with itself or with none of the experiment.
    """
    if match := _RANK.fullmatch(cell.statistic):
        by = Statistic(
            experiment=cell.experiment,
            problem=cell.problem,
            algorithm=cell.algorithm,
            statistic=match["by"] or "mean",
            quantity=cell.quantity,
        )
        return Rank(of=by, among=tuple(of.algorithms), ties=cast("Ties", match["ties"] or "min"))
    if match := _P_VALUE.fullmatch(cell.statistic):
        return _p_value(cell, of, cast("RankTest", match["test"]), match["against"])
    return cell


def compared_with(word: str, algorithm: str, of: Experiment) -> tuple[str, ...]:
    """Return the algorithms of the paper, run or not, that the word compares one with."""
    if _RANK.fullmatch(word):
        return (*of.algorithms, *of.left_out)
    if match := _P_VALUE.fullmatch(word):
        return (algorithm, match["against"] or of.proposed)
    return ()


def _p_value(cell: Statistic, of: Experiment, test: RankTest, against: str | None) -> RankSum:
    own, other = (cell.algorithm, against) if against else (of.proposed, cell.algorithm)
    rivals = [name for name in of.algorithms if name != own]
    if other not in rivals:
        message = (
            f"{cell.statistic!r} on {cell.problem}: {own} is tested against {other!r}, which is "
            f"none of {', '.join(rivals)}"
        )
        raise DeclarationError(message)
    return RankSum(
        experiment=cell.experiment,
        problems=(cell.problem,),
        algorithm=own,
        against=other,
        by=test,
    )
