"""Files of a complete run that are missing or cut off: the page says so, and all else stays on it."""

import glob
import os
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pages
from pages import clod

CASES = {"ring": "tests/restart/ring.yaml", "wall": "tests/cli/wall_friction.yaml", "box": "tests/restart/box.yaml"}


class Damage(pages.PageCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.runs = clod.make_folder()
        cls.addClassCleanup(shutil.rmtree, cls.runs)
        for name, case in CASES.items():
            done = clod.run("run", clod.source(case), "-o", os.path.join(cls.runs, name), "-t", "1",
                            *(pages.SHORT if name == "box" else ()))
            assert done.returncode == 0, done.stderr

    def copy(self, name):
        shutil.rmtree(self.path(name), ignore_errors=True)
        shutil.copytree(os.path.join(self.runs, name), self.path(name))

    def cut(self, name, size):
        with open(self.path(name), "r+b") as file:
            file.truncate(size)

    def report(self, name="ring"):
        """The page, and what standard error says of damage: each of it is first on the page."""
        done = self.made("report", name)
        page = self.page(f"{name}/report.html")
        said = [line.removeprefix("clod: ") for line in done.stderr.splitlines() if not line.startswith("clod report:")]
        self.assertEqual(page.items[:len(said)], said)
        return page, said

    def test_a_whole_run_has_none(self):
        for name in CASES:
            self.copy(name)
            self.assertEqual(self.report(name)[1], [])

    def test_without_its_last_snapshot_a_page_has_all_but_the_view(self):
        self.copy("ring")
        whole, _ = self.report()
        for spoil in (os.remove, lambda path: self.cut(path, 100)):
            self.copy("ring")
            last = max(glob.glob(self.path("ring/point-2_snap_*.hdf")))
            spoil(last)
            page, said = self.report()
            if whole.views:  # built with scripts
                self.assertEqual(len(said), 1)
                self.assertTrue(said[0].startswith(f"There is no 3-D view of the last snapshot: ring/{os.path.basename(last)}: "), said)
            self.assertEqual(page.views, [])
            self.assertEqual(page.figures, whole.figures)
            self.assertEqual(page.tables, whole.tables)
            self.assertEqual(page.items[len(said):], whole.items)

    def test_a_table_that_ends_before_its_part(self):
        """At the end of a part its table has a row: one without the last row is cut off, too."""
        for name, part in (("ring", "preshear"), ("ring", "point-1"), ("wall", "wall"), ("box", "series")):
            self.copy(name)
            path = f"{name}/{part}.csv"
            times = clod.table(self.path(path))
            self.cut(path, os.path.getsize(self.path(path)) - 3)
            _, (said,) = self.report(name)
            before, end = (f"{row['time']:.6g} s" for row in times[-2:])
            self.assertTrue(said.startswith(f"{path} ends at {before}, and the simulation at {end}: "), said)

    def test_a_table_without_rows(self):
        self.copy("ring")
        os.remove(self.path("ring/point-1.csv"))
        pages.write(self.path("ring"), preshear__csv="a,b\n")
        page, said = self.report()
        self.assertEqual([text.split(" ", 1)[0] for text in said], ["ring/preshear.csv", "ring/point-1.csv"])
        self.assertTrue(all("has no rows with a time, or is missing" in text for text in said), said)

    def test_a_table_of_results_with_fewer_points_than_the_summary(self):
        for name, table, points in (("ring", "points.csv", 2), ("wall", "wall_friction.csv", 3)):
            self.copy(name)
            whole = clod.read(self.path(f"{name}/{table}"))
            for content, rows in (("a,b", 0), (whole.splitlines()[0].decode() + "\n", 0), (b"\n".join(whole.splitlines()[:2]).decode() + "\n", 1)):
                with open(self.path(f"{name}/{table}"), "w") as file:
                    file.write(content)
                _, (said,) = self.report(name)
                self.assertTrue(said.startswith(f"{name}/{table} has {rows} of the {points} points "), said)

    def test_a_comparison_says_it_too(self):
        self.copy("ring")
        shutil.copytree(self.path("ring"), self.path("cut"))
        self.cut("cut/preshear.csv", 1000)
        done = self.made("compare", "ring", "cut", "-o", "both.html")
        self.assertIn("clod: cut/preshear.csv ends at ", done.stderr)
        self.assertIn("cut/preshear.csv ends at ", self.page("both.html").text)

    def test_a_run_that_goes_on_is_not_damaged(self):
        """Its tables may be behind or before what it has told."""
        self.copy("ring")
        os.remove(self.path("ring/report.txt"))
        self.cut("ring/preshear.csv", 1000)
        done = self.made("report", "ring")
        self.assertNotIn("ends at", done.stderr)


if __name__ == "__main__":
    clod.main()
