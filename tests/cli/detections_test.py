# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""simulate --detections: radars and an object camera in the recording instead of object lists."""

import mcap_parts
import program

US101 = program.real_data("commonroad") / "USA_US101-4_1_T-1.xml"


class Detections(program.ProgramTest):
    def topics(self, name):
        return mcap_parts.topics(self.bytes_of(name))

    def test_radars_and_boxes_are_recorded_instead_of_objects(self):
        self.simulate("lists.mcap", 0.2)
        self.assertIn("/in/objects", self.topics("lists.mcap"))
        self.assertNotIn("/in/radar", self.topics("lists.mcap"))
        done = self.simulate("drive.mcap", 0.2, "--detections")
        self.assertTrue(done["drive"].endswith(", detections"))
        self.assertIn("/in/radar", self.topics("drive.mcap"))
        self.assertIn("/in/camera_boxes", self.topics("drive.mcap"))
        self.assertNotIn("/in/objects", self.topics("drive.mcap"))

    def test_the_same_seed_gives_the_same_bytes(self):
        self.simulate("one.mcap", 0.2, "--detections")
        self.simulate("two.mcap", 0.2, "--detections")
        self.simulate("mirrors.mcap", 0.2, "--detections", "--guard-rail-mirrors", 20)
        self.assertEqual(self.bytes_of("one.mcap"), self.bytes_of("two.mcap"))
        self.assertGreater(len(self.bytes_of("mirrors.mcap")), len(self.bytes_of("one.mcap")))

    def test_no_objects_leaves_them_out(self):
        self.simulate("none.mcap", 0.2, "--detections", "--no-objects")
        self.assertNotIn("/in/radar", self.topics("none.mcap"))
        self.assertNotIn("/in/camera_boxes", self.topics("none.mcap"))

    def test_mirrors_are_a_few_and_of_detections(self):
        self.refuse(2, "simulate", "--km", 0.2, "--detections", "--guard-rail-mirrors", 51, "-o", "x.mcap",
                    naming="--guard-rail-mirrors")
        self.refuse(2, "simulate", "--km", 0.2, "--guard-rail-mirrors", 5, "-o", "x.mcap", naming="--detections")


@program.needs(US101)
class RecordedDetections(program.ProgramTest):
    def test_recorded_traffic_is_seen_by_radars_too(self):
        done = self.succeed("simulate", "--commonroad", US101, "--detections", "--guard-rail-mirrors", 5, "-o",
                            "drive.mcap")
        self.assertIn("up to 5 guard-rail mirrors", done["drive"])
        topics = mcap_parts.topics(self.bytes_of("drive.mcap"))
        self.assertIn("/in/radar", topics)
        self.assertNotIn("/in/objects", topics)


if __name__ == "__main__":
    program.main()
