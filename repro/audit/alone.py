"""The tables of a paper that no run stands behind, audited as those of a file are."""

from collections.abc import Iterator

from repro.audit.blocks import bounds_of
from repro.model.paper import Paper
from repro.model.table_alone import TableAlone, least_value
from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audited_table
from repro.tables.read_published import published_grid, read_published


def tables_alone(paper: Paper) -> Iterator[AuditedTable]:
    """Yield the audit of each, with what was read and guessed."""
    for alone in paper.audited:
        table = alone.table
        yield audited_table(
            read_published(table), published_grid(table), options_of(alone), file=paper.key
        )


def options_of(alone: TableAlone) -> AuditOptions:
    """Return what the declaration of a table tells."""
    return AuditOptions(
        **alone.told,
        minimum={name: least_value(value) for name, value in alone.minima.items()},
        functions={name: bounds_of(problem) for name, problem in alone.function.items()},
    )
