#!/usr/bin/env python3
"""Plugins that others can write or replace are refused before they are loaded (IG-0311).

  plugin_folders_test.py --isogloss PATH --hostile FOLDER [unittest's own options]

The plugin writes a file when it is loaded: where it was refused, there is none.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

OPTIONS = None


class PluginFolders(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.trace = self.path / "loaded"
        self.plugins = self.path / "plugins"
        self.make(self.plugins)
        (self.path / "part.nc").write_text("G21 G90\nG0 X1.\nM30\n")
        (self.path / "hostile.xml").write_text(
            '<Dialect xmlns="urn:isogloss:dialect:1" name="hostile" extends="iso"><Plugins><Plugin name="hostile"/></Plugins>'
            '<Chain><InsertBefore syntax="ProgramXyzSyntax"><BadSyntax/></InsertBefore></Chain></Dialect>')

    def make(self, folder):
        folder.mkdir(parents=True)
        folder.chmod(0o755)
        shutil.copy(pathlib.Path(OPTIONS.hostile) / "hostile.so", folder / "hostile.so")
        (folder / "hostile.so").chmod(0o755)

    def run_it(self, *arguments, plugins=None, **environment):
        clean = {k: v for k, v in os.environ.items() if not k.startswith(("ISOGLOSS_", "HOSTILE_"))}
        self.trace.unlink(missing_ok=True)
        return subprocess.run([OPTIONS.isogloss, *map(str, arguments), "--plugins", str(plugins or self.plugins)],
                              cwd=self.path, capture_output=True, text=True, check=False, timeout=300,
                              env=clean | {"HOSTILE_DEED": "creates", "HOSTILE_WHEN": "load",
                                           "HOSTILE_TARGET": str(self.trace)} | environment)

    def run_program(self, *more, plugins=None, **environment):
        return self.run_it("run", "part.nc", "-d", "hostile.xml", *more, plugins=plugins, **environment)

    def is_refused(self, place, remedy, plugins=None, who="every user"):
        done = self.run_program(plugins=plugins)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(f"is not loaded, because {who} can write {place}: chmod {remedy} {place}", done.stderr)
        self.assertIn("[IG-0311]", done.stderr)
        self.assertFalse(self.trace.exists())
        doctor = self.run_it("doctor", plugins=plugins)
        self.assertEqual(doctor.returncode, 1)
        self.assertEqual(doctor.stdout.count("[IG-0311]"), 1 + doctor.stdout.count("does not link"), doctor.stdout)
        self.assertFalse(self.trace.exists())

    def is_loaded(self, *more, plugins=None, **environment):
        done = self.run_program(*more, plugins=plugins, **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(self.trace.exists())

    def test_a_plugin_of_the_user_is_loaded(self):
        self.is_loaded()

    def test_a_folder_that_all_can_write(self):
        self.plugins.chmod(0o757)
        self.is_refused(self.plugins, "o-w")

    def test_a_file_that_all_can_write(self):
        (self.plugins / "hostile.so").chmod(0o646)
        self.is_refused(self.plugins / "hostile.so", "o-w")

    def test_a_folder_further_up_that_all_can_write(self):
        self.path.chmod(0o777)
        self.is_refused(self.path, "o-w")

    def test_a_sticky_folder_holds_what_belongs_to_the_user(self):
        self.plugins.chmod(0o1777)
        self.is_loaded()

    @unittest.skipUnless(os.geteuid() == 0, "only root gives files away")
    def test_a_sticky_folder_with_a_plugin_of_somebody_else(self):
        self.plugins.chmod(0o1777)
        os.chown(self.plugins / "hostile.so", 65534, 65534)
        self.is_refused(self.plugins, "o-w")

    @unittest.skipUnless(os.geteuid() == 0, "only root gives files away")
    def test_a_group_that_the_user_is_not_in(self):
        for place in (self.plugins, self.plugins / "hostile.so"):
            with self.subTest(place):
                mode = place.stat().st_mode
                place.chmod(0o775)
                os.chown(place, 0, 54321)
                self.is_refused(place, "g-w", who="the group 54321")
                os.chown(place, 0, os.getegid())
                self.is_loaded()
                place.chmod(mode)

    def test_links_to_what_others_can_write(self):
        safe = self.path / "safe"
        safe.mkdir()
        (safe / "hostile.so").symlink_to(self.plugins / "hostile.so")
        self.is_loaded(plugins=safe)
        self.plugins.chmod(0o757)
        self.is_refused(self.plugins, "o-w", plugins=safe)

    def test_links_that_others_can_replace(self):
        open_folder = self.path / "open"
        open_folder.mkdir()
        (open_folder / "hostile.so").symlink_to(self.plugins / "hostile.so")
        open_folder.chmod(0o777)
        self.is_refused(open_folder, "o-w", plugins=open_folder)
        # A chain of links, and a folder that is one.
        safe = self.path / "safe"
        safe.mkdir()
        (safe / "hostile.so").symlink_to("../open/hostile.so")
        self.is_refused(open_folder, "o-w", plugins=safe)
        (open_folder / "folder").symlink_to(self.plugins)
        self.is_refused(open_folder, "o-w", plugins=open_folder / "folder")

    def test_it_can_be_allowed_by_hand(self):
        self.plugins.chmod(0o777)
        self.is_loaded("--any-plugins")
        self.is_loaded(ISOGLOSS_ANY_PLUGINS="1")
        self.assertEqual(self.run_program(ISOGLOSS_ANY_PLUGINS="0").returncode, 2)

    def test_a_folder_is_reported_once(self):
        for name in ("second", "third"):
            shutil.copy(self.plugins / "hostile.so", self.plugins / f"{name}.so")
        self.plugins.chmod(0o777)
        refused = json.loads(self.run_it("doctor", "--json").stdout)["Refused"]
        self.assertEqual([r["Code"] for r in refused], ["IG-0311"])
        self.assertEqual(refused[0]["File"], str(self.plugins))
        self.assertFalse(self.trace.exists())

    def test_no_plugin_behind_the_one_that_has_a_table_is_loaded(self):
        own = pathlib.Path(OPTIONS.isogloss).parent / "plugins"
        for table, is_loaded in (('<MachineKinematics><Axis name="A" Place="table" Order="1"/></MachineKinematics>', False),
                                 ("<NoSuchTable/>", True)):
            with self.subTest(table):
                (self.path / "machine.xml").write_text(f"<Dependencies>{table}</Dependencies>")
                done = self.run_it("run", "part.nc", "-d", "iso", "-m", "machine.xml", "--plugins", own)
                self.assertEqual(done.returncode, 2 if is_loaded else 0, done.stderr)
                self.assertEqual(self.trace.exists(), is_loaded, done.stderr)

    def test_other_commands_do_not_load_it_either(self):
        self.plugins.chmod(0o777)
        for command in (("list", "plugins"), ("lint", "hostile.xml"), ("version",), ("--version",), ("inspect", "BadSyntax"),
                        ("validate", self.plugins / "hostile.so"), ("explain", "part.nc:2", "-d", "hostile.xml")):
            with self.subTest(command):
                self.run_it(*command)
                self.assertFalse(self.trace.exists())


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--hostile", required=True)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(pathlib.Path(OPTIONS.isogloss).resolve())
    unittest.main(argv=[sys.argv[0], *rest])
