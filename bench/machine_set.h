#pragma once
/**
 * @file machine_set.h
 * Loops that do nothing but keep one unit of a core busy, written in the vocabulary of the
 * kernels and compiled once per instruction set (tools/bench.cmake).
 */

#include <stddef.h>
#include <stdint.h>

typedef struct bench_machine_set {
    const char *name;
    /** x = x m + a in chains that do not wait for each other; two operations each. */
    double (*multiply_add)(int64_t rounds);
    double (*divide)(int64_t rounds); ///< x = a / x
    double (*root)(int64_t rounds);   ///< x = sqrt(x + a); the root alone is counted
    int64_t operations;               ///< of one round, of multiply_add: half of it
    /** a = a + s b, in place as the step's own arrays; count is a multiple of 8. */
    void (*update)(double *a, const double *b, size_t count);
} bench_machine_set;
