"""A wall of a simulation (include/clod/sim.h) as an object."""

import numpy

from ._library import ffi, lib


def _three(value):
    return ffi.new("double[3]", list(value))


class Wall:
    """A wall of a simulation, by its name: what it feels, and its motion, which may be set."""

    def __init__(self, simulation, name):
        self._simulation, self.name = simulation, name

    def _index(self):
        index = lib.clod_sim_wall_index(self._simulation._pointer(), self.name.encode())
        if index < 0:
            raise KeyError(f"there is no wall '{self.name}'")
        return index

    def _look(self):
        wall = ffi.new("clod_sim_wall *")
        self._simulation._call(lib.clod_sim_wall_look, self._index(), wall)
        return wall

    def _set(self, function, *values):
        self._simulation._call(function, self._index(), *values)

    def _vector(self, name):
        return numpy.array(list(getattr(self._look(), name)))

    force = property(lambda self: self._vector("force"), doc="N, of the grains, last step")
    torque = property(lambda self: self._vector("torque"), doc="N m, last step")
    mean_force = property(lambda self: self._vector("mean_force"),
                          doc="N, since Simulation.reset_wall_means")
    mean_torque = property(lambda self: self._vector("mean_torque"), doc="N m, likewise")
    power = property(lambda self: self._look().power, doc="W, done on the grains, last step")
    angle = property(lambda self: self._look().angle, doc="rad, turned so far")
    angular_velocity = property(lambda self: self._vector("angular_velocity"),
                                doc="rad/s, spin along its axis; set_angular_velocity sets it")
    material_velocity = property(
        lambda self: self._vector("material_velocity"),
        doc="m/s, of the material: velocity, load servo, oscillation, surface_velocity")
    material_spin = property(lambda self: self._look().material_spin,
                             doc="rad/s, of the material: spin, oscillation")

    @property
    def position(self):
        """m, from where the case puts it; may be set."""
        return self._vector("position")

    @position.setter
    def position(self, value):
        self._set(lib.clod_sim_set_wall_position, _three(value))

    @property
    def velocity(self):
        """m/s, of the whole wall; setting it drives the wall. A load and an oscillation add to it."""
        return self._vector("velocity")

    @velocity.setter
    def velocity(self, value):
        self._set(lib.clod_sim_set_wall_velocity, _three(value))

    @property
    def surface_velocity(self):
        """m/s, of a belt on all shapes: the wall stays where it is; may be set."""
        return self._vector("surface_velocity")

    @surface_velocity.setter
    def surface_velocity(self, value):
        self._set(lib.clod_sim_set_wall_surface_velocity, _three(value))

    def set_belt(self, shape=0, velocity=(0, 0, 0), speed=0, direction=(0, 0, 0), spin=0,
                 spin_axis=(0, 0, 0), spin_point=(0, 0, 0)):
        """Drive the belt of one shape; all zero stops it.

        velocity [m/s]; speed [m/s] along the projection of direction onto the surface; spin [rad/s]
        about spin_axis through spin_point [m]; in the frame in which the wall was given.
        """
        belt = ffi.new("clod_sim_belt *")
        belt.velocity, belt.speed, belt.direction = list(velocity), speed, list(direction)
        belt.spin, belt.spin_axis, belt.spin_point = spin, list(spin_axis), list(spin_point)
        self._set(lib.clod_sim_set_belt, int(shape), belt)

    def belt(self, shape=0):
        """The belt of one shape; keyword arguments of set_belt."""
        belt = ffi.new("clod_sim_belt *")
        self._simulation._call(lib.clod_sim_belt_look, self._index(), int(shape), belt)
        return {name: getattr(belt, name) if name in ("speed", "spin")
                else list(getattr(belt, name)) for name, _ in ffi.typeof("clod_sim_belt").fields}

    @property
    def spin(self):
        """rad/s about its spin axis; may be set. An oscillation adds to it."""
        return self._look().spin

    @spin.setter
    def spin(self, value):
        self._set(lib.clod_sim_set_wall_spin, float(value))

    @property
    def orientation(self):
        """Quaternion w, x, y, z from the frame in which the wall was given; may be set."""
        return self._vector("orientation")

    @orientation.setter
    def orientation(self, value):
        self._set(lib.clod_sim_set_wall_orientation, ffi.new("double[4]", list(value)))

    def set_angular_velocity(self, value, point):
        """rad/s about a point of space (m) from now on; the wall stays where it is."""
        self._set(lib.clod_sim_set_wall_angular_velocity, _three(value), _three(point))

    @property
    def load(self):
        """N that its load aims at; may be set to 0 or more that the time step bears."""
        return self._look().load

    @load.setter
    def load(self, value):
        self._set(lib.clod_sim_set_wall_load, float(value))
