from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt

import repro
from repro.commands.load import Results
from repro.commands.plots import Plots
from repro.errors import InputError
from repro.model.figures import Convergence
from repro.report.frames import frame_of_tests
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import filled

RANKS = [
    {"test": "Friedman", "experiment": "search", "algorithm": name, "p": 0.01, "rank": rank,
     "critical_difference": 1.1, "problems": 5}
    for name, rank in (("$a_b", 1.0), ("b$", 2.0), ("c", 3.0))
]  # fmt: skip


class Ranked:
    """Results that have nothing but ranks."""

    tests = frame_of_tests([{"key": "a2020", "tests": RANKS}])


@pytest.fixture(autouse=True)
def closed() -> Iterator[None]:
    mpl.use("Agg")
    yield
    plt.close("all")


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Results]:
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, PAPER)
        yield repro.load(filled(tmp_path_factory.mktemp("drawn")))


def test_runs_are_drawn_a_strip_an_algorithm(results: Results) -> None:
    axes = results.plot.runs("small2020", "search", "bowl")

    assert [text.get_text() for text in axes.get_yticklabels()] == ["guess", "wide"]
    assert axes.figure in [plt.figure(number) for number in plt.get_fignums()]


def test_every_curve_has_its_own_name_in_the_legend(results: Results) -> None:
    _, axes = plt.subplots()

    assert results.plot.convergence("small2020", "search", "bowl", ax=axes) is axes
    legend: Any = axes.get_legend()
    shown = [text.get_text() for text in legend.get_texts()]
    assert shown == ["guess", "wide"]
    colours = [entry.get_color() for entry in legend.legend_handles]
    assert colours == [line.get_color() for line in axes.lines]
    medians = results.curves("small2020", "search", "bowl", "guess").median().to_numpy()
    assert np.log10(medians) == pytest.approx(axes.lines[0].get_ydata()) or medians == (
        pytest.approx(axes.lines[0].get_ydata())
    )


def test_dollars_in_names_stay_dollars() -> None:
    axes = Plots(Ranked()).ranks("a2020", "search")  # type: ignore[arg-type]

    texts = {text.get_text(): text for text in axes.texts}
    assert {"$a_b 1.00", "b$ 2.00", "c 3.00"} <= set(texts)
    assert not texts["$a_b 1.00"].get_parse_math()


def test_what_is_not_there_is_named_with_what_there_is(results: Results) -> None:
    with pytest.raises(InputError, match="no problem 'F1'; there are: bowl"):
        results.plot.runs("small2020", "search", "F1")
    with pytest.raises(InputError, match=r"no experiment 'found' of small2020; there are: search"):
        results.plot.convergence("small2020", "found", "bowl")
    with pytest.raises(InputError, match=r"no experiment 'none'; there are: search"):
        Plots(Ranked()).ranks("a2020", "none")  # type: ignore[arg-type]


def test_a_study_is_drawn_apart(results: Results) -> None:
    with pytest.raises(InputError, match="no study 'baselines'; there are: protocol"):
        results.plot.runs("small2020", "search", "bowl", study="baselines")


def test_a_figure_of_the_page_is_had_as_axes(tmp_path: Path) -> None:
    figure = Convergence(label="Fig. 1", caption="c", experiment="search")
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, replace(PAPER, figures=(figure,)))
        results = repro.load(filled(tmp_path))

    (axes,) = results.plot.figure("small2020", "Fig. 1")
    assert axes.get_title() == "bowl"
    assert len(axes.lines) == 2
    with pytest.raises(InputError, match=r"no figure 'Fig\. 2' of small2020; there are: Fig\. 1"):
        results.plot.figure("small2020", "Fig. 2")
