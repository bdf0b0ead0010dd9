import copy
import pickle

from repro.functions import FUNCTIONS, Known

SPHERE = FUNCTIONS["sphere"]


def test_a_function_travels_by_plain_pickle_without_what_is_known_of_it() -> None:
    travelled = pickle.loads(pickle.dumps(SPHERE.problem(3)))  # noqa: S301 (made here)

    assert travelled == SPHERE.problem(3)
    assert travelled.function.known == Known()


def test_copies_know_the_same() -> None:
    assert copy.copy(SPHERE).known is SPHERE.known
    assert copy.deepcopy(SPHERE.known) is SPHERE.known
