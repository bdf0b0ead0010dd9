"""Pages of the invented paper, made in a moment."""

import gzip
import re
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from repro.commands.written_pages import write_pages
from repro.model.paper import Paper
from repro.runs.plan import plan
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from tests.doe2021 import PAPER

ENVIRONMENT: dict[str, object] = {"date": "2021-02-03", "packages": {"numpy": "2"}, "cores": 2}


def pages_of(folder: Path, paper: Paper = PAPER, repeats: int = 2) -> dict[str, str]:
    """Run the paper, write its report below `folder`, and return every file by name."""
    tasks = plan([paper], repeats)
    with Store(folder / "store") as store:
        with ThreadPoolExecutor(2) as executor:
            run_missing(
                store,
                tasks,
                executor=executor,
                workers=2,
                environment=lambda: ENVIRONMENT,
                report=lambda *_: None,
            )
        write_pages(store, [paper], tasks, folder / "reports", [paper.key])
    return {
        str(path.relative_to(folder / "reports")): text_of(path)
        for path in sorted((folder / "reports").rglob("*"))
        if path.is_file()
    }


def rooms_of(pages: Mapping[str, str], key: str = PAPER.key) -> str:
    """Return the text of all HTML pages of a paper, the door's first."""
    own = (name for name in pages if re.fullmatch(rf"{re.escape(key)}(\.\w+)?\.html", name))
    return "".join(pages[name] for name in sorted(own, key=len))


def text_of(path: Path) -> str:
    """Return the text of a file, unpacked where it is packed."""
    content = path.read_bytes()
    return (gzip.decompress(content) if path.suffix == ".gz" else content).decode()
