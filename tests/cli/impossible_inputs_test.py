# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Single impossible inputs in a sound recording: they are rejected and counted, the rest is fused, exit status 3."""

import json
import os
import subprocess

import program


class ImpossibleInputs(program.ProgramTest):
    def spoil(self, kind):
        subprocess.run([os.environ["SPOILT_DRIVE"], kind, "spoilt.mcap"], cwd=self.folder, check=True)
        done = self.call("run", "spoilt.mcap", "-o", f"{kind}.mcap", "--json")
        return done, json.loads(done.stdout)["inputs"]

    def expect_rejection(self, kind):
        done, inputs = self.spoil(kind)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertGreater(inputs["rejected"], 10)
        self.assertGreater(inputs["used"], 10 * inputs["rejected"] if kind != "time" else 100)
        self.assertIn("spoilt.mcap, cycle at", done.stderr)
        self.assertIn("impossible", done.stderr)
        self.assertTrue((self.folder / f"{kind}.mcap").exists())

    def test_a_sound_drive_rejects_nothing(self):
        done, inputs = self.spoil("nothing")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(inputs["rejected"], 0)

    def test_a_number_that_is_none(self):
        self.expect_rejection("nan")

    def test_a_covariance_that_is_none(self):
        self.expect_rejection("covariance")

    def test_received_before_it_was_measured(self):
        self.expect_rejection("time")


if __name__ == "__main__":
    program.main()
