// Numbers of grains that are lent to the caller as a copy: of several ranks the state has the grains
// only when somebody looks, and what the caller writes must get back to them.
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "sim/sim.h"

struct clod_sim_loan {
    clod_sim_loan *before; ///< smaller one, lent earlier; owned
    size_t capacity;       ///< bytes
    _Alignas(64) char rows[];
};

static size_t row_bytes(const clod_sim_view *view)
{
    static const size_t BYTES[] = {[CLOD_SIM_F64] = sizeof(double),
                                   [CLOD_SIM_U64] = sizeof(uint64_t),
                                   [CLOD_SIM_U16] = sizeof(uint16_t),
                                   [CLOD_SIM_I32] = sizeof(int32_t)};
    return view->components * BYTES[view->type];
}

/** Room for a loan. Those that were too small stay: somebody may still hold a view of them. */
static bool make_room(clod_sim *self, size_t array, size_t bytes, clod_status *status)
{
    clod_sim_loan *before = self->loan[array];
    if (before != NULL && before->capacity >= bytes) {
        return true;
    }
    const size_t capacity =
        bytes + bytes / 2; // all of them together are no more than thrice this
    clod_sim_loan *made = clod_memory_alloc(1, sizeof *made + capacity);
    if (made == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a view of %zu bytes",
                                bytes);
    }
    made->before = before;
    made->capacity = capacity;
    self->loan[array] = made;
    return true;
}

/** The numbers of a view of the state, into the loan of the same property. */
static void fill(clod_sim *self, size_t array, const clod_sim_view *view)
{
    const size_t bytes = row_bytes(view);
    char *to = self->loan[array]->rows;
    for (size_t g = 0; g < view->rows; g++) {
        memcpy(to + g * bytes, (const char *)view->data + g * view->stride, bytes);
    }
    self->lent[array] = view->rows * bytes;
}

bool clod_sim_lend(clod_sim *self, size_t array, clod_sim_view *view, clod_status *status)
{
    const size_t bytes = row_bytes(view);
    if (self->lent[array] == 0) {
        if (!make_room(self, array, view->rows * bytes, status)) {
            return false;
        }
        fill(self, array, view);
    }
    view->data = self->loan[array]->rows;
    view->stride = bytes;
    return true;
}

/** What was written into a loan, into the state. */
static void fetch_array(clod_sim *self, size_t array)
{
    const clod_sim_view view = clod_sim_view_of(self, array);
    const size_t bytes = row_bytes(&view);
    CLOD_ASSERT(view.rows * bytes == self->lent[array]);
    for (size_t g = 0; view.writable && g < view.rows; g++) {
        char *to = (char *)view.data + g * view.stride;
        const char *from = self->loan[array]->rows + g * bytes;
        if (memcmp(to, from, bytes) != 0) {
            memcpy(to, from, bytes);
            self->written = true;
        }
    }
}

void clod_sim_fetch(clod_sim *self)
{
    for (size_t k = 0; k < CLOD_SIM_ARRAYS; k++) {
        if (self->lent[k] > 0) {
            fetch_array(self, k);
        }
    }
}

bool clod_sim_take(clod_sim *self, clod_status *status)
{
    clod_sim_fetch(self);
    if (!self->written || self->state.changes.moved) { // a change deals them anyway
        return true;
    }
    self->written = false;
    return clod_step_renew(&self->step, status);
}

void clod_sim_renew_loans(clod_sim *self)
{
    for (size_t k = 0; k < CLOD_SIM_ARRAYS; k++) {
        if (self->lent[k] > 0) {
            const clod_sim_view view = clod_sim_view_of(self, k);
            fill(self, k, &view);
        }
    }
}

void clod_sim_recall(clod_sim *self)
{
    for (size_t k = 0; k < CLOD_SIM_ARRAYS; k++) {
        if (self->lent[k] > 0) { // no numbers, and no id that a grain has
            memset(self->loan[k]->rows, 0xff, self->lent[k]);
            self->lent[k] = 0;
        }
    }
}

void clod_sim_free_loans(clod_sim *self)
{
    for (size_t k = 0; k < CLOD_SIM_ARRAYS; k++) {
        while (self->loan[k] != NULL) {
            clod_sim_loan *before = self->loan[k]->before;
            clod_memory_free(self->loan[k]);
            self->loan[k] = before;
        }
    }
}
