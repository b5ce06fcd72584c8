"""As test_mpirun_kill.py, at fifty moments."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
import rank_kills


@clod.quick_only
class Killed(rank_kills.Kills):

    def test_a_rank_is_killed(self):
        self.go_on_after(50)


if __name__ == "__main__":
    clod.main()
