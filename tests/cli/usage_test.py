# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Help for every subcommand, exit status 2 for wrong use, and nothing overwritten unasked."""

import program

SUBCOMMANDS = [["simulate"], ["import", "comma2k19"], ["run"], ["evaluate"], ["plot"], ["strip"], ["graph", "solve"],
               ["graph", "convert"], ["graph", "spoil"], ["graph", "compare"], ["bench", "lane-graphs"], ["bench", "windows"],
               ["benchmark"], ["benchmark", "merge"], ["benchmark", "table"], ["benchmark", "compare"],
               ["map", "info"], ["map", "convert"], ["calibrate", "chessboard"], ["calibrate", "mounting"]]


class Help(program.ProgramTest):
    def test_every_subcommand_explains_itself(self):
        for subcommand in SUBCOMMANDS:
            done = self.call(*subcommand, "--help")
            self.assertEqual(done.returncode, 0, subcommand)
            self.assertIn("Usage: lanefuse " + " ".join(subcommand), done.stdout)
            for option in ("--json", "--force"):
                self.assertIn(option, done.stdout, subcommand)

    def test_the_program_lists_its_subcommands(self):
        done = self.call("--help")
        self.assertEqual(done.returncode, 0)
        for subcommand in SUBCOMMANDS:
            self.assertIn(f"\n  {subcommand[0]} ", done.stdout)

    def test_the_version_is_a_line(self):
        self.assertRegex(self.call("--version").stdout, r"^lanefuse \d+\.\d+\.\d+\n$")


class WrongUse(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate()
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")

    def test_no_or_an_unknown_subcommand(self):
        self.refuse(2, naming="subcommand")
        self.refuse(2, "import", naming="subcommand")
        self.refuse(2, "fuse", naming="fuse")
        self.refuse(2, "graph", "draw", naming="draw")

    def test_unknown_options_are_named(self):
        for subcommand in SUBCOMMANDS:
            if subcommand[0] in ("graph", "bench"):
                needed = ["-o", "y", "--outliers", 1] if subcommand[-1] == "spoil" else ["y"]
                self.refuse(2, *subcommand, "x", *needed, "--bogus", naming="--bogus")
                continue
            needed = ["--camera", "z", "--lane-width-m", 3.5] if subcommand[-1] == "mounting" else []
            self.refuse(2, *subcommand, "x", "-o", "y", "--truth", "exact", *needed, "--bogus", naming="--bogus")

    def test_what_is_missing_is_named(self):
        self.refuse(2, "run", naming="drive")
        self.refuse(2, "run", "drive.mcap", naming="--output")
        self.refuse(2, "simulate", naming="--output")
        self.refuse(2, "evaluate", "lanes.mcap", naming="--truth")
        self.refuse(2, "plot", "lanes.mcap", naming="--output")
        self.refuse(2, "strip", "drive.mcap", naming="--output")

    def test_values_out_of_range(self):
        self.refuse(2, "simulate", "--km", 0, "-o", "x.mcap", naming="--km")
        self.refuse(2, "simulate", "--km", "nan", "-o", "x.mcap", naming="km")
        self.refuse(2, "simulate", "--seed", -1, "-o", "x.mcap", naming="--seed")
        self.refuse(2, "simulate", "--road", "moon", "-o", "x.mcap", naming="moon")
        self.refuse(2, "plot", "lanes.mcap", "--at", -1, "-o", "x.svg", naming="--at")
        self.refuse(2, "plot", "lanes.mcap", "--at", "nan", "-o", "x.svg", naming="--at")
        self.refuse(2, "plot", "lanes.mcap", "--at", 1e6, "-o", "x.svg", naming="--at")
        self.refuse(2, "plot", "lanes.mcap", "--at", 1, "--tracks", "-o", "x.svg", naming="--tracks")
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "guess", naming="--truth")
        self.refuse(2, "graph", "solve", "x.g2o", "--max-iterations", -1, naming="--max-iterations")
        self.refuse(2, "graph", "solve", "x.g2o", "--switch-prior", 0, naming="--switch-prior")
        self.refuse(2, "graph", "solve", "x.g2o", "--solver", "guess", naming="guess")
        self.refuse(2, "graph", "spoil", "x.g2o", "-o", "y.g2o", "--outliers", -1, naming="--outliers")

    def test_nothing_is_overwritten_unasked(self):
        self.refuse(2, "simulate", "-o", "drive.mcap", naming="--force")
        self.refuse(2, "run", "drive.mcap", "-o", "lanes.mcap", naming="--force")
        self.refuse(2, "strip", "drive.mcap", "-o", "lanes.mcap", naming="--force")
        self.refuse(2, "plot", "lanes.mcap", "-o", "drive.mcap", naming="drive.mcap")
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "exact", "-o", "drive.mcap", naming="--force")

    def test_no_input_is_overwritten_even_if_asked(self):
        self.refuse(2, "run", "drive.mcap", "-o", "drive.mcap", "--force", naming="is the input")
        self.refuse(2, "run", "drive.mcap", "-o", "./drive.mcap", "--force", naming="is the input")
        self.refuse(2, "strip", "drive.mcap", "-o", "drive.mcap", "--force", naming="is the input")
        for output in ("lanes.mcap", "drive.mcap"):
            self.refuse(2, "plot", "lanes.mcap", "-o", output, "--force", naming="is the input")
            self.refuse(2, "evaluate", "lanes.mcap", "--truth", "exact", "-o", output, "--force", naming="is the input")

    def test_a_missing_folder_is_named(self):
        for command in (["simulate"], ["run", "drive.mcap"], ["strip", "drive.mcap"], ["plot", "lanes.mcap"],
                        ["evaluate", "lanes.mcap", "--truth", "exact"]):
            self.refuse(2, *command, "-o", "nowhere/output", naming="nowhere")

    def test_a_folder_is_no_output(self):
        (self.folder / "folder").mkdir(exist_ok=True)
        self.refuse(2, "run", "drive.mcap", "-o", "folder", "--force", naming="is a folder")


class Force(program.ProgramTest):
    def test_force_overwrites(self):
        self.simulate()
        self.simulate("drive.mcap", 0.2, "--force")
        for _ in range(2):
            self.succeed("run", "drive.mcap", "-o", "lanes.mcap", "--force")


if __name__ == "__main__":
    program.main()
