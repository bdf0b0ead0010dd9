from dataclasses import replace

import pytest

from repro.errors import DeclarationError
from repro.model.claims import lowest_everywhere
from tests.small_papers import CLAIMS, EXPERIMENT, PAPER, Bowl, Guessing


def test_cell_without_a_claim_is_refused_by_name() -> None:
    fault = r"^small2020, Table 1: cell \(bowl std, wide\) has no claim$"
    with pytest.raises(DeclarationError, match=fault):
        replace(PAPER, claims=CLAIMS[:-1])


def test_cell_with_two_claims_is_refused_by_name() -> None:
    fault = r"^small2020, Table 1: cell \(bowl mean, guess\) has 2 claims$"
    with pytest.raises(DeclarationError, match=fault):
        replace(PAPER, claims=(*CLAIMS, CLAIMS[0]))


def test_input_tables_need_no_claims() -> None:
    assert replace(PAPER, claims=(), results=(), inputs=PAPER.results).claims == ()


def test_claim_on_runs_that_no_experiment_makes_is_refused_with_the_experiments() -> None:
    fault = r"^small2020, Table 1, bowl mean, guess: no experiment 'search'; there is 'other'\n"
    with pytest.raises(DeclarationError, match=fault):
        replace(PAPER, experiments=(replace(EXPERIMENT, name="other"),))


def test_sentence_on_an_unknown_algorithm_is_refused_by_its_words() -> None:
    claims = lowest_everywhere(
        EXPERIMENT, algorithm="guess", statistic="mean", claim="guessing wins", where="p. 4"
    )
    smaller = replace(EXPERIMENT, algorithms={"guess": Guessing()})

    with pytest.raises(
        DeclarationError,
        match=r"guessing wins, on bowl: experiment 'search' has no algorithm 'wide'",
    ):
        replace(PAPER, experiments=(smaller,), results=(), claims=claims)


def test_two_experiments_of_one_name_are_refused() -> None:
    with pytest.raises(DeclarationError, match="small2020, 'search': runs are named"):
        replace(PAPER, experiments=(EXPERIMENT, EXPERIMENT))


@pytest.mark.parametrize("changed", [{"name": "a/b"}, {"problems": {"a/b": Bowl()}}])
def test_name_with_a_slash_is_refused(changed: dict[str, object]) -> None:
    with pytest.raises(DeclarationError, match="'a/b': runs are named"):
        replace(PAPER, experiments=(replace(EXPERIMENT, **changed),), results=(), claims=())  # type: ignore[arg-type]
