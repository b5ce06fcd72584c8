"""Processes of mpirun that step one simulation together (include/clod/ranks.h)."""

import weakref

from ._library import Error, ffi, lib


class Ranks:
    """The processes that mpirun has started with this one; number 0 drives, the others compute.

        with clod.ranks() as ranks:           # in all of them
            if ranks.number == 0:
                with clod.Simulation("case.yaml", ranks=ranks) as sim:
                    ...                       # the whole program
        # here the others have computed all that number 0 asked for

    comm: an mpi4py communicator, all of whose processes make this call, in place of all that were
    started: so groups of them can step a simulation each. Without mpi4py MPI begins here and ends with
    close, and cannot begin again: make ranks once, for one simulation after the other.
    """

    def __init__(self, comm=None):
        status = ffi.new("clod_status *")
        if comm is not None and not hasattr(comm, "py2f"):
            raise TypeError("comm: give a communicator of mpi4py, for instance "
                            f"mpi4py.MPI.COMM_WORLD, not {comm!r}")
        opened = lib.clod_ranks_open(status) if comm is None \
            else lib.clod_ranks_open_group(comm.py2f(), status)
        if opened == ffi.NULL:
            raise Error(status)
        self._ranks = ffi.new("clod_ranks **", opened)
        self.number = lib.clod_ranks_number(opened)
        self.size = lib.clod_ranks_size(opened)
        # at the end of the program too, and before mpi4py ends MPI
        self._close = weakref.finalize(self, lib.clod_ranks_close, self._ranks)

    def _pointer(self):
        if self._ranks[0] == ffi.NULL:
            raise ValueError("these ranks are closed")
        return self._ranks[0]

    def serve(self):
        """Compute what number 0 asks for until it closes the ranks; on number 0 nothing."""
        lib.clod_ranks_serve(self._pointer())

    def close(self):
        """Leave them: number 0 lets the others go, and these serve until it does.

        A simulation that still uses them can be read and closed from then on.
        """
        self._close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def ranks(comm=None):
    """The processes that mpirun has started with this one, or those of an mpi4py communicator."""
    return Ranks(comm)


def on_ranks(program, comm=None):
    """Call program(ranks) in process number 0 and return what it returns; the others compute and get None.

        def program(ranks):
            with clod.Simulation("case.yaml", ranks=ranks) as sim:
                sim.advance(1000)
                return sim.energies()

        energies = clod.on_ranks(program)

    An exception in the program lets the others go, and is raised in process number 0 alone.
    comm: as of clod.ranks.
    """
    with Ranks(comm) as joined:
        return program(joined) if joined.number == 0 else None
