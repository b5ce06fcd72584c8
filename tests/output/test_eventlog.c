// log.jsonl: one JSON object per line, from several threads, over several runs.

#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <sys/resource.h>

#include <cmocka.h>

#include "output/eventlog.h"

#include "temp_folder.h"

#define THREADS 4
#define LINES 200

static clod_eventlog *open_log(void **folder)
{
    clod_status status;
    clod_eventlog *log = clod_eventlog_open(temp_folder(folder), "log.jsonl", &status);
    assert_non_null(log);
    return log;
}

/** Owned line number `number` of the log as JSON, NULL behind the last. */
static json_t *line(void **folder, int number)
{
    size_t size;
    char *text = temp_read(folder, "log.jsonl", &size);
    size_t start = 0;
    for (int l = 0; l < number; l++) {
        start += strcspn(text + start, "\n") + 1;
    }
    assert_true(start <= size);
    json_t *json = json_loadb(text + start, strcspn(text + start, "\n"), 0, NULL);
    clod_memory_free(text);
    return json;
}

static void an_event_has_time_name_and_fields(void **folder)
{
    clod_status status;
    clod_eventlog *log = open_log(folder);
    clod_eventlog_write(log, "start", "{s:i, s:f, s:s}", "threads", 2, "dt_s", 1e-7, "case",
                        "a \"b\"\n");
    clod_eventlog_write(log, "end", NULL);
    clod_eventlog_write_json(log, "given", json_pack("{s:b}", "steady", 1));
    assert_true(clod_eventlog_close(&log, &status));
    assert_null(log);
    json_t *first = line(folder, 0);
    const char *time = json_string_value(json_object_get(first, "time"));
    int year, month, day, hour, minute, second, thousandth;
    assert_int_equal(sscanf(time, "%4d-%2d-%2dT%2d:%2d:%2d.%3dZ", &year, &month, &day, &hour,
                            &minute, &second, &thousandth),
                     7);
    assert_int_equal(strlen(time), 24);
    assert_string_equal(json_string_value(json_object_get(first, "event")), "start");
    assert_int_equal(json_integer_value(json_object_get(first, "threads")), 2);
    assert_true(json_real_value(json_object_get(first, "dt_s")) == 1e-7);
    assert_string_equal(json_string_value(json_object_get(first, "case")), "a \"b\"\n");
    json_decref(first);
    json_t *second_line = line(folder, 1);
    assert_int_equal(json_object_size(second_line), 2);
    json_decref(second_line);
    json_t *third = line(folder, 2);
    assert_true(json_is_true(json_object_get(third, "steady")));
    json_decref(third);
    assert_null(line(folder, 3));
}

static void fields_that_json_cannot_hold_do_not_lose_the_event(void **folder)
{
    clod_status status;
    clod_eventlog *log = open_log(folder);
    clod_eventlog_write(log, "odd", "{s:f}", "angle", (double)NAN);
    assert_true(clod_eventlog_close(&log, &status));
    json_t *json = line(folder, 0);
    assert_string_equal(json_string_value(json_object_get(json, "event")), "odd");
    assert_non_null(json_object_get(json, "fields_lost"));
    json_decref(json);
}

static void a_second_run_starts_on_a_line_of_its_own(void **folder)
{
    clod_status status;
    const char *cut = "{\"time\":\"2026-01-01T00:00:00.000Z\",\"ev";
    temp_write(folder, "log.jsonl", cut, strlen(cut));
    clod_eventlog *log = open_log(folder);
    clod_eventlog_write(log, "again", NULL);
    assert_true(clod_eventlog_close(&log, &status));
    json_t *json = line(folder, 1);
    assert_string_equal(json_string_value(json_object_get(json, "event")), "again");
    json_decref(json);
    assert_null(line(folder, 2));
}

static void *write_many(void *log)
{
    for (int n = 0; n < LINES; n++) {
        clod_eventlog_write(log, "point", "{s:i, s:s}", "number", n, "text",
                            "long enough to be mixed up if it were not one write");
    }
    return NULL;
}

static void threads_do_not_mix_their_lines(void **folder)
{
    clod_status status;
    clod_eventlog *log = open_log(folder);
    pthread_t threads[THREADS];
    for (int t = 0; t < THREADS; t++) {
        assert_int_equal(pthread_create(&threads[t], NULL, write_many, log), 0);
    }
    for (int t = 0; t < THREADS; t++) {
        pthread_join(threads[t], NULL);
    }
    assert_true(clod_eventlog_close(&log, &status));
    size_t size;
    char *text = temp_read(folder, "log.jsonl", &size);
    int seen[LINES] = {0};
    int lines = 0;
    for (size_t start = 0, length; start < size; start += length + 1) {
        length = strcspn(text + start, "\n");
        json_t *json = json_loadb(text + start, length, 0, NULL);
        assert_non_null(json);
        seen[json_integer_value(json_object_get(json, "number"))]++;
        json_decref(json);
        lines++;
    }
    clod_memory_free(text);
    assert_int_equal(lines, THREADS * LINES);
    for (int n = 0; n < LINES; n++) {
        assert_int_equal(seen[n], THREADS);
    }
}

static void a_full_disk_is_told_at_the_end(void **folder)
{
    clod_status status;
    char text[2 * PATH_MAX];
    struct rlimit before;
    clod_eventlog *log = open_log(folder);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct rlimit full = {0, before.rlim_max}; // stands for a full disk
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &full);
    clod_eventlog_write(log, "lost", NULL);
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, SIG_DFL);
    assert_false(clod_eventlog_close(&log, &status));
    assert_null(log);
    snprintf(text, sizeof text, "Cannot write %s/log.jsonl: File too large.", (char *)*folder);
    assert_non_null(strstr(status.text, text));
}

static void no_log_is_fine(void **folder)
{
    (void)folder;
    clod_status status;
    clod_eventlog *log = NULL;
    clod_eventlog_write(log, "nobody listens", "{s:i}", "number", 1);
    assert_true(clod_eventlog_close(&log, &status));
}

static void a_log_is_not_written_through_a_link(void **folder)
{
    clod_status status;
    char link[PATH_MAX], other[PATH_MAX];
    temp_write(folder, "other", "mine", 4);
    temp_path(link, folder, "log.jsonl");
    assert_int_equal(symlink(temp_path(other, folder, "other"), link), 0);
    assert_null(clod_eventlog_open(temp_folder(folder), "log.jsonl", &status));
    assert_non_null(strstr(status.text, link));
    assert_non_null(strstr(status.text, "clod does not write through symbolic links"));
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

/** The same event is written once, over several runs; other fields or another name are another. */
static void an_event_is_written_once(void **folder)
{
    clod_status status;
    for (int run = 0; run < 2; run++) {
        clod_eventlog *log = open_log(folder);
        clod_eventlog_write_once(log, "alarm",
                                 json_pack("{s:f, s:i}", "time_s", 0.1, "step", 7));
        clod_eventlog_write_once(log, "alarm",
                                 json_pack("{s:f, s:i}", "time_s", 0.1, "step", 8));
        clod_eventlog_write_once(log, "end", json_pack("{s:f, s:i}", "time_s", 0.1, "step", 7));
        assert_true(clod_eventlog_close(&log, &status));
    }
    json_t *last = line(folder, 2);
    assert_string_equal(json_string_value(json_object_get(last, "event")), "end");
    assert_null(line(folder, 3));
    json_decref(last);
}

/** Lines of another process come whole, and once they are there. */
static void a_log_can_be_collected_and_appended(void **folder)
{
    clod_status status;
    clod_bytes lines = {0};
    clod_eventlog *log = open_log(folder), *other = clod_eventlog_collect(&lines);
    clod_eventlog_write(log, "first", NULL);
    clod_eventlog_write(other, "far", "{s:i}", "rank", 3);
    clod_eventlog_write_once(other, "far too", json_pack("{s:i}", "rank", 4));
    assert_null(line(folder, 1));
    assert_true(clod_eventlog_close(&other, &status));
    clod_eventlog_append(log, lines.data, lines.count);
    clod_eventlog_append(NULL, lines.data, lines.count);
    clod_eventlog_write(log, "last", NULL);
    assert_true(clod_eventlog_close(&log, &status));
    static const char *const EVENTS[] = {"first", "far", "far too", "last"};
    for (int k = 0; k < 4; k++) {
        json_t *found = line(folder, k);
        assert_string_equal(json_string_value(json_object_get(found, "event")), EVENTS[k]);
        json_decref(found);
    }
    assert_null(line(folder, 4));
    clod_bytes_fini(&lines);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(an_event_has_time_name_and_fields),
        FOLDER_TEST(fields_that_json_cannot_hold_do_not_lose_the_event),
        FOLDER_TEST(a_second_run_starts_on_a_line_of_its_own),
        FOLDER_TEST(an_event_is_written_once),
        FOLDER_TEST(threads_do_not_mix_their_lines),
        FOLDER_TEST(a_full_disk_is_told_at_the_end),
        FOLDER_TEST(no_log_is_fine),
        FOLDER_TEST(a_log_is_not_written_through_a_link),
        FOLDER_TEST(a_log_can_be_collected_and_appended),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
