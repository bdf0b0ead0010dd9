"""What no other reading of a paper may say: what it changes must be able to run, and be judged."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

from repro.errors import ReproError
from repro.model.assumptions import Alternative
from repro.model.claims import CellClaim, Claim
from repro.model.experiment import Experiment
from repro.model.faults import claim_faults, experiment_faults
from repro.model.known_words import known_words, shown_value

PROTOCOL = ("population", "iterations", "runs", "evaluations")


def reading_faults(
    alternative: Alternative, experiments: Iterable[Experiment], claims: Iterable[Claim]
) -> Iterator[str]:
    """Yield what is wrong with the experiments as an alternative has them, and with its claims.

    The experiments themselves must be sound. A claim of an alternative takes the place of one of
    the paper's `claims`, on the same cell or of the same words.
    """
    place = f"alternative {alternative.says!r}"
    changed, faults = [], []
    for experiment in experiments:
        found = list(_change_faults(experiment, alternative))
        if not found:
            changed.append(_changed(experiment, alternative))
            found = list(experiment_faults(changed[-1]))
        faults += found
    yield from (f"{place}: {fault}" for fault in faults)
    known = {_told(claim) for claim in claims}
    for claim in alternative.claims:
        if not isinstance(claim, Claim):
            yield f"{place}: {shown_value(claim)} is no claim"
        elif _told(claim) not in known:
            yield f"{place}: its claim {_told(claim)!r} takes the place of none of the paper's"
        elif not faults:
            yield from (f"{place}: {fault}" for fault in claim_faults(claim, changed))


def _told(claim: Claim) -> str:
    if isinstance(claim, CellClaim):
        return f"{claim.table.label}, {claim.row}, {claim.column}"
    return claim.claim


def _change_faults(experiment: Experiment, alternative: Alternative) -> Iterator[str]:
    place = f"experiment {experiment.name!r}"
    for name in alternative.protocol.get(experiment.name, {}):
        if name not in PROTOCOL:
            yield f"{place} has no {name!r} to replace; {known_words(name, PROTOCOL)}"
    for kind, changes, parts in _parts(experiment, alternative):
        for (of, name), change in changes.items():
            if of == experiment.name and isinstance(change, Mapping):
                yield from _field_faults(f"{place}, {kind} {name!r}", parts[name], change)


def _parts(
    experiment: Experiment, alternative: Alternative
) -> tuple[tuple[str, Mapping[tuple[str, str], Any], Mapping[str, Any]], ...]:
    return (
        ("algorithm", alternative.algorithms, experiment.algorithms),
        ("problem", alternative.problems, experiment.problems),
    )


def _field_faults(place: str, part: Any, change: Mapping[str, Any]) -> Iterator[str]:  # noqa: ANN401
    if not is_dataclass(part):
        yield f"{place} is no dataclass: give an object in its place, not fields of it"
        return
    known = [each.name for each in fields(part) if each.init]
    unknown = [name for name in change if name not in known]
    yield from (f"{place} has no field {name!r}; {known_words(name, known)}" for name in unknown)
    if not unknown:
        try:
            replace(part, **change)  # type: ignore[type-var]
        except (ReproError, TypeError, ValueError) as error:
            yield f"{place}: {' '.join(str(error).split())}"


def _changed(experiment: Experiment, alternative: Alternative) -> Experiment:
    """Return the experiment as the alternative has it."""
    found: dict[str, Any] = dict(alternative.protocol.get(experiment.name, {}))
    for kind, changes, parts in _parts(experiment, alternative):
        found[f"{kind}s"] = dict(parts) | {
            name: replace(parts[name], **change) if isinstance(change, Mapping) else change
            for (of, name), change in changes.items()
            if of == experiment.name
        }
    return replace(experiment, **found)
