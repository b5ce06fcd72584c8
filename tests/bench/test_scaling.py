"""The scaling model: geometry, counts, the simulation of messages and the closed model, in limits that have
closed forms. Counts are beside those of bench_ranks, which runs the code."""

import json
import math
import os
import subprocess
import unittest

import scaling_path  # noqa: F401
import compare
import constants
import engine
import evenness
import geometry
import lattice
import model
import program
import simulate

BINARY = os.path.dirname(os.environ.get("CLOD_BINARY", ""))
BENCH_RANKS = os.path.join(BINARY, "bench", "bench_ranks")


def machine(**numbers):
    """Constants that are easy to compute with; everything that is not given costs nothing."""
    free = {"row": 1000.0, "far": 0.0, "ghost": 0.0, "pack_share": 0.0, "memory_core": math.inf,
            "noise": 0.0, "imbalance": 1.0,
            "latency": 0.0, "latency_node": 0.0, "overhead": 0.0, "overhead_long": 0.0,
            "meeting": 0.0, "gap": 0.0, "cores": 10 ** 9,
            "bandwidth": math.inf, "bandwidth_node": math.inf, "eager": math.inf,
            "rebuild_steps": math.inf, "memory": math.inf}
    return constants.load("epyc-hdr").but(**{**free, **numbers})


def run(c, programs):
    simulation = engine.Simulation(c, programs)
    return simulation.run(), simulation


class Geometry(unittest.TestCase):
    def test_a_rank_among_cubes_has_a_shell_of_ghosts(self):
        bed = geometry.Bed(64 * 1000.0, 64, 1.5)  # cubes of 10 grains along an edge
        self.assertAlmostEqual(bed.most_ghosts(), 13.0 ** 3 - 1000.0, places=6)
        self.assertAlmostEqual(bed.mean_ghosts(), 13.0 ** 3 - 1000.0, places=6)
        self.assertEqual(bed.most_neighbours(), 26)

    def test_a_neighbour_on_both_sides_is_counted_once(self):
        bed = geometry.Bed(1000.0, 2, 1.0)  # 5 x 10 x 10: two faces, whose rims are the same grains
        self.assertAlmostEqual(bed.most_ghosts(), 200.0, places=6)
        self.assertAlmostEqual(geometry.Bed(1000.0, 2, 6.0).most_ghosts(), 500.0, places=6)

    def test_without_periods_only_the_cut_counts(self):
        bed = geometry.Bed(1000.0, 2, 1.0, periodic=False)
        self.assertAlmostEqual(bed.most_ghosts(), 100.0, places=6)

    def test_ranks_have_as_many_grains_each_whatever_their_number(self):
        for ranks in (3, 7, 12, 100):
            boxes = geometry.leaves(geometry.bisect((4.0, 5.0, 6.0), ranks))
            for box in boxes:
                volume = math.prod(b - a for a, b in zip(box.low, box.high))
                self.assertAlmostEqual(volume, 120.0 / ranks, places=9)
            self.assertEqual([box.first for box in boxes], list(range(ranks)))

    def test_nodes_of_cubes_have_the_ghosts_of_the_closed_form(self):
        c = machine(cores=8, ghost_layers=1.0)
        bed = geometry.Bed(64 * 1000.0, 64, 1.0)  # nodes of 2 x 2 x 2 cubes
        rows, messages = bed.between_nodes(8)
        shape = model.regular_shape(c, 64 * 1000.0, 64)
        self.assertAlmostEqual(rows, 8 * 12.0 ** 3 - 22.0 ** 3, places=6)
        self.assertAlmostEqual(shape.node_ghosts, rows, places=6)
        self.assertEqual(messages, 8 * 26 - 8 * 7)
        self.assertAlmostEqual(shape.node_messages, messages, places=6)


class Evenness(unittest.TestCase):
    def test_a_box_of_points_is_cut_evenly(self):
        points = [(i + 0.5, j + 0.5, k + 0.5) for i in range(64) for j in range(8) for k in range(8)]
        self.assertEqual(evenness.most_over_mean(points, 4), 1.0)

    def test_half_a_block_with_points_in_one_half_of_it(self):
        # one block in a row of 64 has all: it is taken to be even, so the cut is in its middle
        points = [(0.0, 0.0, 0.0)] + [(32.1, 0.0, 0.0)] * 98 + [(64.0, 0.0, 0.0)]
        self.assertAlmostEqual(evenness.most_over_mean(points, 2), 99 / 50)

    def test_a_heap_has_as_many_points_as_were_asked_for(self):
        points = evenness.heap(5000)
        self.assertAlmostEqual(len(points) / 5000, 1.0, delta=0.05)


@unittest.skipUnless(os.path.exists(BENCH_RANKS), "bench_ranks was not built")
class Counts(unittest.TestCase):
    def test_they_are_those_of_the_code(self):
        c = constants.load("here")
        bytes_of = {"ghost": c.code_ghost, "order": c.code_order, "state": c.code_state}
        for ranks, edge in ((2, 8), (3, 8), (5, 8), (8, 8), (4, 12), (27, 9)):
            done = subprocess.run([BENCH_RANKS, str(ranks), str(edge)], capture_output=True,
                                  text=True, check=True)
            said, guess = json.loads(done.stdout), lattice.predict(edge, ranks, bytes_of)
            with self.subTest(ranks=ranks, edge=edge):
                self.assertAlmostEqual(said["ghosts_a_grain"], guess["ghosts"], delta=5.1e-4)
                self.assertAlmostEqual(said["step"]["messages_a_rank"], guess["messages_a_rank"],
                                       delta=0.051)
                self.assertAlmostEqual(said["step"]["bytes_a_rank"], guess["bytes_a_rank"],
                                       delta=0.51)
                merges = said["messages_of_collectives_a_step"] / said["collectives_a_step"]
                self.assertAlmostEqual(merges, guess["messages_of_a_merge"], delta=0.05)
                self.assertGreaterEqual(said["rebuild"]["messages_a_rank"] + 0.5,
                                        guess["rebuild_messages_least"])


class Simulation(unittest.TestCase):
    def test_a_rank_alone_only_computes(self):
        result = simulate.run(machine(), geometry.Bed(5000.0, 1, 1.0), steps=7)
        self.assertAlmostEqual(result.step, 5000 * 1e-6, places=12)
        self.assertEqual((result.waited, result.messages), (0.0, 0.0))

    def test_messages_that_cost_nothing_let_nobody_wait(self):
        result = simulate.run(machine(), geometry.Bed(27000.0, 27, 1.0), steps=4)
        self.assertAlmostEqual(result.step, 1000 * 1e-6, places=12)
        self.assertAlmostEqual(result.waited, 0.0, places=12)

    def test_rounds_of_a_merge_come_one_behind_the_other(self):
        c = machine(latency_node=3e-6, bandwidth_node=1e6)
        for ranks, rounds in ((2, 1), (8, 3), (64, 6)):
            ends, simulation = run(c, [program.merge(r, ranks, 10) for r in range(ranks)])
            self.assertAlmostEqual(max(ends), rounds * (3e-6 + 1e-5), places=12)
            self.assertAlmostEqual(min(ends), max(ends), places=12)
            self.assertEqual(simulation.messages, lattice.merge_messages(ranks))

    def test_ranks_that_are_no_power_of_two_take_two_rounds_more(self):
        c = machine(latency_node=5e-6)
        ends, simulation = run(c, [program.merge(r, 7, 10) for r in range(7)])
        self.assertAlmostEqual(max(ends), 4 * 5e-6, places=12)
        self.assertEqual(simulation.messages, lattice.merge_messages(7))
        # of six, the two that nobody joins are a round ahead: their second message is there in time
        ends, _ = run(c, [program.merge(r, 6, 10) for r in range(6)])
        self.assertAlmostEqual(max(ends), 3 * 5e-6, places=12)

    def test_numbers_of_bytes_go_in_as_many_rounds_as_ranks_have_bits(self):
        c = machine(latency_node=3e-6)
        ends, simulation = run(c, [program.numbers(r, 10) for r in range(10)])
        self.assertAlmostEqual(max(ends), 4 * 3e-6, places=12)
        # of 1 ... 9, those with bit 1: 5, bit 2: 4, bit 4: 4, bit 8: 2
        self.assertEqual(simulation.bytes, 10 * 8 * (5 + 4 + 4 + 2))

    def test_all_wait_for_a_late_rank_at_a_merge(self):
        c = machine(latency_node=1e-6)

        def late(rank):
            yield ("work", 5e-3 if rank == 3 else 0.0)
            yield from program.merge(rank, 8, 10)

        # what it has goes on by each bit in which the number of a rank differs; to it all have come
        ends, simulation = run(c, [late(r) for r in range(8)])
        for rank in simulation.ranks:
            end = 5e-3 + (rank.number ^ 3).bit_count() * 1e-6
            self.assertAlmostEqual(ends[rank.number], end, places=12)
            self.assertAlmostEqual(rank.waited, 0.0 if rank.number == 3 else end, places=12)

    def test_a_delay_travels_by_one_neighbour_in_a_step(self):
        # an idle wave: Afzal, Hager, Wellein 2019, doi:10.1109/CLUSTER.2019.8890995
        ranks, steps, delay, work = 16, 5, 1.0, 1e-3

        def ring(rank):
            sides = [((rank + side) % ranks, 8) for side in (1, -1)]
            yield ("work", delay if rank == 0 else 0.0)
            for _ in range(steps):
                yield ("work", work)
                yield from program.exchange(sides, sides)

        ends, _ = run(machine(), [ring(r) for r in range(ranks)])
        for rank, end in enumerate(ends):
            hops = min(rank, ranks - rank)
            self.assertAlmostEqual(end, steps * work + (delay if hops <= steps else 0.0), places=12)

    def test_messages_of_a_node_leave_one_after_the_other(self):
        c = machine(cores=4, latency=2e-6, bandwidth=1e9, gap=1e-7)

        def one_way(rank):
            if rank < 4:
                yield from program.exchange([(rank + 4, 1000)], [])
            else:
                yield from program.exchange([], [(rank - 4, 1000)])

        ends, _ = run(c, [one_way(r) for r in range(8)])
        self.assertAlmostEqual(min(ends[4:]), 2e-6 + 1e-6, places=12)
        self.assertAlmostEqual(max(ends), 2e-6 + 4 * 1e-6 + 3 * 1e-7, places=12)

    def test_calls_cost_processor_time_by_messages_and_copies_queue(self):
        c = machine(latency_node=5e-6, bandwidth_node=1e9, overhead=1e-6, eager=5000,
                    overhead_long=7e-6)

        def star(rank, size):
            if rank == 0:
                yield from program.exchange([], [(1, size), (2, size), (3, size)])
            else:
                yield from program.exchange([(0, size)], [])

        ends, _ = run(c, [star(r, 1000) for r in range(4)])
        self.assertAlmostEqual(ends[0], 5e-6 + 3 * 1e-6 + 2 * 1e-6, places=12)
        ends, _ = run(c, [star(r, 10000) for r in range(4)])
        self.assertAlmostEqual(ends[0], 7e-6 + 3 * 5e-6 + 3 * 1e-5 + 2 * 1e-6 + 3 * 7e-6, places=12)

    def test_a_long_message_waits_until_its_receiver_is_ready(self):
        c = machine(latency_node=2e-6, bandwidth_node=1e9, eager=100)

        def pair(rank, late):
            yield ("work", late if rank == 1 else 0.0)
            yield from program.exchange([(1, 1000)] if rank == 0 else [],
                                        [(0, 1000)] if rank == 1 else [])

        for late, end in ((0.0, 3 * 2e-6 + 1e-6), (1e-3, 1e-3 + 2 * 2e-6 + 1e-6)):
            ends, _ = run(c, [pair(r, late) for r in range(2)])
            self.assertAlmostEqual(ends[1], end, places=12)

    def test_it_repeats_itself(self):
        c, bed = machine(noise=0.1, imbalance=1.1), geometry.Bed(8000.0, 8, 1.0)
        steps = [simulate.run(c, bed, seed=seed).step for seed in (1, 1, 2)]
        self.assertEqual(steps[0], steps[1])
        self.assertNotEqual(steps[0], steps[2])


class ClosedModel(unittest.TestCase):
    def test_it_is_the_simulation_where_messages_hide_behind_the_merge(self):
        c = machine(latency_node=1e-6, latency=1e-6, overhead=2e-7, ghost=500.0, pack_share=0.3)
        for ranks in (8, 64):
            bed = geometry.Bed(1000.0 * ranks, ranks, 1.0)
            closed = model.step_time(c, model.shape_of(c, bed))
            self.assertAlmostEqual(simulate.run(c, bed, steps=3).step / closed, 1.0, places=9)

    def test_a_rebuild_has_its_merges_numbers_and_grains(self):
        c = machine(latency_node=1e-6, rebuild=500.0, cuts=0.0, code_rebuild_merges=22,
                    code_rebuild_swaps=2)
        bed = geometry.Bed(8000.0, 8, 1.0)
        seconds = 22 * 3e-6 + 2 * 3e-6 + 1e-6 + 1000 * 500e-9
        self.assertAlmostEqual(model.rebuild_time(c, model.shape_of(c, bed)), seconds, places=12)
        steps = [simulate.run(c, bed, 4, rebuilds).step * 4 for rebuilds in (0, 1)]
        self.assertAlmostEqual(steps[1] - steps[0], seconds, places=12)

    def test_the_adapter_takes_longest_once_or_where_both_ends_queue_twice(self):
        c = machine(cores=8, bandwidth=1e9, latency=1e-6, ghost_layers=1.0)
        bed = geometry.Bed(64 * 8000.0, 64, 1.0)
        closed = model.step_parts(c, model.shape_of(c, bed))
        queue = closed["on their way"] + closed["merge"]
        simulated = simulate.run(c, bed, steps=3).step - closed["own rows"]
        self.assertGreaterEqual(simulated, queue)
        self.assertLessEqual(simulated, 2.0 * queue)

    def test_the_most_of_even_imbalance_is_what_a_step_takes(self):
        c = machine(imbalance=1.2)
        bed = geometry.Bed(512 * 100.0, 512, 1e-6)
        self.assertAlmostEqual(simulate.run(c, bed, steps=2).step / model.step_time(
            c, model.shape_of(c, bed)), 1.0, delta=0.002)

    def test_noise_costs_the_largest_of_all_ranks(self):
        c = machine(noise=0.05)
        bed = geometry.Bed(100 * 100.0, 100, 1e-6)
        step = simulate.run(c, bed, steps=100).step
        self.assertAlmostEqual((step / 1e-4 - 1.0) / 0.05, 2.5076, delta=0.1)  # mean of 100 maxima; below for its source

    def test_the_largest_of_normal_numbers(self):
        # order statistics of normal samples: 1 / sqrt(pi) of 2, 2.5076 of 100, 3.2414 of 1000
        self.assertAlmostEqual(model.most_of(2), 1.0 / math.sqrt(math.pi), delta=0.04)
        self.assertAlmostEqual(model.most_of(100) / 2.5076, 1.0, delta=0.01)
        self.assertAlmostEqual(model.most_of(1000) / 3.2414, 1.0, delta=0.01)

    def test_rows_beyond_the_cache_take_their_share_of_memory(self):
        c = machine(row=50.0, far=10.0, cache=1e6, cache_all=2e6, row_footprint=500.0,
                    row_bytes=1000.0, memory=1e11, memory_core=1e11, cores=100)
        self.assertAlmostEqual(model.row_time(c, 2000, 100), 50e-9, places=15)
        self.assertAlmostEqual(model.row_time(c, 4000, 100), 55e-9, places=15)  # half beyond its own
        # three quarters of it from memory, which 100 cores share
        self.assertAlmostEqual(model.row_time(c, 16000, 100), 0.75 * 1000 / 1e9, places=12)
        # one core alone has all caches: half of it from memory
        self.assertAlmostEqual(model.row_time(c, 800000, 1),
                               (50 + 10 * (1 - 1 / 400)) * 1e-9 + 0.5 * 1000 / 1e11, places=15)

    def test_grains_for_an_efficiency_have_it(self):
        c = constants.load("epyc-hdr")
        grains = model.grains_for(c, 512, 0.5)
        self.assertGreaterEqual(model.efficiency(c, model.shape_for(c, 512 * grains, 512)), 0.5)
        fewer = model.shape_for(c, 512 * grains / 1.04, 512)
        self.assertLess(model.efficiency(c, fewer), 0.5)

    def test_a_checkpoint_is_its_bytes_and_the_numbers_of_each_slab(self):
        c = machine(write=1e9, overhead=1e-6, code_checkpoint=500.0, code_slab=10000,
                    code_slab_messages=10, code_slab_merges=0)
        self.assertAlmostEqual(model.checkpoint_time(c, 1e6, 101), 0.5 + 100 * 10 * 100 * 1e-6,
                               places=9)


class Compare(unittest.TestCase):
    def step_line(self, rank, own, ghosts, worked, ranks=2):
        said = {"rank": rank, "watched": {
            "steps": 10, "wall_s": 20 * worked, "worked_s": 10 * worked, "waited_s": worked,
            "ghost_bytes_in": 72 * ghosts}}
        if rank == 0:
            said.update(grain_steps_per_s=1.0, law="mepa", ranks=ranks, threads=1, grains=sum(own), seconds=1.0,
                        steps=10, own_rows=own)
        return said

    def test_constants_are_found_again(self):
        lines = []
        for own, ghosts in (([1000, 1200], (300, 200)), ([100, 90], (150, 160))):
            for rank in (1, 0):
                time = 40e-9 * own[rank] + 25e-9 * ghosts[rank]
                lines.append(self.step_line(rank, own, ghosts[rank], time))
        found = compare.fit(lines, constants.load("here"))
        self.assertAlmostEqual(found["row"], 40.0, places=6)
        self.assertAlmostEqual(found["ghost"], 25.0, places=6)

    def test_messages_of_two_ranks_give_latency_and_bandwidth(self):
        lines = [{"test": test, "pairs": "near", "ranks": 2, "bytes": size, "median": time}
                 for test, size, time in (("pingpong", 8, 1.0), ("pingpong", 1 << 20, 101.0),
                                          ("kept", 8, 1.5))]
        for size, time in ((1 << 10, 1e-6 + 0.5e-6 + 3 * 2 * 0.2e-6),
                           (1 << 13, 0.0), (1 << 16, 0.0)):  # 4 peers; 1e9 B/s, 3 us each more beyond 1 kB
            time += 0.0 if size == 1 << 10 else 2.7e-6 + 4 * (size - (1 << 10)) * 1e-9 + 4 * 2 * 3e-6
            lines.append({"test": "halo", "pairs": "all", "ranks": 5, "peers": 4, "bytes": size,
                          "median": 1e6 * time})
        found = compare.fit(lines, constants.load("here"))
        self.assertAlmostEqual(found["latency_node"], 1e-6, places=12)
        self.assertAlmostEqual(found["meeting"], 0.5e-6, places=12)
        self.assertAlmostEqual(found["overhead"], 0.2e-6, places=12)
        self.assertAlmostEqual(found["overhead_long"], 3e-6, places=12)
        self.assertAlmostEqual(found["bandwidth_node"] / 1e9, 1.0, places=9)

    def test_a_packing_has_its_box(self):
        lengths = compare.lengths_of(3750 * 8)
        self.assertAlmostEqual(math.prod(lengths), 30000.0, places=6)
        self.assertAlmostEqual(max(compare.lengths_of(3750 * 80)) / min(compare.lengths_of(300000)),
                               1.25, places=9)


if __name__ == "__main__":
    unittest.main()
