"""What any paper must satisfy beyond loading, and what the papers of this house have besides."""

from collections import Counter
from collections.abc import Iterable, Iterator

from repro.model.assumptions import Assumption
from repro.model.claims import CellClaim
from repro.model.measures.measure import Statistic
from repro.model.open_points import Gap
from repro.model.paper import Paper
from repro.tables.headings import runs_in


def contract_faults(paper: Paper) -> Iterator[str]:
    """Yield what no paper may do, a line each."""
    for label, times in Counter(table.label for table in paper.tables).items():
        if times > 1:
            yield f"{times} tables are called {label!r}: a label names one table"
    for table in paper.tables:
        if table.where == table.label:
            yield f"{table.label}: it does not say where it stands, as in '{table.label}, p. 3'"
    yield from _without_a_place(paper)
    for assumption in paper.assumptions:
        yield from _of_a_choice(assumption)
    for what, because in (
        *((f"erratum {each.printed!r}", each.because) for each in paper.errata),
        *((f"gap {each.what!r}", each.because) for each in paper.gaps),
    ):
        if not because.strip():
            yield f"{what}: it has no reason (because)"
    yield from _other_counts(paper)
    for what, gap in _left_to(paper):
        if gap not in paper.gaps:
            yield f"{what}: its gap {gap.what!r} is not among the paper's gaps"


def _other_counts(paper: Paper) -> Iterator[str]:
    """Yield the tables whose caption tells another number of runs than their experiment has."""
    runs = {experiment.name: experiment.runs for experiment in paper.experiments}
    pairs = {
        (claim.table.where, claim.table.label, claim.measure.experiment)
        for claim in paper.claims
        if isinstance(claim, CellClaim) and isinstance(claim.measure, Statistic) and not claim.gap
    }
    for where, label, name in sorted(pairs):
        told = {n for n, _ in runs_in(where)}
        if told and runs[name] not in told:
            counts = " and ".join(map(str, sorted(told)))
            yield f"{label}: its caption tells {counts} runs, experiment {name!r} has {runs[name]}"


def _left_to(paper: Paper) -> Iterator[tuple[str, Gap]]:
    """Yield what is left to a gap, in words, and the gap."""
    for experiment in paper.experiments:
        for name, gap in experiment.left_out.items():
            yield f"experiment {experiment.name!r}, left_out {name!r}", gap
    for claim in paper.claims:
        if not isinstance(claim, CellClaim) and claim.gap:
            yield claim.claim, claim.gap


def house_notes(paper: Paper) -> Iterator[str]:
    """Yield what papers of this house have and this one lacks: no fault of a paper from outside."""
    if not paper.read_twice and not paper.control:
        yield "its tables were not transcribed a second time, blind (read_twice)"
    if len(paper.together) not in {2, 3} and not paper.control:
        yield "no two or three alternatives are tried together (together)"
    if not paper.source.doi and not paper.source.note:
        yield "its source has neither a DOI nor a note on why there is none"
    if not paper.formulas:
        yield "no equation that the re-run follows is listed ([[formula]])"


def _without_a_place(paper: Paper) -> Iterator[str]:
    declared: dict[str, Iterable[tuple[str, str]]] = {
        "experiment": ((each.name, each.where) for each in paper.experiments),
        "assumption": ((each.what, each.where) for each in paper.assumptions),
        "erratum": ((each.printed, each.where) for each in paper.errata),
        "gap": ((each.what, each.where) for each in paper.gaps),
        "sentence": (
            (each.claim, each.where) for each in paper.claims if not isinstance(each, CellClaim)
        ),
    }
    for kind, several in declared.items():
        for name, where in several:
            if not where.strip():
                yield f"{kind} {name!r}: it does not say where it stands in the paper (where)"


def _of_a_choice(assumption: Assumption) -> Iterator[str]:
    place = f"assumption {assumption.what!r}"
    says = [alternative.says for alternative in assumption.alternatives]
    if not assumption.because.strip():
        yield f"{place}: it has no reason (because)"
    if not assumption.chosen.strip():
        yield f"{place}: it does not say what was chosen"
    if assumption.chosen in says:
        yield f"{place}: {assumption.chosen!r} is both chosen and an alternative"
    for text, times in Counter(says).items():
        if times > 1 or not text.strip():
            yield f"{place}: the alternative {text!r} stands there {times} times"
