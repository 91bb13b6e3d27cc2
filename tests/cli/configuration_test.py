# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Settings by file and by --set: defaults documented, wrong ones refused by name."""

import program


class Configuration(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate()
        cls.plain = cls.succeed("run", "drive.mcap", "-o", "plain.mcap")

    def printed(self, *arguments):
        done = self.call("run", "--print-config", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def run_with(self, name, *arguments):
        return self.succeed("run", "drive.mcap", "-o", name, "--force", *arguments)

    def test_the_committed_listing_is_the_programs(self):
        listing = (program.SOURCE / "config" / "default.yaml").read_text(encoding="utf-8")
        without_head = "".join(line for line in listing.splitlines(True) if not line.startswith("# SPDX-"))
        self.assertEqual(without_head, self.printed(), "renew it: see docs/configuration.md")

    def test_the_listing_is_a_configuration(self):
        (self.folder / "default.yaml").write_text(self.printed(), encoding="utf-8")
        run = self.run_with("listed.mcap", "--config", "default.yaml")
        self.assertEqual(run["configuration_hash"], self.plain["configuration_hash"])
        self.assertEqual(self.bytes_of("listed.mcap"), self.bytes_of("plain.mcap"))

    def test_a_setting_changes_what_is_printed_and_what_is_run(self):
        self.assertIn("cycle_hz: 10", self.printed("--set", "cycle_hz=10"))
        run = self.run_with("slow.mcap", "--set", "cycle_hz=10")
        self.assertAlmostEqual(run["cycles"], 0.8 * self.plain["cycles"], delta=2)
        self.assertNotEqual(run["configuration_hash"], self.plain["configuration_hash"])

    def test_set_goes_over_the_file(self):
        (self.folder / "file.yaml").write_text("cycle_hz: 5\n", encoding="utf-8")
        self.assertIn("cycle_hz: 10", self.printed("--config", "file.yaml", "--set", "cycle_hz=10"))

    def test_either_estimator_runs_and_is_named(self):
        self.assertEqual(self.plain["estimator"], "graph")
        self.assertIn("graph", self.plain)
        self.assertIn("estimator: road", self.printed("--set", "estimator=graph", "--estimator", "road"))
        run = self.run_with("road.mcap", "--estimator", "road")
        self.assertEqual(run["estimator"], "road")
        self.assertNotIn("graph", run)
        self.assertEqual(run["cycles"], self.plain["cycles"])
        for name, estimator in (("plain.mcap", "graph"), ("road.mcap", "road")):
            judged = self.succeed("evaluate", name, "--truth", "exact", "--report", "report.html", "--force")
            self.assertEqual(judged["estimator"], estimator)
            self.assertIn(f"estimator: {estimator}", (self.folder / "report.html").read_text(encoding="utf-8"))
            self.assertIn(f"estimator: {estimator}", self.call("evaluate", name, "--truth", "exact").stdout)

    def test_the_setting_chooses_as_the_option_does(self):
        self.run_with("set.mcap", "--set", "estimator=road")
        self.run_with("option.mcap", "--estimator", "road")
        self.assertEqual(self.bytes_of("set.mcap"), self.bytes_of("option.mcap"))

    def test_what_is_the_graphs_own_is_refused_with_another(self):
        road = ("run", "drive.mcap", "-o", "x.mcap", "--estimator", "road")
        self.refuse(2, *road, "--dump-graphs", "windows", naming="--dump-graphs")
        self.refuse(2, *road, "--solver", "direct", naming="--solver")
        self.refuse(2, "run", "drive.mcap", "-o", "x.mcap", "--estimator", "guess", naming="--estimator")

    def test_wrong_settings_are_refused_by_name(self):
        for setting, name in [("fusion.bogus=1", "fusion.bogus"), ("bogus=1", "bogus"), ("cycle_hz=-1", "cycle_hz"),
                              ("cycle_hz=fast", "cycle_hz"), ("cycle_hz=nan", "cycle_hz"), ("cycle_hz=", "cycle_hz"),
                              ("cycle_hz", "KEY=VALUE"), ("fusion=1", "fusion"), ("fusion.width_edges=2", "width_edges")]:
            self.refuse(2, "run", "drive.mcap", "-o", "x.mcap", "--set", setting, naming=name)

    def test_wrong_files_are_refused_by_name_and_line(self):
        for text, naming in [("cycle_hz: 10\nfusion: {bogus: 1}\n", "wrong.yaml:2"), ("cycle_hz: [\n", "wrong.yaml"),
                             ("just text\n", "wrong.yaml"), ("cycle_hz: 1e9\n", "cycle_hz")]:
            (self.folder / "wrong.yaml").write_text(text, encoding="utf-8")
            self.refuse(2, "run", "drive.mcap", "-o", "x.mcap", "--config", "wrong.yaml", naming=naming)
        self.refuse(2, "run", "drive.mcap", "-o", "x.mcap", "--config", "nowhere.yaml", naming="nowhere.yaml")


if __name__ == "__main__":
    program.main()
