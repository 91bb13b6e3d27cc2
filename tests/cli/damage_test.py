# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""A damaged drive: what is sound of it is fused and kept, the rest is named and counted, and the exit status is 3."""

import json

import mcap_parts
import program


class Damage(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.simulate(km=0.5)
        cls.succeed("run", "drive.mcap", "-o", "lanes.mcap")
        cls.drive = cls.bytes_of("drive.mcap")
        cls.whole = mcap_parts.chunks(cls.bytes_of("lanes.mcap"))

    def run_damaged(self, data):
        """The result of fusing a damaged drive, or None where nothing of it could be fused."""
        for name in ("saved.mcap", "saved.mcap.run.json"):
            (self.folder / name).unlink(missing_ok=True)
        (self.folder / "damaged.mcap").write_bytes(data)
        done = self.call("run", "damaged.mcap", "-o", "saved.mcap", "--json")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("damaged.mcap", done.stderr)
        self.assertEqual(list(self.folder.glob("*.part")), [])
        self.assertEqual((self.folder / "saved.mcap").exists(), done.stdout != "")
        return json.loads(done.stdout) if done.stdout else None

    def test_a_drive_cut_off_anywhere_is_refused_or_saved(self):
        size = len(self.drive)
        cuts = [1, 7, 8, 9, 100, 1000, size // 10, size // 3, size // 2, size - 2000, size - 100, size - 9, size - 1]
        saved = [self.run_damaged(self.drive[:cut]) for cut in cuts]
        cycles = [result["cycles"] if result else 0 for result in saved]
        self.assertEqual(cycles, sorted(cycles), "a longer rest gave fewer cycles")
        self.assertEqual(cycles[0], 0)
        self.assertGreater(cycles[-1], 100)

    def test_cycles_before_the_cut_are_those_of_the_whole_drive(self):
        places = mcap_parts.input_chunks(self.drive)
        begin, end = places[len(places) // 2]
        self.run_damaged(self.drive[:(begin + end) // 2])
        saved = mcap_parts.chunks(self.bytes_of("saved.mcap"))
        self.assertGreater(len(saved), 3)
        self.assertLess(len(saved), len(self.whole))
        # The last two chunks hold the cut's own second and the end of the one before.
        self.assertEqual(saved[:-2], self.whole[:len(saved) - 2])

    def test_an_altered_byte_costs_its_chunk_and_no_more(self):
        begin, end = mcap_parts.input_chunks(self.drive)[4]
        altered = bytearray(self.drive)
        altered[(begin + end) // 2] ^= 0x40
        result = self.run_damaged(bytes(altered))
        self.assertAlmostEqual(result["cycles"], self.succeed("run", "drive.mcap", "-o", "again.mcap", "--force")["cycles"],
                               delta=15)

    def test_what_was_lost_is_counted(self):
        begin, end = mcap_parts.input_chunks(self.drive)[4]
        altered = self.drive[:begin + 60] + bytes([self.drive[begin + 60] ^ 1]) + self.drive[begin + 61:]
        (self.folder / "altered.mcap").write_bytes(altered)
        done = self.call("run", "altered.mcap", "-o", "counted.mcap", "--force")
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stderr, r"1 chunks?.* lost")

    def test_bytes_altered_anywhere_crash_nothing(self):
        for step in range(1, 40):
            at = step * len(self.drive) // 40
            altered = bytearray(self.drive)
            altered[at] ^= 0xFF
            (self.folder / "altered.mcap").write_bytes(altered)
            done = self.call("run", "altered.mcap", "-o", "altered_lanes.mcap", "--force")
            # Damage in the truth or in an index is none to a run, which opens neither.
            self.assertIn(done.returncode, (0, 3), f"byte {at}: {done.stderr}")

    def test_damaged_lanes_are_not_judged(self):
        lanes = bytearray(self.bytes_of("lanes.mcap"))
        lanes[len(lanes) // 2] ^= 0xFF
        (self.folder / "damaged_lanes.mcap").write_bytes(lanes)
        self.refuse(3, "evaluate", "damaged_lanes.mcap", "--truth", "exact", "--drive", "drive.mcap", "-o", "x.html",
                    naming="damaged_lanes.mcap")

    def test_a_damaged_drive_is_not_stripped(self):
        (self.folder / "cut.mcap").write_bytes(self.drive[:len(self.drive) // 2])
        self.refuse(3, "strip", "cut.mcap", "-o", "x.mcap", naming="cut.mcap")


if __name__ == "__main__":
    program.main()
