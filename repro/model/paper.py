"""What a paper module declares."""

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any

from repro.errors import DeclarationError
from repro.model.assumptions import Assumption, alternative_faults
from repro.model.claims import CellClaim, Claim, Sentence, left_open
from repro.model.experiment import Experiment
from repro.model.faults import claim_faults, experiment_faults, text_faults
from repro.model.field_kinds import kind_faults, kind_words
from repro.model.figure_faults import FIGURES, RELATIONS, figure_faults, relation_faults
from repro.model.figures import Figure
from repro.model.known_words import shown_value
from repro.model.measures.measure import Statistic
from repro.model.open_points import Erratum, Gap
from repro.model.reading_faults import reading_faults
from repro.model.table_alone import TableAlone, alone_faults
from repro.tables.published import PublishedTable
from repro.tables.relations import Relation


@dataclass(frozen=True, slots=True, kw_only=True)
class Source:
    """How to cite the paper, as far as the copy at hand says it."""

    authors: str
    title: str
    year: int | None = None
    journal: str | None = None
    doi: str | None = None
    note: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionReading:
    """A motion problem under another reading of the paper: certified, but not run.

    `of` names the experiment and problem whose printed times are held against it.
    """

    name: str
    of: tuple[str, str]
    problem: Any


@dataclass(frozen=True, slots=True, kw_only=True)
class Formula:
    """An equation of the paper that the re-run follows.

    `latex` is its text, `code` the module or object that computes it; `departs` says where the
    re-run does something else than what is printed.
    """

    label: str
    where: str
    latex: str
    says: str
    code: str
    departs: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Paper:
    """One source paper: everything that is printed, open, wrong or missing, as data.

    `inputs` are printed tables that the re-run starts from, `results` those whose every cell is
    claimed, `audited` those that no run stands behind, with what is told of each; `relations` say
    what printed numbers must be to each other; `motion_readings` are motion problems as the paper
    may also be read; `together` names the alternatives that are also tried in every combination;
    `summary` says in one sentence what the paper reports; `read_twice` that its tables were
    transcribed a second time, blind, and agree. A `control` is a paper whose numbers our own
    programs should make: it says whether these are the papers'.
    """

    key: str
    source: Source
    summary: str
    experiments: tuple[Experiment, ...] = ()
    inputs: tuple[PublishedTable, ...] = ()
    results: tuple[PublishedTable, ...] = ()
    audited: tuple[TableAlone, ...] = ()
    claims: tuple[Claim, ...] = ()
    assumptions: tuple[Assumption, ...] = ()
    errata: tuple[Erratum, ...] = ()
    gaps: tuple[Gap, ...] = ()
    formulas: tuple[Formula, ...] = ()
    figures: tuple[Figure, ...] = ()
    relations: tuple[Relation, ...] = ()
    motion_readings: tuple[MotionReading, ...] = ()
    together: tuple[str, ...] = ()
    read_twice: bool = False
    control: bool = False

    def __post_init__(self) -> None:
        """Raise DeclarationError where parts of the declaration do not fit together."""
        self._keep_tuples()
        found = list(self._strangers()) or list(dict.fromkeys(self._faults()))
        if found:
            raise DeclarationError("\n".join(" ".join(fault.split()) for fault in found))

    def _keep_tuples(self) -> None:
        """Take lists, and whatever else can be walked through, where tuples are meant."""
        for each in fields(self):
            value = getattr(self, each.name)
            if str(each.type).startswith("tuple[") and not isinstance(value, tuple):
                try:
                    object.__setattr__(self, each.name, tuple(value))
                except TypeError:
                    message = f"{self.key}, {each.name} is {value!r:.60}, not a tuple"
                    raise DeclarationError(message) from None

    def _strangers(self) -> Iterator[str]:
        """Yield what is not of the kind that its place is for."""
        kinds: dict[str, type | tuple[type, ...]] = {
            "experiments": Experiment, "inputs": PublishedTable, "results": PublishedTable,
            "audited": TableAlone, "claims": (CellClaim, Sentence), "assumptions": Assumption,
            "errata": Erratum, "gaps": Gap, "formulas": Formula, "motion_readings": MotionReading,
            "figures": FIGURES, "relations": RELATIONS, "together": str,
        }  # fmt: skip
        for name, kind in kinds.items():
            for k, each in enumerate(getattr(self, name), start=1):
                if not isinstance(each, kind):
                    yield f"{self.key}, {name} {k}: {shown_value(each)} is no {kind_words(kind)}"
                elif name in _LOOKED_INTO:
                    yield from kind_faults(f"{self.key}, {_place(name, k, each)}", each)
        if not isinstance(self.source, Source):
            yield f"{self.key}, source: {shown_value(self.source)} is no Source"
        else:
            yield from text_faults(f"{self.key}, source", self.source, ("authors", "title"))
        if not isinstance(self.summary, str):
            yield f"{self.key}, summary is {shown_value(self.summary)}; it must be a text"
        for table, times in Counter(each for each in (*self.inputs, *self.results)).items():
            if times > 1:
                yield f"{self.key}: the table {table.label!r} is listed {times} times"

    def _faults(self) -> Iterator[str]:
        """Yield every fault; what hangs on parts that are wrong is not looked at."""
        if not re.fullmatch(r"\w[\w.-]*", str(self.key)):
            yield f"the key {self.key!r} cannot name a file: give letters, digits and _"
        yield from self._ambiguous_names()
        own = [fault for each in self.experiments for fault in experiment_faults(each)]
        yield from (f"{self.key}, {fault}" for fault in own)
        if not own:
            yield from (f"{self.key}, {fault}" for fault in self._faults_of_runs())
        for alone in self.audited:
            yield from (f"{self.key}, {fault}" for fault in alone_faults(alone))
        yield from self._unclaimed_cells()
        yield from self._audited_twice()
        yield from self._readings_of_nothing()
        assumed = [assumption.what for assumption in self.assumptions]
        for fault in (
            *alternative_faults(self.assumptions, self.together, self.experiments),
            *figure_faults(self.figures, self.experiments, assumed),
            *relation_faults(self.relations, self.tables),
        ):
            yield f"{self.key}, {fault}"

    def _faults_of_runs(self) -> Iterator[str]:
        """Yield what is wrong with what is asked of experiments, which are sound themselves."""
        for claim in self.claims:
            yield from claim_faults(claim, self.experiments)
        if not list(alternative_faults(self.assumptions, (), self.experiments)):
            for assumption in self.assumptions:
                for alternative in assumption.alternatives:
                    yield from reading_faults(alternative, self.experiments, self.said)

    @property
    def tables(self) -> tuple[PublishedTable, ...]:
        """Every table that is declared, each once."""
        alone = (each.table for each in self.audited)
        return tuple(dict.fromkeys((*self.inputs, *self.results, *alone)))

    @property
    def said(self) -> tuple[Claim, ...]:
        """The claims, and the gaps about results that no claim carries, as sentences."""
        carried = {claim.gap for claim in self.claims}
        gaps = [gap for gap in self.gaps if gap.result and gap not in carried]
        return (*self.claims, *map(left_open, gaps))

    def _ambiguous_names(self) -> Iterator[str]:
        names = [experiment.name for experiment in self.experiments]
        for experiment in self.experiments:
            for name in (experiment.name, *experiment.problems, *experiment.algorithms):
                if "/" in name or names.count(name) > 1:
                    message = (
                        f"{self.key}, {name!r}: runs are named experiment/problem/algorithm, so a "
                        "name has no '/' and no two experiments share one"
                    )
                    yield message

    def _readings_of_nothing(self) -> Iterator[str]:
        known = {(e.name, problem) for e in self.experiments for problem in e.problems}
        for reading in self.motion_readings:
            if reading.of not in known:
                names = ", ".join(sorted("/".join(names) for names in known))
                message = (
                    f"{self.key}, reading {reading.name!r}: no problem {'/'.join(reading.of)}; "
                    f"problems: {names}"
                )
                yield message

    def _audited_twice(self) -> Iterator[str]:
        labels = [each.table.label for each in self.audited if isinstance(each, TableAlone)]
        of_runs = {
            claim.table.label
            for claim in self.claims
            if isinstance(claim, CellClaim) and isinstance(claim.measure, Statistic)
        }
        for label, times in Counter(labels).items():
            if times > 1 or label in of_runs:
                yield (
                    f"{self.key}, {label}: audited {'twice' if times > 1 else 'alone'}, and "
                    f"{'once is enough' if times > 1 else 'its claims have it audited already'}"
                )

    def _unclaimed_cells(self) -> Iterator[str]:
        claimed = Counter(claim.place for claim in self.claims)
        for table in self.results:
            for row, column in table.places():
                if (times := claimed[table.label, row, column]) != 1:
                    message = (
                        f"{self.key}, {table.label}: cell ({row}, {column}) has {times or 'no'} "
                        f"claim{'s' * (times > 1)}"
                    )
                    yield message


_LOOKED_INTO = ("experiments", "claims", "relations", "gaps", "errata", "assumptions", "formulas")


def _place(name: str, k: int, each: object) -> str:
    """Return where a part stands: its list, its number there, and what it calls itself."""
    titles = (getattr(each, field, None) for field in ("name", "claim", "what", "row"))
    title = next((title for title in titles if isinstance(title, str)), "")
    return f"{name} {k}{f' ({title!r:.60})' if title else ''}"
