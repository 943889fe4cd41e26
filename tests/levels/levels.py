#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same bits however the library is built: levels.py --count N --seed N PROGRAM PROGRAM...

Each program draws the same random scenes, its library built at another level or with the code of another core. A scene
that one of them draws otherwise than the first is a failure; the line tells its seed: `PROGRAM 1 SEED` draws it alone.
"""
import argparse
import concurrent.futures
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests", "board"))
from qemu import Tally  # noqa: E402

SHOWN = 8


def draw(program, count, seed):
    return subprocess.run([program, str(count), str(seed)], stdout=subprocess.PIPE, text=True, check=False)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("programs", nargs="+")
    arguments = parser.parse_args()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        ended = list(pool.map(lambda program: draw(program, arguments.count, arguments.seed), arguments.programs))
    printed = [process.stdout.splitlines() for process in ended]
    tally = Tally()
    first = printed[0]
    tally.check(ended[0].returncode == 0 and len(first) == arguments.count,
                "%s: status %d behind %d scenes" % (arguments.programs[0], ended[0].returncode, len(first)))
    drawn = sum(": 0 " in line for line in first)
    tally.check(drawn >= len(first) * 0.9, "only %d of %d scenes are drawn" % (drawn, len(first)))
    for program, process, lines in zip(arguments.programs[1:], ended[1:], printed[1:]):
        others = ["%s, not %s" % (there, here.rsplit(": ", 1)[1]) for here, there in zip(first, lines) if here != there]
        tally.check(process.returncode == 0 and len(lines) == len(first) and not others,
                    "%s: status %d behind %d scenes, of which %d differ\n  %s" %
                    (program, process.returncode, len(lines), len(others), "\n  ".join(others[:SHOWN])))
    print("%d scenes from seed %d, each by %d libraries" % (len(first), arguments.seed, len(printed)))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
