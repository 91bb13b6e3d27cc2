#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Scenarios, maps to drive on and maps to write, as `lanefuse simulate` promises them."""

import program


class Scenarios(program.ProgramTest):
    def test_are_listed_by_name(self):
        listed = self.succeed("simulate", "--list-scenarios")["scenarios"]
        names = [scenario["name"] for scenario in listed]
        self.assertIn("nominal", names)
        self.assertIn("right-markings-missing", names)
        self.assertEqual(names, sorted(names))
        self.assertTrue(all(scenario["about"] for scenario in listed))

    def test_the_nominal_one_is_the_default(self):
        self.simulate("default.mcap", 0.2)
        self.simulate("named.mcap", 0.2, "--scenario", "nominal")
        self.assertEqual(self.bytes_of("default.mcap"), self.bytes_of("named.mcap"))

    def test_a_file_makes_a_drive(self):
        (self.folder / "own.yaml").write_text("version: 1\ntraffic: {vehicles_per_km_lane: 0}\n")
        self.assertEqual(self.simulate("own.mcap", 0.2, "--scenario", "own.yaml")["scenario"], "own")

    def test_a_bad_one_is_refused_by_line_and_key(self):
        (self.folder / "bad.yaml").write_text("version: 1\nego:\n  speed: 3\n")
        self.refuse(2, "simulate", "--scenario", "bad.yaml", "-o", "x.mcap", naming="bad.yaml, line 3, ego.speed")
        self.refuse(2, "simulate", "--scenario", "no-such", "-o", "x.mcap", naming="exit-ramp")
        self.refuse(2, "simulate", "--scenario", "nowhere.yaml", "-o", "x.mcap", naming="nowhere.yaml")
        self.refuse(2, "simulate", "--scenario", "sharp-bends", "--road", "gentle", "-o", "x.mcap",
                    naming="has a road of its own")


class Maps(program.ProgramTest):
    def test_a_written_map_can_be_driven_on(self):
        self.simulate("drive.mcap", 0.3, "--write-map", "road.xodr")
        self.simulate("again.mcap", 0.3, "--map", "road.xodr")
        self.refuse(2, "simulate", "--map", "road.xodr", "--km", "50", "-o", "x.mcap", naming="choose up to")
        self.refuse(2, "simulate", "--map", "road.xodr", "--road", "gentle", "-o", "x.mcap", naming="--road")

    def test_bad_ones_are_refused(self):
        (self.folder / "bad.xodr").write_text("<OpenDRIVE/>")
        self.refuse(3, "simulate", "--map", "bad.xodr", "-o", "x.mcap", naming="bad.xodr")
        self.refuse(2, "simulate", "--map", "road.txt", "-o", "x.mcap", naming="road.txt")
        self.refuse(2, "simulate", "--write-map", "road.txt", "-o", "x.mcap", naming="road.txt")


if __name__ == "__main__":
    program.main()
