# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""`graph solve` finds the known optima of the standard graphs."""

import program

GRAPHS = program.real_data("pose_graphs")
OPTIMA = {"M3500": 146.076745, "intel": 546.461112, "MIT": 770.663502, "CSAIL": 40.555129, "city10000": 511.985164,
          "ring": 11.163101}


@program.needs(GRAPHS)
class StandardGraphs(program.ProgramTest):
    def test_optima(self):
        for name, optimum in OPTIMA.items():
            with self.subTest(graph=name):
                solved = self.succeed("graph", "solve", GRAPHS / f"{name}.g2o")
                self.assertLess(abs(solved["chi2"] / optimum - 1), 1e-6)
                self.assertGreater(solved["iterations"], 0)
                self.assertGreater(solved["solve_ms"], 0)

    def test_a_solved_graph_is_solved(self):
        first = self.succeed("graph", "solve", GRAPHS / "intel.g2o", "-o", "solved.g2o")
        again = self.succeed("graph", "solve", "solved.g2o")
        self.assertAlmostEqual(again["initial_chi2"], first["chi2"], delta=1e-6 * first["chi2"])


if __name__ == "__main__":
    program.main()
