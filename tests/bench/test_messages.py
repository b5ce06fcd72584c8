"""bench_messages and what bench_step says of each rank, under mpirun: numbers that fit together."""

import json
import os
import subprocess
import unittest

import scaling_path
import compare

FOLDER = os.path.join(os.path.dirname(os.environ.get("CLOD_BINARY", "")), "bench")
PACKING = [os.path.join(scaling_path.SOURCE, "bench", "packings", "pack_4k." + end)
           for end in ("csv", "box")]
MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca",
          "mpi_yield_when_idle", "1", "--mca", "btl", "self,vader", "-n"]
RANKS, STEPS, WARM = 3, 40, 7


def run(program, *arguments):
    """JSON lines of a program on some ranks."""
    done = subprocess.run([*MPIRUN, str(RANKS), os.path.join(FOLDER, program), *arguments],
                          capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
@unittest.skipUnless(os.path.exists(os.path.join(FOLDER, "bench_messages")), "it was not built")
class Messages(unittest.TestCase):
    def test_each_test_has_its_line(self):
        lines = run("bench_messages")
        self.assertEqual(lines[0]["hosts"], 1)
        tests = {(line["test"], line["pairs"]) for line in lines[1:]}
        self.assertEqual(tests, {
            ("work", "all"), ("merge", "all"), ("tell", "all"), ("gather", "all"), ("swap", "all"),
            ("halo", "all"), ("meeting", "all"),
            *((test, pairs) for test in ("pingpong", "exchange", "kept")
              for pairs in ("near", "far", "all"))})
        for line in lines[1:]:
            self.assertTrue(0 < line["least"] <= line["lower"] <= line["median"] <= line["upper"]
                            <= line["p99"] <= line["most"], line)
        # 21 blocks of each rank that takes part: of pairs two, the third is left over
        blocks = {line["test"] + line["pairs"]: line["blocks"] for line in lines[1:]}
        self.assertEqual((blocks["keptnear"], blocks["keptall"], blocks["mergeall"]), (42, 42, 63))

    def test_ranks_say_what_they_did(self):
        lines = run("bench_step", *PACKING, "--steps", str(STEPS), "--warm", str(WARM))
        said, = compare.runs_of(lines)
        self.assertEqual(sum(said.own), said.grains)
        self.assertEqual(sorted(w["rank"] for w in said.watched), list(range(RANKS)))
        for w in said.watched:
            self.assertEqual(w["steps"], STEPS - 1)
            self.assertEqual(w["neighbours"], RANKS - 1)
            self.assertEqual(w["merges"], STEPS - 1)  # a bed at rest: one in each step
            self.assertEqual(w["messages"], (STEPS - 1) * (RANKS - 1))
            self.assertEqual(w["bytes"], (STEPS - 1) * w["ghost_bytes_out"])
            self.assertGreater(w["worked_s"], 0.0)
            self.assertGreaterEqual(w["wall_s"], w["waited_s"])
        self.assertEqual(sum(w["ghost_bytes_in"] for w in said.watched),
                         sum(w["ghost_bytes_out"] for w in said.watched))


if __name__ == "__main__":
    unittest.main()
