"""Tables of the cases: what is wrong with a folder is told in a line, with what to do, and exit status 2."""

import glob
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
TABLES = sorted(glob.glob(os.path.join(ROOT, "cases", "*", "table")))
BOX = {"title": "A box", "max_overlap": 0.001, "stages": [{"name": "run", "end_s": 9.0}], "inlets": [], "outlets": {},
       "left": {}, "gauges": {}, "surfaces": []}  # a run of none of the cases


def reader():
    """A Python that reads snapshots; None: none does."""
    for python in (sys.executable, "/usr/bin/python3"):
        if os.path.exists(python) and subprocess.run([python, "-c", "import h5py"], stderr=subprocess.DEVNULL,
                                                     check=False).returncode == 0:
            return python
    return None


READER = reader()


class Tables(clod.Case):

    def table(self, table, *words, python=sys.executable):
        return subprocess.run([python, table, *words], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, check=False)

    def refused(self, table, *words, **more):
        done = self.table(table, *words, **more)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr

    def each(self, what, summary=None, **files):
        """Every table refuses a folder with these files, names it, and says what is missing and what to run."""
        folder = self.path(what.replace(" ", "-"))
        os.mkdir(folder)
        files = {**files, **({} if summary is None else {"summary.json": summary})}
        for name, text in files.items():
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
        for table in TABLES:
            said = self.refused(table, folder)
            case = os.path.relpath(os.path.dirname(table), ROOT)
            self.assertTrue(said.startswith(f"table: {folder}: "), said)
            self.assertIn(f"clod run {case}/case.yaml -o FOLDER", said)
            self.assertRegex(said, what)

    def test_there_are_tables(self):
        self.assertGreaterEqual(len(TABLES), 6)

    def test_no_folder(self):
        for table in TABLES:
            said = self.refused(table, self.path("nowhere"))
            self.assertIn(f"table: {self.path('nowhere')}: there is no such folder", said)
            self.assertIn("RUN", self.refused(table))

    def test_runs_that_have_not_ended_or_are_damaged(self):
        self.each("the run has not ended")
        self.each("summary.json cannot be read", summary='{"title": "half')
        self.each("not an object", summary="[1, 2]")

    def test_a_run_of_another_case(self):
        rows = "time [s],grains\n" + "".join(f"{0.5 * k},7\n" for k in range(19))
        snapshots = {"run.hdf.series": json.dumps({"files": []}), "series.csv": rows}
        self.each("has no .* it is a run of another case", summary=json.dumps(BOX), **snapshots)

    @clod.unittest.skipIf(READER is None, "no Python here reads snapshots (python3-h5py)")
    def test_a_run_of_a_case_with_the_same_columns(self):
        """Cone and wedge have the same series and stages; their walls tell them apart."""
        short = ["--set", "grains.0.count=20", "--set", "stages.0.duration=20 ms", "--set", "stages.1.duration=1 ms",
                 "--set", "stages.2.duration=40 ms"]
        runs = {}
        for name in ("hopper-cone", "hopper-wedge"):
            runs[name] = self.path(name)
            done = clod.run("run", clod.source(f"cases/{name}/dry.yaml"), "-o", runs[name], *short)
            self.assertEqual(done.returncode, 0, done.stderr)
        table = os.path.join(ROOT, "cases", "hopper-cone", "table")
        for mine, other, words, told in (
                ("hopper-cone", "hopper-wedge", [], "outlet of 38.0 mm, and those of this case 50 mm"),
                ("hopper-wedge", "hopper-cone", ["--wedge"], "outlet of 50.0 mm, and those of this case 38 mm")):
            done = self.table(table, *words, runs[mine], python=READER)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            said = self.refused(table, *words, runs[other], python=READER)
            self.assertIn(f"table: {runs[other]}: its walls have an {told}", said)
            self.assertIn(f"clod run cases/{mine}/case.yaml", said)
        # an outlet of 50 mm as well, but another bin
        mesh = self.path("hopper.obj")
        script = os.path.join(ROOT, "cases", "hopper-cone", "geometry")
        subprocess.run([sys.executable, script, "--bin", "112", "-o", mesh], check=True)
        done = clod.run("run", clod.source("cases/hopper-cone/dry.yaml"), "-o", self.path("wide"), *short,
                        "--set", f"walls.hopper.shapes.0.mesh.file={mesh}")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("a bin of 112.0 mm, and those of this case 110 mm",
                      self.refused(table, self.path("wide"), python=READER))

    def test_a_run_that_is_too_short(self):
        """All columns are there, but of 0.1 s, and no snapshots."""
        names = ("left_x_max.mass", "left_z_min.mass", "drum.torque_y", "screw.torque_x", "tray.force_z")
        rows = f"time [s],{','.join(names)}\n" + "".join(f"0.{k},1,1,1,1,1\n" for k in range(2))
        self.each("snapshots|after [0-9.]+ s|has no", summary=json.dumps(
            {**BOX, "repose": {"heap": {"angle_deg": None, "height_m": 0.1}}}), **{"series.csv": rows})


if __name__ == "__main__":
    clod.main()
