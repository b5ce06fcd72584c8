"""
Counts what the kernel does in a step, instruction by instruction: valgrind says how often each
address of the AVX2 kernel was executed, objdump what is there. A lane counts as one operation,
whether its contact is closed or not. All sets do the same arithmetic, so AVX-512, which valgrind
does not know, needs as many operations.
"""

import collections
import os
import re
import subprocess
import tempfile

from programs import ProgramError, call

STEPS = 20
LANES = {"pd": 4, "sd": 1}  # packed and single doubles of AVX2
# what counts as what; an instruction that multiplies and adds counts twice
KINDS = {"flops": r"v?(add|sub|mul|min|max)(pd|sd)", "divides": r"v?div(pd|sd)",
         "roots": r"v?sqrt(pd|sd)"}
FUSED = r"vf(n?m(add|sub)|maddsub|msubadd)\d*(pd|sd)"
FUNCTION = "kernel_"  # kernel_contact, kernel_drift, kernel_kick, ...


def _executed(program, packing):
    """How often each address of each function of the kernel was executed."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "out")
        call(["valgrind", "--tool=callgrind", "--dump-instr=yes", "--compress-strings=no",
              "--compress-pos=no", "--toggle-collect=clod_step_advance",
              f"--callgrind-out-file={path}", program, *packing, "--simd", "avx2", "--warm",
              "0", "--steps", str(STEPS)])
        with open(path) as file:
            return parse_counts(file)


def parse_counts(lines):
    """Counts by (function, address) of a callgrind file; costs of calls are left out."""
    counts = collections.Counter()
    function, skip = "", False
    for line in lines:
        if line.startswith("fn="):
            function = line[3:].strip()
        elif line.startswith("calls="):
            skip = True
        elif line.startswith("0x"):
            address, _, cost = line.split()
            if not skip and function.startswith(FUNCTION):
                counts[function, int(address, 16)] += int(cost)
            skip = False
    return counts


def parse_code(text):
    """Mnemonic at each address of a disassembly."""
    found = re.findall(r"^ *([0-9a-f]+):\t(\S+)", text, re.M)
    return {int(address, 16): mnemonic for address, mnemonic in found}


def operations(counts, code):
    """Operations by function and kind."""
    sums = collections.defaultdict(collections.Counter)
    for (function, address), count in counts.items():
        if address not in code:
            raise ProgramError(f"objdump shows no instruction at {address:#x} of {function}")
        mnemonic = code[address]
        for kind, pattern in KINDS.items():
            found = re.fullmatch(pattern, mnemonic)
            if found:
                sums[function][kind] += count * LANES[found.groups()[-1]]
        found = re.fullmatch(FUSED, mnemonic)
        if found:
            sums[function]["flops"] += 2 * count * LANES[found.groups()[-1]]
    return sums


def kernel(program, packing, grains):
    """Operations per grain and step, by function of the kernel and kind."""
    code = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], text=True,
                          stdout=subprocess.PIPE, check=True).stdout
    sums = operations(_executed(program, packing), parse_code(code))
    if not sums:
        raise ProgramError(f"{program}: valgrind saw no function {FUNCTION}*")
    return {function: {kind: n / (grains * STEPS) for kind, n in kinds.items()}
            for function, kinds in sums.items()}
