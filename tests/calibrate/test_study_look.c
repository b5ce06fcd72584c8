/**
 * The first point is looked at before any other is computed.
 */

#include "calibrate/study.h"
#include "plan_made.h"
#include "support/check.h"

typedef struct record {
    size_t computed, looked, when;
} record;

static bool compute(void *context, size_t first, size_t count, const double *places,
                    double *results, clod_status *status)
{
    (void)status;
    record *self = context;
    for (size_t point = first; point < first + count; point++) {
        results[point] = places[point];
    }
    self->computed += count;
    return true;
}

static void look(void *context)
{
    record *self = context;
    self->looked++;
    self->when = self->computed;
}

static void the_first_point_is_looked_at_alone(void **state)
{
    (void)state;
    plan_made plan;
    plan_make(&plan, 1, 1);
    plan.plan.seeds = 1;
    plan.plan.points = 6;
    plan.plan.sampling.samples = 100;
    plan.targets[0].value = 0.4;
    plan.targets[0].error = 0.1;
    record of = {0};
    const clod_study_source source = {.compute = compute, .look = look, .context = &of};
    clod_study study;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_study_run(&plan.plan, &source, &study, &status));
    assert_int_equal(of.computed, 6);
    assert_int_equal(of.looked, 1);
    assert_int_equal(of.when, 1);
    clod_study_fini(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_point_is_looked_at_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
