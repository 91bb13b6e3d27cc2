#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Plants violations in a small tree and expects tools/structure-rules to name them."""

import importlib.machinery
import importlib.util
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("structure_rules", str(Path(__file__).parent / "structure-rules"))
rules = importlib.util.module_from_spec(importlib.util.spec_from_loader("structure_rules", loader))
loader.exec_module(rules)

SLASH_HEAD = "// SPDX-FileCopyrightText: 2026 Someone\n// SPDX-License-Identifier: Apache-2.0\n"
HASH_HEAD = SLASH_HEAD.replace("//", "#")
ROOMS = {"core": [], "sensors": ["core"], "sources": ["sensors", "core"], "fusion": ["core"],
         "simulation": ["sensors", "core"]}


class StructureRules(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        subprocess.run(["git", "init", "-q", str(self.root)], check=True)
        for room, depends in ROOMS.items():
            words = f"{room} DEPENDS {' '.join(depends)}" if depends else room
            self.write(f"src/{room}/CMakeLists.txt", f"{HASH_HEAD}lanefuse_library({words})\n")
            self.write_cpp(f"src/{room}/{room}.hpp")
        self.write_cpp("src/sensors/truth.hpp")
        self.write_plan(ROOMS)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, file, text):
        path = self.root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def write_cpp(self, file, *includes, body=""):
        self.write(file, SLASH_HEAD + "".join(f'#include "{i}"\n' for i in includes) + body)

    def write_plan(self, rooms):
        lines = [f"src/{room}/  what it is\n     and more  -> {', '.join(depends) or 'nothing'}"
                 for room, depends in rooms.items()]
        self.write("docs/architecture.md", "# Plan\n```\n" + "\n".join(lines) + "\n```\n")

    def expect_only(self, file, rule):
        found = rules.violations(self.root)
        self.assertEqual([f for f, _ in found], [file], found)
        self.assertIn(rule, found[0][1])

    def test_a_tidy_tree_has_no_violation(self):
        self.write_cpp("src/sources/radar.cpp", "sensors/sensors.hpp", "core/core.hpp")
        self.write_cpp("tests/simulation/drive_test.cpp", "simulation/simulation.hpp", "sensors/truth.hpp")
        self.assertEqual(rules.violations(self.root), [])

    def test_a_missing_head(self):
        self.write("src/core/bare.cpp", "int x;\n")
        self.expect_only("src/core/bare.cpp", "SPDX")

    def test_a_script_needs_a_head_and_may_begin_with_its_interpreter(self):
        self.write("good", "#!/bin/bash\n" + HASH_HEAD)
        self.write("bad", "#!/bin/bash\necho\n")
        self.expect_only("bad", "SPDX")

    def test_a_folder_and_a_file_that_name_nothing(self):
        self.write_cpp("tests/helpers/scene.hpp")
        self.expect_only("tests/helpers/scene.hpp", "'helpers'")
        (self.root / "tests/helpers/scene.hpp").unlink()
        self.write_cpp("src/core/utils.hpp")
        self.expect_only("src/core/utils.hpp", "'utils'")

    def test_a_long_file_counts_code_only(self):
        self.write_cpp("src/core/fits.cpp", body="int x;  // why\n" * 250 + "\n// word\n/* block\n of words */\n")
        self.assertEqual(rules.violations(self.root), [])
        self.write_cpp("src/core/long.cpp", body="int x;\n" * 251)
        self.expect_only("src/core/long.cpp", "251 lines of code")

    def test_an_arrow_that_is_not_declared(self):
        self.write_cpp("src/core/up.cpp", "sensors/sensors.hpp")
        self.expect_only("src/core/up.cpp", "core depends on nothing")

    def test_the_users_form_of_an_include_inside_the_tree(self):
        self.write("src/sensors/odd.cpp", SLASH_HEAD + "#include <lanefuse/core/core.hpp>\n")
        self.expect_only("src/sensors/odd.cpp", 'say "core/core.hpp"')

    def test_a_room_that_is_no_library(self):
        self.write_cpp("src/attic/box.hpp")
        self.write_plan({**ROOMS, "attic": []})
        self.expect_only("src/attic/CMakeLists.txt", "does not call lanefuse_library(attic")

    def test_a_plan_that_says_otherwise(self):
        self.write_plan({**ROOMS, "sensors": []})
        self.expect_only("docs/architecture.md", "draws sensors -> nothing, src/sensors/CMakeLists.txt says core")

    def test_a_plan_that_forgets_or_invents_a_room(self):
        self.write_plan({room: depends for room, depends in ROOMS.items() if room != "fusion"})
        self.expect_only("docs/architecture.md", "no line 'src/fusion/")
        self.write_plan({**ROOMS, "attic": []})
        self.expect_only("docs/architecture.md", "draws src/attic")

    def test_a_missing_plan(self):
        (self.root / "docs/architecture.md").unlink()
        self.expect_only("docs/architecture.md", "is missing")

    def test_fusion_knows_no_sensors_even_if_it_declares_them(self):
        self.write("src/fusion/CMakeLists.txt", f"{HASH_HEAD}lanefuse_library(fusion DEPENDS sources core)\n")
        self.write_plan({**ROOMS, "fusion": ["sources", "core"]})
        self.write_cpp("src/fusion/window.cpp", "sources/sources.hpp")
        self.expect_only("src/fusion/window.cpp", "fusion knows features, never sensors")

    def test_nothing_outside_may_simulate(self):
        self.write_cpp("examples/01_drive.cpp")
        self.write("examples/01_drive.cpp", SLASH_HEAD + "#include <lanefuse/simulation/simulation.hpp>\n")
        self.expect_only("examples/01_drive.cpp", "may simulate")

    def test_what_estimates_sees_no_truth_not_even_through_others(self):
        self.write_cpp("src/sources/cheat.cpp", "sensors/truth.hpp")
        self.expect_only("src/sources/cheat.cpp", "sees the truth through src/sensors/truth.hpp")
        (self.root / "src/sources/cheat.cpp").unlink()
        self.write_cpp("src/sensors/window.hpp", "sensors/truth.hpp")
        self.write_cpp("src/sources/cheat.cpp", "sensors/window.hpp")
        self.expect_only("src/sources/cheat.cpp", "src/sensors/window.hpp -> src/sensors/truth.hpp")

    def test_a_circle_of_files(self):
        self.write_cpp("src/core/a.hpp", "core/b.hpp")
        self.write_cpp("src/core/b.hpp", "core/c.hpp")
        self.write_cpp("src/core/c.hpp", "core/a.hpp")
        self.expect_only("src/core/a.hpp", "src/core/a.hpp -> src/core/b.hpp -> src/core/c.hpp -> src/core/a.hpp")

    def test_a_circle_of_rooms(self):
        self.write("src/core/CMakeLists.txt", f"{HASH_HEAD}lanefuse_library(core DEPENDS sensors)\n")
        self.write_plan({**ROOMS, "core": ["sensors"]})
        self.write_cpp("src/core/up.cpp", "sensors/sensors.hpp")
        self.write_cpp("src/sensors/down.cpp", "core/core.hpp")
        self.expect_only("core", "rooms include each other in a circle: core -> sensors -> core")

    def test_ignored_files_do_not_count(self):
        self.write(".gitignore", "/build/\n")
        self.write("build/made.cpp", "int x;\n")
        self.assertEqual(rules.violations(self.root), [])


if __name__ == "__main__":
    unittest.main()
