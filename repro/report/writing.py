"""Writing the reports folder: the files of papers, the index and results.json."""

from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path

from repro.report.earlier import RESULTS, refuse_foreign
from repro.report.pages import ANOTHER_SEED, index_files, verdict_files
from repro.report.results import (
    PROVENANCE,
    Files,
    Json,
    Made,
    merged,
    merged_provenance,
    read_json,
    read_results,
    results_text,
)
from repro.report.rooms import OURS, check_apart, pages_of_paper
from repro.runs.whole_files import read_file, usable_folder, write_file

_TOP = 1000  # bytes within which a page says what made it
_MARK = f'<meta name="generator" content="{OURS}">'.encode()


def write_report(papers: Iterable[Made], folder: Path, known: Sequence[str]) -> Json:
    """Write the files of some papers, the index and results.json; return the results.

    `known` are the keys of all papers, in their order; entries of others are kept from before.
    """
    usable_folder(folder)
    made = {each.entry["key"]: each for each in papers}
    files: Files = {}
    for key, each in made.items():
        check_apart(files, each.files, key)
        files |= each.files
    entries = [each.entry for each in made.values()]
    results = merged(entries, read_results(folder / RESULTS), known)
    files[RESULTS] = results_text(results)
    kept = [entry["key"] for entry in results["papers"]]
    fresh = {key: each.provenance for key, each in made.items()}
    provenance = merged_provenance(fresh, read_json(folder / PROVENANCE), kept)
    files[PROVENANCE] = results_text(provenance)
    # pages of papers that were made by another call stay, and so does what those are called
    all_called = {key: each.get("called", "") for key, each in provenance["papers"].items()}
    files |= index_files(results, read_json(folder / ANOTHER_SEED), all_called) | verdict_files()
    refuse_foreign(folder, files)
    # the results first: by them a call after one that was cut short knows the folder for ours
    for name in sorted(files, key=lambda name: name != RESULTS):
        write_file(folder, name, files[name])
    for page in (page for key in made for page in pages_of_paper(key) if page not in files):
        _remove_ours(folder / page)
    return results


def _remove_ours(page: Path) -> None:
    """Remove a page that is no longer made, if it carries our mark near its top; no other file."""
    with suppress(OSError):
        if not page.is_symlink() and _MARK in read_file(page)[:_TOP]:
            page.unlink()
