"""clod_sim (include/clod/sim.h) as an object; its arrays are views onto its memory."""

import itertools
import json
import os

import numpy

from ._library import CONTACT, TYPES, Error, ffi, lib
from ._wall import Wall


class _View:
    """Memory of a simulation as NumPy takes it; keeps the simulation alive."""

    def __init__(self, simulation, view):
        self.simulation = simulation
        itemsize = numpy.dtype(TYPES[view.type]).itemsize
        shape, strides = (view.rows,), (view.stride,)
        if view.components > 1:
            shape, strides = shape + (view.components,), strides + (itemsize,)
        self.__array_interface__ = {
            "version": 3, "shape": shape, "strides": strides, "typestr": TYPES[view.type],
            "data": (int(ffi.cast("uintptr_t", view.data)), not view.writable)}


class Simulation:
    """A simulation made from a case file, or from the text of one.

    Arrays (position, velocity, angular_velocity, force, torque, radius, mass, inverse_inertia,
    id, material) are views: they are valid until the next advance, change, energies, contacts,
    measure or file, which may sort the rows. Copy what is to be kept.

    ranks: of clod.ranks or clod.on_ranks, that compute it together; this process is number 0 of them.
    Then a view that is not valid any more has nan in it, or ids and materials that nobody has.

    Where mpirun started several processes, each_process=True gives this one a simulation of its own;
    without that or ranks it is an error.

    series_units has the units of series_row() by name once a row was taken.
    """

    series_units = {}

    def __init__(self, path=None, text=None, threads=0, simd=None, each_process=False,
                 ranks=None):
        if (path is None) == (text is None):
            raise TypeError("give either the path of a case, or its text")
        self._status = ffi.new("clod_status *")
        options = ffi.new("clod_sim_options *")
        options.threads = threads
        simd_text = ffi.new("char[]", simd.encode()) if simd is not None else ffi.NULL
        options.simd = simd_text
        options.each_process = each_process
        options.ranks = ranks._pointer() if ranks is not None else ffi.NULL
        self._ranks = ranks  # they stay as long as the simulation
        self._sim = ffi.new("clod_sim **")
        if path is not None:
            self._sim[0] = lib.clod_sim_create_from_file(os.fsencode(path), options,
                                                         self._status)
        else:
            self._sim[0] = lib.clod_sim_create_from_text(b"case", text.encode(), options,
                                                         self._status)
        if self._sim[0] == ffi.NULL:
            raise Error(self._status)

    def close(self):
        """Free it; views of it must not be used any more."""
        lib.clod_sim_destroy(self._sim)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        if hasattr(self, "_sim"):
            self.close()

    def _pointer(self):
        if self._sim[0] == ffi.NULL:
            raise ValueError("this simulation is closed")
        return self._sim[0]

    def _call(self, function, *arguments):
        if not function(self._pointer(), *arguments, self._status):
            raise Error(self._status)

    # ---- time

    def advance(self, steps):
        """Advance by a number of steps."""
        self._call(lib.clod_sim_advance, int(steps))

    time = property(lambda self: lib.clod_sim_time(self._pointer()), doc="s simulated")
    dt = property(lambda self: lib.clod_sim_dt(self._pointer()), doc="s, time step")
    step = property(lambda self: lib.clod_sim_step(self._pointer()), doc="steps done")

    def set_adhesion(self, fraction):
        """k_adh and other pulls as a fraction of the case's, from now on."""
        self._call(lib.clod_sim_set_adhesion, float(fraction))

    # ---- grains

    def __len__(self):
        return lib.clod_sim_grain_count(self._pointer())

    def array(self, name):
        """View of a property of all grains, without a copy."""
        view = ffi.new("clod_sim_view *")
        self._call(lib.clod_sim_array, name.encode(), view)
        return numpy.asarray(_View(self, view))

    def __getattr__(self, name):
        if name in ARRAYS:
            return self.array(name)
        raise AttributeError(f"a Simulation has no '{name}'; its arrays are {', '.join(ARRAYS)}")

    def row(self, grain):
        """Row of the grain with this id, now."""
        rows = numpy.nonzero(self.array("id") == grain)[0]
        if len(rows) == 0:
            raise KeyError(f"there is no grain {grain}")
        return int(rows[0])

    def set_radii(self, radii):
        """Give the grains other radii (m, in the order of the rows); masses and inertias follow."""
        radii = numpy.ascontiguousarray(radii, dtype=float)
        if radii.shape != (len(self),):
            raise ValueError(f"{radii.shape} radii; there are {len(self)} grains")
        self._call(lib.clod_sim_set_radii, ffi.from_buffer("double[]", radii))

    def positions_changed(self):
        """To be called after writing positions."""
        self._call(lib.clod_sim_positions_changed)

    def add_grain(self, id, position, radius, velocity=(0, 0, 0), angular_velocity=(0, 0, 0),
                  material=0):
        """Ask for a grain to come, before the next step or by change()."""
        grain = ffi.new("clod_sim_grain *")
        grain.id, grain.radius, grain.material = id, radius, material
        grain.position, grain.velocity = list(position), list(velocity)
        grain.angular_velocity = list(angular_velocity)
        self._call(lib.clod_sim_add_grain, grain)

    def remove_grain(self, id):
        """Ask for a grain to go."""
        self._call(lib.clod_sim_remove_grain, int(id))

    def add_wall(self, name, wall):
        """Ask for a wall to come; wall: what stands below its name in a case, as a dict or as YAML.

            sim.add_wall("chute", {"material": "steel", "shapes": [
                {"box": {"center": "0 0 -5 mm", "size": "100 20 10 mm"}}]})

        It may have a load or an oscillation.
        """
        text = wall if isinstance(wall, str) else json.dumps(wall)
        self._call(lib.clod_sim_add_wall_from_text, name.encode(), text.encode())

    def remove_wall(self, name):
        """Ask for a wall to go."""
        self._call(lib.clod_sim_remove_wall, name.encode())

    def change(self):
        """Do now what was asked for."""
        self._call(lib.clod_sim_change)

    # ---- contacts, walls, measures

    def contacts(self):
        """Copy of all closed contacts with their history; a structured array.

        Fields: id_1, id_2 (of grains; with a wall id_2 is 0), row_1, row_2 (of the moment), wall
        and shape (-1 without), then what a contact remembers: plastic [m^n], tangent [N/m],
        spring [m], roll [rad] (clod.CONTACT_UNITS).
        """
        first, count = ffi.new("clod_sim_contact **"), ffi.new("size_t *")
        self._call(lib.clod_sim_contacts, first, count)
        size = count[0] * CONTACT.itemsize
        return numpy.frombuffer(ffi.buffer(first[0], size), CONTACT).copy() if size > 0 \
            else numpy.empty(0, CONTACT)

    def _found(self, function, *which):
        contact, found = ffi.new("clod_sim_contact *"), ffi.new("bool *")
        self._call(function, *which, contact, found)
        if not found[0]:
            return None
        return numpy.frombuffer(ffi.buffer(contact), CONTACT).copy()[0]

    def contact_of(self, id_1, id_2):
        """The contact of two grains, by their ids; None: there is none.

        spring and roll are those of grain id_1: in the other order they change their signs.
        """
        return self._found(lib.clod_sim_contact_of, int(id_1), int(id_2))

    def wall_contact_of(self, id, wall, shape=0):
        """The contact of a grain, by its id, with a shape of a wall, by its name; None: there is none."""
        return self._found(lib.clod_sim_wall_contact_of, int(id), Wall(self, wall)._index(),
                           int(shape))

    @property
    def walls(self):
        """Walls by name."""
        made = {}
        for index in range(lib.clod_sim_wall_count(self._pointer())):
            wall = ffi.new("clod_sim_wall *")
            self._call(lib.clod_sim_wall_look, index, wall)
            name = ffi.string(wall.name).decode()
            made[name] = Wall(self, name)
        return made

    def reset_wall_means(self):
        """Begin the means of force and torque of all walls anew."""
        lib.clod_sim_reset_wall_means(self._pointer())

    def _numbers(self, function, kind):
        made = ffi.new(f"{kind} *")
        self._call(function, made)
        return {name: getattr(made, name) for name, _ in ffi.typeof(kind).fields}

    def energies(self):
        """J: translation, rotation, potential, normal, sliding, rolling."""
        return self._numbers(lib.clod_sim_energies, "clod_sim_energy")

    def measure(self):
        """Numbers of contacts, coordination, overlaps (fractions), largest speed [m/s]."""
        return self._numbers(lib.clod_sim_measure, "clod_sim_bed")

    def left(self):
        """Grains that left through each side of a domain with open: delete.

        By side (x_min, x_max, y_min ...): grains, mass [kg], energy [J, kinetic].
        """
        made = ffi.new("clod_sim_exchange *")
        self._call(lib.clod_sim_exchange_look, made)
        return {f"{axis}_{end}": {"grains": side.grains, "mass": side.mass, "energy": side.energy}
                for (axis, end), side in zip(itertools.product("xyz", ("min", "max")), made.left)}

    def exchange(self):
        """Grains added and removed by requests, their masses [kg], and walls removed."""
        made = self._numbers(lib.clod_sim_exchange_look, "clod_sim_exchange")
        del made["left"]
        return made

    def open_ledger(self):
        """Open the energy ledger now; it is open from the start with output: {energy: true}."""
        self._call(lib.clod_sim_open_ledger)

    def ledger(self):
        """J since it was opened: plastic, dash_pot, friction, rolling, lag, wall_work, exchanged, residual."""
        return self._numbers(lib.clod_sim_ledger_look, "clod_sim_ledger")

    # ---- series

    def open_series(self):
        """Measure what the case asks for from now on: gauges, clumps, surfaces, belts, balance.

        It is open from the start when the case has inlets. Its columns are those of the walls of this
        moment; those of a wall that is removed have nan from then on.
        """
        self._call(lib.clod_sim_open_series)

    def _row(self):
        first, count = ffi.new("clod_sim_column **"), ffi.new("size_t *")
        self._call(lib.clod_sim_series_row, first, count)
        return [first[0][k] for k in range(count[0])]

    def series_row(self):
        """Take a row: values of the columns of series.csv by name, with rates and means since the
        row before."""
        row = self._row()
        names = [ffi.string(column.name).decode() for column in row]
        if len(set(names)) < len(names):
            twice = sorted({name for name in names if names.count(name) > 1})
            raise ValueError(f"two columns of the series have one name: {', '.join(twice)}; rename a wall")
        self.series_units = dict(zip(names, (ffi.string(column.unit).decode() for column in row)))
        return {name: column.value for name, column in zip(names, row)}

    # ---- files

    def write_checkpoint(self, folder):
        """Write a checkpoint into a results folder."""
        self._call(lib.clod_sim_write_checkpoint, os.fsencode(folder))

    def read_checkpoint(self, folder, part=None):
        """Go on from the newest checkpoint in a folder, of the same case."""
        self._call(lib.clod_sim_read_checkpoint, os.fsencode(folder),
                   part.encode() if part is not None else ffi.NULL)

    def write_snapshot(self, folder, contacts=False):
        """Write grains and walls for ParaView into a results folder."""
        self._call(lib.clod_sim_write_snapshot, os.fsencode(folder), contacts)


ARRAYS = [ffi.string(lib.clod_sim_array_name(k)).decode()
          for k in range(lib.clod_sim_array_count())]
