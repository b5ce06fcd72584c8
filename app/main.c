/**
 * @file main.c
 * clod VERB ...: find the verb and hand over.
 */

#include <argp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "arguments.h"
#include "clod/ranks.h"
#include "clod/version.h"
#include "output.h"

#define USAGE 2

typedef struct verb {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *help;
} verb;

static const verb VERBS[] = {
    {"new", clod_app_new, "write an example case to start from"},
    {"run", clod_app_run, "run a case, or continue an interrupted run"},
    {"check", clod_app_check, "check a case and estimate its run time, memory and disk space"},
    {"contact", clod_app_contact, "drive one contact along a path and print force and history"},
    {"locus", clod_app_locus,
     "evaluate tables of shear points, wall friction or bulk densities"},
    {"hopper", clod_app_hopper, "design a hopper: half angle, critical outlet, rathole"},
    {"calibrate", clod_app_calibrate, "calibrate a material against laboratory measurements"},
    {"mesh", clod_app_mesh, "check a triangle mesh: STL, OBJ or PLY"},
    {"picture", clod_app_picture, "draw snapshots of a run as PNG, or as a movie"},
    {"report", clod_app_report, "write a page for the browser about a run"},
    {"compare", clod_app_compare, "write one page about several runs"},
    {"explain", clod_app_explain, "explain a key of a case, a hopper or a plan"},
    {"schema", clod_app_schema, "print the JSON Schema of case files, for editors"},
    {"verify", clod_app_verify, "run the verification suite: computed against known results"},
};

#define VERB_COUNT (sizeof VERBS / sizeof VERBS[0])

static void print_version(FILE *out, struct argp_state *state)
{
    (void)state;
    fprintf(out, "%s\n", clod_version_text());
}

#define LIST_BEGIN "Verbs:\n"
#define LIST_END "\nclod VERB --help explains one of them."
#define LIST_ROOM 17 ///< name and blanks of a line

/** The list of verbs, in place of the options at the end of --help; argp frees it. */
static char *list_verbs(int key, const char *text, void *input)
{
    (void)input;
    if (key != ARGP_KEY_HELP_POST_DOC) {
        return (char *)text;
    }
    size_t size = sizeof LIST_BEGIN + sizeof LIST_END;
    for (size_t i = 0; i < VERB_COUNT; i++) {
        size += LIST_ROOM + strlen(VERBS[i].help);
    }
    char *list = malloc(size);
    if (list == NULL) {
        fputs("clod: no memory for the list of verbs\n", stderr);
        exit(EXIT_FAILURE);
    }
    int used = snprintf(list, size, LIST_BEGIN);
    for (size_t i = 0; i < VERB_COUNT; i++) {
        used += snprintf(list + used, size - (size_t)used, "  %-9s  %s\n", VERBS[i].name,
                         VERBS[i].help);
    }
    snprintf(list + used, size - (size_t)used, LIST_END);
    return list;
}

/** How many letters two words share, wherever they stand. */
static size_t shared_letters(const char *a, const char *b)
{
    size_t count = 0;
    for (int letter = 'a'; letter <= 'z'; letter++) {
        size_t in_a = 0;
        size_t in_b = 0;
        for (const char *at = a; *at != '\0'; at++) {
            in_a += *at == letter;
        }
        for (const char *at = b; *at != '\0'; at++) {
            in_b += *at == letter;
        }
        count += in_a < in_b ? in_a : in_b;
    }
    return count;
}

/** The verb with nearly the same letters as `name`, or NULL. */
static const verb *find_near(const char *name)
{
    const verb *near = NULL;
    size_t most = 0;
    for (size_t i = 0; i < VERB_COUNT; i++) {
        const size_t length = strlen(VERBS[i].name);
        const size_t longest = strlen(name) > length ? strlen(name) : length;
        const size_t common = shared_letters(name, VERBS[i].name);
        if (common > most && 3 * common >= 2 * longest) {
            most = common;
            near = &VERBS[i];
        }
    }
    return near;
}

static const verb *find_verb(const char *name)
{
    for (size_t i = 0; i < VERB_COUNT; i++) {
        if (strcmp(VERBS[i].name, name) == 0) {
            return &VERBS[i];
        }
    }
    const verb *near = find_near(name);
    fprintf(stderr, "clod: there is no verb %s", name);
    if (near != NULL) {
        fprintf(stderr, "; did you mean %s?", near->name);
    }
    fputs("\nclod --help lists the verbs\n", stderr);
    return NULL;
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    int *first = state->input;
    (void)argument;
    if (key == ARGP_KEY_ARG) {
        *first = state->next - 1;
        state->next = state->argc; // the rest belongs to the verb
        return 0;
    }
    if (key == ARGP_KEY_NO_ARGS) {
        argp_state_help(state, stderr, ARGP_HELP_STD_HELP & ~ARGP_HELP_EXIT_OK);
        exit(USAGE);
    }
    return ARGP_ERR_UNKNOWN;
}

/** Whether this process is the only one that runs the verb: each of several would do all of it, and write the
 *  same files. */
static bool is_alone(const verb *self)
{
    clod_status status = {0};
    if (self->run == clod_app_run || self->run == clod_app_verify) { // these share it
        return true;
    }
    clod_ranks *ranks = clod_ranks_open(&status);
    if (ranks == NULL) {
        fprintf(stderr, "clod %s: %s\n", self->name, status.text);
        return false;
    }
    const int size = clod_ranks_size(ranks);
    if (size > 1 && clod_ranks_number(ranks) == 0) {
        fprintf(
            stderr,
            "clod %s: started as %d processes; only clod run and clod verify share their work. "
            "Leave mpirun out\n",
            self->name, size);
    }
    clod_ranks_close(&ranks);
    return size == 1;
}

int main(int argc, char **argv)
{
    if (!clod_output_watch()) {
        return EXIT_FAILURE;
    }
    argp_program_version_hook = print_version;
    argp_err_exit_status = USAGE;
    const struct argp argp = {
        .parser = parse,
        .args_doc = "VERB ...",
        .doc = "Discrete element simulation of cohesive bulk solids.\v ",
        .help_filter = list_verbs,
    };
    int first = argc;
    if (!clod_arguments_parse(&argp, argc, argv, ARGP_IN_ORDER, &first)) {
        return EXIT_FAILURE;
    }
    const verb *chosen = find_verb(argv[first]);
    if (chosen == NULL || !is_alone(chosen)) {
        return USAGE;
    }
    char name[32];
    snprintf(name, sizeof name, "clod %s", chosen->name);
    argv[first] = name; // so that the verb's own messages begin with it
    const int result = chosen->run(argc - first, argv + first);
    clod_output_put(""); // now: a library's own end could flush and forget why it failed
    return result;
}
