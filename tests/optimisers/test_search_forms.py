"""Every form in which a search may come, taken as it is; what is none, refused in a line."""

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from repro.errors import InputError
from repro.optimisers import Result
from repro.optimisers.returned_points import point_in
from repro.optimisers.users_search import Entrant, load
from tests.small_problems import small

MODULE = '''
import functools
from typing import Callable
import numpy as np
from scipy.optimize import Bounds, OptimizeResult, differential_evolution, minimize

def best(cost, low, high, budget, rng):
    """Return the best of as many points as the budget has."""
    return min(rng.uniform(low, high, size=(budget, len(low))), key=cost)
def plain(cost, bounds, budget, rng): return best(cost, *bounds.T, budget, rng)

# what is returned
def mapped(cost, bounds, budget, rng): return {"fun": 1.0, "x": plain(cost, bounds, budget, rng)}
def params(cost, bounds, budget, rng):
    return {f"x{k}": v for k, v in enumerate(plain(cost, bounds, budget, rng))}
def second(cost, bounds, budget, rng):
    x = plain(cost, bounds, budget, rng)
    return 0.5, x
def listed(cost, bounds, budget, rng): return [plain(cost, bounds, budget, rng), 0.5]
def column(cost, bounds, budget, rng): return plain(cost, bounds, budget, rng)[:, None]
def row(cost, bounds, budget, rng): return plain(cost, bounds, budget, rng)[None, :]
def scipys(cost, bounds, budget, rng):
    return OptimizeResult(x=plain(cost, bounds, budget, rng), fun=1.0, nfev=budget, nit=1)
class Agent:
    def __init__(self, x): self.solution, self.fitness = x, 0.0
class Model:
    def __init__(self, x): self.g_best = Agent(x)
    @property
    def best_params(self): raise ValueError("none yet")
def nested(cost, bounds, budget, rng): return Model(plain(cost, bounds, budget, rng))

# how it is called
def scattered(rng, budget, bounds, func): return plain(func, bounds, budget, rng)
def named(*, cost, bounds, budget, rng): return plain(cost, bounds, budget, rng)
def half_named(cost, bounds, *, rng, max_evals): return plain(cost, bounds, max_evals, rng)
def seeded(cost, bounds, budget, seed):
    return plain(cost, bounds, budget, np.random.default_rng(seed + 0))
def edges(objf, lb, ub, dim, SearchAgents_no, Max_iter, seed):
    assert lb.shape == ub.shape == (dim,)
    rng = np.random.default_rng(seed)
    return best(objf, lb, ub, SearchAgents_no * Max_iter, rng)
def own_words(f, b, n, r, /): return plain(f, b, n, r)
def tuned(share, cost, bounds, budget, rng):
    return plain(cost, bounds, int(share * budget), rng)
partial = functools.partial(tuned, 1.0)
lambda_ = lambda cost, bounds, budget, rng: plain(cost, bounds, budget, rng)  # noqa: E731

# how bounds come
def lower_upper(cost, bounds: tuple[np.ndarray, np.ndarray], budget, rng):
    low, high = bounds
    return best(cost, low, high, budget, rng)
def written(cost, bounds: "tuple[list[float], list[float]]", budget, rng):
    return lower_upper(cost, bounds, budget, rng)
def in_pairs(cost, bounds: list[tuple[float, float]], budget, rng):
    assert type(bounds) is list and type(bounds[0]) is tuple
    return best(cost, *zip(*bounds), budget, rng)
def scipys_bounds(cost, bounds: Bounds, budget, rng):
    return best(cost, bounds.lb, bounds.ub, budget, rng)

# what it is
class Called:
    def __init__(self, share=1.0): self.share = share
    def __call__(self, cost, bounds, budget, rng):
        return plain(cost, bounds, int(self.share * budget), rng)
class Below(Called):
    def __call__(self, cost, bounds, budget, rng):
        return super().__call__(cost, bounds, budget, rng)
below = Below(0.5)
class Method:
    def optimize(self, func, lower, upper, maxfev, rng):
        return best(func, lower, upper, maxfev, rng)
method = Method()
class American:
    def minimize(self, cost, bounds, budget, rng): return plain(cost, bounds, budget, rng)
american = American()
class British:
    def minimise(self, cost, bounds, budget, rng): return plain(cost, bounds, budget, rng)
british = British()
class Swarm:
    def __init__(self, func, n_dim, pop, max_iter, lb, ub, seed=None):
        self.asked = func, lb, ub, pop * max_iter, np.random.default_rng(seed)
    def run(self, max_iter=None): return best(*self.asked)

# asked and told
class Asked:
    def __init__(self, bounds, rng): self.box, self.rng = bounds, rng
    def ask(self): return self.rng.uniform(*self.box.T, size=(5, len(self.box)))
    def tell(self, points, costs): self.lowest = costs.min()
class Suggesting(Asked):
    ask = tell = None
    def suggest(self, n_suggestions=1):
        return [{f"x{k}": v for k, v in enumerate(self.rng.uniform(*self.box.T))}]
    def observe(self, points, costs): assert isinstance(points[0], dict) and len(costs) == 1
class Candidate:
    def __init__(self, value): self.value = value
class Nevergrads(Asked):
    def ask(self): return Candidate(self.rng.uniform(*self.box.T))
    def tell(self, candidate, loss, extra=None): self.last = candidate
    def provide_recommendation(self): return self.last
class Trial:
    def __init__(self, rng): self.rng = rng
    def suggest_float(self, name, low, high): return self.rng.uniform(low, high)
class Study:
    def __init__(self, rng): self.rng = rng
    def ask(self): return Trial(self.rng)
    def tell(self, trial, values=None, state=None, skip=False): pass
    def stop(self) -> None: raise RuntimeError("only within an objective")
class Waiting(Asked):
    population_size = 5
    def ask(self): return self.rng.uniform(*self.box.T)
    def tell(self, solutions): assert len(solutions) == 5
class Short(Asked):
    rounds = 0
    def ask(self): return [self.rng.uniform(*self.box.T)]
    def tell(self, points, costs): self.rounds += 1
    def stop(self): return self.rounds == 3
    def recommend(self): return self.box.mean(axis=1)
class Empty(Asked):
    def ask(self): return []
    def recommend(self): return self.box.mean(axis=1)
def study(rng): return Study(rng)

# none of them
def unsaid(cost, bounds, budget, rng, *, temperature): return bounds[:, 0]
def none(): return None
def boundless(cost, rng): return None
def costless(budget, rng=None, lower=None, x=None): return None
async def later(cost, bounds, budget, rng): return bounds[:, 0]
def lazily(cost, bounds, budget, rng): yield bounds[:, 0]
class Needing:
    def __init__(self, temperature): pass
class Mute:
    def __init__(self, cost, bounds): pass
class Raising:
    def __init__(self): raise OSError("no\\nfile")
'''
RETURNED = ("mapped", "params", "second", "listed", "column", "row", "scipys", "nested")
CALLED = ("scattered", "named", "half_named", "seeded", "edges", "own_words", "partial", "lambda_",
          "lower_upper", "written", "in_pairs", "scipys_bounds", "Called", "Method", "method",
          "American", "american", "british", "Swarm")  # fmt: skip
ASKED = ("Asked", "Suggesting", "Nevergrads", "Study", "study", "Waiting")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    (tmp_path / "forms.py").write_text(MODULE)
    yield
    sys.modules.pop("forms", None)


def run(name: str) -> Result:
    load(f"forms:{name}")
    found = Entrant(place=f"forms:{name}", source="")
    return found.minimise(small("slope"), population=20, iterations=5, rng=np.random.default_rng(1))


@pytest.mark.parametrize("name", RETURNED)
def test_point_is_found_in_whatever_is_returned(name: str) -> None:
    assert run(name).x.tolist() == run("plain").x.tolist()


@pytest.mark.parametrize("name", [*CALLED, *ASKED])
def test_search_is_called_as_it_is_and_counted(name: str) -> None:
    result = run(name)

    assert result.evaluations == 100
    assert result.cost == small("slope").cost(result.x.tolist())


def test_subclass_with_its_own_call_is_called_by_that() -> None:
    assert run("below").evaluations == 50


def test_what_an_object_recommends_where_it_stops_is_counted_once_more() -> None:
    assert run("Short").evaluations == 4
    assert run("Empty").evaluations == 1


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("unsaid", "'temperature' says not what it asks for"),
        ("none", "it asks for no cost"),
        ("boundless", "it asks for no bounds"),
        ("later", "it returns before it has searched"),
        ("lazily", "it returns before it has searched"),
        ("Needing", "is a class that needs 'temperature': name an object of it"),
        ("Mute", "is a class without a method minimise, minimize"),
        ("Raising", "is a class that cannot be made: OSError: no file"),
    ],
)
def test_what_is_no_form_is_refused_in_a_line(name: str, says: str) -> None:
    with pytest.raises(InputError, match=says) as refused:
        load(f"forms:{name}")

    assert str(refused.value).startswith(f"forms:{name}")
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "returned",
    [None, "x", [[1.0, 2.0], [3.0, 4.0]], {"cost": 1.0, "nfev": 3.0}, (1.0, 2.0, 3.0), {1: "a"}],
)
def test_what_holds_no_point_stays_what_it_is(returned: object) -> None:
    assert point_in(returned, 2) is returned


def test_number_is_the_point_of_one_coordinate() -> None:
    assert point_in(0.5, 1).tolist() == [0.5]
    assert point_in((0.1, np.array([0.5])), 1).tolist() == [0.5]
