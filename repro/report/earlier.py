"""What stands in a reports folder before a call writes there: taken over, set aside, or refused.

Results of papers that are not judged again are taken over from the files of an earlier call. A
file that cannot be read is never replaced: a call that judges all papers sets it aside, and one
that would lose what it says of others refuses.
"""

import json
import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from repro.errors import InputError
from repro.report.pages import ANOTHER_SEED
from repro.report.results import PROVENANCE, SCHEMA
from repro.report.rooms import check_names, pages_of_paper
from repro.report.verdict_pages import VERDICTS
from repro.runs.whole_files import read_file, set_aside

RESULTS = "results.json"
_PAGES = ("index.html", "index.md", f"{VERDICTS}.html", f"{VERDICTS}.md", PROVENANCE)
_SIGN = "verdicts.md"  # a page that no other program writes
_MARK = b'"findings"'  # and a word of every results.json, a broken one too
_OF_A_PAPER = {
    *("key", "title", "control", "summary", "provenance", "findings", "audit", "certificates"),
    *("tests", "standings", "assumptions", "errata", "gaps"),
}


def check_folder(folder: Path, chosen: Iterable[str], known: Iterable[str]) -> None:
    """Raise InputError, before any run, where pages of chosen papers cannot be written.

    `known` are the keys of all papers: what earlier files say of those that are not chosen stays.
    """
    keys = list(chosen)
    check_names((*known, *keys))
    pages = (*_PAGES, *(page for key in keys for page in pages_of_paper(key)))
    refuse_foreign(folder, pages)
    others = [key for key in dict.fromkeys(known) if key not in keys]
    for path, reason in unreadable(folder) if others else ():
        message = (
            f"{path} cannot be read ({reason}), and what it says of {', '.join(others)} would be "
            "lost: mend it, or ask for all papers, which sets it aside"
        )
        raise InputError(message)


def refuse_foreign(folder: Path, names: Iterable[str]) -> None:
    """Raise InputError where one of these files would replace what is not of repro."""
    ours = _is_ours(folder)
    for name in names:
        path = folder / name
        if path.is_dir() and not path.is_symlink():
            message = f"{path} is a folder, and a file of this name is to be written"
            raise InputError(message)
        if not ours and os.path.lexists(path):
            message = (
                f"{path} is not of repro, as no results stand beside it: "
                "name another folder for the pages"
            )
            raise InputError(message)


def keep_earlier(
    folder: Path, chosen: Iterable[str], known: Iterable[str], say: Callable[[str], None]
) -> None:
    """Set aside what cannot be read and is about to be written, with a line for each.

    Raises InputError as `check_folder`.
    """
    check_folder(folder, chosen, known)
    for path, reason in unreadable(folder):
        say(f"{path} cannot be read ({reason}); it is set aside as {set_aside(path)}")
    path = folder / ANOTHER_SEED
    if reason := _fault(path, _any_object):
        say(f"{path} cannot be read ({reason}); the index says nothing of another seed")


def unreadable(folder: Path) -> Iterator[tuple[Path, str]]:
    """Yield each file of an earlier call that is there and cannot be read, and why."""
    for name, fault_of in ((RESULTS, _of_results), (PROVENANCE, _of_provenance)):
        if reason := _fault(folder / name, fault_of):
            yield folder / name, reason


def _is_ours(folder: Path) -> bool:
    if (folder / _SIGN).exists():
        return True
    try:
        return _MARK in read_file(folder / RESULTS)
    except OSError:
        return False


def _fault(path: Path, fault_of: Callable[[dict[str, Any]], str]) -> str:
    """Return what is wrong with a file of JSON, "" for one that is right or not there."""
    try:
        content = json.loads(read_file(path).decode())
    except (FileNotFoundError, NotADirectoryError):
        return ""
    except OSError as error:
        return str(error.strerror)
    except json.JSONDecodeError as error:
        return f"line {error.lineno}: {error.msg}"
    except (ValueError, RecursionError):
        return "it is no text of JSON"
    return fault_of(content) if isinstance(content, dict) else "it holds no object"


def _of_results(content: dict[str, Any]) -> str:
    if content.get("schema") != SCHEMA:
        return f"its schema is {content.get('schema')!r:.20}, not {SCHEMA}"
    papers = content.get("papers")
    if not isinstance(papers, list):
        return "it has no list of papers"
    for number, paper in enumerate(papers, 1):
        lacking = _OF_A_PAPER - paper.keys() if isinstance(paper, dict) else _OF_A_PAPER
        if lacking:
            return f"paper {number} in it lacks {min(lacking)}"
    return ""


def _of_provenance(content: dict[str, Any]) -> str:
    return "" if isinstance(content.get("papers"), dict) else "it has no papers"


def _any_object(_content: dict[str, Any]) -> str:
    return ""
