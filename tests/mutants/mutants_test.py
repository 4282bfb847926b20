#!/usr/bin/env python3
"""The tool itself: it finds the places of a source, and one compiled program behaves as each mutant.

  mutants_test.py [unittest's own options]; exit status 77 where libclang is not installed
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    from clang import cindex
    cindex.Index.create()
except Exception:  # the module is missing, or its library
    print("skipped: libclang-14-dev and python3-clang-14 are not installed")
    sys.exit(77)

import find_mutants
import mutants
import schemata

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = """#include <algorithm>
#include <cstdio>
#include <cstdlib>
constexpr int twice(int n) { return n * 2; }
template <typename T> T half(T n) { return n / 2; }
const int most = 9;
int count(int from, int to) {
  int sums[1] = {0};
  int& sum = sums[0];
  for (int i = from; i < to; ++i) sum += i;
  if (from == 7 && to > 3) sum = -sum;
  return std::max(sum, from);  // "a < b" is no code here
}
int main(int, char** words) {
  std::printf("%d", count(std::atoi(words[1]), std::atoi(words[2])));
  return half(twice(0)) + most - 9;
}
"""


class Tool(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="isogloss-mutants-")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        (self.path / "sum.cpp").write_text(SOURCE)
        self.finder = find_mutants.Finder(self.path, ["sum.cpp"])
        self.finder.read(str(self.path / "sum.cpp"), ["-std=c++20"])
        self.changes = {m.change(SOURCE): n for n, m in enumerate(self.finder.mutants(), 1)}

    def build(self):
        (self.path / "all.cpp").write_text(schemata.rendered(SOURCE, list(enumerate(self.finder.mutants(), 1))))
        subprocess.run(["c++", "-std=c++20", "-w", "-include", HERE / "mutant.hpp", "-o", self.path / "all", self.path / "all.cpp"],
                       check=True)

    def run_it(self, *words, mutant=0, reached=None):
        more = {"ISOGLOSS_MUTANT_REACHED": str(reached)} if reached else {}
        return subprocess.run([self.path / "all", *map(str, words)], capture_output=True, text=True, check=False,
                              env={"ISOGLOSS_MUTANT": str(mutant), **more}).stdout

    def test_each_operator_finds_its_places(self):
        for change in ("i < to → i <= to", "i < to → i >= to", "from == 7 → from != 7", "7 → 8", "7 → 0",
                       "from == 7 && to > 3 → from == 7 || to > 3", "from == 7 && to > 3 → !(from == 7 && to > 3)",
                       "sum += i → sum -= i", "sum += i → (left out)", "-sum → sum", "sum = -sum → (left out)",
                       "std::max(sum, from) → std::min(sum, from)"):
            self.assertIn(change, self.changes)

    def test_what_is_a_constant_for_the_compiler_is_left_out_and_counted(self):
        self.assertNotIn("n * 2 → n / 2", self.changes)
        self.assertNotIn("9 → 10", {c for c, n in self.changes.items() if self.finder.mutants()[n - 1].start < SOURCE.index("int count")})
        bound = SOURCE.index("sums[1]") + len("sums[")
        self.assertEqual([m for m in self.finder.mutants() if m.start == bound], [])
        self.assertGreaterEqual(self.finder.left_out["a constexpr function"], 2)
        self.assertGreaterEqual(self.finder.left_out["a template"], 1)
        self.assertGreaterEqual(self.finder.left_out["an initialiser of a constant or a member"], 1)

    def test_the_environment_chooses_one_of_all(self):
        self.build()
        self.assertEqual(self.run_it(1, 4), "6")
        for change, expected in (("i < to → i <= to", "10"), ("sum += i → sum -= i", "1"), ("sum += i → (left out)", "1"),
                                 ("from == 7 → from != 7", "1"), ("std::max(sum, from) → std::min(sum, from)", "1")):
            self.assertEqual(self.run_it(1, 4, mutant=self.changes[change]), expected, change)

    def test_a_run_tells_what_it_reaches(self):
        self.build()
        reached = self.path / "reached"
        reached.write_bytes(bytes(len(self.changes) + 1))
        self.run_it(1, 4, reached=reached)
        bits = reached.read_bytes()
        self.assertEqual(bits[self.changes["i < to → i <= to"]], 1)
        self.assertEqual(bits[self.changes["-sum → sum"]], 0)

    def test_lines_stay_where_they_are(self):
        text = schemata.rendered(SOURCE, list(enumerate(self.finder.mutants(), 1)))
        self.assertEqual(text.count("\n"), SOURCE.count("\n"))

    def test_an_answer_is_read_back_as_it_was_written(self):
        cells = ("a.cpp", "if (a || b) return;", "a || b → a && b")
        answer = mutants.row(cells)[:-1] + "| because |"
        self.assertEqual(mutants.read_answers(answer), {cells: "because"})


if __name__ == "__main__":
    unittest.main()
