import copy
import pickle

import pytest

from repro.errors import InputError
from repro.functions import FUNCTIONS, Known

SPHERE = FUNCTIONS["sphere"]


def test_a_function_travels_by_plain_pickle_without_what_is_known_of_it() -> None:
    travelled = pickle.loads(pickle.dumps(SPHERE.problem(3)))  # noqa: S301 (made here)

    assert travelled == SPHERE.problem(3)
    assert travelled.function.known == Known()


def test_copies_know_the_same() -> None:
    assert copy.copy(SPHERE).known is SPHERE.known
    assert copy.deepcopy(SPHERE.known) is SPHERE.known


def test_a_function_that_is_not_there_is_told_with_those_near_it() -> None:
    with pytest.raises(InputError, match=r"no function 'spher'; did you mean 'sphere'\? there is "):
        FUNCTIONS["spher"]
    assert FUNCTIONS.get("spher") is None
    assert "spher" not in FUNCTIONS
