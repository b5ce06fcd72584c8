#include "output/snapshot.h"

#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "output/file.h"
#include "output/folder_files.h"
#include "output/hdf.h"
#include "output/hdf_series.h"
#include "output/wall_mesh.h"

// cell types of VTK, vtkCellType.h
#define VTK_VERTEX 1
#define VTK_LINE 3
#define VTK_TRIANGLE 5

/** The kinds of picture, in the names of their files and series. */
static const char *const KINDS[] = {"snap", "walls", "contacts"};
enum { GRAINS, WALLS, CONTACTS };

static void put_columns(clod_hdf *hdf, const clod_hdf_column *columns, size_t count)
{
    for (size_t c = 0; c < count; c++) {
        clod_hdf_put(hdf, &columns[c]);
    }
}

/** The cells: number c has the points c * corners ... c * corners + corners - 1. */
static bool put_cells(clod_hdf *hdf, size_t cells, uint8_t type, int64_t corners,
                      clod_status *status)
{
    const size_t points = cells * (size_t)corners;
    int64_t *numbers = clod_memory_alloc(points + cells + 1, sizeof *numbers);
    uint8_t *types = clod_memory_alloc(cells, 1);
    const bool good = numbers != NULL && types != NULL;
    if (good) {
        int64_t *offsets = numbers + points;
        for (size_t p = 0; p < points; p++) {
            numbers[p] = (int64_t)p;
        }
        for (size_t c = 0; c <= cells; c++) {
            offsets[c] = (int64_t)c * corners;
        }
        memset(types, type, cells);
        const int64_t sizes[3] = {(int64_t)points, (int64_t)cells, (int64_t)points};
        const clod_hdf_column columns[] = {
            {"VTKHDF/NumberOfPoints", NULL, CLOD_HDF_I64, 1, 1, &sizes[0], 8},
            {"VTKHDF/NumberOfCells", NULL, CLOD_HDF_I64, 1, 1, &sizes[1], 8},
            {"VTKHDF/NumberOfConnectivityIds", NULL, CLOD_HDF_I64, 1, 1, &sizes[2], 8},
            {"VTKHDF/Connectivity", NULL, CLOD_HDF_I64, 1, points, numbers, 8},
            {"VTKHDF/Offsets", NULL, CLOD_HDF_I64, 1, cells + 1, offsets, 8},
            {"VTKHDF/Types", NULL, CLOD_HDF_U8, 1, cells, types, 1},
        };
        put_columns(hdf, columns, sizeof columns / sizeof *columns);
    } else {
        clod_status_fail(status, CLOD_FAILED, "No memory for a snapshot.");
    }
    clod_memory_free(numbers);
    clod_memory_free(types);
    return good;
}

/** Contacts of each grain with grains and walls; owned [grains.count], or NULL. */
static int32_t *coordination(const clod_state *state)
{
    int32_t *number = clod_memory_alloc(state->grains.count, sizeof *number);
    const size_t between = state->contact_count - state->wall_contact_count;
    for (size_t c = 0; number != NULL && c < state->contact_count; c++) {
        number[state->contacts[c].i]++;
        if (c < between) {
            number[state->contacts[c].j]++;
        }
    }
    return number;
}

static bool put_grains(clod_hdf *hdf, const clod_state *state, clod_status *status)
{
    const clod_grains *grains = &state->grains;
    const size_t n = grains->count;
    int32_t *contacts = coordination(state);
    if (contacts == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a snapshot.");
    }
    const size_t row = sizeof *grains->place;
    const bool some = n > 0;
    const double *radius = some ? &grains->place[0][3] : NULL;
    const double *mass = some ? &grains->motion[0][3] : NULL;
    const clod_hdf_column columns[] = {
        {"VTKHDF/Points", "m", CLOD_HDF_F64, 3, n, grains->place, row},
        {"VTKHDF/PointData/id", "1", CLOD_HDF_I64, 1, n, grains->id, sizeof *grains->id},
        {"VTKHDF/PointData/type", "1", CLOD_HDF_U16, 1, n, grains->material,
         sizeof *grains->material},
        {"VTKHDF/PointData/radius", "m", CLOD_HDF_F64, 1, n, radius, row},
        {"VTKHDF/PointData/velocity", "m s-1", CLOD_HDF_F64, 3, n, grains->motion, row},
        {"VTKHDF/PointData/omega", "rad s-1", CLOD_HDF_F64, 3, n, grains->turning, row},
        {"VTKHDF/PointData/force", "N", CLOD_HDF_F64, 3, n, grains->load, sizeof *grains->load},
        {"VTKHDF/PointData/mass", "kg", CLOD_HDF_F64, 1, n, mass, row},
        {"VTKHDF/PointData/coordination", "1", CLOD_HDF_I32, 1, n, contacts, sizeof *contacts},
    };
    put_columns(hdf, columns, sizeof columns / sizeof *columns);
    clod_memory_free(contacts);
    return put_cells(hdf, n, VTK_VERTEX, 1, status);
}

static bool put_walls(clod_hdf *hdf, const clod_state *state, clod_status *status)
{
    clod_wall_mesh mesh;
    bool good = clod_wall_mesh_make(&mesh, state, status);
    if (good) {
        const size_t n = mesh.count;
        const clod_hdf_column columns[] = {
            {"VTKHDF/Points", "m", CLOD_HDF_F64, 3, 3 * n, mesh.corner,
             sizeof mesh.corner[0][0]},
            {"VTKHDF/CellData/wall", "1", CLOD_HDF_I32, 1, n, mesh.wall, sizeof *mesh.wall},
            {"VTKHDF/CellData/type", "1", CLOD_HDF_I32, 1, n, mesh.material,
             sizeof *mesh.material},
            {"VTKHDF/CellData/velocity", "m s-1", CLOD_HDF_F64, 3, n, mesh.velocity,
             sizeof *mesh.velocity},
        };
        put_columns(hdf, columns, sizeof columns / sizeof *columns);
        good = put_cells(hdf, n, VTK_TRIANGLE, 3, status);
    }
    clod_wall_mesh_fini(&mesh);
    return good;
}

/** A contact as a line: from the centre of i to the image of j next to it. */
typedef struct clod_contact_line {
    double end[2][3]; ///< m
    double overlap;   ///< m
    uint64_t id[2];
} clod_contact_line;

static clod_contact_line contact_line(const clod_state *state, const clod_contact *contact)
{
    const double *a = state->grains.place[contact->i];
    const double *b = state->grains.place[contact->j];
    clod_contact_line line = {
        .id = {state->grains.id[contact->i], state->grains.id[contact->j]}};
    double square = 0.0;
    for (int d = 0; d < 3; d++) {
        const double length = state->domain.max[d] - state->domain.min[d];
        double step = b[d] - a[d];
        if (state->domain.periodic[d]) {
            step -= length * nearbyint(step / length);
        }
        line.end[0][d] = a[d];
        line.end[1][d] = a[d] + step;
        square += step * step;
    }
    line.overlap = a[3] + b[3] - sqrt(square);
    return line;
}

/** Every quantity of the contacts' histories. */
static void put_histories(clod_hdf *hdf, const clod_contact *contacts, size_t count)
{
    for (int f = 0; f < CLOD_HISTORY_FIELDS; f++) {
        const clod_history_field *field = &CLOD_HISTORY[f];
        char name[64];
        snprintf(name, sizeof name, "VTKHDF/CellData/%s", field->name);
        const clod_hdf_column column = {.name = name,
                                        .units = field->unit,
                                        .type = CLOD_HDF_F64,
                                        .components = (size_t)field->components,
                                        .rows = count,
                                        .data = count > 0 ? contacts[0].history + field->first
                                                          : NULL,
                                        .stride = sizeof *contacts};
        clod_hdf_put(hdf, &column);
    }
}

static bool put_contacts(clod_hdf *hdf, const clod_state *state, clod_status *status)
{
    const size_t n = state->contact_count - state->wall_contact_count;
    const clod_contact *contacts = state->contacts;
    clod_contact_line *lines = clod_memory_alloc(n, sizeof *lines);
    double(*ends)[3] = clod_memory_alloc(2 * n, sizeof *ends);
    bool good = lines != NULL && ends != NULL;
    if (good) {
        for (size_t c = 0; c < n; c++) {
            lines[c] = contact_line(state, &contacts[c]);
            memcpy(ends[2 * c], lines[c].end, sizeof lines[c].end);
        }
        const size_t row = sizeof *lines;
        const clod_hdf_column columns[] = {
            {"VTKHDF/Points", "m", CLOD_HDF_F64, 3, 2 * n, ends, sizeof *ends},
            {"VTKHDF/CellData/id", "1", CLOD_HDF_I64, 2, n, lines[0].id, row},
            {"VTKHDF/CellData/overlap", "m", CLOD_HDF_F64, 1, n, &lines[0].overlap, row},
        };
        put_columns(hdf, columns, sizeof columns / sizeof *columns);
        put_histories(hdf, contacts, n);
        good = put_cells(hdf, n, VTK_LINE, 2, status);
    } else {
        clod_status_fail(status, CLOD_FAILED, "No memory for a snapshot of the contacts.");
    }
    clod_memory_free(lines);
    clod_memory_free(ends);
    return good;
}

/** Owned bytes of one picture. */
static bool build_picture(const clod_state *state, int kind, void **image, size_t *size,
                          clod_status *status)
{
    clod_hdf *hdf = clod_hdf_create(CLOD_HDF_PICTURE, status);
    if (hdf == NULL) {
        return false;
    }
    const int64_t version[2] = {1, 0};
    clod_hdf_group(hdf, "VTKHDF");
    clod_hdf_put_ints(hdf, "VTKHDF", "Version", version, 2);
    clod_hdf_put_text(hdf, "VTKHDF", "Type", "UnstructuredGrid");
    clod_hdf_put_ints(hdf, "/", "step", &state->step, 1);
    clod_hdf_put_real(hdf, "/", "time_s", state->time);
    const bool good = kind == GRAINS  ? put_grains(hdf, state, status)
                      : kind == WALLS ? put_walls(hdf, state, status)
                                      : put_contacts(hdf, state, status);
    clod_status finishing;
    const bool finished = clod_hdf_finish(&hdf, image, size, good ? status : &finishing);
    if (finished && !good) {
        clod_memory_free(*image);
    }
    return finished && good;
}

static bool name_series(char name[NAME_MAX + 1], const char *stem, int kind,
                        clod_status *status)
{
    return (size_t)snprintf(name, NAME_MAX + 1, "%s%s%s.hdf.series", stem,
                            kind == GRAINS ? "" : "_",
                            kind == GRAINS ? "" : KINDS[kind]) <= NAME_MAX ||
           clod_file_fail(status, "name a series", stem, ENAMETOOLONG);
}

/** Write one picture and put it into its series. */
static bool write_picture(const clod_folder *folder, const char *stem, int64_t number,
                          const clod_state *state, int kind, clod_snapshot_film *film,
                          clod_status *status)
{
    char name[NAME_MAX + 1], series[NAME_MAX + 1];
    const bool plain = strcmp(stem, "run") == 0;
    if ((size_t)snprintf(name, sizeof name, "%s%s%s_%06" PRId64 ".hdf", plain ? "" : stem,
                         plain ? "" : "_", KINDS[kind], number) >= sizeof name) {
        return clod_file_fail(status, "name a snapshot", stem, ENAMETOOLONG);
    }
    if (!name_series(series, stem, kind, status)) {
        return false;
    }
    void *image;
    size_t size;
    if (!build_picture(state, kind, &image, &size, status)) {
        return false;
    }
    const bool done = clod_folder_replace(folder, name, image, size, NULL, 0, status);
    clod_memory_free(image);
    return done &&
           clod_hdf_series_add(folder, series, name, state->time, &film->crc32[kind], status);
}

bool clod_snapshot_write(const clod_folder *folder, const char *stem, int64_t number,
                         const clod_state *state, bool contacts, clod_snapshot_film *film,
                         clod_status *status)
{
    return write_picture(folder, stem, number, state, GRAINS, film, status) &&
           write_picture(folder, stem, number, state, WALLS, film, status) &&
           (!contacts || write_picture(folder, stem, number, state, CONTACTS, film, status));
}

bool clod_snapshot_resume(const clod_folder *folder, const char *stem, double time,
                          clod_status *status)
{
    for (int kind = GRAINS; kind <= CONTACTS; kind++) {
        char series[NAME_MAX + 1];
        if (!name_series(series, stem, kind, status) ||
            !clod_hdf_series_cut(folder, series, time, status)) {
            return false;
        }
    }
    return true;
}

bool clod_snapshot_check(const clod_folder *folder, const char *stem, double time,
                         const clod_snapshot_film *film, clod_status *status)
{
    for (int kind = GRAINS; kind <= CONTACTS; kind++) {
        char series[NAME_MAX + 1];
        if (!name_series(series, stem, kind, status) ||
            !clod_hdf_series_check(folder, series, time, film->crc32[kind], status)) {
            return false;
        }
    }
    return true;
}
