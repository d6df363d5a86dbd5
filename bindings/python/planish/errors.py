"""What goes wrong, as exceptions: the words and the codes are those of the program (docs/errors.md)."""

from __future__ import annotations

from typing import Optional

__all__ = ["Cancelled", "Error", "FileError", "FormatError", "MeshError", "PatternError", "Place", "RequestError"]


class Place:
    """Where the fault is; None is not known."""

    def __init__(
        self,
        path: Optional[str] = None,
        line: Optional[int] = None,
        byte: Optional[int] = None,
        first: Optional[int] = None,
        count: Optional[int] = None,
    ) -> None:
        self.path = path
        """File."""
        self.line = line
        """Line of a text file, from 1."""
        self.byte = byte
        """Offset in a binary file, from 0."""
        self.first = first
        """First vertex, triangle or edge at fault, from 0."""
        self.count = count
        """How many are at fault."""

    def __repr__(self) -> str:
        known = ", ".join(f"{name}={value!r}" for name, value in vars(self).items() if value is not None)
        return f"Place({known})"


class Error(Exception):
    """A fault of the input or the request."""

    code: str = "internal_error"
    """Its stable name, as non_manifold_edge."""
    place: Place = Place()
    """Where it is."""


class FileError(Error):
    """A file cannot be found, read or written."""


class FormatError(Error):
    """What a file or an array holds is wrong."""


class MeshError(Error):
    """A mesh is not of the kind that the work needs."""


class RequestError(Error, ValueError):
    """What was asked for cannot be had."""


class PatternError(Error):
    """A pattern, or what it is to carry, cannot be made."""


class Cancelled(Error):
    """A progress function ended the work. Nothing of it is left."""


# Family -> its codes.
FAMILIES: dict[type[Error], str] = {
    FileError: "file_not_found file_unreadable file_unwritable unsupported_format",
    FormatError: "malformed_file truncated_file bad_number index_out_of_range no_triangles too_large",
    MeshError: "non_finite_coordinate repeated_index duplicate_triangle zero_length_edge zero_area non_manifold_edge "
    "non_manifold_vertex inconsistent_orientation non_orientable closed_surface open_surface several_components "
    "several_border_loops handles no_inner_vertex unreferenced_vertex",
    RequestError: "option_out_of_range unknown_name unsupported_constraint misplaced_cut not_symmetric method_failed "
    "usage",
    PatternError: "unfold_failed overlapping_outline allowance_too_wide misplaced_allowance misplaced_notch "
    "misplaced_mark no_grain_direction piece_too_large",
    Cancelled: "interrupted",
}


def make(
    code: str,
    words: str,
    path: Optional[str] = None,
    line: Optional[int] = None,
    byte: Optional[int] = None,
    first: Optional[int] = None,
    count: Optional[int] = None,
) -> Error:
    """The exception of a code of the program."""
    family = next((family for family, codes in FAMILIES.items() if code in codes.split()), Error)
    error = family(words)
    error.code = code
    error.place = Place(path, line, byte, first, count)
    return error
