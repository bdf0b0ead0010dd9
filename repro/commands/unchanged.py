"""Whether the pages stand as they were written, so that a call with nothing to do writes nothing.

Pages follow from the declared papers, the stored runs, the source and templates, the installed
packages, the machine, and what the reports folder held before. A digest of all of them is kept
beside the runs when the pages are written; while it is the same, writing again gives the same
bytes. Whatever it does not know of counts as a change: without a digest pages are written.
"""

import hashlib
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import repro
from repro.determinism.provenance import provenance
from repro.determinism.trees import installed, tree
from repro.errors import InputError
from repro.runs.plan import Task
from repro.runs.store.store import Store
from repro.runs.whole_files import read_file, write_file

_NAME = "repro-pages"
_OF_THE_DAY = ("date", "commit")  # what the provenance of a call says besides its machine


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """What pages are of, and where: tasks, chosen and known papers, the reports folder.

    `declarations` are the folders with the papers' modules.
    """

    tasks: Sequence[Task]
    chosen: Sequence[str]
    known: Sequence[str]
    declarations: Sequence[str]
    reports: Path

    def stand(self, store: Store) -> bool:
        """Return whether no run is missing and writing the pages would change no byte.

        A store that is damaged since they were written is not the same, and reading it says so.
        """
        try:
            kept = read_file(store.folder / _NAME).decode()
            runs = store.fingerprint()
            if runs is None or kept != self._digests(runs):
                return False
        except (OSError, ValueError):
            return False
        return not any(store.lacking(self.tasks))

    def remember(self, store: Store) -> None:
        """Keep digests of the pages just written and of what they follow from."""
        runs = store.fingerprint()
        if runs is None:
            return
        # without it pages are written again: of a file that may not be read, or no place for it
        with suppress(OSError, InputError):
            write_file(store.folder, _NAME, self._digests(runs))

    def _digests(self, runs: str) -> str:
        """Return the place of the reports, a digest of what they follow from, and one of them."""
        digest = hashlib.sha256()
        for part in (self.chosen, self.known, *installed(), *machine()):
            digest.update(f"{part}\0".encode())
        for folder in (*repro.__path__, *self.declarations):
            digest.update(tree(Path(folder)))
        for task in self.tasks:
            digest.update(task.key.encode())
        digest.update(runs.encode())
        return f"{self.reports.resolve()}\n{digest.hexdigest()}\n{tree(self.reports).hex()}\n"


def machine() -> Iterator[str]:
    """Yield what decides the last bits of a run here, and where it is made."""
    for name, value in provenance().items():
        if name not in _OF_THE_DAY:
            yield f"{name} {value}"
