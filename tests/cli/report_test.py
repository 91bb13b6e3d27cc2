# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A browser opens the report: tables and pictures are there, nothing complains, nothing is fetched from elsewhere."""

import re
import shutil
import subprocess
import unittest

import program

BROWSER = shutil.which("chromium")
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--no-first-run", "--enable-logging=stderr",
         "--virtual-time-budget=5000"]


@unittest.skipUnless(BROWSER, "no chromium")
class ReportInABrowser(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate()
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.judged = cls.succeed("evaluate", "lanes.mcap", "--truth", "exact")
        cls.opened = subprocess.run(
            [BROWSER, *FLAGS, f"--user-data-dir={cls.folder / 'profile'}", "--dump-dom",
             (cls.folder / "report.html").as_uri()], capture_output=True, text=True, timeout=300, check=False)

    def test_it_opens(self):
        self.assertEqual(self.opened.returncode, 0, self.opened.stderr)

    def test_the_table_holds_the_scores(self):
        page = self.opened.stdout
        self.assertIn("<table", page)
        for entry in (self.judged["lanes"]["ego"][6], self.judged["lanes"]["adjacent"][6]):
            self.assertIn(f"{entry['rmse_m']:.2f}", page)

    def test_it_holds_charts_and_top_views(self):
        self.assertGreaterEqual(self.opened.stdout.count("<svg"), 5)
        self.assertNotRegex(self.opened.stdout, r"\bNaN\b|\bnan\b|\binf\b")

    def test_the_console_stays_silent(self):
        said = [line for line in self.opened.stderr.splitlines() if "CONSOLE" in line]
        self.assertEqual(said, [])

    def test_nothing_comes_from_elsewhere(self):
        page = self.opened.stdout
        outside = re.findall(r'(?:src|srcset|action|data|poster)\s*=\s*["\']?\s*(?:https?:|//)[^"\'>]*', page)
        outside += re.findall(r'<link[^>]*href[^>]*>', page)
        outside += re.findall(r'url\(\s*["\']?(?:https?:|//)[^)]*|@import[^;]*', page)
        self.assertEqual(outside, [])


if __name__ == "__main__":
    program.main()
