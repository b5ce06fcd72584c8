#include "report/packed.h"

#include <math.h>

#include "base/memory.h"
#include "report/figure_json.h"

void clod_packed_base64(FILE *out, const unsigned char *bytes, size_t count)
{
    static const char LETTERS[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < count; i += 3) {
        const size_t left = count - i;
        const unsigned long word = (unsigned long)bytes[i] << 16 |
                                   (left > 1 ? (unsigned long)bytes[i + 1] << 8 : 0) |
                                   (left > 2 ? (unsigned long)bytes[i + 2] : 0);
        char text[4] = {LETTERS[word >> 18], LETTERS[word >> 12 & 63], '=', '='};
        if (left > 1) {
            text[2] = LETTERS[word >> 6 & 63];
        }
        if (left > 2) {
            text[3] = LETTERS[word & 63];
        }
        fwrite(text, 1, sizeof text, out);
    }
}

bool clod_packed_numbers(FILE *out, const double *value, size_t count, size_t stride)
{
    double min = HUGE_VAL;
    double max = -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        const double v = value[i * stride];
        min = isfinite(v) ? fmin(min, v) : min;
        max = isfinite(v) ? fmax(max, v) : max;
    }
    fputs("{\"min\":", out);
    clod_figure_json_number(out, min);
    fputs(",\"max\":", out);
    clod_figure_json_number(out, max);
    unsigned char *bytes = max > min ? clod_memory_alloc(count, 2) : NULL;
    if (bytes != NULL) {
        for (size_t i = 0; i < count; i++) {
            const double v = value[i * stride];
            const long word = isfinite(v) ? lround(65535.0 * ((v - min) / (max - min))) : 0;
            bytes[2 * i] = (unsigned char)(word & 255);
            bytes[2 * i + 1] = (unsigned char)(word >> 8);
        }
        fputs(",\"data\":\"", out);
        clod_packed_base64(out, bytes, 2 * count);
        fputs("\"", out);
    }
    fputs("}", out);
    clod_memory_free(bytes);
    return bytes != NULL || !(max > min);
}
