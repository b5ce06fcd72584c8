/**
 * @file params_shape.c
 * Tables of the shapes of walls: where they are, what they are made of, their belts.
 */

#include "config/param.h"
#include "config/unit.h"

#define S clod_case_shape

#define LENGTH(name, field_help, text)                                                         \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_REQUIRED, .unit = "m",       \
        CLOD_ABOVE(0, 1e4), .example = text, CLOD_AT(S, name), .help = field_help,             \
        .source = "convention"                                                                 \
    }
#define POSITION(name, field, field_help, text)                                                \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_VECTOR, .length = 3, .need = CLOD_PARAM_REQUIRED,      \
        .unit = "m", CLOD_FROM(-1e4, 1e4), .example = text, CLOD_AT(S, field),                 \
        .help = field_help, .source = "convention"                                             \
    }
#define DIRECTION(name, field_help, text)                                                      \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_VECTOR, .length = 3, .need = CLOD_PARAM_OPTIONAL,     \
        .unit = "1", CLOD_FROM(-1e4, 1e4), .nonzero = true, .fallback = text,                  \
        CLOD_AT(S, name), .help = field_help, .source = "convention"                           \
    }

static const char *const SIDES[] = {
    [CLOD_SIDE_INSIDE] = "inside", [CLOD_SIDE_OUTSIDE] = "outside", NULL};

#define RADIUS(name, field_help, text)                                                         \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_REQUIRED, .unit = "m",       \
        CLOD_FROM(0, 1e4), .example = text, CLOD_AT(S, name), .help = field_help,              \
        .source = "convention"                                                                 \
    }
#define SIDE                                                                                   \
    {                                                                                          \
        .key = "side", .kind = CLOD_PARAM_CHOICE, .need = CLOD_PARAM_OPTIONAL,                 \
        .choices = SIDES, .fallback = "inside", CLOD_AT(S, side),                              \
        .help = "Side on which the grains are.", .source = "convention"                        \
    }

#define U clod_case_surface

static bool has_speed(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const U *)self)->speed != 0.0;
}

static bool has_surface_spin(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const U *)self)->spin != 0.0;
}

static bool has_surface(const clod_case *whole, const void *self)
{
    (void)whole;
    const U *surface = &((const S *)self)->surface;
    const double *v = surface->velocity;
    return surface->material != NULL || surface->speed != 0.0 || surface->spin != 0.0 ||
           v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0;
}

static bool mesh_turns(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const S *)self)->rotate.angle != 0.0;
}

static const clod_param SURFACE[] = {
    {.key = "material",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "rubber",
     CLOD_AT(U, material),
     .help = "Name of a material; without it that of the wall.",
     .source = "convention"},
    {.key = "velocity",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .fallback = "0 0 0 m/s",
     CLOD_AT(U, velocity),
     .help = "Velocity of the material while the shape stays in place, on top of the motion of "
             "the wall and turning with it.",
     .source = "docs/theory/walls.md"},
    {.key = "speed",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .fallback = "0 m/s",
     CLOD_AT(U, speed),
     .help = "Speed of the material along direction as projected onto the surface, as on a "
             "belt over a curved bed.",
     .source = "docs/theory/walls.md"},
    {.key = "direction",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .fallback = "1 0 0",
     CLOD_AT(U, direction),
     .used = has_speed,
     .unused = "without speed nothing moves along it; remove this key, or give speed",
     .help = "Direction of speed; where it is normal to the surface the material stands.",
     .source = "docs/theory/walls.md"},
    {.key = "spin",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad/s",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 rad/s",
     CLOD_AT(U, spin),
     .help = "Speed with which the material turns about spin_axis through spin_point, as on "
             "a pulley.",
     .source = "docs/theory/walls.md"},
    {.key = "spin_axis",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .fallback = "0 0 1",
     CLOD_AT(U, spin_axis),
     .used = has_surface_spin,
     .unused = "without spin nothing turns about it; remove this key, or give spin",
     .help = "Direction of the axis about which the material turns.",
     .source = "docs/theory/walls.md"},
    {.key = "spin_point",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 0 0 m",
     CLOD_AT(U, spin_point),
     .used = has_surface_spin,
     .unused = "without spin nothing turns about it; remove this key, or give spin",
     .help = "A point of the axis about which the material turns.",
     .source = "docs/theory/walls.md"},
};
static const clod_table SURFACE_TABLE = {
    .title = "What a shape is made of, and how its material moves while it stays in place.",
    CLOD_ROWS(SURFACE),
    .size = sizeof(U)};

#define SURFACE_ROW                                                                            \
    {                                                                                          \
        .key = "surface", .kind = CLOD_PARAM_SECTION, .need = CLOD_PARAM_OPTIONAL,             \
        .table = &SURFACE_TABLE, CLOD_AT(S, surface), .used = has_surface,                     \
        .help = "Material and motion of this surface, where they are not the wall's.",         \
        .source = "docs/theory/walls.md"                                                       \
    }

static const clod_param PLANE[] = {
    POSITION("point", point, "A point of the plane.", "[0 mm, 0 mm, 0 mm]"),
    DIRECTION(normal, "Direction towards the grains.", "0 0 1"),
    SURFACE_ROW,
};
static const clod_table PLANE_TABLE = {.title = "An endless plane.", CLOD_ROWS(PLANE)};

static const clod_param DISC[] = {
    POSITION("center", point, "Centre.", "[0 mm, 0 mm, 40 mm]"),
    DIRECTION(normal, "Direction towards the grains.", "0 0 1"),
    LENGTH(radius, "Radius.", "100 mm"),
    SURFACE_ROW,
};
static const clod_table DISC_TABLE = {.title = "A flat disc.", CLOD_ROWS(DISC)};

static const clod_param ANNULUS[] = {
    POSITION("center", point, "Centre.", "[0 mm, 0 mm, 40 mm]"),
    DIRECTION(normal, "Direction towards the grains.", "0 0 1"),
    LENGTH(inner_radius, "Radius of the hole.", "50 mm"),
    LENGTH(outer_radius, "Outer radius.", "100 mm"),
    SURFACE_ROW,
};
static const clod_table ANNULUS_TABLE = {.title = "A flat ring.", CLOD_ROWS(ANNULUS)};

static const clod_param CYLINDER[] = {
    POSITION("foot", point, "Foot of the axis, where the cylinder begins.",
             "[0 mm, 0 mm, 0 mm]"),
    DIRECTION(axis, "Direction of the axis.", "0 0 1"),
    LENGTH(radius, "Radius.", "100 mm"),
    LENGTH(length, "Length along the axis.", "60 mm"),
    SIDE,
    SURFACE_ROW,
};
static const clod_table CYLINDER_TABLE = {.title = "The shell of a cylinder.",
                                          CLOD_ROWS(CYLINDER)};

static const clod_param CONE[] = {
    POSITION("foot", point, "Foot of the axis, where the cone begins.", "[0 mm, 0 mm, 0 mm]"),
    DIRECTION(axis, "Direction of the axis.", "0 0 1"),
    RADIUS(foot_radius, "Radius at the foot; 0 is a tip.", "20 mm"),
    RADIUS(top_radius, "Radius at the other end of the axis; 0 is a tip.", "100 mm"),
    LENGTH(length, "Length along the axis.", "150 mm"),
    SIDE,
    SURFACE_ROW,
};
static const clod_table CONE_TABLE = {
    .title = "The shell of a cone with two rims, or with a rim and a tip.", CLOD_ROWS(CONE)};

static const clod_param BOX[] = {
    POSITION("center", point, "Centre.", "[0 mm, 0 mm, 5 mm]"),
    {.key = "size",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "[20 mm, 20 mm, 10 mm]",
     CLOD_AT(S, size),
     .help = "Edge lengths along x, y, z; grains are outside.",
     .source = "convention"},
    SURFACE_ROW,
};
static const clod_table BOX_TABLE = {.title = "A solid box along x, y, z.", CLOD_ROWS(BOX)};

static const clod_param BAR[] = {
    POSITION("from", from, "One end of the centre line.", "[50 mm, 0 mm, 3 mm]"),
    POSITION("to", to, "The other end of the centre line.", "[100 mm, 0 mm, 3 mm]"),
    LENGTH(width, "Thickness across.", "3 mm"),
    LENGTH(height, "Height along up, half on each side of the centre line.", "6.35 mm"),
    DIRECTION(up, "Direction of the height.", "0 0 1"),
    SURFACE_ROW,
};
static const clod_table BAR_TABLE = {.title = "A straight bar with four sides and two ends.",
                                     CLOD_ROWS(BAR)};

static const clod_param MESH[] = {
    {.key = "file",
     .kind = CLOD_PARAM_FILE,
     .need = CLOD_PARAM_REQUIRED,
     .example = "chute.stl",
     CLOD_AT(S, file),
     .help = "Triangle mesh: .stl, .obj or .ply (clod mesh FILE says what is in it).",
     .source = "docs/meshes.md"},
    {.key = "unit",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e6),
     .example = "1 mm",
     .bare_unit = true,
     CLOD_AT(S, unit),
     .help =
         "What one unit of the file is, mm or 25.4 mm for instance; mesh files do not say it.",
     .source = "docs/meshes.md"},
    {.key = "scale",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, 1e6),
     .fallback = "1",
     CLOD_AT(S, scale),
     .help = "Factor of the numbers of the file.",
     .source = "docs/meshes.md"},
    {.key = "rotate",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &CLOD_TABLE_ROTATION,
     CLOD_AT(S, rotate),
     .used = mesh_turns,
     .help = "Turns the scaled mesh.",
     .source = "docs/meshes.md"},
    {.key = "move",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 0 0 m",
     CLOD_AT(S, move),
     .help = "Shifts the mesh, after rotate.",
     .source = "docs/meshes.md"},
    {.key = "smooth_angle",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad",
     CLOD_ABOVE(0, 60 * CLOD_UNIT_DEGREE),
     .fallback = "20 deg",
     CLOD_AT(S, smooth_angle),
     .help = "Facets that bend by less are one smooth surface, on which a grain has one "
             "contact; at sharper bends inwards each side pushes.",
     .source = "docs/adr/0033-contacts-with-meshes.md"},
    SURFACE_ROW,
    {.key = "parts",
     .kind = CLOD_PARAM_MAP,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &SURFACE_TABLE,
     .any_name = true,
     CLOD_AT(S, parts),
     CLOD_COUNT(S, part_count),
     .help =
         "Parts of the file by their names (clod mesh FILE lists them; in quotes where YAML "
         "needs them), each with material and motion of its own in place of surface; "
         "without material that of surface, else of the wall.",
     .source = "docs/meshes.md"},
};
static const clod_table MESH_TABLE = {.title = "A triangle mesh; grains touch both sides.",
                                      CLOD_ROWS(MESH)};

#define SHAPE(name, sub, field_help)                                                           \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_SECTION, .need = CLOD_PARAM_OPTIONAL, .table = &(sub), \
        .help = field_help, .source = "convention"                                             \
    }

static const clod_param SHAPES[CLOD_SHAPE_KINDS] = {
    [CLOD_SHAPE_PLANE] = SHAPE("plane", PLANE_TABLE, "An endless plane."),
    [CLOD_SHAPE_DISC] = SHAPE("disc", DISC_TABLE, "A flat disc."),
    [CLOD_SHAPE_ANNULUS] = SHAPE("annulus", ANNULUS_TABLE, "A flat ring."),
    [CLOD_SHAPE_CYLINDER] = SHAPE("cylinder", CYLINDER_TABLE, "The shell of a cylinder."),
    [CLOD_SHAPE_CONE] =
        SHAPE("cone", CONE_TABLE, "The shell of a cone, whole or cut off: a hopper."),
    [CLOD_SHAPE_BOX] = SHAPE("box", BOX_TABLE, "A solid box along x, y, z."),
    [CLOD_SHAPE_BAR] = SHAPE("bar", BAR_TABLE, "A straight bar."),
    [CLOD_SHAPE_MESH] = SHAPE("mesh", MESH_TABLE, "A triangle mesh from a file."),
    [CLOD_SHAPE_CONVEYOR] = {.key = "belt",
                             .kind = CLOD_PARAM_SECTION,
                             .need = CLOD_PARAM_OPTIONAL,
                             .table = &CLOD_TABLE_BELT,
                             CLOD_AT(S, belt),
                             .help = "A conveyor belt, flat or troughed.",
                             .source = "docs/belts.md"},
};
const clod_table CLOD_TABLE_SHAPE = {.title = "One surface: one of these.",
                                     CLOD_ROWS(SHAPES),
                                     .size = sizeof(S),
                                     .one_of = true,
                                     .kind = offsetof(S, kind)};
