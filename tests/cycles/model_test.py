#!/usr/bin/env python3
"""Do the models do what the worked examples say, and does the comparison find the differences that it should?"""
import copy
import itertools
import unittest
from fractions import Fraction

import events
import worked_lists
from machine import Machine, Uncertain
from random_programs import RandomProgram
from reference import Reference

START = worked_lists.START


def without_lines(steps):
    result = []
    for step in steps:
        step = copy.copy(step)
        step.line, step.speed = 0, None
        result.append(step)
    return result


def steps(model, program):
    """The linear moves of a program, as text, without those of the start."""
    return [str(e) for e in model.run(START + program)[1:]]


class WorkedLists(unittest.TestCase):
    def test_every_list(self):
        for example in worked_lists.read():
            with self.subTest(example.title):
                machine = Machine(example.settings)
                happened = events.settled(events.moves_only(machine.run(example.program)))
                happened = without_lines(e for e in happened if e.line > 2)
                expected = example.events
                if machine.loose_lines:
                    happened, expected = ([e for e in side if e.kind != "spindle"] for side in (happened, expected))
                for number, (a, b) in enumerate(itertools.zip_longest(happened, expected), 1):
                    self.assertIsNone(events.differ(a, b), f"step {number}: {a}, not {b}")


class OfTheMachine(unittest.TestCase):
    def test_group_01_and_g80_forget_the_data(self):
        for cancel in ("G80", "G00 X1."):
            with self.assertRaises(Uncertain):
                Machine().run(START + f"G81 X1. Z-5. R2. F100\n{cancel}\nG81 X5.\n")

    def test_bare_words_after_g80_move_by_the_code_of_before(self):
        self.assertEqual(steps(Machine(), "G01 X1. F50\nG81 Z-5. R2.\nG80\nX7.")[-1], "feed X7 Y0 Z50 F50")

    def test_q_p_of_a_block_that_does_not_drill_are_lost(self):
        happened = steps(Machine(), "G82 X1. Z-5. R2. P500 F100\nP900\nX2.")
        self.assertEqual([s for s in happened if "dwell" in s], ["dwell 0.5", "dwell 0.5"])

    def test_what_does_not_drill(self):
        for block in ("M08", "F120", "S500", "T5", "G04 X1.5", "G98", "G90"):
            machine = Machine()
            machine.run(START + f"G81 X1. Z-5. R2. F100\n{block}\n")
            self.assertEqual(machine.drilling_lines, {3}, block)

    def test_exact_multiples_have_no_sliver(self):
        happened = steps(Machine(), "G99 G83 Z-0.3 R0. Q0.1 F100")
        self.assertEqual(sum("feed" in s for s in happened), 3)

    def test_k0_keeps_the_levels(self):
        self.assertEqual(steps(Machine(), "G99 G81 X1. Z-5. R2. F100 K0\nX3.")[2], "feed X3 Y0 Z-5 F100")

    def test_planes_and_shift(self):
        self.assertIn("rapid X0 Y-8 Z4", steps(Machine(), "G18 G00 X0. Y9. Z0.\nG76 Z3. Y-8. R2. Q1. F100"))
        self.assertIn("rapid X-8 Y4 Z50", steps(Machine(), "G19 G00 X9.\nG76 Y3. X-8. R2. Q1. F100"))


class OfTheReferenceBehaviour(unittest.TestCase):
    def test_previous_level(self):
        happened = steps(Reference(), "G99 G81 X1. Z-5. R2. F100\nG98 X2.")
        self.assertEqual(happened[-1], "rapid X2 Y0 Z2")

    def test_g83_and_g73(self):
        self.assertEqual(steps(Reference(), "G98 G83 Z-20. R2. Q8. F100"),
                         ["rapid X0 Y0 Z50", "rapid X0 Y0 Z2", "feed X0 Y0 Z-6 F100", "rapid X0 Y0 Z2",
                          "rapid X0 Y0 Z-1", "feed X0 Y0 Z-14 F100", "rapid X0 Y0 Z2", "rapid X0 Y0 Z-9",
                          "feed X0 Y0 Z-20 F100", "rapid X0 Y0 Z2", "rapid X0 Y0 Z50"])
        self.assertEqual(steps(Reference(), "G98 G73 Z-20. R2. Q8. F100"),
                         ["rapid X0 Y0 Z50", "rapid X0 Y0 Z2", "feed X0 Y0 Z-6 F100", "rapid X0 Y0 Z-1",
                          "feed X0 Y0 Z-14 F100", "rapid X0 Y0 Z-9", "feed X0 Y0 Z-20 F100", "rapid X0 Y0 Z-15",
                          "rapid X0 Y0 Z50"])

    def test_g87_cuts_from_z_up_to_r(self):
        self.assertEqual(steps(Reference(), "G98 G87 X30. Y20. Z-25. R-5. Q4. F60"),
                         ["orient", "rapid X34 Y20 Z50", "rapid X34 Y20 Z-25", "rapid X30 Y20 Z-25",
                          "spindle CW S0", "feed X30 Y20 Z-5 F60", "orient", "rapid X34 Y20 Z-5", "rapid X34 Y20 Z50",
                          "rapid X30 Y20 Z50", "spindle CW S0"])

    def test_feed_out_to_the_final_level(self):
        self.assertEqual(steps(Reference(), "G98 G85 Z-5. R2. F60")[-1], "feed X0 Y0 Z50 F60")
        self.assertEqual(steps(Reference(), "G98 G84 Z-5. R2. F60")[-3:],
                         ["spindle CCW S0", "feed X0 Y0 Z50 F60", "spindle CW S0"])

    def test_seconds(self):
        self.assertIn("dwell 0.5", steps(Reference(), "G82 Z-5. R2. P0.5 F60"))


class RandomPrograms(unittest.TestCase):
    def test_are_repeatable_certain_and_drill(self):
        for model in (Machine, Reference):
            drilled, seen = 0, set()
            for seed in range(30):
                program = RandomProgram(seed, model)
                self.assertEqual(program.text, RandomProgram(seed, model).text)
                again = model()
                again.run(program.text)
                drilled += len(again.drilling_lines)
                seen |= {code for code in model.CYCLES if f"G{code}" in program.text}
            self.assertGreater(drilled, 300)
            self.assertEqual(seen, set(model.CYCLES))


class Comparison(unittest.TestCase):
    def test_every_planted_error_is_seen(self):
        event = events.Event("feed", 7, (1.0, 2.0, 3.0), 100.0)
        self.assertIsNone(events.differ(event, events.Event("feed", 7, (Fraction(1), Fraction(2), Fraction(3)), 100)))
        for name, value in (("kind", "rapid"), ("line", 8), ("end", (1.0, 2.0, 3.00001)), ("value", 100.001),
                            ("value", None), ("by_hand", True)):
            other = copy.copy(event)
            setattr(other, name, value)
            self.assertIsNotNone(events.differ(event, other), name)
        self.assertIsNotNone(events.differ(event, None))

    def test_what_repeats_the_spindle_is_no_event(self):
        turns = ["STOP", "CW", "CW", "STOP", "CW"]
        rows = [events.Event("spindle", line, value=value, speed=500) for line, value in enumerate(turns)]
        self.assertEqual([e.line for e in events.settled(rows)], [1, 3, 4])


if __name__ == "__main__":
    unittest.main()
