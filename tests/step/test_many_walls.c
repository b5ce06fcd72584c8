// Walls of very many shapes: the candidates found through cells are those of the slow look at
// every shape, in the same order; and a bed among ten thousand boxes has the bits that it has
// without those which no grain is near.
#include "step/cells.h"
#include "step/wall_cells.h"
#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

#define SKIN 1e-3 ///< m

/** A shape of any kind, size and place about the unit cube; cylinders and cones from both
 * sides.
 */
static clod_shape any_shape(dice *roll)
{
    static const clod_shape_kind KINDS[] = {
        CLOD_SHAPE_PLANE, CLOD_SHAPE_DISC, CLOD_SHAPE_ANNULUS, CLOD_SHAPE_CYLINDER,
        CLOD_SHAPE_CONE,  CLOD_SHAPE_BOX,  CLOD_SHAPE_BAR};
    const clod_shape_kind kind = KINDS[dice_pick(roll, 7)];
    double axis[3];
    dice_direction(roll, axis);
    if (dice_pick(roll, 3) == 0) { // along an axis of the grid
        axis[0] = axis[1] = 0.0;
        axis[2] = 1.0;
    }
    const clod_vec3 center = {dice_real(roll, -0.3, 1.3), dice_real(roll, -0.3, 1.3),
                              dice_real(roll, -0.3, 1.3)};
    clod_shape shape = shape_along(kind, center, (clod_vec3){axis[0], axis[1], axis[2]});
    const double size = exp(dice_real(roll, log(1e-3), log(0.7)));
    shape.outer = size;
    shape.inner = dice_real(roll, 0.0, 1.0) * size;
    for (int a = 0; a < 3; a++) {
        shape.half[a] = size * dice_real(roll, 0.1, 1.0);
    }
    shape.side = dice_pick(roll, 2) == 0 ? CLOD_SIDE_INSIDE : CLOD_SIDE_OUTSIDE;
    return shape;
}

/** Grains at random in the unit cube, some at the borders of cells, and walls of shapes. */
static void random_scene(scene *s, uint64_t seed, int grains, int walls, int shapes)
{
    const clod_case_contact ore = contact_ore();
    dice roll = {seed};
    scene_init(s, 1e-6, &ore);
    for (int g = 0; g < grains; g++) {
        double at[3];
        for (int a = 0; a < 3; a++) {
            at[a] = dice_pick(&roll, 4) == 0 ? 0.125 * dice_pick(&roll, 9)
                                             : dice_real(&roll, 0.0, 1.0);
        }
        scene_grain(s, at[0], at[1], at[2], dice_real(&roll, 2e-3, 2e-2));
    }
    for (int w = 0; w < walls; w++) {
        char name[32];
        snprintf(name, sizeof name, "wall %d", w);
        clod_wall *wall = scene_wall(s, name, any_shape(&roll));
        wall->shapes = clod_memory_grow(wall->shapes, 1, (size_t)shapes, sizeof *wall->shapes);
        wall->shape_count = shapes;
        for (int k = 1; k < shapes; k++) {
            wall->shapes[k] = any_shape(&roll);
        }
        wall->shift =
            (clod_vec3){dice_real(&roll, -0.1, 0.1), dice_real(&roll, -0.1, 0.1), 0.0};
        wall->angle = dice_real(&roll, -3.0, 3.0);
    }
}

/** What was found with cells and without; the scene ends. */
static void compare(scene *s)
{
    clod_status status = {0};
    clod_neighbour *search = &s->step.neighbour;
    clod_neighbour_init(search, &s->state, false);
    search->skin = SKIN;
    assert_true(clod_neighbour_sort(search, &s->state, &status));
    assert_true(clod_neighbour_build(search, &s->state, &s->laws, &status));
    const size_t count = search->walls.count;
    clod_wall_candidate *found = clod_memory_alloc(count + 1, sizeof *found);
    memcpy(found, search->walls.item, count * sizeof *found);
    search->walls.count = 0;
    assert_true(clod_wall_cells_find_all(
        search, &s->state, &s->laws, (clod_chunk){0, s->state.grains.count}, &search->walls));
    assert_int_equal(count, search->walls.count);
    assert_true(count > 0);
    for (size_t k = 0; k < count; k++) {
        const clod_wall_candidate *one = &found[k];
        const clod_wall_candidate *all = &search->walls.item[k];
        assert_true(one->i == all->i && one->wall == all->wall && one->shape == all->shape &&
                    one->law == all->law);
    }
    clod_memory_free(found);
    clod_neighbour_fini(search);
    clod_state_fini(&s->state);
}

static void check_candidates(uint64_t seed, int grains, int walls, int shapes)
{
    scene s;
    random_scene(&s, seed, grains, walls, shapes);
    compare(&s);
}

/** Grains in the corners of cells, and for each a speck just within its reach, straight away
 *  from the centre of the cell: the farthest that a shape of a cell can be. */
static void specks_beyond_the_corners_are_found(void **state)
{
    (void)state;
    enum { GRAINS = 200 };
    const double radius = 0.02;
    const clod_case_contact ore = contact_ore();
    clod_status status = {0};
    dice roll = {11};
    scene s;
    scene_init(&s, 1e-6, &ore);
    for (int g = 0; g < GRAINS; g++) { // the first two hold the grid where it is
        const double x = g == 0 ? 0.0 : g == 1 ? 1.0 : 0.5;
        scene_grain(&s, x, x, x, radius);
    }
    clod_neighbour search;
    clod_neighbour_init(&search, &s.state, false);
    search.skin = SKIN;
    assert_true(clod_neighbour_sort(&search, &s.state, &status));
    const clod_cells_grid grid = clod_cells_grid_of(&search, &s.state);
    clod_neighbour_fini(&search);
    clod_wall *specks = scene_wall(&s, "specks", shape_floor(-1.0));
    specks->shapes = clod_memory_grow(specks->shapes, 1, GRAINS, sizeof *specks->shapes);
    specks->shape_count = GRAINS;
    for (int g = 0; g < GRAINS; g++) {
        double *at = s.state.grains.position[g];
        double speck[3];
        for (int a = 0; a < 3; a++) {
            const int cell = dice_pick(&roll, grid.n[a]), up = dice_pick(&roll, 2);
            if (at[a] == 0.5) {
                at[a] = ((double)cell + (up ? 1.0 - 1e-9 : 1e-9)) / grid.inverse_width[a];
            }
            speck[a] = at[a] + (up ? 1.0 : -1.0) * 0.999 * (radius + SKIN) / sqrt(3.0);
        }
        specks->shapes[g] =
            shape_box((clod_vec3){speck[0], speck[1], speck[2]}, 1e-9, 1e-9, 1e-9);
    }
    compare(&s);
}

static void cells_find_what_a_look_at_every_shape_finds(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 40; seed += sanitized() ? 5 : 1) {
        check_candidates(seed, 400, 1 + (int)seed % 8, 1 + 7 * (int)seed);
    }
    check_candidates(77, 1, 3, 50); // a grid of one cell
    check_candidates(78, 2, 1, 900);
}

/** Numbers beyond 16 bits. */
static void a_hundred_thousand_shapes_are_found(void **state)
{
    (void)state;
    check_candidates(5, 40, 1, 100000);
}

/** A bed in a drum, and boxes on a grid around and far above it that no grain comes near. */
static void far_boxes_change_no_bit(void **state)
{
    (void)state;
    scene plain, crowded;
    bed_init(&plain, BED_DRUM, 3);
    bed_init(&crowded, BED_DRUM, 3);
    clod_wall *wall =
        scene_wall(&crowded, "boxes", shape_box((clod_vec3){0.0, 0.0, 0.12}, 1e-3, 1e-3, 1e-3));
    wall->shapes = clod_memory_grow(wall->shapes, 1, 10000, sizeof *wall->shapes);
    wall->shape_count = 10000;
    for (int k = 1; k < 10000; k++) {
        const int column = k % 50, line = k / 50 % 50, layer = k / 2500;
        const clod_vec3 at = {-0.1 + 4e-3 * column, -0.1 + 4e-3 * line, 0.12 + 4e-3 * layer};
        wall->shapes[k] = shape_box(at, 1e-3, 1e-3, 1e-3);
    }
    scene_start(&plain);
    scene_start_with(&crowded, (clod_step_options){.threads = 2});
    scene_run(&plain, 9000);
    scene_run(&crowded, 9000);
    assert_true(clod_step_export(&plain.step, &plain.step.status));
    assert_true(clod_step_export(&crowded.step, &crowded.step.status));
    assert_true(crowded.step.rebuilds > 3);
    assert_true(bits_same_grains(&plain.state.grains, &crowded.state.grains));
    assert_true(bits_same_contacts(&plain.state, &crowded.state));
    const clod_wall *boxes = &crowded.state.walls.wall[crowded.state.walls.count - 1];
    assert_int_equal(boxes->sum_steps, plain.state.walls.wall[0].sum_steps);
    crowded.state.walls.count--; // the others are the same
    assert_true(bits_same_walls(&plain.state.walls, &crowded.state.walls));
    crowded.state.walls.count++;
    scene_end(&plain);
    scene_end(&crowded);
}

/** Walls that start, stop and are loaded between advances do what they should at once. */
static void walls_may_start_and_stop(void **state)
{
    (void)state;
    const clod_case_contact ore = contact_ore();
    scene s;
    scene_init(&s, 1e-6, &ore);
    scene_grain(&s, 0.0, 0.0, 1.0, 1e-3);
    clod_wall *wall = scene_wall(&s, "floor", shape_floor(0.0));
    scene_start(&s);
    scene_run(&s, 10);
    assert_true(wall->shift.z == 0.0);
    wall->velocity.z = 2.0;
    scene_run(&s, 10);
    check_relative(wall->shift.z, 2e-5, 1e-12);
    wall->velocity.z = 0.0;
    scene_run(&s, 10);
    check_relative(wall->shift.z, 2e-5, 1e-12);
    wall->load = CLOD_LOAD_FORCE; // far from any grain
    wall->load_force = 3.0;
    wall->mass = 2.0;
    scene_run(&s, 100);
    check_relative(wall->servo_velocity, 3.0 / 2.0 * 1e-4, 1e-10); // F/m t
    assert_int_equal(wall->sum_steps, 130);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_find_what_a_look_at_every_shape_finds),
        cmocka_unit_test(specks_beyond_the_corners_are_found),
        cmocka_unit_test(a_hundred_thousand_shapes_are_found),
        cmocka_unit_test(far_boxes_change_no_bit),
        cmocka_unit_test(walls_may_start_and_stop),
    };
    if (looks_for_races()) {
        cmocka_set_test_filter("far_boxes*"); // others have one thread
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
