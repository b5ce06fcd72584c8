#include "report/report.h"

bool clod_report_compare(const clod_report_options *options, char **path, clod_status *status)
{
    (void)options;
    *path = NULL;
    return clod_status_fail(status, CLOD_USAGE, "not yet");
}
