#include "config/unit.h"

#include <ctype.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <udunits2.h>

#include "config/suggest.h"

#define LONGEST_UNIT 48
#define WEIGHT (2 * LONGEST_UNIT) ///< bytes: gcc cannot see that one more is enough

static const clod_unit_kind KINDS[] = {
    {"1", "a number", "number", "%"},
    {"Pa", "a pressure", "pressure", "kPa"},
    {"m", "a length", "length", "mm"},
    {"m2", "an area", "area", "cm2"},
    {"m3", "a volume", "volume", "m3"},
    {"m3/s", "a volume flow", "volume_flow", "m3/s"},
    {"s", "a time", "time", "ms"},
    {"m/s", "a speed", "speed", "mm/s"},
    {"m/s2", "an acceleration", "acceleration", "m/s2"},
    {"kg", "a mass", "mass", "kg"},
    {"kg/s", "a mass flow", "mass_flow", "t/h"},
    {"kg/m3", "a density", "density", "kg/m3"},
    {"N", "a force", "force", "N"},
    {"rad", "an angle", "angle", "deg"},
    {"rad/s", "a speed of rotation", "rotation", "rpm"},
    {"Hz", "a frequency", "frequency", "Hz"},
    {"1/s", "a rate", "rate", "1/s"},
    {"J/m2", "a surface energy", "surface_energy", "mJ/m2"},
    {"J", "an energy", "energy", "mJ"},
    {"W", "a power", "power", "W"},
    {"N m", "a torque", "torque", "N m"},
    {"N/s", "a rate of force", "force_rate", "N/s"},
    {"N/m3", "a force in a volume", "force_density", "N/m3"},
    {"m2/s2", "a speed squared", "speed_squared", "m2/s2"},
};

static const char *const COMMON[] = {
    "Pa",     "kPa",   "MPa",    "GPa",  "bar",   "psi",   "m",    "mm",  "cm",
    "um",     "km",    "inch",   "ft",   "s",     "ms",    "us",   "min", "h",
    "kg",     "g",     "mg",     "t",    "lb",    "N",     "kN",   "mN",  "lbf",
    "m/s",    "mm/s",  "mm/min", "m/s2", "kg/m3", "g/cm3", "t/m3", "rad", "deg",
    "rad/s",  "deg/s", "rpm",    "m2",   "mm2",   "cm2",   "psf",  "pcf", "N/m2",
    "kN/m2",  "mbar",  "hPa",    "cm/s", "km/h",  "ft/s",  "dm",   "ns",  "minute",
    "degree", "J/m2",  "mJ/m2",  "J",    "mJ",    "W",     "kW"};

/** Words that make a unit one of rotation; without them Hz would pass for rad/s. */
static const char *const ANGLES[] = {"rad",  "mrad",  "radian", "radians",
                                     "deg",  "rpm",   "degree", "degrees",
                                     "turn", "turns", "rps",    "arc_degree"};

/** udunits keeps its status in global variables: one call at a time, over all threads. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
/** The unit database; read once, then only looked at, always under the lock. */
static ut_system *database;

const clod_unit_kind *clod_unit_describe(const char *unit)
{
    for (size_t i = 0; i < sizeof KINDS / sizeof KINDS[0]; i++) {
        if (strcmp(KINDS[i].unit, unit) == 0) {
            return &KINDS[i];
        }
    }
    return &KINDS[0];
}

const char *clod_unit_number(const char *text, double *value)
{
    const char *at = text + strspn(text, " ");
    const char *start = at;
    at += *at == '+' || *at == '-';
    const size_t whole = strspn(at, "0123456789");
    at += whole;
    size_t part = 0;
    if (*at == '.') {
        part = strspn(at + 1, "0123456789");
        at += part + 1;
    }
    if (whole + part == 0) {
        return NULL;
    }
    if (*at == 'e' || *at == 'E') {
        const char *digits = at + 1;
        digits += *digits == '+' || *digits == '-';
        const size_t count = strspn(digits, "0123456789");
        at = count == 0 ? at : digits + count;
    }
    char digits[64];
    const size_t length = (size_t)(at - start);
    if (length >= sizeof digits) {
        return NULL;
    }
    memcpy(digits, start, length);
    digits[length] = '\0';
    *value = strtod(digits, NULL);
    return isfinite(*value) ? at + strspn(at, " ") : NULL;
}

/** Spellings of the keyboard and of typesetting -> what udunits reads. */
static bool normalise(const char *written, char unit[LONGEST_UNIT])
{
    static const char *const PAIRS[][2] = {{"²", "2"}, {"³", "3"}, {"·", "."},
                                           {"µ", "u"}, {"μ", "u"}, {"°", "deg"}};
    size_t used = 0;
    while (*written != '\0') {
        const char *text = NULL;
        size_t step = 1;
        for (size_t i = 0; i < sizeof PAIRS / sizeof PAIRS[0] && text == NULL; i++) {
            const size_t length = strlen(PAIRS[i][0]);
            if (strncmp(written, PAIRS[i][0], length) == 0) {
                text = PAIRS[i][1];
                step = length;
            }
        }
        const size_t length = text == NULL ? 1 : strlen(text);
        if (used + length >= LONGEST_UNIT) {
            return false;
        }
        memcpy(unit + used, text == NULL ? written : text, length);
        used += length;
        written += step;
    }
    while (used > 0 && unit[used - 1] == ' ') {
        used--;
    }
    unit[used] = '\0';
    return true;
}

/** One factor of a unit: letters, then perhaps a whole exponent; NULL when it is none. */
static const char *skip_term(const char *at)
{
    if (*at == '%') {
        return at + 1;
    }
    const char *start = at;
    while (isalpha((unsigned char)*at) || *at == '_') {
        at++;
    }
    if (at == start) {
        return NULL;
    }
    if (*at == '^' || *at == '-' || isdigit((unsigned char)*at)) {
        at += *at == '^';
        at += *at == '-';
        if (*at < '1' || *at > '9') {
            return NULL;
        }
        at++;
    }
    return at;
}

/** The whitelist: factors with whole exponents, joined by blank, dot, star or slash. */
static bool well_formed(const char *unit)
{
    for (const char *at = skip_term(unit); at != NULL; at = skip_term(at)) {
        if (*at == '\0') {
            return true;
        }
        const char *before = at;
        at += strspn(at, " ");
        at += *at == '.' || *at == '*' || *at == '/';
        at += strspn(at, " ");
        if (at == before) {
            return false;
        }
    }
    return false;
}

/** Next word of letters in a unit, or false at its end. */
static bool next_word(const char **at, char word[LONGEST_UNIT])
{
    while (**at != '\0' && !isalpha((unsigned char)**at)) {
        (*at)++;
    }
    size_t length = 0;
    while (isalpha((unsigned char)(*at)[length]) || (*at)[length] == '_') {
        length++;
    }
    memcpy(word, *at, length);
    word[length] = '\0';
    *at += length;
    return length > 0;
}

static bool is_angular(const char *unit)
{
    char word[LONGEST_UNIT];
    while (next_word(&unit, word)) {
        for (size_t i = 0; i < sizeof ANGLES / sizeof ANGLES[0]; i++) {
            if (strcmp(word, ANGLES[i]) == 0) {
                return true;
            }
        }
    }
    return false;
}

/** "ton", "tons", "kton": short tons to udunits, something else to most of its users. */
static bool has_ton(const char *unit)
{
    char word[LONGEST_UNIT];
    while (next_word(&unit, word)) {
        size_t length = strlen(word);
        length -= length > 0 && word[length - 1] == 's';
        const bool ton = length >= 3 && strncmp(word + length - 3, "ton", 3) == 0;
        if (ton && strchr(word, '_') == NULL && strstr(word, "ewton") == NULL) {
            return true;
        }
    }
    return false;
}

static void add_name(const char *name, double factor, const char *of)
{
    ut_unit *base = ut_parse(database, of, UT_ASCII);
    ut_unit *unit = base == NULL ? NULL : ut_scale(factor, base);
    if (unit != NULL) {
        ut_map_name_to_unit(name, UT_ASCII, unit);
    }
    ut_free(unit);
    ut_free(base);
}

static bool open_database(void)
{
    if (database == NULL) {
        ut_set_error_message_handler(ut_ignore);
        database = ut_read_xml(NULL);
        if (database != NULL) {
            add_name("deg", CLOD_UNIT_DEGREE, "radian");
            add_name("psf", 1.0, "lbf/ft^2");
            add_name("pcf", 1.0, "lb/ft^3");
            add_name("kp", 1.0, "kgf");
        }
    }
    return database != NULL;
}

typedef enum outcome { CONVERTED, NO_DATABASE, UNKNOWN_UNIT, OTHER_KIND } outcome;

/** Multiply by the factor; a factor such as 0.001 is a division, so that 6.35 mm is 0.00635 m.
 */
static double scaled(double value, double factor)
{
    const double inverse = round(1.0 / factor);
    if (factor < 1.0 && fabs(inverse * factor - 1.0) < 1e-14) {
        return value / inverse;
    }
    return value * factor;
}

static outcome convert_locked(const char *from, const char *to, double *value)
{
    if (!open_database()) {
        return NO_DATABASE;
    }
    ut_unit *source = ut_parse(database, from, UT_ASCII);
    ut_unit *target = ut_parse(database, to, UT_ASCII);
    outcome result = source == NULL || target == NULL ? UNKNOWN_UNIT : OTHER_KIND;
    if (result == OTHER_KIND && ut_are_convertible(source, target)) {
        cv_converter *converter = ut_get_converter(source, target);
        // every unit of the tables is a plain multiple: degC and dB, with offsets, are not
        if (converter != NULL && cv_convert_double(converter, 0.0) == 0.0) {
            *value = scaled(*value, cv_convert_double(converter, 1.0));
            result = CONVERTED;
        }
        cv_free(converter);
    }
    ut_free(source);
    ut_free(target);
    return result;
}

static bool fail_unknown(const char *written, char *message)
{
    char hint[64];
    clod_suggest near = clod_suggest_start(written);
    for (size_t i = 0; i < sizeof COMMON / sizeof COMMON[0]; i++) {
        clod_suggest_offer(&near, COMMON[i]);
    }
    snprintf(message, CLOD_UNIT_MESSAGE, "unit \"%s\" is not known%s", written,
             clod_suggest_text(&near, hint, sizeof hint));
    return false;
}

static bool convert_number(const char *unit, double *value, char *message)
{
    if (unit[0] == '\0') {
        return true;
    }
    if (strcmp(unit, "%") == 0) {
        *value /= 100.0;
        return true;
    }
    snprintf(message, CLOD_UNIT_MESSAGE, "takes a pure number or %%, not the unit \"%s\"",
             unit);
    return false;
}

static bool fail_kind(const char *written, const clod_unit_kind *kind, double value,
                      char *message)
{
    if (written[0] == '\0') {
        snprintf(message, CLOD_UNIT_MESSAGE, "%.10g needs a unit of %s, for instance %.10g %s",
                 value, kind->of, value, kind->example);
    } else {
        snprintf(message, CLOD_UNIT_MESSAGE, "%.10g %s is not %s; use a unit such as %s", value,
                 written, kind->noun, kind->example);
    }
    return false;
}

/** A mass on an area in place of its weight: g/cm2 for gf/cm2; "": `written` is none, or its mass does not come first. */
static void find_weight(const char *written, char weight[WEIGHT])
{
    size_t mass = 0;
    while (isalpha((unsigned char)written[mass])) {
        mass++;
    }
    double one = 1.0;
    snprintf(weight, WEIGHT, "%.*sf%s", (int)mass, written, written + mass);
    pthread_mutex_lock(&lock);
    const bool found = convert_locked(written, "kg/m2", &one) == CONVERTED &&
                       convert_locked(weight, "Pa", &one) == CONVERTED;
    pthread_mutex_unlock(&lock);
    weight[found ? strlen(weight) : 0] = '\0';
}

/** Units that go together and are not of the kind that is asked for. */
static bool fail_other(const char *written, const clod_unit_kind *kind, double value,
                       char *message)
{
    char weight[WEIGHT] = "";
    if (strcmp(kind->unit, "Pa") == 0) {
        find_weight(written, weight);
    }
    if (weight[0] == '\0') {
        return fail_kind(written, kind, value, message);
    }
    snprintf(message, CLOD_UNIT_MESSAGE,
             "%.10g %s is a mass on an area, not a pressure; its weight on it is %.10g %s",
             value, written, value, weight);
    return false;
}

bool clod_unit_convert(const char *written, const char *unit, double *value,
                       char message[CLOD_UNIT_MESSAGE])
{
    return clod_unit_convert_like(written, unit, NULL, value, message);
}

bool clod_unit_convert_like(const char *written, const char *unit, const char *example,
                            double *value, char message[CLOD_UNIT_MESSAGE])
{
    clod_unit_kind own = *clod_unit_describe(unit);
    const clod_unit_kind *kind = &own;
    own.example = example != NULL ? example : own.example;
    char clean[LONGEST_UNIT];
    if (written[0] == ',') {
        snprintf(message, CLOD_UNIT_MESSAGE, "write the decimal point as a point, not a comma");
        return false;
    }
    if (!normalise(written, clean)) {
        snprintf(message, CLOD_UNIT_MESSAGE, "the unit is too long to be one");
        return false;
    }
    if (strcmp(unit, "1") == 0) {
        return convert_number(clean, value, message);
    }
    if (clean[0] == '\0' || strcmp(clean, "%") == 0) {
        return *value == 0.0 || fail_kind(clean, kind, *value, message);
    }
    if (strcmp(clean, unit) == 0) {
        return true;
    }
    if (!well_formed(clean)) {
        snprintf(message, CLOD_UNIT_MESSAGE,
                 "\"%s\" is not a unit; write one like %s, with whole exponents", clean,
                 kind->example);
        return false;
    }
    if (has_ton(clean)) {
        snprintf(message, CLOD_UNIT_MESSAGE,
                 "\"ton\" means different masses; write t (1000 kg) or short_ton (907.18 kg)");
        return false;
    }
    const bool angle = strncmp(unit, "rad", 3) == 0;
    if (angle != is_angular(clean)) {
        return fail_kind(clean, kind, *value, message);
    }
    double si = *value;
    pthread_mutex_lock(&lock);
    const outcome result = convert_locked(clean, unit, &si);
    pthread_mutex_unlock(&lock);
    switch (result) {
    case CONVERTED:
        if (!isfinite(si)) {
            snprintf(message, CLOD_UNIT_MESSAGE, "%.10g %s is too large a number", *value,
                     clean);
            return false;
        }
        *value = si;
        return true;
    case NO_DATABASE:
        snprintf(message, CLOD_UNIT_MESSAGE,
                 "the unit database of UDUNITS-2 is missing; install libudunits2-data");
        return false;
    case UNKNOWN_UNIT:
        return fail_unknown(clean, message);
    default:
        return fail_other(clean, kind, *value, message);
    }
}
