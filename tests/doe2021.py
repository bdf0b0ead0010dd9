"""Doe & Roe (2021): an invented paper of a few runs, for the tests of pages and of joining."""

from repro.functions import FUNCTIONS
from repro.model.assumptions import Alternative, Assumption
from repro.model.cells import every_cell
from repro.model.claims import Sentence, lowest_everywhere
from repro.model.experiment import Experiment
from repro.model.figures import Convergence, Motion
from repro.model.measures.measure import Statistic
from repro.model.open_points import Erratum, Gap
from repro.model.paper import Paper, Source
from repro.model.tolerances import Absolute, Percent
from repro.optimisers import PSO, WOA
from repro.robotics import MinimumTime, quintic
from repro.tables.published import Printed, PublishedTable

WAYPOINTS = PublishedTable.read("""
    Table 1, p. 3
    joint || start [deg] | goal [deg]
    1     || 10.0        | 100.0
    2     || -20.0       | 25.0
""")
COSTS = PublishedTable.read("""
    Table 2, p. 5 (4 runs)
    No. | Index || WOA      | PSO
    F1  | Best  || 1.000    | 9.99×10^9
        | Mean  || 2.500    | 1.2×10^1
""")
TIMES = PublishedTable.read("""
    Table 3, p. 9 (4 runs)
    algorithm || mean [s]
    WOA       || 2.357
    PSO       || 2.1
""")
TEST = Experiment(
    name="test",
    where="section 3",
    proposed="WOA",
    problems={"F1": FUNCTIONS["sphere"].problem(3)},
    algorithms={"WOA": WOA(), "PSO": PSO(clip="last particle")},
    population=6,
    iterations=12,
    runs=4,
)
ARM = MinimumTime(
    waypoints=tuple(WAYPOINTS.column(name) for name in WAYPOINTS.column_names),
    law=quintic,
    velocity=(1.25, 1.25),
    acceleration=(9.0, 9.0),
    durations=(0.5, 9.0),
)
MOTION = Experiment(
    name="motion",
    where="section 4",
    proposed="WOA",
    problems={"arm": ARM},
    algorithms={"WOA": WOA(), "PSO": PSO(clip="last particle")},
    population=6,
    iterations=12,
    runs=4,
)
SIMULATOR = Gap(what="time in a simulator", where="section 5", because="no motion is printed")

PAPER = Paper(
    key="doe2021",
    source=Source(authors="Doe, Roe", title="Motion of an <arm> & a whale", year=2021),
    summary="A whale moves an arm.",
    experiments=(TEST, MOTION),
    inputs=(WAYPOINTS,),
    results=(COSTS, TIMES),
    claims=(
        *every_cell(
            COSTS,
            of=TEST,
            rows=("problem", "statistic"),
            columns="algorithm",
            names={"Best": "best", "Mean": "mean"},
            within=Percent(20),
        ),
        *every_cell(
            TIMES,
            of=MOTION,
            rows=("algorithm",),
            columns="statistic",
            given={"problem": "arm", "quantity": "total"},
            within=Percent(1),
        ),
        *lowest_everywhere(
            TEST, algorithm="WOA", statistic="mean", claim="WOA is best", where="p. 6"
        ),
        Sentence(
            claim="WOA needs 2.36 s | at most",
            where="p. 9",
            printed=Printed("2.36", "s"),
            measure=Statistic(
                experiment="motion",
                problem="arm",
                algorithm="WOA",
                statistic="mean",
                quantity="total",
            ),
            accepted=Absolute(0.3),
        ),
        Sentence(
            claim="the simulator shows 3 s",
            where="p. 10",
            printed=Printed("3", "s"),
            measure=None,
            accepted=Absolute(0),
            gap=SIMULATOR,
        ),
    ),
    assumptions=(
        Assumption(
            what="box of the durations",
            where="p. 9",
            chosen="0.5 s to 9 s",
            alternatives=(
                Alternative(
                    name="wide box",
                    says="0.1 s to 20 s",
                    problems={("motion", "arm"): {"durations": (0.1, 20.0)}},
                ),
                Alternative(says="any other", untried="there is no end of them"),
            ),
            because="none is printed",
        ),
        Assumption(
            what="spiral",
            where="p. 4",
            chosen="b = 1",
            alternatives=(
                Alternative(
                    name="tight spiral",
                    says="b = 2",
                    algorithms={("test", "WOA"): {"b": 2.0}, ("motion", "WOA"): {"b": 2.0}},
                ),
            ),
            because="none is printed",
        ),
    ),
    errata=(Erratum(where="Table 1", printed="1OO", used="100", because="a letter for a digit"),),
    gaps=(SIMULATOR,),
    together=("wide box", "tight spiral"),
    figures=(
        Convergence(label="Fig. 1", caption="Cost over iterations", experiment="test"),
        Motion(label="Fig. 2", caption="Joints", problem=ARM, durations=(3.0,)),
    ),
)
