# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""The same input gives the same bytes, and the truth is no input."""

import program


class SameBytes(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate()
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.succeed("run", "drive.mcap", "--estimator", "road", "-o", "road.mcap")

    def test_a_seed_is_a_drive(self):
        self.simulate("twin.mcap")
        self.assertEqual(self.bytes_of("twin.mcap"), self.bytes_of("drive.mcap"))
        self.succeed("simulate", "--seed", 2, "--km", 0.3, "-o", "other.mcap")
        self.assertNotEqual(self.bytes_of("other.mcap"), self.bytes_of("drive.mcap"))

    def test_a_drive_is_its_lanes(self):
        self.succeed("run", "drive.mcap", "-o", "again.mcap")
        self.assertEqual(self.bytes_of("again.mcap"), self.bytes_of("lanes.mcap"))
        self.succeed("run", "drive.mcap", "--estimator", "road", "-o", "again_road.mcap")
        self.assertEqual(self.bytes_of("again_road.mcap"), self.bytes_of("road.mcap"))
        self.assertNotEqual(self.bytes_of("road.mcap"), self.bytes_of("lanes.mcap"))

    def test_without_truth_the_lanes_are_the_same(self):
        self.succeed("strip", "drive.mcap", "-o", "stripped.mcap")
        self.assertLess(len(self.bytes_of("stripped.mcap")), len(self.bytes_of("drive.mcap")))
        self.assertNotIn(b"/truth/", self.bytes_of("stripped.mcap"))
        self.succeed("run", "stripped.mcap", "-o", "blind.mcap")
        self.assertEqual(self.bytes_of("blind.mcap"), self.bytes_of("lanes.mcap"))
        self.succeed("run", "stripped.mcap", "--estimator", "road", "-o", "blind_road.mcap")
        self.assertEqual(self.bytes_of("blind_road.mcap"), self.bytes_of("road.mcap"))

    def test_report_and_picture_are_the_same(self):
        for name in ("a", "b"):
            self.succeed("evaluate", "lanes.mcap", "--truth", "exact", "-o", f"{name}.html")
            self.succeed("plot", "lanes.mcap", "--at", 3, "-o", f"{name}.svg")
        self.assertEqual(self.bytes_of("a.html"), self.bytes_of("b.html"))
        self.assertEqual(self.bytes_of("a.svg"), self.bytes_of("b.svg"))


if __name__ == "__main__":
    program.main()
