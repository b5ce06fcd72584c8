"""Checkpoints store some structs as plain bytes: another layout needs another format number.

checkpoint_parts.txt holds the number and the declarations that belong to it. When this test
fails, raise CLOD_CHECKPOINT_FORMAT (src/output/checkpoint_file.h), then write the file anew:

    python3 tests/output/test_checkpoint_parts.py --record
"""

import os
import re
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RECORD = os.path.join(ROOT, "tests/output/checkpoint_parts.txt")
# What src/sim hands to clod_checkpoint_write as parts, what those structs are made of, and impacts.
PARTS = [("src/tester/ring_shear.h", ["clod_ring_shear_kind", "clod_ring_shear_phase",
                                      "clod_ring_shear_flag", "clod_ring_shear"]),
         ("src/tester/uniaxial.h", ["clod_uniaxial_phase", "clod_uniaxial_flag",
                                    "clod_uniaxial"]),
         ("src/tester/wall_shear.h", ["clod_wall_shear_phase", "clod_wall_shear_flag",
                                      "clod_wall_shear_point", "clod_wall_shear"]),
         ("src/measure/steady.h", ["CLOD_STEADY_MAX", "clod_steady"]),
         ("src/measure/peak.h", ["CLOD_PEAK_BINS", "clod_peak"]),
         ("src/sim/free_stages.h", ["clod_free_end", "clod_free_stages",
                                     "clod_free_stage_end"]),
         ("src/sim/free_measures.c", ["clod_free_memory"]),
         ("src/sim/inlets.h", ["clod_inlet", "clod_inlets"]),
         ("src/measure/gauge.h", ["clod_gauge"]),
         ("src/measure/gauge_bins.h", ["clod_gauge_bin", "clod_gauge_section"]),
         ("src/sim/belt_work.h", ["clod_belt_work"]),
         ("src/sim/belt_loads.c", ["belt_memory", "belts"]),
         ("src/sim/gauges.h", ["clod_gauge_alarm", "clod_gauge_passed", "clod_gauge_memory", "clod_gauges"]),
         ("src/measure/continuum.h", ["CLOD_CONTINUUM_SUMS"]),
         ("src/sim/fields.h", ["clod_field_memory"]),
         ("src/measure/mixing.h", ["clod_mixing"]),
         ("src/measure/repose.h", ["clod_repose_angle"]),
         ("src/sim/mixing.h", ["clod_mixing_mean"]),
         ("src/sim/mixing.c", ["mixing_memory"]),
         ("src/sim/repose.c", ["repose_memory"]),
         ("src/sim/part_measures.c", ["part_notes"]),
         ("src/sim/balance.h", ["clod_balance_count", "clod_balance"]),
         ("src/sim/steady_time.h", ["clod_steady_time"]),
         ("src/state/clump_class.h", ["CLOD_CLUMP_CLASSES"]),
         ("src/state/time_class.h", ["CLOD_TIME_CLASSES"]),
         ("src/measure/clumps.h", ["clod_clump_stats", "clod_clump_sizes"]),
         ("src/measure/clumps_look.h", ["CLOD_CLUMPS_CHOICES", "clod_clump_lives"]),
         ("src/sim/clumps.h", ["clod_clump_count", "clod_clump_memory"]),
         ("src/sim/build_up.h", ["CLOD_BUILD_UP_PARTS", "CLOD_BUILD_UP_POINTS"]),
         ("src/sim/build_up.c", ["past", "build_up"]),
         ("src/measure/strength_grid.h", ["clod_strength_force", "clod_strength_cell"]),
         ("src/sim/history_map.c", ["history_map"]),
         ("src/state/impacts.h", ["CLOD_IMPACT_ANGLES", "CLOD_IMPACT_BOUNDS", "clod_impact_class",
                                  "clod_impact_sums", "clod_impacts"]),
         ("src/state/planes.h", ["clod_plane", "clod_passed"]),
         ("src/output/series.h", ["clod_series_mark"]),
         ("src/output/snapshot.h", ["clod_snapshot_film"]),
         ("src/sim/job.h", ["clod_job_memory"])]
COMMENT = r"/\*.*?\*/|//[^\n]*"


def code(path):
    """Source without comments."""
    with open(os.path.join(ROOT, path)) as file:
        return re.sub(COMMENT, "", file.read(), flags=re.DOTALL)


def declaration(text, name):
    """One line for a #define, one for each member of a struct or an enum."""
    define = re.search(rf"^#define {name} .*$", text, re.MULTILINE)
    if define:
        return [" ".join(define[0].split())]
    found = re.search(rf"^typedef (struct|enum) {name} \{{(.*?)^\}} {name};", text,
                      re.DOTALL | re.MULTILINE)
    end = ";" if found[1] == "struct" else ","
    members = [" ".join(member.split()) for member in found[2].split(end)]
    return [f"{found[1]} {name}", *("    " + member for member in members if member)]


def now():
    number = re.search(r"#define CLOD_CHECKPOINT_FORMAT (\d+)",
                       code("src/output/checkpoint_file.h"))[1]
    lines = [line for path, names in PARTS for name in names
             for line in declaration(code(path), name)]
    return number, lines


def recorded():
    with open(RECORD) as file:
        lines = file.read().splitlines()
    return lines[0].removeprefix("format "), lines[1:]


class Parts(unittest.TestCase):

    maxDiff = None

    def test_layout_belongs_to_format(self):
        number, lines = now()
        known, known_lines = recorded()
        if number == known:
            self.assertEqual(known_lines, lines, "data of checkpoints changed, the format did "
                             f"not; what to do stands in {os.path.relpath(__file__, ROOT)}")
        self.assertEqual(known, number, "record the data of this format: "
                         f"python3 {os.path.relpath(__file__, ROOT)} --record")


if __name__ == "__main__":
    if sys.argv[1:] == ["--record"]:
        number, lines = now()
        with open(RECORD, "w") as file:
            file.write("\n".join([f"format {number}", *lines, ""]))
    else:
        unittest.main()
