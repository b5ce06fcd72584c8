// A warm step allocates nothing, rebuilds included: the same steps, gone through again and
// again from the same start, ask for no memory once the buffers have seen them.

#include "support/bed.h"

#define STEPS 2000

/** Back to the start with the step's buffers kept. */
static void rewind_to(scene *s, const clod_state *start)
{
    clod_status status = {0};
    clod_grains *g = &s->state.grains;
    const size_t n = g->count;
    memcpy(g->position, start->grains.position, n * sizeof *g->position);
    memcpy(g->velocity, start->grains.velocity, n * sizeof *g->velocity);
    memcpy(g->angular_velocity, start->grains.angular_velocity,
           n * sizeof *g->angular_velocity);
    memcpy(g->load, start->grains.load, n * sizeof *g->load);
    memcpy(g->id, start->grains.id, n * sizeof *g->id);
    memcpy(g->material, start->grains.material, n * sizeof *g->material);
    for (int32_t w = 0; w < s->state.walls.count; w++) {
        clod_shape *shapes = s->state.walls.wall[w].shapes;
        s->state.walls.wall[w] = start->walls.wall[w];
        s->state.walls.wall[w].shapes = shapes;
    }
    clod_wall_rows_update(&s->step.walls, &s->state.walls);
    s->state.contact_count = s->state.wall_contact_count = 0;
    s->step.thread[0].age = 0.0;
    const clod_near_job job = {.near = &s->step.near,
                               .neighbour = &s->step.neighbour,
                               .state = &s->state,
                               .laws = &s->laws,
                               .walls = &s->step.walls,
                               .skins = {.least = 5e-6, .most = 5e-6, .wall = 5e-6},
                               .runs = 1};
    assert_true(clod_neighbour_sort(&s->step.neighbour, &s->state, &status) &&
                clod_neighbour_build(&s->step.neighbour, &s->state, &s->laws, &status) &&
                clod_near_make(&job, &status));
    s->step.view.wall_sum = s->step.near.wall_sum;
}

static void check_warm(bed_kind kind, int threads)
{
    clod_status status = {0};
    clod_state start = {0};
    scene s;
    bed_init(&s, kind, 3);
    assert_true(clod_state_copy(&start, &s.state, &status));
    scene_start_with(&s, (clod_step_options){.threads = threads});
    uint64_t allocations = 0;
    for (int pass = 0; pass < 4; pass++) { // two buffers take turns: both must have seen it
        rewind_to(&s, &start);
        const uint64_t before = clod_memory_count();
        const int64_t rebuilds = s.step.rebuilds;
        const int64_t refreshes = s.step.refreshes;
        scene_run(&s, STEPS);
        assert_true(clod_step_export(&s.step, &status));
        allocations = clod_memory_count() - before;
        assert_true(s.step.rebuilds > rebuilds + 3); // all paths were taken
        assert_true(s.step.refreshes > refreshes + 10);
        assert_true(pass > 0 || allocations > 0); // the count counts
    }
    assert_int_equal(allocations, 0);
    scene_end(&s);
    clod_state_fini(&start);
}

static void warm_steps_of_one_thread_allocate_nothing(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        check_warm((bed_kind)kind, 1);
    }
}

static void warm_steps_of_two_threads_allocate_nothing(void **state)
{
    (void)state;
    check_warm(BED_DRUM, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(warm_steps_of_one_thread_allocate_nothing),
        cmocka_unit_test(warm_steps_of_two_threads_allocate_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
