"""The two papers that are controls: what one takes from the other, and what each leaves open."""

import numpy as np
import pytest

from papers import mirjalili2014, mirjalili2016
from repro.functions import FUNCTIONS
from repro.model.claims import CellClaim
from repro.model.paper import Paper
from repro.optimisers import WOA
from repro.tables.published import Printed

BY_ROW = {
    row: table
    for table in (mirjalili2014.TABLE_5, mirjalili2014.TABLE_6, mirjalili2014.TABLE_7)
    for row in table.row_names
}
PAPERS = (mirjalili2014.PAPER, mirjalili2016.PAPER)
each_paper = pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.key)


def test_the_columns_of_pso_and_gsa_are_the_same_in_both_papers() -> None:
    columns = [f"{name} {kind}" for name in ("PSO", "GSA") for kind in ("ave", "std")]
    later = mirjalili2016.TABLE_6
    pairs = [
        (BY_ROW[row][row, column].text, later[row, column].text)
        for row in later.row_names
        for column in columns
    ]

    assert len(pairs) == 92
    assert all(one == other for one, other in pairs)


@each_paper
def test_every_column_that_is_run_is_judged_and_every_other_has_a_gap(paper: Paper) -> None:
    own = paper.experiments[0].algorithms
    cells = [claim for claim in paper.claims if isinstance(claim, CellClaim)]

    for claim in cells:
        run = claim.column.rpartition(" ")[0] in own and claim.row in paper.experiments[0].problems
        assert (claim.gap is None) == run
    assert sum(claim.gap is None for claim in cells) == 23 * 2 * len(own)


@each_paper
def test_a_number_counts_by_its_distance_from_the_least_cost(paper: Paper) -> None:
    (own,) = (
        claim
        for claim in paper.claims
        if isinstance(claim, CellClaim)
        and (claim.row, claim.column) == ("F8", f"{paper.experiments[0].proposed} ave")
    )
    least = FUNCTIONS["schwefel_2_26"].problem(30).minimum
    low, high = own.accepted.band(own.printed)

    assert (high - low) / 2 == pytest.approx(0.25 * (own.printed.value - least), rel=1e-4)


def test_averages_of_f6_are_none_of_thirty_whole_numbers() -> None:
    printed = mirjalili2014.TABLE_5["F6", "PSO ave"]
    sums = 30 * np.array([printed.value - printed.rounding, printed.value + printed.rounding])

    assert isinstance(printed, Printed)
    assert 0 < sums[0] < sums[1] < 1


def test_the_program_of_the_whales_is_a_reading_that_runs_as_deep_as_the_equations() -> None:
    (program,) = (
        alternative
        for assumption in mirjalili2016.PAPER.assumptions
        for alternative in assumption.alternatives
        if alternative.name == "the authors' program"
    )

    assert program.full_depth
    assert dict(program.algorithms) == {("benchmark", "WOA"): WOA()}
