# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Input that is no drive, or none that this program can read: exit status 3, the place named, nothing left behind."""

import mcap_parts
import program

METADATA = {
    "schema_version": "1.0",
    "kind": "drive",
    "frame": "ISO 8855, origin at road height under the middle of the front axle",
    "marking_reference": "centre line",
    "drive": "made by hand",
    "preset_hash": "",
    "witness": "radar_and_camera",
}


class NotADrive(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate()
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")

    def write(self, name, data):
        (self.folder / name).write_bytes(data)

    def refuse_everywhere(self, name, naming):
        self.refuse(3, "run", name, "-o", "x.mcap", naming=naming)
        self.refuse(3, "run", name, "-o", "x.mcap", "--json", naming=naming)
        self.refuse(3, "strip", name, "-o", "x.mcap", naming=naming)
        self.refuse(3, "plot", name, "-o", "x.svg", naming=naming)
        self.refuse(3, "evaluate", name, "--truth", "exact", "-o", "x.html", naming=naming)

    def test_files_that_are_no_recording(self):
        self.write("empty.mcap", b"")
        self.write("text.mcap", b"hello\n" * 100)
        self.write("magic.mcap", mcap_parts.MAGIC)
        self.write("zeros.mcap", bytes(5000))
        for name in ("empty.mcap", "text.mcap", "magic.mcap", "zeros.mcap", "nowhere.mcap"):
            self.refuse_everywhere(name, naming=name)

    def test_lanes_are_no_drive_and_a_drive_is_no_lanes(self):
        self.refuse(3, "run", "lanes.mcap", "-o", "x.mcap", naming="kind")
        self.refuse(3, "strip", "lanes.mcap", "-o", "x.mcap", naming="kind")
        self.refuse(3, "plot", "drive.mcap", "-o", "x.svg", naming="kind")
        self.refuse(3, "evaluate", "drive.mcap", "--truth", "exact", "-o", "x.html", naming="kind")

    def test_a_missing_channel_is_named(self):
        self.write("bare.mcap", mcap_parts.recording_without_channels(METADATA))
        self.refuse(3, "run", "bare.mcap", "-o", "x.mcap", naming="/in/")

    def test_what_the_metadata_must_say(self):
        for key, value, naming in [("schema_version", "9.0", "9.0"), ("kind", "song", "song"),
                                   ("frame", "rear axle", "frame"), ("marking_reference", "inner edge", "marking_reference"),
                                   ("witness", "hearsay", "witness"), ("schema_version", "new", "schema_version")]:
            self.write("other.mcap", mcap_parts.recording_without_channels({**METADATA, key: value}))
            self.refuse(3, "run", "other.mcap", "-o", "x.mcap", naming=naming)

    def test_a_drive_of_another_run_is_refused(self):
        self.succeed("simulate", "--seed", 2, "--km", 0.3, "-o", "other_drive.mcap", "--force")
        self.refuse(2, "evaluate", "lanes.mcap", "--truth", "exact", "-o", "x.html", "--drive", "other_drive.mcap",
                    naming="other_drive.mcap")

    def test_truth_that_is_not_there(self):
        self.succeed("strip", "drive.mcap", "-o", "stripped.mcap", "--force")
        for truth in ("exact", "ego-path"):
            self.refuse(3, "evaluate", "lanes.mcap", "--truth", truth, "--drive", "stripped.mcap", "-o", "x.html",
                        naming="truth")

    def test_graphs_that_are_none(self):
        for text, naming in [("", "no graph"), ("hello\n", "broken.g2o:1"), ("VERTEX_SE2 0 0 0\n", "broken.g2o:1"),
                             ("VERTEX_SE2 0 0 0 nan\n", "broken.g2o:1")]:
            self.write("broken.g2o", text.encode())
            self.refuse(3, "graph", "solve", "broken.g2o", "-o", "x.g2o", naming=naming)
        self.refuse(3, "graph", "solve", "nowhere.g2o", naming="nowhere.g2o")

    def test_folders_that_hold_no_data_set(self):
        (self.folder / "nothing").mkdir(exist_ok=True)
        self.refuse(3, "import", "comma2k19", "nothing", "-o", "x.mcap", naming="nothing")
        self.refuse(3, "import", "comma2k19", "nowhere", "-o", "x.mcap", naming="nowhere")


if __name__ == "__main__":
    program.main()
