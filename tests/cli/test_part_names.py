"""Names of parts on the command line: those that several shapes of a wall share (tests/support/same_names.py)."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import same_names

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


if __name__ == "__main__":
    clod.main()
