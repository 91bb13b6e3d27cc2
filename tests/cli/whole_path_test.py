# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A drive becomes lanes, a report and a picture, and every step's JSON keeps its promise."""

import program

DISTANCES = [10.0 * i for i in range(13)]
ENTRY = {"distance_m", "mean_m", "sigma_m", "rmse_m", "p95_m", "availability", "n"}


class WholePath(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulated = cls.simulate(km=0.5)
        cls.ran = cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.judged = cls.succeed("evaluate", "lanes.mcap", "--truth", "exact")

    def test_simulate_says_what_it_wrote(self):
        self.assertEqual(self.simulated["output"], "drive.mcap")
        self.assertGreater(self.simulated["measurements"], 1000)
        self.assertTrue((self.folder / "drive.mcap").is_file())

    def test_run_keeps_its_promise(self):
        run = self.ran
        self.assertLessEqual({"cycles", "duration_s", "cycle_ms", "stage_ms", "inputs", "graph"}, set(run))
        self.assertEqual(set(run["cycle_ms"]), {"p50", "p99", "max"})
        self.assertEqual(set(run["stage_ms"]), {"sources", "association", "solve", "lane_model"})
        self.assertEqual(set(run["inputs"]), {"used", "rejected", "dropped"})
        self.assertEqual(set(run["graph"]), {"poses", "features", "edges"})

    def test_run_counts_what_happened(self):
        run = self.ran
        self.assertAlmostEqual(run["cycles"], 12.5 * run["duration_s"], delta=2)
        self.assertLessEqual(run["cycle_ms"]["p50"], run["cycle_ms"]["p99"])
        self.assertLessEqual(run["cycle_ms"]["p99"], run["cycle_ms"]["max"])
        self.assertEqual(run["inputs"]["rejected"], 0)
        for count in [run["inputs"]["used"], *run["graph"].values()]:
            self.assertGreater(count, 0)

    def test_evaluate_scores_ego_and_adjacent_lanes(self):
        self.assertEqual(set(self.judged["lanes"]), {"ego", "adjacent"})
        for role in self.judged["lanes"].values():
            self.assertEqual([entry["distance_m"] for entry in role], DISTANCES)
            for entry in role:
                self.assertEqual(set(entry), ENTRY)
        self.assertNotIn("baselines", self.judged)

    def test_lanes_of_a_short_drive_are_good(self):
        ego = self.judged["lanes"]["ego"]
        self.assertLess(ego[6]["rmse_m"], 0.5)
        self.assertGreater(ego[6]["availability"], 0.9)

    def test_evaluate_writes_a_report_of_its_own(self):
        report = self.bytes_of("report.html").decode()
        self.assertTrue(report.lstrip().lower().startswith("<!doctype html>"))
        self.assertIn("<svg", report)

    def test_a_kept_report_is_named_on_standard_error(self):
        before = self.bytes_of("report.html")
        again = self.call("evaluate", "lanes.mcap", "--truth", "exact")
        self.assertEqual(again.returncode, 0)
        self.assertIn("report.html is there already", again.stderr)
        self.assertEqual(self.bytes_of("report.html"), before)

    def test_the_driven_path_judges_simulated_drives_too(self):
        judged = self.succeed("evaluate", "lanes.mcap", "--truth", "ego-path", "--report", "path.html")
        for baseline in ("straight", "arc"):
            entries = judged["baselines"][baseline]
            self.assertEqual([entry["distance_m"] for entry in entries], DISTANCES)
            self.assertEqual(set(entries[0]), ENTRY)

    def test_plot_draws_the_moment_asked_for(self):
        drawn = self.succeed("plot", "lanes.mcap", "--at", 5, "-o", "frame.svg")
        self.assertGreaterEqual(drawn["at_s"], 5)
        self.assertLess(drawn["at_s"], 5.1)
        self.assertIn(b"<svg", self.bytes_of("frame.svg")[:400])

    def test_plot_draws_all_tracks_over_time(self):
        drawn = self.succeed("plot", "lanes.mcap", "--tracks", "-o", "tracks.svg")
        self.assertGreater(drawn["duration_s"], 5)
        self.assertIn(b"to the left [m]", self.bytes_of("tracks.svg"))

    def test_a_moved_folder_keeps_lanes_and_truth_together(self):
        moved = self.folder / "moved"
        moved.mkdir()
        for name in ("drive.mcap", "lanes.mcap", "lanes.mcap.run.json"):
            (moved / name).write_bytes(self.bytes_of(name))
        judged = self.succeed("evaluate", "moved/lanes.mcap", "--truth", "exact")
        self.assertEqual(judged, self.judged)

    def test_nothing_is_left_half_written(self):
        self.assertEqual(list(self.folder.rglob("*.part")), [])


if __name__ == "__main__":
    program.main()
