#include "output/paraview.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "output/file.h"
#include "output/folder_files.h"

/** Numbers of the proxies: any that differ. */
enum {
    GRAINS = 1001,
    WALLS,
    CONTACTS,
    GRAINS_SHOWN = 1011, ///< representations
    WALLS_SHOWN,
    CONTACTS_SHOWN,
    VELOCITY = 1021, ///< colours
    PRESSURE,
    VELOCITY_OPACITY = 1031,
    PRESSURE_OPACITY,
    VELOCITY_BAR = 1041,
    PRESSURE_BAR,
    VIEW = 1051,
    TIMES
};

/** Numbers of the servers that have a proxy, as ParaView writes them. */
enum { DATA_SERVER = 1, CLIENT = 16, ALL_SERVERS = 21 };

/** From the middle, in radii of the ball about the box: the camera sees 15 degrees to each side. */
#define CAMERA_DISTANCE 3.0

clod_paraview clod_paraview_begin(double time)
{
    return (clod_paraview){.low = {INFINITY, INFINITY, INFINITY},
                           .high = {-INFINITY, -INFINITY, -INFINITY},
                           .time = time};
}

void clod_paraview_add(clod_paraview *self, const double p[3], double radius)
{
    for (int a = 0; a < 3; a++) {
        self->low[a] = fmin(self->low[a], p[a] - radius);
        self->high[a] = fmax(self->high[a], p[a] + radius);
    }
}

// ---- properties of a proxy

static void put_escaped(FILE *to, const char *text)
{
    for (; *text != '\0'; text++) {
        if (strchr("&<>\"'", *text) != NULL) {
            fprintf(to, "&#%d;", *text);
        } else {
            fputc(*text, to);
        }
    }
}

static void put_texts(FILE *to, int proxy, const char *name, int count,
                      const char *const *values)
{
    fprintf(to, "      <Property name=\"%s\" id=\"%d.%s\" number_of_elements=\"%d\">", name,
            proxy, name, count);
    for (int k = 0; k < count; k++) {
        fprintf(to, "<Element index=\"%d\" value=\"", k);
        put_escaped(to, values[k]);
        fputs("\"/>", to);
    }
    fputs("</Property>\n", to);
}

static void put_text(FILE *to, int proxy, const char *name, const char *value)
{
    put_texts(to, proxy, name, 1, &value);
}

static void put_numbers(FILE *to, int proxy, const char *name, int count, const double *values)
{
    enum { MOST = 12 };
    char text[MOST][32];
    const char *texts[MOST];
    for (int k = 0; k < count; k++) {
        snprintf(text[k], sizeof text[k], "%.9g", values[k]);
        texts[k] = text[k];
    }
    put_texts(to, proxy, name, count, texts);
}

static void put_number(FILE *to, int proxy, const char *name, double value)
{
    put_numbers(to, proxy, name, 1, &value);
}

static void put_proxies(FILE *to, int proxy, const char *name, int count, const int *others)
{
    fprintf(to, "      <Property name=\"%s\" id=\"%d.%s\" number_of_elements=\"%d\">", name,
            proxy, name, count);
    for (int k = 0; k < count; k++) {
        fprintf(to, "<Proxy value=\"%d\"/>", others[k]);
    }
    fputs("</Property>\n", to);
}

/** An array of points ("0") or cells ("1"). */
static void put_array(FILE *to, int proxy, const char *name, const char *of, const char *array)
{
    put_texts(to, proxy, name, 5, (const char *const[]){"", "", "", of, array});
}

static void begin_proxy(FILE *to, const char *group, const char *type, int id, int servers)
{
    fprintf(to, "    <Proxy group=\"%s\" type=\"%s\" id=\"%d\" servers=\"%d\">\n", group, type,
            id, servers);
}

static void end_proxy(FILE *to)
{
    fputs("    </Proxy>\n", to);
}

// ---- the proxies

static void put_reader(FILE *to, int id, const char *folder, const char *stem, const char *kind)
{
    char path[PATH_MAX + NAME_MAX + 32];
    snprintf(path, sizeof path, "%s/%s%s.hdf.series", folder, stem, kind);
    begin_proxy(to, "sources", "HDFReader", id, DATA_SERVER);
    put_text(to, id, "FileName", path);
    end_proxy(to);
}

/** Colours from blue to red over 0 to `most`, which grow with what comes. */
static void put_colours(FILE *to, int id, int opacity, double most)
{
    const double top = most > 0.0 ? most : 1.0;
    const double colours[] = {0.0,      0.231373, 0.298039, 0.752941, 0.5 * top, 0.865003,
                              0.865003, 0.865003, top,      0.705882, 0.0156863, 0.14902};
    const double opaque[] = {0.0, 0.0, 0.5, 0.0, top, 1.0, 0.5, 0.0};
    enum { DIVERGING = 3, GROW_EVERY_TIME_STEP = 1 };
    begin_proxy(to, "piecewise_functions", "PiecewiseFunction", opacity, ALL_SERVERS);
    put_numbers(to, opacity, "Points", 8, opaque);
    end_proxy(to);
    begin_proxy(to, "lookup_tables", "PVLookupTable", id, ALL_SERVERS);
    put_numbers(to, id, "RGBPoints", 12, colours);
    put_number(to, id, "ColorSpace", DIVERGING);
    put_number(to, id, "AutomaticRescaleRangeMode", GROW_EVERY_TIME_STEP);
    put_number(to, id, "ScalarRangeInitialized", 1);
    put_proxies(to, id, "ScalarOpacityFunction", 1, &opacity);
    end_proxy(to);
}

static void begin_shown(FILE *to, int id, int reader, const char *as, bool visible)
{
    begin_proxy(to, "representations", "UnstructuredGridRepresentation", id, ALL_SERVERS);
    fprintf(to,
            "      <Property name=\"Input\" id=\"%d.Input\" number_of_elements=\"1\">"
            "<Proxy value=\"%d\" output_port=\"0\"/></Property>\n",
            id, reader);
    put_text(to, id, "Representation", as);
    put_number(to, id, "Visibility", visible ? 1 : 0);
}

static void put_grains_shown(FILE *to)
{
    const int id = GRAINS_SHOWN, colours = VELOCITY;
    begin_shown(to, id, GRAINS, "Point Gaussian", true);
    put_number(to, id, "GaussianRadius", 1);
    put_number(to, id, "ScaleByArray", 1);
    put_number(to, id, "UseScaleFunction", 0);
    put_array(to, id, "SetScaleArray", "0", "radius");
    put_text(to, id, "ShaderPreset", "Sphere");
    put_array(to, id, "ColorArrayName", "0", "velocity");
    put_proxies(to, id, "LookupTable", 1, &colours);
    end_proxy(to);
}

static void put_walls_shown(FILE *to, bool wears)
{
    const int id = WALLS_SHOWN, colours = PRESSURE;
    begin_shown(to, id, WALLS, "Surface", true);
    put_number(to, id, "Opacity", 0.35);
    if (wears) {
        put_array(to, id, "ColorArrayName", "1", "pressure");
        put_proxies(to, id, "LookupTable", 1, &colours);
    }
    end_proxy(to);
}

static void put_bar(FILE *to, int id, int colours, const char *title, double height)
{
    enum { ANY_PLACE = 0 };
    begin_proxy(to, "representations", "ScalarBarWidgetRepresentation", id, ALL_SERVERS);
    put_proxies(to, id, "LookupTable", 1, &colours);
    put_text(to, id, "Title", title);
    put_text(to, id, "ComponentTitle", "");
    put_number(to, id, "Enabled", 1);
    put_number(to, id, "Visibility", 1);
    put_number(to, id, "WindowLocation", ANY_PLACE);
    put_numbers(to, id, "Position", 2, (const double[]){0.86, height});
    end_proxy(to);
}

/** Where the camera is: it sees the ball about the box, aslant from the front and above. */
static void put_camera(FILE *to, const clod_paraview *self)
{
    static const double FROM[] = {0.33, -0.87, 0.36}; // of about length 1
    double middle[3], camera[3], square = 0.0;
    for (int a = 0; a < 3; a++) {
        const bool some = self->low[a] <= self->high[a];
        const double size = some ? self->high[a] - self->low[a] : 1.0;
        middle[a] = some ? 0.5 * (self->low[a] + self->high[a]) : 0.0;
        square += size * size;
    }
    for (int a = 0; a < 3; a++) {
        camera[a] = middle[a] + 0.5 * sqrt(square) * CAMERA_DISTANCE * FROM[a];
    }
    put_numbers(to, VIEW, "CameraPosition", 3, camera);
    put_numbers(to, VIEW, "CameraFocalPoint", 3, middle);
    put_numbers(to, VIEW, "CenterOfRotation", 3, middle);
    put_numbers(to, VIEW, "CameraViewUp", 3, (const double[]){0, 0, 1});
}

static void put_view(FILE *to, const clod_paraview *self)
{
    int shown[5] = {GRAINS_SHOWN, WALLS_SHOWN, VELOCITY_BAR}, count = 3;
    const int timed[] = {GRAINS, WALLS, CONTACTS}, view = VIEW;
    if (self->wears) {
        shown[count++] = PRESSURE_BAR;
    }
    if (self->contacts) {
        shown[count++] = CONTACTS_SHOWN;
    }
    begin_proxy(to, "views", "RenderView", VIEW, ALL_SERVERS);
    put_proxies(to, VIEW, "Representations", count, shown);
    put_camera(to, self);
    end_proxy(to);
    begin_proxy(to, "misc", "TimeKeeper", TIMES, CLIENT);
    put_proxies(to, TIMES, "TimeSources", self->contacts ? 3 : 2, timed);
    put_proxies(to, TIMES, "Views", 1, &view);
    put_number(to, TIMES, "Time", self->time);
    end_proxy(to);
}

/** What is known to the window under which name: ids and names, in turn. */
typedef struct item {
    const char *collection, *name;
    int id;
    bool there;
} item;

static void put_collections(FILE *to, const clod_paraview *self)
{
    const bool wears = self->wears, contacts = self->contacts;
    const item items[] = {
        {"sources", "grains", GRAINS, true},
        {"sources", "walls", WALLS, true},
        {"sources", "contacts", CONTACTS, contacts},
        {"representations", "grains", GRAINS_SHOWN, true},
        {"representations", "walls", WALLS_SHOWN, true},
        {"representations", "contacts", CONTACTS_SHOWN, contacts},
        {"scalar_bars", "velocity", VELOCITY_BAR, true},
        {"scalar_bars", "pressure", PRESSURE_BAR, wears},
        {"lookup_tables", "velocity.PVLookupTable", VELOCITY, true},
        {"lookup_tables", "pressure.PVLookupTable", PRESSURE, wears},
        {"piecewise_functions", "velocity.PiecewiseFunction", VELOCITY_OPACITY, true},
        {"piecewise_functions", "pressure.PiecewiseFunction", PRESSURE_OPACITY, wears},
        {"views", "RenderView1", VIEW, true},
        {"timekeeper", "TimeKeeper1", TIMES, true},
    };
    const size_t count = sizeof items / sizeof *items;
    for (size_t k = 0; k < count; k++) {
        const char *name = items[k].collection;
        if (k == 0 || strcmp(name, items[k - 1].collection) != 0) {
            fprintf(to, "    <ProxyCollection name=\"%s\">\n", name);
        }
        if (items[k].there) {
            fprintf(to, "      <Item id=\"%d\" name=\"%s\"/>\n", items[k].id, items[k].name);
        }
        if (k + 1 == count || strcmp(name, items[k + 1].collection) != 0) {
            fputs("    </ProxyCollection>\n", to);
        }
    }
}

static void put_all(FILE *to, const clod_paraview *self, const char *folder, const char *stem)
{
    fputs("<GenericParaViewApplication>\n  <ServerManagerState version=\"5.11.0\">\n", to);
    put_reader(to, GRAINS, folder, stem, "");
    put_reader(to, WALLS, folder, stem, "_walls");
    put_colours(to, VELOCITY, VELOCITY_OPACITY, self->speed);
    put_grains_shown(to);
    put_bar(to, VELOCITY_BAR, VELOCITY, "velocity [m/s]", 0.05);
    put_walls_shown(to, self->wears);
    if (self->wears) {
        put_colours(to, PRESSURE, PRESSURE_OPACITY, self->pressure);
        put_bar(to, PRESSURE_BAR, PRESSURE, "pressure on walls [Pa]", 0.55);
    }
    if (self->contacts) {
        put_reader(to, CONTACTS, folder, stem, "_contacts");
        begin_shown(to, CONTACTS_SHOWN, CONTACTS, "Surface", false);
        end_proxy(to);
    }
    put_view(to, self);
    put_collections(to, self);
    fputs("  </ServerManagerState>\n</GenericParaViewApplication>\n", to);
}

bool clod_paraview_write(const clod_paraview *self, const clod_folder *folder, const char *stem,
                         clod_status *status)
{
    char name[NAME_MAX + 1];
    if ((size_t)snprintf(name, sizeof name, "%s.pvsm", stem) >= sizeof name) {
        return clod_file_fail(status, "name a state file", stem, ENAMETOOLONG);
    }
    char *path = realpath(folder->path, NULL);
    if (path == NULL) {
        return clod_file_fail(status, "find the folder", folder->path, errno);
    }
    clod_text whole;
    FILE *to = clod_text_open(&whole);
    if (to != NULL) {
        put_all(to, self, path, stem);
    }
    char *text = to != NULL ? clod_text_close(&whole) : NULL;
    const bool good = clod_folder_write(folder, name, text, status);
    clod_memory_free(text);
    free(path);
    return good;
}
