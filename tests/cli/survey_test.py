# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A road is surveyed from drives, and a drive is placed in the map."""

from program import ProgramTest, main


class Survey(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for lane in (1, 2, 3):
            cls.survey_drive(f"lane{lane}.mcap", lane, seed=lane)

    @classmethod
    def survey_drive(cls, name, lane, seed, *more):
        cls.succeed("simulate", "--seed", seed, "--road-seed", 7, "--km", 0.8, "--lane", lane, "--ego-lane-changes",
                    "off", "--gnss-ins", "--no-objects", "--no-high-resolution-camera", "-o", name, *more)

    def test_drives_on_all_lanes_become_a_map_near_the_exact_road(self):
        built = self.succeed("map", "build", "lane1.mcap", "lane2.mcap", "lane3.mcap", "-o", "map.geojson",
                             "--against", "lane1.mcap")
        self.assertEqual(built["boundaries"], 4)
        self.assertEqual(built["lanes"], 3)
        self.assertLess(built["deviation"]["all"]["rmse"], 0.15)
        self.assertEqual(built["deviation"]["strays"], 0)
        compared = self.succeed("map", "compare", "map.geojson", "--truth", "lane3.mcap")
        self.assertAlmostEqual(compared["all"]["rmse"], built["deviation"]["all"]["rmse"], places=3)

    def test_same_drives_same_bytes(self):
        for name in ("a.geojson", "b.geojson"):
            self.succeed("map", "build", "lane1.mcap", "lane2.mcap", "-o", name)
        self.assertEqual(self.bytes_of("a.geojson"), self.bytes_of("b.geojson"))

    def test_drive_is_placed_in_the_map(self):
        self.succeed("map", "build", "lane1.mcap", "lane2.mcap", "lane3.mcap", "-o", "place.geojson")
        self.survey_drive("later.mcap", 2, seed=50)
        placed = self.succeed("map", "localize", "later.mcap", "--map", "place.geojson", "-o", "poses.csv")
        self.assertGreater(placed["lanes"]["2"], 0.9 * placed["poses"])
        self.assertLess(placed["error"]["by_map"]["across_m"]["rmse"], 0.15)
        lines = (self.folder / "poses.csv").read_text().splitlines()
        self.assertEqual(len(lines), placed["poses"] + 1)

    def test_fixes_do_not_change_what_is_estimated(self):
        self.simulate("without.mcap", 0.3)
        self.simulate("with.mcap", 0.3, "--gnss-ins")
        for name in ("without", "with"):
            self.succeed("run", f"{name}.mcap", "-o", f"{name}.lanes.mcap")
        self.assertEqual(self.bytes_of("without.lanes.mcap"), self.bytes_of("with.lanes.mcap"))

    def test_what_cannot_be_surveyed_is_refused(self):
        self.simulate("blind.mcap", 0.2)
        self.refuse(3, "map", "build", "blind.mcap", "-o", "x.geojson", naming="blind.mcap: holds no GNSS/INS fixes")
        self.refuse(2, "map", "build", "lane1.mcap", "-o", "lane1.mcap", naming="lane1.mcap")
        self.refuse(2, "map", "build", "lane1.mcap", "-o", "x.geojson", "--chart", "x.svg", naming="--against")
        self.refuse(2, "simulate", "--lane", 9, "-o", "x.mcap", naming="no lane 9")


if __name__ == "__main__":
    main()
