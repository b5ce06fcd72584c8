// Candidates at meshes (src/step/wall_mesh.c): at a rebuild and at a near list the patches and
// slots, found by one walk for each surface, are those that clod_wall_rows_is_near tells of each
// alone; and the facets that are noted are those within reach by their closest points. A hundred
// thousand facets elsewhere change none of it.
#include "mesh/mesh_maker.h"
#include "mesh/surface_touch.h"
#include "step/wall_cells.h"
#include "step/wall_mesh.h"
#include "support/dice.h"
#include "support/scene.h"

enum { GRAINS = 400, AROUND = 24, SIDE = 5 };

/** A surface of what is made. */
static clod_surface *surface_of(maker *made)
{
    return maker_surface(made, 0.35);
}

static void put(maker *made, const float p[4][3])
{
    maker_add(made, p[0], p[1], p[2]);
    maker_add(made, p[0], p[2], p[3]);
}

/** The unit cube, each side in 5 by 5 pieces: sharp rims. */
static maker *make_cube(void)
{
    maker *made = maker_new();
    for (int side = 0; side < 6; side++) {
        for (int k = 0; k < SIDE * SIDE; k++) {
            float p[4][3];
            for (int c = 0; c < 4; c++) {
                const int u = k % SIDE + (c == 1 || c == 2), v = k / SIDE + (c >= 2);
                p[c][side / 2] = (float)(side % 2);
                p[c][(side / 2 + 1) % 3] = (float)u / SIDE;
                p[c][(side / 2 + 2) % 3] = (float)v / SIDE;
            }
            put(made, (const float(*)[3])p);
        }
    }
    return made;
}

static clod_surface *cube(void)
{
    return surface_of(make_cube());
}

/** An open tube of radius 0.3 about the axis x = y = 0.5: many patches, rims at its ends. */
static clod_surface *tube(bool round)
{
    maker *made = maker_new();
    for (int k = 0; k < AROUND; k++) {
        float p[4][3];
        for (int c = 0; c < 4; c++) {
            const double a = 2.0 * M_PI * ((k + (c == 1 || c == 2)) % AROUND) / AROUND;
            p[c][0] = (float)(0.5 + 0.3 * cos(a));
            p[c][1] = (float)(0.5 + 0.3 * sin(a));
            p[c][2] = c < 2 ? 0.1f : 0.8f;
        }
        put(made, (const float(*)[3])p);
    }
    clod_surface *surface = surface_of(made);
    const clod_surface_cylinder cylinder = {{0.5, 0.5, 0.0}, {0.0, 0.0, 1.0}, 0.3};
    assert_true(!round || clod_surface_make_round(surface, 0, &cylinder));
    return surface;
}

/** Put the shapes of a surface behind those of a wall. */
static void add_surface(clod_wall *wall, clod_surface *surface)
{
    const int32_t count = CLOD_SURFACE_SLOTS * (int32_t)surface->patch_count;
    const size_t before = (size_t)wall->shape_count;
    wall->shapes =
        clod_memory_grow(wall->shapes, before, before + (size_t)count, sizeof *wall->shapes);
    for (int32_t k = 0; k < count; k++) {
        const clod_surface_patch *patch = &surface->patches[k / CLOD_SURFACE_SLOTS];
        clod_shape *to = &wall->shapes[wall->shape_count++];
        *to = shape_floor(0.0);
        to->kind = CLOD_SHAPE_MESH;
        to->symmetric = false;
        to->center = clod_vec3_scale(
            clod_vec3_add(clod_vec3_of(patch->low), clod_vec3_of(patch->high)), 0.5);
        to->surface = clod_surface_share(surface);
        to->patch = k / CLOD_SURFACE_SLOTS;
        to->slot = k % CLOD_SURFACE_SLOTS;
    }
    clod_surface_release(surface);
}

/** Grains of many sizes about the meshes; a wall that is turned, and one of a plane and two. */
static void begin(scene *s, dice *roll)
{
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-6, &ore);
    for (int g = 0; g < GRAINS; g++) {
        scene_grain(s, dice_real(roll, -0.2, 1.2), dice_real(roll, -0.2, 1.2),
                    dice_real(roll, -0.2, 1.2), dice_real(roll, 0.01, 0.1));
    }
    add_surface(scene_wall(s, "floor", shape_floor(0.0)), cube());
    add_surface(&s->state.walls.wall[0], tube(true));
    clod_wall *turned = scene_wall(s, "turned", shape_floor(0.0));
    add_surface(turned, tube(false));
    turned->shift = (clod_vec3){0.1, -0.2, 0.0};
    turned->angle = 0.7;
}

/** Look at every grain and shape: what the candidates say, in their order. */
static int compare(const scene *s, const clod_wall_rows *rows, const double (*position)[4],
                   double skin, bool thin)
{
    const clod_wall_candidates *found = &s->step.neighbour.walls;
    size_t at = 0;
    int near = 0;
    for (size_t g = 0; g < s->state.grains.count; g++) {
        for (int32_t w = 0; w < s->state.walls.count; w++) {
            for (int32_t k = 0; k < s->state.walls.wall[w].shape_count; k++) {
                const double *p = position[g];
                const bool is = clod_wall_rows_is_near(rows, w, k, p, p[3] + skin);
                const clod_wall_candidate *c = &found->item[at];
                const bool listed =
                    at < found->count && (size_t)c->i == g && c->wall == w && c->shape == k;
                const bool said = listed && (!thin || c->near != 0);
                const clod_wall_patch *patch = clod_wall_rows_patch(rows, w, k);
                // a chord at the rim may be nearer than what it stands for
                const bool chord = patch->surface != NULL && patch->slot > 0 &&
                                   patch->surface->cylinder_count > 0;
                assert_true(is == said || (chord && is));
                at += listed;
                near += is;
            }
        }
    }
    assert_int_equal(at, found->count);
    return near;
}

/** The facets that a first slot has noted are those within reach, or the weld distance beyond. */
static int compare_facets(const scene *s, const clod_wall_rows *rows, double skin)
{
    const clod_wall_candidates *found = &s->step.neighbour.walls;
    int noted = 0;
    for (size_t k = 0; k < found->count; k++) {
        const clod_wall_candidate *c = &found->item[k];
        const clod_wall_patch *at = clod_wall_rows_patch(rows, c->wall, c->shape);
        if (at->surface == NULL || at->slot > 0) {
            continue;
        }
        const double *p = s->state.grains.position[c->i];
        const int32_t row = clod_wall_rows_shape(rows, c->wall, c->shape);
        const clod_wall_pose pose =
            clod_wall_facets_pose((const double(*)[4])rows->shape + row);
        const clod_vec3 from = clod_wall_to_frame(&pose, clod_vec3_of(p));
        int here = 0, all = 0;
        for (int32_t f = 0; f < c->facets; f++) {
            const clod_wall_facet facet = found->facet[c->facet + (size_t)f];
            const double d = clod_surface_closest_of(at->surface, facet.number, from).distance;
            assert_true(facet.near || d >= p[3] + skin);
            assert_true(!facet.near || at->surface->cylinder_count > 0 ||
                        d < p[3] + skin + 2.0 * at->surface->weld);
            assert_int_equal(at->surface->patch[facet.number], at->patch);
            here += facet.near;
        }
        for (uint32_t f = 0; f < at->surface->facet_count; f++) {
            all += at->surface->patch[f] == (uint32_t)at->patch &&
                   clod_surface_closest_of(at->surface, f, from).distance < p[3] + skin;
        }
        assert_true(all <= here);
        noted += here;
    }
    return noted;
}

static void one_walk_finds_what_a_look_at_each_shape_finds(void **state)
{
    (void)state;
    const double wide = 0.04, thin = 0.015;
    for (uint64_t seed = 1; seed <= 5; seed++) {
        dice roll = {seed};
        clod_status status = {0};
        scene s;
        begin(&s, &roll);
        clod_neighbour *search = &s.step.neighbour;
        clod_neighbour_init(search, &s.state, seed == 5);
        search->skin = wide;
        assert_true(clod_neighbour_sort(search, &s.state, &status));
        assert_true(clod_neighbour_build(search, &s.state, &s.laws, &status));
        const clod_wall_rows *rows = &search->build_rows;
        assert_true(compare(&s, rows, (const double(*)[4])s.state.build_position, wide, false) >
                    1000);
        for (size_t g = 0; g < GRAINS; g++) { // so far that the candidates still hold
            double way[3];
            dice_direction(&roll, way);
            const double far = dice_real(&roll, 0.0, wide - thin);
            for (int a = 0; a < 3; a++) {
                s.state.grains.position[g][a] += far * way[a];
            }
        }
        for (size_t k = 0; k < search->walls.count; k++) {
            clod_wall_candidate *c = &search->walls.item[k];
            const double *p = s.state.grains.position[c->i];
            const bool mesh = clod_wall_rows_patch(rows, c->wall, c->shape)->surface != NULL;
            c->near = mesh ? clod_wall_mesh_mark(&search->walls, c, rows, p, p[3] + thin)
                           : clod_wall_rows_is_near(rows, c->wall, c->shape, p, p[3] + thin);
        }
        assert_true(compare(&s, rows, (const double(*)[4])s.state.grains.position, thin, true) >
                    500);
        assert_true(compare_facets(&s, rows, thin) > 500);
        clod_neighbour_fini(search);
        clod_state_fini(&s.state);
    }
}

/** A ring of 100 352 facets that no grain reaches. */
static void add_ring(maker *made)
{
    enum { U = 224, V = 224 };
    for (int k = 0; k < U * V; k++) {
        float p[4][3];
        for (int c = 0; c < 4; c++) {
            const double a = 2.0 * M_PI * ((k / V + (c == 1 || c == 2)) % U) / U;
            const double b = 2.0 * M_PI * ((k % V + (c >= 2)) % V) / V;
            p[c][0] =
                (float)(0.5 + (4.0 + cos(b)) * cos(a)); // 2.5 m or more from the cube's middle
            p[c][1] = (float)(0.5 + (4.0 + cos(b)) * sin(a));
            p[c][2] = (float)(0.5 + sin(b));
        }
        put(made, (const float(*)[3])p);
    }
}

/** Candidates of 400 grains about the cube, with or without the ring in the same file. */
static clod_wall_candidates candidates_of(scene *s, bool ring)
{
    dice roll = {3};
    clod_status status = {0};
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-6, &ore);
    for (int g = 0; g < GRAINS; g++) {
        scene_grain(s, dice_real(&roll, -0.2, 1.2), dice_real(&roll, -0.2, 1.2),
                    dice_real(&roll, -0.2, 1.2), dice_real(&roll, 0.01, 0.1));
    }
    maker *made = make_cube();
    if (ring) {
        add_ring(made);
    }
    add_surface(scene_wall(s, "floor", shape_floor(0.0)), surface_of(made));
    clod_neighbour *search = &s->step.neighbour;
    clod_neighbour_init(search, &s->state, false);
    search->skin = 0.04;
    assert_true(clod_neighbour_sort(search, &s->state, &status));
    assert_true(clod_neighbour_build(search, &s->state, &s->laws, &status));
    return search->walls;
}

static int compare_numbers(const void *left, const void *right)
{
    const uint32_t *a = left, *b = right;
    return *a < *b ? -1 : *a > *b;
}

static void sorted_facets(const clod_wall_candidates *of, const clod_wall_candidate *at,
                          uint32_t *number)
{
    assert_true(at->facets <= 600);
    for (int32_t f = 0; f < at->facets; f++) {
        number[f] = of->facet[at->facet + (size_t)f].number;
    }
    qsort(number, (size_t)at->facets, sizeof *number, compare_numbers);
}

static void facets_far_away_change_no_candidate(void **state)
{
    (void)state;
    static scene few, many;
    const clod_wall_candidates a = candidates_of(&few, false), b = candidates_of(&many, true);
    assert_true(a.count > 500);
    assert_int_equal(a.count, b.count);
    size_t facets = 0;
    for (size_t k = 0; k < a.count; k++) {
        const clod_wall_candidate *x = &a.item[k], *y = &b.item[k];
        assert_true(x->i == y->i && x->wall == y->wall && x->shape == y->shape);
        assert_int_equal(x->facets, y->facets);
        uint32_t own[600], other[600]; // in the order of the tree, which is another one
        sorted_facets(&a, x, own);
        sorted_facets(&b, y, other);
        assert_memory_equal(own, other, (size_t)x->facets * sizeof *own);
        facets += (size_t)x->facets;
    }
    assert_true(facets > 500);
    clod_neighbour_fini(&few.step.neighbour);
    clod_neighbour_fini(&many.step.neighbour);
    clod_state_fini(&few.state);
    clod_state_fini(&many.state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_walk_finds_what_a_look_at_each_shape_finds),
        cmocka_unit_test(facets_far_away_change_no_candidate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
