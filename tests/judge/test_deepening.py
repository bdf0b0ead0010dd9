from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest

from repro.judge.deepening import SHARE, deepened
from repro.judge.findings import findings_of
from repro.judge.verdict import Verdict
from repro.model.assumptions import Alternative, Assumption
from repro.model.evidence import Cell, Evidence, Runs
from repro.model.paper import Paper
from tests.small_papers import PAPER, evidence_of

FULL = 8
RUN_AS = ("search [wider]", "bowl", "guess")
WIDER = Alternative(
    name="wider", says="three times", algorithms={("search", "guess"): {"width": 3.0}}
)
ASSUMPTION = Assumption(
    what="width", chosen="ours", alternatives=(WIDER,), because="so", where="p. 3"
)
OPEN = replace(PAPER, assumptions=(ASSUMPTION,))
HELD, FAR = 0.05, 5.0


def runs(cost: float, repeats: int, evaluations: int = 20) -> Runs:
    return Runs(
        costs=cost * np.linspace(0.9, 1.1, 3 * repeats).reshape(repeats, 3),
        points=np.zeros((repeats, 3, 2)),
        histories=np.zeros((1, 3, 5)),
        evaluations=evaluations,
    )


def shallow(own: float, wider: float, *, evaluations: int = 20) -> Evidence:
    cells = {("search", "bowl", name): runs(own, FULL, 100) for name in ("guess", "wide")}
    return evidence_of(OPEN, {**cells, RUN_AS: runs(wider, 1, evaluations)})


class Laboratory:
    """Give as many repeats as are wanted, and remember what was."""

    def __init__(self, costs: Mapping[int, float], most: int = FULL) -> None:
        """Keep the costs by depth, and the most repeats that are given."""
        self.costs, self.most = costs, most
        self.wanted: list[dict[Cell, int]] = []

    def __call__(self, depths: Mapping[Cell, int]) -> Mapping[Cell, Runs]:
        """Return the runs."""
        self.wanted.append(dict(depths))
        return {
            cell: runs(self.costs[depth], min(depth, self.most)) for cell, depth in depths.items()
        }


def on_mean(paper: Paper, evidence: Evidence, laboratory: Laboratory) -> Verdict:
    evidence, others = deepened(paper, evidence, laboratory)
    return findings_of(paper.said, evidence, others)[0].verdict


MEAN_ONLY = replace(OPEN, results=(), claims=OPEN.claims[:1])


@pytest.mark.parametrize(("own", "wider"), [(FAR, HELD), (HELD, FAR)])
def test_reading_that_seems_to_turn_a_verdict_is_doubled_down_to_the_papers_depth(
    own: float, wider: float
) -> None:
    laboratory = Laboratory({2: wider, 4: wider, 8: wider})

    assert on_mean(MEAN_ONLY, shallow(own, wider), laboratory) is Verdict.DEPENDS
    assert laboratory.wanted == [{RUN_AS: 2}, {RUN_AS: 4}, {RUN_AS: 8}]


def test_reading_is_no_longer_deepened_once_it_turns_nothing() -> None:
    laboratory = Laboratory({2: HELD, 4: FAR, 8: FAR})

    assert on_mean(MEAN_ONLY, shallow(FAR, HELD), laboratory) is Verdict.CONTRADICTED
    assert laboratory.wanted == [{RUN_AS: 2}, {RUN_AS: 4}]


def test_reading_that_agrees_is_not_deepened() -> None:
    laboratory = Laboratory({})

    on_mean(MEAN_ONLY, shallow(HELD, HELD), laboratory)

    assert laboratory.wanted == []


def test_what_cannot_be_had_ends_the_deepening() -> None:
    laboratory = Laboratory({2: HELD, 4: HELD, 8: HELD}, most=2)

    assert on_mean(MEAN_ONLY, shallow(FAR, HELD), laboratory) is Verdict.DEPENDS
    assert laboratory.wanted == [{RUN_AS: 2}, {RUN_AS: 4}]


def test_cheapest_cells_are_deepened_first() -> None:
    laboratory = Laboratory({2: HELD, 4: HELD, 8: HELD})
    narrower = replace(WIDER, name="narrower", algorithms={("search", "guess"): {"width": 0.5}})
    paper = replace(MEAN_ONLY, assumptions=(replace(ASSUMPTION, alternatives=(WIDER, narrower)),))
    evidence = shallow(FAR, HELD, evaluations=200)
    cheap = ("search [narrower]", "bowl", "guess")
    both = evidence.deeper({cheap: runs(HELD, 1, 20)})

    deepened(paper, both, laboratory)

    assert list(laboratory.wanted[0]) == [cheap, RUN_AS]


def test_deepening_costs_no_more_than_its_share_of_the_evaluations() -> None:
    laboratory = Laboratory({2: HELD})
    evidence = shallow(FAR, HELD)
    spent = sum(each.costs.size * each.evaluations for each in evidence.runs.values())
    # one repeat more has 3 runs, each of which costs more than a third of the share
    dear = shallow(FAR, HELD, evaluations=int(SHARE * spent))

    on_mean(MEAN_ONLY, dear, laboratory)

    assert laboratory.wanted == []
