/**
 * Preloaded into clod: lets calls for memory fail.
 *
 *   ALLOC_FAIL    number of the first call that fails, from 1; 0: none, they are counted
 *   ALLOC_FROM    1: all calls from that one on fail, not only it
 *   ALLOC_WHOSE   own: only calls from the program itself are counted (and those that jansson
 * makes through the program); all: those within libraries too ALLOC_REPORT  file that gets the
 * place of the first failure, from the inside outwards, that of a crash, and at the end "calls
 * N failed M"
 *
 * Calls before main and during exit are not counted.
 */
#define _GNU_SOURCE

#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define FRAMES 24
#define RANGES 16
#define EXPORT __attribute__((visibility("default")))

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);

static atomic_long calls, failed;
static long first_to_fail;
static bool all_from_there;
static int report = -1;
static struct {
    uintptr_t begin, end;
} code[RANGES]; ///< where those lie whose calls are counted
static int code_count;
static atomic_bool counting;
static _Thread_local bool inside; ///< what the report itself asks for is not counted

/** Whether `name` begins with one of the words of `list`, which has commas. */
static bool is_listed(const char *name, const char *list)
{
    while (*list != '\0') {
        const size_t length = strcspn(list, ",");
        if (strncmp(name, list, length) == 0) {
            return true;
        }
        list += length;
        list += *list == ',';
    }
    return false;
}

/** Note where the code of the chosen objects lies; the program is the one without a name. */
static int find_code(struct dl_phdr_info *info, size_t size, void *chosen)
{
    (void)size;
    const char *slash = strrchr(info->dlpi_name, '/');
    const char *name = slash != NULL ? slash + 1 : info->dlpi_name;
    const bool program = info->dlpi_name[0] == '\0';
    if (!(program ? strcmp(chosen, "own") == 0 : is_listed(name, chosen))) {
        return 0;
    }
    for (int p = 0; p < info->dlpi_phnum && code_count < RANGES; p++) {
        const ElfW(Phdr) *part = &info->dlpi_phdr[p];
        if (part->p_type == PT_LOAD && (part->p_flags & PF_X) != 0) {
            code[code_count].begin = info->dlpi_addr + part->p_vaddr;
            code[code_count].end = code[code_count].begin + part->p_memsz;
            code_count++;
        }
    }
    return 0;
}

static bool is_counted(const void *caller)
{
    const uintptr_t from = (uintptr_t)caller;
    for (int c = 0; c < code_count; c++) {
        if (from >= code[c].begin && from < code[c].end) {
            return true;
        }
    }
    return false;
}

static void put(const char *text)
{
    const ssize_t written = write(report, text, strlen(text));
    (void)written;
}

/** Write what is called from where, without the first frames, which are of this file. */
static void report_place(const char *what, int skip)
{
    void *frames[FRAMES];
    const int count = backtrace(frames, FRAMES);
    for (int f = skip; f < count; f++) {
        Dl_info info;
        char text[512];
        if (dladdr(frames[f], &info) == 0 || info.dli_fname == NULL) {
            continue;
        }
        const char *slash = strrchr(info.dli_fname, '/');
        snprintf(text, sizeof text, "%s %s %s %#lx\n", what,
                 slash != NULL ? slash + 1 : info.dli_fname,
                 info.dli_sname != NULL ? info.dli_sname : "?",
                 (unsigned long)((char *)frames[f] - (char *)info.dli_fbase));
        put(text);
    }
}

/** Whether this call, made from `caller`, is to fail. */
static bool fails(const void *caller)
{
    if (inside || !atomic_load(&counting) || !is_counted(caller)) {
        return false;
    }
    const long number = 1 + atomic_fetch_add(&calls, 1);
    if (first_to_fail == 0 || number < first_to_fail ||
        (number > first_to_fail && !all_from_there)) {
        return false;
    }
    if (atomic_fetch_add(&failed, 1) == 0 && report >= 0) {
        inside = true;
        report_place("failed", 3);
        inside = false;
    }
    errno = ENOMEM;
    return true;
}

EXPORT void *malloc(size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_malloc(size);
}

EXPORT void *calloc(size_t count, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_calloc(count, size);
}

EXPORT void *realloc(void *memory, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_realloc(memory, size);
}

EXPORT void *reallocarray(void *memory, size_t count, size_t size)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes)) {
        errno = ENOMEM;
        return NULL;
    }
    return fails(__builtin_return_address(0)) ? NULL : __libc_realloc(memory, bytes);
}

EXPORT void *aligned_alloc(size_t alignment, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);
}

EXPORT void *memalign(size_t alignment, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);
}

EXPORT int posix_memalign(void **memory, size_t alignment, size_t size)
{
    void *got = fails(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);
    if (got == NULL) {
        return ENOMEM;
    }
    *memory = got;
    return 0;
}

static char *copy(const char *text, size_t length, bool fail)
{
    char *made = fail ? NULL : __libc_malloc(length + 1);
    if (made != NULL) {
        memcpy(made, text, length);
        made[length] = '\0';
    }
    return made;
}

EXPORT char *strdup(const char *text)
{
    return copy(text, strlen(text), fails(__builtin_return_address(0)));
}

EXPORT char *strndup(const char *text, size_t size)
{
    return copy(text, strnlen(text, size), fails(__builtin_return_address(0)));
}

static void on_crash(int number)
{
    inside = true;
    if (report >= 0) {
        report_place("crash", 3);
    }
    signal(number, SIG_DFL);
    raise(number);
}

static void finish(void)
{
    char text[64];
    atomic_store(&counting, false);
    if (report >= 0) {
        snprintf(text, sizeof text, "calls %ld failed %ld\n", atomic_load(&calls),
                 atomic_load(&failed));
        put(text);
    }
}

static long number_of(const char *name)
{
    const char *text = getenv(name);
    return text != NULL ? strtol(text, NULL, 10) : 0;
}

__attribute__((constructor)) static void begin(void)
{
    void *warm[4];
    const char *whose = getenv("ALLOC_WHOSE");
    const char *path = getenv("ALLOC_REPORT");
    first_to_fail = number_of("ALLOC_FAIL");
    all_from_there = number_of("ALLOC_FROM") != 0;
    if (path != NULL) {
        report = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    }
    backtrace(warm, 4);       // loads its library now
    static char stack[65536]; // a stack of its own: endless recursion crashes too
    sigaltstack(&(stack_t){.ss_sp = stack, .ss_size = sizeof stack}, NULL);
    struct sigaction action = {.sa_handler = on_crash, .sa_flags = SA_ONSTACK};
    sigemptyset(&action.sa_mask);
    static const int CRASHES[] = {SIGSEGV, SIGBUS, SIGFPE, SIGABRT};
    for (size_t c = 0; c < sizeof CRASHES / sizeof CRASHES[0]; c++) {
        sigaction(CRASHES[c], &action, NULL);
    }
    dl_iterate_phdr(find_code, (void *)(whose != NULL ? whose : "own"));
    atexit(finish);
    atomic_store(&counting, true);
}
