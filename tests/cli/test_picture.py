"""Pictures of a run as a user meets them: size, colours of grains at their places, colour bar,
frames, movies, two runs side by side, and messages when something is wrong."""

import collections
import os
import shutil
import struct
import sys
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

CASE = """title: {title}
materials: {{ore: {{density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}}}}
contacts: {{default: {{law: hertz, restitution: 0.5, friction: 0.3}}}}
domain: {{min: [-50 mm, -50 mm, -50 mm], max: [50 mm, 50 mm, 50 mm]}}
gravity: [0 m/s2, 0 m/s2, 0 m/s2]
grains: [{{material: ore, file: grains.csv}}]
walls:
  floor: {{material: ore, shapes: [{{plane: {{point: [0 mm, 0 mm, -50 mm], normal: [0, 0, 1]}}}}]}}
stages: [{{name: run, duration: 3 ms}}]
output: {{series_interval: 1 ms, snapshot_interval: 1 ms}}
"""
# x, y, z, radius in mm and vz in m/s; the first is where the camera looks
GRAINS = [(0, 0, 0, 4, 0), (25, 0, 0, 5, 3), (-5, 10, 16, 6, 0), (-20, -5, -10, 3.2, -1)]
CAMERA = ("--from=0,-0.3,0", "--at=0,0,0", "--angle=15", "--size=500x400", "--hide=floor")


def nearest(left, up, corner):
    """Which of the three is nearest to left + up - corner, the first of equals."""
    from_left, from_up, from_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
    if from_left <= from_up and from_left <= from_corner:
        return left
    return up if from_up <= from_corner else corner


# What a filter of a row adds to a byte.
ADDED = (lambda left, up, corner: 0, lambda left, up, corner: left, lambda left, up, corner: up,
         lambda left, up, corner: (left + up) // 2, nearest)


class Image:
    """A PNG of 8 bits per colour, read without other packages (PNG specification, 2nd edition)."""

    def __init__(self, path):
        data = clod.read(path)
        assert data[:8] == b"\x89PNG\r\n\x1a\n", path
        packed, at = b"", 8
        while at < len(data):
            length, kind = struct.unpack(">I4s", data[at:at + 8])
            body = data[at + 8:at + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, colour = struct.unpack(">IIBB", body[:10])
                assert (depth, colour) == (8, 2), "not red, green, blue of 8 bits"
            packed += body if kind == b"IDAT" else b""
            at += length + 12
        self.rows = self.unfilter(zlib.decompress(packed), 3 * self.width)

    def unfilter(self, data, size):
        rows, above = [], bytes(size)
        for start in range(0, self.height * (size + 1), size + 1):
            add = ADDED[data[start]]
            row = bytearray(data[start + 1:start + 1 + size])
            for k in range(3):
                row[k] = (row[k] + add(0, above[k], 0)) & 255
            for k in range(3, size) if data[start] else ():
                row[k] = (row[k] + add(row[k - 3], above[k], above[k - 3])) & 255
            rows.append(row)
            above = row
        return rows

    def pixel(self, x, y):
        return tuple(self.rows[y][3 * x:3 * x + 3])

    def runs(self, x, good):
        """The longest run of rows in column x whose pixels are good: first row and how many."""
        best, first = (0, 0), None
        for y in range(self.height + 1):
            if y < self.height and good(self.pixel(x, y)):
                first = y if first is None else first
            elif first is not None:
                best = max(best, (y - first, first))
                first = None
        return best[1], best[0]


def is_coloured(pixel):
    return max(pixel) - min(pixel) > 40


def find_bar(image):
    """Column in the middle of the colour bar, its first row and number of rows."""
    columns = [x for x in range(image.width * 2 // 3, image.width)
               if image.runs(x, is_coloured)[1] > image.height // 4]
    middle = columns[len(columns) // 2]
    return (middle, *image.runs(middle, is_coloured))


class Picture(clod.Case):

    @classmethod
    def setUpClass(cls):
        cls.out = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.out)
        with open(os.path.join(cls.out, "grains.csv"), "w") as file:
            file.write("x [mm],y [mm],z [mm],radius [mm],vz [m/s]\n")
            file.writelines(",".join(map(str, grain)) + "\n" for grain in GRAINS)
        for name, title in (("one", "One of two"), ("two", "Two of two")):
            path = os.path.join(cls.out, f"{name}.yaml")
            with open(path, "w") as file:
                file.write(CASE.format(title=title))
            done = clod.run("run", path, "-o", os.path.join(cls.out, name))
            assert done.returncode == 0, done.stderr
        cls.results = os.path.join(cls.out, "one")

    def picture(self, *arguments, code=0, **more):
        done = clod.run("picture", *arguments, cwd=self.folder, **more)
        self.assertEqual(done.returncode, code, done.stderr)
        if code != 0:
            self.assertEqual(done.stdout, "")
            self.assertTrue(done.stderr.startswith("clod picture: "), done.stderr)
        return done.stderr if code != 0 else done.stdout

    def image(self, *arguments, name="a.png"):
        self.picture(self.results, "-o", name, *arguments)
        return Image(self.path(name))

    def places(self, image, moved=0.0):
        """Pixels of the grains' middles by a projection of our own: 15 degrees from bottom to top
        of the panel, seen from 0.3 m. Letters are 1/52 of the width high and the panel begins
        below 3.6 of them; its middle is where the first grain is seen."""
        top = int(3.6 * min(image.height / 40, image.width / 52))
        middle_y = (top + image.height) / 2
        scale = (image.height - top) / 2 / 0.13165249758739583  # tan(7.5 degrees)
        row = [x for x in range(image.width) if image.pixel(x, int(middle_y)) != (255, 255, 255)]
        middle_x = row[0] + 0.004 / 0.3 * scale  # the first grain is the one at the left of its row
        found = []
        for x, y, z, _, vz in GRAINS:
            depth = 0.3 + y / 1000
            found.append((int(middle_x + scale * x / 1000 / depth),
                          int(middle_y - scale * (z / 1000 + moved * vz) / depth)))
        return found

    def test_grains_have_the_colours_of_their_values(self):
        """Grey map: lightness of OKLab from 0.30 to 0.92, in equal steps; a grey of lightness L
        has L^3 of the light of white. What faces the eye has the colour of the map."""
        image = self.image("--time=0.001", "--color=radius", "--range=0.003,0.007", "--map=grey",
                           *CAMERA)
        self.assertEqual((image.width, image.height), (500, 400))
        for (x, y), grain in zip(self.places(image, moved=0.001), GRAINS):
            light = (0.30 + 0.62 * (grain[3] - 3) / 4) ** 3
            expected = 255 * (1.055 * light ** (1 / 2.4) - 0.055)
            for channel in image.pixel(x, y):
                self.assertLess(abs(channel - expected), 0.03 * 255, f"grain {grain}")

    def test_grains_have_the_colours_of_the_bar(self):
        image = self.image("--time=0.001", "--color=velocity_z", "--range=-2,4", "--map=sea", *CAMERA)
        middle, first, rows = find_bar(image)
        self.assertGreater(image.pixel(middle, first)[0], image.pixel(middle, first)[2])  # yellow
        low = image.pixel(middle, first + rows - 1)
        self.assertGreater(low[2], low[0])  # blue
        for (x, y), grain in zip(self.places(image, moved=0.001), GRAINS):
            row = first + round((rows - 1) * (4 - grain[4]) / 6)
            for seen, bar in zip(image.pixel(x, y), image.pixel(middle, row)):
                self.assertLess(abs(seen - bar), 14, f"grain {grain}")

    def test_times_and_last(self):
        """The nearest snapshot; the last one when no time is given; grains that moved show it."""
        said = self.picture(self.results, "--time=0.00104", "-o", "near.png", "--size=300x200")
        self.assertRegex(said, r"near.png: t = 0\.00(1|099)")
        said = self.picture(self.results, "--size=300x200")
        self.assertRegex(said, r"one.png: t = 0\.00(3|299)")
        one, last = Image(self.path("near.png")), Image(self.path("one.png"))
        self.assertNotEqual(one.rows, last.rows)
        again = self.image("--time=0.001", "--size=300x200", "-j1")
        self.assertEqual(one.rows, again.rows)  # one thread or several

    def test_all_frames_and_a_movie(self):
        names = sorted(name for name in os.listdir(self.results) if name.startswith("snap_"))
        said = self.picture(self.results, "--all", "-j", "3", "--size=300x200")
        self.assertIn(f"one-frames: {len(names)} frames", said)
        frames = sorted(os.listdir(self.path("one-frames")))
        self.assertEqual(frames, [f"frame_{k:06d}.png" for k in range(len(names))])
        images = [Image(self.path(f"one-frames/{name}")) for name in frames]
        self.assertNotEqual(images[0].rows, images[-1].rows)
        self.picture(self.results, "--all", "-j", "1", "--size=300x200", "-o", "other")
        for name in frames:
            self.assertEqual(clod.read(self.path(f"one-frames/{name}")),
                             clod.read(self.path(f"other/{name}")))
        if shutil.which("ffmpeg"):
            self.picture(self.results, "--movie=a.mp4", "--size=301x201", "-o", "other")
            self.assertEqual(clod.read(self.path("a.mp4"))[4:8], b"ftyp")

    def test_a_movie_without_ffmpeg(self):
        os.mkdir(self.path("empty"))
        said = self.picture(self.results, "--movie=a.mp4", code=2,
                            env={**os.environ, "PATH": self.path("empty")})
        self.assertIn("apt install ffmpeg", said)
        self.assertEqual(os.listdir(self.folder), ["empty"])

    def test_two_runs_side_by_side(self):
        """Both halves show the same grains at the same places, since the runs are the same."""
        image = self.image("--beside", os.path.join(self.out, "two"), "--time=0.001",
                           "--size=900x400", "--hide=floor")
        bar, first, rows = find_bar(image)
        columns = [x for x in range(bar - 10)
                   if any(is_coloured(image.pixel(x, y)) for y in range(first, 330))]
        half = (columns[-1] - columns[0]) // 2 + columns[0]
        left = [x for x in columns if x < half]
        right = [x for x in columns if x > half]
        shift = right[0] - left[0]
        self.assertLessEqual(abs((right[-1] - right[0]) - (left[-1] - left[0])), 2)
        same = sum(image.pixel(x, y) == image.pixel(x + shift, y)
                   for x in left for y in range(first, 330))
        self.assertGreater(same, 0.9 * len(left) * (330 - first))

    def test_walls_with_a_bar_of_their_own(self):
        """The floor is seen and coloured by its field; hidden it is gone."""
        options = ("--wall-color=velocity", "--time=0.001", "--size=400x300", "--view=top")
        shown, hidden = self.image(*options), self.image(*options, "--hide=0")
        panel = [(x, y) for y in range(30, 240) for x in range(300)]
        counts = collections.Counter(shown.pixel(x, y) for x, y in panel)
        floor, often = max(counts.items(), key=lambda item: item[1] * is_coloured(item[0]))
        self.assertGreater(often, len(panel) // 5)
        self.assertNotIn(floor, [hidden.pixel(x, y) for x, y in panel])
        # it faces the eye and stands still: the lowest colour of its bar, but for the light
        bar = [shown.pixel(x, y) for y in range(150, 300) for x in range(300, 400)]
        self.assertTrue(any(max(abs(a - b) for a, b in zip(floor, pixel)) < 6 for pixel in bar))

    def test_the_range_of_the_walls_bar(self):
        """The floor stands still and faces the eye: from -1 to 3 it has the colour a quarter up the walls' bar, the
        lower one. The grains' bar keeps the range of its values."""
        options = ("--wall-color=velocity", "--time=0.001", "--size=500x400", "--view=top")
        image, usual = self.image(*options, "--wall-range=-1,3"), self.image(*options)
        panel = [(x, y) for y in range(50, 330) for x in range(370)]
        counts = collections.Counter(image.pixel(x, y) for x, y in panel)
        floor = max(counts.items(), key=lambda item: item[1] * is_coloured(item[0]))[0]
        self.assertNotIn(floor, [usual.pixel(x, y) for x, y in panel])
        grains = [[row[3 * 420:] for row in one.rows[:200]] for one in (image, usual)]
        self.assertEqual(*grains)
        image.rows, image.height = image.rows[200:], image.height - 200
        middle, first, rows = find_bar(image)
        row = first + round((rows - 1) * 3 / 4)
        for seen, bar in zip(floor, image.pixel(middle, row)):
            self.assertLess(abs(seen - bar), 14)

    def test_ranges_are_told_apart(self):
        """--range with a field of the walls alone may be meant for them: it says what it is for."""
        walls = ("-o", "a.png", "--wall-color=velocity", "--size=200x200", "--quality=draft")
        for more, told in ((("--range=0,1",), True), (("--range=0,1", "--color=mass"), False),
                           (("--range=0,1", "--wall-range=0,1"), False), (("--wall-range=0,1",), False)):
            done = clod.run("picture", self.results, *walls, *more, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, "clod picture: --range is for the grains' bar (speed); --wall-range sets that "
                             "of the walls (velocity)\n" if told else "")

    def test_a_square_of_a_mesh_does_not_end_like_a_plane(self):
        """From above, 1.3 m high: a plane ends with the domain, 50 mm from the middle; a mesh of two
        triangles is 200 mm long to each side. In a snapshot without the column, a plane is the
        square that it is shown as, as long as the domain."""
        mesh = "v -200 -200 -60\nv 200 -200 -60\nv 200 200 -60\nv -200 200 -60\nf 1 2 3\nf 1 3 4\n"
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [mm],y [mm],z [mm],radius [mm]\n0,0,0,4\n")
        with open(self.path("floor.obj"), "w") as file:
            file.write(mesh)
        plane = "{plane: {point: [0 mm, 0 mm, -50 mm], normal: [0, 0, 1]}}"
        ends = []
        for shape in (plane, "{mesh: {file: floor.obj, unit: 1 mm}}"):
            with open(self.path("case.yaml"), "w") as file:
                file.write(CASE.format(title="Square").replace(plane, shape))
            done = clod.run("run", "case.yaml", "-o", "square", "--fresh", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.picture("square", "-o", "a.png", "--from=0,0,1.25", "--at=0,0,-0.05",
                         "--angle=30", "--size=600x400", "--quality=draft")
            image = Image(self.path("a.png"))
            white = (255, 255, 255)
            row = 3 * image.height // 4 # below the grain, above the scale
            ends.append(sum(image.pixel(x, row) != white for x in range(image.width)))
        # as wide as the domain, or not at all in that row; and as wide as the mesh
        self.assertGreater(ends[1], 2.5 * max(ends[0], 40))

    def test_a_part_of_a_mesh_is_left_out(self):
        """A closed box of sides and lid, a belt beside it. Without the lid the picture is that of a box that has none;
        without all parts that without the wall. What is not there is named."""
        corners = [(x, y, z) for z in (-9, 9) for x, y in ((-9, -9), (9, -9), (9, 9), (-9, 9))]
        sides = "o sides\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 1 2 3 4\n"
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [mm],y [mm],z [mm],radius [mm]\n0,0,0,4\n")
        plane = "{plane: {point: [0 mm, 0 mm, -50 mm], normal: [0, 0, 1]}}"
        belt = "{belt: {from: [20 mm, 0 mm, 0 mm], runs: [{length: 20 mm}], width: 10 mm, speed: 1 m/s}}"
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(title="Box").replace(plane, "{mesh: {file: box.obj, unit: 1 mm}}, " + belt))
        for name, lid in (("closed", "o lid\nf 5 6 7 8\n"), ("open", "")):
            with open(self.path("box.obj"), "w") as file:
                file.writelines("v {} {} {}\n".format(*corner) for corner in corners)
                file.write(sides + lid)
            done = clod.run("run", "case.yaml", "-o", name, "--fresh", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)

        def rows(run, *hidden):
            self.picture(run, "-o", "a.png", "--from=0.03,-0.1,0.3", "--at=0,0,0", "--angle=10", "--size=300x300",
                         "--quality=draft", *[f"--hide={name}" for name in hidden])
            return Image(self.path("a.png")).rows
        opened = rows("closed", "floor.lid")
        self.assertEqual(opened, rows("open"))
        self.assertNotEqual(opened, rows("closed"))
        self.assertEqual(rows("closed", "floor.lid", "floor.sides", "floor.run 1"), rows("closed", "floor"))
        self.assertNotEqual(opened, rows("closed", "floor"))
        said = self.picture("closed", "--hide=floor.hood", code=2)
        self.assertIn("--hide floor.hood: closed has no such wall or part. Walls: floor; or their numbers, from 0. "
                      "Parts: floor.sides, floor.lid, floor.run 1.", said)

    def test_more_parts_than_a_snapshot_has_room_for(self):
        """60 000 bytes of names; behind the first that does not fit no part has one, so no other part takes its
        name."""
        with open(self.path("grains.csv"), "w") as file:
            file.write("x [mm],y [mm],z [mm],radius [mm]\n0,0,30,4\n")
        with open(self.path("many.obj"), "w") as file:
            for k, name in enumerate([f"part_of_some_length_{k:05d}" for k in range(1900)] + ["s0"]):
                x, y = -40 + 2 * (k % 40), -49 + 2 * (k // 40)
                file.write(f"o {name}\nv {x} {y} -5\nv {x + 1} {y} -5\nv {x} {y + 1} -5\nf -3 -2 -1\n")
        plane = "{plane: {point: [0 mm, 0 mm, -50 mm], normal: [0, 0, 1]}}"
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE.format(title="Many").replace(plane, "{mesh: {file: many.obj, unit: 1 mm}}"))
        done = clod.run("run", "case.yaml", "-o", "many", "--fresh", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.picture("many", "-o", "a.png", "--size=200x200", "--quality=draft", "--hide=floor.part_of_some_length_01800")
        self.assertIn("no such wall or part", self.picture("many", "--hide=floor.s0", code=2))

    def test_fields(self):
        for field in ("speed", "age", "birth", "kinetic_energy", "mass", "type", "id",
                      "coordination", "force", "omega_x", "velocity_y"):
            self.picture(self.results, "-o", "a.png", "-c", field, "--size=200x200", "--quality=draft")

    def test_what_is_wrong_is_named(self):
        for name in ("x.jpg", "x.PNG.svg", "a.d/x.tiff"):
            self.assertIn(f"--output {name}: pictures are PNG; let the name end in .png",
                          self.picture(self.results, "-o", name, code=2))
        said = self.picture(self.results, "--color=moisture", code=2)
        self.assertIn("grains have no field moisture. Fields: ", said)
        for name in ("radius", "velocity (_x, _y, _z)", "speed", "age", "kinetic_energy"):
            self.assertIn(name, said)
        self.assertIn("walls have no field wear. Fields: shape, type, velocity",
                      self.picture(self.results, "--wall-color=wear", code=2))
        self.assertIn("--time 7 s is outside of the run", self.picture(self.results, "-t7", code=2))
        self.assertIn("Walls: floor", self.picture(self.results, "--hide=roof", code=2))
        self.assertIn("Maps: sea", self.picture(self.results, "--map=jet", code=2))
        self.assertIn("Parts that have: run",
                      self.picture(self.results, "--part=preshear", code=2))
        self.assertIn("No such file or directory", self.picture("nowhere", code=2))
        self.assertIn("is not the results folder of a run", self.picture(".", code=2))
        for option, word in (("--range=3,1", "rise"), ("--size=10x10", "pixels"),
                             ("--view=back", "oblique"), ("--from=1,2", "three numbers"),
                             ("--angle=200", "degrees"), ("--jobs=0", "processes"),
                             ("--quality=best", "draft"), ("--time=soon", "seconds")):
            self.assertIn(word, self.picture(self.results, option, code=2))
        for options, words in ((("--wall-range=3,1", "--wall-color=velocity"), "--wall-range 3,1: two numbers that rise"),
                               (("--wall-range=0,1",), "say which, with --wall-color"),
                               (("--view=front", "--from=1,1,1"), "--view and --from both place the camera: leave one"),
                               (("--from=1,1,1", "--view=oblique"), "--view and --from")):
            self.assertIn(words, self.picture(self.results, *options, code=2))
        self.assertEqual(os.listdir(self.folder), [])

    def test_damaged_files(self):
        run = self.path("run")
        shutil.copytree(self.results, run)
        last = sorted(name for name in os.listdir(run) if name.startswith("snap_"))[-1]
        path = os.path.join(run, last)
        whole = clod.read(path)
        for length in (0, 100, len(whole) // 2):
            with open(path, "wb") as file:
                file.write(whole[:length])
            said = self.picture(run, code=2)
            self.assertIn(last, said)
            self.assertIn("damaged", said)
        self.assertIn(last, self.picture(run, "--all", code=2))
        os.remove(path)
        self.assertIn("not there", self.picture(run, code=2))
        with open(os.path.join(run, "run.hdf.series"), "w") as file:
            file.write("{}")
        self.assertIn("run.hdf.series is damaged", self.picture(run, code=2))
        os.remove(os.path.join(run, "run.hdf.series"))
        self.assertIn("has no snapshots", self.picture(run, code=2))


if __name__ == "__main__":
    clod.main()
