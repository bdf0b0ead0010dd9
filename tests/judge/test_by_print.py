from repro.judge.by_print import by_print, printed_evidence, printed_sizes
from repro.model.measures.measure import Reduction, Statistic, computed
from tests.doe2021 import PAPER


def mean_time(algorithm: str) -> Statistic:
    return Statistic(
        experiment="motion", problem="arm", algorithm=algorithm, statistic="mean", quantity="total"
    )


def test_a_measure_of_printed_numbers_comes_to_what_the_print_says() -> None:
    shorter = Reduction(before=mean_time("PSO"), after=mean_time("WOA"))

    assert by_print(shorter, printed_evidence(PAPER)) == 100 * (1 - 2.357 / 2.1)


def test_a_measure_of_which_a_number_is_not_printed_has_none() -> None:
    best = Statistic(experiment="motion", problem="arm", algorithm="WOA", statistic="best")
    printed = printed_evidence(PAPER)

    assert by_print(Reduction(before=mean_time("PSO"), after=best), printed) is None
    assert by_print(computed("two", lambda: 2.0), printed) is None
    assert by_print(None, printed) is None


def test_every_claim_has_its_size_in_its_own_unit() -> None:
    sizes = printed_sizes(PAPER)

    assert len(sizes) == len(PAPER.said)
    cells = [(size, claim.printed.value) for size, claim in zip(sizes, PAPER.said, strict=True)
             if claim.place]  # fmt: skip
    assert all(size == value for size, value in cells)
