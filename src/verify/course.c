#include "verify/course.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "setup/bound.h"
#include "setup/state.h"
#include "step/step.h"
#include "verify/case_file.h"

#define RADIUS CLOD_VERIFY_COURSE_RADIUS
#define GRAVITY CLOD_VERIFY_COURSE_GRAVITY
#define DENSITY 2500.0
#define STIFFNESS 1e5 ///< N/m: the grain sinks in by 1e-5 of its radius or so
#define LOOK 10       ///< steps of 1e-5 s from look to look

double clod_verify_course_mass(void)
{
    return DENSITY * 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS;
}

double clod_verify_course_overlap(double force)
{
    return force / STIFFNESS;
}

static bool advance(clod_step *step, const clod_verify_course *self,
                    clod_verify_course_look look, void *context, clod_status *status)
{
    clod_state *state = step->state;
    clod_new_grain grain = {
        .id = 1,
        .position = {self->place[0], self->place[1], self->place[2], RADIUS},
        .angular_velocity = {0.0, self->spin, 0.0},
        .density = DENSITY};
    memcpy(grain.velocity, self->velocity, sizeof self->velocity);
    clod_changes_add_grain(&state->changes, &grain);
    if (!clod_step_change(step, status)) {
        return false;
    }
    bool wanted = true;
    while (wanted && state->time < self->duration) {
        if (!clod_step_advance(step, LOOK, status)) {
            return false;
        }
        const clod_verify_sight now = {state->time, clod_vec3_of(state->grains.position[0]),
                                       clod_vec3_of(state->grains.velocity[0]),
                                       state->grains.angular_velocity[0][1]};
        wanted = look(context, &now);
    }
    return true;
}

bool clod_verify_course_run(const clod_verify_bench *bench, const clod_verify_course *self,
                            clod_verify_course_look look, void *context, clod_status *status)
{
    char text[2048], path[4096];
    snprintf(text, sizeof text,
             "# Written by clod verify, which puts one grain of 5 mm at (%.9g, %.9g, %.9g) m\n"
             "# with the velocity (%.9g, %.9g, %.9g) m/s.\n"
             "title: \"%s\"\n"
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {law: %s, restitution: 1, friction: %.17g,\n"
             "  %s}}\n"
             "gravity: [%.17g m/s2, 0 m/s2, %.17g m/s2]\n"
             "domain: {min: [-20 m, -20 m, -20 m], max: [20 m, 20 m, 20 m]}\n"
             "time: {step: 1e-5 s, design_stress: 1 kPa}\n"
             "walls: {wall: {material: ore, shapes: [%s]}}\n"
             "stages: [{name: run, duration: %.17g s}]\n",
             self->place[0], self->place[1], self->place[2], self->velocity[0],
             self->velocity[1], self->velocity[2], self->name,
             self->law != NULL ? self->law : "hooke, k1: 1e5 N/m", self->friction,
             self->rolling, GRAVITY * sin(self->tilt), -GRAVITY * cos(self->tilt), self->shape,
             self->duration);
    if (!clod_verify_case_file(bench->directory, self->name, text, path, status)) {
        return false;
    }
    clod_case *from = clod_case_load(path, NULL, 0, status);
    clod_state state = {0};
    clod_laws laws = {0};
    clod_step step = {0};
    const clod_step_options options = {
        .threads = 1, .accepts = clod_setup_bound_accepts, .context = from};
    const bool good = from != NULL && clod_setup_state(from, 1, &state, status) &&
                      clod_laws_init(&laws, from, status) &&
                      clod_step_init(&step, &state, &laws, &options, status) &&
                      advance(&step, self, look, context, status);
    clod_step_fini(&step);
    clod_laws_fini(&laws);
    clod_state_fini(&state);
    clod_case_destroy(&from);
    return good;
}
