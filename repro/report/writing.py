"""Writing the reports folder: the files of papers, the index and results.json."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from repro.report.files import usable_folder, write_file
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


def write_report(papers: Iterable[Made], folder: Path, known: Sequence[str]) -> Json:
    """Write the files of some papers, the index and results.json; return the results.

    `known` are the keys of all papers, in their order; entries of others are kept from before.
    """
    usable_folder(folder)
    made = {each.entry["key"]: each for each in papers}
    files: Files = {name: text for each in made.values() for name, text in each.files.items()}
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
    return results
