# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A drive with images becomes a video of what was seen in them."""

from program import ProgramTest, main


class Overlay(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate("drive.mcap", 0.05, "--images", "clear")
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")

    def test_the_video_has_a_frame_for_every_image(self):
        whole = self.succeed("overlay", "lanes.mcap", "-o", "whole.mp4")
        rate = whole["frames_per_second"]
        self.assertAlmostEqual(whole["frames"], 1 + (whole["to_s"] - whole["from_s"]) * rate, delta=1)
        self.assertGreater((self.folder / "whole.mp4").stat().st_size, 10000)
        part = self.succeed("overlay", "lanes.mcap", "--from", 0.4, "--to", 0.8, "-o", "part.mp4")
        self.assertGreaterEqual(part["from_s"], 0.4)
        self.assertLessEqual(part["to_s"], 0.8)
        self.assertAlmostEqual(part["frames"], 0.4 * rate, delta=1.01)
        self.assertEqual(part["without_view"], 0)

    def test_one_moment_is_a_picture(self):
        for name in ("a.png", "b.png"):
            still = self.succeed("overlay", "lanes.mcap", "--at", 0.5, "-o", name)
            self.assertEqual(still["frames"], 1)
            self.assertGreaterEqual(still["from_s"], 0.5)
        self.assertEqual(self.bytes_of("a.png"), self.bytes_of("b.png"))

    def test_what_cannot_be_drawn_is_named(self):
        self.refuse(2, "overlay", "lanes.mcap", "--camera", "rear", "-o", "x.mp4", naming="--camera rear")
        self.refuse(2, "overlay", "lanes.mcap", "-o", "x.avi", naming="x.avi")
        self.refuse(2, "overlay", "lanes.mcap", "--at", 1, "-o", "x.mp4", naming=".png")
        self.refuse(2, "overlay", "lanes.mcap", "--at", 1, "--from", 1, "-o", "x.png", naming="--from")
        self.refuse(2, "overlay", "lanes.mcap", "--from", 900, "-o", "x.mp4", naming="900")
        self.refuse(2, "overlay", "lanes.mcap", "-o", "drive.mcap", naming="drive.mcap")
        self.refuse(3, "overlay", "drive.mcap", "-o", "x.mp4", naming="drive.mcap")

    def test_a_drive_without_images_is_named(self):
        self.simulate("blind.mcap", 0.05)
        self.succeed("run", "blind.mcap", "-o", "blind.lanes.mcap")
        self.refuse(3, "overlay", "blind.lanes.mcap", "-o", "x.mp4", naming="blind.mcap")


if __name__ == "__main__":
    main()
