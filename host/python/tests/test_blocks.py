"""Blocks as they come, explanations, and the binary stream."""

import json
import subprocess
import sys
import time

import isogloss
import numpy as np
import pytest

LONG = "O1\nG90 G54 G94\n" + "G1 X1. F100\nX2.\n" * 100_000 + "M30\n"


def test_blocks_are_those_of_the_command(part, command):
    expected = [json.loads(line) for line in
                command("run", part, "-d", "fanuc", "--emit", "blocks").stdout.decode().splitlines()]
    assert list(isogloss.blocks(part, dialect="fanuc")) == expected
    assert list(isogloss.run(part, dialect="fanuc").blocks()) == expected


def test_a_reader_may_stop_early():
    begin = time.monotonic()
    with isogloss.blocks(text=LONG * 5, dialect="fanuc") as blocks:
        assert "Source" in next(blocks) or True
    assert time.monotonic() - begin < 30
    with pytest.raises(StopIteration):
        next(blocks)
    blocks.close()


def test_an_open_iterator_does_not_hold_the_interpreter():
    script = ("import isogloss\nblocks = isogloss.blocks(text='O1\\n' + 'G1 X1. F100\\nX2.\\n' * 300000 + 'M30\\n', "
              "dialect='fanuc')\nprint(len(next(blocks)) > 0)")
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stdout) == (0, "True\n"), done.stderr


def test_blocks_of_nothing_raise(tmp_path):
    with pytest.raises(isogloss.Error):
        list(isogloss.blocks(tmp_path / "none.nc", dialect="fanuc"))


def test_explain_is_the_json_of_the_command(part, command):
    expected = json.loads(command("explain", f"{part}:7", "-d", "fanuc", "--all", "--json").stdout)
    assert isogloss.explain(f"{part}:7", dialect="fanuc") == expected
    assert [b["Line"] for b in isogloss.explain(f"{part}:6-8", dialect="fanuc")] == [6, 7, 8]


def test_what_cannot_be_explained_is_an_error(part):
    with pytest.raises(isogloss.Error) as raised:
        isogloss.explain(f"{part}:700", dialect="fanuc")
    assert any(d.code == "IG-0515" for d in raised.value.diagnostics)
    with pytest.raises(isogloss.Error):
        isogloss.explain(f"{part}:x", dialect="fanuc")
    with pytest.raises(ValueError):
        isogloss.explain("part.nc", dialect="fanuc")


def test_a_stream_of_the_command_is_read(part, command, tmp_path):
    stream = tmp_path / "part.igm"
    command("run", part, "-d", "fanuc", "--format", "binary", "-o", stream)
    result, read = isogloss.run(part, dialect="fanuc"), isogloss.read_motions(stream)
    assert read.motions.tobytes() == result.motions.tobytes()
    assert read.texts == result.texts
    records = np.memmap(stream, isogloss.MOTION, "r", isogloss.MOTION_OFFSET)
    assert records[records["event"] < 128].tobytes() == result.motions.tobytes()
    header = json.loads(stream.read_bytes()[24:isogloss.MOTION_OFFSET])
    assert np.dtype([(f[0], f[1], *f[2:]) for f in header["Fields"]]) == isogloss.MOTION


def test_damaged_streams_are_errors(part, command, tmp_path):
    stream = tmp_path / "part.igm"
    command("run", part, "-d", "fanuc", "--format", "binary", "-o", stream)
    whole = stream.read_bytes()
    for damaged, code in ((b"", "IG-0640"), (whole[:-1], "IG-0642"), (b"x" + whole, "IG-0640")):
        stream.write_bytes(damaged)
        with pytest.raises(isogloss.Error) as raised:
            isogloss.read_motions(stream)
        assert raised.value.diagnostics[0].code == code
    with pytest.raises(isogloss.Error):
        isogloss.read_motions(tmp_path / "none.igm")
