// The blockage alarm of gauges: when it begins and ends, and what is said of that.

#include <math.h>

#include "sim/gauges.h"

bool clod_gauges_watch(clod_gauge_alarm *self, const clod_case_gauge *gauge, const double *sums,
                       const clod_state *state)
{
    const clod_case_blocked *limit = &gauge->blocked;
    const double mass = sums[CLOD_GAUGE_MASS];
    const bool slow = gauge->has_blocked && mass >= limit->mass_above &&
                      sums[CLOD_GAUGE_SPEED] <= limit->speed_below * mass;
    self->mass = mass;
    self->speed = mass > 0.0 ? sums[CLOD_GAUGE_SPEED] / mass : 0.0;
    if (!slow) {
        self->slow_since = -1;
        self->on = 0;
        return false;
    }
    self->slow_since = self->slow_since < 0 ? state->step : self->slow_since;
    const double steps = (double)(state->step - self->slow_since);
    const bool on = steps >= round(limit->duration / state->dt);
    if (on && self->on == 0) {
        self->alarms++;
        self->first = self->first < 0 ? self->slow_since : self->first;
    }
    self->on = on;
    return on;
}

/** A sentence, and the same as fields. */
static void describe(const clod_gauge_alarm *self, const char *name, const clod_state *state,
                     clod_news *news)
{
    news->event = self->on != 0 ? "alarm begins" : "alarm ends";
    news->fields =
        json_pack("{s:s, s:I, s:f, s:f, s:f}", "gauge", name, "step", (json_int_t)state->step,
                  "time_s", state->time, "mass_kg", self->mass, "speed_m_per_s", self->speed);
    if (self->on != 0) {
        const double since = (double)self->slow_since * state->dt;
        json_object_set_new(news->fields, "since_s", json_real(since));
        snprintf(news->text, sizeof news->text,
                 "warning: gauge %s is blocked since %.6g s: at %.6g s it holds %.4g kg that "
                 "move at %.3g m/s",
                 name, since, state->time, self->mass, self->speed);
    } else {
        snprintf(news->text, sizeof news->text,
                 "gauge %s is not blocked any more: at %.6g s it holds %.4g kg that move at "
                 "%.3g m/s",
                 name, state->time, self->mass, self->speed);
    }
}

bool clod_gauges_news(void *memory, const clod_case *from, const clod_state *state,
                      clod_news *news)
{
    clod_gauges *self = memory;
    for (size_t k = 0; k < from->gauge_count; k++) {
        clod_gauge_alarm *alarm = &self->gauge[k].alarm;
        if (alarm->on != alarm->reported) {
            alarm->reported = alarm->on;
            describe(alarm, from->gauges[k].name, state, news);
            return true;
        }
    }
    return false;
}
