#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes src/math/tables.c: python3 tools/make_tables.py > src/math/tables.c

Every entry is computed here from its formula; tests/unit checks the functions that read them.
"""
import math

UNIT = 32764  # GLINT_UNIT


def table(ctype, name, comment, values, width):
    print(f"\n/* {comment} */\nconst {ctype} {name}[{len(values)}] = {{")
    for start in range(0, len(values), width):
        print("    " + ", ".join(f"{v}u" for v in values[start:start + width]) + ",")
    print("};")


def chord(function, position, step):
    """A node that halves the error of linear interpolation: the chord of a convex function lies above it."""
    bend = function(position - step) - 2 * function(position) + function(position + step)
    return function(position) - bend / 16


def inverse_root(index):
    return 2**30 * (UNIT / 32768) / math.sqrt(index * 2**23)


# REUSE-IgnoreStart
print("/* SPDX-License-Identifier: MIT */")
# REUSE-IgnoreEnd
print("/* Made by tools/make_tables.py; not to be edited. */")
print("/* clang-format off */")
print('#include "division.h"')
table("uint16_t", "glint_inverse_root_table",
      "2^30 UNIT / 2^15 / sqrt(i 2^23) for i = 32 to 385, less 1/16 of its second difference",
      [min(65535, round(chord(inverse_root, i, 1))) for i in range(32, 386)], 14)
table("uint16_t", "glint_quotient_table", "2^20 / i for i = 16 to 256",
      [min(65535, round(2**20 / i)) for i in range(16, 257)], 14)



def over_length(index):
    return 2**31 / math.sqrt(index * 2**24)


nodes = [min(65535, round(chord(over_length, i, 1) + 0.5)) for i in range(64, 257)]  # results are cut off
table("uint32_t", "glint_length_table",
      "2^31 / sqrt(i 2^24) + 1/2 for i = 64 to 255, less 1/16 of its second difference, times 2^16; and the fall to the next",
      [nodes[i] << 16 | (nodes[i] - nodes[i + 1]) for i in range(192)], 12)
table("uint16_t", "glint_root_table", "2^14 / sqrt((i + 1/2) / 1024) for i = 64 to 1023",
      [round(2**14 / math.sqrt((i + 0.5) / 1024)) for i in range(64, 1024)], 14)
inverses = [round(2**31 / (1 + (i + 0.5) / 32)) for i in range(32)]
table("uint32_t", "glint_log2_inverse_table", "Q31: 1 / (1 + (i + 1/2) / 32)", inverses, 8)
table("uint32_t", "glint_log2_table", "Q31: minus the binary logarithm of the entry above",
      [round(-math.log2(v / 2**31) * 2**31) for v in inverses], 8)
table("uint32_t", "glint_exp2_table", "Q30: 2^(i/32)", [round(2**(i / 32) * 2**30) for i in range(32)], 8)
