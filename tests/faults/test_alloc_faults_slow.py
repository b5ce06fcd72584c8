"""All calls for memory of every verb, up to the 2 000th, fail in turn; about an hour.

Of those that take long it is every 50th.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod
from test_alloc_faults import LIBRARIES, LONG, MOST, VERBS, AllocFaults


class AllAllocFaults(AllocFaults):

    def numbers(self, verb, calls):
        return range(1, min(calls, MOST) + 1, 50 if verb in LONG else 1)

    def test_calls_of_libraries(self):
        for library in LIBRARIES:
            self.check(VERBS, library)


del AllocFaults  # its tests are those of the other file

if __name__ == "__main__":
    clod.main()
