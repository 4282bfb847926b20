"""Diagnostics as objects, and the exceptions that hold them."""

from __future__ import annotations

import dataclasses

from . import _isogloss


@dataclasses.dataclass(frozen=True)
class Diagnostic:
    """What Isogloss reports about a program, a dialect or a plugin. Lines and columns count from 1; 0 is unknown."""

    code: str
    severity: str
    message: str
    file: str = ""
    line: int = 0
    column: int = 0
    end_column: int = 0
    hint: str = ""

    def __str__(self) -> str:
        place = self.file
        if self.line:
            place += f":{self.line}" + (f":{self.column}" if self.column else "")
        hint = f" ({self.hint})" if self.hint else ""
        return f"{place + ': ' if place else ''}{self.severity}: {self.message}{hint} [{self.code}]"


class Error(Exception):
    """A run that could not start, or errors of a program that Result.check() raises. `diagnostics` says why."""

    def __init__(self, diagnostics: list[Diagnostic]):
        self.diagnostics = diagnostics
        told = [d for d in diagnostics if d.severity == "error"] or diagnostics
        more = f"\n… and {len(told) - 5} more" if len(told) > 5 else ""
        super().__init__("\n".join(str(d) for d in told[:5]) + more)

    def __reduce__(self):
        return type(self), (self.diagnostics,)


class Fault(Error):
    """A plugin threw, or broke its contract: the result would be wrong. Ask its vendor."""


def diagnostics_of(tuples) -> list[Diagnostic]:
    return [Diagnostic(*t) for t in tuples]


def raise_unless(started: bool, diagnostics: list[Diagnostic]) -> None:
    if any(_isogloss.is_internal_fault(d.code) for d in diagnostics):
        raise Fault(diagnostics)
    if not started:
        raise Error(diagnostics)
