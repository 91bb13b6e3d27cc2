# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Many short drives become a file of results, which goes on where it was broken off, and tables that can be trusted."""

import json
import re
import subprocess

import program

HEAD = ["scene", "road", "seed", "km", "variant", "estimator", "truth", "version", "preset", "scene_hash",
        "configuration_hash"]
TIMES = {"cycle_ms", "stage_s", "wall_s"}


class BenchmarkTest(program.ProgramTest):
    @classmethod
    def drive(cls, output, *arguments):
        return cls.succeed("benchmark", "--km", 0.3, "--road", "gentle", *arguments, "-o", output)

    def lines(self, name):
        return [json.loads(line) for line in self.bytes_of(name).decode().splitlines()]


class Drives(BenchmarkTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.said = cls.drive("results.jsonl", "--seeds", "1-3", "--no-times")

    def test_there_is_a_line_a_drive(self):
        self.assertEqual(self.said, {"output": "results.jsonl", "drives": 3, "driven": 3, "there_already": 0})
        lines = self.lines("results.jsonl")
        self.assertEqual([line["seed"] for line in lines], [1, 2, 3])
        for line in lines:
            self.assertEqual(list(line)[:len(HEAD)], HEAD)
            self.assertLessEqual({"lanes", "false_lanes_per_frame", "wrong_lane_rate", "nees", "inputs"}, set(line))
            self.assertFalse(TIMES & set(line))

    def test_a_line_says_what_evaluate_says(self):
        self.simulate()
        self.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        judged = self.succeed("evaluate", "lanes.mcap", "--truth", "exact")
        line = self.lines("results.jsonl")[0]
        self.assertEqual(line["preset"], judged["preset_hash"])
        for role in ("ego", "adjacent"):
            for ours, theirs in zip(line["lanes"][role], judged["lanes"][role], strict=True):
                self.assertEqual(ours["n"], theirs["n"])
                self.assertAlmostEqual(ours["rmse_m"], theirs["rmse_m"], places=9)

    def test_the_number_of_jobs_changes_nothing(self):
        for jobs in (1, 3):
            self.drive(f"jobs{jobs}.jsonl", "--seeds", "1-3", "--no-times", "--jobs", jobs)
            self.assertEqual(self.bytes_of(f"jobs{jobs}.jsonl"), self.bytes_of("results.jsonl"))

    def test_it_goes_on_behind_a_cut_line(self):
        whole = self.bytes_of("results.jsonl")
        (self.folder / "cut.jsonl").write_bytes(whole[:whole.index(b"\n") + 200])
        done = self.call("benchmark", "--km", 0.3, "--road", "gentle", "--seeds", "1-3", "--no-times", "-o", "cut.jsonl")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("cut off", done.stderr)
        self.assertIn("2 of 3 drives driven, 1 there already", done.stdout)
        self.assertEqual(self.bytes_of("cut.jsonl"), whole)

    def test_slices_merge_to_the_whole(self):
        for i in (1, 2):
            said = self.drive(f"slice{i}.jsonl", "--seeds", "1-3", "--no-times", "--job", f"{i}/2")
            self.assertEqual(said["driven"], 3 - i)
        merged = self.succeed("benchmark", "merge", "slice2.jsonl", "slice1.jsonl", "-o", "merged.jsonl")
        self.assertEqual(merged, {"output": "merged.jsonl", "files": 2, "lines": 3, "drives": 3})
        self.assertEqual(self.bytes_of("merged.jsonl"), self.bytes_of("results.jsonl"))

    def test_other_settings_are_another_file(self):
        command = ["benchmark", "--km", 0.3, "--road", "gentle", "--seeds", 1, "--set", "fusion.width_edges=false"]
        self.refuse(2, *command, "-o", "results.jsonl", naming="configuration")
        self.succeed(*command, "--no-times", "-o", "other.jsonl")
        self.refuse(3, "benchmark", "merge", "results.jsonl", "other.jsonl", "-o", "x.jsonl", naming="configuration")

    def test_another_program_s_file_is_kept(self):
        (self.folder / "poem.txt").write_text("no end of line")
        self.refuse(3, "benchmark", "--km", 0.3, "-o", "poem.txt", naming="poem.txt:1")

    def test_force_starts_anew(self):
        (self.folder / "anew.jsonl").write_text("rubbish\n")
        self.drive("anew.jsonl", "--seeds", "1", "--force", "--no-times")
        self.assertEqual(self.bytes_of("anew.jsonl").splitlines(), self.bytes_of("results.jsonl").splitlines()[:1])

    def test_a_table_has_intervals_and_the_paper(self):
        table = self.succeed("benchmark", "table", "results.jsonl")
        self.assertEqual([(row["name"], row["drives"]) for row in table], [("nominal, gentle, full", 3)])
        figure = table[0]["figures"][3]
        self.assertEqual((figure["figure"], figure["unit"], figure["paper"]), ("ego RMSE at 60 m", "m", 0.28))
        self.assertLess(figure["low"], figure["mean"])
        self.assertLess(figure["mean"], figure["high"])
        text = self.call("benchmark", "table", "results.jsonl").stdout
        self.assertIn("the paper, Table I", text)
        markdown = self.call("benchmark", "table", "results.jsonl", "--markdown", "--by", "variant").stdout
        self.assertRegex(markdown, r"\| full \| ego \| 0\.\d{3} ±0\.\d{3} \|")

    def test_a_table_says_how_far_the_oracle_is(self):
        lines = self.lines("results.jsonl")
        for line in lines:
            line["estimator"] = "oracle"
            for lane in line["lanes"].values():
                for entry in lane:
                    entry["rmse_m"] = entry["rmse_m"] and entry["rmse_m"] / 2
        (self.folder / "oracle.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
        command = ["benchmark", "table", "results.jsonl", "oracle.jsonl"]
        rows = {row["estimator"]: row for row in self.succeed(*command)}
        self.assertNotIn("ratios", rows["oracle"])
        (ratios,) = rows["graph"]["ratios"]
        self.assertEqual((ratios["to"], ratios["drives"], len(ratios["figures"])), ("oracle", 3, 14))
        at_60_m = ratios["figures"][3]
        self.assertEqual(at_60_m["figure"], "ego RMSE at 60 m")
        for key in ("ratio", "low", "high"):
            self.assertAlmostEqual(at_60_m[key], 2)
        self.assertRegex(self.call(*command).stdout, r"\n +ego x oracle +2\.00 ±0\.00 ")
        self.assertIn("| ego x oracle | 2.00 ±0.00 |", self.call(*command, "--markdown").stdout)
        self.assertNotIn(" x ", self.call("benchmark", "table", "results.jsonl").stdout)

    def test_compare_pairs_drives_and_judges(self):
        self.drive("without.jsonl", "--seeds", "1-3", "--no-times", "--variant", "no-objects")
        compared = self.succeed("benchmark", "compare", "results.jsonl", "without.jsonl")
        self.assertEqual((compared["pairs"], compared["only_in_a"], compared["only_in_b"]), (3, 0, 0))
        for figure in compared["figures"]:
            self.assertIn(figure["verdict"], {"better", "worse", "noise", "unknown"})
        same = self.call("benchmark", "compare", "results.jsonl", "results.jsonl").stdout
        self.assertIn("3 drives in both", same)
        self.assertNotIn("significantly", same)


class Estimators(BenchmarkTest):
    def test_both_drive_the_same_drives_and_are_compared(self):
        self.drive("both.jsonl", "--seeds", "1-2", "--no-times", "--estimator", "graph,road")
        lines = self.lines("both.jsonl")
        self.assertEqual([(line["seed"], line["estimator"]) for line in lines],
                         [(1, "graph"), (1, "road"), (2, "graph"), (2, "road")])
        self.assertIn("graph", lines[0])
        self.assertNotIn("graph", lines[1])
        self.assertNotEqual(lines[0]["configuration_hash"], lines[1]["configuration_hash"])
        self.assertEqual(lines[0]["inputs"], lines[1]["inputs"])
        compared = self.succeed("benchmark", "compare", "both.jsonl", "both.jsonl", "--estimator-a", "graph",
                                "--estimator-b", "road")
        self.assertEqual((compared["pairs"], compared["only_in_a"], compared["only_in_b"]), (2, 0, 0))
        table = self.call("benchmark", "table", "both.jsonl").stdout
        self.assertIn("nominal, gentle, full, road", table)

    def test_what_contradicts_itself_is_refused(self):
        self.refuse(2, "benchmark", "--set", "estimator=road", "-o", "x.jsonl", naming="--estimator")
        self.refuse(2, "benchmark", "--estimator", "graph,x", "-o", "x.jsonl", naming="graph, road")
        self.refuse(2, "bench", "endurance", "--estimator", "road", "--beside", "direct", naming="--beside")
        self.drive("graph.jsonl", "--seeds", "1", "--no-times")
        self.refuse(2, "benchmark", "compare", "graph.jsonl", "graph.jsonl", "--estimator-b", "road",
                    naming="no drive of estimator road")

    def test_a_long_drive_takes_either(self):
        for estimator in ("graph", "road"):
            said = self.succeed("bench", "endurance", "--hours", 0.002, "--estimator", estimator)
            self.assertEqual({stretch["estimator"] for stretch in said["stretches"]}, {estimator})


class Times(BenchmarkTest):
    def test_times_are_all_that_differs(self):
        for name in ("a.jsonl", "b.jsonl"):
            self.drive(name, "--seeds", "1")
        a, b = self.lines("a.jsonl")[0], self.lines("b.jsonl")[0]
        self.assertLessEqual(a["cycle_ms"]["p50"], a["cycle_ms"]["max"])
        self.assertGreater(a["wall_s"], 0)
        self.assertEqual(set(a["stage_s"]), {"simulate", "fuse", "evaluate"})
        for line in (a, b):
            for key in TIMES:
                del line[key]
        self.assertEqual(a, b)
        self.succeed("benchmark", "merge", "a.jsonl", "b.jsonl", "-o", "c.jsonl")


class Coverage(BenchmarkTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.drive("nominal.jsonl", "--suite", "coverage", "--seeds", "1-2", "--no-times")
        cls.drive("noisy.jsonl", "--suite", "coverage", "--seeds", "1-2", "--no-times", "--noise", 2)

    def test_stated_uncertainty_is_judged_by_lane_and_distance(self):
        nominal, noisy = self.succeed("benchmark", "coverage", "nominal.jsonl", "noisy.jsonl", "--by", "scene")
        self.assertEqual((nominal["name"], nominal["noise"], nominal["drives"]), ("nominal", 1, 2))
        self.assertEqual((noisy["name"], noisy["noise"], noisy["drives"]), ("nominal, noise x 2", 2, 2))
        for lane in ("ego", "adjacent"):
            self.assertEqual([at["distance_m"] for at in nominal[lane]], list(range(0, 121, 10)))
            for before, after in zip(nominal[lane][:4], noisy[lane][:4]):
                self.assertGreater(after["nees"]["mean"], before["nees"]["mean"])
                self.assertIn(after["verdict"], ("honest", "too narrow", "too wide", "wrong tails"))
                self.assertEqual(after["n_protected"], 0)  # the paper's estimator vouches for no bound

    def test_for_people_it_is_a_table_a_row_of_drives(self):
        text = self.call("benchmark", "coverage", "nominal.jsonl", "noisy.jsonl").stdout
        self.assertIn("nominal, gentle, full, noise x 2: graph", text)
        self.assertIn("intervals are", text)
        markdown = self.call("benchmark", "coverage", "nominal.jsonl", "--markdown").stdout
        self.assertIn("### nominal, gentle, full: graph", markdown)
        self.assertIn("|---|---|", markdown)

    def test_the_noise_names_the_drive(self):
        self.assertEqual({line["noise"] for line in self.lines("noisy.jsonl")}, {2})
        self.assertNotIn("noise", self.lines("nominal.jsonl")[0])
        self.succeed("benchmark", "merge", "nominal.jsonl", "noisy.jsonl", "-o", "both.jsonl")
        self.assertEqual(len(self.lines("both.jsonl")), 4)
        self.refuse(2, "benchmark", "compare", "nominal.jsonl", "noisy.jsonl", naming="no drive in common")

    def test_a_recorded_drive_says_that_it_is_not_nominal(self):
        said = self.succeed("simulate", "--km", 0.1, "--noise", 0.5, "-o", "noisy.mcap")
        self.assertTrue(said["preset_hash"].endswith(", noise x 0.5"))
        self.assertIn("noise x 0.5", said["drive"])


class Tracking(BenchmarkTest):
    def test_two_trackers_are_judged_side_by_side(self):
        said = self.succeed("benchmark", "tracking", "--km", 0.3, "--seeds", "1-2", "--guard-rail-mirrors", 2)
        self.assertEqual((said["drives"], said["km"], said["road"]), (2, 0.6, "gentle"))
        for tracker in (said["tracking"], said["nearest_neighbour"]):
            self.assertLessEqual({"gospa_m", "mota", "idf1", "id_switches_per_vehicle_hour", "false_confirmed_per_hour",
                                  "false_witnesses_per_hour", "time_to_confirm_s", "near"}, set(tracker))
            for by_range in ("range_from_m", "lateral_rmse_m", "heading_rmse_deg", "n"):
                self.assertEqual(len(tracker[by_range]), 8)
        self.assertEqual(said["tracking"]["vehicles"], said["nearest_neighbour"]["vehicles"])
        self.assertGreater(said["tracking"]["hits"], 0)

    def test_for_people_it_is_a_table(self):
        text = self.call("benchmark", "tracking", "--hours", 0.002).stdout
        self.assertIn("nearest neighbour", text)
        self.assertIn("GOSPA", text)
        self.assertIn("1 drive, 0.2 km", text)

    def test_wrong_use_is_named(self):
        self.refuse(2, "benchmark", "tracking", "--road", "sharp", naming="--road")
        self.refuse(2, "benchmark", "tracking", "--km", 1, "--hours", 1, naming="--hours")
        self.refuse(2, "benchmark", "tracking", "--seeds", "x", naming="--seeds")
        self.refuse(2, "benchmark", "tracking", "--guard-rail-mirrors", -1, naming="--guard-rail-mirrors")


class WrongUse(BenchmarkTest):
    def test_what_is_missing_or_unknown_is_named(self):
        self.refuse(2, "benchmark", naming="--output")
        for option, value in (("--suite", "x"), ("--road", "x"), ("--scene", "x"), ("--variant", "x"), ("--seeds", "3-1"),
                              ("--truth", "x"), ("--estimator", "x"), ("--job", "3/2"), ("--job", "0/2"), ("--job", "x")):
            self.refuse(2, "benchmark", option, value, "-o", "x.jsonl", naming=option)
        self.refuse(2, "benchmark", "--set", "fusion.bogus=1", "-o", "x.jsonl", naming="fusion.bogus")
        self.refuse(2, "benchmark", "--km", 0, "-o", "x.jsonl", naming="--km")
        self.refuse(2, "benchmark", "--noise", 0, "-o", "x.jsonl", naming="--noise")
        self.refuse(2, "benchmark", "-o", "nowhere/x.jsonl", naming="nowhere")

    def test_results_are_looked_for(self):
        for command in (["table", "none"], ["coverage", "none"], ["compare", "none", "none"], ["merge", "none", "-o", "x"]):
            self.refuse(3, "benchmark", *command, naming="none")

    def test_merging_overwrites_nothing_unasked(self):
        (self.folder / "empty.jsonl").touch()
        (self.folder / "there.jsonl").touch()
        self.refuse(2, "benchmark", "merge", "empty.jsonl", "-o", "there.jsonl", naming="--force")
        self.refuse(2, "benchmark", "merge", "empty.jsonl", "-o", "empty.jsonl", "--force", naming="is the input")
        self.refuse(2, "benchmark", "table", "empty.jsonl", naming="empty.jsonl")


class List(BenchmarkTest):
    def test_it_names_the_drives_and_drives_none(self):
        listed = self.succeed("benchmark", "--suite", "ablations", "--seeds", "4,5", "--list")
        self.assertEqual({drive["variant"] for drive in listed},
                         {"full", "no-objects", "no-high-resolution-camera", "no-serial-camera", "no-width", "no-smoothing",
                          "no-switches"})
        self.assertEqual({(drive["scene"], drive["road"], drive["km"]) for drive in listed}, {("nominal", "gentle", 24)})
        self.assertEqual({drive["estimator"] for drive in listed}, {"graph"})
        text = self.call("benchmark", "--suite", "ablations", "--seeds", "4,5", "--list").stdout
        self.assertEqual(len(text.splitlines()), len(listed))

    def test_the_road_level_estimator_has_ablations_of_its_own(self):
        listed = self.succeed("benchmark", "--suite", "road-ablations", "--seeds", "4", "--list")
        self.assertEqual({drive["estimator"] for drive in listed}, {"road"})
        self.assertTrue({"full", "no-objects", "no-yaw-bias", "no-range-order"} <= {drive["variant"] for drive in listed})
        self.refuse(2, "benchmark", "--variant", "no-pitch", "--list", naming="no-pitch")

    def test_the_array_script_drives_them_one_process_each(self):
        script = program.SOURCE / "tools" / "benchmark-slurm.sh"
        done = subprocess.run([str(script), "--local", "array", "--km", "0.3", "--road", "gentle", "--seeds", "1-2"],
                              cwd=self.folder, capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([line["seed"] for line in self.lines("array/results.jsonl")], [1, 2])
        self.assertEqual(sorted(p.name for p in (self.folder / "array").glob("drive-*.jsonl")),
                         ["drive-1.jsonl", "drive-2.jsonl"])
        self.assertTrue(re.search("2 drives", done.stdout))


if __name__ == "__main__":
    program.main()
