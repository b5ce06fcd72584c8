"""What bench/peers reads from the output of others: valgrind, objdump, LIGGGHTS, LAMMPS."""

import unittest

import peers_path  # noqa: F401
import count
import programs

CALLGRIND = """fn=main
0x10 5 9
fn=kernel_contact
0x20 7 300
0x24 7 300
fl=elsewhere.h
0x28 8 100
cfn=pow
calls=2 0x90
0x2c 8 4000
0x2c 8 50
fn=kernel_kick
0x20 1 7
"""
OBJDUMP = """
0000000000000020 <kernel_contact>:
      20:\tvmulpd %ymm1,%ymm2,%ymm3
      24:\tvdivpd %ymm1,%ymm2,%ymm3
      28:\tvsqrtsd %xmm1,%xmm2,%xmm3
      2c:\tvfmadd231pd %ymm1,%ymm2,%ymm3
"""
PEER = """
Loop time of 0.25 on 1 procs for 200 steps with 30 atoms, some
Neighbor list builds = 4
Loop time of 1.5 on 1 procs for 1000 steps with 30 atoms
Neighbor list builds = 3
    Step    Atoms         KinEng           spin   coordination
    1200       30   1.378392e-06   1.158921e-08    5.877333333
Loop time of 1e-06 on 1 procs for 0 steps with 30 atoms
"""


class Count(unittest.TestCase):

    def test_counts_are_of_the_kernel_and_without_what_it_calls(self):
        self.assertEqual(count.parse_counts(CALLGRIND.splitlines()), {
            ("kernel_contact", 0x20): 300, ("kernel_contact", 0x24): 300,
            ("kernel_contact", 0x28): 100, ("kernel_contact", 0x2c): 50, ("kernel_kick", 0x20): 7})

    def test_lanes_and_kinds(self):
        # 4 lanes: 300 * 4 products, 50 * 4 * 2 fused, 300 * 4 divides; 100 roots of one lane
        code = count.parse_code(OBJDUMP)
        sums = count.operations(count.parse_counts(CALLGRIND.splitlines()), code)
        self.assertEqual(sums["kernel_contact"], {"flops": 1200 + 400, "divides": 1200,
                                                  "roots": 100})
        self.assertEqual(sums["kernel_kick"], {"flops": 28})

    def test_second_loop_time_and_last_state(self):
        found = programs.parse(PEER, 30, 1000)
        self.assertEqual(found, {"seconds": 1.5, "rate": 30 * 1000 / 1.5,
                                 "coordination": 5.877333333, "kinetic_J": 1.378392e-06,
                                 "rotational_J": 1.158921e-08, "lists": 3})

    def test_another_run_is_refused(self):
        for grains, steps in ((31, 1000), (30, 999)):
            with self.assertRaises(programs.ProgramError):
                programs.parse(PEER, grains, steps)


if __name__ == "__main__":
    unittest.main()
