#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Links firmware for a board with less RAM than it takes: small_ram.py SCRIPT SIZE DIRECTORY COMMAND...

The linker must refuse with the number of bytes that are missing. COMMAND is the link without script and output; SIZE is
what tools/size.py says of the firmware that fits. Prints nothing and exits with 0 when all is as it should be.
"""
import os
import re
import subprocess
import sys

MISSING = 1000


def main():
    script, size, directory = sys.argv[1:4]
    with open(size) as file:
        taken = int(re.search(r"RAM (\d+) ", file.read())[1])
    with open(script) as file:
        text, count = re.subn(r"(RAM \(rw\) : ORIGIN = \w+, LENGTH = )[^\n]+", r"\g<1>%d" % (taken - MISSING), file.read())
    small = os.path.join(directory, "small.ld")
    with open(small, "w") as file:
        file.write(text)
    link = subprocess.run(sys.argv[4:] + ["-T", small, "-o", os.path.join(directory, "small.elf")],
                          stderr=subprocess.PIPE, text=True)
    said = re.findall(r"region .RAM. overflowed by (\d+) bytes", link.stderr)
    if count != 1 or link.returncode == 0 or said != [str(MISSING)]:
        print("FAILED: %s without %d bytes of RAM: exit status %d, %s bytes missing: %s" % (
            script, MISSING, link.returncode, said, link.stderr[-300:]))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
