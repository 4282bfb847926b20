"""Syntaxes in Python."""

import os
import signal
import subprocess
import sys
import threading
import time

import isogloss
import numpy as np
import pytest

PART = "O1\nG21 G90 G54 G94\nG0 X0 Y0 Z0\nG1 X10. F100 E7\nX20.\nX30. F600\nM30\n"
AFTER = "FeedrateSyntax"


def anchor():
    """An alias of the chain, whatever it is called: the syntax that writes the feed."""
    step = next(s for b in isogloss.explain("p.nc:4", text=PART, dialect="fanuc") for s in b["Steps"]
                if any(c["Path"] == "Feedrate.FeedrateValue" for c in s["Changes"]))
    return step["Syntax"]


def test_a_syntax_takes_a_word_and_reports():
    seen = []

    @isogloss.syntax(before="UnconsumedCheckSyntax", takes="Parsing.E", diagnostics={"SHOP-0001": ("warning", "E is {0}")})
    def extruder(block):
        """Takes E."""
        value = block.take("Parsing.E")
        seen.append((value, block.text))
        block.report("SHOP-0001", value)

    result = isogloss.run(text=PART, dialect="fanuc", syntaxes=[extruder])
    assert seen == [(7.0, "G1 X10. F100 E7")]
    assert [(d.code, d.line, d.message) for d in result.diagnostics if d.severity == "warning"] == [
        ("SHOP-0001", 4, "E is 7.0")]
    assert "ISO-0285" in {d.code for d in isogloss.run(text=PART, dialect="fanuc").diagnostics}


def test_a_syntax_changes_the_motion():
    @isogloss.syntax(before=anchor(), reads="Parsing.F", writes="Parsing.F")
    def half(block):
        block["Parsing.F"] = block["Parsing.F"] / 2

    plain = isogloss.run(text=PART, dialect="fanuc")
    halved = isogloss.run(text=PART, dialect="fanuc", syntaxes=[half])
    moves = ~np.isnan(plain.feeds)
    assert moves.sum() == 3
    assert np.allclose(halved.feeds[moves], plain.feeds[moves] / 2)
    explained = isogloss.explain("p.nc:4", text=PART, dialect="fanuc", syntaxes=[half])
    assert "half" in [s["Syntax"] for s in explained[0]["Steps"]]


def test_new_fields_have_types_and_lives():
    values = []

    @isogloss.syntax(reads=["Parsing.F", isogloss.Field("Shop.Count", "integer", "modal")],
                     writes=[isogloss.Field("Shop.Name", "text"), "Shop.Count"], wakes="Parsing.F")
    def count(block):
        values.append(block.get("Shop.Count", 0))
        block["Shop.Count"] = block.get("Shop.Count", 0) + 1
        block["Shop.Name"] = "block %s" % block.text
        assert block.is_fresh("Shop.Count") and "Shop.Name" in block

    documents = list(isogloss.blocks(text=PART, dialect="fanuc", syntaxes=[count]))
    assert values == [0, 1]
    assert documents[-2]["Shop"] == {"Name": "block X30. F600", "Count": 2}


def test_an_exception_ends_the_run_and_comes_out():
    calls = []

    @isogloss.syntax(reads="Parsing.F")
    def faulty(block):
        calls.append(block.text)
        raise ZeroDivisionError("on purpose")

    for run in (isogloss.run, lambda **given: list(isogloss.blocks(**given)),
                lambda **given: isogloss.explain("p.nc:6", **given)):
        calls.clear()
        with pytest.raises(ZeroDivisionError, match="on purpose"):
            run(text=PART, dialect="fanuc", syntaxes=[faulty])
        assert len(calls) == 1


def test_what_is_not_declared_cannot_be_reached():
    tried = []

    @isogloss.syntax(reads="Parsing.F")
    def curious(block):
        for attempt in (lambda: block["Parsing.X"], lambda: block.take("Parsing.F"), lambda: block.report("SHOP-0001"),
                        lambda: block.__setitem__("Parsing.F", 1)):
            with pytest.raises(KeyError):
                attempt()
            tried.append(attempt)
        tried.append(block)

    isogloss.run(text=PART, dialect="fanuc", syntaxes=[curious])
    assert len(tried) == 10
    with pytest.raises(RuntimeError, match="the block has ended"):
        tried[-1].text


def test_wrong_declarations_are_errors():
    def error(**given):
        @isogloss.syntax(**given)
        def wrong(block):
            pass

        with pytest.raises(isogloss.Error) as raised:
            isogloss.run(text=PART, dialect="fanuc", syntaxes=[wrong])
        return raised.value.diagnostics

    assert [d.code for d in error(reads="Parsing.F", after="NoSuchSyntax")] == ["IG-0646"]
    assert "IG-0646" in [d.code for d in error(reads="Shop.New")]
    assert "IG-0646" in [d.code for d in error(reads="Parsing.F", stage="noon")]
    assert "IG-0646" in [d.code for d in error(reads="CompoundMotion.Items[].Dwell.Time")]
    assert error(reads="Parsing.F", diagnostics={"no code": ("warning", "x")})
    assert error(reads=isogloss.Field("Feedrate.FeedrateValue", "text"))
    with pytest.raises(ValueError):
        isogloss.syntax(after="A", before="B")


def test_runs_with_syntaxes_on_threads():
    def work(factor, results):
        @isogloss.syntax(before=name, reads="Parsing.F", writes="Parsing.F")
        def scaled(block):
            block["Parsing.F"] = block["Parsing.F"] * factor

        for _ in range(3):
            results.append(np.nanmax(isogloss.run(text=PART, dialect="fanuc", syntaxes=[scaled]).feeds) / factor)

    name, results = anchor(), []
    threads = [threading.Thread(target=work, args=(f, results)) for f in (1, 2, 3)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert results == pytest.approx([10.0] * 9)


@pytest.mark.parametrize("way", ["isogloss.run(text=text, dialect='fanuc')",
                                 "[b for b in isogloss.blocks(text=text, dialect='fanuc')]",
                                 "isogloss.run(text=text, dialect='fanuc', syntaxes=[idle])"])
def test_a_keyboard_interrupt_ends_a_run(way):
    script = f"""
import isogloss, sys
@isogloss.syntax(reads="Parsing.X")
def idle(block): pass
text = "O1\\nG90 G54 G94\\nN1 G1 X1. F100\\nX2.\\nGOTO 1\\nM30\\n"
print("ready", flush=True)
try:
    while True: {way}
except KeyboardInterrupt:
    print("interrupted")
"""
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        assert child.stdout.readline() == b"ready\n"
        time.sleep(0.3)
        os.kill(child.pid, signal.SIGINT)
        out, errors = child.communicate(timeout=30)
    assert out == b"interrupted\n", errors
