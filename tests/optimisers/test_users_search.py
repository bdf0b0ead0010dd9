import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from repro.errors import InputError
from repro.optimisers import Result
from repro.optimisers.users_search import Entrant, entrant, load
from tests.small_problems import Small, small

MODULE = """
import sys
from dataclasses import replace
import numpy as np
from repro.optimisers import DE, WOA
from repro.optimisers.search import Result

class Search:
    def __init__(self, change): self.change = change
    def minimise(self, problem, **budget):
        return self.change(WOA().minimise(problem, **budget))

def sample(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    return min(points, key=cost)
def greedy(cost, bounds, budget, rng):
    while True: cost(rng.uniform(*bounds.T))
def early(cost, bounds, budget, rng): return [7.0, -50.0, 2.0]
def nothing(cost, bounds, budget, rng): return None
def words(cost, bounds, budget, rng): return "somewhere"
def flat(cost, bounds, budget, rng): return 0.0
def far(cost, bounds, budget, rng): return bounds[:, 1] + 1.0
def sly(cost, bounds, budget, rng):
    try: cost(bounds[:, 1] + 1.0)
    except Exception: pass
    return bounds[:, 1]
def nan(cost, bounds, budget, rng): cost(np.full(3, np.nan))
def end(cost, bounds, budget, rng): sys.exit(3)

whale, evolution = WOA(), DE()
dear = Search(lambda r: replace(r, evaluations=10_000))
outside = Search(lambda r: replace(r, x=r.x + 100.0))
liar = Search(lambda r: replace(r, cost=-1e9))
rising = Search(lambda r: replace(r, history=r.history[::-1]))
long = Search(lambda r: replace(r, history=np.zeros(99)))
mute = Search(lambda r: None)
number = 3
def three(cost, bounds, budget): return bounds[:, 0]
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    (tmp_path / "searches.py").write_text(MODULE)
    yield tmp_path
    sys.modules.pop("searches", None)


def run(name: str, problem: Small | None = None, *, iterations: int = 10) -> Result:
    found = Entrant(place=f"searches:{name}", source="")
    return found.minimise(
        problem or small("slope"),
        population=20,
        iterations=iterations,
        rng=np.random.default_rng(1),
    )


@pytest.mark.parametrize("name", ["sample", "greedy"])
def test_call_is_stopped_where_the_budget_ends_and_its_best_is_kept(name: str) -> None:
    problem, same = small("slope", room=200), small("slope")

    result = run(name, problem)

    best_so_far = np.minimum.accumulate([same.cost(x) for x in problem.points])
    assert result.evaluations == problem.calls == 200
    assert result.history.tolist() == best_so_far[19::20].tolist()
    assert result.cost == best_so_far[-1] == same.cost(result.x.tolist())


def test_call_that_ends_early_is_judged_by_the_point_that_it_returned() -> None:
    result = run("early")

    assert (result.x.tolist(), result.cost) == ([7.0, -50.0, 2.0], -41.0)
    assert (result.evaluations, result.history.tolist()) == (1, [-41.0] * 10)


def test_object_with_our_protocol_is_run_at_the_budget() -> None:
    result = run("evolution", iterations=10)

    assert result.evaluations == 200  # not 220, which ten iterations cost
    assert result.history.shape == (10,)
    assert result.history[-1] == result.cost


@pytest.mark.parametrize(
    ("name", "fault"),
    [
        ("nothing", r"it returned None, which is no point of shape \(3,\)"),
        ("words", "it returned 'somewhere', which is no point"),
        ("flat", "it returned 0.0, which is no point"),
        ("far", r"it returned a point outside the box: x\[0\] is 8.0, not in"),
        ("sly", r"it asked for the cost of a point outside the box: x\[0\] is 8.0"),
        ("nan", r"it asked for the cost of a point outside the box: x\[0\] is nan"),
        ("end", "it tried to end the program"),
        ("dear", "it spent 10000 evaluations, and 200 were allowed"),
        ("outside", "it returned a point outside the box"),
        ("liar", "it says that its best point costs -1000000000.0; it costs"),
        ("rising", "its history is not the best cost so far"),
        ("long", "its history is not the best cost so far of up to 10 iterations"),
        ("mute", "it returned None, which has no x, cost, history and evaluations"),
    ],
)
def test_search_that_breaks_a_rule_is_told_which(name: str, fault: str) -> None:
    with pytest.raises(InputError, match=fault):
        run(name)


@pytest.mark.parametrize(
    ("place", "fault"),
    [
        ("searches", "'searches' is not MODULE:OBJECT"),
        (":sample", "':sample' is not MODULE:OBJECT"),
        ("nowhere:sample", "no module 'nowhere' in this folder"),
        ("nowhere.at.all:sample", "no module 'nowhere'"),
        ("searches:lost", "'searches' has no 'lost'; it has: .*sample"),
        ("searches:number", "neither an object with minimise.* nor a callable f"),
        ("searches:three", r"cannot be called as f\(cost, bounds, budget, rng\)"),
        ("searches:Search", "is a class that needs 'change': name an object of it"),
        ("broken:x", "'broken' cannot be imported: SyntaxError"),
        ("ending:x", "'ending' cannot be imported: SystemExit: 3"),
        ("needing:x", "'needing' cannot be imported: no module 'no_such_library'"),
    ],
)
def test_place_without_a_search_is_refused_with_the_reason(
    folder: Path, place: str, fault: str
) -> None:
    (folder / "broken.py").write_text("def (")
    (folder / "ending.py").write_text("import sys; sys.exit(3)")
    (folder / "needing.py").write_text("import no_such_library")

    with pytest.raises(InputError, match=fault):
        load(place)


def test_source_of_the_module_is_part_of_the_words_that_key_a_run(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "first.py").write_text("def f(cost, bounds, budget, rng): return bounds[:, 0]")
    (folder / "second.py").write_text("def f(cost, bounds, budget, rng): return bounds[:, 1]")

    digests = {entrant(place).source for place in ("first:f", "second:f", "searches:whale")}

    assert len(digests) == 3
    assert "source=" in repr(entrant("first:f"))
    monkeypatch.chdir("/")
    assert entrant("first:f").holds_interpreter


def test_cost_of_a_coordinate_without_width_is_asked_for_as_any_other() -> None:
    problem: Any = small("slope", box=((-3.0, 7.0), (2.5, 2.5), (2.0, 4.0)))

    assert run("sample", problem).x[1] == 2.5


def test_library_that_turns_the_stop_into_an_error_is_stopped_all_the_same(folder: Path) -> None:
    (folder / "searches.py").write_text("""
def wrapped(cost, bounds, budget, rng):
    try:
        while True: cost(rng.uniform(*bounds.T))
    except BaseException as stop:
        raise SystemError("returned a result with an exception set") from stop
""")

    assert run("wrapped").evaluations == 200


THREADED = """
import multiprocessing, threading
def over(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    threads = [threading.Thread(target=lambda: [cost(x) for x in points]) for _ in range(3)]
    for thread in threads: thread.start()
    for thread in threads: thread.join()
def sent(cost, bounds, budget, rng):
    with multiprocessing.get_context("fork").Pool(1) as pool:
        pool.map(cost, [bounds[:, 0]])
def held(cost, bounds, budget, rng):
    import cloudpickle
    cloudpickle.dumps(cost)
"""


def test_threads_that_ask_for_more_end_without_a_word(
    folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (folder / "searches.py").write_text(THREADED)

    assert run("over").evaluations == 200
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize("name", ["sent", "held"])
def test_cost_that_is_sent_to_another_process_is_told_in_a_line(folder: Path, name: str) -> None:
    (folder / "searches.py").write_text(THREADED)

    with pytest.raises(InputError, match="asked for the cost in another process, where it cannot"):
        run(name)
