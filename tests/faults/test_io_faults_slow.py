"""The sweeps of test_io_faults.py over every single call."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import test_io_faults as sample
from io_faults import clod


class EveryCall(sample.Run):

    EVERY = 1


if __name__ == "__main__":
    clod.main()
