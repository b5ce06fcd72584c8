#include "picture/picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "picture/scan.h"
#include "picture/stage.h"
#include "picture/tracer.h"
#include "picture/view.h"

struct clod_picture {
    const clod_picture_options *options;
    clod_scan scan;
    clod_camera camera;
    uint8_t *veiled; ///< [triangles] owned: in the way in any of several frames
    size_t triangles;
};

/** Bars that the page shows. */
static size_t list_bars(const clod_scan *scan, clod_page_bar bars[2])
{
    bars[0] = scan->grains.bar;
    bars[1] = scan->walls.bar;
    return scan->walls.field != NULL ? 2 : 1;
}

static bool begin_page(const clod_picture *self, clod_page *page, clod_status *status)
{
    clod_page_bar *bars = clod_memory_alloc(2, sizeof *bars);
    if (bars == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a picture.");
    }
    const size_t count = list_bars(&self->scan, bars);
    const bool good = clod_page_begin(page, self->options->width, self->options->height,
                                      (int)self->scan.film_count, bars, count, status);
    clod_memory_free(bars);
    return good;
}

static clod_vec3 middle_of(const clod_cutaway_box *box)
{
    return (clod_vec3){0.5 * (box->min[0] + box->max[0]), 0.5 * (box->min[1] + box->max[1]),
                       0.5 * (box->min[2] + box->max[2])};
}

/** Note all that a frame shows. */
static bool bound_frame(const clod_scan *scan, const clod_film_frame *frame,
                        const clod_camera *camera, clod_camera_bounds *bounds,
                        clod_status *status)
{
    clod_scene scene;
    const bool good = clod_stage_load(&scan->stage, frame, &scene, status);
    for (size_t k = 0; good && k < scene.spheres; k++) {
        clod_camera_bound(camera, bounds, clod_vec3_of(scene.center[k]), scene.radius[k]);
    }
    for (size_t k = 0; good && k < 3 * scene.triangles; k++) {
        clod_camera_bound(camera, bounds, clod_vec3_of(scene.corner[k / 3][k % 3]), 0.0);
    }
    clod_scene_fini(&scene);
    return good;
}

/** Stand where all frames are seen whole. */
static bool fit(clod_picture *self, clod_status *status)
{
    clod_camera_bounds bounds = CLOD_CAMERA_BOUNDS_NONE;
    for (size_t f = 0; f < self->scan.film_count; f++) {
        for (size_t k = 0; k < self->scan.count; k++) {
            if (!bound_frame(&self->scan, clod_scan_frame(&self->scan, f, k), &self->camera,
                             &bounds, status)) {
                return false;
            }
        }
    }
    clod_camera_fit(&self->camera, &bounds);
    return true;
}

static bool place_camera(clod_picture *self, clod_status *status)
{
    static const double ROOM = 1.04; // a margin about what is seen
    const clod_picture_options *options = self->options;
    const clod_cutaway_box *box = &self->scan.stage.clip;
    clod_page page;
    if (!begin_page(self, &page, status)) {
        clod_page_fini(&page);
        return false;
    }
    const double aspect = (double)page.panel[0].width / page.panel[0].height;
    clod_page_fini(&page);
    const clod_vec3 at =
        options->at != NULL ? clod_vec3_of(options->at) : middle_of(&self->scan.seen);
    clod_vec3 direction = clod_view_direction(options->view, box->min, box->max);
    clod_vec3 eye = at;
    if (options->from != NULL) {
        eye = clod_vec3_of(options->from);
        direction = clod_vec3_sub(at, eye);
        if (!(clod_vec3_length(direction) > 0.0)) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "--from and --at are the same point: the camera needs a "
                                    "direction.");
        }
    }
    const double angle = options->angle * M_PI / 180.0;
    self->camera = clod_camera_make(eye, direction, angle, aspect);
    if (options->from == NULL) {
        self->camera.half_height /= ROOM;
        self->camera.half_width /= ROOM;
        if (!fit(self, status)) {
            return false;
        }
        self->camera.half_height *= ROOM;
        self->camera.half_width *= ROOM;
    }
    if (options->from == NULL && options->at != NULL) { // as far away, but towards `at`
        const clod_vec3 arm = clod_vec3_sub(self->camera.eye, at);
        const double far = -clod_vec3_dot(arm, self->camera.ahead);
        self->camera.eye = clod_vec3_axpy(at, -far, self->camera.ahead);
    }
    return true;
}

/** Veil what is in the way in any frame, so that nothing flickers from one to the next. */
static bool veil_all(clod_picture *self, clod_status *status)
{
    const size_t frames = self->scan.film_count * self->scan.count;
    bool good = true;
    for (size_t k = 0; frames > 1 && k < frames && good; k++) {
        const clod_film_frame *frame =
            clod_scan_frame(&self->scan, k % self->scan.film_count, k / self->scan.film_count);
        clod_scene scene;
        clod_faces faces = {0};
        good = clod_stage_load(&self->scan.stage, frame, &scene, status) &&
               clod_faces_make(&faces, &scene, status) &&
               clod_cutaway_veil(&scene, &faces, self->camera.eye, status);
        if (good && self->veiled == NULL) {
            self->triangles = scene.triangles;
            self->veiled = scene.veiled;
            scene.veiled = NULL;
        }
        for (size_t t = 0; good && scene.veiled != NULL && t < self->triangles &&
                           self->triangles == scene.triangles;
             t++) {
            self->veiled[t] |= scene.veiled[t];
        }
        clod_faces_fini(&faces);
        clod_scene_fini(&scene);
    }
    return good;
}

clod_picture *clod_picture_open(const clod_picture_options *options, clod_status *status)
{
    clod_picture *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for a picture.");
        return NULL;
    }
    self->options = options;
    if (!clod_scan_make(&self->scan, options, status) || !place_camera(self, status) ||
        !veil_all(self, status)) {
        clod_picture_close(&self);
    }
    return self;
}

size_t clod_picture_count(const clod_picture *self)
{
    return self->scan.count;
}

double clod_picture_time(const clod_picture *self, size_t k)
{
    return clod_scan_frame(&self->scan, 0, k)->time;
}

/** Draw one run into its panel. */
static bool draw_panel(const clod_picture *self, clod_page *page, size_t f, size_t k,
                       clod_status *status)
{
    const clod_film_frame *frame = clod_scan_frame(&self->scan, f, k);
    const clod_page_box *box = &page->panel[f];
    clod_camera camera = self->camera;
    camera.half_width = camera.half_height * box->width / box->height;
    clod_scene scene;
    clod_faces faces = {0};
    uint8_t *image = clod_memory_alloc((size_t)box->width * (size_t)box->height, 3);
    bool good = clod_stage_load(&self->scan.stage, frame, &scene, status) &&
                clod_faces_make(&faces, &scene, status) &&
                clod_cutaway_veil(&scene, &faces, camera.eye, status);
    if (good && self->veiled != NULL && self->triangles == scene.triangles) {
        memcpy(scene.veiled, self->veiled, scene.triangles);
    }
    if (good && image == NULL) {
        good = clod_status_fail(status, CLOD_FAILED, "No memory for a picture.");
    }
    if (good) {
        const clod_tracer_order order = {box->width, box->height,
                                         (clod_tracer_quality)self->options->quality,
                                         self->options->threads};
        good = clod_tracer_draw(&scene, &camera, &order, image, status);
    }
    if (good) {
        char time[64];
        snprintf(time, sizeof time, "t = %.3f s", frame->time);
        clod_page_put_image(page, (int)f, image, self->scan.film[f].title, time);
        clod_page_put_scale(page, (int)f, &camera, middle_of(&self->scan.seen));
    }
    clod_memory_free(image);
    clod_faces_fini(&faces);
    clod_scene_fini(&scene);
    return good;
}

bool clod_picture_draw(const clod_picture *self, size_t k, const char *path,
                       clod_status *status)
{
    clod_page page;
    bool good = begin_page(self, &page, status);
    for (size_t f = 0; good && f < self->scan.film_count; f++) {
        good = draw_panel(self, &page, f, k, status);
    }
    clod_page_bar *bars = clod_memory_alloc(2, sizeof *bars);
    if (good && bars == NULL) {
        good = clod_status_fail(status, CLOD_FAILED, "No memory for a picture.");
    }
    if (good) {
        clod_page_put_bars(&page, bars, list_bars(&self->scan, bars));
        good = clod_page_write(&page, path, status);
    }
    clod_memory_free(bars);
    clod_page_fini(&page);
    return good;
}

void clod_picture_close(clod_picture **self)
{
    if (*self != NULL) {
        clod_scan_fini(&(*self)->scan);
        clod_memory_free((*self)->veiled);
        clod_memory_free(*self);
        *self = NULL;
    }
}
