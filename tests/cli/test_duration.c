// Durations on the clock (app/duration.c). Expected values: seconds by hand.
#include "duration.h"

#include "support/check.h"

typedef struct duration {
    const char *text;
    double seconds;
} duration;

static void numbers_with_a_unit(void **state)
{
    (void)state;
    static const duration GOOD[] = {
        {"90 s", 90.0},   {"90s", 90.0},  {"30 min", 1800.0}, {"2.5 h", 9000.0},
        {"1 d", 86400.0}, {"0.5 s", 0.5}, {"1e2 s", 100.0},   {"0.25 d", 21600.0},
    };
    for (size_t k = 0; k < sizeof GOOD / sizeof *GOOD; k++) {
        double seconds = -1.0;
        assert_true(clod_duration_read(GOOD[k].text, &seconds));
        check_close(seconds, GOOD[k].seconds, 0.0);
    }
}

static void times_as_batch_systems_write_them(void **state)
{
    (void)state;
    static const duration GOOD[] = {
        {"30:00", 1800.0},                               // minutes:seconds
        {"90:30", 5430.0},                               // more than an hour of them
        {"00:01", 1.0},           {"12:30:15", 45015.0}, // hours:minutes:seconds
        {"100:00:00", 360000.0},                         // more than a day of them
        {"00:00:59", 59.0},       {"1-0", 86400.0},      // days-hours
        {"2-12", 216000.0},       {"1-12:30", 131400.0}, // days-hours:minutes
        {"1-12:30:15", 131415.0},                        // days-hours:minutes:seconds
        {"0-00:00:01", 1.0},
    };
    for (size_t k = 0; k < sizeof GOOD / sizeof *GOOD; k++) {
        double seconds = -1.0;
        assert_true(clod_duration_read(GOOD[k].text, &seconds));
        check_close(seconds, GOOD[k].seconds, 0.0);
    }
}

static void anything_else_is_refused(void **state)
{
    (void)state;
    static const char *const BAD[] = {
        "",        " ",       "90",      "s",      "90 m",    "90 hours",   "30:60",  "1:60:00",
        "1:00:60", "1:2:3:4", "1-",      "-1",     "-1:00",   "1:-5",       "1-2-3",  "1:2-3",
        "12:30:",  ":30",     "12 : 30", "1.5:00", "1-12:60", "1-12:00:60", "0 s",    "-5 s",
        "00:00",   "0-0",     "nan s",   "inf h",  "1e999 s", "1234567:00", "30:00 ",
    };
    for (size_t k = 0; k < sizeof BAD / sizeof *BAD; k++) {
        double seconds;
        if (clod_duration_read(BAD[k], &seconds)) {
            fail_msg("'%s' was read as %g s", BAD[k], seconds);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_with_a_unit),
        cmocka_unit_test(times_as_batch_systems_write_them),
        cmocka_unit_test(anything_else_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
