/**
 * @file measured_header.c
 * The header of a measured table: its columns, and which stresses they are.
 */

#include "analysis/measured_header.h"

#include <ctype.h>
#include <stdint.h>
#include <string.h>

#include "base/given.h"
#include "base/input.h"
#include "base/memory.h"

/** The first line that is neither empty nor a comment, cut to its names, in small letters: the
 *  reader of its kind tells of capital ones. */
static void find_header(const char *text, size_t length, char header[CLOD_MEASURED_HEADER])
{
    size_t at = 0;
    header[0] = '\0';
    while (at < length && header[0] == '\0') {
        const char *end = memchr(text + at, '\n', length - at);
        const size_t line = end != NULL ? (size_t)(end - (text + at)) : length - at;
        const size_t taken = line < CLOD_MEASURED_HEADER - 1 ? line : CLOD_MEASURED_HEADER - 1;
        memcpy(header, text + at, taken);
        header[taken] = '\0';
        for (size_t k = 0; k < taken; k++) {
            header[k] = (char)tolower((unsigned char)header[k]);
        }
        const size_t blank = strspn(header, " \t\r");
        if (header[blank] == '\0' || header[blank] == '#') {
            header[0] = '\0';
        }
        at += line + 1;
    }
}

bool clod_measured_header_has(const char *header, const char *name)
{
    static const char ENDS[] = ",;\t \"[\r";
    const size_t length = strlen(name);
    for (const char *at = header; (at = strstr(at, name)) != NULL; at += length) {
        const bool begins = at == header || strchr(ENDS, at[-1]) != NULL;
        const bool ends = at[length] == '\0' || strchr(ENDS, at[length]) != NULL;
        if (begins && ends) {
            return true;
        }
    }
    return false;
}

void clod_measured_header_of(const char *text, size_t length, char header[CLOD_MEASURED_HEADER])
{
    const size_t mark = length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    find_header(text + mark, length - mark, header);
}

bool clod_measured_has(const char *text, size_t length, const char *name)
{
    char header[CLOD_MEASURED_HEADER];
    clod_measured_header_of(text, length, header);
    return clod_measured_header_has(header, name);
}

bool clod_measured_header_is_wall(const char *header)
{
    return clod_measured_header_has(header, "sigma_w") ||
           clod_measured_header_has(header, "tau_w");
}

/** Whether such a header has one of these columns, ended by NULL. */
static bool has_any(const char *header, const char *const *names)
{
    while (*names != NULL && !clod_measured_header_has(header, *names)) {
        names++;
    }
    return *names != NULL;
}

/** Bulk densities as laboratories print them, over the normal stress of preshear. */
static bool is_density_of_preshear(const char *header)
{
    static const char *const PRESHEAR[] = {"sigma_pre", "sigma_p", NULL};
    static const char *const DENSITY[] = {"rho_b", "rho", NULL};
    static const char *const OTHERS[] = {"sigma_sh", "sigma_s", "sigma", "tau_sh",  "tau_s",
                                         "tau",      "tau_pre", "tau_p", "sigma_1", NULL};
    return has_any(header, PRESHEAR) && has_any(header, DENSITY) && !has_any(header, OTHERS);
}

clod_measured_stress clod_measured_stress_of(const char *text, size_t length)
{
    static const char *const SHEAR[] = {"sigma_sh", "sigma_s",   "sigma",   "tau_sh", "tau_s",
                                        "tau",      "sigma_pre", "tau_pre", NULL};
    char header[CLOD_MEASURED_HEADER];
    CLOD_NEED(text);
    clod_measured_header_of(text, length, header);
    if (clod_measured_header_is_wall(header)) {
        return CLOD_MEASURED_OF_WALL;
    }
    if (is_density_of_preshear(header)) {
        return CLOD_MEASURED_OF_PRESHEAR;
    }
    if (has_any(header, SHEAR)) {
        return CLOD_MEASURED_OF_SHEAR;
    }
    return clod_measured_header_has(header, "sigma_1")           ? CLOD_MEASURED_OF_SIGMA_1
           : clod_measured_header_has(header, "angle_of_repose") ? CLOD_MEASURED_OF_REPOSE
                                                                 : CLOD_MEASURED_OF_NONE;
}

const char *const CLOD_MEASURED_STRESS_NAMES[] = {
    [CLOD_MEASURED_OF_SHEAR] = "shear points (sigma_pre, tau_pre, sigma_sh, tau_sh)",
    [CLOD_MEASURED_OF_WALL] = "wall friction (sigma_w, tau_w)",
    [CLOD_MEASURED_OF_SIGMA_1] = "a flow function or bulk densities (sigma_1)",
    [CLOD_MEASURED_OF_REPOSE] = "angles of repose (angle_of_repose)",
    [CLOD_MEASURED_OF_PRESHEAR] = "bulk densities over the preshear stress (sigma_pre, rho_b)"};

bool clod_measured_header_check(const char *path, clod_measured_stress found,
                                clod_status *status)
{
    return found != CLOD_MEASURED_OF_PRESHEAR ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: is a table of %s. A table of bulk densities needs sigma_1, the major "
               "principal stress of consolidation, in place of sigma_pre: that of the yield "
               "locus at this preshear stress, which clod locus prints for its shear points. Or "
               "put rho_b as a column into the table of shear points.",
               path, CLOD_MEASURED_STRESS_NAMES[found]);
}

clod_measured_stress clod_measured_stress_in(const char *path)
{
    char *text;
    size_t length;
    clod_status ignored = {0};
    if (!clod_input_read_regular(path, SIZE_MAX, &text, &length, &ignored)) {
        return CLOD_MEASURED_OF_NONE;
    }
    const clod_measured_stress found = clod_measured_stress_of(text, length);
    clod_memory_free(text);
    return found;
}
