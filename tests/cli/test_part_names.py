"""Names of parts on the command line: those that several shapes of a wall share (tests/support/same_names.py)."""

import html
import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import same_names

# Names as Blender and CAD write them, with the belt speed [m/s] and friction of each in the case.
LONG = "liner of the upper chute, inner side, part number "
NAMED = {"Cube.001": (1, 0.5), "Hood-left: plate": (1, 0.2), LONG + "1": (0, 0), LONG + "2": (-1, 0.5)}
PLACES = [(50, 50), (150, 50), (50, 250), (150, 250)]  # mm, of the grains there

VIEW = ("--from=0.4,0.2,3", "--at=0.4,0.2,0", "--angle=20", "--size=400x300", "--quality=draft")


class PartNames(clod.Case):

    def go_same(self, text=same_names.CASE):
        same_names.write(self.path, text)
        return clod.run("run", "case.yaml", "-o", "run", "--fresh", cwd=self.folder)

    def picture(self, *hidden, code=0):
        done = clod.run("picture", "run", "-o", "a.png", *VIEW, *[f"--hide={name}" for name in hidden],
                        cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        return clod.read(self.path("a.png")) if code == 0 else done.stderr

    def test_a_picture_hides_one_or_all(self):
        """WALL.PART hides the parts of this name of all shapes, WALL.NUMBER.PART that of one."""
        self.assertEqual(self.go_same().returncode, 0)
        both = self.picture("plates.left")
        self.assertEqual(both, self.picture("plates.1.left", "plates.2.left"))
        one = self.picture("plates.1.left")
        self.assertEqual(len({self.picture(), both, one, self.picture("plates.2.left")}), 4)
        self.assertEqual(self.picture("plates.left", "plates.right", "belts.run 1"), self.picture("plates", "belts"))
        names = ", ".join(same_names.GRAINS)
        for name in ("plates.3.left", "plates.1.run 1", "plates.", "plates.1.", "left"):
            self.assertIn(f"no such wall or part. Walls: plates, belts; or their numbers, from 0. Parts: {names}.",
                          self.picture(name, code=2))

    def test_an_outlet_is_one_or_all(self):
        """Its grains are not pushed, and are gone when they have sunk by half of the largest radius: 30 ms."""
        case = same_names.CASE.replace("4 ms", "40 ms") + "outlets: {exit: {wall: WALL, part: PART}}\n"
        for part, surfaces in (("left", ["plates.1.left", "plates.2.left"]), ("2.left", ["plates.2.left"])):
            done = self.go_same(case.replace("WALL", "plates").replace("PART", part))
            self.assertEqual(done.returncode, 0, done.stderr)
            gone = self.summary("run")["outlets"]["exit"]["mass_kg"]
            self.assertAlmostEqual(gone / sum(same_names.mass(one) for one in surfaces), 1.0, 12)
        done = self.go_same(case.replace("WALL", "belts").replace("PART", "3.run 1"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("outlets.exit.part: walls.belts has no part '3.run 1'; its parts are 1.run 1, 2.run 1", done.stderr)

    def test_a_name_that_is_too_long(self):
        """A name of 255 bytes is whole, and one more is refused with its line; OBJ and STL alike."""
        stl = "solid {}\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"
        for kind, text, line in (("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng {}\nf 1 2 3\n", 4), ("stl", stl, 1)):
            for length in (255, 256):
                with open(self.path(f"a.{kind}"), "w") as file:
                    file.write(text.format("n" * length))
                done = clod.run("mesh", f"a.{kind}", "--unit=m", cwd=self.folder)
                if length == 255:
                    self.assertIn("  " + "n" * length + "\n", done.stdout)
                else:
                    self.assertEqual(done.returncode, 2)
                    self.assertIn(f"a.{kind}:{line}: the name of the part has 256 bytes; at most 255", done.stderr)

    def go_named(self, key="Cube.001", *options):
        """The plates with these names; what each part is given follows from its name."""
        text = same_names.CASE.replace("friction: 0}}", "friction: 0.5}, ore-slick: {friction: 0.2}}")
        text = text.replace("materials: {", "materials: {slick: {density: 1000 kg/m3}, ")
        text = text.replace("file: one.obj, unit: 1 mm", f"""file: one.obj, unit: 1 mm, parts: {{{key}: {{speed: 1 m/s}},
               "Hood-left: plate": {{material: slick, speed: 1 m/s}}}}""")
        text = text.replace("file: two.obj, unit: 1 mm", f"""file: two.obj, unit: 1 mm,
               parts: {{"{LONG}2": {{speed: -1 m/s}}}}""")
        same_names.write(self.path, text)
        for file, names in (("one.obj", list(NAMED)[:2]), ("two.obj", list(NAMED)[2:])):
            with open(self.path(file), "w") as out:
                out.write(same_names.PLATE.replace("o left", f"o {names[0]}").replace("o right", f"o {names[1]}"))
        return clod.run("run", "case.yaml", "-o", "run", "--fresh", *options, cwd=self.folder)

    def test_names_of_cad(self):
        """Parts with points, blanks, colons and long names have material and belt of their own: where it slips, a
        grain drags the belt with friction times its weight."""
        done = self.go_named()
        self.assertEqual(done.returncode, 0, done.stderr)
        last = {name.split(" [")[0]: float(value) for name, value in self.rows("run")[-1].items()}
        grains = {place[:2]: name for name, place in same_names.GRAINS.items()}
        for (name, (speed, friction)), place in zip(NAMED.items(), PLACES):
            weight = same_names.mass(grains[place]) * same_names.GRAVITY
            column = f"surface_plates.{name.replace(',', '_')}.force_x"
            self.assertAlmostEqual(last[column] / weight, -friction * speed, 4, name)
        shutil.copy(self.path("run/case-complete.yaml"), self.path("again.yaml"))
        done = clod.run("check", "again.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        every = [f"plates.{name}" for name in NAMED]
        self.assertEqual(self.picture(*every), self.picture("plates"))
        self.assertNotEqual(self.picture(*every[1:]), self.picture("plates"))

    def test_a_part_that_the_mesh_has_not(self):
        """The message has the place, however the part is called."""
        for key in ("Cube_001", "Cube.002", '"Cube: 1 [m]"'):
            done = self.go_named(key)
            self.assertEqual(done.returncode, 2)
            place = "case.yaml:11:52: " if key[0] == '"' else "case.yaml:11:51: "  # behind the quote
            self.assertIn(f"{place}walls.plates.shapes.0.mesh.parts.{key.strip(chr(34))}: the mesh ", done.stderr)
            self.assertIn("its parts are Cube.001, Hood-left: plate", done.stderr)

    def test_a_setting_of_a_part(self):
        done = self.go_named("Cube.001", "--set", "walls.plates.shapes.0.mesh.parts.Cube.001.speed=-3 m/s")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b'"Cube.001":\n', clod.read(self.path("run/case-complete.yaml")))
        self.assertIn(b"speed: -3 m/s\n", clod.read(self.path("run/case-complete.yaml")))

    def test_a_setting_of_a_part_with_equals_signs(self):
        """The key ends at the = behind the longest name that the case has, or at the first; the part may lack the key."""
        names = ["a", "a=b", "a=b.c=d", "x=y"]
        text = same_names.CASE
        for file, two in (("one.obj", names[:2]), ("two.obj", names[2:])):
            text = text.replace(f"file: {file},", f"""file: {file}, parts: {{"{two[0]}": {{}}, "{two[1]}": {{}}}},""")
        same_names.write(self.path, text)
        for file, (left, right) in (("one.obj", names[:2]), ("two.obj", names[2:])):
            with open(self.path(file), "w") as out:
                out.write(same_names.PLATE.replace("o left", f"o {left}").replace("o right", f"o {right}"))
        places = [f"walls.plates.shapes.{k // 2}.mesh.parts.{name}.speed" for k, name in enumerate(names)]
        settings = [f"--set={place}={k + 3} m/s" for k, place in enumerate(places)] + ["--set=title=a.b=c=d"]
        done = clod.run("run", "case.yaml", "-o", "run", "--fresh", *settings, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        complete = clod.read(self.path("run/case-complete.yaml")).decode()
        self.assertEqual(re.findall(r'^ *"(.*)":\n(?: *\w+: .*\n)*? *speed: (.*) m/s$', complete, re.M),
                         [(name, str(k + 3)) for k, name in enumerate(names)])
        self.assertIn('\ntitle: "a.b=c=d"\n', complete)
        done = clod.run("check", "case.yaml", "--set", "walls.plates.shapes.0.mesh.parts.e=f.speed=1 m/s", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("walls.plates.shapes.0.mesh.parts.e", done.stderr)

    def test_what_differs(self):
        """`compare` and --from tell parts apart by their whole names, with colons and alike in 100 characters."""
        names = ["Hood: left", "Hood: right", 2 * LONG + "1", 2 * LONG + "2"]
        for run, speeds in (("run1", (1, 5, 2, 3)), ("run2", (2, 6, 2, 4))):
            parts = [f'"{name}": {{speed: {speed} m/s}}' for name, speed in zip(names, speeds)]
            text = same_names.CASE
            for file, two in (("one.obj", parts[:2]), ("two.obj", parts[2:])):
                text = text.replace(f"file: {file},", f"file: {file}, parts: {{{', '.join(two)}}},")
            same_names.write(self.path, text)
            for file, (left, right) in (("one.obj", names[:2]), ("two.obj", names[2:])):
                with open(self.path(file), "w") as out:
                    out.write(same_names.PLATE.replace("o left", f"o {left}").replace("o right", f"o {right}"))
            origin = ["--from", "run1"] if run == "run2" else []
            done = clod.run("run", "case.yaml", "-o", run, *origin, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
        differ = {f'walls.plates.shapes.0.mesh.parts."{names[0]}".speed': ("1 m/s", "2 m/s"),
                  f'walls.plates.shapes.0.mesh.parts."{names[1]}".speed': ("5 m/s", "6 m/s"),
                  f'walls.plates.shapes.1.mesh.parts."{names[3]}".speed': ("3 m/s", "4 m/s")}
        told = re.findall(r"^ +(walls.*): (.*) there, (.*) here$", done.stderr, re.M)
        self.assertEqual({key: (there, here) for key, there, here in told}, differ)
        self.assertEqual(clod.run("compare", "run1", "run2", "-o", "c.html", cwd=self.folder).returncode, 0)
        page = clod.read(self.path("c.html")).decode()
        rows = re.findall(r"<tr><th>(walls[^<]*)</th><td>([^<]*)</td><td>([^<]*)</td></tr>", page)
        self.assertEqual({html.unescape(key): (there, here) for key, there, here in rows}, differ)

    def test_names_that_are_no_text(self):
        """Control characters and bytes that are no UTF-8 reach no terminal; a name that comes again goes on."""
        facet = b"v 0 0 0\nv %d 0 0\nv 0 1 0\nf -3 -2 -1\n"
        names = [b"red \x1b[31m", b"Bl\xe4tter", "Blätter".encode(), b"red \x1b[31m", b"\xc2\x9b1m"]
        with open(self.path("a.obj"), "wb") as file:
            file.writelines(b"o " + name + b"\n" + facet % (k + 1) for k, name in enumerate(names))
        told = ["red ?[31m", "Bl?tter", "Blätter", "??1m"]
        done = clod.run("mesh", "a.obj", "--unit=m", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in told:
            self.assertIn(f"  {name}\n", done.stdout)
        self.assertEqual([c for c in done.stdout if ord(c) < 32 and c != "\n" or 127 <= ord(c) < 160], [])
        done = clod.run("mesh", "a.obj", "--unit=m", "--json", cwd=self.folder)
        self.assertEqual([part["name"] for part in json.loads(done.stdout)["parts"]], told)
        case = same_names.CASE.replace("file: one.obj, unit: 1 mm", 'file: a.obj, unit: 1 mm, parts: {"no\\e": {}}')
        same_names.write(self.path, case)
        done = clod.run("check", "case.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn(".parts.no?: the mesh ", done.stderr)
        self.assertIn("its parts are " + ", ".join(told), done.stderr)

    def test_names_that_become_alike(self):
        """Two or three names of one reading: a warning each, also of a long one, whose cut splits no character."""
        long = "é".encode() * 101
        names = [b"a\xff", b"a\xfe", b"b\x01", b"b\x02", b"b\xff", b"c\xff", b"d?", long + b"\xff", long + b"\x01"]
        with open(self.path("one.obj"), "wb") as file:
            for k, name in enumerate(names):
                file.write(b"o %s\nv 0 0 %d\nv 100 0 %d\nv 0 100 %d\nf -3 -2 -1\n" % (name, k, k, k))
        told = clod.run("mesh", "one.obj", "--unit=mm", "--json", cwd=self.folder)
        warnings = json.loads(told.stdout)["warnings"]
        shown = [re.match("([0-9]) parts are called ([^:]*): .* means (both|all of them);", text) for text in warnings]
        self.assertEqual([one.groups() for one in shown],
                         [("2", "a?", "both"), ("3", "b?", "all of them"), ("2", 40 * "é" + "...", "both")])
        case = same_names.CASE.replace("file: one.obj,", 'file: one.obj, parts: {"a?": {speed: 1 m/s}},')
        for name, text in (("case.yaml", case), ("two.obj", same_names.PLATE), ("grains.csv", "x [mm],y [mm],z [mm],radius [mm]\n50,50,50,4\n")):
            with open(self.path(name), "w") as file:
                file.write(text)
        told = clod.run("check", "case.yaml", "--json", cwd=self.folder)
        self.assertEqual(told.returncode, 0, told.stderr)
        told = [text for text in json.loads(told.stdout)["warnings"] if "parts are called" in text]
        self.assertEqual(told, [f"walls.plates: one.obj: {text}" for text in warnings])


    def test_messages_with_long_names(self):
        """No character is cut, of names and of the line above the caret; a name has its end, or is counted."""
        names = [letter * 120 + str(k) for k, letter in enumerate("äöüßé")]  # 241 bytes each
        facet = "v %d 0 0\nv 9 0 0\nv 0 9 0\nf -3 -2 -1\n"
        for before in ("", "a", f'"{names[0]}": {{}}, ', f'"{names[0]}": {{}},  '):
            case = same_names.CASE.replace("file: one.obj, unit: 1 mm", f'file: a.obj, unit: 1 mm, parts: {{{before}WRONG: {{}}}}')
            same_names.write(self.path, case.replace("WRONG", "é" * 100))
            with open(self.path("a.obj"), "w") as file:
                file.writelines(f"o {name}\n" + facet % k for k, name in enumerate(names))
            done = subprocess.run([clod.BINARY, "check", self.path("case.yaml")], stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 2)
            told, line, caret = done.stderr.decode("utf-8").splitlines()[:3]  # strict
            self.assertTrue(told.endswith(f"; its parts are {names[0]} and 4 more"), told)
            self.assertEqual(line[caret.index("^")], "a" if before == "a" else "é")
            self.assertIn(len(line.encode()) - 2, (99, 100, 101))  # bytes of the line that are shown


if __name__ == "__main__":
    clod.main()
