#include "sim/ranks_check.h"

#include "config/testers.h"
#include "setup/grains.h"

static bool has_meshes(const clod_case *from)
{
    bool has = false;
    for (size_t w = 0; w < from->wall_count; w++) {
        for (size_t s = 0; s < from->walls[w].shape_count; s++) {
            has = has || from->walls[w].shapes[s].kind == CLOD_SHAPE_MESH;
        }
    }
    return has;
}

static bool has_inlets(const clod_case *from)
{
    return clod_setup_grains_coming(from) > 0;
}

static bool has_outlets(const clod_case *from)
{
    return from->outlet_count > 0;
}

static bool is_open(const clod_case *from)
{
    return from->open == CLOD_OPEN_DELETE;
}

static bool has_surfaces(const clod_case *from)
{
    return from->output.surfaces;
}

static bool has_clumps(const clod_case *from)
{
    return from->clumps.present;
}

/** A key that only one rank can do. */
typedef struct alone_row {
    const char *key;
    bool (*present)(const clod_case *from);
} alone_row;

static const alone_row ALONE[] = {
    {"walls.NAME.shapes: mesh", has_meshes},
    {"grains.NAME.inlet", has_inlets},
    {"outlets", has_outlets},
    {"domain.open: delete", is_open},
    {"output.surfaces", has_surfaces},
    {"clumps", has_clumps},
};

bool clod_ranks_check(const clod_case *from, clod_status *status)
{
    const char *key = clod_config_tester_of(from)->key;
    for (size_t k = 0; key == NULL && k < sizeof ALONE / sizeof *ALONE; k++) {
        key = ALONE[k].present(from) ? ALONE[k].key : NULL;
    }
    return key == NULL ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: %s does not work on more than one rank yet: run it without "
                            "mpirun, with --threads",
                            from->path, key);
}
