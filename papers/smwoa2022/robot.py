"""SMWOA: the UR5, whose links the paper does not print, as its maker describes it."""

from repro.model.paper import Assumption
from repro.robotics import dh_rows
from repro.tables.published import PublishedTable

MAKERS_TABLE = PublishedTable.read("""
    Table C.3, Universal Robots CB3 service manual, appendix Robot Parameter (UR5 series 3)
    joint || a [m]    | α [rad] | d [m]
    1     || 0        | π/2     | 0.089159
    2     || -0.42500 | 0       | 0
    3     || -0.39225 | 0       | 0
    4     || 0        | π/2     | 0.10915
    5     || 0        | -π/2    | 0.09465
    6     || 0        | 0       | 0.08230
""")
DH = dh_rows(a=MAKERS_TABLE.column("a"), alpha=MAKERS_TABLE.column("α"), d=MAKERS_TABLE.column("d"))
LINKS = Assumption(
    what="links of the UR5 and zero of its joint angles",
    where="section 4.3, Fig. 2",
    chosen="the maker's Denavit-Hartenberg parameters of series 3, in the standard convention, and "
    "its joint angles",
    alternatives=(),
    because="the paper prints no links; only the view of the arm rests on them, and series 1 and 2 "
    "differ by less than 2 mm in any length",
)
