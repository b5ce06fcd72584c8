"""The 3-D view of a page: grains in the colours of each field of the snapshot, walls of a mesh, a cut.

Skipped where there is no browser, or clod was built without the scripts of its pages.
"""

import array
import base64
import json
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from browser import BrowserCase
from pages import clod

# a floor and four sides, two triangles each [mm]
TUB = """v 0 0 0
v 40 0 0
v 40 40 0
v 0 40 0
v 0 0 50
v 40 0 50
v 40 40 50
v 0 40 50
""" + "".join(f"f {a} {b} {c}\nf {a} {c} {d}\n" for a, b, c, d in
              ((1, 2, 3, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)))
TRIANGLES = 10
CASE = """title: Grains in a tub
materials: {ore: {density: 2500 kg/m3}, steel: {}}
contacts: {default: {law: hooke, k1: 2e3 N/m, restitution: 0.3, friction: 0.5}}
time: {design_stress: 500 Pa}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
domain: {min: [-10 mm, -10 mm, -10 mm], max: [50 mm, 50 mm, 100 mm]}
grains: [{material: ore, count: 100, radius: {distribution: uniform, min: 2 mm, max: 4 mm}, region: {box: {min: [1 mm, 1 mm, 1 mm], max: [39 mm, 39 mm, 90 mm]}}}]
walls: {tub: {material: steel, shapes: [{mesh: {file: tub.obj, unit: 1 mm}}]}}
stages: [{name: fall, duration: 120 ms}]
output: {snapshot_interval: 60 ms}
"""
# Moves the slides and the list as a user does, and counts the pixels of the picture that change.
MOVES = """
  const view = document.querySelector(".view"), canvas = view.querySelector("canvas");
  const {width, height} = canvas;
  const shot = () => {
    const copy = Object.assign(document.createElement("canvas"), {width, height}).getContext("2d");
    copy.drawImage(canvas, 0, 0);
    return copy.getImageData(0, 0, width, height).data;
  };
  const isOther = (a, b, k) => Math.max(...[0, 1, 2].map(c => Math.abs(a[k + c] - b[k + c]))) > 4;
  const changed = (a, b, inside = () => true) => {
    let count = 0;
    for (let k = 0; k < a.length; k += 4) count += isOther(a, b, k) && inside(k / 4 % width) ? 1 : 0;
    return count;
  };
  const move = (name, value) => {
    const slide = [...view.querySelectorAll("label")].find(label => label.textContent.startsWith(name))?.querySelector("input");
    if (!slide) return; // nothing changes then
    slide.value = value;
    slide.dispatchEvent(new Event("input"));
  };
  const first = shot();
  move("walls", 0);
  const bare = shot();
  const select = view.querySelector("select");
  const choose = k => { select.value = k; select.dispatchEvent(new Event("change")); return shot(); };
  const pictures = [...select.options].map((_, k) => choose(k));
  const ends = [...select.options].map((_, k) => { choose(k); return [...view.querySelectorAll(".ramp span")].map(end => end.textContent); });
  const back = choose(0);
  move("cut", 500);
  const half = shot();
  const colour = picture => {
    const sum = [0, 0, 0];
    for (let k = 0; k < picture.length; k += 4) {
      if (Math.min(picture[k], picture[k + 1], picture[k + 2]) < 250) [0, 1, 2].forEach(c => { sum[c] += picture[k + c]; });
    }
    return sum;
  };
  return {
    pixels: width * height, names: [...select.options].map(option => option.textContent),
    left: changed(first, bare, x => x < width / 3), right: changed(first, bare, x => x > 2 * width / 3),
    changes: pictures.map(a => pictures.map(b => changed(a, b))), sums: pictures.map(colour), ends,
    back: changed(bare, back), half: changed(bare, half),
  };
"""


def numbers(packed, count):
    """What the page has packed in 16 bits each."""
    if "data" not in packed:
        return [float(packed["min"])] * count
    low, high = float(packed["min"]), float(packed["max"])
    return [low + (high - low) * word / 65535 for word in array.array("H", base64.b64decode(packed["data"]))]


def spanned(values):
    """What the ends of the colours stand for: all but the outermost hundredth at either end."""
    line = sorted(values)
    low, high = line[round(0.01 * (len(line) - 1))], line[round(0.99 * (len(line) - 1))]
    return (low, high) if low < high else (line[0], line[-1])


def tones(values):
    """Places on the ramp of colours, 0 to 1."""
    low, high = spanned(values)
    return [min(max((value - low) / (high - low or 1.0), 0.0), 1.0) for value in values]


class View(BrowserCase):

    def test_walls_of_a_mesh_and_colours(self):
        for name, text in (("tub.obj", TUB), ("case.yaml", CASE)):
            with open(self.path(name), "w") as file:
                file.write(text)
        self.go("run")
        self.need_scripts(clod.run("report", self.path("run")))
        seen, _ = self.show("run/report.html", then=MOVES)
        view, = json.loads(seen["views"])
        self.assertEqual((view["grains"], view["triangles"]), (100, 2 * TRIANGLES))  # back sides, then front sides
        tried = json.loads(seen["tried"])
        # the tub is wider than the grains in it: its sides are seen beside them
        for side in ("left", "right"):
            self.assertGreater(tried[side], 0.02 * tried["pixels"], side)
        self.assertGreater(tried["half"], 0.02 * tried["pixels"])
        self.assertEqual(tried["back"], 0)
        self.assert_colours(tried, pages.load(self.path("run/report.html")).views[0]["grains"])

    def test_grains_at_rest(self):
        """Speed colours grains that move; the coordination, or what varies, those that rest: their speed is noise."""
        for name, text in (("tub.obj", TUB), ("case.yaml", CASE)):
            with open(self.path(name), "w") as file:
                file.write(text)
        self.go("run")
        self.need_scripts(clod.run("report", self.path("run")))
        with open(self.path("run/report.html")) as file:
            page = file.read()
        speed = re.search(r'"name":"speed","units":"[^"]*","values":\{"min":([^,]*),"max":([^,]*),', page)
        # a grain of 4 mm that has fallen as far has 0.28 m/s
        for scale, wanted in ((1.0, "speed"), (3e-3 / float(speed[2]), "speed"), (1e-4 / float(speed[2]), "coordination"), (0.0, "coordination")):
            low, high = (repr(scale * float(speed[k])) for k in (1, 2))
            with open(self.path("other.html"), "w") as file:
                file.write(page.replace(speed[0], speed[0].replace(f'"min":{speed[1]},"max":{speed[2]},', f'"min":{low},"max":{high},')))
            seen, _ = self.show("other.html", then='return [...document.querySelector(".view select").selectedOptions].map(option => option.textContent);')
            view, = json.loads(seen["views"])
            self.assertEqual((view["field"], json.loads(seen["tried"])), (wanted, [wanted]), scale)
            self.assertGreater(view["colours"], 50)
        self.go("afloat", "1", "--set", "gravity=[0 m/s2, 0 m/s2, 0 m/s2]")  # no grain touches another
        clod.run("report", self.path("afloat"))
        seen, _ = self.show("afloat/report.html")
        self.assertEqual(json.loads(seen["views"])[0]["field"], "radius")

    def assert_colours(self, tried, grains):
        """Fields whose grains have other places on the ramp give other pictures, those with the same ones the same."""
        fields = {field["name"]: numbers(field["values"], 100) for field in grains["fields"]}
        self.assertEqual(tried["names"], list(fields))
        self.assertTrue({"speed", "radius", "coordination", "type"} <= set(fields))
        places = [tones(values) for values in fields.values()]
        other = same = 0
        for a, one in enumerate(places):
            for b, two in enumerate(places[:a]):
                apart = sum(abs(x - y) for x, y in zip(one, two)) / 100
                changes, where = tried["changes"][a][b], (tried["names"][a], tried["names"][b])
                if apart > 0.15:
                    other += 1
                    self.assertGreater(changes, 0.02 * tried["pixels"], where)
                elif apart == 0.0:
                    same += 1
                    self.assertEqual(changes, 0, where)
        self.assertGreater(other, 10)
        self.assertGreater(same, 0)
        for (name, values), ends, (red, green, blue) in zip(fields.items(), tried["ends"], tried["sums"]):
            for end, value in zip(ends, spanned(values)):
                self.assertAlmostEqual(float(end.split()[0]), value, delta=0.006 * abs(value), msg=name)
            if min(values) == max(values):  # all at the dark end, #440154 in any light
                self.assertAlmostEqual(red / blue, 68 / 84, delta=0.05, msg=name)
                self.assertLess(green / blue, 0.1, name)
            else:
                self.assertGreater(green / blue, 0.2, name)


if __name__ == "__main__":
    clod.unittest.main()
