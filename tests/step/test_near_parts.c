// The cut of the grains into parts, one for each thread, and the groups of contacts that
// follow.

#include "step/near_parts.h"
#include "step/near_walk.h"
#include "support/bed.h"

static const int PARTS[] = {1, 2, 3, 7, 40, 1000}; // 1000: more than grains
#define CUTS ((int)(sizeof PARTS / sizeof *PARTS))

/** Parts without a gap, in order, from the first grain to the last. */
static void check_cover(const clod_near *near, size_t grains)
{
    assert_int_equal(near->part_start[0], 0);
    assert_int_equal(near->part_start[near->parts], grains);
    for (int p = 0; p < near->parts; p++) {
        assert_true(near->part_start[p] <= near->part_start[p + 1]);
        for (size_t g = near->part_start[p]; g < near->part_start[p + 1]; g++) {
            assert_int_equal(clod_near_part_of(near, (int32_t)g), p);
        }
    }
}

/** Work of each grain: 1 for moving it, 3 for each pair in which it is the later one, 4 for
 * each wall. */
static int64_t work_of(const scene *s, int64_t *work)
{
    const clod_near *near = &s->step.near;
    const int64_t grains = (int64_t)s->state.grains.count;
    int64_t all = grains;
    for (int64_t g = 0; g < grains; g++) {
        work[g] = 1;
    }
    const clod_contact_block *pairs = near->pairs.block;
    for (size_t at = 0; at < near->pairs.count * CLOD_LANES; at++) {
        const int32_t i = pairs[at / CLOD_LANES].i[at % CLOD_LANES];
        if (i < grains) {
            work[pairs[at / CLOD_LANES].j[at % CLOD_LANES]] += 3;
            all += 3;
        }
    }
    const clod_wall_block *walls = near->walls.block;
    for (size_t at = 0; at < near->walls.count * CLOD_LANES; at++) {
        const int32_t i = walls[at / CLOD_LANES].i[at % CLOD_LANES];
        if (i < grains) {
            work[i] += 4;
            all += 4;
        }
    }
    return all;
}

/** No part is off the mean by more than the work of one grain. */
static void check_work(const scene *s)
{
    const clod_near *near = &s->step.near;
    int64_t work[1000], most = 0;
    const int64_t all = work_of(s, work);
    for (size_t g = 0; g < s->state.grains.count; g++) {
        most = work[g] > most ? work[g] : most;
    }
    for (int p = 0; p < near->parts; p++) {
        int64_t mine = 0;
        for (size_t g = near->part_start[p]; g < near->part_start[p + 1]; g++) {
            mine += work[g];
        }
        check_close((double)mine, (double)all / near->parts, (double)most);
    }
}

/** One group: its law, its part, ascending by (i, j), padding behind. */
static void check_group(const scene *s, int part, int32_t law, bool between)
{
    const clod_near *near = &s->step.near;
    const size_t group =
        between ? clod_near_group_between(near, part, law) : clod_near_group(near, part, law);
    const clod_contact_block *blocks = near->pairs.block;
    blocks += near->pairs.group_start[group];
    const size_t contacts = near->pairs.group_count[group];
    const size_t all = near->pairs.group_start[group + 1] - near->pairs.group_start[group];
    const uint16_t *material = s->state.grains.material;
    assert_true(contacts <= all * CLOD_LANES && contacts + CLOD_LANES > all * CLOD_LANES);
    int64_t before = -1;
    for (size_t k = 0; k < all * CLOD_LANES; k++) {
        const int32_t i = blocks[k / CLOD_LANES].i[k % CLOD_LANES];
        const int32_t j = blocks[k / CLOD_LANES].j[k % CLOD_LANES];
        if (k >= contacts) {
            assert_true(i >= (int32_t)s->state.grains.count && j > i);
            continue;
        }
        const int part_i = clod_near_part_of(near, i), part_j = clod_near_part_of(near, j);
        assert_true(i < j && clod_laws_index(&s->laws, material[i], material[j]) == law);
        assert_true(part_j == part && (between ? part_i < part : part_i == part));
        assert_true(((int64_t)i << 32 | j) > before);
        before = (int64_t)i << 32 | j;
    }
}

/** Runs of contacts between parts: each has its two parts, and all of them have all contacts.
 */
static void check_runs(const scene *s)
{
    const clod_near *near = &s->step.near;
    size_t in_runs = 0, in_groups = 0;
    for (int32_t law = 0; law < s->laws.count; law++) {
        for (int part = 0; part < near->parts; part++) {
            const size_t k = (size_t)law * (size_t)near->parts + (size_t)part;
            int before = part; // runs ascend by the later part, which is behind this one
            for (size_t r = near->between.run_start[k]; r < near->between.run_start[k + 1];
                 r++) {
                const clod_near_run *run = &near->between.run[r];
                const size_t group = clod_near_group_between(near, run->later, law);
                const clod_contact_block *blocks = near->pairs.block;
                blocks += near->pairs.group_start[group];
                assert_true(run->later > before && run->begin < run->end);
                assert_true(run->end <= near->pairs.group_count[group]);
                for (size_t c = run->begin; c < run->end; c++) {
                    const int32_t i = blocks[c / CLOD_LANES].i[c % CLOD_LANES];
                    assert_int_equal(clod_near_part_of(near, i), part);
                }
                in_runs += run->end - run->begin;
                before = run->later;
            }
            in_groups += near->pairs.group_count[clod_near_group_between(near, part, law)];
        }
    }
    assert_int_equal(in_runs, in_groups); // with the above: each contact once
}

/** Groups hold as many pairs as candidates are near, and the walk finds each in its lane. */
static void check_candidates(scene *s)
{
    const clod_near *near = &s->step.near;
    const clod_pairs *pairs = &s->step.neighbour.pairs;
    const clod_contact_block *blocks = near->pairs.block;
    size_t marked = 0, held = 0, walked = 0;
    for (size_t k = 0; k < pairs->count; k++) {
        marked += pairs->item[k].near;
    }
    for (size_t q = 0; q < clod_near_groups(near); q++) {
        held += near->pairs.group_count[q];
    }
    size_t *fill = clod_memory_alloc(clod_near_groups(near), sizeof *fill);
    clod_near_job job = {.near = &s->step.near,
                         .neighbour = &s->step.neighbour,
                         .state = &s->state,
                         .laws = &s->laws};
    for (int part = 0; part < near->parts; part++) {
        clod_near_walk walk = clod_near_walk_begin(&job, part);
        while (clod_near_walk_on(&walk)) {
            const size_t at =
                near->pairs.group_start[walk.group] * CLOD_LANES + fill[walk.group]++;
            assert_int_equal(blocks[at / CLOD_LANES].i[at % CLOD_LANES], walk.i);
            assert_int_equal(blocks[at / CLOD_LANES].j[at % CLOD_LANES], walk.j);
            walked++;
        }
    }
    clod_memory_free(fill);
    assert_true(marked == held && held == walked);
}

/** Beds in motion, cut anew into other numbers of parts. */
static void parts_cover_all_grains_and_contacts(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene s;
        bed_init(&s, (bed_kind)kind, 1);
        scene_start(&s);
        scene_run(&s, 1500);
        assert_true(clod_step_export(&s.step, &s.step.status));
        for (int c = 0; c < CUTS; c++) {
            clod_step_fini(&s.step);
            scene_start_with(&s, (clod_step_options){.threads = PARTS[c]});
            assert_true(s.step.near.pairs.count > 10);
            assert_int_equal(s.state.contact_count, 0); // the blocks have them
            check_cover(&s.step.near, s.state.grains.count);
            check_work(&s);
            for (int32_t law = 0; law < s.laws.count; law++) {
                for (int part = 0; part < PARTS[c]; part++) {
                    check_group(&s, part, law, false);
                    check_group(&s, part, law, true);
                }
            }
            check_runs(&s);
            check_candidates(&s);
        }
        scene_end(&s);
    }
}

/** Nothing to cut is cut into parts of nothing. */
static void no_grains_are_cut_too(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    scene s;
    scene_init(&s, 1e-6, &contact);
    assert_true(clod_grains_reserve(&s.state.grains, 1, &s.step.status));
    scene_start_with(&s, (clod_step_options){.threads = 3});
    check_cover(&s.step.near, 0);
    scene_run(&s, 3);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_cover_all_grains_and_contacts),
        cmocka_unit_test(no_grains_are_cut_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
