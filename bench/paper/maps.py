"""Colour maps of the discrete Gaussian curvature, Eq. 1, as in the paper's figures."""

import numpy as np

from markdown import number
from picture import rainbow, view_of, write_row
from surface import curvature, diagonal, is_inner

# Of the vertices: what is above is red. The largest values are single vertices, and with them at
# the end of the scale all else would be blue.
RED_FROM = 98


def write_maps(job, file, paths):
    """Patches side by side from the first one's best side and in one scale, that of the first two.

    @return a sentence on the scale"""
    shown = [job.program.surface(path) for path in paths]
    values = [np.abs(curvature(surface)) for surface in shown]
    inner = is_inner(shown[0])
    red = max(float(np.percentile(v[inner], RED_FROM)) for v in values[:2])
    colored = [(surface, rainbow(v, red)) for surface, v in zip(shown, values)]
    write_row(job.out / file, colored, view_of(shown[0]))
    return (
        "Colour: $|K|$ of Eq. 1, blue at 0, red from "
        f"{number(red * diagonal(shown[0]) ** 2)} over the square of the diagonal on."
    )
