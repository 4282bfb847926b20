import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple, Self, TypedDict, Unpack

import numpy as np

from ._isogloss import Block as Block

__version__: str
MOTION: np.dtype
MOTION_OFFSET: int
CIRCLE: np.dtype
EVENTS: tuple[str, ...]

Path = str | os.PathLike[str]
Triple = tuple[float, float, float]

class Options(TypedDict, total=False):
    text: str | bytes | None
    dialect: Path | None
    machine: Path | None
    offsets: Path | None
    tools: Path | None
    variables: Path | None
    set: Mapping[str, float | str] | Iterable[str] | None
    block_skip: str | Iterable[int] | None
    optional_stop: bool
    start_program: str | None
    subprograms: Path | Iterable[Path]
    main_passes: int | None
    on_error: Literal["stop", "continue"]
    max_blocks: int
    max_motions: int
    max_diagnostics: int
    zero_moves: bool
    summary: bool
    plugins: Path | Iterable[Path]
    dialects: Path | Iterable[Path]
    machines: Path | Iterable[Path]
    any_plugins: bool
    syntaxes: Sequence[Syntax]

@dataclass(frozen=True)
class Diagnostic:
    code: str
    severity: str
    message: str
    file: str = ""
    line: int = 0
    column: int = 0
    end_column: int = 0
    hint: str = ""

class Error(Exception):
    diagnostics: list[Diagnostic]
    def __init__(self, diagnostics: list[Diagnostic]) -> None: ...

class Fault(Error): ...

class Motion(NamedTuple):
    file: str
    line: int
    event: str
    program: Triple
    machine: tuple[float, float, float, float, float, float]
    feed: float
    seconds: float
    value: float
    count: int
    text: str

class Motions:
    motions: np.ndarray
    circles: np.ndarray
    texts: list[str]
    def __init__(self, motions: np.ndarray, circles: np.ndarray, texts: list[str]) -> None: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Motion]: ...
    @property
    def positions(self) -> np.ndarray: ...
    @property
    def program_positions(self) -> np.ndarray: ...
    @property
    def feeds(self) -> np.ndarray: ...
    @property
    def seconds(self) -> np.ndarray: ...
    @property
    def times(self) -> np.ndarray: ...
    @property
    def lines(self) -> np.ndarray: ...
    @property
    def events(self) -> np.ndarray: ...
    def is_move(self) -> np.ndarray: ...
    def tools(self) -> np.ndarray: ...

class Result(Motions):
    program: str
    dialect: str
    diagnostics: list[Diagnostic]
    summary: dict[str, Any] | None
    @property
    def errors(self) -> list[Diagnostic]: ...
    def check(self) -> Self: ...
    def blocks(self) -> Blocks: ...

class Blocks:
    def __iter__(self) -> Iterator[dict[str, Any]]: ...
    def __next__(self) -> dict[str, Any]: ...
    @property
    def diagnostics(self) -> list[Diagnostic]: ...
    def close(self) -> None: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, *_: object) -> None: ...

@dataclass(frozen=True)
class Field:
    path: str
    type: str = ""
    life: str = ""

class Syntax:
    function: Callable[[Block], object]
    def __call__(self, block: Block) -> object: ...

Fields = str | Field | Sequence[str | Field]

def run(program: Path | None = None, **given: Unpack[Options]) -> Result: ...
def blocks(program: Path | None = None, **given: Unpack[Options]) -> Blocks: ...
def explain(where: Path, *, pass_: int = 1, in_file: Path = "", **given: Unpack[Options]) -> list[dict[str, Any]]: ...
def read_motions(file: Path) -> Motions: ...
def dialects(folders: Path | Iterable[Path] = ()) -> dict[str, str]: ...
def syntax(*, after: str = "", before: str = "", stage: str = "logic", reads: Fields = (), writes: Fields = (),
           takes: Fields = (), wakes: Fields | None = None, wakes_while: Fields = (),
           diagnostics: Mapping[str, tuple[str, str]] | None = None) -> Callable[[Callable[[Block], object]], Syntax]: ...
