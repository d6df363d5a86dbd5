"""Planish: curved patches changed as little as they need, laid flat, and written as true-size patterns."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from . import _core, _meshes
from ._core import (
    ComparedMethod,
    CompareResult,
    CutResult,
    EvolveResult,
    FlattenResult,
    MeasureResult,
    Mesh,
    PanelsResult,
    ProductResult,
    Sweep,
    SweepInput,
    Sweeps,
    UnfoldResult,
)
from ._meshes import write
from ._verbs.compare import compare
from ._verbs.drawing import dxf, pdf, plt, svg
from ._verbs.evolve import evolve, evolve_sweeps
from ._verbs.flatten import flatten
from ._verbs.measure import measure
from ._verbs.product import flatten_many, flatten_product
from ._verbs.read import read
from ._verbs.sample import sample
from ._verbs.suggest_cuts import suggest_cuts
from ._verbs.suggest_panels import suggest_panels
from ._verbs.unfold import unfold
from .errors import Cancelled, Error, FileError, FormatError, MeshError, PatternError, Place, RequestError

if TYPE_CHECKING:
    from ._types import Path

__version__ = _core.__version__

__all__ = [
    "Cancelled",
    "ComparedMethod",
    "CompareResult",
    "CutResult",
    "Error",
    "EvolveResult",
    "FileError",
    "FlattenResult",
    "FormatError",
    "MeasureResult",
    "Mesh",
    "MeshError",
    "PanelsResult",
    "PatternError",
    "Place",
    "ProductResult",
    "RequestError",
    "Sweep",
    "SweepInput",
    "Sweeps",
    "UnfoldResult",
    "compare",
    "describe",
    "dxf",
    "evolve",
    "evolve_sweeps",
    "flatten",
    "flatten_many",
    "flatten_product",
    "materials",
    "measure",
    "pdf",
    "plt",
    "read",
    "sample",
    "suggest_cuts",
    "suggest_panels",
    "svg",
    "unfold",
    "write",
]


def describe() -> dict[str, Any]:
    """All verbs and flags of the program, as `planish describe --json` prints them."""
    import json

    description: dict[str, Any] = json.loads(_core.description())
    return description


def _report_in_frame(self: Any) -> str:
    """The report, for notebooks."""
    import html

    page = html.escape(self.report_html(), quote=True)
    return f'<iframe srcdoc="{page}" style="width: 100%; height: 640px; border: 0"></iframe>'


def _pattern_in_page(self: Any) -> str:
    """The pattern, for notebooks."""
    return f'<div style="max-width: 640px; overflow: auto">{svg(self)}</div>'


def _add_methods() -> None:
    for shown in (Mesh, MeasureResult, EvolveResult, UnfoldResult, FlattenResult, CutResult, PanelsResult):
        for method in (_meshes.to_trimesh, _meshes.to_pyvista, _meshes.to_meshio):
            setattr(shown, method.__name__, method)
    for reported in (FlattenResult, CompareResult, ProductResult):
        setattr(reported, "_repr_html_", _report_in_frame)
    setattr(UnfoldResult, "_repr_html_", _pattern_in_page)
    for drawn in (FlattenResult, UnfoldResult):
        for writer in (svg, dxf, pdf, plt):
            setattr(drawn, writer.__name__, writer)


_add_methods()


def materials(material: Optional[Path] = None) -> list[dict[str, Any]]:
    """What is known of materials, with the source of each figure, as `planish materials --json` lists it: of all, of
    one by its name, or of the .json file of your own. Each is what such a file holds."""
    import json
    import os

    known: list[dict[str, Any]] = json.loads(_core.materials("" if material is None else os.fspath(material)))["materials"]
    return known
