"""Run by ctest as `/usr/bin/python3 -m pytest host/python/tests` with the built package in PYTHONPATH, and the command in
ISOGLOSS_COMMAND."""

import os
import pathlib
import subprocess

import pytest

PART = """%
O0001 (PART)
G21 G17 G90 G54 G94
T1 M6
M3 S1000
G0 X0 Y0 Z5.
G1 Z-1. F100
G2 X10. Y0 I5. J0
T2 M6
G1 X20. F200
G4 P500
M5
M30
%
"""


@pytest.fixture
def part(tmp_path):
    path = tmp_path / "part.nc"
    path.write_text(PART)
    return path


@pytest.fixture
def command():
    """Runs the command that was built beside the package."""
    path = os.environ.get("ISOGLOSS_COMMAND")
    if not path:
        pytest.skip("ISOGLOSS_COMMAND does not name the command")
    return lambda *arguments: subprocess.run([path, *map(str, arguments)], capture_output=True, check=False)


@pytest.fixture
def source():
    return pathlib.Path(__file__).resolve().parents[3]
