"""Types of what functions take."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Protocol, Tuple, Union

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from . import _core

    class HasFaces(Protocol):
        """As a mesh of trimesh, or a result of this package."""

        @property
        def vertices(self) -> Any: ...
        @property
        def faces(self) -> Any: ...

    class HasCells(Protocol):
        """As a mesh of meshio."""

        @property
        def points(self) -> Any: ...
        @property
        def cells_dict(self) -> Any: ...

    class HasRegularFaces(Protocol):
        """As a mesh of PyVista."""

        @property
        def points(self) -> Any: ...
        @property
        def regular_faces(self) -> Any: ...

    Path = Union[str, os.PathLike[str]]
    MeshLike = Union[_core.Mesh, HasFaces, HasCells, HasRegularFaces, Path, Tuple[ArrayLike, ArrayLike], ArrayLike]
    # A number in model units, degrees or as a share, or a text with a unit: "5mm", "30deg", "2%".
    Amount = Union[float, str]
    # A file, or its lines: each a text or the items of a line.
    Rows = Union[Path, Iterable[Any], Mapping[int, float]]
    # Makes a sweep: returns the places of all vertices after it.
    OwnMethod = Callable[[_core.SweepInput], ArrayLike]
    # Called with stage, share of the work from 0 to 1, and subject; False ends the work.
    Progress = Callable[[str, float, str], Optional[bool]]
