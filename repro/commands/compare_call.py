"""`repro.compare`: a search of one's own beside the others, from Python or a notebook."""

import html
import sys
from argparse import Namespace
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from repro.commands import catalogue
from repro.commands.arguments import STORE
from repro.commands.compare_entrants import check_name, stem
from repro.commands.comparing import compared, silence
from repro.commands.progress import Progress
from repro.commands.shown_rows import warn
from repro.determinism.read_anew import read_anew
from repro.errors import InputError
from repro.judge.comparison import Asked, Comparison
from repro.optimisers.held_search import entrant_of
from repro.report.compared_pages import as_json, compared_files, write_comparison
from repro.runs.honesty import Warned
from repro.runs.whole_files import usable_folder

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class ComparedResult:
    """What a comparison found; in a notebook it draws itself.

    `runs`, `standings` and `tests` are frames with a row a thing, as in `NAME.json` of the command.
    """

    comparison: Comparison

    @property
    def warnings(self) -> tuple[Warned, ...]:
        """What a reader must know, each with a kind and what it says."""
        return self.comparison.warnings

    @cached_property
    def runs(self) -> "pd.DataFrame":
        """A row for each run of the searches."""
        return self._frame("runs")

    @cached_property
    def standings(self) -> "pd.DataFrame":
        """A row for each algorithm on each problem."""
        return self._frame("standings")

    @cached_property
    def tests(self) -> "pd.DataFrame":
        """A row for each rank-sum test."""
        return self._frame("tests")

    def _frame(self, name: str) -> "pd.DataFrame":
        import pandas as pd  # noqa: PLC0415 (loaded where it is asked for)

        return pd.DataFrame(as_json(self.comparison)[name])

    def save(self, folder: str | Path) -> Path:
        """Write page, Markdown, JSON and CSV into a folder, and return the page's path."""
        usable_folder(Path(folder), "the folder")
        called = stem(Path(folder), list(self.comparison.asked.searches))
        return write_comparison(Path(folder), called, self.comparison)

    def _repr_html_(self) -> str:
        """Return the page in a frame of its own, so that its style leaves the notebook alone."""
        page = html.escape(compared_files(self.comparison)[".html"])
        return f'<iframe srcdoc="{page}" width="100%" height="640" style="border:0"></iframe>'


def compare(
    search: Any,  # noqa: ANN401 (whatever the user wrote)
    *,
    papers: Sequence[str] = (),
    experiments: Sequence[str] = (),
    problems: Sequence[str] = (),
    algorithms: Sequence[str] = (),
    runs: int | None = None,
    repeats: int = 1,
    name: str | None = None,
    store: str | Path = STORE,
    workers: int | None = None,
    timeout: float | None = None,
    centre_bias: bool = True,
    quiet: bool = False,
) -> ComparedResult:
    """Run a search under the protocols of papers and return where it stands beside the others.

    `search` is a callable or an object in any form that `repro compare` knows, its place as text,
    or several of them by name in a mapping; it may stand in a notebook's cell. Empty lists name
    all; `timeout` is in seconds a run; with `centre_bias` it is run on moved optima, too. Raises
    InputError for what cannot be used.
    """
    read_anew()  # a module may have been edited since the last call
    given = search if isinstance(search, Mapping) else {name or _called(search): search}
    options = Namespace(
        keys=[str(key) for key in papers], store=Path(store), workers=workers, dask=None, say=warn
    )
    chosen = [paper for paper in catalogue.chosen(options) if paper.experiments]
    if not chosen:
        message = f"no experiments in {', '.join(options.keys)}: no protocol to run a search under"
        raise InputError(message)
    for known in given:
        check_name(known, chosen)
    asked = Asked(
        searches={known: entrant_of(each, known) for known, each in given.items()},
        experiments=tuple(experiments), problems=tuple(problems), against=tuple(algorithms),
        runs=runs, repeats=repeats, timeout=timeout, centre_bias=centre_bias,
    )  # fmt: skip
    return ComparedResult(compared(asked, chosen, options, silence if quiet else _bar))


def _called(search: object) -> str:
    if isinstance(search, str):
        return search.rpartition(":")[2]
    return str(getattr(search, "__name__", type(search).__name__))


def _bar() -> Callable[[int, int], None]:
    """Return what shows progress: a bar that is redrawn in a notebook, lines elsewhere."""
    ipython = sys.modules.get("IPython")
    if ipython is None or getattr(ipython.get_ipython(), "kernel", None) is None:
        return Progress()
    from IPython import display as shows  # noqa: PLC0415 (loaded there already)

    handles: list[Any] = []

    def report(done: int, total: int) -> None:
        drawn = _drawn(shows.HTML, done, total)
        if handles:
            handles[0].update(drawn)
        else:
            display: Any = shows.display
            handles.append(display(drawn, display_id=True))

    return report


def _drawn(made: Callable[[str], Any], done: int, total: int) -> Any:  # noqa: ANN401
    return made(f'<progress value="{done}" max="{total}"></progress> {done} of {total} runs')
