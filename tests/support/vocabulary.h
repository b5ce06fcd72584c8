#pragma once
/**
 * @file vocabulary.h
 * The vector vocabulary of one instruction set behind ordinary functions; vocabulary.c is
 * compiled once per set, as the kernels are.
 */

#include <stdbool.h>
#include <stdint.h>

#define VOCABULARY_LANES 8

typedef enum vocabulary_operation {
    OP_ADD,
    OP_SUB,
    OP_MUL,
    OP_DIV,
    OP_MIN,
    OP_MAX,
    OP_SELECT_LESS, ///< a < b ? b : a
    OP_SQRT,        ///< of a, like the following
    OP_ABS,
    OP_ROUND,
    OP_NEGATIVE,
    OP_FMA,  ///< a b + a[0], rounded once
    OP_SET,  ///< a[0] in every lane
    OP_BOTH, ///< 3 a - b / 2: between vectors and doubles
    OP_COUNT
} vocabulary_operation;

typedef struct vocabulary {
    int width;
    /** out = a op b over VOCABULARY_LANES lanes. */
    void (*apply)(vocabulary_operation operation, const double *a, const double *b,
                  double *out);
    /** One truth per group of `width` lanes, the first of each: is a < b in any of them? */
    void (*any_less)(const double *a, const double *b, bool *out);
    void (*load_rows)(const double (*rows)[4], const int32_t *index, double (*out)[8]);
    void (*store_rows)(double (*rows)[8], const int32_t *index, double (*in)[8]);
    /** Of the first `lanes` lanes, group by group of `width`. */
    void (*add_rows)(double (*rows)[8], const int32_t *index, double (*in)[8], int lanes);
    /** Rows of out: 1/a, 1/b by vreal_invert2; 1/a, 1/b, 1/c by vreal_invert3. */
    void (*invert)(double (*in)[8], double (*out)[8]);
    /** Rows of out: a + b, a - b, a x b, a + s b, s a, (a.b, a.a, 0); s is in[6]. */
    void (*vectors)(double (*in)[8], double (*out)[8]);
    /** Closest points: `in` has 16 rows of a shape and x, y, z; out distance and normal. */
    void (*closest)(int form, double (*in)[8], double (*out)[8]);
} vocabulary;

extern const vocabulary vocabulary_scalar;
#if defined(__x86_64__)
extern const vocabulary vocabulary_avx2;
extern const vocabulary vocabulary_avx512;
#elif defined(__aarch64__)
extern const vocabulary vocabulary_neon;
#endif
