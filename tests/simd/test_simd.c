// The vocabulary of every instruction set against plain C, bit for bit, with infinities, NaN,
// signed zeros, subnormal numbers and ties.

#include <float.h>
#include <string.h>

#include "geometry/wall_gap.h"
#include "step/kernel.h"
#include "support/check.h"
#include "support/dice.h"
#include "support/vocabulary.h"

static const double SPECIAL[] = {0.0,     -0.0,     1.0,     -1.0,       0.5,        -0.5,
                                 1.5,     -2.5,     2.5,     INFINITY,   -INFINITY,  NAN,
                                 DBL_MAX, -DBL_MAX, DBL_MIN, 4.94e-324,  -4.94e-324, 1e16,
                                 3.7,     -1e-300,  0x1p52,  0x1p52 + 1, 1e308,      0.1};
#define SPECIALS ((int)(sizeof SPECIAL / sizeof *SPECIAL))

static double any_number(dice *roll)
{
    const int kind = dice_pick(roll, 4);
    if (kind == 0) {
        return SPECIAL[dice_pick(roll, SPECIALS)];
    }
    if (kind == 1) { // any bits at all
        const uint64_t bits = dice_bits(roll);
        double number;
        memcpy(&number, &bits, sizeof number);
        return isnan(number) ? (double)NAN
                             : number; // one kind of NaN: its bits are not promised
    }
    return dice_real(roll, -10.0, 10.0);
}

/** What simd.h says, in plain C. */
static double expected_of(vocabulary_operation operation, double a, double b, double first)
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
        return a < b ? a : b;
    case OP_MAX:
        return a > b ? a : b;
    case OP_SELECT_LESS:
        return a < b ? b : a;
    case OP_SQRT:
        return sqrt(a);
    case OP_ABS:
        return fabs(a);
    case OP_ROUND:
        return rint(a);
    case OP_NEGATIVE:
        return -a;
    case OP_FMA:
        return fma(a, b, first);
    case OP_SET:
        return first;
    default:
        return 3.0 * a - b / 2.0;
    }
}

static void check_bits(double found, double expected)
{
    if (isnan(expected)) {
        assert_true(isnan(found));
    } else if (memcmp(&found, &expected, sizeof found) != 0) {
        fail_msg("%a, expected %a", found, expected);
    }
}

static void check_operations(const vocabulary *v)
{
    dice roll = {1};
    for (int k = 0; k < 200000; k++) {
        double a[8], b[8], out[8];
        for (int l = 0; l < 8; l++) {
            a[l] = any_number(&roll);
            b[l] = dice_pick(&roll, 6) == 0 ? a[l] : any_number(&roll);
        }
        const vocabulary_operation operation = (vocabulary_operation)(k % OP_COUNT);
        v->apply(operation, a, b, out);
        for (int l = 0; l < 8; l++) {
            check_bits(out[l], expected_of(operation, a[l], b[l], a[0]));
        }
    }
}

static void check_truths(const vocabulary *v)
{
    dice roll = {2};
    for (int k = 0; k < 20000; k++) {
        double a[8], b[8];
        bool out[8];
        for (int l = 0; l < 8; l++) {
            b[l] = any_number(&roll);
            a[l] = dice_pick(&roll, 9) == 0 ? any_number(&roll) : b[l]; // mostly not less
        }
        v->any_less(a, b, out);
        for (int l = 0; l < 8; l += v->width) {
            bool any = false;
            for (int w = 0; w < v->width; w++) {
                any |= a[l + w] < b[l + w];
            }
            assert_true(out[l] == any);
        }
    }
}

static void check_rows(const vocabulary *v)
{
    dice roll = {3};
    _Alignas(64) double rows[50][4], wide[50][8], before[50][8];
    for (int k = 0; k < 5000; k++) {
        int32_t index[8];
        double columns[8][8];
        for (int r = 0; r < 50; r++) {
            for (int c = 0; c < 8; c++) {
                rows[r][c % 4] = any_number(&roll);
                wide[r][c] = before[r][c] = any_number(&roll);
            }
        }
        for (int l = 0; l < 8; l++) { // different rows
            index[l] = 6 * l + dice_pick(&roll, 6);
            for (int c = 0; c < 8; c++) {
                columns[c][l] = any_number(&roll);
            }
        }
        double loaded[4][8];
        v->load_rows((const double(*)[4])rows, index, loaded);
        v->store_rows(wide, index, columns);
        for (int l = 0; l < 8; l++) {
            for (int c = 0; c < 8; c++) {
                check_bits(loaded[c % 4][l], rows[index[l]][c % 4]);
                check_bits(wide[index[l]][c], columns[c][l]);
                before[index[l]][c] = wide[index[l]][c];
            }
        }
        assert_memory_equal(wide, before, sizeof wide); // no other row was touched
    }
}

/** Rows that come again, and fewer lanes than a vector has: sums go lane after lane. */
static void check_added_rows(const vocabulary *v)
{
    dice roll = {5};
    _Alignas(64) double rows[8][8], expected[8][8];
    for (int k = 0; k < 20000; k++) {
        const int lanes = 1 + dice_pick(&roll, 8);
        const int different = 1 + dice_pick(&roll, 8);
        int32_t index[8];
        double columns[8][8];
        for (int l = 0; l < 8; l++) {
            index[l] = dice_pick(&roll, different);
            for (int c = 0; c < 8; c++) {
                rows[l][c] = expected[l][c] = any_number(&roll);
                columns[c][l] = any_number(&roll);
            }
        }
        for (int l = 0; l < lanes; l++) {
            for (int c = 0; c < 8; c++) {
                expected[index[l]][c] += columns[c][l];
            }
        }
        v->add_rows(rows, index, columns, lanes);
        for (int l = 0; l < 8; l++) {
            for (int c = 0; c < 8; c++) {
                check_bits(rows[l][c], expected[l][c]);
            }
        }
    }
}

/** found = 1/a but for so many roundings of half a unit of the last place each. */
static void check_inverse(double found, double a, int roundings)
{
    check_at_most(fabs(fma(found, a, -1.0)), roundings * 0x1p-53 * (1.0 + 1e-12));
}

/**
 * As the callers have them: from squares of 1e-80 to stiffnesses of 1e12. Roundings by hand:
 * the product, its inverse and what is taken out of it are three; the first two of three
 * numbers go through both.
 */
static void check_inverses(const vocabulary *v)
{
    dice roll = {6};
    for (int k = 0; k < 50000; k++) {
        double in[3][8], out[5][8];
        for (int c = 0; c < 3; c++) {
            for (int l = 0; l < 8; l++) {
                const int extreme = dice_pick(&roll, 8);
                const double power = dice_real(&roll, -80.0, 12.0);
                in[c][l] = extreme == 0 ? 1e-80 : extreme == 1 ? 1e12 : pow(10.0, power);
            }
        }
        v->invert(in, out);
        for (int l = 0; l < 8; l++) {
            check_inverse(out[0][l], in[0][l], 3);
            check_inverse(out[1][l], in[1][l], 3);
            check_inverse(out[2][l], in[0][l], 5);
            check_inverse(out[3][l], in[1][l], 5);
            check_inverse(out[4][l], in[2][l], 3);
        }
    }
}

/** Every set has the bits of the scalar one in what plain C does not define by one operation.
 */
static void check_inverses_of_scalar(const vocabulary *v)
{
    dice roll = {7};
    for (int k = 0; k < 20000; k++) {
        double in[3][8], out[5][8], expected[5][8];
        for (int l = 0; l < 24; l++) {
            in[l / 8][l % 8] = any_number(&roll);
        }
        v->invert(in, out);
        vocabulary_scalar.invert(in, expected);
        for (int l = 0; l < 40; l++) {
            check_bits(out[l / 8][l % 8], expected[l / 8][l % 8]);
        }
    }
}

static void check_vectors(const vocabulary *v)
{
    dice roll = {4};
    for (int k = 0; k < 20000; k++) {
        double in[7][8], out[18][8];
        for (int c = 0; c < 7; c++) {
            for (int l = 0; l < 8; l++) {
                in[c][l] = dice_real(&roll, -1.0, 1.0) * pow(2.0, dice_pick(&roll, 40));
            }
        }
        v->vectors(in, out);
        for (int l = 0; l < 8; l++) {
            double a[3], b[3];
            for (int c = 0; c < 3; c++) {
                a[c] = in[c][l];
                b[c] = in[3 + c][l];
                check_bits(out[c][l], a[c] + b[c]);
                check_bits(out[3 + c][l], a[c] - b[c]);
                check_bits(out[9 + c][l], fma(in[6][l], b[c], a[c]));
                check_bits(out[12 + c][l], a[c] * in[6][l]);
            }
            check_bits(out[6][l], fma(a[1], b[2], -(a[2] * b[1])));
            check_bits(out[7][l], fma(a[2], b[0], -(a[0] * b[2])));
            check_bits(out[8][l], fma(a[0], b[1], -(a[1] * b[0])));
            check_bits(out[15][l], fma(a[2], b[2], fma(a[1], b[1], a[0] * b[0])));
            check_bits(out[16][l], fma(a[2], a[2], fma(a[1], a[1], a[0] * a[0])));
        }
    }
}

/** A shape of any kind, upright or tilted; its sizes are small whole numbers. */
static clod_shape any_shape(dice *roll)
{
    static const clod_shape_kind KINDS[] = {
        CLOD_SHAPE_PLANE, CLOD_SHAPE_DISC, CLOD_SHAPE_ANNULUS, CLOD_SHAPE_CYLINDER,
        CLOD_SHAPE_CONE,  CLOD_SHAPE_BOX,  CLOD_SHAPE_BAR};
    clod_shape s = {.kind = KINDS[dice_pick(roll, 7)],
                    .outer = 2.0,
                    .half = {1.0, 2.0, 1.0},
                    .side = dice_pick(roll, 2) == 0 ? CLOD_SIDE_INSIDE : CLOD_SIDE_OUTSIDE};
    s.inner = s.kind == CLOD_SHAPE_DISC ? 0.0 : dice_pick(roll, 2);
    if (s.kind == CLOD_SHAPE_ANNULUS) {
        s.inner = 1.0;
    }
    const double angle = dice_pick(roll, 2) == 0 ? 0.0 : dice_real(roll, 0.0, 6.0);
    for (int a = 0; a < 3; a++) {
        const clod_vec3 e = {a == 0, a == 1, a == 2};
        s.axis[a] = clod_vec3_rotate(e, (clod_vec3){0.6, 0.0, 0.8}, angle);
    }
    return s;
}

/** Anywhere, or where whole and half numbers meet surfaces, rims, axes and middles. */
static double any_coordinate(dice *roll)
{
    return dice_pick(roll, 3) == 0 ? dice_real(roll, -4.0, 4.0)
                                   : 0.5 * (dice_pick(roll, 17) - 8);
}

/** A shape of one form that any_shape makes, as rows. */
static void shape_of(clod_wall_form form, dice *roll, double row[4][4])
{
    do {
        const clod_shape s = any_shape(roll);
        clod_wall_shape_rows(&s, row);
    } while (clod_wall_form_of(row[0][3]) != form);
}

/**
 * Lanes with shapes of each form: what one lane at a time gives, to the last bit. Not meshes:
 * no vector computes what is closest of their facets (tests/mesh/test_surface_touch.c).
 */
static void check_closest(const vocabulary *v)
{
    static const clod_wall_form COMPUTED[] = {CLOD_FORM_PLANE, CLOD_FORM_BOX, CLOD_FORM_SHELL};
    assert_int_equal(sizeof COMPUTED / sizeof *COMPUTED, CLOD_FORMS - 1);
    dice roll = {6};
    int on = 0;
    for (int k = 0; k < 20000; k++) {
        double in[19][8], row[8][4][4], out[4][8];
        const clod_wall_form form = COMPUTED[k % (CLOD_FORMS - 1)];
        for (int l = 0; l < 8; l++) {
            shape_of(form, &roll, row[l]);
            for (int c = 0; c < 16; c++) {
                in[c][l] = row[l][c / 4][c % 4];
            }
            for (int c = 16; c < 19; c++) {
                in[c][l] = any_coordinate(&roll);
            }
        }
        v->closest((int)form, in, out);
        for (int l = 0; l < 8; l++) {
            const clod_vec3 p = {in[16][l], in[17][l], in[18][l]};
            const clod_gap gap = clod_wall_gap_rows((const double(*)[4])row[l], p);
            check_bits(out[0][l], gap.distance);
            check_bits(out[1][l], gap.normal.x);
            check_bits(out[2][l], gap.normal.y);
            check_bits(out[3][l], gap.normal.z);
            on += gap.distance <= 0.0 && row[l][0][3] != CLOD_WALL_PLANE;
        }
    }
    assert_true(on > 1000); // surfaces and insides were met
}

static void check_all(const vocabulary *v)
{
    check_closest(v);
    check_operations(v);
    check_truths(v);
    check_rows(v);
    check_added_rows(v);
    check_inverses(v);
    check_inverses_of_scalar(v);
    check_vectors(v);
}

static void scalar_is_plain_c(void **state)
{
    (void)state;
    assert_int_equal(vocabulary_scalar.width, 1);
    check_all(&vocabulary_scalar);
}

#if defined(__x86_64__)
static void check_set(const char *name, const vocabulary *v, int width)
{
    assert_int_equal(v->width, width);
    if (clod_kernel_choose(name) == NULL) {
        print_message("this machine has no %s: not tested\n", name);
        skip();
    }
    check_all(v);
}

static void avx2_is_plain_c(void **state)
{
    (void)state;
    check_set("avx2", &vocabulary_avx2, 4);
}

static void avx512_is_plain_c(void **state)
{
    (void)state;
    check_set("avx512", &vocabulary_avx512, 8);
}
#elif defined(__aarch64__)
static void neon_is_plain_c(void **state)
{
    (void)state;
    assert_int_equal(vocabulary_neon.width, 2);
    check_all(&vocabulary_neon);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scalar_is_plain_c),
#if defined(__x86_64__)
        cmocka_unit_test(avx2_is_plain_c),
        cmocka_unit_test(avx512_is_plain_c),
#elif defined(__aarch64__)
        cmocka_unit_test(neon_is_plain_c),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
