// A state is the same whatever the order of its rows and contacts: taken up with grains and
// contacts shuffled, it goes on with the same bits.
#include "support/bed.h"
#include "support/bits.h"

#define STEPS 3000

/** Row g of `from` becomes row to[g]. */
static void move_rows(void *array, const void *from, size_t count, size_t size,
                      const size_t *to)
{
    for (size_t g = 0; g < count; g++) {
        memcpy((char *)array + to[g] * size, (const char *)from + g * size, size);
    }
}

static void shuffle(size_t *order, size_t count, dice *roll)
{
    for (size_t k = 0; k < count; k++) {
        order[k] = k;
    }
    for (size_t k = count; k > 1; k--) {
        const size_t other = (size_t)dice_pick(roll, (int)k);
        const size_t kept = order[k - 1];
        order[k - 1] = order[other];
        order[other] = kept;
    }
}

static void shuffle_contacts(clod_contact *contacts, size_t count, const size_t *to, bool walls,
                             dice *roll)
{
    for (size_t k = 0; k < count; k++) {
        contacts[k].i = (int32_t)to[contacts[k].i];
        contacts[k].j = walls ? contacts[k].j : (int32_t)to[contacts[k].j];
        if (!walls && contacts[k].i > contacts[k].j) {
            clod_contact_turn(&contacts[k]);
        }
    }
    for (size_t k = count; k > 1; k--) {
        const size_t other = (size_t)dice_pick(roll, (int)k);
        const clod_contact kept = contacts[k - 1];
        contacts[k - 1] = contacts[other];
        contacts[other] = kept;
    }
}

/** A copy of a state whose rows and contacts stand in another order. */
static clod_state shuffled(const clod_state *from, uint64_t seed)
{
    clod_status status = {0};
    clod_state copy = {0};
    dice roll = {seed};
    const size_t n = from->grains.count;
    size_t *to = clod_memory_alloc(n, sizeof *to);
    assert_true(clod_state_copy(&copy, from, &status));
    shuffle(to, n, &roll);
    const clod_grains *g = &from->grains;
    move_rows(copy.grains.place, g->place, n, sizeof *g->place, to);
    move_rows(copy.grains.motion, g->motion, n, sizeof *g->motion, to);
    move_rows(copy.grains.turning, g->turning, n, sizeof *g->turning, to);
    move_rows(copy.grains.load, g->load, n, sizeof *g->load, to);
    move_rows(copy.grains.id, g->id, n, sizeof *g->id, to);
    move_rows(copy.grains.material, g->material, n, sizeof *g->material, to);
    move_rows(copy.build_place, from->build_place, n, sizeof *from->build_place, to);
    const size_t walls = from->wall_contact_count, pairs = from->contact_count - walls;
    shuffle_contacts(copy.contacts, pairs, to, false, &roll);
    shuffle_contacts(copy.contacts + pairs, walls, to, true, &roll);
    clod_memory_free(to);
    return copy;
}

static void rows_and_contacts_may_stand_in_any_order(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene whole;
        bed_init(&whole, (bed_kind)kind, 4);
        scene_start(&whole);
        scene_run(&whole, STEPS);
        assert_true(clod_step_export(&whole.step, &whole.step.status));
        for (uint64_t seed = 1; seed <= 3; seed++) {
            scene now = whole;
            now.laws.law = now.law;
            now.state = shuffled(&whole.state, seed);
            assert_true(memcmp(now.state.grains.id, whole.state.grains.id,
                               whole.state.grains.count * sizeof(uint64_t)) != 0);
            scene_start_with(&now, (clod_step_options){.threads = (int)seed});
            assert_true(clod_step_export(&now.step, &now.step.status));
            check_same_bits(&whole.state, &now.state); // back in order
            assert_memory_equal(now.state.build_place, whole.state.build_place,
                                whole.state.grains.count * sizeof *whole.state.build_place);
            scene_run(&now, STEPS);
            assert_true(clod_step_export(&now.step, &now.step.status));
            scene other;
            bed_init(&other, (bed_kind)kind, 4);
            scene_start(&other);
            scene_run(&other, 2 * STEPS);
            assert_true(clod_step_export(&other.step, &other.step.status));
            check_same_bits(&other.state, &now.state);
            scene_end(&other);
            scene_end(&now);
        }
        scene_end(&whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_and_contacts_may_stand_in_any_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
