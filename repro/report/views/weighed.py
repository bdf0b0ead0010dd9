"""What the templates name of proofs, readings and the audit of one paper."""

from collections.abc import Sequence

from repro.audit.alone import tables_alone
from repro.judge.judgement import Judgement
from repro.report.views.findings import Shown
from repro.report.views.readings import readings_view, settings_of
from repro.report.views.reasons import strengths
from repro.report.views.times import time_cells
from repro.report.views.turned import turned_by
from repro.tables.audit_words import read_lines, read_words


def weighed(judgement: Judgement, found: Sequence[Shown]) -> dict[str, object]:
    """Return what is shown beside the findings, by the names that templates use."""
    paper = judgement.paper
    times = zip(judgement.certificates, judgement.found_times, strict=True)
    readings = readings_view(judgement)
    return {
        "audit": judgement.audit,
        "strengths": strengths(judgement.audit, found),
        "alone": [
            (read_words(table), *read_lines(table, flag="")) for table in tables_alone(paper)
        ],
        "certificates": [(certificate, time_cells(certificate, own)) for certificate, own in times],
        "readings": readings,
        "matrix": turned_by(readings.rows, found, settings_of(paper)),
        "besides": judgement.besides,
        "reading_repeats": judgement.reading_repeats,
    }
