"""Part programs of CNC machines, resolved: what `isogloss run` and `isogloss explain` know, as Python values.

    import isogloss
    result = isogloss.run("part.nc", dialect="fanuc", set={"IsoCoordinateTable.G54.Z": -120})
    for d in result.diagnostics: print(d)
    print(result.motions["machine"], result.seconds.sum())

Lengths are in mm, angles in degrees, times in seconds, feeds in mm/s. What is not known is nan.

Lifetimes: a Result owns its arrays; numpy keeps their memory alive as long as an array refers to it. A Blocks iterator
owns a run on a thread of its own until it is closed or at its end. A Block that a syntax gets ends with the call.

Threads: the interpreter's lock is released while the engine works, so runs on several Python threads are parallel;
plugins are loaded and dialects linked one thread at a time. A syntax in Python takes the lock for each call. Ctrl-C
ends a run: it is looked for every 65,536 blocks, and in each syntax in Python.

Errors: a run that cannot start (no such file, dialect or option) raises Error; a fault inside a plugin raises Fault. Both
hold the diagnostics. Errors of the program itself are diagnostics of the result: Result.check() raises them. What a
syntax in Python raises ends the run and comes out of it unchanged.
"""

from ._blocks import Blocks, blocks
from ._explain import explain
from ._request import dialects
from ._result import CIRCLE, EVENTS, MOTION, MOTION_OFFSET, Motion, Motions, Result, read_motions, run
from ._syntax import Field, syntax
from ._errors import Diagnostic, Error, Fault
from ._isogloss import Block
from ._isogloss import version as __version__

__all__ = [
    "Block", "Blocks", "CIRCLE", "Diagnostic", "EVENTS", "Error", "Fault", "Field", "MOTION", "MOTION_OFFSET", "Motion",
    "Motions", "Result", "__version__", "blocks", "dialects", "explain", "read_motions", "run", "syntax",
]
