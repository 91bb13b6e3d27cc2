# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""The lessons of examples/, run as their reader would run them."""

import os
import re
import subprocess
import unittest
from pathlib import Path

import program


def lesson(name):
    """Lessons are built beside the program."""
    return Path(os.environ["LANEFUSE_BIN"]).with_name(f"example_{name}")


@unittest.skipUnless(lesson("01_fuse_a_drive").exists(), "built without examples (LANEFUSE_EXAMPLES)")
class Examples(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate(km=0.5)
        cls.simulate("camera.mcap", 0.5, "--no-objects", "--no-high-resolution-camera")

    def run_lesson(self, name, *arguments):
        return subprocess.run([lesson(name), *arguments], cwd=self.folder, capture_output=True, text=True, timeout=600,
                              check=False)

    def test_fuse_a_drive_prints_the_ego_lane_each_second(self):
        done = self.run_lesson("01_fuse_a_drive", "drive.mcap")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual([float(line.split()[0]) for line in lines], [float(second) for second in range(len(lines))])
        widths = [float(width) for width in re.findall(r"lane (\S+) m wide", done.stdout)]
        self.assertGreaterEqual(len(widths), len(lines) - 2)
        for width in widths:
            self.assertTrue(3 < width < 4.2, width)

    def test_a_source_of_ones_own_adds_the_lanes_it_knows(self):
        done = self.run_lesson("02_own_source", "camera.mcap")
        self.assertEqual(done.returncode, 0, done.stderr)
        without, with_it = map(float, re.findall(r"\d+\.\d+", done.stdout))
        self.assertLess(without, 1.5)
        self.assertGreater(with_it, 2.5)

    def test_a_pose_graph_disbelieves_the_false_loop(self):
        done = self.run_lesson("03_pose_graph")
        self.assertEqual(done.returncode, 0, done.stderr)
        switches = [float(value) for value in re.findall(r"loop .*: (\S+)", done.stdout)]
        self.assertEqual(len(switches), 5)
        self.assertGreater(min(switches[:4]), 0.8)
        self.assertLess(switches[4], 0.05)

    def test_a_file_that_is_no_drive_is_named(self):
        for name in ("01_fuse_a_drive", "02_own_source"):
            done = self.run_lesson(name, "nowhere.mcap")
            self.assertEqual(done.returncode, 3)
            self.assertIn("nowhere.mcap", done.stderr)


if __name__ == "__main__":
    program.main()
