"""The examples, as a user starts them."""

import os
import subprocess
import sys

import pytest


@pytest.fixture
def example(source):
    def run(name, *arguments):
        done = subprocess.run([sys.executable, source / "host/python/examples" / name, *map(str, arguments)],
                              capture_output=True, text=True, check=False, env=os.environ)
        return done.returncode, done.stdout, done.stderr
    return run


def test_cycle_time(example, part):
    status, out, _ = example("cycle_time.py", part, "--dialect", "fanuc")
    rows = [line.split() for line in out.splitlines()[1:]]
    assert status == 0
    assert [row[0] for row in rows] == ["1", "2"]
    assert float(rows[0][1]) == pytest.approx((6 + 15.708) / (100 / 60), abs=0.1)
    assert float(rows[1][3]) == 0.5


def test_travel_check(example, part):
    status, out, _ = example("travel_check.py", part, "--dialect", "fanuc", "--travel", "X=-1:15", "--travel", "Y=-1:9")
    assert status == 1
    assert f"{part}:10: X goes to 20.000, beyond its travel" in out
    assert "Y      0.000      5.000" in out
    assert example("travel_check.py", part, "--dialect", "fanuc", "--travel", "X=-1:25")[0] == 0


def test_compare_dialects(example, part, tmp_path):
    assert example("compare_dialects.py", part, "fanuc", "haas")[:2] == (0, "the same motions\n")
    dwell = tmp_path / "o.nc"
    dwell.write_text("O1\nG21 G90 G54 G94\nG0 X0 Y0 Z0\nG1 X10. F100\nM30\n")
    status, out, _ = example("compare_dialects.py", dwell, "fanuc", "fanuc", "--slow")
    assert status == 0 and "cutting takes 6.0 s, at half the feed 12.0 s" in out


def test_an_example_says_what_is_wrong(example, tmp_path):
    for name, more in (("cycle_time.py", ()), ("travel_check.py", ()), ("compare_dialects.py", ("fanuc", "haas"))):
        status, _, errors = example(name, tmp_path / "none.nc", *more)
        assert status == 1 and "IG-0510" in errors and "Traceback" not in errors
