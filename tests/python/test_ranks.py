"""One simulation of a Python program on several ranks: same bits, and everybody ends when one fails."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod  # noqa: E402  the program
import mpirun  # noqa: E402

LIFE = """
import clod, ranks_life
lines = clod.on_ranks(ranks_life.life)
if lines is not None:
    print(*lines, sep="\\n")
"""
HEAD = """
import clod, ranks_life, sys
def make(ranks):
    return clod.Simulation(text=ranks_life.CASE, ranks=ranks)
"""


@unittest.skipUnless(os.environ.get("CLOD_MPI") == "1", "clod was built without MPI")
class Ranks(clod.Case):

    def script(self, ranks, text):
        return mpirun.python(ranks, "-c", HEAD + text)

    def test_same_bits(self):
        alone = mpirun.python(0, "-c", "import ranks_life; print(*ranks_life.life(), sep='\\n')")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        self.assertGreater(alone.stdout.count("\n"), 80)
        for ranks in (0, 1, 2, 3):
            done = mpirun.python(ranks, "-c", LIFE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout.splitlines(), alone.stdout.splitlines(), f"{ranks} ranks")

    def test_with(self):
        done = self.script(3, """
with clod.ranks() as ranks:
    if ranks.number == 0:
        with make(ranks) as sim:
            sim.advance(100)
            print(ranks.size, len(sim), sim.step)
        with make(ranks) as sim:
            print(sim.step)
print(" after ", flush=True)  # mpirun may put the lines of three processes behind each other
""")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(done.stdout.split()), ["0", "100", "120", "3", *3 * ["after"]])

    def test_a_view_that_is_not_valid_any_more_has_no_numbers(self):
        done = self.script(2, """
def program(ranks):
    with make(ranks) as sim:
        position, id = sim.position, sim.id
        sim.advance(1)
        assert (position != position).all() and (id == 2**64 - 1).all()
        high = sim.position
        sim.energies()
        assert (high == sim.position).all()
clod.on_ranks(program)
""")
        self.assertEqual(done.returncode, 0, done.stderr)

    def assert_ends(self, text, *words, status=1, ranks=3):
        done = self.script(ranks, text)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        return done

    def test_an_exception_of_rank_0(self):
        done = self.assert_ends("""
def program(ranks):
    with make(ranks) as sim:
        sim.advance(10)
        raise ValueError("no luck")
clod.on_ranks(program)
print("here", flush=True)
""", "ValueError: no luck")
        self.assertLessEqual(done.stdout.count("here"), 2)  # not on rank 0

    def test_an_exception_that_leaves_the_simulation_open(self):
        self.assert_ends("""
ranks = clod.ranks()
if ranks.number == 0:
    sim = make(ranks)
    sim.advance(10)
    position = sim.position
    1 / 0
ranks.serve()
""", "ZeroDivisionError")

    def test_an_error_of_clod(self):
        done = self.assert_ends("""
def program(ranks):
    with clod.Simulation("none.yaml", ranks=ranks) as sim:
        sim.advance(1)
clod.on_ranks(program)
""", "none.yaml")
        self.assertEqual(done.stderr.count("clod._library.Error"), 1, done.stderr)

    def test_an_exit_status(self):
        self.assert_ends("""
def program(ranks):
    with make(ranks) as sim:
        sim.advance(10)
        sys.exit(7)
clod.on_ranks(program)
""", status=7)

    def test_a_process_that_dies(self):
        self.assert_ends("""
import os
ranks = clod.ranks()
if ranks.number == 0:
    sim = make(ranks)
    sim.advance(10)
    os._exit(3)
""", status=3)

    def test_a_process_that_forgets_which_one_it_is(self):
        self.assert_ends("""
with clod.ranks() as ranks:
    with make(ranks) as sim:
        sim.advance(10)
        print(sim.step)
""", "this is rank 1 of 2", ranks=2)

    def test_ranks_are_to_be_given(self):
        self.assert_ends("make(None)", "clod.ranks")

    def test_mpi_begins_once(self):
        self.assert_ends("""
clod.on_ranks(lambda ranks: None)
clod.on_ranks(lambda ranks: None)
""", "MPI has ended in this process", ranks=2)

    def test_a_communicator_is_mpi4py_s(self):
        self.assert_ends("clod.ranks(comm=3)", "mpi4py", ranks=0)


if __name__ == "__main__":
    clod.main()
