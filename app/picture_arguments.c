#include "picture_arguments.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define SMALLEST 200
#define LARGEST 8192

int clod_app_picture_name(const char *name, const char *const *list, int count)
{
    for (int k = 0; k < count; k++) {
        if (strcmp(name, list[k]) == 0) {
            return k;
        }
    }
    return -1;
}

int clod_app_picture_whole(const char **text, char end, int most)
{
    char *rest;
    const long number = strtol(*text, &rest, 10);
    if (rest == *text || *rest != end || number < 1 || number > most) {
        return -1;
    }
    *text = rest + 1;
    return (int)number;
}

void clod_app_picture_size(struct argp_state *state, const char *text, int *width, int *height)
{
    const char *rest = text;
    *width = clod_app_picture_whole(&rest, 'x', LARGEST);
    *height = *width > 0 ? clod_app_picture_whole(&rest, '\0', LARGEST) : -1;
    if (*width < SMALLEST || *height < SMALLEST) {
        argp_error(state,
                   "--size %s: width and height from %d to %d pixels are needed, as in "
                   "1600x1000",
                   text, SMALLEST, LARGEST);
    }
}

void clod_app_picture_view(struct argp_state *state, const char *text, int *view)
{
    static const char *const VIEWS[] = {"oblique", "front", "side", "top"};
    *view = clod_app_picture_name(text, VIEWS, 4);
    if (*view < 0) {
        argp_error(state, "--view %s: oblique, front, side or top is needed", text);
    }
}

void clod_app_picture_png(struct argp_state *state, const char *option, const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash != NULL ? slash : path, '.');
    if (dot != NULL && strcasecmp(dot, ".png") != 0) {
        argp_error(state, "%s %s: pictures are PNG; let the name end in .png", option, path);
    }
}
