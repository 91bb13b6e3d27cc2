# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Lanes are judged by exact and by surveyed truth, with and without the serial camera beside them."""

import os
import subprocess

import program

DISTANCES = [10.0 * i for i in range(13)]


class Evaluate(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate(km=0.4)
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.exact = cls.judge("exact")

    @classmethod
    def judge(cls, truth, *more):
        return cls.succeed("evaluate", "lanes.mcap", "--truth", truth, *more, "--force")

    def test_exact_truth_gives_every_figure(self):
        for key in ("wrong_lane_rate", "false_boundaries_per_frame", "false_lanes_per_frame", "resets", "nees"):
            self.assertIsNotNone(self.exact[key], key)
        self.assertNotIn("surveyed", self.exact)
        self.assertNotIn("serial_camera", self.exact)
        for entry in self.exact["consistency"]["ego"]:
            self.assertLessEqual(entry["within_68"], entry["within_95"])
            self.assertLessEqual(entry["within_95"], entry["within_99"])

    def test_every_judged_cycle_is_in_one_range_of_traffic(self):
        for condition in ("by_vehicles_ahead", "by_gap_ahead"):
            ranges = self.exact[condition]
            self.assertEqual(sum(r["cycles"] for r in ranges), self.exact["cycles_with_truth"])
            self.assertEqual(sum(r["ego"][6]["n"] for r in ranges), self.exact["lanes"]["ego"][6]["n"])
            self.assertIsNone(ranges[-1]["to"])

    def test_surveyed_truth_has_the_presets_errors_and_a_seed(self):
        surveyed = self.judge("surveyed")
        self.assertEqual(surveyed["truth"], "surveyed")
        for key, value in {"ego_m": 0.09, "adjacent_m": 0.19, "heading_deg": 0.12, "seed": 1}.items():
            self.assertAlmostEqual(surveyed["surveyed"][key], value)
        self.assertNotEqual(surveyed["lanes"], self.exact["lanes"])
        self.assertEqual(surveyed["wrong_lane_rate"], self.exact["wrong_lane_rate"])
        self.assertEqual(surveyed, self.judge("surveyed", "--truth-seed", 1))
        self.assertNotEqual(surveyed["lanes"], self.judge("surveyed", "--truth-seed", 2)["lanes"])

    def test_the_serial_camera_is_judged_beside_and_changes_nothing(self):
        judged = self.judge("exact", "--baseline", "serial-camera")
        camera = judged.pop("serial_camera")
        self.assertEqual(judged, self.exact)
        self.assertEqual([entry["distance_m"] for entry in camera["extrapolated"]], DISTANCES)
        self.assertGreater(camera["extrapolated"][12]["availability"], 0.5)
        self.assertEqual(camera["within_range"][12]["n"], 0)
        self.assertIn("Beside the serial camera alone", self.bytes_of("report.html").decode())

    def test_the_table_is_table_one(self):
        printed = self.call("evaluate", "lanes.mcap", "--truth", "surveyed", "--force")
        self.assertEqual(printed.returncode, 0, printed.stderr)
        rows = [line for line in printed.stdout.split("stated:")[0].splitlines() if " m |" in line]
        self.assertEqual([int(row.split(" m |")[0]) for row in rows], [0, 20, 40, 60, 80, 100, 120])
        for row, (ego, adjacent) in zip(rows, ((".10", ".21"), (".11", ".21"), (".18", ".27"), (".28", ".37"),
                                               (".42", ".50"), (".55", ".66"), (".64", ".99"))):
            columns = [column.split() for column in row.split("|")]
            self.assertEqual(columns[2][0], "0" + ego)
            self.assertEqual(columns[4][0], "0" + adjacent)
            self.assertEqual(len(columns[1]), 6)

    def make_map(self, name, metres):
        subprocess.run([os.environ["DRIVE_MAP"], "drive.mcap", str(metres), name], cwd=self.folder, check=True)

    def test_a_map_of_the_road_judges_as_the_road_does(self):
        self.make_map("road.xodr", 0)
        judged = self.succeed("evaluate", "lanes.mcap", "--map", "road.xodr", "--force")
        self.assertEqual(judged["truth"], "map")
        self.assertGreater(judged["cycles_with_truth"], 0.95 * self.exact["cycles_with_truth"])
        for lane in ("ego", "adjacent"):
            for ours, exact in zip(judged["lanes"][lane][:7], self.exact["lanes"][lane][:7]):
                self.assertAlmostEqual(ours["rmse_m"], exact["rmse_m"], delta=0.02)

    def test_a_map_that_is_off_shows_in_every_deviation(self):
        self.make_map("off.geojson", 0.5)
        judged = self.succeed("evaluate", "lanes.mcap", "--map", "off.geojson", "--force")
        self.assertGreater(abs(judged["lanes"]["ego"][2]["mean_m"] - self.exact["lanes"]["ego"][2]["mean_m"]), 0.2)

    def test_a_map_of_elsewhere_is_refused(self):
        self.make_map("elsewhere.xodr", 5000)
        self.refuse(3, "evaluate", "lanes.mcap", "--map", "elsewhere.xodr", "-o", "elsewhere.html",
                    naming="elsewhere.xodr: the car is in none of its lanes")

    def test_either_truth_or_map_is_named(self):
        self.refuse(2, "evaluate", "lanes.mcap", naming="--truth or --map")
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "exact", "--map", "road.xodr", naming="--map")
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "ego-path", "--baseline", "serial-camera",
                    naming="--baseline")

    def test_a_drive_without_serial_camera_has_no_such_baseline(self):
        self.simulate("blind.mcap", 0.1, "--no-serial-camera")
        self.succeed("run", "blind.mcap", "-o", "blind_lanes.mcap")
        self.refuse(3, "evaluate", "blind_lanes.mcap", "--truth", "exact", "--baseline", "serial-camera", "-o",
                    "blind.html", naming="has no serial camera")

    def test_wrong_names_are_wrong_use(self):
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "perfect", naming="--truth")
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "exact", "--baseline", "luck", naming="--baseline")
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "surveyed", "--truth-seed", "-1", naming="--truth-seed")


if __name__ == "__main__":
    program.main()
