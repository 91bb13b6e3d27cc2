# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A camera's lens from real chessboards, its mounting from real straight roads, and what cannot serve for either."""

import program

VIDEO = program.real_data("highway_video")
CAMERA = program.SOURCE / "tests" / "data" / "highway_video_camera.yaml"


@program.needs(VIDEO)
class RealCamera(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        boards = sorted((VIDEO / "calibration").glob("*.jpg"))
        (cls.folder / "broken.jpg").write_bytes(boards[0].read_bytes()[:300])
        cls.lens = cls.succeed("calibrate", "chessboard", *boards, "broken.jpg", VIDEO / "still" / "test1.jpg",
                               "--square-m", 0.03, "-o", "camera.yaml")

    def test_the_lens_is_the_reference(self):
        self.assertLess(self.lens["rms_px"], 1.1)
        self.assertAlmostEqual(self.lens["fx"] / 1160, 1, delta=0.01)
        self.assertAlmostEqual(self.lens["fy"] / 1155, 1, delta=0.01)
        self.assertEqual(len(self.lens["distortion"]), 5)
        self.assertGreaterEqual(self.lens["images_used"], 18)
        self.assertGreater(self.lens["sigma"]["fx"], 0)

    def test_images_without_a_board_are_named(self):
        reasons = {refusal["image"]: refusal["reason"] for refusal in self.lens["images_refused"]}
        self.assertIn("cannot be read", reasons["broken.jpg"])
        self.assertIn("no chessboard", reasons[str(VIDEO / "still" / "test1.jpg")])

    def test_images_a_pixel_larger_count(self):
        sizes = [image["size"] for image in self.lens["images"]]
        self.assertIn([1281, 721], sizes)

    def test_the_mounting_is_what_is_known(self):
        roads = sorted((VIDEO / "still").glob("straight_lines*.jpg"))
        result = self.succeed("calibrate", "mounting", *roads, "--camera", CAMERA, "--lane-width-m", 3.66,
                              "-o", "mounted.yaml")
        self.assertEqual(result["images_used"], 2)
        self.assertAlmostEqual(result["height_m"], 1.24, delta=0.03 * 1.24)
        self.assertAlmostEqual(result["pitch_deg"], -1.6, delta=0.3)
        self.assertAlmostEqual(result["yaw_deg"], -1.4, delta=0.3)
        self.assertGreater(result["sigma"]["roll_deg"], 0.5)
        self.assertIn("fx_px: 1160", (self.folder / "mounted.yaml").read_text())

    def test_the_lens_serves_to_find_the_mounting(self):
        roads = sorted((VIDEO / "still").glob("straight_lines*.jpg"))
        result = self.succeed("calibrate", "mounting", *roads, "--camera", "camera.yaml", "--lane-width-m", 3.66)
        self.assertAlmostEqual(result["height_m"], 1.24, delta=0.03 * 1.24)

    def test_in_words(self):
        words = self.call("calibrate", "mounting", *(VIDEO / "still").glob("straight_lines*.jpg"), CAMERA,
                          "--camera", CAMERA, "--lane-width-m", 3.66).stdout
        self.assertIn("2 of 3 images", words)
        self.assertIn("height", words)
        self.assertIn("not used: ", words)

    def test_the_same_images_give_the_same_bytes(self):
        arguments = ["calibrate", "mounting", *sorted((VIDEO / "still").glob("straight*.jpg")), "--camera", CAMERA,
                     "--lane-width-m", 3.66, "-o"]
        self.succeed(*arguments, "a.yaml")
        self.succeed(*arguments, "b.yaml")
        self.assertEqual(self.bytes_of("a.yaml"), self.bytes_of("b.yaml"))


class WrongUse(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "text.jpg").write_text("no image")
        (cls.folder / "there.yaml").write_text("there already")
        (cls.folder / "bad.yaml").write_text(CAMERA.read_text().replace("fx_px: 1160", "fx_px: -3"))

    def test_images_that_are_none(self):
        self.refuse(3, "calibrate", "chessboard", "text.jpg", "-o", "x.yaml", naming="text.jpg: cannot be read")
        self.refuse(3, "calibrate", "chessboard", "nowhere.jpg", naming="nowhere.jpg")
        self.refuse(3, "calibrate", "mounting", "text.jpg", "--camera", CAMERA, "--lane-width-m", 3.5,
                    naming="text.jpg")

    def test_a_bad_camera_is_named_by_line_and_key(self):
        self.refuse(2, "calibrate", "mounting", "text.jpg", "--camera", "bad.yaml", "--lane-width-m", 3.5,
                    naming="bad.yaml:11: 'lens.fx_px'")
        self.refuse(2, "calibrate", "mounting", "text.jpg", "--camera", "nowhere.yaml", "--lane-width-m", 3.5,
                    naming="nowhere.yaml")

    def test_patterns_and_widths_out_of_range(self):
        for pattern in ("9", "9x", "2x9", "9x6x2", "axb", "-9x6"):
            self.refuse(2, "calibrate", "chessboard", "text.jpg", f"--pattern={pattern}", naming="--pattern")
        self.refuse(2, "calibrate", "mounting", "text.jpg", "--camera", CAMERA, "--lane-width-m", 0,
                    naming="--lane-width-m")

    def test_nothing_is_overwritten_unasked(self):
        self.refuse(2, "calibrate", "chessboard", "text.jpg", "-o", "there.yaml", naming="--force")

    def test_what_is_missing_is_named(self):
        self.refuse(2, "calibrate", naming="subcommand")
        self.refuse(2, "calibrate", "chessboard", naming="images")
        self.refuse(2, "calibrate", "mounting", "text.jpg", naming="--camera")


if __name__ == "__main__":
    program.main()
