// A sweep over one parameter, the restitution, each value in a thread with a simulation of its
// own.
#include <math.h>
#include <pthread.h>
#include <stdio.h>

#include <clod/sim.h>

static const char CASE[] =
    "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"
    "time: {step: 0.2 us}\n"
    "stages: [{name: all, duration: 1 s}]\n" // a case needs one; this program decides instead
    "materials:\n"
    "  glass: {density: 2500 kg/m3}\n"
    "contacts:\n"
    "  default: {law: hooke, k1: 1e5 N/m, restitution: %.2f, friction: 0}\n"
    "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
    "grains:\n"
    "  - material: glass\n"
    "    count: 1\n"
    "    radius: {distribution: uniform, min: 5 mm, max: 5 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [20 mm, 20 mm, 20 mm]}}\n"
    "    velocity: [0 m/s, 0 m/s, -1 m/s]\n"
    "walls:\n"
    "  plate: {material: glass, shapes: [\n"
    "    {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n";

#define POINTS 4

typedef struct point {
    double asked, got;
    bool ok;
    clod_status status;
} point;

static void *run(void *context)
{
    point *self = context;
    char text[sizeof CASE + 16];
    clod_sim_view velocity;
    const clod_sim_options options = {.threads = 1};
    snprintf(text, sizeof text, CASE, self->asked);
    clod_sim *sim = clod_sim_create_from_text("sweep.yaml", text, &options, &self->status);
    self->ok = sim != NULL && clod_sim_advance(sim, 150000, &self->status) &&
               clod_sim_array(sim, "velocity", &velocity, &self->status);
    if (self->ok) {
        self->got = clod_sim_row(&velocity, 0)[2];
    }
    clod_sim_destroy(&sim);
    return NULL;
}

int main(void)
{
    static point points[POINTS];
    pthread_t threads[POINTS];
    int wrong = 0;
    for (int p = 0; p < POINTS; p++) {
        points[p].asked = 0.3 + 0.2 * p;
        if (pthread_create(&threads[p], NULL, run, &points[p]) != 0) {
            fputs("no thread\n", stderr);
            return 1;
        }
    }
    for (int p = 0; p < POINTS; p++) {
        pthread_join(threads[p], NULL);
        if (!points[p].ok) {
            fprintf(stderr, "%s\n", points[p].status.text);
            wrong++;
            continue;
        }
        printf("restitution %.4f, asked for %.2f\n", points[p].got, points[p].asked);
        wrong += fabs(points[p].got - points[p].asked) > 0.01;
    }
    printf("%d of %d points wrong\n", wrong, POINTS);
    return wrong;
}
