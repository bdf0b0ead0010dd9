"""True tables of statistics: of costs, of whole numbers, of test functions, of equal methods."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from repro.tables.audit_options import AuditOptions
from repro.tables.possible_runs import FEW, ONE_OF_THESE, TRIED, USUAL
from tests.true_tables.functions import function_runs, minimum_told
from tests.true_tables.pipelines import (
    Pipeline,
    drawn_pipeline,
    statistics_of,
    texts_of,
)
from tests.true_tables.samples import DOMAINS, MINIMA, Generator, Vector, number_of_runs, runs_of
from tests.true_tables.written import TrueTable, written

METHODS = ("GWO", "PSO", "DE")
ENDS = {"best": "Best", "worst": "Worst", "lowest": "Min", "highest": "Max"}
WORDS = (
    ENDS
    | {"mean": "Mean", "median": "Median", "q1": "Q1", "q3": "Q3", "std": "Std"}
    | {"iqr": "IQR"}
)
SPREAD_WORDS = {"std": "Std", "variance": "Variance", "sem": "SEM"}
FORMS_OF_N = ("{n} independent runs", "n = {n}", "runs: {n}", "over {n} trials")
NOT_TOLD = 0.01  # tables without a number of runs, each of which is tried with many numbers
Texts = Mapping[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Setting:
    """What all blocks of a table share."""

    n: int
    names: tuple[str, ...]
    pipeline: Pipeline
    domain: str
    options: Mapping[str, Any]
    title: str


def block_table(rng: Generator) -> TrueTable:
    """Return a table of statistics of some methods on some problems."""
    setting = drawn_setting(rng, DOMAINS[int(rng.integers(len(DOMAINS)))])
    minimum = float(MINIMA[int(rng.integers(len(MINIMA)))]) if setting.domain == "minimum" else 0.0
    options = dict(setting.options)
    if setting.domain == "minimum":
        options["minimum"] = {"": minimum_told(minimum)}
    problems, methods = int(rng.integers(1, 4)), METHODS[: int(rng.integers(1, 3))]
    texts = [
        {
            method: _printed(rng, setting, runs_of(rng, setting.n, setting.domain, minimum))
            for method in methods
        }
        for _ in range(problems)
    ]
    return _table(rng, setting, texts, options)


def shared_table(rng: Generator) -> TrueTable:
    """Return a table of methods that share rows: both reach the optimum, or one is the other."""
    setting = drawn_setting(rng, "errors")
    texts = []
    for _ in range(int(rng.integers(1, 4))):
        runs = runs_of(rng, setting.n, "errors")
        if rng.random() < 0.5:  # every run ends at one optimum
            runs = runs * 0 + runs[0]
        same = _printed(rng, setting, runs)
        texts.append(dict.fromkeys(METHODS[:2], same))
    return _table(rng, setting, texts, setting.options)


def function_table(rng: Generator) -> TrueTable:
    """Return a table of a test function of the package, computed by a program of another hand."""
    setting = drawn_setting(rng, "errors")
    single = setting.pipeline.precision != "double"
    setting = replace(setting, pipeline=replace(setting.pipeline, maximise=False))
    runs, bounds, broken = function_runs(rng, setting.n, single=single)
    options = {name: told for name, told in setting.options.items() if name != "errors"}
    texts = [{METHODS[0]: _printed(rng, setting, runs)}]
    table = _table(rng, setting, texts, {**options, "functions": {"": bounds}})
    return replace(table, broken=table.broken | broken)


def drawn_setting(rng: Generator, domain: str) -> Setting:
    """Return what a table prints, how it was made, and what of it is told or guessed."""
    maximise = domain in {"any", "whole"} and rng.random() < 0.4
    pipeline, n = drawn_pipeline(rng, maximise=maximise), number_of_runs(rng)
    ends = ("best", "worst") if rng.random() < 0.7 else ("lowest", "highest")
    able = (ends[0], "mean", "median", "q1", "q3", ends[1])
    shares = (0.8, 0.95, 0.4, 0.15, 0.15, 0.8)
    kept = [name for name, share in zip(able, shares, strict=True) if rng.random() < share]
    spread = ("std", "std", "std", "variance", "sem")[int(rng.integers(5))]
    spreads = [spread] if rng.random() < 0.9 else []
    names = (*(kept or ["mean"]), *spreads, *(["iqr"] if rng.random() < 0.1 else []))
    title = FORMS_OF_N[int(rng.integers(len(FORMS_OF_N)))].format(n=n)
    setting = Setting(n=n, names=names, pipeline=pipeline, domain=domain, options={}, title=title)
    return _told(rng, setting)


def _told(rng: Generator, setting: Setting) -> Setting:
    """Return the setting with what is told of it, by options or in the title."""
    options: dict[str, Any] = {}
    title, pipeline = setting.title, setting.pipeline
    if rng.random() < 0.5:
        options["runs"], title = setting.n, "Results"
    elif rng.random() < 2 * NOT_TOLD:
        title = "Results"
    if pipeline.maximise and rng.random() < 0.5:
        options["maximise"] = True
    if setting.domain == "errors":
        if rng.random() < 0.5:
            options["errors"] = True
        else:
            title = f"Errors, {title}"
    if setting.domain == "whole" and rng.random() < 0.8:
        options["integers"] = True
    if pipeline.precision != "runs in single" and rng.random() < 0.1:
        options["precision"] = pipeline.precision
    if pipeline.prints == "four digits of R" and rng.random() < 0.3:
        options["significant"] = 4
    return replace(setting, options=options, title=title)


def _printed(rng: Generator, setting: Setting, runs: Vector) -> Texts:
    values = statistics_of(runs, setting.pipeline, setting.names)
    texts = texts_of(values, setting.pipeline, rng)
    return {name: texts.get(name, "inf") for name in setting.names}


def _table(
    rng: Generator,
    setting: Setting,
    texts: Sequence[Mapping[str, Texts]],
    options: Mapping[str, Any],
) -> TrueTable:
    """Write the blocks by problem and method, in one of the usual layouts."""
    words, names = {**WORDS, **SPREAD_WORDS}, setting.names
    methods = list(texts[0])
    pairs = {"mean", "std"} <= set(names) and rng.random() < 0.3
    lines: list[list[str]]
    if pairs and len(methods) > 1:  # mean ± std by problem and method, and nothing else
        lines = [["Function", *methods]]
        lines += [
            [f"F{k}", *(f"{each[m]['mean']} ± {each[m]['std']}" for m in methods)]
            for k, each in enumerate(texts, 1)
        ]
    elif len(methods) > 1 and rng.random() < 0.5:  # a line for each statistic
        lines = [["Function", "Index", *methods]]
        lines += [
            [f"F{k}", words[name], *(each[m][name] for m in methods)]
            for k, each in enumerate(texts, 1)
            for name in names
        ]
    else:  # a line for each block
        lines = [["Function", "Algorithm", *(words[name] for name in names)]]
        lines += [
            [f"F{k}", method, *(each[method][name] for name in names)]
            for k, each in enumerate(texts, 1)
            for method in methods
        ]
    return TrueTable(
        made=f"{setting.domain}, n = {setting.n}, {setting.pipeline.words}",
        text=written(rng, setting.title, lines),
        options=AuditOptions(**options),
        broken=setting.pipeline.broken
        | ({ONE_OF_THESE} if setting.n not in {FEW, USUAL, TRIED[-1]} else set()),
    )
