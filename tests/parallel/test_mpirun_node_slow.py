"""A whole node dies at a random moment: its ranks, and what started them there, all at once. The rest ends
by itself, a whole checkpoint is left, and the same command goes on to the same bytes.

Two nodes of one machine: mpirun has the ranks of one, an orted beside it those of the other, and ranks talk
over TCP. Open MPI 4; its launcher for hosts starts the orted here instead.
"""

import contextlib
import os
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import rank_kills

KILLS = 20
LONGEST = 60.0  # s until the other node is empty; the machine may have other work
TCP = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca",
       "mpi_yield_when_idle", "1", "--mca", "btl", "self,tcp", "--mca", "btl_tcp_if_include", "lo",
       "--mca", "oob_tcp_if_include", "lo"]


def children(process, name):
    """Process numbers of the children of that name."""
    found = subprocess.run(["ps", "-o", "pid=,comm=", "--ppid", str(process)], text=True,
                           stdout=subprocess.PIPE, check=False).stdout
    return [int(line.split()[0]) for line in found.splitlines() if line.split()[1] == name]


def runs(process):
    """Whether a process is there, and has not ended yet."""
    try:
        with open(f"/proc/{process}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


@clod.quick_only
class Node(rank_kills.Kills):

    def setUp(self):
        super().setUp()
        self.struck = {"that of mpirun and rank 0": [], "the other": []}  # s until the rest ended
        with open(self.path("agent"), "w") as file:
            file.write('shift  # the host\nexec sh -c "exec $*"\n')

    def start(self, ranks, out):
        hosts = f"localhost:{ranks - ranks // 2},other:{ranks // 2}"
        return subprocess.Popen([*TCP, "--mca", "plm_rsh_agent", f"sh {self.path('agent')}",
                                 "--host", hosts, "-n", str(ranks), *self.command(out)],
                                text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def strike(self, dice, process):
        """Kill all of one node, if all of both still run; wait for the end of the other."""
        launcher = children(process.pid, "orted")
        here = children(process.pid, "clod")
        there = children(launcher[0], "clod") if launcher else []
        if not here or not there:
            return
        nodes = {"that of mpirun and rank 0": [process.pid, *here],
                 "the other": [launcher[0], *there]}
        name = dice.choice(list(nodes))
        for one in nodes[name]:
            with contextlib.suppress(ProcessLookupError):  # the run may just end
                os.kill(one, signal.SIGKILL)
        begin = time.monotonic()
        rest = [one for node in nodes if node != name for one in nodes[node]]
        while any(map(runs, rest)):
            self.assertLess(time.monotonic() - begin, LONGEST, f"seed {rank_kills.SEED}")
            time.sleep(0.01)
        self.struck[name].append(time.monotonic() - begin)

    def assert_killed(self, process, text):
        """An mpirun that is left names the node; one that was killed says nothing."""
        if process.returncode != -signal.SIGKILL:
            self.assertRegex(text, "lost communication with a remote daemon[^/]*on node other")

    def test_a_node_is_killed(self):
        self.go_on_after(KILLS)
        for name, times in self.struck.items():
            self.assertTrue(times, f"seed {rank_kills.SEED}: {name} was never killed")
            print(f"{name} killed {len(times)} times: the rest ended within {min(times):.1f} to "
                  f"{max(times):.1f} s")


if __name__ == "__main__":
    clod.main()
