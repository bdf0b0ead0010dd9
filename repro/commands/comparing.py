"""What a comparison does, for the command and for Python: plan, run, check, judge."""

import shlex
from argparse import Namespace
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from repro.commands.arguments import STORE
from repro.commands.compare_entrants import home_of, libraries
from repro.commands.compiled_code import say_whether_kept
from repro.commands.running import run_lacking
from repro.determinism.provenance import provenance
from repro.errors import InputError
from repro.judge.centre_bias import users_bias
from repro.judge.certificates import certify
from repro.judge.comparison import Asked, Comparison, Missing, Part
from repro.judge.users_search import chance_warnings, users_search
from repro.model.evidence import Evidence
from repro.model.paper import Paper
from repro.optimisers.libraries import BASELINES
from repro.runs.compared import Compared, beside, moved, moved_tasks, narrowed, remember
from repro.runs.gather import gather
from repro.runs.honesty import identical, probed
from repro.runs.moved_optima import CONTROL, FLOOR
from repro.runs.plan import Task, plan
from repro.runs.run import Record
from repro.runs.store.store import Store
from repro.runs.studies import ENOUGH, studies
from repro.runs.workers.local import checked_workers, local

_LONGEST = 1e7  # seconds, of a time limit: no run takes months


def compared(
    asked: Asked,
    papers: Sequence[Paper],
    options: Namespace,
    reporting: Callable[[], Callable[[int, int], None]],
    *,
    ready: Callable[[], object] = tuple,
) -> Comparison:
    """Run the searches as far as the store lacks them, make one again, and judge all.

    Options say where and by whom runs are made (`store`, `workers`, `dask`, `called`); `reporting`
    makes what shows progress, once for the protocols and once for moved optima; `ready` is called
    before. Raises InputError for a name that is unknown and a number that cannot be.
    """
    own = _protocols(asked, papers)
    tasks = _tasks(asked, own)
    ready()
    say_whether_kept()
    used = libraries(getattr(search, "place", "") for search in asked.searches.values())
    made = partial(run_lacking, options=options, environment=partial(_environment, used))
    with Store(options.store, say=options.say) as store:
        failed = made(store, tasks, report=reporting())
        remember(options.store, _noted(asked, own), options.say)
        stored = {record.task.key: record for record in store.records(tasks)}
        if aside := _moved(asked, own, stored.values()):
            failed += made(store, aside, report=reporting())
        parts = tuple(
            part for paper in papers if paper.key in own
            for part in _parts(store, paper, own[paper.key], tasks, asked)
        )  # fmt: skip
    with local(checked_workers(options.workers)) as executor:
        seen = probed(tasks, stored, executor)
    warnings = (*seen, *identical(tasks, stored), *chance_warnings(part.found for part in parts))
    return Comparison(
        asked=asked, parts=parts,
        records=tuple(stored[task.key] for task in tasks if task.key in stored),
        failed=tuple(failed), warnings=warnings,
        missing=tuple(_missing(parts, asked, options)), libraries=used,
    )  # fmt: skip


def silence() -> Callable[[int, int], None]:
    """Return what shows no progress."""
    return lambda _done, _total: None


def _environment(used: Mapping[str, str]) -> dict[str, object]:
    """Return the provenance of runs, with the versions of what their searches import."""
    return {**provenance(), "libraries": dict(used)}


def _tasks(asked: Asked, own: Mapping[str, Paper]) -> list[Task]:
    """Return the runs of the searches, each with its time limit."""
    planned = plan(own.values(), asked.repeats, protocol_only=True)
    return [replace(task, timeout=asked.timeout) for task in planned]


def _moved(asked: Asked, own: Mapping[str, Paper], stored: Iterable[Record]) -> list[Task]:
    """Return the runs with optima moved aside, of searches that failed in no run in place."""
    failing = {record.task.algorithm for record in stored if record.reason}
    planned = (task for paper in own.values() for task in moved_tasks(paper))
    return [
        replace(task, timeout=asked.timeout)
        for task in planned
        if asked.centre_bias and task.algorithm not in failing
    ]


def _protocols(asked: Asked, papers: Sequence[Paper]) -> dict[str, Paper]:
    """Return the papers narrowed, by key; InputError for what none of them has."""
    experiments = {e.name: e for paper in papers for e in paper.experiments}
    all_of = [e for paper in papers for e in paper.experiments]
    known = {
        "--experiment": (asked.experiments, list(experiments)),
        "--problem": (asked.problems, [name for e in all_of for name in e.problems]),
        "--algorithm": (asked.against, [n for e in all_of for n in (*e.algorithms, *BASELINES)]),
    }
    for option, (wanted, names) in known.items():
        for name in wanted:
            if name not in names:
                shown = ", ".join(dict.fromkeys(names))
                message = f"{option} {name!r} is in none of these papers; they have {shown}"
                raise InputError(message)
    if asked.runs is not None and asked.runs < 1:
        message = f"--runs is {asked.runs}; it must be 1 or more"
        raise InputError(message)
    if asked.timeout is not None and not 0.0 < asked.timeout < _LONGEST:
        message = f"--timeout is {asked.timeout}; it must be a number of seconds above 0"
        raise InputError(message)
    found = {
        paper.key: narrowed(
            paper, dict(asked.searches), experiments=asked.experiments, problems=asked.problems,
            runs=asked.runs,
        )
        for paper in papers
    }  # fmt: skip
    kept = {key: paper for key, paper in found.items() if paper.experiments}
    if not kept:
        message = f"no experiment has both {', '.join((*asked.experiments, *asked.problems))}"
        raise InputError(message)
    return kept


def _noted(asked: Asked, own: Mapping[str, Paper]) -> list[Compared]:
    return [
        Compared(
            paper=key, name=name, place=search.place, experiments=asked.experiments,
            problems=asked.problems, runs=asked.runs, repeats=asked.repeats,
            folder=home_of(search.place),
        )
        for key in own
        for name, search in asked.searches.items()
        if getattr(search, "place", "")
    ]  # fmt: skip


def _parts(
    store: Store, paper: Paper, own: Paper, tasks: Sequence[Task], asked: Asked
) -> list[Part]:
    """Return each experiment judged, with the runs of others that the store has of it."""
    others = _others(store, beside(paper, own), asked)
    aside = replace(own, experiments=(*own.experiments, *moved(own)))
    found = gather(store, aside, (*tasks, *(moved_tasks(own) if asked.centre_bias else ())))
    runs = {**others.runs, **found.runs}
    certificates = certify(paper)
    parts = []
    for some in beside(paper, own).experiments:
        judged = users_search(
            paper, some, runs, certificates, name=tuple(asked.searches), against=asked.against
        )
        evidence = Evidence(paper.key, (some,), runs)
        bias = users_bias(some, evidence, asked.searches, against=asked.against)
        parts.append(Part(paper=paper, experiment=some, found=judged, evidence=evidence, bias=bias))
    return parts


def _others(store: Store, paper: Paper, asked: Asked) -> Evidence:
    """Return the runs of others that stand beside: of no reading, and of whom is asked for."""
    besides = [each for each in studies(paper, ENOUGH) if asked.centre_bias or each.kind != "shift"]
    wanted = {*asked.against, CONTROL, FLOOR}
    planned = plan([paper], ENOUGH)
    some = [task for task in planned if not asked.against or task.algorithm in wanted]
    return gather(store, paper, some, besides)


def _missing(parts: Sequence[Part], asked: Asked, options: Namespace) -> list[Missing]:
    found = []
    for part in parts:
        name = part.experiment.name
        lacking = tuple(
            algorithm
            for algorithm in part.experiment.algorithms
            if (not asked.against or algorithm in asked.against)
            and any((name, problem, algorithm) not in part.evidence.runs
                    for problem in part.experiment.problems)
        )  # fmt: skip
        if lacking:
            called = options.called.get(part.paper.key, part.paper.key)
            at = [] if options.store == STORE else [f"--store={options.store}"]
            command = shlex.join(["repro", "reproduce", called, *at])
            found.append(Missing(
                paper=part.paper.key, experiment=name, algorithms=lacking, command=command
            ))  # fmt: skip
    return found
