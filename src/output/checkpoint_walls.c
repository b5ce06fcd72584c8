#include "output/checkpoint_walls.h"

#include <string.h>

#include "base/memory.h"
#include "output/checkpoint_columns.h"
#include "state/wear.h"

static size_t count_shapes(const clod_walls *walls)
{
    size_t count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        count += (size_t)walls->wall[w].shape_count;
    }
    return count;
}

static size_t count_rows(const clod_walls *walls)
{
    size_t count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        count += walls->wall[w].wear != NULL ? (size_t)walls->wall[w].wear_rows : 0;
    }
    return count;
}

/** Sums of the places of all walls; false without memory. */
static bool put_wear(clod_hdf *hdf, const clod_walls *walls)
{
    const size_t count = count_rows(walls);
    double(*sums)[CLOD_WEAR_SUMS] = clod_memory_alloc(count + 1, sizeof *sums);
    size_t at = 0;
    for (int32_t w = 0; sums != NULL && w < walls->count; w++) {
        const clod_wall *wall = &walls->wall[w];
        const size_t rows = wall->wear != NULL ? (size_t)wall->wear_rows : 0;
        if (rows > 0) {
            memcpy(sums + at, wall->wear, rows * sizeof *sums);
        }
        at += rows;
    }
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_of_wear(&columns, (const double(*)[CLOD_WEAR_SUMS])sums, count);
    if (sums != NULL) {
        clod_checkpoint_columns_put(&columns, hdf);
    }
    clod_memory_free(sums);
    return sums != NULL;
}

bool clod_checkpoint_walls_put(clod_hdf *hdf, const clod_walls *walls, clod_status *status)
{
    const size_t count = count_shapes(walls);
    clod_shape *shapes = clod_memory_alloc(count + 1, sizeof *shapes);
    if (shapes == NULL) {
        return clod_status_fail(status, CLOD_FAILED,
                                "No memory for a checkpoint of %zu shapes.", count);
    }
    size_t at = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t s = 0; s < walls->wall[w].shape_count; s++) {
            shapes[at++] = walls->wall[w].shapes[s];
        }
    }
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_of_walls(&columns, walls->wall, (size_t)walls->count);
    clod_checkpoint_columns_put(&columns, hdf);
    clod_checkpoint_columns_of_shapes(&columns, shapes, count);
    clod_checkpoint_columns_put(&columns, hdf);
    clod_memory_free(shapes);
    return put_wear(hdf, walls) ||
           clod_status_fail(status, CLOD_FAILED, "No memory for a checkpoint of %zu shapes.",
                            count);
}

/** Whether the file has the sums of places that its walls speak of. */
static bool has_wear(clod_hdf *hdf, const clod_walls *walls)
{
    size_t count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        count += (size_t)walls->wall[w].wear_rows;
    }
    return count == 0 || count == clod_hdf_rows(hdf, "walls/wear");
}

/** Whether a wall's sums are those of its places; where its facets are not there nobody asks. */
static bool wear_fits(clod_wall *wall)
{
    const int32_t places = clod_wear_number(wall);
    for (int32_t s = 0; s < wall->shape_count; s++) {
        if (clod_shape_lacks_facets(&wall->shapes[s])) {
            return true;
        }
    }
    return wall->wear == NULL ||
           (wall->wear_places == places && wall->wear_rows == clod_wear_rows(wall, places));
}

/** Sums of the places of walls that have them; false without memory. */
static bool read_wear(clod_hdf *hdf, clod_walls *walls)
{
    size_t count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        count += (size_t)walls->wall[w].wear_rows;
    }
    double(*sums)[CLOD_WEAR_SUMS] = clod_memory_alloc(count + 1, sizeof *sums);
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_of_wear(&columns, (const double(*)[CLOD_WEAR_SUMS])sums, count);
    bool good = sums != NULL;
    if (good) {
        clod_checkpoint_columns_get(&columns, hdf);
    }
    size_t at = 0;
    for (int32_t w = 0; good && w < walls->count; w++) {
        clod_wall *wall = &walls->wall[w];
        const size_t rows = (size_t)wall->wear_rows;
        if (rows > 0) {
            wall->wear = clod_memory_alloc(rows, sizeof *sums);
            good = wall->wear != NULL;
        }
        if (good && rows > 0) {
            memcpy(wall->wear, sums + at, rows * sizeof *sums);
        }
        at += rows;
    }
    clod_memory_free(sums);
    return good;
}

/** Read the columns of walls and shapes. */
static void read_columns(clod_hdf *hdf, const clod_walls *walls, clod_shape *shapes,
                         size_t shape_count)
{
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_of_walls(&columns, walls->wall, (size_t)walls->count);
    clod_checkpoint_columns_get(&columns, hdf);
    clod_checkpoint_columns_of_shapes(&columns, shapes, shape_count);
    clod_checkpoint_columns_get(&columns, hdf);
}

/** Whether every wall has a name that ends, and shapes that are in the file and are known. */
static bool fit(const clod_walls *walls, const clod_shape *shapes, size_t shape_count)
{
    size_t left = shape_count;
    for (int32_t w = 0; w < walls->count; w++) {
        const clod_wall *wall = &walls->wall[w];
        if (wall->shape_count < 0 || (size_t)wall->shape_count > left ||
            wall->wear_places < 0 || wall->wear_rows < wall->wear_places ||
            memchr(wall->name, '\0', sizeof wall->name) == NULL) {
            return false;
        }
        left -= (size_t)wall->shape_count;
    }
    bool known = left == 0;
    for (size_t s = 0; known && s < shape_count; s++) {
        const int32_t kind = (int32_t)shapes[s].kind, side = (int32_t)shapes[s].side;
        known = kind >= 0 && kind < CLOD_SHAPE_KINDS && side >= CLOD_SIDE_INSIDE &&
                side <= CLOD_SIDE_OUTSIDE;
    }
    return known;
}

/** Give each wall its own shapes; false without memory. */
static bool share_out(clod_walls *walls, const clod_shape *shapes)
{
    for (int32_t w = 0; w < walls->count; w++) {
        clod_wall *wall = &walls->wall[w];
        const size_t count = (size_t)wall->shape_count;
        wall->shapes = clod_memory_alloc(count, sizeof *wall->shapes);
        if (wall->shapes == NULL && count > 0) {
            return false;
        }
        for (size_t s = 0; s < count; s++) {
            wall->shapes[s] = *shapes++;
        }
        clod_wall_find_symmetry(wall);
    }
    return true;
}

/** Walls of the file into `walls`, which has room for them. */
static bool read_walls(clod_hdf *hdf, clod_walls *walls, const char *path, clod_status *status)
{
    const size_t count = clod_hdf_rows(hdf, "shapes/kind");
    clod_shape *shapes = clod_memory_alloc(count + 1, sizeof *shapes);
    bool memory = shapes != NULL, good = memory;
    if (good) {
        read_columns(hdf, walls, shapes, count);
        good = clod_hdf_has_failed(hdf) || (fit(walls, shapes, count) && has_wear(hdf, walls));
        memory = !good || clod_hdf_has_failed(hdf) ||
                 (share_out(walls, shapes) && read_wear(hdf, walls));
    }
    clod_memory_free(shapes);
    if (!memory) {
        return clod_status_fail(status, CLOD_FAILED, "No memory to read %s.", path);
    }
    return good ||
           clod_status_fail(status, CLOD_FAILED,
                            "%s holds walls whose shapes clod does not know. Start over "
                            "with --fresh.",
                            path);
}

/** Shapes of meshes get their surfaces from the walls of the same names that were there: a file
 *  has no facets. */
static void share_surfaces(const clod_walls *before, clod_walls *walls)
{
    for (int32_t w = 0; w < walls->count; w++) {
        clod_wall *wall = &walls->wall[w];
        const int32_t b = clod_walls_find(before, wall->name);
        const clod_wall *was = b >= 0 ? &before->wall[b] : NULL;
        for (int32_t s = 0; was != NULL && s < wall->shape_count && s < was->shape_count; s++) {
            clod_shape *shape = &wall->shapes[s];
            const clod_shape *other = &was->shapes[s];
            if (clod_shape_lacks_facets(shape) && other->surface != NULL &&
                shape->patch == other->patch && shape->slot == other->slot) {
                shape->surface = clod_surface_share(other->surface);
            }
        }
    }
}

bool clod_checkpoint_walls_get(clod_hdf *hdf, clod_walls *walls, const char *path,
                               clod_status *status)
{
    clod_walls before = *walls;
    *walls = (clod_walls){0};
    const size_t count = clod_hdf_rows(hdf, "walls/name");
    walls->wall = clod_memory_alloc(count + 1, sizeof *walls->wall);
    if (walls->wall == NULL || count > INT32_MAX) {
        clod_walls_fini(&before);
        return clod_status_fail(status, CLOD_FAILED, "No memory to read %s.", path);
    }
    walls->count = (int32_t)count;
    const bool good = read_walls(hdf, walls, path, status);
    if (!good || clod_hdf_has_failed(hdf)) {
        clod_walls_fini(walls);
    }
    share_surfaces(&before, walls);
    clod_walls_fini(&before);
    for (int32_t w = 0; good && w < walls->count; w++) {
        if (!wear_fits(&walls->wall[w])) {
            return clod_status_fail(status, CLOD_FAILED,
                                    "%s holds sums of surfaces that are not those of the wall "
                                    "%s. Start over with --fresh.",
                                    path, walls->wall[w].name);
        }
    }
    return good;
}
