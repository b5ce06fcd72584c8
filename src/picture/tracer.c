#include "picture/tracer.h"

#include <tachyon.h>

#include "base/memory.h"

#define LINE_WIDTH 0.0014 ///< of an edge, over the height of the picture
#define MARK_WIDTH 0.0050 ///< of a marked edge
#define VEIL_OPACITY 0.15 ///< opacity of a wall that is in the way
#define BELT_OPACITY 0.55 ///< the same of one whose surface moves, which stays dark
#define AMBIENT 0.45      ///< light from everywhere
#define LARGE 1.6e7       ///< pixels; from there on fewer rays for each
#define SKY_RAYS 12       ///< of the light from the sky, for each point

static void be_silent(int level, char *text)
{
    (void)level;
    (void)text;
}

static apivector vector_of(const double v[3])
{
    return rt_vector(v[0], v[1], v[2]);
}

static apivector vector(clod_vec3 v)
{
    return rt_vector(v.x, v.y, v.z);
}

/** Kinds of surfaces: lines cast no shadows, nor do veils, through which most light goes. */
enum { SOLID, VEIL, BELT_VEIL, THIN };

/** How a surface takes light. */
static void *make_texture(SceneHandle scene, const double colour[3], double ambient, int kind)
{
    apitexture texture = {.texturefunc = RT_TEXTURE_CONSTANT,
                          .col = rt_color(colour[0], colour[1], colour[2]),
                          .shadowcast = kind == SOLID,
                          .ambient = ambient,
                          .diffuse = 1.0 - ambient,
                          .opacity = kind == VEIL        ? VEIL_OPACITY
                                     : kind == BELT_VEIL ? BELT_OPACITY
                                                         : 1.0};
    return rt_texture(scene, &texture);
}

/** A light far away that shines along a direction of the camera's axes. */
static void add_light(SceneHandle scene, const clod_camera *camera, const double along[3],
                      double strength)
{
    const double white[3] = {strength, strength, strength};
    clod_vec3 direction = clod_vec3_scale(camera->right, along[0]);
    direction = clod_vec3_axpy(direction, along[1], camera->up);
    direction = clod_vec3_axpy(direction, along[2], camera->ahead);
    rt_directional_light(scene, make_texture(scene, white, 0.0, SOLID), vector(direction));
}

static void add_spheres(SceneHandle scene, const clod_scene *from, void *const *textures)
{
    for (size_t k = 0; k < from->spheres; k++) {
        rt_sphere(scene, textures[from->shade[k]], vector_of(from->center[k]), from->radius[k]);
    }
}

static void add_triangles(SceneHandle scene, const clod_scene *from, void *const *textures,
                          void *const *veils)
{
    for (size_t t = 0; t < from->triangles; t++) {
        double(*const c)[3] = from->corner[t];
        double(*const n)[3] = from->normal[t];
        rt_stri(scene, (from->veiled[t] ? veils : textures)[from->paint[t]], vector_of(c[0]),
                vector_of(c[1]), vector_of(c[2]), vector_of(n[0]), vector_of(n[1]),
                vector_of(n[2]));
    }
}

/** A line as a thin rod, equally wide in the picture wherever it is. */
static void add_line(SceneHandle scene, double (*const end)[3], const clod_camera *camera,
                     double width, void *texture)
{
    const clod_vec3 a = clod_vec3_of(end[0]);
    const clod_vec3 b = clod_vec3_of(end[1]);
    const clod_vec3 middle = clod_vec3_scale(clod_vec3_add(a, b), 0.5);
    const double depth = clod_vec3_dot(clod_vec3_sub(middle, camera->eye), camera->ahead);
    if (depth > 0.0) {
        rt_fcylinder(scene, texture, vector(a), vector(clod_vec3_sub(b, a)),
                     width * depth * camera->half_height);
    }
}

static void add_lines(SceneHandle scene, const clod_scene *from, const clod_camera *camera,
                      void *const *textures)
{
    for (size_t k = 0; k < from->lines; k++) {
        add_line(scene, from->end[k], camera, LINE_WIDTH, textures[CLOD_SCENE_LINE]);
    }
    for (size_t k = 0; k < from->marks; k++) {
        add_line(scene, from->mark[k], camera, MARK_WIDTH, textures[from->ink[k]]);
    }
}

static void set_camera(SceneHandle scene, const clod_camera *camera)
{
    rt_camera_projection(scene, RT_PROJECTION_PERSPECTIVE);
    rt_camera_position(scene, vector(camera->eye), vector(camera->ahead), vector(camera->up));
    rt_camera_frustum(scene, -camera->half_width, camera->half_width, -camera->half_height,
                      camera->half_height);
    rt_camera_raydepth(scene, 20); // surfaces one behind the other that are seen through
    rt_trans_max_surfaces(scene, 12);
    rt_trans_mode(scene, RT_TRANS_VMD);
}

/** Shadows of lights at the side would look like grains on the walls, so there are none; that
 *  of the sky is soft, and a light from the eye has its shadows behind what it shines on. */
static void set_light(SceneHandle scene, const clod_camera *camera, clod_tracer_quality quality)
{
    static const double KEY[3] = {0.45, -0.75, 0.85}; // from the upper left, behind the eye
    static const double FILL[3] = {-0.7, -0.1, 0.7};
    static const double EYE[3] = {0.0, 0.0, 1.0};
    if (quality == CLOD_TRACER_HIGH) {
        add_light(scene, camera, EYE, 0.25);
        rt_ambient_occlusion(scene, SKY_RAYS, rt_color(0.65, 0.65, 0.65));
        rt_shadermode(scene, RT_SHADER_FULL);
        rt_shadow_filtering(scene, 1);
    } else {
        add_light(scene, camera, KEY, 0.90);
        add_light(scene, camera, FILL, 0.50);
        rt_shadermode(scene, RT_SHADER_MEDIUM);
    }
}

/**
 * The mean of fine by fine rays for each pixel. Tachyon's rows begin below, and its camera sees
 * space as in a mirror, so the last ray comes first.
 */
static void reduce(const uint8_t *rays, int fine, int width, int height, uint8_t *image)
{
    const size_t row = (size_t)width * (size_t)fine;
    const size_t last = row * (size_t)height * (size_t)fine - 1;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            int sum[3] = {0, 0, 0};
            for (int k = 0; k < fine * fine; k++) {
                const size_t at = last - ((size_t)(y * fine + k / fine) * row +
                                          (size_t)(x * fine + k % fine));
                for (int c = 0; c < 3; c++) {
                    sum[c] += rays[3 * at + (size_t)c];
                }
            }
            for (int c = 0; c < 3; c++) {
                *image++ = (uint8_t)((sum[c] + fine * fine / 2) / (fine * fine));
            }
        }
    }
}

/** Rays along each side of a pixel. */
static int choose_fineness(clod_tracer_quality quality, int width, int height)
{
    return quality == CLOD_TRACER_DRAFT ? 1 : (double)width * height > LARGE ? 2 : 3;
}

bool clod_tracer_draw(const clod_scene *scene, const clod_camera *camera,
                      const clod_tracer_order *order, uint8_t *image, clod_status *status)
{
    const clod_tracer_quality quality = order->quality;
    const int fine = choose_fineness(quality, order->width, order->height);
    const int width = fine * order->width;
    const int height = fine * order->height;
    uint8_t *rays = clod_memory_alloc((size_t)width * (size_t)height, 3);
    if (rays == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a picture of %d by %d.",
                                order->width, order->height);
    }
    char name[] = "clod";
    char *names[] = {name, NULL};
    char **arguments = names;
    int count = 1;
    rt_set_ui_message(be_silent);
    rt_initialize(&count, &arguments);
    SceneHandle to = rt_newscene();
    rt_verbose(to, 0);
    rt_set_numthreads(to, order->threads);
    rt_aa_maxsamples(to, 0);
    rt_resolution(to, width, height);
    rt_rawimage_rgb24(to, rays);
    rt_background(to, rt_color(1.0, 1.0, 1.0));
    rt_image_clamp(to);
    set_camera(to, camera);
    set_light(to, camera, quality);
    void *textures[CLOD_SCENE_COLOURS], *veils[CLOD_SCENE_COLOURS];
    const double ambient = quality == CLOD_TRACER_HIGH ? 0.25 : AMBIENT;
    for (int k = 0; k < CLOD_SCENE_COLOURS; k++) {
        const bool mark = k >= CLOD_SCENE_MARK;
        textures[k] = make_texture(to, scene->colour[k], mark ? 1.0 : ambient,
                                   mark || k == CLOD_SCENE_LINE ? THIN : SOLID);
        veils[k] = make_texture(to, scene->colour[k], ambient,
                                k == CLOD_SCENE_MOVING ? BELT_VEIL : VEIL);
    }
    add_spheres(to, scene, textures);
    add_triangles(to, scene, textures, veils);
    add_lines(to, scene, camera, textures);
    rt_renderscene(to);
    rt_deletescene(to);
    reduce(rays, fine, order->width, order->height, image);
    clod_memory_free(rays);
    return true;
}
