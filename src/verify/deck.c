#include "verify/deck.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/assert.h"

clod_verify_frame clod_verify_frame_plain(void)
{
    return (clod_verify_frame){"plain", {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
}

clod_verify_frame clod_verify_frame_swapped(void)
{
    return (clod_verify_frame){"swapped", {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};
}

clod_verify_frame clod_verify_frame_turned(void)
{
    const clod_verify_frame plain = clod_verify_frame_plain();
    const clod_vec3 axis = clod_vec3_unit((clod_vec3){1.0, 2.0, 3.0});
    return (clod_verify_frame){"turned", clod_vec3_rotate(plain.t, axis, 1.0),
                               clod_vec3_rotate(plain.b, axis, 1.0),
                               clod_vec3_rotate(plain.n, axis, 1.0)};
}

clod_vec3 clod_verify_frame_out(const clod_verify_frame *self, clod_vec3 local)
{
    const clod_vec3 flat = clod_vec3_axpy(clod_vec3_scale(self->t, local.x), local.y, self->b);
    return clod_vec3_axpy(flat, local.z, self->n);
}

clod_vec3 clod_verify_frame_in(const clod_verify_frame *self, clod_vec3 space)
{
    return (clod_vec3){clod_vec3_dot(space, self->t), clod_vec3_dot(space, self->b),
                       clod_vec3_dot(space, self->n)};
}

void clod_verify_deck_material(clod_verify_deck *self, const char *name, double density,
                               double youngs_modulus, double poissons_ratio)
{
    CLOD_ASSERT(self->material_count < CLOD_VERIFY_MATERIALS);
    clod_verify_material *added = &self->materials[self->material_count++];
    *added = (clod_verify_material){
        .density = density, .youngs_modulus = youngs_modulus, .poissons_ratio = poissons_ratio};
    snprintf(added->name, sizeof added->name, "%s", name);
}

void clod_verify_deck_contact(clod_verify_deck *self, const char *pair, const char *format, ...)
{
    size_t used = strlen(self->contacts);
    used +=
        (size_t)snprintf(self->contacts + used, sizeof self->contacts - used, "  %s: {", pair);
    CLOD_ASSERT(used < sizeof self->contacts);
    va_list arguments;
    va_start(arguments, format);
    used += (size_t)vsnprintf(self->contacts + used, sizeof self->contacts - used, format,
                              arguments);
    va_end(arguments);
    CLOD_ASSERT(used + 3 < sizeof self->contacts);
    memcpy(self->contacts + used, "}\n", 3);
}

clod_verify_grain *clod_verify_deck_grain(clod_verify_deck *self, const char *material,
                                          double radius, clod_vec3 place)
{
    CLOD_ASSERT(self->grain_count < CLOD_VERIFY_GRAINS);
    clod_verify_grain *added = &self->grains[self->grain_count++];
    *added = (clod_verify_grain){.radius = radius, .place = place};
    snprintf(added->material, sizeof added->material, "%s", material);
    return added;
}

void clod_verify_deck_wall(clod_verify_deck *self, const char *name, const char *material,
                           double height, double side)
{
    CLOD_ASSERT(self->wall_count < CLOD_VERIFY_WALLS);
    clod_verify_wall *added = &self->walls[self->wall_count++];
    *added = (clod_verify_wall){.height = height, .side = side};
    snprintf(added->name, sizeof added->name, "%s", name);
    snprintf(added->material, sizeof added->material, "%s", material);
}

void clod_verify_deck_stage(clod_verify_deck *self, clod_verify_stage stage)
{
    CLOD_ASSERT(self->stage_count < CLOD_VERIFY_STAGES);
    self->stages[self->stage_count++] = stage;
}

double clod_verify_deck_reach(const clod_verify_deck *self)
{
    double time = 0.0;
    for (int s = 0; s < self->stage_count; s++) {
        time += self->stages[s].duration;
    }
    const double fall = 0.5 * clod_vec3_length(self->gravity) * time * time;
    double reach = 0.0;
    for (int g = 0; g < self->grain_count; g++) {
        const clod_verify_grain *grain = &self->grains[g];
        const double speed =
            clod_vec3_length(grain->velocity) + grain->radius * clod_vec3_length(grain->spin);
        reach =
            fmax(reach, clod_vec3_length(grain->place) + time * speed + fall + grain->radius);
    }
    return reach;
}

/** [x unit, y unit, z unit] */
static void put_vector(FILE *out, clod_vec3 v, const char *unit)
{
    fprintf(out, "[%.17g%s, %.17g%s, %.17g%s]", v.x, unit, v.y, unit, v.z, unit);
}

static void put_materials(const clod_verify_deck *self, FILE *out)
{
    fprintf(out, "materials:\n");
    for (int m = 0; m < self->material_count; m++) {
        const clod_verify_material *material = &self->materials[m];
        fprintf(out, "  %s: {density: %.17g kg/m3", material->name, material->density);
        if (material->youngs_modulus > 0.0) {
            fprintf(out, ", youngs_modulus: %.17g Pa, poissons_ratio: %.17g",
                    material->youngs_modulus, material->poissons_ratio);
        }
        fprintf(out, "}\n");
    }
    fprintf(out, "contacts:\n%s", self->contacts);
}

static void put_walls(const clod_verify_deck *self, const clod_verify_frame *frame, FILE *out)
{
    fprintf(out, "%s", self->wall_count > 0 ? "walls:\n" : "");
    for (int w = 0; w < self->wall_count; w++) {
        const clod_verify_wall *wall = &self->walls[w];
        fprintf(out, "  %s: {material: %s, shapes: [{plane: {point: ", wall->name,
                wall->material);
        put_vector(out, clod_vec3_scale(frame->n, wall->height), " m");
        fprintf(out, ", normal: ");
        put_vector(out, clod_vec3_scale(frame->n, wall->side), "");
        fprintf(out, "}}]}\n");
    }
}

static void put_stages(const clod_verify_deck *self, const clod_verify_frame *frame, FILE *out)
{
    double time = 0.0;
    fprintf(out, "stages:\n");
    for (int s = 0; s < self->stage_count; s++) {
        const clod_verify_stage *stage = &self->stages[s];
        time += stage->duration;
        fprintf(out, "  - {name: s%d, duration: %.17g s", s + 1, stage->duration);
        for (int w = 0; w < self->wall_count; w++) {
            fprintf(out, "%s%s: {velocity: ", w == 0 ? ", walls: {" : ", ",
                    self->walls[w].name);
            put_vector(out, clod_vec3_scale(frame->n, stage->velocity[w]), " m/s");
            fprintf(out, "}");
        }
        fprintf(out, "%s}\n", self->wall_count > 0 ? "}" : "");
    }
    // the automatic step is unknown here; a hundredth of a run is longer
    const double interval = self->step > 0.0 ? fmax(time / 1000.0, self->step) : time / 100.0;
    fprintf(out, "output: {series_interval: %.17g s%s}\n", interval,
            self->ledger ? ", energy: true" : "");
}

static void put_case(const clod_verify_deck *self, const clod_verify_frame *frame, FILE *out)
{
    const double edge = 1.1 * clod_verify_deck_reach(self);
    fprintf(
        out,
        "# Written by clod verify. n, the normal of the contacts, is (%g, %g, %g) in space;\n"
        "# t, the direction of slip, is (%g, %g, %g).\n",
        frame->n.x, frame->n.y, frame->n.z, frame->t.x, frame->t.y, frame->t.z);
    fprintf(out, "title: \"%s\"\ntime: {step: ", self->title);
    if (self->step > 0.0) {
        fprintf(out, "%.17g s}\ngravity: ", self->step);
    } else {
        fprintf(out, "auto}\ngravity: ");
    }
    put_vector(out, clod_verify_frame_out(frame, self->gravity), " m/s2");
    fprintf(out, "\n");
    put_materials(self, out);
    fprintf(out, "domain: {min: ");
    put_vector(out, (clod_vec3){-edge, -edge, -edge}, " m");
    fprintf(out, ", max: ");
    put_vector(out, (clod_vec3){edge, edge, edge}, " m");
    fprintf(out, "}\ngrains:\n  - {file: grains.csv}\n");
    put_walls(self, frame, out);
    put_stages(self, frame, out);
}

static void put_grains(const clod_verify_deck *self, const clod_verify_frame *frame, FILE *out)
{
    fprintf(out, "id,material,radius [m],x [m],y [m],z [m],vx [m/s],vy [m/s],vz [m/s],"
                 "wx [rad/s],wy [rad/s],wz [rad/s]\n");
    for (int g = 0; g < self->grain_count; g++) {
        const clod_verify_grain *grain = &self->grains[g];
        const clod_vec3 p = clod_verify_frame_out(frame, grain->place);
        const clod_vec3 v = clod_verify_frame_out(frame, grain->velocity);
        const clod_vec3 w = clod_verify_frame_out(frame, grain->spin);
        fprintf(out, "%d,%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", g,
                grain->material, grain->radius, p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z);
    }
}

static bool make_folder(const char *path, clod_status *status)
{
    return mkdir(path, 0777) == 0 || errno == EEXIST ||
           clod_status_fail(status, CLOD_FAILED, "%s: cannot be made: %s", path,
                            strerror(errno));
}

static bool put_file(const clod_verify_deck *self, const clod_verify_frame *frame,
                     const char *path,
                     void (*put)(const clod_verify_deck *, const clod_verify_frame *, FILE *),
                     clod_status *status)
{
    FILE *out = fopen(path, "w");
    bool written = out != NULL;
    if (written) {
        put(self, frame, out);
        written = ferror(out) == 0;
        written = fclose(out) == 0 && written;
    }
    return written || clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s", path,
                                       strerror(errno));
}

bool clod_verify_deck_write(const clod_verify_deck *self, const clod_verify_frame *frame,
                            const char *directory, char path[4096], clod_status *status)
{
    const bool plain = strcmp(frame->name, "plain") == 0;
    char folder[3072];
    snprintf(folder, sizeof folder, "%s/cases", directory);
    if (!make_folder(folder, status)) {
        return false;
    }
    snprintf(folder, sizeof folder, "%s/cases/%s%s%s", directory, self->name, plain ? "" : "-",
             plain ? "" : frame->name);
    if (!make_folder(folder, status)) {
        return false;
    }
    snprintf(path, 4096, "%s/grains.csv", folder);
    if (!put_file(self, frame, path, put_grains, status)) {
        return false;
    }
    snprintf(path, 4096, "%s/case.yaml", folder);
    return put_file(self, frame, path, put_case, status);
}
