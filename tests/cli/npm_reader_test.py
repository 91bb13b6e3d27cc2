# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""The MCAP project's own reader opens what the program writes, with every CRC checked."""

import json
import shutil
import subprocess
import unittest

import program

CHECKER = program.SOURCE / "tests" / "npm"


@unittest.skipUnless((CHECKER / "node_modules").is_dir(), "no tests/npm/node_modules; 'npm ci' in tests/npm makes it")
@unittest.skipUnless(shutil.which("node"), "no node")
class NpmReader(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate()
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.succeed("strip", "drive.mcap", "-o", "stripped.mcap")

    def read(self, name):
        done = subprocess.run(["node", str(CHECKER / "check_mcap.mjs"), str(self.folder / name)],
                              capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_a_simulated_drive(self):
        topics = set(self.read("drive.mcap")["topics"])
        self.assertLessEqual({"/in/calibration", "/in/vehicle_motion", "/in/serial_camera", "/in/high_resolution_camera",
                              "/in/objects", "/truth/road", "/truth/frame"}, topics)

    def test_a_stripped_drive(self):
        self.assertFalse([topic for topic in self.read("stripped.mcap")["topics"] if topic.startswith("/truth")])

    def test_lanes(self):
        found = self.read("lanes.mcap")
        self.assertLessEqual({"/out/lanes", "/out/fused_features", "/out/switches"}, set(found["topics"]))
        self.assertIn("lanefuse.v1.LaneEstimate", found["schemas"])
        self.assertIn("lanefuse", found["metadata"])


if __name__ == "__main__":
    program.main()
