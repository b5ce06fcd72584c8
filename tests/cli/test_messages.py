"""Exit codes, messages, and what goes to standard output and what to standard error."""

import json
import os
import re
import shutil
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod

BOX = clod.source("tests/restart/box.yaml")
RING = clod.source("tests/restart/ring.yaml")
VERBS = ["new", "run", "check", "contact", "locus", "mesh", "report", "compare", "explain", "schema"]


class Messages(clod.Case):

    def refused(self, arguments, *texts, code=2):
        """Exit status, nothing on standard output, each text once on standard error."""
        done = clod.run(*arguments, cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout, "")
        for text in texts:
            self.assertEqual(done.stderr.count(text), 1, f"{text!r} in {done.stderr}")
        lines = [line for line in done.stderr.splitlines() if line.strip()]
        self.assertEqual(len(lines), len(set(lines)), f"a line is there twice: {done.stderr}")
        return done.stderr

    def answered(self, *arguments):
        """Exit status 0 and nothing on standard error; returns standard output."""
        done = clod.run(*arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_version(self):
        # CMakeLists.txt: project(clod VERSION ...)
        with open(clod.source("CMakeLists.txt")) as file:
            version = re.search(r"project\(clod VERSION (\S+)", file.read())[1]
        self.assertTrue(self.answered("--version").startswith(f"clod {version} ("))
        self.assertEqual(self.answered("run", "--version"), self.answered("-V"))

    def test_help(self):
        text = self.answered("--help")
        for verb in VERBS:
            self.assertIn(f"\n  {verb} ", text)
            help_of_verb = self.answered(verb, "--help")
            self.assertTrue(help_of_verb.startswith(f"Usage: clod {verb} "), help_of_verb)
            for line in help_of_verb.splitlines():
                self.assertLessEqual(len(line), 80)

    def test_verbs(self):
        self.refused([], "Usage: clod", "clod VERB --help")
        self.refused(["rnu", BOX], "there is no verb rnu; did you mean run?")
        self.refused(["xyzzy"], "there is no verb xyzzy\n", "clod --help lists the verbs")

    def test_options(self):
        for wrong in ("0", "-1", "two", "", "2.5", "100000"):
            self.refused(["run", BOX, f"--threads={wrong}"],
                         f"--threads {wrong}: a whole number from 1 to 1024 is needed")
        self.refused(["run", BOX, "--treads", "2"], "unrecognized option '--treads'", "--help")
        self.refused(["run"], "which case?", "clod new ring-shear")
        self.refused(["run", BOX, RING], "one case at a time")
        self.refused(["run", BOX, "--set"], "requires an argument")
        self.refused(["run", BOX, "--simd", "mmx", "-o", "x"],
                     "instruction set 'mmx' is unknown", "scalar, avx2, avx512 or neon")
        self.refused(["run", BOX, "--output="], "--output: the name of a folder is needed")
        self.assertEqual(os.listdir(self.folder), [], "wrong options leave no folder")

    def test_a_new_case_in_a_folder_that_is_not_there(self):
        done = clod.run("new", "free-run", "sub/deep/x.yaml", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, "clod new: sub/deep/x.yaml: there is no folder sub/deep; make it first: mkdir -p sub/deep\n")
        os.makedirs(self.path("sub/deep"))
        self.assertEqual(clod.run("new", "free-run", "sub/deep/x.yaml", cwd=self.folder).returncode, 0)

    def test_more_threads_than_processors(self):
        # as many are used as there are; the results do not depend on it
        case = self.path("ball.yaml")
        with open(case, "w") as file:
            file.write("materials: {ore: {density: 2500 kg/m3}}\n"
                       "contacts: {default: {law: hooke, k1: 1e4 N/m}}\n"
                       "grains:\n"
                       "  - {material: ore, count: 60, radius: {distribution: uniform, min: 1 mm,"
                       " max: 1 mm},\n     region: {box: {min: [0, 0, 0], max: [9 mm, 9 mm, 9 mm]}}}\n"
                       "time: {step: 1e-5 s}\n"
                       "stages: [{name: one, duration: 2 ms}]\n")
        processors = len(os.sched_getaffinity(0))
        series = []
        for threads in (1, processors, processors + 1, 1024):
            done = clod.run("run", case, "-o", f"out-{threads}", "--threads", str(threads),
                            cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            warning = (f"clod: warning: {threads} threads on {processors} processors slow each "
                       f"other down: {processors} are used")
            self.assertEqual(done.stderr.count(warning), int(threads > processors), done.stderr)
            with open(self.path(f"out-{threads}/log.jsonl")) as log:
                start = json.loads(log.readline())
            self.assertEqual(start["threads"], min(threads, processors))
            with open(self.path(f"out-{threads}/series.csv")) as file:
                series.append(file.read())
        self.assertEqual(series, series[:1] * 4)

    def test_overlap_limit(self):
        # two grains of 1 mm whose centres are 1.7 mm apart overlap by 0.3 mm, 30 % of a radius
        case = self.path("deep.yaml")
        with open(self.path("deep.csv"), "w") as file:
            file.write("x [m],y [m],z [m],r [m]\n0,0,0,1e-3\n1.7e-3,0,0,1e-3\n")
        with open(case, "w") as file:
            file.write("materials: {ore: {density: 2500 kg/m3}}\n"
                       "contacts: {default: {law: hooke, k1: 1e4 N/m}}\n"
                       "grains: [{material: ore, file: deep.csv}]\n"
                       "time: {step: 1e-6 s}\n"
                       "stages: [{name: one, duration: 10 us}]\n")
        self.refused(["run", case, "-o", "a"], "by 30.0 % of the radius of the smaller one",
                     "time.overlap_limit is 20 %", "raise time.overlap_limit", code=1)
        done = clod.run("run", case, "-o", "b", "--set", "time.overlap_limit=31 %",
                        cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.refused(["run", case, "-o", "c", "--set", "time.overlap_limit=91 %"],
                     "time.overlap_limit: 91 % is out of range; allowed is above 0 and at most 0.9")

    def test_a_mass_that_whole_grains_miss(self):
        # by hand: a grain of 1 mm and 2500 kg/m3 has 10.47 mg, so three weigh 8 % more than 29 mg
        case = self.path("mass.yaml")
        with open(case, "w") as file:
            file.write("materials: {ore: {density: 2500 kg/m3}}\n"
                       "contacts: {default: {law: hooke, k1: 1e4 N/m}}\n"
                       "domain: {min: [0 m, 0 m, 0 m], max: [20 mm, 20 mm, 20 mm]}\n"
                       "grains: [{material: ore, mass: 29 mg,\n"
                       "  radius: {distribution: uniform, min: 0.9999 mm, max: 1.0001 mm},\n"
                       "  region: {box: {min: [0 m, 0 m, 0 m], max: [20 mm, 20 mm, 20 mm]}}}]\n"
                       "time: {step: 1e-6 s}\n"
                       "stages: [{name: one, duration: 10 us}]\n")
        text = "3 grains of 3.14e-05 kg in all stand for the 2.9e-05 kg"
        self.assertIn(text, clod.run("check", case, "--json", cwd=self.folder).stdout)
        for folder, mass, count in (("a", "29 mg", 1), ("b", "31 mg", 0)):
            done = clod.run("run", case, "-o", folder, "--set", f"grains.0.mass={mass}",
                            cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr.count("stand for the"), count, done.stderr)

    def test_cases(self):
        self.refused(["run", "missing.yaml"], "clod run: missing.yaml: cannot be opened: No such file")
        self.refused(["run", "."], "cannot be")
        self.refused(["run", BOX, "--set", "seeed=3"], "seeed: this key is not known; did you "
                     "mean seed?")
        self.refused(["run", BOX, "--set", "safty=0.2"], "safty: this key is not known; did you mean time.safety?")  # of a section
        self.refused(["run", BOX, "--set", "zzzzzz=0.2"], "zzzzzz: this key is not known\n")
        self.refused(["run", BOX, "--set", "seed"], "key.path=value")
        self.refused(["run", clod.source("cases/contact-bench/case.yaml")],
                     "nothing to run", "clod contact")

    def test_unknown_key_with_its_place(self):
        with open(BOX) as file:
            text = file.read()
        with open(self.path("wrong.yaml"), "w") as file:
            file.write(text.replace("    restitution:", "    restitutoin:"))
        line = text.splitlines().index("    restitution: 0.3") + 1
        said = self.refused(["run", "wrong.yaml"], f"wrong.yaml:{line}:5: ",
                            "did you mean restitution?").splitlines()
        # the line itself, and a caret below the key's first letter
        at = [k for k, row in enumerate(said) if row.endswith("    restitutoin: 0.3")]
        self.assertEqual(len(at), 1)
        self.assertEqual(said[at[0] + 1].index("^"), said[at[0]].index("restitutoin"))
        self.assertFalse(os.path.exists(self.path("run")), "a refused case leaves no folder")

    def test_folders(self):
        with open(self.path("file"), "w") as file:
            file.write("mine")
        for name in ("file", "file/", "file/deep"):
            self.refused(["run", BOX, "-o", name], "clod run: file is there and is not a folder",
                         "another folder with -o")
        self.assertEqual(clod.read(self.path("file")), b"mine")
        said = self.refused(["run", BOX, "-o", "/proc/none"],
                            "clod run: Cannot make the folder /proc/none: ",
                            "choose another one with -o", code=1)
        self.assertNotIn("Does the folder exist", said)

    def test_default_folder(self):
        done = clod.run("run", BOX, "-t", "1", "--set", "stages.0.duration=1 ms",
                        "--set", "stages.1.duration=1 ms", "--set", "stages.2.duration=1 ms",
                        cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(os.path.exists(self.path("run/box/series.csv")))

    def test_default_folders_of_cases_of_one_name(self):
        """X/case.yaml goes into run/X, from whichever folder it is run."""
        for name, case in (("ore", "ore/case.yaml"), ("coal", "./coal/case.yaml"),
                           (os.path.basename(self.folder), "case.yaml")):
            os.makedirs(self.path(os.path.dirname(case)), exist_ok=True)
            shutil.copy(BOX, self.path(case))
            sets = ["--set", f"title={name}"]
            for stage in range(3):
                sets += ["--set", f"stages.{stage}.duration=1 ms"]
            done = clod.run("run", case, "-t", "1", *sets, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path(f"run/{name}/summary.json")) as file:
                self.assertEqual(json.load(file)["title"], name)

    def test_input_is_not_written_over(self):
        with open(self.path("points.csv"), "w") as file:
            file.write("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                       "10,8,3,4\n10,8,5,5\n10,8,7,6.5\n")
        shutil.copy(clod.source("cases/contact-bench/case.yaml"), self.path("bench.yaml"))
        os.symlink("points.csv", self.path("link.csv"))
        for verb, own, other in (("locus", "points.csv", "link.csv"),
                                 ("contact", "bench.yaml", "./bench.yaml")):
            before = clod.read(self.path(own))
            for name in (own, other):
                self.refused([verb, own, "-o", name],
                             f"clod {verb}: {name} is the file that is read", "name with -o")
            self.assertEqual(clod.read(self.path(own)), before)
            told = clod.run(verb, own, cwd=self.folder)
            self.assertEqual(told.returncode, 0, told.stderr)
            done = clod.run(verb, own, "-o", f"{verb}.csv", cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
            self.assertEqual(clod.read(self.path(f"{verb}.csv")).decode(), told.stdout)
            self.refused([verb, own, "-o", "none/out.csv"], "Does the folder exist?", code=1)
        self.assertEqual([name for name in os.listdir(self.folder) if "part" in name], [])
        said = self.refused(["locus", "none.csv"], "clod locus: none.csv: cannot be opened: No such")
        self.assertNotIn("folder", said)

    def test_where_output_goes(self):
        """The result alone on standard output; progress in plain lines when not a terminal."""
        begin = time.monotonic()
        done = clod.run("run", BOX, "-o", "out", "-t", "1", cwd=self.folder)
        seconds = time.monotonic() - begin
        self.assertEqual(done.returncode, 0, done.stderr)
        ended = re.match(r"time (\S+) s, ", done.stdout)
        self.assertAlmostEqual(float(ended[1]), 0.22, delta=2e-5, msg=done.stdout)  # two steps
        # the bed, three stages and why each ended, two walls
        self.assertEqual([line.split()[0] for line in done.stdout.splitlines()],
                         ["time", *3 * ["stage"], *2 * ["wall"]])
        self.assertNotIn("\r", done.stderr)
        self.assertNotIn("\033", done.stderr)
        # one line on the way at once and every 10 s, the last one at the end
        lines = done.stderr.splitlines()
        self.assertLessEqual(len(lines), 2 + seconds / 10, done.stderr)
        for line in lines[:-1]:
            self.assertRegex(line, r"^run +\w+ +\d\.\d{4} s, step \d+, \S+ grain-steps/s"
                                   r"(, at most \d+:\d\d:\d\d left of this part)?$")
        self.assertRegex(lines[-1], r"^run +drag +0\.22\d* s, step \d+, \S+ grain-steps/s$")

    def test_output_that_cannot_be_written(self):
        with open("/dev/full", "w") as full:
            done = clod.run("run", BOX, "-o", "out", "-t", "1", cwd=self.folder, stdout=full)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot be written to standard output", done.stderr)

    def physics(self, case, folder, stem):
        # some 5 times the critical step that `clod check` prints for these cases; it is not
        # refused at once because it would hold for the small overlaps under 1 Pa
        said = self.refused(["run", case, "-o", folder, "-t", "1", "--set", "time.step=0.4 ms",
                             "--set", "time.design_stress=1 Pa"], "time step", code=1)
        # an overlap beyond the limit, or a grain that has jumped, whichever is seen first
        self.assertRegex(said, r"step \d+: .*grain \d+.*time step.*(too large|clod check)")
        self.assertTrue(os.path.exists(self.path(f"{folder}/{stem}-failed_a.h5")))
        self.assertEqual([event["event"] for event in clod.log(self.path(folder))],
                         ["start", "stopped"])

    def test_physics_gone_wrong(self):
        self.physics(BOX, "box", "restart")
        self.physics(RING, "ring", "restart-preshear")

    def test_log(self):
        done = clod.run("run", BOX, "-o", "out", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        events = clod.log(self.path("out"))
        self.assertEqual([event["event"] for event in events],
                         ["start", *3 * ["phase"], "finished"])
        self.assertEqual([(event["from"], event["to"], event["reason"]) for event in events[1:4]],
                         [("settle", "compress", "its duration is over"),
                          ("compress", "drag", "its duration is over"),
                          ("drag", "end", "its duration is over")])
        with open(self.path("out/run.hdf.series")) as file:
            times = [entry["time"] for entry in json.load(file)["files"]]
        self.assertEqual(times, sorted(set(times)))
        for event in events[1:]:  # every stage's end is a snapshot
            self.assertIn(round(event["time_s"], 9), [round(time, 9) for time in times])


if __name__ == "__main__":
    clod.main()
