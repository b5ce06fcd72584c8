#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "law/law.h"
#include "output/checkpoint.h"
#include "setup/domain.h"
#include "setup/planes.h"
#include "setup/state.h"
#include "setup/walls.h"
#include "sim/origin.h"
#include "step/step.h"

/** What is taken over, while it is. */
typedef struct moving {
    const clod_origin *origin;
    const clod_case *from;
    clod_state other;  ///< the state of the other run; its grains and contacts move
    clod_state *state; ///< the new one
    int *material;     ///< [other materials] index here, or -1
    int32_t *wall;     ///< [other walls] index here, or -1: gone, or of another shape
    bool same_walls;   ///< all of them, in the same order
    FILE *told;
} moving;

static bool read_other(moving *self, clod_status *status)
{
    char notice[1024] = "";
    const clod_origin *origin = self->origin;
    self->other = (clod_state){.build_motion = -1.0};
    if (!clod_checkpoint_read(origin->shelf, origin->stem, &self->other, NULL, 0, NULL, notice,
                              sizeof notice, status)) {
        return clod_origin_fail(origin, status);
    }
    fprintf(self->told, "%s%staken over from %s, step %lld, time %.9g s: %zu grains", notice,
            notice[0] != '\0' ? "\n" : "", origin->text, (long long)self->other.step,
            self->other.time, self->other.grains.count);
    return true;
}

/** Materials by name; grains whose density differs get their new mass. */
static bool map_materials(moving *self, clod_status *status)
{
    const clod_case *there = self->origin->from;
    clod_grains *grains = &self->other.grains;
    for (size_t m = 0; m < there->material_count; m++) {
        self->material[m] = clod_case_material_index(self->from, there->materials[m].name);
    }
    for (size_t g = 0; g < grains->count; g++) {
        const clod_case_material *before = &there->materials[grains->material[g]];
        const int now = self->material[grains->material[g]];
        if (now < 0) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "--from %s: its grains are of the material '%s', which this "
                "case does not have. Name it under materials",
                self->origin->folder, before->name);
        }
        const double density = self->from->materials[now].density;
        if (density != before->density) {
            grains->velocity[g][3] *= density / before->density;
            grains->angular_velocity[g][3] *= before->density / density;
        }
    }
    return true;
}

static bool same_shape(const clod_shape *a, const clod_shape *b)
{
    bool same = a->kind == b->kind && a->side == b->side &&
                clod_vec3_same(a->center, b->center) && a->inner == b->inner &&
                a->outer == b->outer;
    for (int k = 0; k < 3; k++) {
        same = same && clod_vec3_same(a->axis[k], b->axis[k]) && a->half[k] == b->half[k];
    }
    return same;
}

static bool same_wall(const clod_wall *a, const clod_wall *b)
{
    bool same = a->shape_count == b->shape_count &&
                clod_vec3_same(a->spin_axis, b->spin_axis) &&
                clod_vec3_same(a->spin_point, b->spin_point);
    for (int32_t s = 0; same && s < a->shape_count; s++) {
        same = same_shape(&a->shapes[s], &b->shapes[s]);
    }
    return same;
}

static bool same_oscillation(const clod_oscillation *a, const clod_oscillation *b)
{
    return clod_vec3_same(a->direction, b->direction) && a->amplitude == b->amplitude &&
           a->angle == b->angle && a->frequency == b->frequency && a->phase == b->phase;
}

/** Put a wall where its like was; what it does from now on is this case's. */
static void put_wall(const moving *self, const clod_wall *before, clod_wall *now)
{
    double pose[CLOD_WALL_POSE_NUMBERS];
    clod_wall_pose_get(before, pose);
    clod_wall_pose_set(now, pose);
    now->force = before->force;
    now->torque = before->torque;
    now->power = before->power;
    if (now->load != CLOD_LOAD_NONE && before->load != CLOD_LOAD_NONE) {
        now->servo_velocity = before->servo_velocity;
    }
    if (same_oscillation(&before->oscillation, &now->oscillation)) {
        now->travel = before->travel;
        now->turned = before->turned;
        now->sway_velocity = before->sway_velocity;
        now->sway_spin = before->sway_spin;
    } else if (now->oscillation.frequency > 0.0) { // without a jump
        const clod_oscillation *o = &now->oscillation;
        const double sine = sin(2.0 * M_PI * o->frequency * self->other.time + o->phase);
        now->travel = clod_vec3_axpy(before->shift, -o->amplitude * sine, o->direction);
        now->turned = before->angle - o->angle * sine;
    }
}

static bool map_walls(moving *self, clod_status *status)
{
    const clod_walls *there = &self->other.walls;
    clod_walls *here = &self->state->walls;
    if (!clod_setup_walls(self->from, here, status)) {
        return false;
    }
    self->same_walls = there->count == here->count;
    for (int32_t w = 0; w < there->count; w++) {
        const clod_wall *before = &there->wall[w];
        self->wall[w] = -1;
        const int32_t named = clod_walls_find(here, before->name);
        if (named >= 0 && same_wall(before, &here->wall[named])) {
            self->wall[w] = named;
            put_wall(self, before, &here->wall[named]);
        }
        self->same_walls = self->same_walls && self->wall[w] == w;
        if (self->wall[w] < 0) {
            fprintf(self->told, "  wall %s %s: what grains remember of it is dropped\n",
                    before->name,
                    named >= 0 ? "has other shapes or another axis here" : "is gone");
        }
    }
    for (int32_t n = 0; n < here->count; n++) {
        bool known = false;
        for (int32_t w = 0; w < there->count; w++) {
            known = known || self->wall[w] == n;
        }
        fprintf(self->told, "  wall %s %s\n", here->wall[n].name,
                known ? "is where it was" : "stands as this case has it");
    }
    return true;
}

/** Whether what a contact of two materials remembers means the same here. */
static bool keeps_history(const moving *self, int a, int b)
{
    const int now_a = self->material[a], now_b = self->material[b];
    if (now_a < 0 || now_b < 0) {
        return false;
    }
    const clod_case_contact *before = clod_case_pair(self->origin->from, a, b);
    const clod_case_contact *now = clod_case_pair(self->from, now_a, now_b);
    return before->law == now->law && before->exponent == now->exponent;
}

/** Whether two grains that did touch still do: another domain may have other images. */
static bool still_touch(const clod_state *state, const clod_contact *contact)
{
    const double *a = state->grains.position[contact->i];
    const double *b = state->grains.position[contact->j];
    double square = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        const double s = clod_domain_separation(&state->domain, axis, a[axis], b[axis]);
        square += s * s;
    }
    return square <= (a[3] + b[3]) * (a[3] + b[3]);
}

/** How many histories were kept, and not, and why not. */
typedef struct tally {
    size_t kept, walls, law, apart, outlets;
} tally;

/** Whether a contact's history comes along; its wall gets its new number. */
static bool keep_contact(const moving *self, const uint16_t *material, clod_contact *contact,
                         tally *count)
{
    const bool at_wall = contact->shape >= 0;
    const clod_wall *wall = at_wall ? &self->other.walls.wall[contact->j] : NULL;
    const int partner =
        at_wall ? clod_wall_material(wall, contact->shape) : material[contact->j];
    if (at_wall && self->wall[contact->j] < 0) {
        count->walls++;
        return false;
    }
    if (!keeps_history(self, material[contact->i], partner)) {
        count->law++;
        return false;
    }
    if (at_wall) {
        contact->j = self->wall[contact->j];
        if (self->state->walls.wall[contact->j].shapes[contact->shape].outlet > 0) {
            count->outlets++;
            return false;
        }
    } else if (!still_touch(self->state, contact)) {
        count->apart++;
        return false;
    }
    count->kept++;
    return true;
}

/** By wall as the new case numbers them; grain pairs stay in their order. */
static int by_wall(const void *one, const void *other)
{
    const clod_contact *a = one, *b = other;
    const int64_t order[3] = {(int64_t)a->i - b->i, (int64_t)a->j - b->j,
                              (int64_t)a->shape - b->shape};
    for (int k = 0; k < 3; k++) {
        if (order[k] != 0) {
            return order[k] < 0 ? -1 : 1;
        }
    }
    return 0;
}

static void move_contacts(moving *self)
{
    clod_state *state = self->state;
    const clod_state *other = &self->other;
    const size_t pairs = other->contact_count - other->wall_contact_count;
    tally count = {0};
    for (size_t c = 0; c < other->contact_count; c++) {
        clod_contact contact = other->contacts[c];
        if (keep_contact(self, other->grains.material, &contact, &count)) {
            other->contacts[state->contact_count++] = contact;
            state->wall_contact_count += c >= pairs ? 1 : 0;
        }
    }
    state->contacts = other->contacts;
    state->contact_capacity = other->contact_capacity;
    if (state->wall_contact_count > 0) {
        qsort(state->contacts + state->contact_count - state->wall_contact_count,
              state->wall_contact_count, sizeof *state->contacts, by_wall);
    }
    fprintf(self->told, "  %zu contacts with their history", count.kept);
    if (count.law > 0) {
        fprintf(self->told, "; %zu begin anew: their law or exponent is another one",
                count.law);
    }
    if (count.walls > 0) {
        fprintf(self->told, "; %zu begin anew: their wall is another one", count.walls);
    }
    if (count.outlets > 0) {
        fprintf(self->told, "; %zu are no more: their surface is an outlet here",
                count.outlets);
    }
    if (count.apart > 0) {
        fprintf(self->told, "; %zu are open: the domain is another one", count.apart);
    }
    fputc('\n', self->told);
}

/** The grains, after their contacts: those ask for the materials of before. */
static void move_grains(moving *self)
{
    clod_grains *grains = &self->state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        grains->material[g] = (uint16_t)self->material[grains->material[g]];
    }
    clod_memory_free(grains->clump); // this run looks for its own
    grains->clump = NULL;
    self->other.contacts = NULL; // they have moved
    self->other.grains = (clod_grains){0};
}

/** Every grain is in the domain; where it removes grains, one that is about to go may be beyond. */
static bool check_domain(const moving *self, clod_status *status)
{
    const clod_state *state = self->state;
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *p = state->grains.position[g];
        const double beyond = state->domain.removes ? 2.0 * p[3] : 0.0;
        for (int a = 0; a < 3; a++) {
            const double x = p[a];
            if (!(x >= state->domain.min[a] - beyond && x <= state->domain.max[a] + beyond)) {
                return clod_status_fail(status, CLOD_USAGE,
                                        "--from %s: its grain %llu at %c = %.6g m is outside "
                                        "the domain of this case (%.6g to %.6g m)",
                                        self->origin->folder,
                                        (unsigned long long)state->grains.id[g], "xyz"[a], x,
                                        state -> domain.min[a], state->domain.max[a]);
            }
        }
    }
    return true;
}

/** Belts start as if time began now, as inlets do; walls in checkpoints keep it. */
static void set_start_ups(moving *self)
{
    for (int32_t w = 0; w < self->state->walls.count; w++) {
        clod_wall *wall = &self->state->walls.wall[w];
        clod_start_up *start = &wall->start_up;
        if (start->at > 0.0 || start->duration > 0.0) {
            start->at += self->state->time;
            fprintf(self->told, "  wall %s: belts start at %.9g s\n", wall->name, start->at);
        }
    }
}

/** Time goes on, belts start from now, with the other run's step if it may, else this case's own. */
static bool set_time(moving *self, clod_status *status)
{
    clod_state *state = self->state;
    const clod_state *other = &self->other;
    clod_timestep timestep;
    if (!clod_setup_timestep(self->from, state, &timestep, status)) {
        return false;
    }
    clod_setup_damping(state, &timestep);
    const bool same = self->origin->same_law && other->dt <= timestep.step;
    state->dt = same ? other->dt : timestep.step;
    state->step = state->dt == other->dt ? other->step : llround(other->time / state->dt);
    state->time = (double)state->step * state->dt;
    for (int32_t w = 0; w < other->walls.count; w++) {
        const clod_wall *before = &other->walls.wall[w];
        clod_wall *now = self->wall[w] >= 0 ? &state->walls.wall[self->wall[w]] : NULL;
        if (self->origin->same_law && now != NULL && now->load != CLOD_LOAD_NONE &&
            before->load != CLOD_LOAD_NONE && before->mass == now->mass) {
            now->damping = before->damping; // that of the bed as it was when it began
        }
    }
    fprintf(self->told, "  time step %.4g s, %s\n", state->dt,
            state->dt == other->dt ? "as there" : "that of this case");
    set_start_ups(self);
    return clod_setup_wall_pace(&state->walls, state->dt, status);
}

/**
 * Where everything was at the last rebuild: as there, so that grains are sorted when they would
 * have been; or here and now, with a rebuild in the first step, if anything else stands around.
 */
static bool set_build(moving *self, clod_status *status)
{
    clod_state *state = self->state;
    clod_state *other = &self->other;
    const size_t walls = (size_t)state->walls.count;
    if (self->same_walls && self->origin->same_domain && other->build_motion >= 0.0) {
        state->build_position = other->build_position;
        state->build_capacity = other->build_capacity;
        state->build_walls = other->build_walls;
        state->build_motion = other->build_motion;
        state->build_skin = other->build_skin;
        other->build_position = NULL;
        other->build_walls = NULL;
        return true;
    }
    state->build_walls = clod_memory_alloc(walls + 1, sizeof *state->build_walls);
    if (!clod_state_reserve_build(state) || state->build_walls == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the grains");
    }
    memcpy(state->build_position, state->grains.position,
           state->grains.count * sizeof *state->build_position);
    for (size_t w = 0; w < walls; w++) {
        clod_wall_pose_get(&state->walls.wall[w], state->build_walls[w]);
    }
    state->build_motion = (double)INFINITY;
    return true;
}

static bool move_all(moving *self, clod_status *status)
{
    clod_state *state = self->state;
    if (!read_other(self, status)) {
        return false;
    }
    fputc('\n', self->told);
    if (!map_materials(self, status) || !map_walls(self, status)) {
        return false;
    }
    state->grains = self->other.grains;
    if (self->origin->same_domain && (self->from->has_domain || self->same_walls)) {
        state->domain = self->other.domain;
        clod_setup_planes(self->from, state);
    } else {
        clod_setup_domain(self->from, state);
    }
    move_contacts(self);
    move_grains(self);
    return check_domain(self, status) && set_time(self, status) && set_build(self, status);
}

bool clod_origin_state(const clod_origin *self, const clod_case *from, clod_state *state,
                       char **told, clod_status *status)
{
    clod_text text = {0};
    moving now = {.origin = self,
                  .from = from,
                  .state = state,
                  .material = clod_memory_alloc(self->from->material_count + 1, sizeof(int)),
                  .wall = clod_memory_alloc(self->from->wall_count + 1, sizeof(int32_t)),
                  .told = clod_text_open(&text)};
    *told = NULL;
    *state = (clod_state){.build_motion = -1.0, .adhesion = from->stages[0].adhesion};
    memcpy(state->gravity, from->gravity, sizeof state->gravity);
    bool ok = now.material != NULL && now.wall != NULL && now.told != NULL;
    ok = ok ? move_all(&now, status)
            : clod_status_fail(status, CLOD_FAILED, "no memory for the grains");
    if (now.told != NULL) {
        clod_origin_print_differences(self, now.told);
        *told = clod_text_close(&text);
        ok = ok && (*told != NULL || clod_status_fail(status, CLOD_FAILED,
                                                      "no memory to tell what is taken over"));
    }
    clod_memory_free(now.material);
    clod_memory_free(now.wall);
    clod_state_fini(&now.other);
    return ok;
}

bool clod_origin_try(const clod_origin *self, const clod_case *from,
                     const clod_run_options *options, clod_status *status)
{
    char *told;
    clod_state state;
    clod_laws laws = {0};
    clod_step step = {0};
    const clod_step_options how = {.threads = options->threads,
                                   .simd = options->simd,
                                   .overlap_limit = from->time.overlap_limit};
    bool ok = clod_origin_state(self, from, &state, &told, status) &&
              clod_laws_init(&laws, from, status);
    if (ok) {
        clod_laws_set_adhesion(&laws, state.adhesion);
        ok = clod_step_init(&step, &state, &laws, &how, status) &&
             clod_step_advance(&step, 1, status);
        ok = ok || clod_origin_fail(self, status);
    }
    clod_step_fini(&step);
    clod_laws_fini(&laws);
    clod_state_fini(&state);
    clod_memory_free(told);
    return ok;
}
