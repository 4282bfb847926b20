"""Syntaxes in Python, to try an idea before it is written in C++."""

from __future__ import annotations

import dataclasses
from typing import Callable

from . import _isogloss


@dataclasses.dataclass(frozen=True)
class Field:
    """A field that no syntax of the dialect has. type: number, integer, boolean, symbol, text, code, transform, switch;
    life: block (to the end of the block), modal (until it changes), frame (of one call), word."""

    path: str
    type: str = ""
    life: str = ""


class Syntax:
    """A function that can stand in a chain."""

    def __init__(self, function: Callable, spec: _isogloss.SyntaxSpec):
        self.function = function
        self.spec = spec
        self.__name__ = function.__name__
        self.__doc__ = function.__doc__

    def __call__(self, block):
        return self.function(block)


def _fields(reads, writes, takes, wakes, wakes_while):
    found: dict[str, list] = {}
    for fields, access in ((reads, _isogloss.READ), (writes, _isogloss.WRITE), (takes, _isogloss.TAKE),
                           (wakes, _isogloss.WAKE | _isogloss.READ), (wakes_while, _isogloss.WAKE_WHILE | _isogloss.READ)):
        for field in [fields] if isinstance(fields, (str, Field)) else fields:
            field = field if isinstance(field, Field) else Field(field)
            entry = found.setdefault(field.path, [0, "", ""])
            entry[0] |= access
            entry[1] = field.type or entry[1]
            entry[2] = field.life or entry[2]
    return [(path, access, type_, life) for path, (access, type_, life) in found.items()]


def syntax(*, after="", before="", stage="logic", reads=(), writes=(), takes=(), wakes=None, wakes_while=(),
           diagnostics=None):
    """Makes a syntax of a function that gets a Block: isogloss.run(…, syntaxes=[it]).

    after, before: the alias of a syntax in the chain, beside which it stands; without one it is the last of its stage
    (parsing, evaluation, logic, post_logic, inspection). reads, writes, takes: paths of fields, or Field(…) for new ones;
    others cannot be reached. wakes: the fields that call it in a block that sets them; default: those that it reads or
    takes. wakes_while: fields that call it in each block that begins with a value of them. diagnostics: what it reports,
    {"SHOP-0001": ("warning", "the feed {0} is too high")}.

    It is slow: a call takes about a microsecond and the interpreter's lock, where a plugin takes nanoseconds. An exception
    ends the run and comes out of it. Scanners, lists, options and services need a plugin."""
    if after and before:
        raise ValueError("give after or before, not both")

    def decorate(function: Callable) -> Syntax:
        woken_by = wakes if wakes is not None else [*_listed(reads), *_listed(takes)]
        summary = (function.__doc__ or "A syntax in Python.").strip().splitlines()[0]
        spec = _isogloss.SyntaxSpec(function.__name__, summary, stage, after, before,
                                    _fields(reads, writes, takes, woken_by, wakes_while),
                                    [(code, *row) for code, row in (diagnostics or {}).items()], function)
        return Syntax(function, spec)

    return decorate


def _listed(fields):
    return [fields] if isinstance(fields, (str, Field)) else list(fields)
