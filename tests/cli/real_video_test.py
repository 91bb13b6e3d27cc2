# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A real motorway clip from plain video to lanes, against what was marked in it by hand."""

import program

CLIPS = program.real_data("highway_video")
CLIP = "P4_trees_164f.mp4"
CAMERA = program.SOURCE / "tests" / "data" / "highway_video_camera.yaml"
LABELS = program.SOURCE / "tests" / "data" / "highway_video_labels.json"
CONFIG = program.SOURCE / "config" / "video.yaml"


@program.needs(CLIPS)
class RealVideo(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.imported = cls.succeed("import", "video", CLIPS / CLIP, "--camera", CAMERA, "--dash-period-m", 14.63, "-o",
                                   "drive.mcap")
        cls.ran = cls.succeed("run", "drive.mcap", "--config", CONFIG, "-o", "lanes.mcap")
        cls.judged = cls.succeed("benchmark", "labels", "drive.mcap", "--labels", LABELS, "--clip", CLIP, "--config", CONFIG,
                                 "--tolerance-px", 12)

    def share(self, name):
        return self.judged[name]["found"] / self.judged[name]["of"]

    def test_every_image_is_seen_and_believed(self):
        self.assertEqual(self.ran["images"], {"seen": 164, "faults": {}})
        self.assertEqual(self.ran["inputs"]["rejected"], 0)

    def test_the_speed_is_a_motorways(self):
        self.assertEqual(self.imported["scale"]["source"], "dash period")
        self.assertTrue(28 < self.imported["speed_mps"]["mean"] < 33, self.imported)

    def test_the_ego_lane_lies_on_its_paint(self):
        self.assertGreater(self.share("ego_both"), 0.6)
        self.assertLess(abs(self.judged["median_ego_width_m"] - 3.66), 0.25)
        for distance in self.judged["ego_px"]:
            self.assertLess(distance["rmse"], 10, distance)

    def test_no_line_is_found_where_there_is_none(self):
        self.assertEqual(self.judged["dummy"]["found"], 0)

    def test_cars_are_boxed(self):
        self.assertGreater(self.share("vehicles_found"), 0.7)
        self.assertGreater(self.share("boxes_true"), 0.7)


if __name__ == "__main__":
    program.main()
