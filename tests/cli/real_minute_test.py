# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A real minute of comma2k19 from its arrays to its score: radar and odometry alone carry the road's course."""

import program

MINUTE = program.real_data("comma2k19")


@program.needs(MINUTE)
class RealMinute(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.imported = cls.succeed("import", "comma2k19", MINUTE, "-o", "drive.mcap")
        cls.ran = cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.judged = cls.succeed("evaluate", "lanes.mcap", "--truth", "ego-path")

    def entry(self, entries, distance):
        return next(entry for entry in entries if entry["distance_m"] == distance)

    def test_the_witness_rule_is_set_openly(self):
        self.assertEqual(self.imported["witness"], "radar_only")
        self.assertEqual(self.ran["witness"], "radar_only")
        self.assertEqual(self.judged["witness"], "radar_only")
        said = self.call("run", "drive.mcap", "-o", "lanes.mcap", "--force").stderr
        self.assertIn("witness: radar_only", said)

    def test_the_whole_minute_is_fused(self):
        self.assertGreater(self.ran["duration_s"], 59)
        self.assertEqual(self.ran["cycles"], self.judged["cycles"])

    def test_lanes_beat_the_arc_of_the_yaw_rate(self):
        for distance in (60, 80, 100):
            lanes = self.entry(self.judged["lanes"]["ego"], distance)["rmse_m"]
            # Over all cycles, and over those alone in which there was a lane.
            for baseline in ("arc", "arc_where_available"):
                self.assertLess(lanes, self.entry(self.judged["baselines"][baseline], distance)["rmse_m"])

    def test_lanes_are_near_the_driven_path(self):
        self.assertLessEqual(self.entry(self.judged["lanes"]["ego"], 100)["rmse_m"], 0.6)

    def test_lanes_are_there_while_a_vehicle_is_ahead(self):
        ahead = self.entry(self.judged["availability_with_vehicle_ahead"], 60)
        self.assertGreaterEqual(ahead["availability"], 0.9)
        self.assertGreater(ahead["cycles"], 600)

    def test_without_truth_the_lanes_are_the_same(self):
        self.succeed("strip", "drive.mcap", "-o", "stripped.mcap")
        self.succeed("run", "stripped.mcap", "-o", "blind.mcap")
        self.assertEqual(self.bytes_of("blind.mcap"), self.bytes_of("lanes.mcap"))

    def test_its_tracks_make_the_picture_in_the_docs(self):
        drawn = self.succeed("plot", "lanes.mcap", "--tracks", "-o", "tracks.svg")
        self.assertGreater(drawn["duration_s"], 59)
        self.assertLessEqual(drawn["witnesses"], drawn["tracks"])
        picture = self.bytes_of("tracks.svg")
        self.assertLess(len(picture), 150_000)
        # The vehicle on the lane to the right keeps its id for the whole minute.
        self.assertIn(b": 60 s<", picture)


if __name__ == "__main__":
    program.main()
