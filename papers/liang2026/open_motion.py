"""Liang et al.: what the paper leaves open of the motion."""

from papers.liang2026.times import table_vi, time_sentences
from repro.model.paper import Alternative, Assumption

MOTION_OPEN = (
    Assumption(
        what="which of the 50 runs Table VI prints",
        where="section IV-C, Table VI",
        chosen="their mean",
        alternatives=(
            Alternative(
                name="best of 50 runs",
                says="the best",
                claims=(*table_vi("best"), *time_sentences("best")),
            ),
        ),
        because="the average value is taken as the index, the text says, though it also calls "
        "WOA's times the optimal combination",
    ),
    Assumption(
        what="range in which a duration is sought",
        where="section IV-C",
        chosen="0.1 s to 5 s per segment",
        alternatives=(
            Alternative(
                name="durations to 10 s",
                says="0.1 s to 10 s, the whole time before optimisation",
                problems={("motion", "FANUC"): {"durations": (0.1, 10.0)}},
            ),
            Alternative(
                name="durations from 1 s",
                says="1 s to 5 s",
                problems={("motion", "FANUC"): {"durations": (1.0, 5.0)}},
            ),
        ),
        because="the text is silent; 5 s is the duration before optimisation",
    ),
    Assumption(
        what="handling of motions that break a limit",
        where="Eq. (7), section IV-C",
        chosen="any motion that obeys comes before any that does not, and these by excess",
        alternatives=(
            Alternative(
                name="penalty for excess",
                says="a penalty of 1000 s per unit of relative excess",
                problems={("motion", "FANUC"): {"handling": "penalty"}},
            ),
            Alternative(
                name="flat cost",
                says="one flat cost",
                problems={("motion", "FANUC"): {"handling": "rejection"}},
            ),
        ),
        because="the text is silent; this rule has no weight to choose",
    ),
)
