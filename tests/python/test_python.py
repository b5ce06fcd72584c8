"""The Python package: the same object and the same bits as the library, views without copies."""

import gc
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import clod as program  # noqa: E402  runs the command line

sys.modules.pop("clod")
sys.path.insert(0, os.environ["CLOD_PYTHON"])
import numpy  # noqa: E402

import clod  # noqa: E402

CASE = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: mepa, k1: 4.75e5 N/m^1.5, k2: 2.37e6 N/m^1.5, k_adh: 1e5 N/m^1.5,
                     restitution: 0.3, friction: 0.35}}
time: {step: 2e-6 s}
domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 100 mm], periodic: [true, true, false]}
stages: [{name: fall, duration: 0.02 s}]
walls: {floor: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}}
grains:
  - {material: ore, count: 60, radius: {distribution: uniform, min: 1.8 mm, max: 2 mm},
     region: {box: {min: [0 mm, 0 mm, 2 mm], max: [20 mm, 20 mm, 30 mm]}}}
output: {series_interval: 1 ms, contacts: true}
"""


def make(**more):
    return clod.Simulation(text=CASE, threads=1, **more)


STREAM = """\
materials: {ore: {density: 2500 kg/m3}}
contacts: {default: {law: hooke, k1: 5e3 N/m, restitution: 0.2, friction: 0.5}}
gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]
time: {step: 1e-4 s, design_stress: 100 Pa}
domain: {min: [-0.1 m, -0.3 m, -0.1 m], max: [1.2 m, 0.3 m, 0.2 m], open: delete}
grains:
  - material: ore
    radius: {distribution: uniform, min: 4.9 mm, max: 5.1 mm}
    inlet: {mass_flow: 0.6 kg/s}
    region: {box: {min: [10 mm, -150 mm, 10 mm], max: [60 mm, 150 mm, 30 mm]}}
    velocity: [0.5 m/s, 0 m/s, -0.5 m/s]
walls:
  feed:
    material: ore
    shapes:
      - belt: {from: [0 m, 0 m, 0 m], runs: [{length: 0.3 m}], width: 400 mm, speed: 2 m/s}
outlets:
  head: {region: {box: {min: [0.25 m, -0.3 m, -0.1 m], max: [0.4 m, 0.3 m, 0.2 m]}}}
gauges:
  all:
    region: {box: {min: [0 m, -0.3 m, -0.1 m], max: [0.2 m, 0.3 m, 0.2 m]}}
    direction: [1, 0, 0]
    belt: feed
clumps: {}
build_up: {}
stages: [{name: run, duration: 0.4 s}]
output: {series_interval: 50 ms, surfaces: true}
"""


class Python(program.Case):

    def test_arrays_are_views(self):
        with make() as sim:
            self.assertEqual(sim.position.shape, (60, 3))
            self.assertEqual((len(sim), sim.radius.shape, sim.id.dtype), (60, (60,), "u8"))
            before = sim.velocity[7].copy()
            sim.velocity[7] += [0, 0, 1]
            numpy.testing.assert_array_equal(sim.velocity[7], before + [0, 0, 1])
            self.assertTrue(numpy.shares_memory(sim.velocity, sim.velocity))
            with self.assertRaises(ValueError):
                sim.radius[0] = 1.0  # not writable
            sim.set_radii(1.01 * sim.radius)
            before = sim.mass.copy()
            sim.set_radii(sim.radius / 1.01)
            numpy.testing.assert_allclose(before / sim.mass, 1.01**3, rtol=1e-12)
            with self.assertRaisesRegex(ValueError, r"\(2,\) radii; there are 60 grains"):
                sim.set_radii([1e-3, 1e-3])

    def test_free_fall(self):
        """A grain alone: z0 - g t^2/2, by hand."""
        with make() as sim:
            sim.add_grain(1000, [0.01, 0.01, 0.09], 1e-3)
            sim.advance(1000)
            row = sim.row(1000)
            self.assertAlmostEqual(sim.position[row, 2], 0.09 - 0.5 * 9.81 * (1000 * 2e-6)**2,
                                   delta=1e-15)
            self.assertAlmostEqual(sim.velocity[row, 2], -9.81 * 2e-3, delta=1e-13)
            sim.remove_grain(1000)
            sim.change()
            with self.assertRaises(KeyError):
                sim.row(1000)

    def test_the_library_may_be_closed(self):
        """Threads that wait for their next step keep their code, also at the end of Python."""
        for close in ("", "_library.ffi.dlclose(_library.lib)\ntime.sleep(0.1)\n"):
            script = ("import sys, time\nimport clod\nfrom clod import _library\n"
                      "with clod.Simulation(text=sys.argv[1], threads=2) as sim:\n"
                      "    sim.advance(10)\n" + close)
            done = subprocess.run([sys.executable, "-B", "-c", script, CASE], check=False,
                                  env={**os.environ, "PYTHONPATH": os.environ["CLOD_PYTHON"],
                                       "OMP_WAIT_POLICY": "ACTIVE"})
            self.assertEqual(done.returncode, 0, close)

    def test_a_view_keeps_the_simulation(self):
        sim = make()
        position = sim.position
        kept = position.copy()
        del sim
        gc.collect()
        numpy.testing.assert_array_equal(position, kept)

    def test_weight_on_the_floor(self):
        with make() as sim:
            sim.advance(150000)
            sim.reset_wall_means()
            sim.advance(5000)
            weight = 9.81 * sim.mass.sum()
            self.assertAlmostEqual(-sim.walls["floor"].mean_force[2] / weight, 1.0, delta=0.02)
            contacts = sim.contacts()
            self.assertEqual(len(contacts), sim.measure()["pairs"] + sim.measure()["walls"])
            self.assertTrue((contacts["plastic"] > 0).any())
            self.assertTrue(numpy.isin(contacts["id_1"], sim.id).all())
            energy = sim.energies()
            v = sim.velocity
            self.assertAlmostEqual(energy["translation"] /
                                   (0.5 * (sim.mass * (v * v).sum(1)).sum()), 1, delta=1e-12)

    def test_contacts_have_the_fields_of_the_library(self):
        """The dtype is made from the library's list; here against the struct as the header has it."""
        from clod import _library
        with make() as sim:
            sim.advance(60000)
            contacts = sim.contacts()
            first, count = _library.ffi.new("clod_sim_contact **"), _library.ffi.new("size_t *")
            sim._call(_library.lib.clod_sim_contacts, first, count)
            self.assertEqual(len(contacts), count[0])
            self.assertGreater(count[0], 20)
            fields = _library.ffi.typeof("clod_sim_contact").fields
            self.assertEqual(contacts.dtype.names, tuple(name for name, _ in fields))
            self.assertEqual(tuple(clod.CONTACT_UNITS), contacts.dtype.names)
            for name, _ in fields:
                for k in range(count[0]):
                    value = getattr(first[0][k], name)
                    value = list(value) if name in ("spring", "roll") else value
                    numpy.testing.assert_array_equal(contacts[name][k], value)
            self.assertGreater(abs(contacts["spring"]).max(), 0)
            self.assertEqual(clod.CONTACT_UNITS["spring"], "m")

    def test_a_contact_by_its_identity(self):
        with make() as sim:
            sim.advance(60000)
            contacts = sim.contacts()
            self.assertGreater((contacts["wall"] < 0).sum(), 20)
            self.assertGreater((contacts["wall"] >= 0).sum(), 5)
            for there in contacts:
                if there["wall"] >= 0:
                    found = sim.wall_contact_of(there["id_1"], "floor", there["shape"])
                    self.assertEqual(found, there)
                    continue
                self.assertEqual(sim.contact_of(there["id_1"], there["id_2"]), there)
                turned = sim.contact_of(there["id_2"], there["id_1"])
                numpy.testing.assert_array_equal(turned["spring"], -there["spring"])
                self.assertEqual(turned["plastic"], there["plastic"])
            self.assertIsNone(sim.contact_of(contacts["id_1"][0], 999999))
            self.assertIsNone(sim.wall_contact_of(999999, "floor"))
            with self.assertRaises(KeyError):
                sim.wall_contact_of(1, "roof")
            with self.assertRaisesRegex(clod.Error, "no shape 1; it has 1"):
                sim.wall_contact_of(1, "floor", 1)

    def test_walls_are_driven(self):
        with make() as sim:
            floor = sim.walls["floor"]
            floor.velocity = [0, 0, -0.5]
            sim.advance(1000)
            numpy.testing.assert_allclose(floor.position, [0, 0, -0.5 * 2e-3], rtol=1e-12)
            floor.surface_velocity = [0.1, 0, 0]
            floor.set_angular_velocity([0, 0, -3], [0.01, 0.01, 0])
            numpy.testing.assert_array_equal(floor.velocity, [0, 0, -0.5])
            numpy.testing.assert_array_equal(floor.surface_velocity, [0.1, 0, 0])
            numpy.testing.assert_array_equal(floor.material_velocity, [0.1, 0, -0.5])
            numpy.testing.assert_array_equal(floor.angular_velocity, [0, 0, -3])
            floor.spin = 2 * floor.spin
            self.assertEqual(floor.material_spin, floor.spin)
            numpy.testing.assert_array_equal(floor.angular_velocity, [0, 0, -6])
            with self.assertRaises(AttributeError):
                floor.material_velocity = [0, 0, 0]
            sim.remove_wall("floor")
            sim.change()
            self.assertEqual(sim.walls, {})
            with self.assertRaises(KeyError):
                floor.force

    def test_walls_come_and_go(self):
        """A disc below takes the place of the floor, as a dict and as YAML: it carries the weight."""
        yaml = "material: ore\nshapes:\n  - plane: {point: [0 mm, 0 mm, -1 mm]}\n"
        plane = {"material": "ore", "shapes": [{"plane": {"point": "0 0 -1 mm"}}]}
        felt = []
        for wall in (yaml, plane):
            with make() as sim:
                sim.advance(60000)
                sim.remove_wall("floor")
                sim.add_wall("lower", wall)
                self.assertEqual(list(sim.walls), ["floor"])  # requests
                sim.change()
                self.assertEqual(list(sim.walls), ["lower"])
                sim.advance(60000)
                sim.reset_wall_means()
                sim.advance(5000)
                felt.append(sim.walls["lower"].mean_force)
                self.assertAlmostEqual(-felt[-1][2] / (9.81 * sim.mass.sum()), 1, delta=0.05)
                with self.assertRaisesRegex(clod.Error, "wall 'roof':1:3: walls.roof.colour: this key"):
                    sim.add_wall("roof", {"colour": "red"})
                sim.remove_wall("floor")
                with self.assertRaisesRegex(clod.Error, "there is none of this name"):
                    sim.change()
        numpy.testing.assert_array_equal(*felt)

    def test_the_series_is_that_of_a_run(self):
        """Rows taken at its times have the bits that `clod run` writes: its numbers end in the
        last digit that a double has. They go on through a checkpoint."""
        path = self.path("stream.yaml")
        with open(path, "w") as file:
            file.write(STREAM)
        folder = self.path("run")
        done = program.run("run", path, "-o", folder, "-t", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        columns, units = clod.results(folder).table("series")
        kept = self.path("kept")
        sim = clod.Simulation(path, threads=2)
        for row in range(8):
            sim.advance(200)
            sim.advance(300)
            found = sim.series_row()
            self.assertEqual(list(found), list(columns)[4:])
            self.assertEqual(sim.series_units, {name: units[name] for name in found})
            for name, value in found.items():
                numpy.testing.assert_array_equal(value, columns[name][row], f"{name}, row {row}")
            if row == 3:
                sim.write_checkpoint(kept)
                sim.close()
                sim = clod.Simulation(path, threads=1)
                sim.read_checkpoint(kept)
        self.assertGreater(found["inlet_1.grains"], 100)
        self.assertGreater(found["gauge_all.mass_flow"], 0.1)
        with self.assertRaisesRegex(clod.Error, "clod_sim_remove_wall: the series is open"):
            sim.remove_wall("feed")
        sim.close()
        with make() as sim:
            with self.assertRaisesRegex(clod.Error, "call clod_sim_open_series"):
                sim.series_row()
            sim.open_series()
            sim.advance(10)
            self.assertIn("floor.force_z", sim.series_row())

    def test_walls_that_are_added_have_no_sums(self):
        """The series tells what the surfaces of the case feel, and nothing of a wall that came later."""
        text = CASE.replace("contacts: true", "surfaces: true")
        with clod.Simulation(text=text, threads=1) as sim:
            sim.add_wall("lower", "material: ore\nshapes:\n  - plane: {point: [0 mm, 0 mm, -1 mm]}\n")
            sim.change()
            sim.open_series()
            sim.advance(60000)
            row = sim.series_row()
            self.assertGreater(row["surface_floor.impacts"], 0.0)
            self.assertGreater(row["surface_floor.impact_angle"], 0.0)
            self.assertEqual([name for name in row if name.startswith("surface_lower")], [])

    def test_a_lid_comes_with_its_load_while_the_series_is_open(self):
        """At rest the grains carry the load; the floor's columns end when it goes."""
        with make() as sim:
            sim.open_series()
            sim.advance(60000)
            columns = list(sim.series_row())
            top = (sim.position[:, 2] + sim.radius).max()
            sim.add_wall("lid", {"material": "ore", "load": {"force": "0.5 N", "mass": "50 g", "damping": 0.02},
                                 "shapes": [
                {"plane": {"point": ["0 mm", "0 mm", f"{1e3 * top + 0.1:.6f} mm"], "normal": [0, 0, -1]}}]})
            sim.advance(60000)
            lid = sim.walls["lid"]
            self.assertEqual(lid.load, 0.5)
            self.assertAlmostEqual(lid.force[2], 0.5, delta=0.01)
            row = sim.series_row()
            self.assertEqual(list(row), columns)
            self.assertLess(row["floor.force_z"], 0)
            sim.remove_wall("floor")
            sim.advance(10)
            row = sim.series_row()
            self.assertEqual(list(row), columns)
            self.assertTrue(numpy.isnan(row["floor.force_z"]))
            with self.assertRaisesRegex(clod.Error, "walls.b.load: must have exactly one of force, stress"):
                sim.add_wall("b", {"material": "ore", "load": {"mass": "1 kg"}, "shapes": [
                    {"plane": {"point": "0 0 -1 mm"}}]})

    def test_a_belt_carries_what_lies_on_it(self):
        with make() as sim:
            floor = sim.walls["floor"]
            sim.advance(60000)
            self.assertLess(abs(sim.velocity[:, 0].mean()), 0.01)
            floor.set_belt(speed=0.2, direction=[2, 0, 0])
            self.assertEqual(floor.belt()["direction"], [1, 0, 0])
            sim.advance(5000)
            self.assertGreater(sim.velocity[:, 0].mean(), 0.01)
            floor.set_belt(**{**floor.belt(), "speed": -0.2})
            self.assertEqual(floor.belt(0)["speed"], -0.2)
            sim.advance(1000)
            self.assertLess(floor.force[0] * -1, 0)  # now it is dragged the other way
            with self.assertRaisesRegex(clod.Error, "has no direction"):
                floor.set_belt(speed=1)
            with self.assertRaisesRegex(clod.Error, "no shape 1"):
                floor.belt(1)

    def test_the_bits_of_a_run(self):
        """clod run and Python end with the same bits; the results folder into arrays."""
        with open(self.path("case.yaml"), "w") as file:
            file.write(CASE)
        done = program.run("run", "case.yaml", "-o", "out", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        run = clod.results(self.path("out"))
        with clod.Simulation(self.path("case.yaml"), threads=2) as sim:
            sim.advance(10000)
            series = run.series()
            self.assertEqual(series["time"][-1], sim.time)
            self.assertEqual(series["floor.shift_z"][-1], 0)
            again = make()
            again.read_checkpoint(self.path("out"))
            self.assertEqual(again.step, 10000)
            order, other = numpy.argsort(sim.id), numpy.argsort(again.id)
            numpy.testing.assert_array_equal(sim.position[order], again.position[other])
            again.close()
        self.assertEqual(run.summary["grains"], 60)
        self.assertEqual(run.table()[1]["kinetic_energy"], "J")
        try:
            import h5py  # noqa: F401
        except ImportError:
            return
        self.assertEqual(run.snapshot()["position"].shape, (60, 3))
        self.assertIn("plastic", run.snapshot(kind="contacts"))

    def test_what_left_and_the_ledger_of_a_run(self):
        """summary.json and energy.csv of clod run, to the last digit that they have."""
        case = CASE.replace("max: [20 mm, 20 mm, 100 mm], periodic: [true, true, false]}",
                            "max: [20 mm, 20 mm, 100 mm], open: delete}")
        case = case.replace("plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}",
                            "disc: {center: [10 mm, 10 mm, 0 mm], radius: 7 mm}")
        case = case.replace("0.02 s", "0.1 s").replace("contacts: true", "energy: true")
        with open(self.path("case.yaml"), "w") as file:
            file.write(case)
        done = program.run("run", "case.yaml", "-o", "out", "-t", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        run = clod.results(self.path("out"))
        with clod.Simulation(self.path("case.yaml"), threads=2) as sim:
            sim.advance(run.summary["steps"])
            left = sim.left()
            self.assertEqual(list(left), list(run.summary["left"]))
            for side, there in run.summary["left"].items():
                self.assertEqual(left[side]["grains"], there["grains"])
                self.assertEqual(left[side]["mass"], there["mass_kg"])
                self.assertEqual(left[side]["energy"], there["kinetic_energy_J"])
            gone = sum(side["grains"] for side in left.values())
            self.assertEqual(gone + len(sim), 60)
            self.assertGreater(left["z_min"]["grains"], 5)
            ledger = sim.ledger()
            columns = run.series("energy")
            for name, value in ledger.items():
                column = {"plastic": "lost_plastic", "dash_pot": "lost_dash_pot",
                          "friction": "lost_friction", "rolling": "lost_rolling"}.get(name, name)
                self.assertEqual(value, columns[column][-1], name)
            self.assertGreater(ledger["dash_pot"], 0)
            self.assertLess(ledger["exchanged"], 0)
            self.assertLess(abs(ledger["residual"]), 0.01 * ledger["dash_pot"])
            sim.remove_grain(sim.id[0])
            sim.change()
            self.assertEqual(sim.exchange()["removed"], 1)
        with make() as sim:
            with self.assertRaisesRegex(clod.Error, "is not open"):
                sim.ledger()
            sim.open_ledger()
            sim.advance(100)
            self.assertLess(abs(sim.ledger()["residual"]), 1e-12)

    def test_the_library_is_found_by_its_name(self):
        """Without CLOD_LIBRARY the loader looks for the name that the build gave the library."""
        folder = os.path.dirname(os.environ["CLOD_LIBRARY"])
        environment = {**os.environ, "LD_LIBRARY_PATH": folder, "PYTHONPATH": os.environ["CLOD_PYTHON"]}
        del environment["CLOD_LIBRARY"]
        script = "import clod; print(open('/proc/self/maps').read())"
        done = subprocess.run([sys.executable, "-B", "-c", script], env=environment, text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(os.path.realpath(os.environ["CLOD_LIBRARY"]), done.stdout)

    def test_errors(self):
        with self.assertRaises(clod.Error) as caught:
            clod.Simulation(text="title: nothing")
        self.assertTrue(caught.exception.usage)
        self.assertIn("needs the key materials", str(caught.exception))
        with self.assertRaises(TypeError):
            clod.Simulation()
        sim = make()
        with self.assertRaises(clod.Error):
            sim.advance(-1)
        with self.assertRaises(AttributeError):
            sim.colour
        sim.remove_grain(12345)
        with self.assertRaisesRegex(clod.Error, "there is none with this id"):
            sim.change()
        sim.close()
        with self.assertRaises(ValueError):
            sim.advance(1)
        with self.assertRaises(FileNotFoundError):
            clod.results(self.path("nowhere"))


if __name__ == "__main__":
    unittest.main()
