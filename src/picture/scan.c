#include "picture/scan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"

#define FLAT 1e-5  ///< planes across an axis are so exact
#define REACH 1.0  ///< a plane across an axis is looked for so far beyond the rest
#define AROUND 0.3 ///< planes reach so far beyond the rest, in its largest extent

static const clod_cutaway_box ENDLESS = {{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL},
                                         {HUGE_VAL, HUGE_VAL, HUGE_VAL}};

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for a picture.");
}

/** Frames of the first film as asked for, and those nearest to them in time of the second. */
static bool choose_frames(clod_scan *self, const clod_picture_options *options,
                          clod_status *status)
{
    const clod_film *film = &self->film[0];
    self->count = options->all ? film->count : 1;
    for (size_t f = 0; f < self->film_count; f++) {
        self->frame[f] = clod_memory_alloc(self->count, sizeof *self->frame[f]);
        if (self->frame[f] == NULL) {
            return fail_memory(status);
        }
    }
    for (size_t k = 0; k < self->count; k++) {
        self->frame[0][k] = options->all ? k : film->count - 1;
        if (!options->all && options->time != NULL &&
            !clod_film_nearest(film, *options->time, &self->frame[0][k], status)) {
            return false;
        }
    }
    for (size_t k = 0; self->film_count == 2 && k < self->count; k++) {
        const double time = film->frames[self->frame[0][k]].time;
        const clod_film *other = &self->film[1];
        size_t *nearest = &self->frame[1][k];
        for (size_t j = 1; j < other->count; j++) {
            if (fabs(other->frames[j].time - time) <
                fabs(other->frames[*nearest].time - time)) {
                *nearest = j;
            }
        }
    }
    return true;
}

const clod_film_frame *clod_scan_frame(const clod_scan *self, size_t film, size_t k)
{
    return &self->film[film].frames[self->frame[film][k]];
}

/** Where the grains are, and their values. */
static bool look_at_grains(clod_scan *self, const char *path, size_t frames,
                           clod_status *status)
{
    clod_vtkhdf *file = clod_vtkhdf_open(path, status);
    self->seen_now = CLOD_CUTAWAY_EMPTY;
    bool good = file != NULL && clod_channel_add(&self->grains, file, frames, status);
    double(*point)[3] = good ? clod_vtkhdf_points(file, status) : NULL;
    good = point != NULL;
    for (size_t k = 0; good && k < file->rows[CLOD_VTKHDF_POINTS]; k++) {
        clod_cutaway_include(&self->seen, point[k]);
        clod_cutaway_include(&self->seen_now, point[k]);
    }
    clod_memory_free(point);
    clod_vtkhdf_close(&file);
    return good;
}

/** A plane across an axis that all grains are on one side of ends the others there. */
static void bound_by_plane(clod_cutaway_box *planes, const clod_cutaway_box *grains,
                           double (*const corner)[3])
{
    for (int d = 0; d < 3; d++) {
        const double at = corner[0][d];
        const double size = fmax(fabs(at), fabs(corner[0][(d + 1) % 3])) +
                            fabs(corner[2][(d + 1) % 3] - corner[0][(d + 1) % 3]);
        if (fabs(corner[1][d] - at) > FLAT * size || fabs(corner[2][d] - at) > FLAT * size) {
            continue;
        }
        if (at >= grains->max[d]) {
            planes->max[d] = fmin(planes->max[d], at);
        } else if (at <= grains->min[d]) {
            planes->min[d] = fmax(planes->min[d], at);
        }
    }
}

/** Where the walls are, those without an end aside. */
static bool look_at_walls(clod_scan *self, const char *path, size_t frames,
                          clod_cutaway_box *box, clod_status *status)
{
    const clod_cutaway_box grains = self->seen_now;
    clod_cutaway_box planes = ENDLESS;
    clod_vtkhdf *file = clod_vtkhdf_open(path, status);
    clod_stage_walls seen = {0};
    bool good = file != NULL && (self->walls.field == NULL ||
                                 clod_channel_add(&self->walls, file, frames, status));
    good = good && clod_stage_walls_read(&seen, file, &self->hidden, status);
    for (size_t t = 0; good && t < seen.count; t++) {
        if (seen.plane[t]) {
            bound_by_plane(&planes, &grains, seen.corner[t++]); // and its other half
            continue;
        }
        for (int c = 0; c < 3 && !seen.hidden[t]; c++) {
            clod_cutaway_include(box, seen.corner[t][c]);
        }
    }
    for (int d = 0; d < 3; d++) {
        self->planes.min[d] = fmin(self->planes.min[d], planes.min[d]);
        self->planes.max[d] = fmax(self->planes.max[d], planes.max[d]);
    }
    clod_stage_walls_fini(&seen);
    clod_vtkhdf_close(&file);
    return good;
}

/** Planes end a little beyond everything else, and with the domain. */
static void choose_clip(clod_scan *self, const clod_cutaway_box *walls)
{
    clod_cutaway_box *clip = &self->stage.clip;
    *clip = self->seen;
    if (walls->max[0] >= walls->min[0]) {
        clod_cutaway_include(clip, walls->min);
        clod_cutaway_include(clip, walls->max);
    }
    if (!(self->planes.max[0] >= self->planes.min[0])) {
        self->planes = ENDLESS; // no walls
    }
    double size = 0.0;
    for (int d = 0; d < 3; d++) {
        size = fmax(size, clip->max[d] - clip->min[d]);
    }
    const clod_case *of = self->film[0].of;
    for (int d = 0; d < 3; d++) {
        const bool under = self->planes.min[d] > clip->min[d] - REACH * size;
        const bool over = self->planes.max[d] < clip->max[d] + REACH * size;
        clip->min[d] = under ? self->planes.min[d] - FLAT * size : clip->min[d] - AROUND * size;
        clip->max[d] = over ? self->planes.max[d] + FLAT * size : clip->max[d] + AROUND * size;
        if (of != NULL && of->has_domain) {
            const double slack = 1e-4 * (of->domain_max[d] - of->domain_min[d]);
            clip->min[d] = fmax(clip->min[d], of->domain_min[d] - slack);
            clip->max[d] = fmin(clip->max[d], of->domain_max[d] + slack);
        }
    }
    if (!(self->seen.max[0] >= self->seen.min[0])) {
        self->seen = *walls; // no grains
    }
}

static bool look(clod_scan *self, clod_status *status)
{
    clod_cutaway_box walls = CLOD_CUTAWAY_EMPTY;
    self->seen = CLOD_CUTAWAY_EMPTY;
    self->planes = CLOD_CUTAWAY_EMPTY;
    const size_t frames = self->film_count * self->count;
    for (size_t f = 0; f < self->film_count; f++) {
        for (size_t k = 0; k < self->count; k++) {
            const clod_film_frame *frame = clod_scan_frame(self, f, k);
            if (!look_at_grains(self, frame->grains, frames, status) ||
                (frame->walls != NULL &&
                 !look_at_walls(self, frame->walls, frames, &walls, status))) {
                return false;
            }
        }
    }
    choose_clip(self, &walls);
    return true;
}

/** Put a name into a list for a message. */
static void list_name(char *list, size_t size, const char *name, size_t length)
{
    const size_t used = strlen(list);
    snprintf(list + used, size - used, "%s%.*s", used > 0 ? ", " : "", (int)length, name);
}

/** Whether a part has a name: "WALL.PART", not "WALL.". */
static bool is_named(const char *part, size_t length)
{
    const char *point = memchr(part, '.', length);
    return point != NULL && point + 1 < part + length;
}

static bool fail_hide(const clod_film *film, const char *asked, const char *parts,
                      clod_status *status)
{
    char walls[1024] = "", named[2048] = "";
    for (size_t k = 0; clod_film_wall_name(film, k) != NULL; k++) {
        const char *name = clod_film_wall_name(film, k);
        list_name(walls, sizeof walls, name, strlen(name));
    }
    while (parts[0] != '\0') {
        const size_t length = strcspn(parts, "\n");
        if (is_named(parts, length)) {
            list_name(named, sizeof named, parts, length);
        }
        parts += length + (parts[length] == '\n');
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "--hide %s: %s has no such wall or part. Walls: %s; or their "
                            "numbers, from 0. Parts: %s.",
                            asked, film->folder, walls[0] != '\0' ? walls : "names unknown",
                            named[0] != '\0' ? named : "none in its snapshots");
}

/** The parts that walls of a frame have, into `names`; "" where there are none. */
static bool read_parts(const clod_film_frame *frame, char *names, clod_status *status)
{
    names[0] = '\0';
    if (frame->walls == NULL) {
        return true;
    }
    clod_vtkhdf *file = clod_vtkhdf_open(frame->walls, status);
    if (file != NULL) {
        clod_vtkhdf_parts(file, names);
    }
    const bool good = file != NULL;
    clod_vtkhdf_close(&file);
    return good;
}

/** Whether a part in a list, one a line, is asked for; those without names, "WALL.", are not. */
static bool has_part(const char *list, const clod_stage_part *asked)
{
    while (list[0] != '\0') {
        const size_t length = strcspn(list, "\n");
        if (is_named(list, length) && clod_stage_is_part(asked, list, length)) {
            return true;
        }
        list += length + (list[length] == '\n');
    }
    return false;
}

/** Hide what a text asks for: a wall by name or number, a part by its name in the list `parts`, or
 *  all parts of shapes of a wall that have this name. */
static bool hide_one(clod_scan *self, const char *asked, const char *parts, clod_status *status)
{
    clod_stage_hidden *hidden = &self->hidden;
    const int wall = clod_film_wall(&self->film[0], asked);
    if (wall >= 0) {
        hidden->wall[wall] = true;
        return true;
    }
    clod_stage_part part = {asked, false};
    if (!has_part(parts, &part)) {
        part.any_shape = true;
        if (!has_part(parts, &part)) {
            return fail_hide(&self->film[0], asked, parts, status);
        }
    }
    hidden->part[hidden->part_count++] = part;
    return true;
}

/** What is not to be shown: walls by name or number, parts of their meshes as WALL.PART. */
static bool hide(clod_scan *self, const clod_picture_options *options, clod_status *status)
{
    clod_stage_hidden *hidden = &self->hidden;
    char *parts = clod_memory_alloc(CLOD_VTKHDF_PARTS, 1);
    hidden->wall = clod_memory_alloc(CLOD_SCAN_WALLS, sizeof *hidden->wall);
    hidden->wall_count = hidden->wall != NULL ? CLOD_SCAN_WALLS : 0;
    hidden->part = clod_memory_alloc(options->hidden_count + 1, sizeof *hidden->part);
    bool good = parts != NULL && hidden->wall != NULL && hidden->part != NULL;
    if (!good) {
        fail_memory(status);
    }
    good = good && (options->hidden_count == 0 ||
                    read_parts(clod_scan_frame(self, 0, 0), parts, status));
    for (size_t h = 0; good && h < options->hidden_count; h++) {
        good = hide_one(self, options->hidden[h], parts, status);
    }
    clod_memory_free(parts);
    return good;
}

bool clod_scan_make(clod_scan *self, const clod_picture_options *options, clod_status *status)
{
    *self = (clod_scan){.grains = {.field = options->field, .place = CLOD_VTKHDF_POINTS},
                        .walls = {.field = options->wall_field, .place = CLOD_VTKHDF_CELLS}};
    const char *const folders[2] = {options->run, options->beside};
    for (size_t f = 0; f < 2 && folders[f] != NULL; f++) {
        self->film_count++;
        if (!clod_film_open(&self->film[f], folders[f], options->part, status)) {
            return false;
        }
    }
    self->stage = (clod_stage){&self->grains, &self->walls, &self->hidden, CLOD_CUTAWAY_EMPTY};
    const bool good =
        choose_frames(self, options, status) && hide(self, options, status) &&
        look(self, status) &&
        clod_channel_settle(&self->grains, options->range, options->map, &self->film[0],
                            status) &&
        clod_channel_settle(&self->walls, options->wall_range, NULL, &self->film[0], status);
    return good;
}

void clod_scan_fini(clod_scan *self)
{
    for (size_t f = 0; f < self->film_count; f++) {
        clod_memory_free(self->frame[f]);
        clod_film_fini(&self->film[f]);
    }
    clod_channel_fini(&self->grains);
    clod_channel_fini(&self->walls);
    clod_memory_free(self->hidden.wall);
    clod_memory_free(self->hidden.part);
    *self = (clod_scan){0};
}
