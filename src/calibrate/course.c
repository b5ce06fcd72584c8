#include "calibrate/course.h"

#include <jansson.h>

#include "base/json.h"
#include "base/memory.h"
#include "output/folder_files.h"

#define NAME "course.json"

bool clod_course_read(clod_runs *runs, clod_status *status)
{
    void *text = NULL;
    size_t length;
    runs->counted_workers = runs->options.workers;
    if (!clod_folder_read(runs->folder, NAME, &text, &length, status)) {
        return false;
    }
    if (text == NULL) {
        return true;
    }
    json_t *found = clod_json_parse(text, length, NULL);
    clod_memory_free(text);
    const json_t *budget = json_object_get(found, "budget_s");
    const json_int_t workers = json_integer_value(json_object_get(found, "workers"));
    const bool good = json_is_number(budget) && workers >= 1;
    if (good && json_number_value(budget) == runs->plan->budget) {
        runs->counted_workers = (int)workers;
    }
    json_decref(found);
    if (clod_json_lacks_memory()) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %s/" NAME ".",
                                runs->folder->path);
    }
    return good ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s/" NAME ": damaged; remove it, and the budget is counted "
                            "anew",
                            runs->folder->path);
}

bool clod_course_write(const clod_runs *runs, clod_status *status)
{
    json_t *made = json_pack("{s:f, s:i}", "budget_s", runs->plan->budget, "workers",
                             runs->counted_workers);
    const bool good = clod_folder_write_json(runs->folder, NAME, made, status);
    json_decref(made);
    return good;
}
