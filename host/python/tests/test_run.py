"""Whole runs: the arrays hold what the command writes."""

import csv
import gc
import io
import json
import math
import os
import pathlib
import shutil
import threading
import time

import isogloss
import numpy as np
import pytest


def rows_of(command, *arguments):
    return list(csv.DictReader(io.StringIO(command("run", *arguments, "--format", "csv", "--exact").stdout.decode())))


def test_motions_are_those_of_the_command(part, command):
    result = isogloss.run(part, dialect="fanuc")
    rows = rows_of(command, part, "-d", "fanuc")
    assert len(result) == len(rows) == 10
    for motion, row in zip(result, rows):
        assert (motion.file, motion.line, motion.event) == (row["file"], int(row["line"]), row["event"])
        for value, key in zip((*motion.program, *motion.machine, motion.feed),
                              ("px", "py", "pz", "mx", "my", "mz", "a", "b", "c", "feed_mm_s")):
            assert math.isnan(value) if row[key] == "" else value == float(row[key]), (row, key)
    (circle,) = result.circles
    row = rows[circle["motion"]]
    assert row["event"] == "arc"
    assert list(circle["center"]) == [float(row[k]) for k in ("cx", "cy", "cz")]
    assert list(circle["machine_center"]) == [float(row[k]) for k in ("mcx", "mcy", "mcz")]
    assert list(circle["normal"]) == [0, 0, 1]
    assert circle["sweep"] == float(row["sweep"]) == -180


def test_columns_are_views_of_one_array(part):
    result = isogloss.run(part, dialect="fanuc")
    for column in (result.positions, result.program_positions, result.feeds, result.seconds, result.lines, result.events):
        assert column.base is not None and np.shares_memory(column, result.motions)


def test_arrays_outlive_the_result(part):
    lines = isogloss.run(part, dialect="fanuc").lines
    gc.collect()
    for _ in range(20):
        isogloss.run(part, dialect="fanuc")
    assert lines[0] == 4


def test_seconds_times_and_tools(part):
    result = isogloss.run(part, dialect="fanuc")
    events = [isogloss.EVENTS[e] for e in result.events]
    arc = events.index("arc")
    assert result.seconds[arc] == pytest.approx(math.pi * 5 / (100 / 60))
    assert result.seconds[events.index("dwell")] == 0.5
    assert result.times[-1] == pytest.approx(np.nansum(result.seconds))
    assert list(result.tools()) == [1] * 5 + [2] * 5
    assert result.summary["feed_seconds"] == pytest.approx(np.nansum(result.seconds[result.events <= 2][1:]))
    assert result.summary["program_extents"]["Y"][1] == pytest.approx(5)
    assert isogloss.run(part, dialect="fanuc", summary=False).summary is None


@pytest.mark.parametrize("program, given", [
    ("fanuc/demo.nc", {"tools": "fanuc/tools.xml"}),
    ("fanuc/five_axis/tip_control.nc", {"machine": "fanuc/five_axis/tip_control.machine.xml"}),
    ("fanuc/rotary_axes/rotary_axes.nc", {}),
])
def test_the_summary_is_that_of_the_command(program, given, command):
    """It is added up together with the arrays; alone, where they hold moves that the summary does not count."""
    programs = pathlib.Path(__file__).resolve().parents[3] / "tests/programs"
    given = {name: str(programs / file) for name, file in given.items()}
    one_pass = isogloss.run(programs / program, dialect="fanuc", **given).summary
    assert one_pass == isogloss.run(programs / program, dialect="fanuc", zero_moves=True, **given).summary
    options = [word for name, file in given.items() for word in (f"--{name}", file)]
    shown = json.loads(command("run", programs / program, "-d", "fanuc", *options, "--summary", "--json").stdout)
    for key, name in (("feed_length_mm", "FeedLength_mm"), ("rapid_length_mm", "RapidLength_mm"), ("events", "Events"),
                      ("blocks", "Blocks"), ("feed_seconds", "FeedTime_s"), ("rapid_seconds", "RapidTime_s")):
        assert one_pass[key] == shown[name], key
    assert one_pass["events"] > 5


def test_the_dialect_is_guessed_as_by_the_command(part, command):
    result = isogloss.run(part)
    (note,) = [d for d in result.diagnostics if d.code == "IG-0514"]
    assert (note.severity, result.dialect) == ("note", "fanuc")
    assert note.message in command("run", part, "--emit", "none").stderr.decode()


def test_settings_reach_the_run(part):
    plain = isogloss.run(part, dialect="fanuc").positions
    moved = isogloss.run(part, dialect="fanuc", set={"IsoCoordinateTable.G54.Z": -120.5}).positions
    moves = ~np.isnan(plain[:, 2])
    assert np.allclose(moved[moves, 2] - plain[moves, 2], -120.5)
    assert len(isogloss.run(part, dialect="fanuc", max_blocks=5)) < len(plain)


def test_text_instead_of_a_file():
    result = isogloss.run(text="G21 G90 G0 X1.\nM30\n", dialect="fanuc")
    assert result.texts[0] == "program.nc"
    assert isogloss.run("name.nc", text=b"G0 X1.\n(\xff)\nM30\n", dialect="fanuc").texts[0] == "name.nc"


def test_diagnostics_are_objects(tmp_path):
    path = tmp_path / "bad.nc"
    path.write_text("O1\nG21 G90 G54\nG1 X10. E7\nM30\n")
    result = isogloss.run(path, dialect="fanuc")
    (unused,) = [d for d in result.diagnostics if d.code == "ISO-0285"]
    assert (unused.severity, unused.file, unused.line, unused.column) == ("warning", str(path), 3, 9)
    assert "E7" in unused.message and "[ISO-0285]" in str(unused)


def test_what_cannot_start_is_an_error(tmp_path, part):
    for given, code in (({"program": tmp_path / "none.nc"}, "IG-0510"), ({"program": part, "dialect": "fanucc"}, "IG-0"),
                        ({"program": part, "set": ["nonsense"]}, "IG-0513"),
                        ({"program": part, "machine": "no such machine"}, "IG-0123"),
                        ({"program": part, "tools": tmp_path / "none.xml"}, "IG-")):
        with pytest.raises(isogloss.Error) as raised:
            isogloss.run(**given)
        assert any(d.code.startswith(code) for d in raised.value.diagnostics), raised.value
        assert str(raised.value)
    with pytest.raises(TypeError, match="dialekt"):
        isogloss.run(part, dialekt="fanuc")
    with pytest.raises(TypeError):
        isogloss.run()
    with pytest.raises(ValueError):
        isogloss.run(part, on_error="halt")


def test_errors_of_a_program_are_raised_on_request():
    result = isogloss.run(text="O1\nG90 G54\nM98 P7777\nM30\n", dialect="fanuc")
    assert result.errors
    with pytest.raises(isogloss.Error) as raised:
        result.check()
    assert raised.value.diagnostics == result.diagnostics
    assert isogloss.run(text="O1\nM30\n", dialect="fanuc").check()


@pytest.mark.parametrize("text", [b"", b"\x00\x01\xff" * 100, b"%" * 5000, b"G1" + b"X1." * 60000, "\ufeffO1\nM30".encode("utf-16")])
def test_broken_programs_are_diagnostics(text):
    result = isogloss.run(text=text, dialect="fanuc")
    assert result.diagnostics
    assert isinstance(result.motions, np.ndarray)


def test_threads_run_at_once(part):
    expected = isogloss.run(part, dialect="fanuc").motions.tobytes()
    faults = []

    def work():
        for _ in range(10):
            if isogloss.run(part, dialect="fanuc").motions.tobytes() != expected:
                faults.append("another result")

    threads = [threading.Thread(target=work) for _ in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert not faults


def test_arrays_keep_every_record_while_they_grow():
    count = 120_000  # 14 MB: their memory moves several times, while a thread asks for more of it
    text = "O1\nG90 G54 G94 F100.\n" + "".join(f"G1 X{n}.\n" for n in range(1, count + 1)) + "M30\n"
    for result in [isogloss.run(text=text, dialect="iso") for _ in range(2)]:
        moves = result.motions[result.is_move()]
        assert np.array_equal(moves["program"][:, 0], np.arange(1, count + 1))
        assert np.array_equal(moves["line"], np.arange(3, count + 3))
        assert result.summary["machine_extents"]["X"] == (0, count)


def test_other_threads_go_on_during_a_run():
    text = "O1\nG90 G54 G94\n" + "G1 X1. F100\nX2.\n" * 150_000 + "M30\n"
    ticks, over = [0], threading.Event()

    def tick():
        while not over.is_set():
            ticks[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    before = ticks[0]
    isogloss.run(text=text, dialect="iso")
    seen = ticks[0] - before
    over.set()
    thread.join()
    assert seen > 5


def test_a_limit_of_diagnostics_ends_the_run():
    text = "O1\n" + "E1\n" * 200_000 + "M30\n"
    result = isogloss.run(text=text, dialect="fanuc", max_diagnostics=100)
    assert len(result.diagnostics) == 101
    assert result.diagnostics[-1].code == "IG-0454"


def test_a_plugin_that_others_can_write_is_refused(part, tmp_path, command):
    folder = tmp_path / "plugins"
    folder.mkdir()
    installed = pathlib.Path(os.environ["ISOGLOSS_COMMAND"]).parent / "plugins"
    for plugin in ("iso.so", "fanuc.so"):
        shutil.copy(installed / plugin, folder)
    (folder / "iso.so").chmod(0o777)
    with pytest.raises(isogloss.Error) as refused:
        isogloss.run(part, dialect="fanuc", plugins=folder)
    assert "IG-0311" in {d.code for d in refused.value.diagnostics}
    allowed = isogloss.run(part, dialect="fanuc", plugins=folder, any_plugins=True)
    assert allowed.motions.tobytes() == isogloss.run(part, dialect="fanuc").motions.tobytes()


def test_dialects_are_listed():
    assert "Fanuc" in isogloss.dialects()["fanuc"]
