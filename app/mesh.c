/**
 * @file mesh.c
 * clod mesh FILE: what a triangle mesh is, what is wrong with it, and what clod does about it.
 */

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app.h"
#include "arguments.h"
#include "clod/mesh.h"
#include "output.h"
#include "picture/picture.h"
#include "picture_arguments.h"

enum { KEY_JSON = 256, KEY_UNIT, KEY_RADIUS, KEY_PICTURE, KEY_SIZE, KEY_VIEW, KEY_HIDE };

#define HIDDEN 64 ///< parts at most

typedef struct request {
    const char *path, *unit, *radius, *picture;
    clod_picture_mesh drawn;
    const char *hidden[HIDDEN];
    char *(*write)(const clod_mesh *mesh, const clod_mesh_report *report);
} request;

static const struct argp_option OPTIONS[] = {
    {"unit", KEY_UNIT, "UNIT", 0,
     "unit of the numbers in the file: m, mm, cm, in, ft ...; required, since no mesh file says",
     0},
    {"grain-radius", KEY_RADIUS, "LENGTH", 0,
     "radius of the grains that will touch the mesh, e.g. 3mm: compares facets and size", 0},
    {"picture", KEY_PICTURE, "FILE", 0,
     "draw the mesh as PNG, each facet in the colour of what is done about it", 0},
    {"view", KEY_VIEW, "NAME", 0, "of the picture: oblique (default), front, side or top", 0},
    {"size", KEY_SIZE, "WIDTHxHEIGHT", 0, "of the picture, in pixels (1600x1000)", 0},
    {"hide", KEY_HIDE, "PART", 0, "of the picture: leave out a part; may be repeated", 0},
    {"json", KEY_JSON, NULL, 0, "print everything as JSON", 0},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case KEY_JSON:
        self->write = clod_mesh_json;
        return 0;
    case KEY_UNIT:
        self->unit = argument;
        return 0;
    case KEY_RADIUS:
        self->radius = argument;
        return 0;
    case KEY_PICTURE:
        clod_app_picture_png(state, "--picture", argument);
        self->picture = argument;
        return 0;
    case KEY_SIZE:
        clod_app_picture_size(state, argument, &self->drawn.width, &self->drawn.height);
        return 0;
    case KEY_VIEW:
        clod_app_picture_view(state, argument, &self->drawn.view);
        return 0;
    case KEY_HIDE:
        if (self->drawn.hidden_count == HIDDEN) {
            argp_error(state, "--hide %s: at most %d parts", argument, HIDDEN);
        }
        self->hidden[self->drawn.hidden_count++] = argument;
        return 0;
    case ARGP_KEY_ARG:
        if (self->path != NULL) {
            argp_error(state, "one mesh at a time");
        }
        self->path = argument;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "which mesh file?");
        return 0;
    case ARGP_KEY_END:
        if (self->unit == NULL) {
            argp_error(state, "which unit do the numbers have? No mesh file says: --unit mm, "
                              "--unit m, --unit in ...");
        }
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static bool put(const request *self, const clod_mesh *mesh, double radius, clod_status *status)
{
    clod_mesh_report report;
    if (!clod_mesh_examine(mesh, radius, &report, status)) {
        return false;
    }
    char *text = self->write(mesh, &report);
    if (text == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the report.");
    }
    clod_output_put(text);
    clod_output_put(self->write == clod_mesh_json ? "\n" : "");
    clod_mesh_free(text);
    return true;
}

/** A length that an option gives; errors name the option. */
static bool read_length(const char *option, const char *text, double *metres,
                        clod_status *status)
{
    clod_status found = {CLOD_OK, ""};
    return clod_mesh_unit(text, metres, &found) ||
           clod_status_fail(status, found.code, "%s %s", option, found.text);
}

static bool run(const request *self, clod_status *status)
{
    clod_mesh_placing placing = {.scale = 1.0};
    double radius = 0.0;
    if (!read_length("--unit", self->unit, &placing.unit, status) ||
        (self->radius != NULL &&
         !read_length("--grain-radius", self->radius, &radius, status))) {
        return false;
    }
    clod_mesh *mesh = clod_mesh_read(self->path, &placing, status);
    clod_picture_mesh drawn = self->drawn;
    const char *slash = strrchr(self->path, '/');
    drawn.hidden = self->hidden;
    drawn.title = slash != NULL ? slash + 1 : self->path;
    const bool done = mesh != NULL &&
                      (self->picture == NULL ||
                       clod_picture_draw_mesh(mesh, &drawn, self->picture, status)) &&
                      put(self, mesh, radius, status);
    clod_mesh_destroy(&mesh);
    return done;
}

int clod_app_mesh(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "FILE",
        .doc =
            "Check a triangle mesh: FILE is .stl (text or binary), .obj or .ply. Prints box, "
            "area, volume, parts and edges; what is wrong with the mesh, the facets "
            "concerned, and what clod does about it; whether unit and facets fit the "
            "grains.\vdocs/meshes.md explains each finding.",
    };
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    request self = {.write = clod_mesh_text,
                    .drawn = {.width = CLOD_APP_PICTURE_WIDTH,
                              .height = CLOD_APP_PICTURE_HEIGHT,
                              .quality = CLOD_PICTURE_NORMAL,
                              .threads = cores > 0 ? (int)cores : 1}};
    if (!clod_arguments_parse(&argp, argc, argv, 0, &self)) {
        return CLOD_FAILED;
    }
    clod_status status = {CLOD_OK, ""};
    if (!run(&self, &status)) {
        fprintf(stderr, "clod mesh: %s\n", status.text);
        return (int)status.code;
    }
    return EXIT_SUCCESS;
}
