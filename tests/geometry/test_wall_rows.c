// Rows of walls in space (src/geometry/wall_rows.c): the same gaps as in the wall's frame,
// where the point is taken back by the wall's pose; velocities against clod_wall_velocity_at.

#include "base/random.h"
#include "geometry/wall_pose.h"
#include "geometry/wall_rows.h"
#include "support/check.h"

enum { KINDS = 7, POINTS = 1000 };

static double between(double from, double to, uint64_t item, uint64_t draw)
{
    return from + (to - from) * clod_random_uniform(11, CLOD_RANDOM_TEST, item, draw);
}

static clod_vec3 random_point(uint64_t item)
{
    return (clod_vec3){between(-4.0, 4.0, item, 0), between(-4.0, 4.0, item, 1),
                       between(-4.0, 4.0, item, 2)};
}

/** One shape of every kind, tilted and beside the origin. */
static void make_shapes(clod_shape shapes[KINDS])
{
    static const clod_shape_kind ALL[KINDS] = {
        CLOD_SHAPE_PLANE, CLOD_SHAPE_DISC, CLOD_SHAPE_ANNULUS, CLOD_SHAPE_CYLINDER,
        CLOD_SHAPE_CONE,  CLOD_SHAPE_BOX,  CLOD_SHAPE_BAR};
    const clod_vec3 turn = clod_vec3_unit((clod_vec3){1.0, -2.0, 0.5});
    for (int k = 0; k < KINDS; k++) {
        clod_shape *s = &shapes[k];
        *s = (clod_shape){.kind = ALL[k],
                          .center = {0.3, -0.2 * k, 0.1},
                          .outer = 2.0,
                          .half = {0.5, 1.0, 1.5},
                          .side = k % 2 == 0 ? CLOD_SIDE_INSIDE : CLOD_SIDE_OUTSIDE};
        s->inner = s->kind == CLOD_SHAPE_DISC ? 0.0 : 0.8;
        s->axis[0] = clod_vec3_rotate((clod_vec3){1.0, 0.0, 0.0}, turn, 0.7 + k);
        s->axis[1] = clod_vec3_rotate((clod_vec3){0.0, 1.0, 0.0}, turn, 0.7 + k);
        s->axis[2] = clod_vec3_rotate((clod_vec3){0.0, 0.0, 1.0}, turn, 0.7 + k);
    }
}

/** A wall that moves in every way, and one at rest, with the same shapes. */
static void make_walls(clod_wall wall[2], clod_shape *shapes)
{
    wall[0] = (clod_wall){.spin_axis = clod_vec3_unit((clod_vec3){1.0, 2.0, -0.5}),
                          .spin_point = {0.1, 0.2, -0.3},
                          .shift = {1.0, -2.0, 0.5},
                          .angle = 2.3,
                          .velocity = {0.4, 0.1, -0.2},
                          .surface_velocity = {0.0, 0.5, 0.0},
                          .spin = 2.0,
                          .load_axis = {0.0, 0.0, -1.0},
                          .servo_velocity = 0.25};
    wall[1] = (clod_wall){.spin_axis = {0.0, 0.0, 1.0}};
    for (int w = 0; w < 2; w++) {
        wall[w].shapes = shapes;
        wall[w].shape_count = KINDS;
    }
}

/** The walls, and their rows. */
typedef struct yard {
    clod_shape shapes[2 * KINDS];
    clod_wall wall[2];
    clod_walls walls;
    clod_wall_rows rows;
} yard;

static void yard_init(yard *self)
{
    make_shapes(self->shapes);
    make_walls(self->wall, self->shapes);
    self->walls = (clod_walls){.count = 2, .wall = self->wall};
    assert_true(clod_wall_rows_init(&self->rows, &self->walls));
}

static double apart(clod_vec3 a, clod_vec3 b)
{
    return clod_vec3_length(clod_vec3_sub(a, b));
}

static void gaps_are_those_of_the_turned_wall(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    const clod_wall_pose pose = clod_wall_pose_now(&y.wall[0]);
    for (uint64_t i = 0; i < POINTS; i++) {
        const clod_vec3 p = random_point(i);
        for (int s = 0; s < KINDS; s++) {
            const clod_gap gap = clod_wall_rows_gap(&y.rows, 0, s, (double[3]){p.x, p.y, p.z});
            const clod_gap framed = clod_wall_gap(&y.shapes[s], clod_wall_to_frame(&pose, p));
            check_close(gap.distance, framed.distance, 1e-14);
            check_close(apart(gap.normal, clod_wall_to_space(&pose, framed.normal)), 0.0,
                        1e-12);
        }
    }
    clod_wall_rows_fini(&y.rows);
}

static void wall_at_rest_has_the_shapes_that_were_given(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    for (int s = 0; s < KINDS; s++) {
        const clod_vec3 p = random_point((uint64_t)s);
        const clod_gap gap = clod_wall_rows_gap(&y.rows, 1, s, (double[3]){p.x, p.y, p.z});
        const clod_gap given = clod_wall_gap(&y.shapes[s], p);
        assert_true(gap.distance == given.distance);
        assert_true(apart(gap.normal, given.normal) == 0.0);
    }
    clod_wall_rows_fini(&y.rows);
}

// Shapes with their axis on the wall's: turning them changes nothing but the last bits.
static void symmetric_shape_is_the_same_at_any_angle(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    clod_wall_rows_fini(&y.rows);
    const clod_vec3 axis = y.wall[0].spin_axis;
    for (int k = 0; k < KINDS; k++) {
        clod_shape *s = &y.shapes[k];
        s->center = clod_vec3_axpy(y.wall[0].spin_point, 0.1 * k, axis);
        s->axis[0] = clod_vec3_unit(clod_vec3_cross(axis, (clod_vec3){0.0, 0.0, 1.0}));
        s->axis[1] = clod_vec3_cross(axis, s->axis[0]);
        s->axis[2] = axis;
        y.shapes[KINDS + k] = *s;
        y.shapes[KINDS + k].symmetric = true;
    }
    y.wall[0].shape_count = 2 * KINDS;
    assert_true(clod_wall_rows_init(&y.rows, &y.walls));
    for (uint64_t i = 0; i < POINTS; i++) {
        const clod_vec3 p = random_point(i);
        for (int k = 0; k < KINDS; k++) {
            if (y.shapes[k].kind == CLOD_SHAPE_BOX || y.shapes[k].kind == CLOD_SHAPE_BAR) {
                continue;
            }
            const double at[3] = {p.x, p.y, p.z};
            const clod_gap turned = clod_wall_rows_gap(&y.rows, 0, k, at);
            const clod_gap still = clod_wall_rows_gap(&y.rows, 0, KINDS + k, at);
            check_close(still.distance, turned.distance, 1e-13);
            check_close(apart(still.normal, turned.normal), 0.0, 1e-12);
        }
    }
    clod_wall_rows_fini(&y.rows);
}

static void check_rows(const double (*a)[4], const double (*b)[4], int count)
{
    for (int r = 0; r < count; r++) {
        for (int c = 0; c < 4; c++) {
            assert_true(a[r][c] == b[r][c]);
        }
    }
}

static void rows_follow_walls_that_move(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    clod_wall_rows fresh;
    for (int64_t step = 1; step <= 3; step++) {
        clod_wall_move(&y.wall[0], 0.1, step);
        y.wall[0].servo_velocity += 0.5;
        y.wall[1].surface_velocity.x += 0.25; // a belt: nothing else of this wall changes
        clod_wall_rows_update(&y.rows, &y.walls);
        assert_true(clod_wall_rows_init(&fresh, &y.walls));
        check_rows((const double(*)[4])y.rows.shape, (const double(*)[4])fresh.shape,
                   2 * KINDS * CLOD_SHAPE_ROWS);
        clod_wall_rows_fini(&fresh);
    }
    clod_wall_rows_fini(&y.rows);
}

/** Velocity of the material at a point from the rows: v + w x (p - origin). */
static clod_vec3 velocity_at(const double (*row)[4], clod_vec3 p)
{
    const double *v = row[CLOD_SHAPE_VELOCITY], *spin = row[CLOD_SHAPE_SPIN];
    const double *origin = row[CLOD_SHAPE_ORIGIN];
    const clod_vec3 arm = {p.x - origin[0], p.y - origin[1], p.z - origin[2]};
    const clod_vec3 turning = {spin[0], spin[1], spin[2]};
    return clod_vec3_add((clod_vec3){v[0], v[1], v[2]}, clod_vec3_cross(turning, arm));
}

/** Velocity of the material from the rows, as wall_rows.h says. */
static clod_vec3 material_at(const double (*row)[4], clod_vec3 p, clod_vec3 n)
{
    const double *o = row[CLOD_SHAPE_ORIGIN], *b = row[CLOD_SHAPE_BELT];
    const double *w = row[CLOD_SHAPE_BELT_SPIN], *d = row[CLOD_SHAPE_DIRECTION];
    const clod_vec3 arm = {p.x - o[0], p.y - o[1], p.z - o[2]};
    const clod_vec3 turning = {w[0], w[1], w[2]}, direction = {d[0], d[1], d[2]};
    const clod_vec3 along =
        clod_vec3_unit(clod_vec3_axpy(direction, -clod_vec3_dot(direction, n), n));
    clod_vec3 u = clod_vec3_add((clod_vec3){b[0], b[1], b[2]}, clod_vec3_cross(turning, arm));
    u = clod_vec3_axpy(u, b[3], along);
    u = clod_vec3_axpy(u, -clod_vec3_dot(u, n), n);
    return clod_vec3_add(velocity_at(row, p), u);
}

static void rows_tell_how_belts_move(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    clod_wall_rows_fini(&y.rows);
    clod_wall_set_orientation(&y.wall[0], (clod_quat){0.3, -0.5, 0.2, 0.7});
    y.wall[0].angle = 2.3;
    for (int s = 0; s < KINDS; s++) {
        const clod_vec3 axis = clod_vec3_unit(random_point(900 + (uint64_t)s));
        y.shapes[s].belt = (clod_belt){.velocity = random_point(700 + (uint64_t)s),
                                       .direction = axis,
                                       .speed = 0.7 * s,
                                       .spin = 1.3,
                                       .spin_axis = {axis.y, axis.z, axis.x},
                                       .spin_point = random_point(800 + (uint64_t)s)};
    }
    assert_true(clod_wall_rows_init(&y.rows, &y.walls));
    for (uint64_t i = 0; i < POINTS; i++) {
        const clod_vec3 p = random_point(i), n = clod_vec3_unit(random_point(i + POINTS));
        for (int32_t s = 0; s < KINDS; s++) {
            const double(*row)[4] =
                (const double(*)[4])y.rows.shape + clod_wall_rows_shape(&y.rows, 0, s);
            const clod_vec3 v = clod_wall_material_velocity(&y.wall[0], s, p, n);
            check_close(apart(material_at(row, p, n), v), 0.0, 1e-12);
        }
    }
    clod_wall_rows_fini(&y.rows);
}

static void rows_tell_how_a_wall_moves(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    for (uint64_t i = 0; i < POINTS; i++) {
        const clod_vec3 p = random_point(i);
        for (int w = 0; w < 2; w++) {
            for (int32_t s = 0; s < KINDS; s++) {
                const double(*row)[4] =
                    (const double(*)[4])y.rows.shape + clod_wall_rows_shape(&y.rows, w, s);
                const clod_vec3 v = clod_wall_velocity_at(&y.wall[w], p);
                check_close(apart(velocity_at(row, p), v), 0.0, 1e-13);
            }
        }
    }
    clod_wall_rows_fini(&y.rows);
}

/** The rows know how far their walls reach, and with that how fast they can be. */
static void reaches_are_those_of_the_walls(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    for (int w = 0; w < 2; w++) {
        assert_true(y.rows.reach[w] == clod_wall_reach(&y.wall[w]));
        const double bound = clod_wall_speed_within(&y.wall[w], y.rows.reach[w]);
        assert_true(bound == clod_wall_speed_bound(&y.wall[w]));
    }
    const clod_shape *bar = &y.shapes[KINDS - 1];
    clod_vec3 corner = bar->center;
    corner = clod_vec3_axpy(corner, bar->half[0], bar->axis[0]);
    corner = clod_vec3_axpy(corner, bar->half[1], bar->axis[1]);
    corner = clod_vec3_axpy(corner, bar->half[2], bar->axis[2]);
    const clod_vec3 arm = clod_vec3_sub(corner, y.wall[0].spin_point);
    const double along = clod_vec3_dot(arm, y.wall[0].spin_axis);
    const double away = sqrt(clod_vec3_dot(arm, arm) - along * along);
    assert_true(y.rows.reach[0] >= away * (1.0 - 1e-12));
    clod_wall_rows_fini(&y.rows);
}

/** Near is what has a gap below the reach, whatever spheres about boxes say. */
static void near_is_within_the_reach(void **state)
{
    (void)state;
    yard y;
    yard_init(&y);
    int near = 0;
    for (uint64_t k = 0; k < POINTS; k++) {
        const clod_vec3 at = random_point(k);
        const double p[3] = {at.x, at.y, at.z};
        const double reach = between(0.0, 3.0, k, 3);
        for (int32_t w = 0; w < 2; w++) {
            for (int32_t s = 0; s < KINDS; s++) {
                const double gap = clod_wall_rows_gap(&y.rows, w, s, p).distance;
                const bool said = clod_wall_rows_is_near(&y.rows, w, s, p, reach);
                assert_true(said == (gap < reach));
                near += said;
            }
        }
    }
    assert_true(near > POINTS / 10 && near < 2 * KINDS * POINTS - POINTS / 10);
    clod_wall_rows_fini(&y.rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gaps_are_those_of_the_turned_wall),
        cmocka_unit_test(reaches_are_those_of_the_walls),
        cmocka_unit_test(wall_at_rest_has_the_shapes_that_were_given),
        cmocka_unit_test(symmetric_shape_is_the_same_at_any_angle),
        cmocka_unit_test(rows_follow_walls_that_move),
        cmocka_unit_test(rows_tell_how_a_wall_moves),
        cmocka_unit_test(rows_tell_how_belts_move),
        cmocka_unit_test(near_is_within_the_reach),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
