# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""From rendered images to lanes, and cameras judged by what was rendered."""

from program import ProgramTest, main


class Images(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate("drive.mcap", 0.25, "--images", "clear", "--no-objects")
        cls.ran = cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.judged = cls.succeed("evaluate", "lanes.mcap", "--truth", "exact")

    def at(self, distance):
        return next(e for e in self.judged["lanes"]["ego"] if e["distance_m"] == distance)

    def test_pixels_become_lanes(self):
        self.assertGreater(self.ran["images"]["seen"], 250)
        self.assertEqual(self.ran["images"]["faults"], {})
        self.assertGreater(self.at(60)["availability"], 0.7)
        self.assertLess(self.at(60)["rmse_m"], 0.8)

    def test_without_images_there_are_no_lanes(self):
        blind = self.succeed("run", "drive.mcap", "-o", "blind.mcap", "--set", "sources.images.enabled=false")
        self.assertNotIn("images", blind)
        self.assertLess(blind["inputs"]["used"], self.ran["inputs"]["used"] / 10)

    def test_cameras_are_judged_image_by_image(self):
        figures = self.succeed("benchmark", "cameras", "--conditions", "clear", "--km", 0.2)["clear"]
        near = figures["markings"][1]
        self.assertGreater(near["found"], 0.8)
        self.assertLess(near["false"], 0.2)
        self.assertLess(near["lateral_rmse_px"], 3)
        self.assertGreater(figures["serial_camera"]["tracked"], 0.8)
        self.refuse(2, "benchmark", "cameras", "--conditions", "fog", naming="fog")


if __name__ == "__main__":
    main()
