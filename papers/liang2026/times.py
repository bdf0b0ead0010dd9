"""Liang et al.: the times of the motion, in Table VI and in the text."""

from papers.liang2026.experiments import MOTION
from papers.liang2026.printed import BASELINE, TABLE_VI, TIME_SAVED
from repro.model.claims import CellClaim, Sentence, every_cell
from repro.model.measures.measure import Computed, Reduction, Statistic
from repro.model.tolerances import Absolute, Between, Percent

BASELINE_SECONDS = tuple(duration.si for duration in BASELINE)


def baseline_time(_row: str, column: str) -> Computed:
    """Return the measure of one cell of Table VI's first row: the durations that are set."""
    t1, t2 = BASELINE_SECONDS
    chosen = {"t1": t1, "t2": t2, "Total Time t": t1 + t2}[column]
    return Computed(how=f"{column} as set in section IV-B", value=lambda: chosen)


BASELINE_TOTAL = baseline_time("Fifth-order polynomial", "Total Time t")


def table_vi(statistic: str) -> tuple[CellClaim, ...]:
    """Return the claims on the times that the searches find, by a statistic of the 50 runs."""
    return every_cell(
        TABLE_VI,
        of=MOTION,
        rows=("algorithm",),
        columns="quantity",
        given={"problem": "FANUC", "statistic": statistic},
        names={"t1": "duration 1", "t2": "duration 2", "Total Time t": "total"},
        within=Percent(1),
        only=("WOA", "IWOA"),
    )


def time_sentences(statistic: str) -> tuple[Sentence, ...]:
    """Return what the text says of these times, by a statistic of the 50 runs."""
    return (
        Sentence(
            claim="IWOA takes 18.3 % less time than the motion before optimisation",
            where="abstract",
            printed=TIME_SAVED,
            measure=Reduction(before=BASELINE_TOTAL, after=_total(statistic, "IWOA")),
            accepted=Absolute(0.5),
        ),
        Sentence(
            claim="IWOA cuts the total time from 10 s to 4.69 s",
            where="section VI",
            printed=TABLE_VI["IWOA", "Total Time t"],
            measure=_total(statistic, "IWOA"),
            accepted=Percent(1),
        ),
        Sentence(
            claim="WOA reaches a total time of 5.74 s",
            where="section VI",
            printed=TABLE_VI["WOA", "Total Time t"],
            measure=_total(statistic, "WOA"),
            accepted=Percent(1),
        ),
        Sentence(
            claim="IWOA plans a clearly faster motion than WOA (read as: at least 1 % less time; "
            "the printed times differ by 18.3 %)",
            where="sections IV-C and VI",
            printed=TIME_SAVED,
            measure=Reduction(before=_total(statistic, "WOA"), after=_total(statistic, "IWOA")),
            accepted=Between(1, 100),
            in_words=True,
        ),
    )


def _total(statistic: str, algorithm: str) -> Statistic:
    return Statistic(
        experiment="motion",
        problem="FANUC",
        algorithm=algorithm,
        statistic=statistic,
        quantity="total",
    )
