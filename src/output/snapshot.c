#include "output/snapshot.h"

#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "output/file.h"
#include "output/folder_files.h"
#include "output/hdf.h"
#include "output/hdf_series.h"
#include "output/paraview.h"
#include "output/vtk_cells.h"
#include "output/wall_mesh.h"

/** The kinds of picture, in the names of their files and series. */
static const char *const KINDS[] = {"snap", "walls", "contacts"};
enum { GRAINS, WALLS, CONTACTS };

static void put_columns(clod_hdf *hdf, const clod_hdf_column *columns, size_t count)
{
    for (size_t c = 0; c < count; c++) {
        clod_hdf_put(hdf, &columns[c]);
    }
}

/** What a picture is taken of, and what ParaView's state file shall know of it. */
typedef struct scene {
    const clod_folder *folder;
    const char *stem;
    int64_t number;
    const clod_state *state;
    const clod_bed_source *bed;
    clod_paraview *view;
} scene;

enum { GRAIN_COLUMNS = 12 };

/** List the columns of the grains of a slab; how many. */
static size_t list_grains(const clod_bed_slab *slab, clod_hdf_column column[GRAIN_COLUMNS])
{
    const clod_grains *grains = &slab->rows->grains;
    const size_t n = grains->count, row = sizeof *grains->position;
    const double *radius = n > 0 ? &grains->position[0][3] : NULL;
    const double *mass = n > 0 ? &grains->velocity[0][3] : NULL;
    const clod_hdf_column columns[] = {
        {VTK_POINTS, "m", CLOD_HDF_F64, 3, n, grains->position, row},
        {VTK_POINT_DATA "/id", "1", CLOD_HDF_I64, 1, n, grains->id, sizeof *grains->id},
        {VTK_POINT_DATA "/birth", "s", CLOD_HDF_F64, 1, n, grains->birth,
         sizeof *grains->birth},
        {VTK_POINT_DATA "/type", "1", CLOD_HDF_U16, 1, n, grains->material,
         sizeof *grains->material},
        {VTK_POINT_DATA "/radius", "m", CLOD_HDF_F64, 1, n, radius, row},
        {VTK_POINT_DATA "/velocity", "m s-1", CLOD_HDF_F64, 3, n, grains->velocity, row},
        {VTK_POINT_DATA "/omega", "rad s-1", CLOD_HDF_F64, 3, n, grains->angular_velocity, row},
        {VTK_POINT_DATA "/force", "N", CLOD_HDF_F64, 3, n, grains->load, sizeof *grains->load},
        {VTK_POINT_DATA "/mass", "kg", CLOD_HDF_F64, 1, n, mass, row},
        {VTK_POINT_DATA "/coordination", "1", CLOD_HDF_I32, 1, n, slab->contacts,
         sizeof *slab->contacts},
    };
    size_t count = sizeof columns / sizeof *columns;
    memcpy(column, columns, sizeof columns);
    if (grains->clump != NULL) {
        const size_t each = sizeof *grains->clump;
        column[count++] = (clod_hdf_column){VTK_POINT_DATA "/clump", "1", CLOD_HDF_I64, 1, n,
                                            &grains->clump->number,  each};
        column[count++] = (clod_hdf_column){
            VTK_POINT_DATA "/clump_size", "1", CLOD_HDF_I32, 1, n, &grains->clump->size, each};
    }
    return count;
}

static void view_grains(clod_paraview *view, const clod_grains *grains)
{
    for (size_t g = 0; g < grains->count; g++) {
        const double *p = grains->position[g], *v = grains->velocity[g];
        clod_paraview_add(view, p, p[3]);
        view->speed = fmax(view->speed, sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    }
}

/** All grains, slab by slab. */
static bool put_slabs(clod_hdf *hdf, const scene *self, size_t total, clod_status *status)
{
    const clod_bed_source *bed = self->bed;
    clod_hdf_column column[GRAIN_COLUMNS];
    clod_bed_slab slab = {.rows = self->state};
    size_t first = 0;
    bool good = true;
    do {
        const size_t count = total - first < CLOD_HDF_SLAB ? total - first : CLOD_HDF_SLAB;
        good = count == 0 || bed->grains(bed->context, first, count, &slab, status);
        const size_t columns = good ? list_grains(&slab, column) : 0;
        for (size_t c = 0; first == 0 && c < columns; c++) {
            clod_hdf_column whole = column[c];
            whole.rows = total;
            clod_hdf_make(hdf, &whole);
        }
        for (size_t c = 0; count > 0 && c < columns; c++) {
            clod_hdf_put_rows(hdf, &column[c], first);
        }
        if (good && count > 0) {
            view_grains(self->view, &slab.rows->grains);
        }
        first += count;
    } while (good && first < total);
    return good;
}

static bool put_grains(clod_hdf *hdf, const scene *self, clod_status *status)
{
    clod_bed_counts all;
    const clod_bed_source *bed = self->bed;
    const bool good = bed->begin(bed->context, (clod_bed_wants){.each = true}, &all, status) &&
                      put_slabs(hdf, self, all.grains, status);
    bed->end(bed->context);
    return good && clod_vtk_cells_put(hdf, all.grains, VTK_VERTEX, 1, status);
}

/** What grains did to the triangles, if that was measured. */
static void put_wear(clod_hdf *hdf, const clod_wall_mesh *mesh)
{
    static const struct {
        const char *name, *unit;
    } FIELD[CLOD_WALL_MESH_WEAR] = {
        [CLOD_WALL_MESH_PRESSURE] = {VTK_CELL_DATA "/pressure", "Pa"},
        [CLOD_WALL_MESH_SHEAR_WORK] = {VTK_CELL_DATA "/shear_work", "J m-2"},
        [CLOD_WALL_MESH_IMPACT_ENERGY] = {VTK_CELL_DATA "/impact_energy", "J m-2"},
        [CLOD_WALL_MESH_IMPACTS] = {VTK_CELL_DATA "/impacts", "m-2"},
        [CLOD_WALL_MESH_ARCHARD_DEPTH] = {VTK_CELL_DATA "/archard_depth", "m"},
        [CLOD_WALL_MESH_FINNIE_DEPTH] = {VTK_CELL_DATA "/finnie_depth", "m"},
    };
    for (int f = 0; mesh->wears && f < CLOD_WALL_MESH_WEAR; f++) {
        const clod_hdf_column column = {
            FIELD[f].name,     FIELD[f].unit,
            CLOD_HDF_F64,      1,
            mesh->count,       mesh->count > 0 ? &mesh->wear[0][f] : NULL,
            sizeof *mesh->wear};
        clod_hdf_put(hdf, &column);
    }
}

/** Which part of a mesh each triangle is of, if parts have names. */
static void put_parts(clod_hdf *hdf, const clod_wall_mesh *mesh)
{
    const clod_hdf_column column = {VTK_PARTS,   "1",        CLOD_HDF_I32,      1,
                                    mesh->count, mesh->part, sizeof *mesh->part};
    if (mesh->parts[0] != '\0') {
        clod_hdf_put(hdf, &column);
        clod_hdf_put_text(hdf, VTK_PARTS, VTK_PARTS_NAMES, mesh->parts);
    }
}

static void view_walls(clod_paraview *view, const clod_wall_mesh *mesh)
{
    view->wears = mesh->wears;
    for (size_t f = 0; f < mesh->count; f++) {
        for (int c = 0; c < 3; c++) {
            clod_paraview_add(view, mesh->corner[f][c], 0.0);
        }
        if (mesh->wears) {
            view->pressure = fmax(view->pressure, mesh->wear[f][CLOD_WALL_MESH_PRESSURE]);
        }
    }
}

static bool put_walls(clod_hdf *hdf, const clod_state *state, clod_paraview *view,
                      clod_status *status)
{
    clod_wall_mesh mesh;
    bool good = clod_wall_mesh_make(&mesh, state, status);
    if (good) {
        view_walls(view, &mesh);
        const size_t n = mesh.count;
        const clod_hdf_column columns[] = {
            {VTK_POINTS, "m", CLOD_HDF_F64, 3, 3 * n, mesh.corner, sizeof mesh.corner[0][0]},
            {VTK_CELL_DATA "/wall", "1", CLOD_HDF_I32, 1, n, mesh.wall, sizeof *mesh.wall},
            {VTK_CELL_DATA "/type", "1", CLOD_HDF_I32, 1, n, mesh.material,
             sizeof *mesh.material},
            {VTK_CELL_DATA "/shape", "1", CLOD_HDF_I32, 1, n, mesh.shape, sizeof *mesh.shape},
            {VTK_CELL_DATA "/velocity", "m s-1", CLOD_HDF_F64, 3, n, mesh.velocity,
             sizeof *mesh.velocity},
        };
        put_columns(hdf, columns, sizeof columns / sizeof *columns);
        put_parts(hdf, &mesh);
        put_wear(hdf, &mesh);
        good = clod_vtk_cells_put(hdf, n, VTK_TRIANGLE, 3, status);
    }
    clod_wall_mesh_fini(&mesh);
    return good;
}

/** A contact as a line: from the centre of i to the image of j next to it. */
typedef struct clod_contact_line {
    double end[2][3]; ///< m
    double overlap;   ///< m
    double pull_off;  ///< N
    uint64_t id[2];
} clod_contact_line;

static clod_contact_line contact_line(const clod_domain *domain, const clod_bed_line *from,
                                      const uint64_t partners[2])
{
    const double *a = from->place[0];
    const double *b = from->place[1];
    clod_contact_line line = {.pull_off = from->pull_off, .id = {partners[0], partners[1]}};
    double square = 0.0;
    for (int d = 0; d < 3; d++) {
        const double length = domain->max[d] - domain->min[d];
        double step = b[d] - a[d];
        if (domain->periodic[d]) {
            step -= length * nearbyint(step / length);
        }
        line.end[0][d] = a[d];
        line.end[1][d] = a[d] + step;
        square += step * step;
    }
    line.overlap = a[3] + b[3] - sqrt(square);
    return line;
}

enum { LINE_COLUMNS = 4 + CLOD_HISTORY_FIELDS };

/** Contacts on their way into a picture. */
typedef struct slab {
    clod_contact *contacts;
    uint64_t (*partners)[2];
    clod_bed_line *from;
    clod_contact_line *lines;
    double (*ends)[3]; ///< two of each
    char name[CLOD_HISTORY_FIELDS][64];
    clod_hdf_column column[LINE_COLUMNS];
} slab;

static bool slab_init(slab *self, size_t rows)
{
    *self = (slab){.contacts = clod_memory_alloc(rows, sizeof *self->contacts),
                   .partners = clod_memory_alloc(rows, sizeof *self->partners),
                   .from = clod_memory_alloc(rows, sizeof *self->from),
                   .lines = clod_memory_alloc(rows, sizeof *self->lines),
                   .ends = clod_memory_alloc(2 * rows, sizeof *self->ends)};
    return self->contacts != NULL && self->partners != NULL && self->from != NULL &&
           self->lines != NULL && self->ends != NULL;
}

static void slab_fini(slab *self)
{
    clod_memory_free(self->contacts);
    clod_memory_free(self->partners);
    clod_memory_free(self->from);
    clod_memory_free(self->lines);
    clod_memory_free(self->ends);
}

/** List the columns of so many contacts: ends, ids, overlap, and every quantity of histories.
 */
static void list_lines(slab *self, size_t count)
{
    const size_t row = sizeof *self->lines;
    clod_hdf_column *column = self->column;
    column[0] = (clod_hdf_column){VTK_POINTS, "m",        CLOD_HDF_F64,      3,
                                  2 * count,  self->ends, sizeof *self->ends};
    column[1] = (clod_hdf_column){VTK_CELL_DATA "/id", "1", CLOD_HDF_I64, 2, count,
                                  self->lines[0].id,   row};
    column[2] = (clod_hdf_column){VTK_CELL_DATA "/overlap", "m", CLOD_HDF_F64, 1, count,
                                  &self->lines[0].overlap,  row};
    column[3] = (clod_hdf_column){VTK_CELL_DATA "/pull_off", "N", CLOD_HDF_F64, 1, count,
                                  &self->lines[0].pull_off,  row};
    for (int f = 0; f < CLOD_HISTORY_FIELDS; f++) {
        const clod_history_field *field = &CLOD_HISTORY[f];
        snprintf(self->name[f], sizeof self->name[f], VTK_CELL_DATA "/%s", field->name);
        column[4 + f] = (clod_hdf_column){.name = self->name[f],
                                          .units = field->unit,
                                          .type = CLOD_HDF_F64,
                                          .components = (size_t)field->components,
                                          .rows = count,
                                          .data = self->contacts[0].history + field->first,
                                          .stride = sizeof *self->contacts};
    }
}

/** Write lines from number `first` on, of contacts that were just read. */
static void put_lines(clod_hdf *hdf, const clod_domain *domain, slab *self, size_t first,
                      size_t count)
{
    for (size_t c = 0; c < count; c++) {
        self->lines[c] = contact_line(domain, &self->from[c], self->partners[c]);
        memcpy(self->ends[2 * c], self->lines[c].end, sizeof self->lines[c].end);
    }
    list_lines(self, count);
    clod_hdf_put_rows(hdf, &self->column[0], 2 * first);
    for (int k = 1; k < LINE_COLUMNS; k++) {
        clod_hdf_put_rows(hdf, &self->column[k], first);
    }
}

/** Lines of all contacts of grains, slab by slab. */
static bool put_all_lines(clod_hdf *hdf, const scene *self, size_t count, clod_status *status)
{
    const clod_bed_source *bed = self->bed;
    const size_t most = count < CLOD_HDF_SLAB ? count : CLOD_HDF_SLAB;
    slab some;
    bool good =
        slab_init(&some, most + 1) ||
        clod_status_fail(status, CLOD_FAILED, "No memory for a snapshot of the contacts.");
    if (good) {
        list_lines(&some, count);
        for (int k = 0; k < LINE_COLUMNS; k++) {
            clod_hdf_make(hdf, &some.column[k]);
        }
    }
    for (size_t first = 0, n = 0; good && first < count; first += n) {
        n = count - first < most ? count - first : most;
        good = bed->contacts(bed->context, &n, some.contacts, some.partners, some.from, status);
        if (good) {
            CLOD_ASSERT(n > 0);
            put_lines(hdf, &self->state->domain, &some, first, n);
        }
    }
    slab_fini(&some);
    return good;
}

static bool put_contacts(clod_hdf *hdf, const scene *self, clod_status *status)
{
    clod_bed_counts all;
    const clod_bed_source *bed = self->bed;
    const bool good = bed->begin(bed->context, (clod_bed_wants){.lines = true}, &all, status) &&
                      put_all_lines(hdf, self, all.pairs, status);
    bed->end(bed->context);
    return good && clod_vtk_cells_put(hdf, all.pairs, VTK_LINE, 2, status);
}

/** Write one picture into an open file. */
static bool put_picture(const clod_hdf_place *place, const scene *self, int kind,
                        clod_status *status)
{
    const clod_state *state = self->state;
    clod_hdf *hdf = clod_hdf_create(place, CLOD_HDF_PICTURE, status);
    if (hdf == NULL) {
        return false;
    }
    clod_vtk_cells_head(hdf);
    clod_hdf_put_ints(hdf, "/", "step", &state->step, 1);
    clod_hdf_put_real(hdf, "/", VTK_TIME, state->time);
    const bool good = kind == GRAINS  ? put_grains(hdf, self, status)
                      : kind == WALLS ? put_walls(hdf, state, self->view, status)
                                      : put_contacts(hdf, self, status);
    clod_status finishing;
    uint64_t size;
    return clod_hdf_finish(&hdf, &size, good ? status : &finishing) && good;
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
static bool write_picture(const scene *self, int kind, clod_snapshot_film *film,
                          clod_status *status)
{
    char name[NAME_MAX + 1], series[NAME_MAX + 1];
    const bool plain = strcmp(self->stem, "run") == 0;
    if ((size_t)snprintf(name, sizeof name, "%s%s%s_%06" PRId64 ".hdf", plain ? "" : self->stem,
                         plain ? "" : "_", KINDS[kind], self->number) >= sizeof name) {
        return clod_file_fail(status, "name a snapshot", self->stem, ENAMETOOLONG);
    }
    clod_folder_draft draft;
    if (!name_series(series, self->stem, kind, status) ||
        !clod_folder_draft_begin(&draft, self->folder, name, status)) {
        return false;
    }
    const clod_hdf_place place = {self->folder, name, draft.descriptor, 0};
    const bool good = put_picture(&place, self, kind, status);
    return clod_folder_draft_end(&draft, good, status) &&
           clod_hdf_series_add(self->folder, series, name, self->state->time,
                               &film->crc32[kind], status);
}

bool clod_snapshot_write(const clod_folder *folder, const char *stem, int64_t number,
                         const clod_state *state, const clod_bed_source *bed, bool contacts,
                         clod_snapshot_film *film, clod_status *status)
{
    clod_bed_view whole;
    const clod_bed_source own = clod_bed_source_of(&whole, state, NULL);
    clod_paraview view = clod_paraview_begin(state->time);
    const scene of = {folder, stem, number, state, bed != NULL ? bed : &own, &view};
    view.contacts = contacts;
    return write_picture(&of, GRAINS, film, status) &&
           write_picture(&of, WALLS, film, status) &&
           (!contacts || write_picture(&of, CONTACTS, film, status)) &&
           clod_paraview_write(&view, folder, stem, status);
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
