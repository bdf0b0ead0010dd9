from dataclasses import replace

import pytest

from repro.errors import DeclarationError
from repro.model.cells import every_cell
from repro.model.claims import CellClaim
from repro.model.measures.measure import Rank, Statistic
from repro.model.measures.ranks import RankSum
from repro.model.tolerances import Absolute, Percent
from repro.tables.published import PublishedTable
from tests.small_papers import EXPERIMENT, PAPER, Guessing, evidence

THREE = replace(EXPERIMENT, algorithms={name: Guessing() for name in ("guess", "near", "wide")})
COSTS = {
    "guess": [[1.0, 2.0, 3.0, 4.0]],
    "near": [[2.0, 2.0, 2.0, 9.0]],
    "wide": [[1.0, 2.0, 3.0, 5.0]],
}


STATISTIC = Statistic(experiment="search", problem="bowl", algorithm="guess", statistic="mean")


def claims(word: str, *, columns: str = "guess | near | wide") -> tuple[CellClaim, ...]:
    """Return the claims of a table with a single line that prints what `word` says."""
    cells = " | ".join("1" for _ in columns.split("|"))
    table = PublishedTable.read(f"Table 3, p. 4\nproblem || {columns}\nbowl || {cells}")
    return every_cell(
        table,
        of=THREE,
        rows=("problem",),
        columns="algorithm",
        given={"statistic": word},
        within=Absolute(0),
    )


def values(word: str, *, columns: str = "guess | near | wide") -> list[float]:
    found = evidence(PAPER, **COSTS)
    return [
        claim.measure.measure(found).value
        for claim in claims(word, columns=columns)
        if claim.measure
    ]


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("median", [2.5, 2.0, 2.5]),
        ("q1", [1.75, 2.0, 1.75]),
        ("success rate at 2", [50.0, 75.0, 50.0]),
        ("successes at 2", [2.0, 3.0, 2.0]),
        ("rank", [1.0, 3.0, 2.0]),
        ("rank by median", [2.0, 1.0, 2.0]),
        ("rank by median, ties average", [2.5, 1.0, 2.5]),
        ("rank by worst, ties dense", [1.0, 3.0, 2.0]),
        ("rank by median, ties ordinal", [2.0, 1.0, 3.0]),
    ],
)
def test_table_may_print_any_statistic_or_nothing_but_ranks(
    word: str, expected: list[float]
) -> None:
    assert values(word) == expected


def test_table_may_print_nothing_but_p_values() -> None:
    test = RankSum(experiment="search", problems=("bowl",), algorithm="guess", against="near")

    own = [claim.measure for claim in claims("rank-sum p", columns="near | wide")]
    pairs = [
        claim.measure for claim in claims("signed-rank p against near", columns="guess | wide")
    ]

    assert own == [test, replace(test, against="wide")]
    assert pairs == [
        replace(test, by="signed-rank"),
        replace(test, by="signed-rank", algorithm="wide"),
    ]


@pytest.mark.parametrize(
    "word", ["rank-sum p", "rank-sum p against nobody", "rank by luck", "rank, ties even", "mode"]
)
def test_word_that_means_nothing_here_is_refused_with_the_alternatives(word: str) -> None:
    with pytest.raises(DeclarationError, match=r"near, wide|ties dense"):
        claims(word)


def test_interval_of_a_success_rate_lies_between_none_and_all() -> None:
    measured = claims("success rate at 2")[0].measure
    assert measured is not None

    draws = measured.measure(evidence(PAPER, **COSTS)).draws

    assert set(draws) == {0.0, 25.0, 50.0, 75.0, 100.0}


def test_rarer_statistics_are_drawn_from_the_same_tables_as_the_usual_ones() -> None:
    found = evidence(PAPER, **COSTS)

    best = replace(STATISTIC, statistic="best").measure(found).draws
    first = replace(STATISTIC, statistic="q1 by inverted_cdf").measure(found).draws  # one of four

    assert len(set(best)) > 10
    assert (best == first).all()


def test_words_of_a_count_part_it_from_the_quantity() -> None:
    words = replace(STATISTIC, statistic="success rate at 1e-8").words

    assert words == "success rate at 1e-8, cost of guess on bowl"


def test_every_measure_of_spread_has_its_own_tolerance() -> None:
    table = PublishedTable.read("T, p. 1\nstatistic || guess\nstd || 1\niqr || 1\nmedian || 1")

    found = every_cell(
        table, of=THREE, rows=("statistic",), columns="algorithm", given={"problem": "bowl"},
        within=Percent(1), std_within=Percent(9),
    )  # fmt: skip

    assert [claim.accepted for claim in found] == [Percent(9), Percent(9), Percent(1)]


def test_rank_keeps_its_words_where_ties_are_shared_as_ever() -> None:
    rank = Rank(of=STATISTIC, among=("guess", "near"))

    assert rank.words == "rank of mean cost of guess on bowl among guess, near"
    assert replace(rank, ties="dense").words.endswith("near, ties dense")
