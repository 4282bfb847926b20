"""Why a block did what it did."""

from __future__ import annotations

import json
import os

from . import _isogloss, _request
from ._errors import Error, diagnostics_of


def explain(where, *, pass_=1, in_file="", **given) -> list[dict]:
    """Explains the blocks of "part.nc:12" or "part.nc:10-20": one dict for each, as schemas/explain.schema.json describes.

    pass_: which time, for a line that runs several times. in_file: a called program's file, which holds the line. Further
    arguments as of run(); with text="…" the name before the colon is only a name. Raises Error when the run does not come
    to the line."""
    program, colon, lines = os.fspath(where).rpartition(":")
    if not colon:
        raise ValueError(f"explain needs PROGRAM:LINE or PROGRAM:10-20, not {os.fspath(where)!r}")
    text, said = _isogloss.explain(_request.make(program, **given), lines, pass_, os.fspath(in_file))
    if not text:
        raise Error(diagnostics_of(said))
    return json.loads(text)
