"""What a run is asked for: the keyword arguments that run(), blocks() and explain() share."""

from __future__ import annotations

import os
import pathlib
import shutil

from . import _isogloss


def _home() -> str:
    """The folder of the command: of the build tree or the installation that this package is part of."""
    for folder in pathlib.Path(_isogloss.__file__).resolve().parents:
        if (folder / "lib/isogloss/plugins").is_dir():
            return str(folder / "bin")
        if (folder / "plugins").is_dir() and (folder / "dialects").is_dir():
            return str(folder)
    command = shutil.which("isogloss")
    return os.path.dirname(os.path.realpath(command)) if command else ""


def _paths(value) -> list[str]:
    if isinstance(value, (str, os.PathLike)):
        value = [value]
    return [os.fspath(v) for v in value]


def _assignments(value) -> list[str]:
    if hasattr(value, "items"):
        return [f"{name}={_number(number)}" for name, number in value.items()]
    return [value] if isinstance(value, str) else list(value)


def _number(value) -> str:
    return repr(float(value)) if isinstance(value, float) else str(value)


def _layers(value) -> str:
    return value if isinstance(value, str) else ",".join(str(layer) for layer in value)


# How each keyword becomes a member of the request; others are passed on as they are.
_conversions = {
    "machine": os.fspath, "dialect": os.fspath, "offsets": os.fspath, "tools": os.fspath, "variables": os.fspath,
    "set": _assignments, "block_skip": _layers, "subprograms": _paths, "plugins": _paths, "dialects": _paths,
    "machines": _paths, "main_passes": str,
}
_plain = {"optional_stop", "start_program", "on_error", "max_blocks", "max_motions", "max_diagnostics", "zero_moves",
          "summary", "any_plugins"}


def make(program, text=None, syntaxes=(), **given) -> _isogloss.Request:
    """A request for one run. Unknown keywords are a TypeError, as of any function."""
    request = _isogloss.Request()
    request.home = _home()
    if program is None and text is None:
        raise TypeError("a program is needed: its path, or its text")
    request.path = "program.nc" if program is None else os.fspath(program)
    if text is not None:
        request.text = text.encode("utf-8", "surrogateescape") if isinstance(text, str) else bytes(text)
    for name, value in given.items():
        if name not in _conversions and name not in _plain:
            raise TypeError(f"isogloss has no keyword argument '{name}'")
        if value is None:
            continue
        if name == "on_error" and value not in ("stop", "continue"):
            raise ValueError(f"on_error is 'stop' or 'continue', not {value!r}")
        setattr(request, name, _conversions[name](value) if name in _conversions else value)
    request.syntaxes = [getattr(s, "spec", s) for s in syntaxes]
    return request


def dialects(folders=()) -> dict[str, str]:
    """The dialects in the folders and in the installation: titles by name."""
    request = _isogloss.Request()
    request.home = _home()
    request.dialects = _paths(folders)
    return dict(_isogloss.list_dialects(request))
