"""A table as text, in the forms that are read."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from repro.tables.audit_options import AuditOptions
from repro.tables.facts import Fact
from tests.true_tables.samples import Generator

FORMS = ("csv", "markdown", "latex", "html", "tabs")
Lines = Sequence[Sequence[str]]


@dataclass(frozen=True, slots=True, kw_only=True)
class TrueTable:
    """A table without an error: how it was made in words, its text, and what is told of it.

    `broken` has the conditions of audit rows, each by some of its words, that it does not meet.
    """

    made: str
    text: str
    options: AuditOptions
    broken: frozenset[str] = frozenset()
    facts: tuple[Fact, ...] = field(default=())


def written(rng: Generator, title: str, lines: Lines) -> str:
    """Return lines of cells, the first one headings, in a form drawn at random."""
    form = FORMS[int(rng.integers(len(FORMS)))]
    if rng.random() < 0.1:  # algorithms, or what else heads the columns, in lines
        lines = [list(line) for line in zip(*lines, strict=True)]
    if form == "csv":
        return "\n".join([*([f'"{title}"'] if title else []), *(",".join(line) for line in lines)])
    if form == "tabs":
        return "\n".join([*([title] if title else []), *("\t".join(line) for line in lines)])
    if form == "markdown":
        rule = "|" + " --- |" * len(lines[0])
        head, *body = (f"| {' | '.join(line)} |" for line in lines)
        return "\n".join([*([f"Table: {title}", ""] if title else []), head, rule, *body])
    if form == "html":
        rows = "".join(f"<tr><td>{'</td><td>'.join(line)}</td></tr>" for line in lines)
        return f"<table><caption>{title}</caption>{rows}</table>"
    rows = "\n".join(f"{' & '.join(map(_in_latex, line))} \\\\" for line in lines)
    begin = f"\\begin{{tabular}}{{{'l' * len(lines[0])}}}"
    caption = f"\\caption{{{_in_latex(title)}}}\n" if title else ""
    table = f"{begin}\n{rows}\n\\end{{tabular}}"
    return f"\\begin{{table}}\n{caption}{table}\n\\end{{table}}"


def _in_latex(text: str) -> str:
    digits, mark, power = text.partition("e")
    if mark and power.lstrip("+-").isdigit():
        return f"${digits}\\times 10^{{{int(power)}}}$"
    return text.replace("%", "\\%").replace("±", "$\\pm$")
