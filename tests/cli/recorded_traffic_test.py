# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""simulate --commonroad: any vehicle of a recorded scenario as the ego car, and what is refused."""

import re

import program

US101 = program.real_data("commonroad") / "USA_US101-4_1_T-1.xml"


@program.needs(US101)
class RecordedTraffic(program.ProgramTest):
    def replay(self, *more):
        return self.succeed("simulate", "--commonroad", US101, *more)

    def test_the_list_says_who_was_recorded(self):
        vehicles = self.replay("--list")["vehicles"]
        self.assertEqual(len(vehicles), 22)
        self.assertEqual(len({vehicle["id"] for vehicle in vehicles}), 22)
        for vehicle in vehicles:
            self.assertGreaterEqual(vehicle["way_m"], 0)
        self.assertIn("373", self.call("simulate", "--commonroad", US101, "--list").stdout)

    def test_whoever_stayed_longest_is_the_ego_car(self):
        longest = max(vehicle["duration_s"] for vehicle in self.replay("--list")["vehicles"])
        done = self.replay("-o", "longest.mcap")
        self.assertAlmostEqual(done["duration_s"], longest, delta=0.1)
        self.replay("--ego", done["ego"], "-o", "named.mcap")
        self.assertEqual(self.bytes_of("longest.mcap"), self.bytes_of("named.mcap"))

    def test_a_replayed_drive_is_fused_and_judged(self):
        self.replay("--ego", 389, "-o", "drive.mcap")
        self.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        judged = self.succeed("evaluate", "lanes.mcap", "--truth", "exact")
        self.assertEqual(judged["witness"], "radar_and_camera")
        near = next(entry for entry in judged["lanes"]["ego"] if entry["distance_m"] == 20)
        self.assertGreater(near["n"], 0)
        self.assertLess(near["rmse_m"], 3.5)

    def test_what_cannot_be_is_refused(self):
        self.refuse(3, "simulate", "--commonroad", US101, "--ego", 1, "-o", "x.mcap", naming="no recorded vehicle 1")
        self.refuse(2, "simulate", "--commonroad", US101, naming="--output")
        self.refuse(2, "simulate", "--commonroad", US101, "--km", 1, "-o", "x.mcap", naming="--km")
        self.refuse(2, "simulate", "--ego", 389, "-o", "x.mcap", naming="--commonroad")
        vehicle = re.compile("<dynamicObstacle.*?</dynamicObstacle>", re.DOTALL)
        (self.folder / "lanes_only.xml").write_text(vehicle.sub("", US101.read_text()))
        self.refuse(3, "simulate", "--commonroad", "lanes_only.xml", "-o", "x.mcap", naming="no recorded vehicle")
        self.refuse(3, "simulate", "--commonroad", "absent.xml", "-o", "x.mcap", naming="absent.xml")


if __name__ == "__main__":
    program.main()
