"""What the paper prints, and where: Lin, Zhang, Wang, Gao, *Flattenable mesh processing by
controllable Laplacian evolution*, ASME 2010, DETC2010-28301. No other figure of the paper stands
anywhere in this folder."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Row:
    """A row of Table 1 (page 8)."""

    figure: str
    vertices: int
    e_max_before: float
    e_avg_before: float
    e_max_after: float
    e_avg_after: float
    sweeps: int
    seconds: float

    @property
    def ratio(self):
        return self.e_max_before / self.e_max_after


TABLE_1 = [
    Row("7(a), 7(b)", 4234, 0.3212, 0.0055, 0.0999, 0.0020, 10, 28),
    Row("7(c), 7(d)", 5088, 0.6319, 0.0018, 0.0231, 0.0010, 10, 44),
    Row("8(a), 8(b)", 12859, 0.0241, 0.00019, 0.0036, 0.00016, 4, 4),
    Row("8(c), 8(d)", 59513, 0.3490, 0.00020, 0.0756, 0.00017, 10, 97),
    Row("9(a), 9(b)", 195093, 0.6988, 0.00004, 0.0228, 0.00003, 10, 159),
]
MACHINE = "Visual C++ 6.0 on a 2.4 GHz quad-core with 2 GB"  # section 4, first paragraph

# Fig. 5 and 6, and section 4 on them.
FIG_5_SWEEPS = 50
FIG_5_LAMBDA = 0.5
FIG_5_E_MAX = {"before": 0.1271, "controllable": 0.0383, "classical": 0.2357}

# Section 5, on Fig. 10: both e_max and e_avg of the method of [2] are below this.
FIG_10_BOUND = 1e-4

# Section 4, the sentences on Table 1: "more than 30 times (Figs. 7(d) and 9(b))", "less than 10" steps.
MORE_THAN, MORE_THAN_OF = 30.0, (1, 4)
FEWER_SWEEPS_THAN = 10
