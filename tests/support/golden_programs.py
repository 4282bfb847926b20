"""Where the golden programs stand: tests/programs/DIALECT/NAME.nc, or in a room of the dialect, DIALECT/ROOM/NAME.nc.

Folders below a room hold the files that its programs call; they are no programs of their own.
"""
import pathlib
import shlex

PROGRAMS = pathlib.Path(__file__).resolve().parents[1] / "programs"


def dialect_of(program):
    """The name of the dialect in whose folder the program stands."""
    return program.relative_to(PROGRAMS).parts[0]


def arguments_of(program):
    """The further arguments of `isogloss run` that NAME.args beside the program holds."""
    file = program.with_suffix(".args")
    return shlex.split(file.read_text()) if file.exists() else []


def golden_files(suffix="", dialect="*"):
    """The files of the dialect, or of all, whose names end so, by dialect and name: the room does not change the order."""
    files = [p for depth in ("*", "*/*") for p in PROGRAMS.glob(f"{dialect}/{depth}{suffix}") if p.is_file()]
    return sorted(files, key=lambda p: (dialect_of(p), p.name, p))
