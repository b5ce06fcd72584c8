#include "sim/job_tables.h"

#include "sim/energy_series.h"
#include "sim/job_store.h"
#include "sim/leavers_table.h"

bool clod_job_tables_open(clod_job_tables *self, clod_job *job, clod_status *status)
{
    const clod_case_output *wanted = &job->sim->from->output;
    const clod_folder *folder = job->sim->folder;
    clod_job_memory *memory = &job->memory;
    char series[CLOD_JOB_STEM], energy[CLOD_JOB_STEM];
    clod_job_table_names(job->name, series, energy);
    *self = (clod_job_tables){0};
    self->series =
        clod_series_open(folder, series, job->procedure.columns, job->procedure.column_count,
                         job->resumed ? &memory->series : NULL, status);
    bool ok = self->series != NULL;
    if (ok && wanted->energy) {
        self->energy = clod_series_open(folder, energy, clod_energy_series_columns,
                                        CLOD_ENERGY_SERIES_COLUMNS,
                                        job->resumed ? &memory->energy : NULL, status);
        ok = self->energy != NULL;
    }
    if (ok && wanted->leavers) {
        self->leavers = clod_series_open(folder, CLOD_LEAVERS_TABLE, CLOD_LEAVERS_TABLE_COLUMN,
                                         CLOD_LEAVERS_TABLE_COLUMNS,
                                         job->resumed ? &memory->leavers : NULL, status);
        ok = self->leavers != NULL;
        job->state.gone.kept = true;
    }
    return ok;
}

bool clod_job_tables_leavers(clod_job_tables *self, clod_job *job, clod_status *status)
{
    return self->leavers == NULL ||
           clod_leavers_table_write(self->leavers, job->sim->from, &job->state, status);
}

static bool mark(clod_series *table, clod_series_mark *at, clod_status *status)
{
    if (table == NULL) {
        return true;
    }
    *at = clod_series_position(table);
    return clod_series_sync(table, status);
}

bool clod_job_tables_mark(clod_job_tables *self, clod_job *job, clod_status *status)
{
    clod_job_memory *memory = &job->memory;
    return clod_job_tables_leavers(self, job, status) &&
           mark(self->leavers, &memory->leavers, status) &&
           mark(self->energy, &memory->energy, status) &&
           mark(self->series, &memory->series, status);
}

bool clod_job_tables_close(clod_job_tables *self, bool ok, clod_status *status)
{
    clod_status closing; // an error before it is the one to report
    ok = clod_series_close(&self->series, ok ? status : &closing) && ok;
    ok = clod_series_close(&self->energy, ok ? status : &closing) && ok;
    return clod_series_close(&self->leavers, ok ? status : &closing) && ok;
}
