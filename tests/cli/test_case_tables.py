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


class Tables(clod.Case):

    def refused(self, table, *words):
        done = subprocess.run([sys.executable, table, *words], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, check=False)
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

    def test_a_run_that_is_too_short(self):
        """All columns are there, but of 0.1 s, and no snapshots."""
        names = ("left_x_max.mass", "left_z_min.mass", "drum.torque_y", "screw.torque_x", "tray.force_z")
        rows = f"time [s],{','.join(names)}\n" + "".join(f"0.{k},1,1,1,1,1\n" for k in range(2))
        self.each("snapshots|after [0-9.]+ s|has no", summary=json.dumps(
            {**BOX, "repose": {"heap": {"angle_deg": None, "height_m": 0.1}}}), **{"series.csv": rows})


if __name__ == "__main__":
    clod.main()
