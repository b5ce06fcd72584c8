// The candidates of a search by several parts are those of one part, and of all pairs looked
// at; also where a part has too little room for what it finds. So are those with walls, and the
// first contact that is none of them.

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
static bool search_contacts(clod_neighbour *self, scene *s, int parts, size_t room,
                            clod_status *failed)
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
    return clod_neighbour_build_end(self, &s->state, failed);
}

static void search(clod_neighbour *self, scene *s, int parts, size_t room)
{
    clod_status status = {0};
    assert_true(search_contacts(self, s, parts, room, &status));
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

/** A contact of every grain that has a partner, and with every wall that is near. */
static void touch_candidates(clod_state *state, const clod_neighbour *self)
{
    const clod_wall_candidates *walls = &self->walls;
    state->contacts = clod_memory_alloc(GRAINS + walls->count, sizeof *state->contacts);
    state->contact_count = 0;
    for (int32_t i = 0; i < GRAINS; i++) {
        if (self->pairs.start[i] < self->pairs.start[i + 1]) {
            state->contacts[state->contact_count++] = (clod_contact){
                .i = i, .j = (int32_t)self->pairs.item[self->pairs.start[i]].j, .shape = -1};
        }
    }
    for (size_t k = 0; k < walls->count; k++) {
        const clod_wall_candidate *at = &walls->item[k];
        state->contacts[state->contact_count++] =
            (clod_contact){.i = at->i, .j = at->wall, .shape = at->shape};
    }
    state->wall_contact_count = walls->count;
}

/** However many parts there are, and whether their room is enough or not. */
static void expect_separated(scene *s, const clod_contact *contact)
{
    char expected[48];
    snprintf(expected, sizeof expected, "step 0: grain %llu is far away",
             (unsigned long long)s->state.grains.id[contact->i]);
    for (int parts = 1; parts <= 9; parts++) {
        for (size_t room = 0; room < 2; room++) {
            clod_neighbour other;
            clod_status status = {0};
            assert_false(search_contacts(&other, s, parts, room, &status));
            assert_non_null(strstr(status.text, expected));
            clod_neighbour_fini(&other);
        }
    }
}

static void the_first_contact_that_is_no_candidate_is_named(void **state)
{
    (void)state;
    scene s;
    clod_neighbour first, other;
    clod_status status = {0};
    make_cloud(&s, 1.1, 3);
    clod_neighbour_init(&first, &s.state, false);
    assert_true(clod_neighbour_sort(&first, &s.state, &status));
    assert_true(clod_neighbour_build(&first, &s.state, &s.laws, &status));
    touch_candidates(&s.state, &first);
    for (int parts = 1; parts <= 9; parts++) {
        search(&other, &s, parts, 0);
        clod_neighbour_fini(&other);
        search(&other, &s, parts, 1);
        clod_neighbour_fini(&other);
    }
    clod_contact *contacts = s.state.contacts;
    const size_t pairs = s.state.contact_count - s.state.wall_contact_count;
    contacts[s.state.contact_count - 1].shape = 7;
    expect_separated(&s, &contacts[s.state.contact_count - 1]);
    contacts[pairs].shape = 7;
    expect_separated(&s, &contacts[pairs]);
    contacts[pairs - 1].j = contacts[pairs - 1].i; // no grain is its own partner
    expect_separated(&s, &contacts[pairs - 1]);
    contacts[pairs / 2].j = contacts[pairs / 2].i;
    expect_separated(&s, &contacts[pairs / 2]);
    contacts[0].j = contacts[0].i;
    expect_separated(&s, &contacts[0]);
    clod_neighbour_fini(&first);
    clod_state_fini(&s.state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_find_what_one_finds),
        cmocka_unit_test(the_first_contact_that_is_no_candidate_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
