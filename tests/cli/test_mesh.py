"""The mesh doctor as a user meets it: text and JSON, options, files that are wrong or endless."""

import json
import os
import resource
import struct
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
from test_picture import Image

CORNERS = [(x, y, z) for z in (0, 250) for x, y in ((0, 0), (1000, 0), (1000, 500), (0, 500))]
FACETS = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4),
          (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7)]


def stl(facets, solid="box"):
    lines = [f"solid {solid}"]
    for facet in facets:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {} {} {}".format(*CORNERS[corner]) for corner in facet]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, f"endsolid {solid}"]) + "\n"


class Mesh(clod.Case):

    def mesh(self, *arguments, code=0, **more):
        done = clod.run("mesh", *arguments, cwd=self.folder, **more)
        self.assertEqual(done.returncode, code, done.stderr)
        if code != 0:
            self.assertEqual(done.stdout, "")
            self.assertTrue(done.stderr.startswith("clod mesh: "), done.stderr)
        return done.stderr if code != 0 else done.stdout

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)

    def test_a_box(self):
        """1 m by 0.5 m by 0.25 m, in numbers of mm."""
        self.write("box.stl", stl(FACETS, "hood and spoon"))
        said = self.mesh("box.stl", "--unit", "mm")
        for text in ("box.stl: 12 facets, 8 vertices, 1 unconnected piece, closed",
                     "area     1.75 m2", "volume   0.125 m3", "6 flat, 12 convex, 0 concave",
                     "12  hood and spoon", "nothing of what clod looks for"):
            self.assertIn(text, said)
        self.assertRegex(said, r"x +0 +1 +1 +1000\n")
        self.assertNotIn("Warnings", said)

    def test_a_picture_of_it(self):
        """From above the upper side of the box: the facet at the lower right, which came twice, has the
        colour of that, orange; the one at the upper left is good, a light grey."""
        self.write("box.stl", stl([*FACETS, FACETS[2]]))
        said = self.mesh("box.stl", "--unit=mm", "--picture=box.png", "--view=top",
                         "--size=500x300")
        self.assertIn("1 facet with the corners of another", said)
        image = Image(self.path("box.png"))
        self.assertEqual((image.width, image.height), (500, 300))
        top = int(3.6 * min(image.height / 40, image.width / 52)) # below title and size
        body = [(x, y) for y in range(top + 10, 260) for x in range(330)
                if image.pixel(x, y) != (255, 255, 255)]
        left, right = min(x for x, _ in body), max(x for x, _ in body)
        upper = min(y for x, y in body if x == (left + right) // 2)
        lower = max(y for x, y in body if x == (left + right) // 2)
        at = lambda u, v: image.pixel(int(left + u * (right - left)), int(upper + v * (lower - upper)))
        r, _, b = at(0.75, 0.7)
        self.assertGreater(r, b + 80)
        r, _, b = at(0.25, 0.3)
        self.assertLess(abs(r - b), 40)
        for option, word in (("--size=1x1", "pixels"), ("--view=back", "oblique"),
                             ("--picture=a.jpg", "--picture a.jpg: pictures are PNG; let the name end in .png")):
            self.assertIn(word, self.mesh("box.stl", "--unit=mm", option, code=2))
        self.assertIn("nowhere/box.png", self.mesh("box.stl", "--unit=mm",
                                                   "--picture=nowhere/box.png", code=1))

    def test_parts_left_out_of_a_picture(self):
        """Two squares side by side from above; without the right one the left one fills the picture."""
        self.write("two.obj", "o left\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"
                              "o right\nv 3 0 0\nv 4 0 0\nv 4 1 0\nv 3 1 0\nf 5 6 7\nf 5 7 8\n")
        drawn = ("two.obj", "--unit=m", "--picture=out.png", "--view=top", "--size=500x300")

        def height():
            image = Image(self.path("out.png"))
            rows = [y for y in range(40, 260) if any(image.pixel(x, y) != (255, 255, 255) for x in range(20, 300, 5))]
            return len(rows)
        self.mesh(*drawn)
        both = height()
        self.mesh(*drawn, "--hide=right")
        self.assertGreater(height(), 1.5 * both)
        self.assertIn("--hide middle: the mesh has no such part. Parts: left, right.",
                      self.mesh(*drawn, "--hide=middle", code=2))
        self.assertIn("nothing is left to draw", self.mesh(*drawn, "--hide=left", "--hide=right", code=2))

    def test_marked_edges_of_a_picture(self):
        """Open edges as cyan lines, those on a T as magenta ones (docs/meshes.md).

        A square of 1 m in two triangles, from above: a frame of open edges, nothing on the diagonal. A triangle
        whose lower edge has a vertex of the two below inside: that edge is on a T.
        """
        def drawn(name, text, *options):
            """Cyan and magenta pixels of the image, and then of the legend."""
            self.write(name, text)
            self.mesh(name, "--unit=m", "--picture=out.png", "--view=top", "--size=500x300", *options)
            image = Image(self.path("out.png"))
            cyan, magenta = [], []
            for x in range(500):
                for y in range(300):
                    r, g, b = image.pixel(x, y)
                    cyan += [(x, y)] if min(g, b) > r + 50 else []
                    magenta += [(x, y)] if min(r, b) > g + 60 else []
            return [[p for p in of if (p[0] < 350) == shown] for shown in (True, False) for of in (cyan, magenta)]

        square = "o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"
        frame, line, legend, t_legend = drawn("square.obj", square)
        self.assertTrue(legend)
        self.assertEqual((line, t_legend), ([], []))
        left, right = min(x for x, _ in frame), max(x for x, _ in frame)
        upper, lower = min(y for _, y in frame), max(y for _, y in frame)
        self.assertLessEqual(abs((right - left) - (lower - upper)), 3)
        self.assertGreater(right - left, 100)
        for x, y in frame: # every marked pixel is on the frame
            self.assertLessEqual(min(x - left, right - x, y - upper, lower - y), 3)
        for x in range(left, right + 1): # and the frame has no gap
            self.assertTrue(any((x, upper + d) in frame for d in range(4)), x)
        # the second square is hidden, and its edges with it
        two = square + "o b\nv 2 0 0\nv 3 0 0\nv 3 1 0\nv 2 1 0\nf 5 6 7\nf 5 7 8\n"
        self.assertEqual(drawn("two.obj", two, "--hide=b")[0], frame)
        # vertex 4 lies inside the edge from 1 to 2; the other edges are open
        outline, line, legend, t_legend = drawn("t.obj", "v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 0 0\nv 0.5 -1 0\n"
                                                "v 1.5 -1 0\nf 1 2 3\nf 1 5 4\nf 4 6 2\nf 4 5 6\n")
        self.assertTrue(legend and t_legend)
        self.assertLessEqual(max(y for _, y in line) - min(y for _, y in line), 4)
        width = max(x for x, _ in outline) - min(x for x, _ in outline)
        self.assertLessEqual(abs(max(x for x, _ in line) - min(x for x, _ in line) - width), 6)
        # a closed box has none
        self.assertEqual(drawn("box.stl", stl(FACETS)), [[], [], [], []])

    def test_one_is_not_many(self):
        """A needle of 1.012 km: one facet of each kind, and a length without a power of ten."""
        self.write("one.obj", "v 0 0 0\nv 1012 0 0\nv 1012 1 0\nf 1 2 3\n")
        said = self.mesh("one.obj", "--unit=m")
        for text in ("1 facet, 3 vertices", "1 needle, one edge", "The mesh is 1012 m long"):
            self.assertIn(text, said)

    def test_json(self):
        """The second side is missing, a facet comes twice."""
        self.write("box.stl", stl([*FACETS[:2], *FACETS[4:], FACETS[7]]))
        told = json.loads(self.mesh("box.stl", "--unit", "in", "--grain-radius=5 mm", "--json"))
        self.assertAlmostEqual(told["box_max_m"][0], 25.4, places=12)
        self.assertIsNone(told["volume_m3"])
        self.assertEqual((told["facets_read"], told["facets"], told["closed"]), (11, 10, False))
        self.assertEqual(told["edges"], {"flat": 5, "convex": 8, "concave": 0, "open": 4, "t": 0,
                                         "nonmanifold": 0})
        kinds = {found["kind"]: found for found in told["findings"]}
        self.assertEqual(sorted(kinds), ["duplicate_facets", "open_edges"])
        self.assertEqual(kinds["duplicate_facets"]["action"], "dropped")
        self.assertEqual(kinds["duplicate_facets"]["first"][0]["facet"], 11)
        self.assertEqual(kinds["duplicate_facets"]["first"][0]["part"], "box")
        self.assertEqual(kinds["open_edges"]["count"], 4)
        self.assertEqual(told["parts"], [{"name": "box", "facets": 10}])
        self.assertEqual(len(told["warnings"]), 1)
        # 25.4 m; diameters of 10 mm: 10 to 1000 of them are 0.1 to 10 m
        self.assertIn("2540 grain diameters", told["warnings"][0])
        self.assertIn("plausible in: cm, mm.", told["warnings"][0])

    def test_facets_against_grains(self):
        self.write("box.stl", stl(FACETS))
        said = self.mesh("box.stl", "--unit=mm", "--grain-radius=0.6 m")
        self.assertIn("grain    of radius 600 mm: 4 facets are smaller than it", said)
        self.assertIn("4 of 12 facets are smaller than the radius of a grain", said)

    def test_what_the_options_say(self):
        self.write("box.stl", stl(FACETS))
        self.assertIn("which unit do the numbers have?",
                      clod.run("mesh", "box.stl", cwd=self.folder).stderr)
        self.assertIn("which mesh file?", clod.run("mesh", "--unit=mm").stderr)
        self.assertIn("one mesh at a time", clod.run("mesh", "a.stl", "b.stl").stderr)
        self.assertIn("clod mesh: --unit kg: ", self.mesh("box.stl", "--unit=kg", code=2))
        for radius, wrong in (("3", "3 needs a unit of length"), ("-3mm", "a length above 0 is expected")):
            self.assertIn(f"clod mesh: --grain-radius {radius}: {wrong}",
                          self.mesh("box.stl", "--unit=mm", f"--grain-radius={radius}", code=2))

    def test_files_that_are_wrong(self):
        self.write("cut.stl", b"\0" * 80 + struct.pack("<I", 12) + b"\0" * 500)
        self.assertIn("cut.stl: the header announces 12 facets",
                      self.mesh("cut.stl", "--unit=mm", code=2))
        self.write("nan.obj", "v 0 0 nan\n")
        self.assertIn('nan.obj:1: "nan"', self.mesh("nan.obj", "--unit=mm", code=2))
        self.write("empty.ply", "")
        self.assertIn("empty.ply: the file is empty", self.mesh("empty.ply", "--unit=mm", code=2))
        os.mkdir(self.path("folder.stl"))
        self.assertIn("folder.stl: cannot be read: Is a directory",
                      self.mesh("folder.stl", "--unit=mm", code=2))
        self.assertIn("none.stl: cannot be opened: No such file",
                      self.mesh("none.stl", "--unit=mm", code=2))
        if os.geteuid() != 0:
            self.write("closed.stl", stl(FACETS))
            os.chmod(self.path("closed.stl"), 0)
            self.assertIn("you have no right to read it",
                          self.mesh("closed.stl", "--unit=mm", code=2))

    def test_no_memory_goes_into_what_is_refused(self):
        """With 300 MB of address space: an endless file, a huge one, one that promises much."""
        if clod.SANITIZED:
            self.skipTest("the sanitizers need more address space than that")
        with open(self.path("huge.stl"), "wb") as file:
            file.truncate(5 * 10**9)
        os.symlink("/dev/zero", self.path("endless.stl"))
        os.mkfifo(self.path("pipe.obj"))
        self.write("promise.ply", "ply\nformat binary_little_endian 1.0\n"
                   "element vertex 2000000000\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 2000000000\n"
                   "property list uchar int vertex_indices\nend_header\n")
        for name, text in (("huge.stl", "the file has 5 GB; 2 GB are read at most: take a coarser one, or split it"),
                           ("endless.stl", "it is no regular file"),
                           ("pipe.obj", "it is no regular file"),
                           ("promise.ply", "this cannot be how many there are")):
            said = self.mesh(name, "--unit=mm", code=2, timeout=60, preexec_fn=lambda:
                             resource.setrlimit(resource.RLIMIT_AS, (300 << 20, 300 << 20)))
            self.assertIn(text, said)


if __name__ == "__main__":
    clod.main()
