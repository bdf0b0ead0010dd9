"""Liang et al.: the numbers that are printed, as they stand on the page."""

from repro.tables.published import Printed, PublishedTable

TABLE_II = PublishedTable.read("""
    Table II, section III-D (30 runs)
    No. | Index || IWOA          | WOA           | GWO           | PSO          | DBO
    F1  | Best  || 0             | 0             | 0             | 3.472×10^-57 | 2.98×10^-14
        | Worst || 7.294×10^-287 | 7.294×10^-287 | 0             | 9.676×10^-26 | 9.931×10^3
        | Mean  || 0             | 1.495×10^-289 | 9.676×10^-26  | 2.460×10^-28 | 3.187×10^3
        | Std   || 0             | 0             | 0             | 4.465×10^-27 | 2.854×10^3
    F5  | Best  || 1.755×10^-4   | 2.53          | 2.721×10^1    | 9.003×10^4   | 2.196×10^8
        | Worst || 5.596×10^-4   | 2.66          | 2.721×10^1    | 9.003×10^4   | 7.573×10^8
        | Mean  || 2.459×10^-4   | 2.536         | 2.721×10^1    | 9.003×10^4   | 4.754×10^8
        | Std   || 8.641×10^-5   | 2.172×10^-2   | 7.178×10^-15  | 3.325×10^-1  | 1.244×10^8
    F10 | Best  || 4.441×10^-16  | 4.441×10^-16  | 4.441×10^-16  | 3.856        | 1.474×10
        | Worst || 4.441×10^-16  | 4.441×10^-16  | 4.441×10^-16  | 2.050×10     | 2.213×10
        | Mean  || 4.441×10^-16  | 4.441×10^-16  | 4.441×10^-16  | 1.445×10     | 2.088×10
        | Std   || 0             | 0             | 0             | 3.242        | 8.693×10^-1
    F12 | Best  || 2.564×10^-7   | 1.003×10^-3   | 1.969×10^-2   | 8.325×10^-1  | 3.615×10^8
        | Worst || 2.834×10^-7   | 1.009×10^-3   | 1.969×10^-2   | 8.347×10^-1  | 2.389×10^9
        | Mean  || 2.714×10^-7   | 1.003×10^-3   | 1.969×10^-2   | 8.326×10^-1  | 1.146×10^9
        | Std   || 4.241×10^-9   | 1.135×10^-6   | 3.494×10^-18  | 2.626×10^-4  | 4.120×10^8
""")
TABLE_III = PublishedTable.read("""
    Table III, section IV-A
    Joint No. (i) || a_{i-1} [mm] | α_{i-1} [rad] | d_i [mm] | θ_i [text]
    1             || 175          | -π/2          | 490      | θ1
    2             || 1500         | 0             | 0        | θ2
    3             || 1350         | -π/2          | 0        | θ3
    4             || 0            | π/2           | 162      | θ4
    5             || 0            | -π/2          | 0        | θ5
    6             || 0            | 0             | 220      | θ6
""")
TABLE_IV = PublishedTable.read("""
    Table IV, section IV-B
    Waypoint || x [m] | y [m] | z [m]
    X_1      || 0.1   | 0.1   | 0.5
    X_2      || -1.5  | 0.75  | 2.344
    X_3      || 0.5   | 0.5   | 2.0
""")
TABLE_V = PublishedTable.read("""
    Table V, section IV-B
    Joint || X_1 [rad] | X_2 [rad] | X_3 [rad]
    1     || -1.0228   | 2.6619    | 0.5174
    2     || -2.8352   | -1.5037   | -2.1353
    3     || -3.0950   | 0.9949    | 1.7531
    4     || 1.2294    | -0.4553   | 1.3274
    5     || 2.4167    | -0.2435   | 1.0696
    6     || 0         | 0         | 0
""")
TABLE_VI = PublishedTable.read("""
    Table VI, section IV-C (50 runs, averaged)
    Method                 || t1 [s] | t2 [s] | Total Time t [s]
    Fifth-order polynomial || 5      | 5      | 10
    WOA                    || 3.26   | 2.48   | 5.74
    IWOA                   || 2.76   | 1.93   | 4.69
""")
VELOCITY = Printed("3", "rad/s")  # section IV-B
ACCELERATION = Printed("3.5", "rad/s^2")  # section IV-B
BASELINE = (Printed("5", "s"), Printed("5", "s"))  # duration of each segment, section IV-B
TIME_SAVED = Printed("18.3", "%")  # abstract, against the motion before optimisation
