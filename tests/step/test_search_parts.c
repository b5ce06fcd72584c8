// The candidates of a search by several parts are those of one part, and of all pairs looked
// at; also where a part has too little room for what it finds. So are those with walls.

#include "step/cells.h"
#include "support/bed.h"

enum { GRAINS = 1500 };

/** A cloud of grains in a box that is periodic along x, above a floor and about a post; radii 1
 *  to `spread`. */
static void make_cloud(scene *s, double spread, uint64_t seed)
{
    dice roll = {seed};
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-6, &ore);
    s->state.domain.periodic[0] = true;
    s->state.domain.min[0] = -0.05;
    s->state.domain.max[0] = 0.05;
    for (int g = 0; g < GRAINS; g++) {
        scene_grain(s, dice_real(&roll, -0.05, 0.05), dice_real(&roll, -0.01, 0.01),
                    dice_real(&roll, 0.0, 0.02), dice_real(&roll, 1e-3, spread * 1e-3));
    }
    scene_wall(s, "floor", shape_floor(0.0));
    scene_wall(s, "post", shape_box((clod_vec3){0.01, 0.0, 0.01}, 2e-3, 2e-3, 0.01));
}

static void check_same(const clod_neighbour *one, const clod_neighbour *other)
{
    const clod_pairs *a = &one->pairs, *b = &other->pairs;
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->start, b->start, (GRAINS + 1) * sizeof *a->start);
    assert_memory_equal(a->item, b->item, a->count * sizeof *a->item);
    assert_int_equal(one->walls.count, other->walls.count);
    assert_memory_equal(one->walls.item, other->walls.item,
                        one->walls.count * sizeof *one->walls.item);
}

/** Search by parts, with room for so many pairs at first; 0: as much as is usual. */
static void search(clod_neighbour *self, scene *s, int parts, size_t room)
{
    clod_status status = {0};
    clod_neighbour_init(self, &s->state, false);
    assert_true(clod_neighbour_reserve(self, &s->state, &status));
    if (room > 0) {
        self->pairs.item = clod_memory_alloc(room, sizeof *self->pairs.item);
        self->pairs.capacity = room;
    }
    assert_true(clod_neighbour_build_begin(self, &s->state, parts, &status));
    for (int p = 0; p < parts; p++) {
        clod_neighbour_build_count(self, &s->state, p);
    }
    clod_neighbour_build_add(self, &s->state);
    for (int p = parts; p-- > 0;) { // in any order
        clod_neighbour_build_enter(self, &s->state, p);
    }
    for (int p = parts; p-- > 0;) {
        clod_neighbour_build_part(self, &s->state, &s->laws, p);
    }
    assert_true(clod_neighbour_build_end(self, &s->state, &status));
}

static void parts_find_what_one_finds(void **state)
{
    (void)state;
    static const double SPREAD[] = {1.1, 4.0};
    for (int k = 0; k < 2; k++) {
        scene s;
        clod_neighbour first, all, other;
        clod_status status = {0};
        make_cloud(&s, SPREAD[k], 3 + (uint64_t)k);
        clod_neighbour_init(&first, &s.state, false);
        assert_true(clod_neighbour_sort(&first, &s.state, &status));
        assert_true(clod_neighbour_build(&first, &s.state, &s.laws, &status));
        clod_neighbour_init(&all, &s.state, true);
        assert_true(clod_neighbour_reserve(&all, &s.state, &status));
        assert_true(clod_neighbour_build(&all, &s.state, &s.laws, &status));
        assert_true(first.pairs.count > GRAINS / 2);
        assert_true(first.walls.count > 50);
        check_same(&first, &all);
        for (int parts = 1; parts <= 9; parts++) {
            static const size_t ROOM[] = {0, 1, 300,
                                          100000}; // the second and third: too little
            for (int r = 0; r < 4; r++) {
                search(&other, &s, parts, ROOM[r]);
                check_same(&first, &other);
                clod_neighbour_fini(&other);
            }
        }
        search(&other, &s, GRAINS + 3, 0); // parts without grains
        check_same(&first, &other);
        clod_neighbour_fini(&other);
        clod_neighbour_fini(&first);
        clod_neighbour_fini(&all);
        clod_state_fini(&s.state);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_find_what_one_finds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
