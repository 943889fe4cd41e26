# SPDX-License-Identifier: MIT
"""Cycles that a core would take for instructions counted by plugin.c, as its manual documents them.

Memory without wait states, but for waits(). Where the manual gives a range, its middle: of a pipeline's refill, of long products and of
divisions. Left out: waiting for an address that the instruction before computes, contention between fetches and
accesses, caches, integer instructions that are done while a float division is. Skipped instructions of an IT block count as if they were executed.

Sources: Cortex-M0 Technical Reference Manual (ARM DDI 0432C), table 3-1; Cortex-M0+ (ARM DDI 0484C), table 3-1; Cortex-M3
(ARM DDI 0337I), 3.3; Cortex-M4 (ARM DDI 0439B), 3.3 and 7.2.3 for its FPU.
"""
from fractions import Fraction

# Cycles of each kind of thumb.h that are not 1; `taken`: of one that goes elsewhere, before what it transfers. Words of
# several registers take one more each.
_ARMV6M = {"load": 2, "load_next": 2, "store": 2, "store_indexed": 2, "store_next": 2}
# A pipeline's refill takes 1 to 3 cycles.
_REFILL = 2
_ARMV7M = {"load": 2, "store_indexed": 2, "divide": Fraction(2 + 12, 2)}
_ARMV7M_TAKEN = {"branch": 1 + _REFILL, "call": 1 + _REFILL, "jump": 1 + _REFILL, "table": 2 + 1 + 3,
                 "load_jump": 2 + _REFILL, "multiple_jump": 1 + _REFILL}

CORES = {
    "m0": (dict(_ARMV6M, multiply=32, system=4),
           {"branch": 3, "call": 4, "jump": 3, "multiple_jump": 4}),
    "m0+": (dict(_ARMV6M, system=3),
            {"branch": 2, "call": 3, "jump": 2, "multiple_jump": 3}),
    "m3": (dict(_ARMV7M, multiply_add=2, multiply_long=Fraction(3 + 5, 2), accumulate_long=Fraction(4 + 7, 2)),
           _ARMV7M_TAKEN),
    "m4": (dict(_ARMV7M, float_add=3, float_divide=14, float_load=2, float_store=2, float_pair=2), _ARMV7M_TAKEN),
}


# Fetches are words (0432C, 0484C: 3.1), and an instruction is fetched while the two before it are decoded and executed, the one
# before it on a Cortex-M0+ (two stages): what is fetched behind a branch that is taken is for nothing.
_AHEAD = {"m0": "code_ahead", "m0+": "code_ahead_of_word"}


def read(path):
    """Counts by name of each line that the plugin wrote."""
    with open(path) as file:
        return [{name: int(count) for name, count in (item.split("=") for item in line.split())} for line in file]


def cycles(counts, core):
    """Cycles, a Fraction."""
    others, taken_ones = CORES[core]
    total = Fraction(0)
    for name, count in counts.items():
        if name.startswith("code_"):
            continue
        if name.endswith("_words"):
            total += count
        elif name.endswith("_taken"):
            if count:
                total += count * (taken_ones[name[:-len("_taken")]] - others.get(name[:-len("_taken")], 1))
        else:
            total += count * others.get(name, 1)
    return total


def instructions(counts):
    return sum(count for name, count in counts.items() if not name.startswith("code_") and not name.endswith(("_words", "_taken")))


def waits(counts, core, code=1, tables=1, data=1):
    """Cycles more of a core with neither cache nor prefetch buffer, where words of each are read with so many wait states.
    Every one is waited for: at most that many, as long instructions may hide some."""
    words = counts["code_words"] + counts[_AHEAD[core]] + counts["code_literals"]
    return code * words + tables * counts["code_tables"] + data * counts["code_data"]
