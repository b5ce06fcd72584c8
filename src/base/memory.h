#pragma once
/**
 * @file memory.h
 * Heap memory, counted: running out is reported by clod_memory_alloc's NULL, and the count of
 * calls lets a test prove that a warm step allocates nothing.
 */

#include <stddef.h>
#include <stdint.h>

#define CLOD_MEMORY_ALIGNMENT 64
#define CLOD_MEMORY_HUGE_PAGE 2097152 ///< bytes

/**
 * Zeroed memory aligned to a cache line; from 2 MiB on to a huge page, in such pages where the
 * system gives them on request (but for what does not fill the last one), and taken from it as
 * it is first used (docs/adr/0012).
 *
 * @param count  number of items
 * @param size   bytes of one item
 * @return       owned memory (free with clod_memory_free), or NULL when there is none
 * Errors  NULL.   Threads  safe.
 */
void *clod_memory_alloc(size_t count, size_t size);

/** Grow to new_count items, zeroing the new ones; NULL (old memory kept) when there is none. */
void *clod_memory_grow(void *memory, size_t old_count, size_t new_count, size_t size);

/** Bytes of an array from which on it pays to give back what lies in it at every list. */
#define CLOD_MEMORY_LARGE 8388608

/**
 * Give what lies in the first `bytes` of an array, and is not needed any more, back to the
 * system: its whole pages, if the array has 1 MiB or more and the system takes them. They come
 * again when they are next used; what is in them then is not defined (docs/adr/0016).
 *
 * @param memory  start of an array, or a place within it
 * @param bytes   that may be lost from there on
 * @param array   bytes of the whole array
 */
void clod_memory_give_back(void *memory, size_t bytes, size_t array);

/** Owned copy of a text; NULL gives NULL. */
char *clod_memory_text(const char *text);

/** Free; NULL is fine. */
void clod_memory_free(void *memory);

/** Bytes of memory that this machine has; 0 where the system does not say. */
double clod_memory_machine(void);

/** Number of allocations so far, over all threads. */
uint64_t clod_memory_count(void);
