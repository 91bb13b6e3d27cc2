# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Calls the program that LANEFUSE_BIN names, in an empty folder, and judges what it leaves there."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
SKIPPED = 77  # what ctest takes for a skipped test


def real_data(part):
    """A part of the real data, which may not be there: LANEFUSE_DATA, else ../shared/data beside the source tree."""
    return Path(os.environ.get("LANEFUSE_DATA", SOURCE / ".." / "shared" / "data")) / part


def needs(path):
    """Skips a test class, and says why, where the real data is not there."""
    return unittest.skipUnless(path.exists(), f"real data not found at {path}; set LANEFUSE_DATA to run this test")


class ProgramTest(unittest.TestCase):
    """A test class with a folder of its own, in which the program runs; what one test leaves, the next one finds."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="lanefuse-cli-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)

    @classmethod
    def call(cls, *arguments):
        command = [os.environ["LANEFUSE_BIN"], *map(str, arguments)]
        return subprocess.run(command, cwd=cls.folder, capture_output=True, text=True, timeout=600, check=False)

    @classmethod
    def succeed(cls, *arguments):
        """The result, as JSON, of a call that must succeed and say nothing else on standard output."""
        done = cls.call(*arguments, "--json")
        if done.returncode != 0:
            raise AssertionError(f"{arguments} returned {done.returncode}: {done.stderr}")
        return json.loads(done.stdout)

    @classmethod
    def simulate(cls, name="drive.mcap", km=0.3, *more):
        return cls.succeed("simulate", "--seed", 1, "--km", km, "-o", name, *more)

    @classmethod
    def bytes_of(cls, name):
        return (cls.folder / name).read_bytes()

    def content(self):
        return {str(p.relative_to(self.folder)): p.read_bytes() for p in self.folder.rglob("*") if p.is_file()}

    def refuse(self, code, *arguments, naming=""):
        """Expects exit status `code`, a message with `naming` in it, and the folder as it was."""
        before = self.content()
        done = self.call(*arguments)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stderr}")
        self.assertEqual(done.stdout, "", arguments)
        self.assertIn(naming, done.stderr, arguments)
        self.assertNotEqual(done.stderr.strip(), "", arguments)
        self.assertEqual(self.content(), before, f"{arguments} changed files")


def main():
    """As unittest.main(), but with the exit status SKIPPED where every test was skipped."""
    result = unittest.main(module="__main__", exit=False, verbosity=2).result
    if not result.wasSuccessful():
        sys.exit(1)
    sys.exit(SKIPPED if result.testsRun == len(result.skipped) else 0)
