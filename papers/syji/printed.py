"""SYJI-0035: the numbers that are printed, as they stand on the page."""

from repro.tables.published import Printed, PublishedTable

TABLE_1 = PublishedTable.read("""
    Table 1, section 6R robot modeling
    Joint || Link distance di [m] | Link length ai-1 [m] | Link twist αi-1 [deg] | θi [text]
    1     || 0                    | 0                    | 0                     | -150°~150°
    2     || 0.02                 | 0.2                  | -90                   | -60°~55°
    3     || 0                    | 0.64                 | -90                   | -65°~65°
    4     || 0.866                | 0                    | -90                   | -180°~180°
    5     || 0                    | 0                    | 90                    | -150°~60°
    6     || 0.267                | 0                    | 180                   | -360°~360°
""")
TABLE_2 = PublishedTable.read("""
    Table 2, section 6R robot simulation
    Joint || Maximum velocity 7 [deg/s] | Maximum velocity 5 [deg/s] | Maximum acceleration 7 [deg/s^2] | Maximum acceleration 5 [deg/s^2] | Maximum Jerk 7 [deg/s^3] | Maximum Jerk 5 [deg/s^3]
    1     || 19.68 | 16.88 | 13.52 | 10.39 | 15.12 | 21.6
    2     || 39.36 | 33.75 | 27.04 | 20.75 | 37.78 | 43.2
    3     || 19.68 | 16.87 | 13.52 | 10.39 | 18.89 | 21.6
    4     || 19.68 | 16.87 | 13.52 | 10.39 | 18.89 | 21.6
    5     || 19.68 | 16.87 | 13.52 | 10.39 | 18.89 | 21.6
    6     || 39.36 | 33.75 | 27.04 | 20.75 | 37.78 | 43.2
""")  # noqa: E501 (the heading is as wide as the page's)
TABLE_3 = PublishedTable.read("""
    Table 3, section Simulation parameter settings, item 1
    Joint || Maximum Velocity [deg/s] | Maximum Acceleration [deg/s^2] | Maximum Jerk [deg/s^3]
    1     || 19.68                    | 13.52                          | 15.12
    2     || 39.36                    | 27.04                          | 37.78
    3     || 19.68                    | 13.52                          | 18.89
    4     || 19.68                    | 13.52                          | 18.89
    5     || 19.68                    | 13.52                          | 18.89
    6     || 39.36                    | 27.04                          | 37.78
""")
TABLE_4 = PublishedTable.read("""
    Table 4, section Simulation parameter settings, item 2
    Joint || θ0 [deg] | θ1 [deg] | θ2 [deg] | θ3 [deg] | θf [deg]
    1     || 0        | 11.25    | 22.5     | 33.75    | 45
    2     || 90       | 67.5     | 45       | 22.5     | 0
    3     || 0        | -11.25   | -22.5    | -33.75   | -45
    4     || 0        | 11.25    | 22.5     | 33.75    | 45
    5     || 0        | -11.25   | -22.5    | -33.75   | -45
    6     || 0        | -22.5    | -45      | -67.5    | -90
""")

# section 6R robot simulation: q1 and q2
START = tuple(Printed(text, "rad") for text in ("0", "π/2", "0", "0", "0", "0"))
END = tuple(Printed(text, "rad") for text in ("π/4", "0", "-π/4", "π/4", "-π/4", "-π/2"))
WHOLE = Printed("5", "s")  # section 6R robot simulation: t from 0 to 5

# section Simulation parameter settings, item 3: the prices λ1, λ2, λ3 of a broken limit
PENALTIES = (Printed("0.1", "s"), Printed("0.01", "s"), Printed("0.01", "s"))

# section Simulation parameter settings, item 4
RESULTS = "section Simulation parameter settings, item 4"
TOTAL = Printed("2.2999", "s")
DURATIONS = (
    Printed("0.2308", "s"),
    Printed("0.845", "s"),
    Printed("0.9166", "s"),
    Printed("0.258", "s"),
)
SECOND_DURATION = Printed("0.8945", "s")  # with which the printed total is met, see the errata
SAVED = Printed("2.7001", "s")
