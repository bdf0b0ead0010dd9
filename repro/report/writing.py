"""Writing the reports folder: the files of papers, the index and results.json."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from repro.report.files import remove_ours, usable_folder, write_file
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
    results = merged(entries, read_results(folder / "results.json"), known)
    files["results.json"] = results_text(results)
    kept = [entry["key"] for entry in results["papers"]]
    fresh = {key: each.provenance for key, each in made.items()}
    provenance = merged_provenance(fresh, read_json(folder / PROVENANCE), kept)
    files[PROVENANCE] = results_text(provenance)
    # pages of papers that were made by another call stay, and so does what those are called
    all_called = {key: each.get("called", "") for key, each in provenance["papers"].items()}
    files |= index_files(results, read_json(folder / ANOTHER_SEED), all_called) | verdict_files()
    for name, content in files.items():
        write_file(folder / name, content)
    for page in (page for key in made for page in pages_of_paper(key) if page not in files):
        remove_ours(folder / page, f'<meta name="generator" content="{OURS}">')
    return results
