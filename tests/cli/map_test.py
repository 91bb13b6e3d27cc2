# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""Maps: what they hold is said, every format can be made of every other, and bad ones are refused by line and element."""

import json

import program

ROAD = """<?xml version="1.0"?>
<OpenDRIVE>
<header revMajor="1" revMinor="6" name="short"/>
<road id="1" length="100" junction="-1">
<planView>
<geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry>
</planView>
<lanes><laneSection s="0">
<center><lane id="0" type="none"><roadMark sOffset="0" type="solid" color="white"/></lane></center>
<right>
<lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/>
<roadMark sOffset="0" type="broken" color="white"/></lane>
<lane id="-2" type="shoulder"><width sOffset="0" a="2.5" b="0" c="0" d="0"/></lane>
</right>
</laneSection></lanes>
</road>
</OpenDRIVE>
"""


class Maps(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "road.xodr").write_text(ROAD)

    def test_info_says_what_is_there(self):
        info = self.succeed("map", "info", "road.xodr")
        self.assertEqual(info["name"], "short")
        self.assertIsNone(info["origin"])
        self.assertEqual([lane["kind"] for lane in info["lanes"]], ["driving", "emergency"])
        self.assertAlmostEqual(info["lanes"][0]["length"], 100, places=6)
        self.assertAlmostEqual(info["lanes"][0]["width_min"], 3.5, places=6)
        self.assertEqual(info["lanes"][0]["right_lane"], info["lanes"][1]["id"])
        self.assertEqual(len(info["boundaries"]), 3)
        self.assertEqual(info["boundaries"][1]["styles"][0]["type"], "dashed")

    def test_info_in_words(self):
        words = self.call("map", "info", "road.xodr").stdout
        self.assertIn("short: 2 lanes, 3 boundaries", words)
        self.assertIn("origin unknown", words)

    def test_formats_follow_one_another(self):
        before = self.succeed("map", "info", "road.xodr")
        last = "road.xodr"
        for ending in ("osm", "geojson", "xodr", "geojson", "osm"):
            self.succeed("map", "convert", last, "-o", f"next.{ending}", "--origin", "48.25,11.5", "--force")
            last = f"next.{ending}"
        after = self.succeed("map", "info", last)
        self.assertAlmostEqual(after["origin"]["latitude_deg"], 48.25, places=9)
        for lane, other in zip(before["lanes"], after["lanes"], strict=True):
            self.assertEqual(lane["kind"], other["kind"])
            self.assertAlmostEqual(lane["width_max"], other["width_max"], places=2)
        styles = [[b["styles"][0]["type"] for b in info["boundaries"]] for info in (before, after)]
        self.assertEqual(*styles)

    def test_geojson_lies_where_the_origin_is(self):
        self.succeed("map", "convert", "road.xodr", "-o", "place.geojson", "--origin", "48.25,-11.5")
        features = json.loads((self.folder / "place.geojson").read_text())["features"]
        longitude, latitude = features[0]["geometry"]["coordinates"][0][:2]
        self.assertAlmostEqual(longitude, -11.5, places=6)
        self.assertAlmostEqual(latitude, 48.25, places=6)

    def test_the_same_map_gives_the_same_bytes(self):
        self.succeed("map", "convert", "road.xodr", "-o", "a.osm")
        self.succeed("map", "convert", "road.xodr", "-o", "b.osm")
        self.assertEqual(self.bytes_of("a.osm"), self.bytes_of("b.osm"))


class WrongUse(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "road.xodr").write_text(ROAD)
        (cls.folder / "bad.xodr").write_text(ROAD.replace('a="3.5"', 'a="wide"'))
        (cls.folder / "there.osm").write_text("mine")

    def test_bad_maps_are_refused_by_line_and_element(self):
        self.refuse(3, "map", "info", "bad.xodr", naming="bad.xodr, line 11, <lane id=-1>/<width>")
        self.refuse(3, "map", "convert", "bad.xodr", "-o", "x.osm", naming="line 11")
        self.refuse(3, "map", "info", "none.xodr", naming="none.xodr")

    def test_a_place_is_needed_for_geojson(self):
        self.refuse(3, "map", "convert", "road.xodr", "-o", "x.geojson", naming="--origin LAT,LON")

    def test_wrong_use(self):
        self.refuse(2, "map", naming="subcommand")
        self.refuse(2, "map", "info", "road.kml", naming=".xodr")
        self.refuse(2, "map", "convert", "road.xodr", "-o", "x.xml", naming=".osm")
        self.refuse(2, "map", "convert", "road.xodr", "-o", "there.osm", naming="--force")
        self.refuse(2, "map", "convert", "road.xodr", "-o", "road.xodr", "--force", naming="is the input")
        for origin in ("48", "48,11,3", "91,0", "north"):
            self.refuse(2, "map", "convert", "road.xodr", "-o", "x.osm", "--origin", origin, naming="is no place")


REAL = program.real_data("commonroad")


@program.needs(REAL)
class RealMaps(program.ProgramTest):
    def test_every_scenario_becomes_every_format(self):
        for path in sorted(REAL.glob("*.xml")):
            before = self.succeed("map", "info", path)
            for ending in ("xodr", "osm", "geojson"):
                name = f"{path.stem}.{ending}"
                self.succeed("map", "convert", path, "-o", name, "--origin", "48.25,11.5")
                after = self.succeed("map", "info", name)
                self.assertEqual(len(after["lanes"]), len(before["lanes"]), name)
                self.assertEqual(len(after["boundaries"]), len(before["boundaries"]), name)


if __name__ == "__main__":
    program.main()
