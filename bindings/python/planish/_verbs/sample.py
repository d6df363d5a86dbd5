"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import Optional

from .. import _core, _run


def sample(
    name: str,
    *,
    vertices: Optional[int] = None,
) -> _core.Mesh:
    """A built-in patch made by formula, in millimetres.

    Keywords, as flags of the program:
        vertices: about how many vertices (100 to 10000000, default 5000)
    """
    given = _run.keywords_of(locals())
    return _core.sample(name, given)
