"""The reports folder that the browser looks at: every paper, by a protocol of a few runs."""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

from repro.commands.catalogue import all_papers
from repro.commands.written_pages import write_pages
from repro.model.cells import every_cell
from repro.model.claims import lowest_everywhere
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.model.tolerances import Percent
from repro.runs.plan import Task, plan
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.studies import ENOUGH
from tests.doe2021 import COSTS, MOTION, TEST
from tests.doe2021 import PAPER as DOE
from tests.made_up import ENVIRONMENT

POPULATION = 8  # the least that most of the papers' algorithms take
DUNG_BEETLES = 20  # the least for DBO, which parts its population in four
INJECTION = '<img src=x onerror="document.title=1">'
CLAIM = f"a claim's</script><script>document.title=2</script>{INJECTION}"


def small(paper: Paper) -> Paper:
    """Return the paper with its tables and claims as they are, and runs that take seconds."""
    return replace(paper, experiments=tuple(map(_small, paper.experiments)))


def _small(experiment: Experiment) -> Experiment:
    least = DUNG_BEETLES if "DBO" in experiment.algorithms else POPULATION
    return replace(experiment, runs=min(experiment.runs, 2), population=least)


def hostile() -> Paper:
    """Return a paper whose title, claims and an algorithm's name try to become markup."""
    test = replace(
        TEST, algorithms={"WOA": TEST.algorithms["WOA"], INJECTION: TEST.algorithms["PSO"]}
    )
    costs = replace(COSTS, columns=(COSTS.columns[0], replace(COSTS.columns[1], name=INJECTION)))
    return replace(
        DOE,
        key="hostile",
        source=replace(DOE.source, title=f"</title>{CLAIM}", authors=CLAIM),
        summary=CLAIM,
        experiments=(test, MOTION),
        results=(costs,),
        claims=(
            *every_cell(
                costs,
                of=test,
                rows=("problem", "statistic"),
                columns="algorithm",
                names={"Best": "best", "Mean": "mean"},
                within=Percent(20),
            ),
            *lowest_everywhere(
                test, algorithm=INJECTION, statistic="mean", claim=CLAIM, where=CLAIM
            ),
        ),
    )


def make_pages(folder: Path) -> Path:
    """Run every paper's small protocol and write its pages; return the reports folder.

    The first paper is run twice over, which is what other readings of it need.
    """
    first, *others = map(small, all_papers().values())
    invented = (DOE, hostile())
    tasks = (*plan([first], 2), *plan(others, 1), *plan(invented, 2))
    return _written(folder, (first, *others, *invented), tasks)


def make_asked_pages(folder: Path) -> Path:
    """Write the pages of which readers' questions are asked; return the reports folder.

    liang2026 has a small protocol, as often as baselines wait for; of smwoa2022, as it is printed,
    nothing is run: what the audit says of it follows from the printed number of runs.
    """
    papers = all_papers()
    run = small(papers["liang2026"])
    return _written(folder, (run, papers["smwoa2022"]), plan([run], ENOUGH))


def _written(folder: Path, papers: Sequence[Paper], tasks: Sequence[Task]) -> Path:
    with Store(folder / "store") as store, ThreadPoolExecutor(2) as executor:
        run_missing(
            store,
            tasks,
            executor=executor,
            workers=2,
            environment=lambda: ENVIRONMENT,
            report=lambda *_: None,
        )
        write_pages(store, papers, tasks, folder / "reports", [paper.key for paper in papers])
    return folder / "reports"
