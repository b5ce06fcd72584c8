#include "base/memory.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#if defined(__linux__)
#include <malloc.h>
#endif

#include "base/assert.h"

#define PAGE 4096         ///< bytes, or a multiple where pages are larger
#define GIVE_FROM 1048576 ///< bytes from which on an array's pages are given back

static atomic_uint_fast64_t allocations;

/**
 * Zeroed memory, in huge pages but for what does not fill the last one: the system gives zeroed
 * pages as they are first used, so what is never used takes no memory. Fewer misses of the
 * address translation, too (docs/adr/0012).
 */
static void take_huge_pages(void *memory, size_t bytes)
{
#if defined(__linux__)
    // a wish: without it all works as well
    madvise(memory, bytes / CLOD_MEMORY_HUGE_PAGE * CLOD_MEMORY_HUGE_PAGE, MADV_HUGEPAGE);
    if (madvise(memory, bytes, MADV_DONTNEED) == 0) { // on Linux: zeros from now on
        return;
    }
#endif
    memset(memory, 0, bytes);
}

void *clod_memory_alloc(size_t count, size_t size)
{
    if (size != 0 && count > (SIZE_MAX - CLOD_MEMORY_HUGE_PAGE) / size) {
        return NULL;
    }
    atomic_fetch_add_explicit(&allocations, 1, memory_order_relaxed);
    const size_t alignment = count * size >= CLOD_MEMORY_HUGE_PAGE
                                 ? (size_t)CLOD_MEMORY_HUGE_PAGE
                                 : (size_t)CLOD_MEMORY_ALIGNMENT;
    const size_t whole = (count * size + alignment) / alignment * alignment;
    void *memory = aligned_alloc(alignment, whole);
    if (memory != NULL && alignment == CLOD_MEMORY_HUGE_PAGE) {
        take_huge_pages(memory, count * size);
    } else if (memory != NULL) {
        memset(memory, 0, whole);
    }
    return memory;
}

void *clod_memory_grow(void *memory, size_t old_count, size_t new_count, size_t size)
{
    void *grown = clod_memory_alloc(new_count, size);
    if (grown != NULL && memory != NULL) {
        memcpy(grown, memory, old_count * size);
        clod_memory_free(memory);
    }
    return grown;
}

void clod_memory_give_back(void *memory, size_t bytes, size_t array)
{
#if defined(__linux__)
    CLOD_ASSERT(bytes < array || malloc_usable_size(memory) >= bytes); // none of another's
    const uintptr_t small = (uintptr_t)sysconf(_SC_PAGESIZE);
    const uintptr_t page = array >= CLOD_MEMORY_HUGE_PAGE ? CLOD_MEMORY_HUGE_PAGE : small;
    const uintptr_t from = ((uintptr_t)memory + page - 1) / page * page;
    const uintptr_t last =
        bytes < array ? page : small; // behind whole huge pages are small ones
    const uintptr_t to = ((uintptr_t)memory + bytes) / last * last;
    if (array >= GIVE_FROM && from < to) {
        madvise((char *)memory + (from - (uintptr_t)memory), to - from, MADV_DONTNEED);
    }
#else
    (void)memory;
    (void)bytes;
    (void)array;
#endif
}

char *clod_memory_text(const char *text)
{
    if (text == NULL) {
        return NULL;
    }
    const size_t length = strlen(text) + 1;
    char *copy = clod_memory_alloc(length, 1);
    if (copy != NULL) {
        memcpy(copy, text, length);
    }
    return copy;
}

void clod_memory_free(void *memory)
{
    free(memory);
}

double clod_memory_machine(void)
{
    const double pages = (double)sysconf(_SC_PHYS_PAGES);
    const double page = (double)sysconf(_SC_PAGESIZE);
    return pages > 0.0 && page > 0.0 ? pages * page : 0.0;
}

uint64_t clod_memory_count(void)
{
    return atomic_load_explicit(&allocations, memory_order_relaxed);
}
