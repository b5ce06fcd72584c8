// Janssen's silo: friction on the wall carries part of the weight, so that what stands on a
// layer saturates with the depth. The floor sinks slowly, as in the experiments of Vanel &
// Clement, so that the grains slip down the wall everywhere.
#include <math.h>
#include <string.h>

#include "analysis/fit.h"
#include "tester/limits.h"
#include "verify/saturation.h"
#include "verify/silo.h"
#include "verify/suite.h"

#define WALL_FRICTION 0.3   ///< well below what the grains bear among themselves
#define HOLD 1.0            ///< rolling friction that no shear on the wall overcomes
#define RANKINE (1.0 / 3.0) ///< (1 - sin 30 deg)/(1 + sin 30 deg): active
#define LAW_POINTS 60
#define SOURCE "Janssen (1895), transl. Sperl, Granular Matter 8 (2006) 59"

/** Seeds of the same silo; then one whose grains do not roll on the wall, one without friction.
 */
enum { FIRST, SECOND, HELD, SMOOTH, SILOS };

static const clod_verify_silo SILO[SILOS] = {
    [FIRST] = {.name = "janssen-1", .seed = 1, .friction = WALL_FRICTION},
    [SECOND] = {.name = "janssen-2", .seed = 2, .friction = WALL_FRICTION},
    [HELD] = {.name = "janssen-held", .seed = 1, .friction = WALL_FRICTION, .rolling = HOLD},
    [SMOOTH] = {.name = "janssen-smooth", .seed = 1},
};

static bool check_silo(const clod_verify_bench *bench, const clod_verify_silo *of,
                       clod_status *status)
{
    const clod_verify_expect whole = {1.0, 1e-3, true, "Newton's second law"};
    const clod_verify_expect shallow = {0.0, CLOD_LIMITS_OVERLAP_MOST, false,
                                        "docs/theory/time-step.md"};
    return clod_verify_bench_check(
               bench, &whole, clod_verify_silo_carried(of) / of->weight, status,
               "%s: force of floor and wall less inertia, over the weight [1]", of->name) &&
           clod_verify_bench_check(bench, &shallow, of->overlap, status,
                                   "%s: largest overlap over the radius [1]", of->name);
}

/** K, of the filled silo and of those whose grains slip down the wall. */
static bool check_ratio(const clod_verify_bench *bench, const clod_verify_silo *of,
                        clod_status *status)
{
    const clod_verify_expect between = {0.5 * (1.0 + RANKINE), 0.5 * (1.0 - RANKINE), false,
                                        "Rankine's active state at 30 deg to hydrostatic"};
    if (!clod_verify_bench_check(bench, &between, clod_verify_silo_stress_ratio(of), status,
                                 "%s: stress on the wall over the vertical one, K [1]",
                                 of->name)) {
        return false;
    }
    if (of->friction > 0.0 && of->rolling == 0.0) {
        clod_verify_bench_record_miss(bench, "hydrostatic is no bound of theory (Rankine's "
                                             "passive state has 3), only our guess for a silo");
    }
    return true;
}

/** With friction: the length of saturation beside what friction and K of the wall say. */
static bool check_length(const clod_verify_bench *bench, const clod_verify_silo *of,
                         clod_status *status)
{
    const double friction = clod_verify_silo_wall_friction(of);
    const double length =
        CLOD_VERIFY_SILO_DIAMETER / (4.0 * friction * clod_verify_silo_stress_ratio(of));
    const clod_verify_silo_profile joints = clod_verify_silo_joints(of);
    const double saturated =
        clod_verify_saturation_fit(joints.filled, joints.apparent, joints.count);
    const clod_verify_expect same = {length, 0.05, true, SOURCE};
    return clod_verify_bench_check(
        bench, &same, saturated / clod_verify_silo_line_weight(of), status,
        "%s: lambda of the fit beside D/(4 mu K) with mu = %.3f of the wall [m]", of->name,
        friction);
}

/** Grains that do not roll slip: friction of the wall is that of its contacts. */
static bool check_held(const clod_verify_bench *bench, const clod_verify_silo *of,
                       clod_status *status)
{
    const clod_verify_expect coulomb = {WALL_FRICTION, 0.05, true, "Coulomb: fully mobilised"};
    return clod_verify_bench_check(bench, &coulomb, clod_verify_silo_wall_friction(of), status,
                                   "%s: shear over normal force of the wall [1]", of->name);
}

/** Without friction: all on the floor, and the stress on the wall goes with the depth. */
static bool check_smooth(const clod_verify_bench *bench, const clod_verify_silo *of,
                         clod_status *status)
{
    double depth[CLOD_VERIFY_SILO_SHELLS];
    double wall[CLOD_VERIFY_SILO_SHELLS];
    size_t count = 0;
    for (int s = CLOD_VERIFY_SILO_LOW; s < CLOD_VERIFY_SILO_HIGH; s++) {
        depth[count] = clod_verify_silo_stands_on(of, s) * 4.0 * CLOD_VERIFY_SILO_SHELL /
                       CLOD_VERIFY_SILO_DIAMETER;
        wall[count++] = of->normal[s];
    }
    const clod_fit line = clod_fit_line(depth, wall, count);
    const clod_verify_expect weight = {1.0, 1e-3, true, "hydrostatics"};
    const clod_verify_expect same = {clod_verify_silo_stress_ratio(of), 0.1, true,
                                     "hydrostatics: K does not depend on the depth"};
    return clod_verify_bench_check(bench, &weight, (of->floor - of->inertia) / of->weight,
                                   status, "%s: floor less inertia, over the weight [1]",
                                   of->name) &&
           clod_verify_bench_check(bench, &same, line.slope, status,
                                   "%s: slope of the stress on the wall over the vertical one, "
                                   "beside their ratio K [1]",
                                   of->name);
}

/** Root mean square distance of both seeds from their common law, over their own scatter. */
static double misfit(const clod_verify_silo_profile joints[2], double saturated)
{
    double about = 0.0;
    double between = 0.0;
    const size_t count = joints[0].count < joints[1].count ? joints[0].count : joints[1].count;
    for (size_t j = 0; j < count; j++) { // counted from the floor, the same places in both
        double off[2];
        for (int c = 0; c < 2; c++) {
            const size_t at = joints[c].count - 1 - j;
            off[c] = joints[c].apparent[at] -
                     clod_verify_saturation_at(joints[c].filled[at], saturated);
        }
        about += 0.5 * (off[0] * off[0] + off[1] * off[1]);
        between += 0.5 * (off[0] - off[1]) * (off[0] - off[1]);
    }
    return sqrt(about / between);
}

/** Write the joints of a silo. */
static void put_joints(clod_verify_curve *curve, const clod_verify_silo_profile *joints,
                       int column)
{
    for (size_t j = 0; j < joints->count; j++) {
        double row[] = {joints->filled[j], NAN, NAN, NAN, NAN, NAN};
        row[column] = joints->apparent[j];
        clod_verify_curve_add(curve, row, 6);
    }
}

static bool write_curve(const clod_verify_bench *bench, const clod_verify_silo silo[SILOS],
                        double saturated, clod_status *status)
{
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, bench->test,
        "weight above [N],clod: weight that stands below; seed 1 [N],clod: seed 2 [N],"
        "clod: no friction on the wall [N],Janssen [N],hydrostatic [N]",
        status);
    if (curve == NULL) {
        return false;
    }
    const int shown[] = {FIRST, SECOND, SMOOTH};
    for (int c = 0; c < 3; c++) {
        const clod_verify_silo_profile joints = clod_verify_silo_joints(&silo[shown[c]]);
        put_joints(curve, &joints, 1 + c);
    }
    for (int i = 0; i <= LAW_POINTS; i++) {
        const double filled = silo[FIRST].weight * i / LAW_POINTS;
        const double row[] = {
            filled, NAN, NAN, NAN, clod_verify_saturation_at(filled, saturated), filled};
        clod_verify_curve_add(curve, row, 6);
    }
    return clod_verify_curve_close(&curve, status);
}

/** One law through both seeds. */
static bool check_law(const clod_verify_bench *bench, const clod_verify_silo silo[SILOS],
                      clod_status *status)
{
    const clod_verify_silo_profile joints[2] = {clod_verify_silo_joints(&silo[FIRST]),
                                                clod_verify_silo_joints(&silo[SECOND])};
    double filled[2 * CLOD_VERIFY_SILO_SHELLS];
    double apparent[2 * CLOD_VERIFY_SILO_SHELLS];
    size_t count = 0;
    for (int c = 0; c < 2; c++) {
        const size_t size = joints[c].count * sizeof *filled;
        memcpy(filled + count, joints[c].filled, size);
        memcpy(apparent + count, joints[c].apparent, size);
        count += joints[c].count;
    }
    const double saturated = clod_verify_saturation_fit(filled, apparent, count);
    const clod_verify_expect scatter = {0.0, 2.0, false, SOURCE};
    return clod_verify_bench_check(bench, &scatter, misfit(joints, saturated), status,
                                   "janssen-1, janssen-2: distance from the law, over the "
                                   "scatter between them, rms [1]") &&
           write_curve(bench, silo, saturated, status);
}

bool clod_verify_janssen(const clod_verify_bench *bench, clod_status *status)
{
    clod_verify_silo silo[SILOS];
    for (int k = 0; k < SILOS; k++) {
        silo[k] = SILO[k];
        if (!clod_verify_silo_run(&silo[k], bench, status) ||
            !check_silo(bench, &silo[k], status) || !check_ratio(bench, &silo[k], status) ||
            (k != SMOOTH && !check_length(bench, &silo[k], status))) {
            return false;
        }
    }
    return check_law(bench, silo, status) && check_held(bench, &silo[HELD], status) &&
           check_smooth(bench, &silo[SMOOTH], status);
}
