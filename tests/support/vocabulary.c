// Compiled once per instruction set, see tools/tests.cmake.
#include "vocabulary.h"

#include "geometry/wall_closest.h"
#include "simd/simd.h"

static vreal operate(vocabulary_operation operation, vreal a, vreal b, double first)
{
    switch (operation) {
    case OP_ADD:
        return a + b;
    case OP_SUB:
        return a - b;
    case OP_MUL:
        return a * b;
    case OP_DIV:
        return a / b;
    case OP_MIN:
        return vreal_min(a, b);
    case OP_MAX:
        return vreal_max(a, b);
    case OP_SELECT_LESS:
        return vreal_select(vmask_less(a, b), b, a);
    case OP_SQRT:
        return vreal_sqrt(a);
    case OP_ABS:
        return vreal_abs(a);
    case OP_ROUND:
        return vreal_round(a);
    case OP_NEGATIVE:
        return -a;
    case OP_FMA:
        return vreal_fma(a, b, vreal_set(first));
    case OP_SET:
        return vreal_set(first);
    default:
        return 3.0 * a - b / 2.0;
    }
}

static void apply(vocabulary_operation operation, const double *a, const double *b, double *out)
{
    for (int l = 0; l < VOCABULARY_LANES; l += CLOD_WIDTH) {
        vreal_store(&out[l], operate(operation, vreal_load(&a[l]), vreal_load(&b[l]), a[0]));
    }
}

static void any_less(const double *a, const double *b, bool *out)
{
    for (int l = 0; l < VOCABULARY_LANES; l += CLOD_WIDTH) {
        out[l] = vmask_any(vmask_less(vreal_load(&a[l]), vreal_load(&b[l])));
    }
}

static void load_rows(const double (*rows)[4], const int32_t *index, double (*out)[8])
{
    for (int l = 0; l < VOCABULARY_LANES; l += CLOD_WIDTH) {
        vreal columns[4];
        vreal_load_rows(columns, rows, &index[l]);
        for (int c = 0; c < 4; c++) {
            vreal_store(&out[c][l], columns[c]);
        }
    }
}

static void store_rows(double (*rows)[8], const int32_t *index, double (*in)[8])
{
    for (int l = 0; l < VOCABULARY_LANES; l += CLOD_WIDTH) {
        vreal columns[8];
        for (int c = 0; c < 8; c++) {
            columns[c] = vreal_load(&in[c][l]);
        }
        vreal_store_rows(rows, &index[l], columns);
    }
}

static void add_rows(double (*rows)[8], const int32_t *index, double (*in)[8], int lanes)
{
    for (int l = 0; l < lanes; l += CLOD_WIDTH) {
        vreal columns[8];
        for (int c = 0; c < 8; c++) {
            columns[c] = vreal_load(&in[c][l]);
        }
        vreal_add_rows(rows, &index[l], columns,
                       lanes - l < CLOD_WIDTH ? lanes - l : CLOD_WIDTH);
    }
}

static void invert(double (*in)[8], double (*out)[8])
{
    for (int l = 0; l < VOCABULARY_LANES; l += CLOD_WIDTH) {
        vreal a = vreal_load(&in[0][l]), b = vreal_load(&in[1][l]);
        vreal_invert2(&a, &b);
        vreal_store(&out[0][l], a);
        vreal_store(&out[1][l], b);
        a = vreal_load(&in[0][l]);
        b = vreal_load(&in[1][l]);
        vreal c = vreal_load(&in[2][l]);
        vreal_invert3(&a, &b, &c);
        vreal_store(&out[2][l], a);
        vreal_store(&out[3][l], b);
        vreal_store(&out[4][l], c);
    }
}

static void vectors(double (*in)[8], double (*out)[8])
{
    for (int l = 0; l < VOCABULARY_LANES; l += CLOD_WIDTH) {
        const vreal3 a = vreal3_load(in, l);
        const vreal3 b = vreal3_load(in + 3, l);
        const vreal s = vreal_load(&in[6][l]);
        vreal3_store(out, l, vreal3_add(a, b));
        vreal3_store(out + 3, l, vreal3_sub(a, b));
        vreal3_store(out + 6, l, vreal3_cross(a, b));
        vreal3_store(out + 9, l, vreal3_axpy(a, s, b));
        vreal3_store(out + 12, l, vreal3_scale(a, s));
        vreal3_store(out + 15, l, (vreal3){vreal3_dot(a, b), vreal3_dot(a, a), vreal_set(0.0)});
    }
}

static void closest(int form, double (*in)[8], double (*out)[8])
{
    for (int l = 0; l < VOCABULARY_LANES; l += CLOD_WIDTH) {
        vreal s[4][4];
        for (int c = 0; c < 16; c++) {
            s[c / 4][c % 4] = vreal_load(&in[c][l]);
        }
        const clod_wall_closest at =
            clod_wall_closest_point((clod_wall_form)form, s, vreal3_load(in + 16, l));
        vreal_store(&out[0][l], at.distance);
        vreal3_store(out + 1, l, at.normal);
    }
}

#define VOCABULARY_OF(suffix) vocabulary_##suffix
#define VOCABULARY(suffix) VOCABULARY_OF(suffix)

const vocabulary VOCABULARY(CLOD_SIMD_SUFFIX) = {.width = CLOD_WIDTH,
                                                 .apply = apply,
                                                 .any_less = any_less,
                                                 .load_rows = load_rows,
                                                 .store_rows = store_rows,
                                                 .add_rows = add_rows,
                                                 .invert = invert,
                                                 .vectors = vectors,
                                                 .closest = closest};
