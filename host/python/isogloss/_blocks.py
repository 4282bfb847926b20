"""Blocks as they are executed."""

from __future__ import annotations

import atexit
import json
import weakref

from . import _isogloss, _request
from ._errors import diagnostics_of, raise_unless

_open = weakref.WeakSet()


@atexit.register
def _close_all() -> None:
    """A run must not outlive the interpreter."""
    for blocks_ in list(_open):
        blocks_.close()


class Blocks:
    """An iterator of documents; the program runs on a thread of its own while they are read, and memory stays flat.

    Close it, leave a `with` statement, or let it go: that ends the run."""

    def __init__(self, request):
        self._stream = _isogloss.BlockStream(request)
        self._lines: list[bytes] = []
        self._rest = b""
        self._is_over = False
        _open.add(self)

    def __iter__(self):
        return self

    def __next__(self) -> dict:
        while not self._lines:
            if self._is_over:
                raise StopIteration
            self._fetch()
        return json.loads(self._lines.pop())

    def _fetch(self) -> None:
        piece = self._stream.next()
        if piece is None:
            self._is_over = True
            self._stream.close()
            raise_unless(self._stream.is_started(), self.diagnostics)
            return
        lines = (self._rest + piece).split(b"\n")
        self._rest = lines.pop()
        self._lines = lines[::-1]

    @property
    def diagnostics(self):
        """Of the run so far, which is ahead of the iterator."""
        return diagnostics_of(self._stream.diagnostics())

    def close(self) -> None:
        self._is_over = True
        self._lines = []
        self._stream.close()

    def __enter__(self) -> "Blocks":
        return self

    def __exit__(self, *_) -> None:
        self.close()


def blocks(program=None, **given) -> Blocks:
    """Runs a program and gives the document of each executed block as a dict, as `isogloss run --emit blocks` writes it.

    Takes what run() takes. Raises at the first document when the run cannot start."""
    return Blocks(_request.make(program, **given))
