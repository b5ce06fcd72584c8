/**
 * @file picture.c
 * clod picture RUN: snapshots of a run as PNG, or as a movie.
 */

#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app.h"
#include "arguments.h"
#include "picture/picture.h"
#include "picture_arguments.h"
#include "picture_frames.h"

enum {
    KEY_ALL = 256,
    KEY_ANGLE,
    KEY_AT,
    KEY_BESIDE,
    KEY_FROM,
    KEY_HIDE,
    KEY_MAP,
    KEY_MOVIE,
    KEY_PART,
    KEY_QUALITY,
    KEY_RANGE,
    KEY_SIZE,
    KEY_VIEW,
    KEY_WALL_COLOR,
    KEY_WALL_RANGE,
};

#define MOST_JOBS CLOD_APP_FRAMES_JOBS

typedef struct request {
    clod_picture_options options;
    double time, range[2], wall_range[2], from[3], at[3];
    bool coloured, viewed; ///< --color, --view were given
    const char **hidden;
    const char *output, *movie;
    int jobs; ///< processors; 0: all
} request;

static const struct argp_option OPTIONS[] = {
    {"time", 't', "SECONDS", 0, "the snapshot nearest to this time (the last one)", 0},
    {"all", KEY_ALL, NULL, 0, "every snapshot, as frame_000000.png ... in a folder", 0},
    {"movie", KEY_MOVIE, "FILE", 0, "every snapshot, and a movie of them (.mp4) with ffmpeg",
     0},
    {"color", 'c', "FIELD", 0,
     "what colours the grains (speed); an unknown name lists those that there are", 0},
    {"wall-color", KEY_WALL_COLOR, "FIELD", 0, "what colours the walls (steel and belts)", 0},
    {"range", KEY_RANGE, "FROM,TO", 0, "values at the ends of the grains' colour bar", 0},
    {"wall-range", KEY_WALL_RANGE, "FROM,TO", 0, "values at the ends of the walls' colour bar",
     0},
    {"map", KEY_MAP, "NAME", 0, "colour map of the grains: sea, ember, balance or grey", 0},
    {"view", KEY_VIEW, "NAME", 0, "oblique (default), front, side or top", 0},
    {"from", KEY_FROM, "X,Y,Z", 0, "where the camera stands [m]", 0},
    {"at", KEY_AT, "X,Y,Z", 0, "the point that it looks at [m]", 0},
    {"angle", KEY_ANGLE, "DEGREES", 0, "angle of view from bottom to top (25)", 0},
    {"hide", KEY_HIDE, "WALL[.PART]", 0,
     "leave out a wall, by name or number, or a part of its mesh; may be repeated", 0},
    {"beside", KEY_BESIDE, "RUN", 0,
     "a second run at the right, with the same camera and colours", 0},
    {"part", KEY_PART, "NAME", 0, "part of a test: preshear, point-1, stress-1 ...", 0},
    {"size", KEY_SIZE, "WIDTHxHEIGHT", 0, "pixels (1600x1000)", 0},
    {"quality", KEY_QUALITY, "NAME", 0,
     "draft, normal (default), or high: light from the whole sky, twelve times as slow", 0},
    {"output", 'o', "FILE", 0, "PNG file (RUN.png), or folder of frames (RUN-frames)", 0},
    {"jobs", 'j', "N", 0, "processors that draw at the same time (all)", 0},
    {0},
};

/** Read numbers with commas between them; false: not so many, or not finite. */
static bool read_numbers(const char *text, double *number, int count)
{
    for (int k = 0; k < count; k++) {
        char *end;
        number[k] = strtod(text, &end);
        if (end == text || !isfinite(number[k]) || *end != (k + 1 < count ? ',' : '\0')) {
            return false;
        }
        text = end + 1;
    }
    return true;
}

static void read_point(struct argp_state *state, const char *option, const char *text,
                       double point[3], const double **to)
{
    if (!read_numbers(text, point, 3)) {
        argp_error(state,
                   "--%s %s: three numbers in metres with commas are needed, as in "
                   "--%s=1.5,-2,0.8",
                   option, text, option);
    }
    *to = point;
}

static void read_jobs(struct argp_state *state, const char *text, int *to)
{
    const char *rest = text;
    *to = clod_app_picture_whole(&rest, '\0', MOST_JOBS);
    if (*to < 0) {
        argp_error(state, "--jobs %s: 1 to %d processes", text, MOST_JOBS);
    }
}

static void read_quality(struct argp_state *state, const char *text, clod_picture_options *to)
{
    static const char *const QUALITIES[] = {"draft", "normal", "high"};
    to->quality = clod_app_picture_name(text, QUALITIES, 3);
    if (to->quality < 0) {
        argp_error(state, "--quality %s: draft, normal or high is needed", text);
    }
}

static void read_range(struct argp_state *state, const char *option, const char *text,
                       double range[2], const double **to)
{
    if (!read_numbers(text, range, 2) || range[0] >= range[1]) {
        argp_error(state, "--%s %s: two numbers that rise are needed, as in 0,2.5", option,
                   text);
    }
    *to = range;
}

/** Options of the camera and the page; false: it is none of them. */
static bool parse_view(request *self, int key, char *argument, struct argp_state *state)
{
    clod_picture_options *to = &self->options;
    switch (key) {
    case KEY_VIEW:
        clod_app_picture_view(state, argument, &to->view);
        self->viewed = true;
        return true;
    case KEY_FROM:
        read_point(state, "from", argument, self->from, &to->from);
        return true;
    case KEY_AT:
        read_point(state, "at", argument, self->at, &to->at);
        return true;
    case KEY_ANGLE:
        if (!read_numbers(argument, &to->angle, 1) || to->angle < 1.0 || to->angle > 120.0) {
            argp_error(state, "--angle %s: 1 to 120 degrees are needed", argument);
        }
        return true;
    case KEY_SIZE:
        clod_app_picture_size(state, argument, &to->width, &to->height);
        return true;
    case KEY_QUALITY:
        read_quality(state, argument, to);
        return true;
    case KEY_HIDE:
        self->hidden[to->hidden_count++] = argument;
        return true;
    default:
        return false;
    }
}

/** Options of what is shown. */
static bool parse_what(request *self, int key, char *argument, struct argp_state *state)
{
    clod_picture_options *to = &self->options;
    switch (key) {
    case 't':
        if (!read_numbers(argument, &self->time, 1)) {
            argp_error(state, "--time %s: a number of seconds is needed", argument);
        }
        to->time = &self->time;
        return true;
    case KEY_RANGE:
        read_range(state, "range", argument, self->range, &to->range);
        return true;
    case KEY_WALL_RANGE:
        read_range(state, "wall-range", argument, self->wall_range, &to->wall_range);
        return true;
    case 'c':
        to->field = argument;
        self->coloured = true;
        return true;
    case KEY_WALL_COLOR:
        to->wall_field = argument;
        return true;
    case KEY_MAP:
        to->map = argument;
        return true;
    case KEY_PART:
        to->part = argument;
        return true;
    case KEY_BESIDE:
        to->beside = argument;
        return true;
    default:
        return false;
    }
}

/** What goes together, once all options are known. */
static void check(const request *self, struct argp_state *state)
{
    const clod_picture_options *of = &self->options;
    if (of->all && of->time != NULL) {
        argp_error(state, "--time picks one snapshot, --all and --movie take every one");
    }
    if (self->viewed && of->from != NULL) {
        argp_error(state, "--view and --from both place the camera: leave one out");
    }
    if (of->wall_range != NULL && of->wall_field == NULL) {
        argp_error(state,
                   "--wall-range is for the colours of walls: say which, with --wall-color");
    }
    if (of->range != NULL && of->wall_field != NULL && of->wall_range == NULL &&
        !self->coloured) {
        fprintf(stderr,
                "%s: --range is for the grains' bar (%s); --wall-range sets that of the walls "
                "(%s)\n",
                state->name, of->field, of->wall_field);
    }
    if (self->output != NULL && !of->all) { // else a folder
        clod_app_picture_png(state, "--output", self->output);
    }
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    if (parse_view(self, key, argument, state) || parse_what(self, key, argument, state)) {
        return 0;
    }
    switch (key) {
    case KEY_ALL:
        self->options.all = true;
        return 0;
    case KEY_MOVIE:
        self->options.all = true;
        self->movie = argument;
        return 0;
    case 'o':
        self->output = argument;
        return 0;
    case 'j':
        read_jobs(state, argument, &self->jobs);
        return 0;
    case ARGP_KEY_ARG:
        if (self->options.run != NULL) {
            argp_error(state, "one run at a time; --beside shows a second one");
        }
        self->options.run = argument;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "which run? Name its results folder, e.g. run/first");
        return 0;
    case ARGP_KEY_END:
        check(self, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int clod_app_picture(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "RUN",
        .doc = "Draw snapshots of the run in the results folder RUN as PNG: grains as spheres, "
               "coloured by any of their fields, walls and belts.\v"
               "docs/howto/pictures.md has examples. Lengths are metres, times seconds.",
    };
    request self = {.options = {.field = "speed",
                                .angle = 25.0,
                                .width = CLOD_APP_PICTURE_WIDTH,
                                .height = CLOD_APP_PICTURE_HEIGHT,
                                .quality = CLOD_PICTURE_NORMAL},
                    .hidden = calloc((size_t)argc, sizeof(char *))};
    if (self.hidden == NULL) {
        fputs("clod picture: no memory\n", stderr);
        return CLOD_FAILED;
    }
    self.options.hidden = self.hidden;
    clod_status status = {CLOD_OK, ""};
    int result = CLOD_FAILED;
    if (clod_arguments_parse(&argp, argc, argv, 0, &self)) {
        const long cores = sysconf(_SC_NPROCESSORS_ONLN);
        if (self.jobs == 0) {
            self.jobs = cores < 1 ? 1 : cores > MOST_JOBS ? MOST_JOBS : (int)cores;
        }
        self.options.threads = self.options.all ? 1 : self.jobs;
        const clod_app_frames_job job = {&self.options, self.output, self.movie, self.jobs};
        const bool done = clod_app_frames(&job, &status);
        result = done ? EXIT_SUCCESS : (int)status.code;
        if (!done) {
            fprintf(stderr, "clod picture: %s\n", status.text);
        }
    }
    free(self.hidden);
    return result;
}
