#pragma once
/**
 * @file clump_class.h
 * Classes of the number of grains in a clump: 2, 3, 4-5, 6-10, 11-20, 21-50, and so on in
 * steps of 1, 2 and 5.
 */

#include <stdint.h>

#define CLOD_CLUMP_CLASSES 20

/** Most grains of each class. */
static const int32_t CLOD_CLUMP_CLASS_MOST[CLOD_CLUMP_CLASSES] = {
    2,    3,    5,     10,    20,    50,     100,    200,    500,     1000,
    2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000, INT32_MAX};

/** Class of a clump of so many grains, 2 or more. Threads: pure. Test: test_clumps.c */
static inline int clod_clump_class(int32_t grains)
{
    int k = 0;
    while (grains > CLOD_CLUMP_CLASS_MOST[k]) {
        k++;
    }
    return k;
}

/** Fewest grains of a class. */
static inline int32_t clod_clump_class_least(int k)
{
    return k == 0 ? 2 : CLOD_CLUMP_CLASS_MOST[k - 1] + 1;
}
