"""What the tests of plugins share: their options, a folder, and the command."""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

OPTIONS = argparse.Namespace()


class PluginTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def run_it(self, *arguments):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], capture_output=True, text=True,
                              errors="replace", timeout=300, check=False, cwd=self.path, env=environment)
        self.assertGreaterEqual(done.returncode, 0, f"killed by a signal: {arguments}\n{done.stderr}")
        return done

    def doctor(self, folder):
        return self.run_it("doctor", "--plugins", folder)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--plugins", required=True, type=pathlib.Path)
    _, rest = parser.parse_known_args(namespace=OPTIONS)
    unittest.main(argv=[sys.argv[0], *rest])
