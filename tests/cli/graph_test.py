# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""`graph` and `bench`: files in and out, false loops and switches, solvers beside each other."""

import math

import program

GRAPHS = program.real_data("pose_graphs")


def square_drive(laps):
    """A drive around a square, whose later laps close loops; every number is one that text holds exactly."""
    side, count = 8, 32 * laps
    lines = []
    for i in range(count):
        corner, along = divmod(i % 32, side)
        x, y = [(along, 0), (side, along), (side - along, side), (0, side - along)][corner]
        lines.append(f"VERTEX_SE2 {i} {x} {y} {[0, math.pi / 2, -math.pi, -math.pi / 2][corner]}")
    for i in range(count - 1):
        turn = math.pi / 2 if (i + 1) % side == 0 else 0
        lines.append(f"EDGE_SE2 {i} {i + 1} 1 0 {turn} 50 0 0 50 0 500")
    for i in range(count - 32):
        lines.append(f"EDGE_SE2 {i} {i + 32} 0 0 0 50 0 0 50 0 500")
    return "\n".join(lines) + "\n"


class Graphs(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "square.g2o").write_text(square_drive(5))

    def test_a_graph_comes_back_from_toro_bit_by_bit(self):
        self.succeed("graph", "convert", "square.g2o", "plain.g2o")
        self.succeed("graph", "convert", "square.g2o", "square.graph")
        self.assertIn("VERTEX2 1 1 0 0\n", (self.folder / "square.graph").read_text())
        self.succeed("graph", "convert", "square.graph", "back.g2o")
        self.assertEqual(self.bytes_of("back.g2o"), self.bytes_of("plain.g2o"))

    def test_what_a_format_has_no_words_for_is_said(self):
        self.succeed("graph", "spoil", "square.g2o", "--outliers", 3, "--switchable", "-o", "switches.g2o")
        done = self.call("graph", "convert", "switches.g2o", "switches.graph")
        self.assertEqual(done.returncode, 0)
        self.assertIn("131 switchable edges became plain ones", done.stderr)
        self.refuse(2, "graph", "convert", "square.g2o", "square.txt", naming="square.txt")

    def test_the_seed_decides_what_is_false(self):
        for name, seed in [("a.g2o", 1), ("b.g2o", 1), ("c.g2o", 2)]:
            self.succeed("graph", "spoil", "square.g2o", "--outliers", 20, "--seed", seed, "-o", name)
        self.assertEqual(self.bytes_of("a.g2o"), self.bytes_of("b.g2o"))
        self.assertNotEqual(self.bytes_of("a.g2o"), self.bytes_of("c.g2o"))

    def test_switches_turn_false_loops_off(self):
        self.succeed("graph", "spoil", "square.g2o", "--outliers", 20, "-o", "false.g2o")
        plain = self.succeed("graph", "solve", "false.g2o", "--reference", "square.g2o")
        switched = self.succeed("graph", "solve", "false.g2o", "--switchable", "--reference", "square.g2o", "-o", "s.g2o")
        self.assertGreater(plain["reference"]["ate_m"], 0.3)
        self.assertLess(switched["reference"]["ate_m"], 0.02)
        self.assertEqual(switched["switches_off"], 20)
        again = self.succeed("graph", "compare", "s.g2o", "square.g2o")
        self.assertAlmostEqual(again["ate_m"], switched["reference"]["ate_m"], places=9)

    def test_solvers_agree_or_say_that_they_are_not_there(self):
        own = self.succeed("graph", "solve", "square.g2o", "--solver", "direct")
        done = self.call("graph", "solve", "square.g2o", "--solver", "ceres", "--json")
        if done.returncode == 2:
            self.assertIn("not part of this program", done.stderr)
        else:
            other = self.succeed("graph", "solve", "square.g2o", "--solver", "ceres:dense_schur")
            self.assertAlmostEqual(own["chi2"], other["chi2"], delta=1e-6)

    def test_bench_names_times_and_ratio(self):
        (self.folder / "graphs").mkdir(exist_ok=True)
        (self.folder / "graphs" / "square.g2o").write_text(square_drive(5))
        row = self.succeed("bench", "lane-graphs", "graphs", "--seconds", 0)["graphs"][0]
        self.assertEqual(row["graph"], "square")
        self.assertEqual(row["cycles"], 20)
        self.assertGreater(row["lanefuse_ms"], 0)
        self.assertGreaterEqual(row["lanefuse_p95_ms"], row["lanefuse_ms"])
        self.assertEqual(row["cg_iterations"], 0)
        if row["ceres_ms"] is not None:
            self.assertAlmostEqual(row["ratio"], row["ceres_ms"] / row["lanefuse_ms"])
        self.refuse(3, "bench", "lane-graphs", "nowhere", naming="nowhere")

    def test_windows_of_a_run_change_nothing_and_can_be_timed(self):
        self.simulate(km=0.1)
        self.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cycles = self.succeed("run", "drive.mcap", "-o", "same.mcap", "--dump-graphs", "windows")["cycles"]
        self.assertEqual(self.bytes_of("same.mcap"), self.bytes_of("lanes.mcap"))
        windows = sorted(p.name for p in (self.folder / "windows").iterdir())
        self.assertEqual(windows[:2], ["000000.g2o", "000001.g2o"])
        self.assertLessEqual(len(windows), cycles)
        row = self.succeed("bench", "windows", "windows")["windows"]
        self.assertEqual((row["windows"], row["failed"]), (len(windows), 0))
        self.assertEqual(self.succeed("bench", "lane-graphs", "windows")["windows"]["windows"], len(windows))
        self.refuse(2, "run", "drive.mcap", "-o", "x.mcap", "--dump-graphs", "windows", naming="windows")


@program.needs(GRAPHS)
class FalseLoops(program.ProgramTest):
    def test_m3500_with_a_thousand(self):
        self.succeed("graph", "solve", GRAPHS / "M3500.g2o", "-o", "clean.g2o")
        self.succeed("graph", "spoil", GRAPHS / "M3500.g2o", "--outliers", 1000, "--switchable", "-o", "false.g2o")
        solved = self.succeed("graph", "solve", "false.g2o", "--reference", "clean.g2o")
        self.assertLess(solved["reference"]["ate_m"], 0.02)
        self.assertEqual(solved["switches_off"], 1000)


if __name__ == "__main__":
    program.main()
