"""The blocks of a table from anywhere: what its numbers are statistics of, and what is told."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from repro.tables.arithmetic import NARROWEST
from repro.tables.audit_options import AuditOptions
from repro.tables.blocks import Block, FunctionBounds, known_minimum
from repro.tables.gathered import Entry, numbered
from repro.tables.possible_runs import TRIED
from repro.tables.senses import Numbered, guessed_senses

_SPREADS = {"std": "std", "variance": "variance", "sem": "standard error"}


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadBlock:
    """A block in the sense that is told or guessed; where that is open, in the `other` one, too."""

    block: Block
    other: Block | None = None


def read_blocks(
    entries: Sequence[Entry], runs: int | None, options: AuditOptions
) -> list[ReadBlock]:
    """Return the blocks of a table, each with the statistics that stand for one set of runs."""
    parts: dict[tuple[str, str, str, int], dict[str, Entry]] = {}
    for key, entry in numbered(entries):
        parts.setdefault(key, {})[entry.statistic] = entry
    found = list(parts.values())
    senses = _senses(found, runs, options)
    return [_read(part, sense, runs, options) for part, sense in zip(found, senses, strict=True)]


def _senses(
    parts: Sequence[Mapping[str, Entry]], runs: int | None, options: AuditOptions
) -> list[int]:
    """Return 1 for each block whose least run is the best, -1 for the greatest, 0 where open."""
    if options.maximise is not None:
        return [-1 if options.maximise else 1] * len(parts)
    return guessed_senses([_numbered(part) for part in parts], runs, options.significant)


def _numbered(part: Mapping[str, Entry]) -> Numbered:
    entry = next(iter(part.values()))
    return Numbered(
        numbers={name: each.number for name, each in part.items()},
        problem=entry.problem or entry.algorithm,
        name=f"{entry.problem} {entry.algorithm} {entry.quantity}",
    )


def _read(
    part: Mapping[str, Entry], sense: int, runs: int | None, options: AuditOptions
) -> ReadBlock:
    block = _block(part, runs, options, maximised=sense < 0)
    # a known least value, such as that of errors, is there to be reached
    is_open = sense == 0 and block.function is None and not {"best", "worst"}.isdisjoint(part)
    return ReadBlock(
        block=block, other=_block(part, runs, options, maximised=True) if is_open else None
    )


def _block(
    part: Mapping[str, Entry], runs: int | None, options: AuditOptions, *, maximised: bool
) -> Block:
    """Return the block of some numbers, by the names that checks know."""
    spread = _SPREADS[options.spread or "std"]
    low, high = ("worst", "best") if maximised else ("best", "worst")
    own_names = {"lowest": low, "highest": high, "std": spread, "sem": "standard error"}
    numbers = {name: entry.number for name, entry in part.items()}
    cells = {own_names.get(name, name): number for name, number in numbers.items()}
    entry = next(iter(part.values()))
    return Block(
        problem_name=entry.problem or entry.algorithm,
        algorithm=entry.algorithm,
        quantity=entry.quantity or "cost",
        n=runs or TRIED[0],
        cells=cells,
        scientific=any(number.printed.power is not None for number in numbers.values()),
        given=replace(NARROWEST, significant=options.significant),
        maximise=maximised,
        whole_numbers=options.integers and not entry.quantity,
        function=None if entry.quantity else _bounds(entry.problem, options, maximised=maximised),
    )


def _bounds(problem: str, options: AuditOptions, *, maximised: bool) -> FunctionBounds | None:
    """Return what is told of the values of a problem."""
    for names in (options.functions, options.minimum):
        for name in names_of(problem):
            told = _named(names, name)
            if isinstance(told, FunctionBounds):
                return told
            if isinstance(told, Fraction):
                return known_minimum(f"{name or 'the problem'}, as told,", told)
    return known_minimum("an error", Fraction(0)) if options.errors and not maximised else None


def _named(names: Mapping[str, Any], name: str) -> Any:  # noqa: ANN401 (a bound or a number)
    return next((told for key, told in names.items() if letters(key) == letters(name)), None)


def letters(name: str) -> str:
    """Return the letters and digits of a name, by which it is looked up, in lower case."""
    return "".join(filter(str.isalnum, name.lower()))


def names_of(problem: str) -> tuple[str, ...]:
    """Return what a problem may be called: its name, the first word of it, or nothing for all."""
    return problem, problem.split(" ", maxsplit=1)[0], ""
