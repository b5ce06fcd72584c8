"""Groups of ranks by communicators of mpi4py. Skipped where mpi4py or MPI is not installed."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod  # noqa: E402  the program
import mpirun  # noqa: E402

HEAD = """
from mpi4py import MPI
import clod, ranks_life
world = MPI.COMM_WORLD
def seed(k):
    return ranks_life.CASE + f"seed: {k}\\n"
"""


class Mpi4py(clod.Case):

    def script(self, ranks, text):
        done = mpirun.python(ranks, "-c", HEAD + text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.splitlines()

    def test_all_processes(self):
        alone = mpirun.python(0, "-c", "import ranks_life; print(*ranks_life.life(), sep='\\n')")
        for ranks in (1, 3):
            self.assertEqual(self.script(ranks, """
lines = clod.on_ranks(ranks_life.life, world)
if lines is not None:
    print(*lines, sep="\\n")
"""), alone.stdout.splitlines())

    def test_groups_step_one_seed_each(self):
        alone = [line for k in range(2) for line in mpirun.python(
            0, "-c", HEAD + f"print(*ranks_life.life(text=seed({k})), sep='\\n')").stdout.splitlines()]
        self.assertGreater(len(set(alone)), 0.7 * len(alone))  # two seeds
        self.assertEqual(self.script(5, """
which = world.rank % 2  # groups of 3 and 2
group = world.Split(which)
lines = clod.on_ranks(lambda ranks: ranks_life.life(ranks, seed(which)), group)
found = world.gather((which, lines))
if world.rank == 0:
    for _, lines in sorted(one for one in found if one[1] is not None):
        print(*lines, sep="\\n")
"""), alone)

    def test_ranks_again_and_again(self):
        self.assertEqual(self.script(2, """
def steps(ranks):
    with clod.Simulation(text=ranks_life.CASE, ranks=ranks) as sim:
        sim.advance(10)
        return sim.step
found = [clod.on_ranks(steps, world), clod.on_ranks(steps), clod.on_ranks(steps, MPI.COMM_SELF)]
print(world.gather(found)) if world.rank == 0 else world.gather(found)
"""), ["[[10, 10, 10], [None, None, 10]]"])

    def test_mpi_in_one_process_alone(self):
        self.assertEqual(self.script(0, """
with clod.Simulation(text=ranks_life.CASE) as sim:
    print(len(sim))
with clod.Simulation(text=ranks_life.CASE, ranks=clod.ranks()) as sim:
    print(len(sim))
print(clod.on_ranks(lambda ranks: ranks.size, world))
"""), ["120", "120", "1"])

    def test_no_communicator(self):
        self.assertIn("MPI_COMM_NULL", self.script(1, """
try:
    clod.ranks(MPI.COMM_NULL)
except clod.Error as error:
    print(error)
""")[0])

    def test_an_exception_ends_all_with_mpi4py_s_runner(self):
        path = self.path("fails.py")
        with open(path, "w") as file:
            file.write(HEAD + """
def program(ranks):
    with clod.Simulation(text=ranks_life.CASE, ranks=ranks) as sim:
        sim.advance(10)
        raise ValueError("no luck")
clod.on_ranks(program, world)
world.barrier()  # where number 0 never comes
""")
        done = mpirun.python(3, "-m", "mpi4py", path)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("ValueError: no luck", done.stderr)


if __name__ == "__main__":
    if os.environ.get("CLOD_MPI") != "1":
        print("skipped: clod was built without MPI")
        sys.exit(77)
    mpirun.need("mpi4py")
    clod.main()
