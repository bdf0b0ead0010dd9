from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt

import repro
from repro.__main__ import main
from repro.commands.load import Results
from repro.commands.plots import Plots
from repro.errors import InputError
from repro.functions import FUNCTIONS
from repro.model.figures import Convergence
from repro.report.drawings.convergence import CostScale
from repro.report.frames import frame_of_tests
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import filled, with_pages

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


def test_printed_costs_are_marked_beside_the_runs(tmp_path: Path) -> None:
    place = with_pages(tmp_path)
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, PAPER)
        for name in ("reports", "store"):
            results = repro.load(place / name)
            assert results.marks("small2020", "search", "bowl") == {
                "guess": {"mean": 0.05}, "wide": {"mean": 0.5}
            }  # fmt: skip
            axes = results.plot.runs("small2020", "search", "bowl")
            (marks,) = [line for line in axes.lines if line.get_marker() == "D"]
            assert len(np.asarray(marks.get_xdata())) == 2


def test_verdict_is_drawn_as_interval_band_and_printed_value(results: Results) -> None:
    one = results.findings.iloc[0]

    axes = results.plot.verdict("small2020", one["id"])

    interval, printed = axes.lines
    scale = CostScale.of(
        np.array([one[n] for n in ("measured_low", "measured_high", "accepted_low",
                                   "accepted_high")] + [0.05])
    )  # fmt: skip
    ends = scale.place(np.array([one["measured_low"], one["measured_high"]]))
    assert np.asarray(interval.get_xdata()) == pytest.approx(ends)
    assert np.asarray(printed.get_xdata()) == pytest.approx(scale.place(np.array([0.05, 0.05])))
    assert one["verdict"] in axes.get_title()
    with pytest.raises(InputError, match="no id 'nothing'; there are: "):
        results.plot.verdict("small2020", "nothing")


def test_centre_bias_is_drawn_of_pages_and_of_the_store_alike(tmp_path: Path) -> None:
    spheres = replace(PAPER.experiments[0], problems={"F1": FUNCTIONS["sphere"].problem(2)}, runs=2)
    paper = replace(PAPER, experiments=(spheres,), results=(), claims=())
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, paper)
        places = ("--store", f"{tmp_path}/store", "--reports", f"{tmp_path}/reports")
        assert main(("reproduce", *places, "--repeats", "2", "--workers", "1")) == 0
        drawn = []
        for name in ("reports", "store"):
            results = repro.load(tmp_path / name)
            axes = results.plot.centre_bias("small2020", "search")
            assert [text.get_text() for text in axes.get_yticklabels()] == [
                "guess", "wide", "DE (control)", "random search (floor)"
            ]  # fmt: skip
            drawn.append([float(np.asarray(line.get_xdata())[0]) for line in axes.lines])
    assert drawn[0] == pytest.approx(drawn[1], abs=1e-5)  # of six digits


def test_experiment_without_moved_optima_has_no_bias_to_draw(results: Results) -> None:
    with pytest.raises(InputError, match="no optimum of search of small2020 was moved in"):
        results.plot.centre_bias("small2020", "search")


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
