"""Re-run times against the certificates: how near they come, and that none is below."""

from dataclasses import dataclass

from repro.errors import ReproError
from repro.judge.certificates import Certificate
from repro.judge.outside_box import inside_box
from repro.model.evidence import Evidence

ROUNDING = 1e-9  # share by which sums and roots of doubles may differ from the proof


class CertificateBeatenError(ReproError):
    """A run claims a time below the proved minimum: the program is wrong."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundTime:
    """Mean and least total time in s that an algorithm found in all repeats, and their ratios."""

    algorithm: str
    mean: float
    least: float
    mean_ratio: float
    least_ratio: float


def found_times(certificate: Certificate, evidence: Evidence) -> tuple[FoundTime, ...]:
    """Return what each algorithm found on the certified problem, nothing where none was run.

    Raises CertificateBeatenError for a time below the proved bound. A certificate without a
    minimum concerns a cost that is least where limits are broken, so its times are not compared;
    neither are those of points outside the box, which no time of the problem is.
    """
    if certificate.minimum is None or certificate.lower_bound is None:
        return ()
    found = []
    for cell in evidence.runs:
        if f"{cell[0]}/{cell[1]}" != certificate.problem:
            continue
        times = evidence.values(cell, "total")[inside_box(evidence, cell)]
        if not times.size:
            continue
        least, mean = float(times.min()), float(times.mean())
        if least < certificate.lower_bound * (1.0 - ROUNDING):
            message = (
                f"{evidence.key}, {'/'.join(cell)}: a run claims {least!r} s, below the "
                f"proved {certificate.lower_bound!r} s; please report this fault"
            )
            raise CertificateBeatenError(message)
        found.append(
            FoundTime(
                algorithm=cell[2],
                mean=mean,
                least=least,
                mean_ratio=mean / certificate.minimum,
                least_ratio=least / certificate.minimum,
            )
        )
    return tuple(found)
