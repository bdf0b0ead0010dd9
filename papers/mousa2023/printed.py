"""Mousa et al.: the numbers that are printed, as they stand on the page."""

from repro.tables.published import Printed, PublishedTable

TABLE_IV = PublishedTable.read("""
    Table IV, section IV (the second table of this number)
    links || a [m] | α [rad] | d [m] | θ [text]
    1     || 0     | 1.57    | 0.330 | q_1
    2     || 0.29  | 0       | 0     | q_1
    3     || 0.02  | 1.57    | 0     | q_1
    4     || 0     | -1.57   | 0.310 | q_1
    5     || 0     | 1.57    | 0     | q_1
    6     || 0     | 0       | 0.075 | q_1
""")
ANGLES = PublishedTable.read("""
    Eqs. (10) and (11), section IV (no unit is printed)
    joint || start angles [rad] | end angles [rad]
    1     || -1.856             | -0.388
    2     || -1.73              | -1.74
    3     || -0.009             | 0.248
    4     || 3.1                | 1.50
    5     || -1.8               | -1.30
    6     || -0.30              | 1.7
""")
EQUATION_4 = ("1", "0", "3", "-2")  # a_0 is q_start, the others multiply (q_end - q_start) / t^j
EQUATION_9 = ("1", "0", "0", "10", "-15", "6")  # likewise
CROSSOVER = Printed("80", "%")  # section III-B
MUTATION = Printed("1", "%")  # section III-B
REACH = Printed("600", "mm")  # the R600 of the arm's name, keywords and section IV
FREEDOMS = Printed("6")  # title and section IV
