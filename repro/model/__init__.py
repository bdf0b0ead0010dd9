"""All that a paper module says, in one import."""

from repro.model.assumptions import Alternative, Assumption
from repro.model.cells import Role, computed_cells, every_cell
from repro.model.claims import (
    CellClaim,
    Claim,
    Sentence,
    as_one,
    lowest_everywhere,
    not_counted,
    ranked,
    says,
    says_in_words,
)
from repro.model.experiment import Experiment
from repro.model.figures import (
    Arm,
    ArmMotion,
    Convergence,
    Figure,
    JointCurves,
    Motion,
    SplineMotion,
    ToolPath,
)
from repro.model.measures.combined import Combined, EqualTo, MeanOf, Ratio, combined
from repro.model.measures.curves import (
    Combination,
    Effort,
    PlaceAmong,
    Sensitivity,
    Together,
    planned,
)
from repro.model.measures.measure import (
    Computed,
    Difference,
    Measure,
    Measured,
    Rank,
    Reduction,
    Statistic,
    computed,
    runs_of,
)
from repro.model.measures.ranks import Contest, ContestPlace, Firsts, MeanRank, RankSum, Samples
from repro.model.named_robot import NamedRobot
from repro.model.open_points import Erratum, Gap
from repro.model.paper import Formula, MotionReading, Paper, Source
from repro.model.prose import Prose, prose
from repro.model.table_alone import TableAlone
from repro.model.tolerances import (
    Absolute,
    Between,
    Fitness,
    FromMinimum,
    Interval,
    Percent,
    RoundedOrCut,
    Tolerance,
)
from repro.model.woa_readings import (
    WOA_BY_EQUATIONS,
    WOA_BY_VECTORS,
    WOA_READINGS,
    everywhere,
    woa_readings,
)
from repro.tables.published import NOTHING, UNITS, Printed, PublishedTable
from repro.tables.relations import (
    AverageRank,
    ByFormula,
    Equal,
    EqualSpacing,
    InRange,
    Less,
    Mean,
    Number,
    PercentLower,
    PrintedPoses,
    PValues,
    Relation,
    SameNumbers,
    Sum,
    TableCell,
    TextNumber,
    Times,
    column_cells,
    equally_spaced,
    row_cells,
    row_sums,
)
from repro.tables.true_numbers import ZERO_FITNESS, ZERO_STD
