#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instructions per source file and per unit: profile.py --qemu QEMU --nm NM --output CSV [--functions] CPU=ELF...

QEMU logs every block of code that it runs (-d exec) and, once, the instructions of each (-d in_asm). Summed by function
and by the source file that a function stands in, they are exact: the same figure on every run.
"""
import argparse
import bisect
import collections
import concurrent.futures
import csv
import os
import re
import subprocess
import sys
import tempfile

TRACE = re.compile(r"Trace \d+: \S+ \[[0-9a-f]+/([0-9a-f]+)/")
LISTED = re.compile(r"0x([0-9a-f]+):")


class Symbols:
    """Functions by address, with the source file of each."""

    def __init__(self, nm, elf):
        rows = []
        for line in subprocess.run([nm, "-l", "--defined-only", elf], check=True, capture_output=True, text=True).stdout.splitlines():
            words, _, place = line.partition("\t")
            address, kind, name = words.split()
            if kind in "tTwW" and not name.startswith("$"):
                rows.append((int(address, 16) & ~1, name, "/".join(place.split(":")[0].split("/")[-2:])))
        rows.sort()
        self.addresses = [row[0] for row in rows]
        self.rows = rows

    def at(self, address):
        return self.rows[bisect.bisect_right(self.addresses, address) - 1]


def stage_of(name, source):
    """Folder and name of a file of src/; what compilers bring; None for the board's."""
    if name.startswith("mem"):
        return "memory"
    if os.path.basename(source) in ("", "lib1funcs.S", "libgcc2.c") or name.startswith("__aeabi"):
        return "division"
    return source.rsplit(".", 1)[0] if os.path.exists(os.path.join("src", source)) else "flush" if source.startswith("profile/") else None


def follow(qemu, elf, mark):
    """What the firmware wrote, and for each frame how often each block ran, with the blocks' lengths."""
    with tempfile.TemporaryDirectory() as directory:
        pipe = os.path.join(directory, "trace")
        os.mkfifo(pipe)
        process = subprocess.Popen(
            [qemu, "-M", "mps2-an385", "-display", "none", "-serial", "none", "-monitor", "none", "-nodefaults",
             "-chardev", "stdio,id=text,signal=off", "-semihosting-config", "enable=on,target=native,chardev=text",
             "-d", "exec,nochain,in_asm", "-D", pipe, "-kernel", elf],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        frames, ran, lengths = [], None, {}
        block = None
        with open(pipe) as trace:
            for line in trace:
                if line.startswith("Trace"):
                    address = int(TRACE.match(line).group(1), 16)
                    if address == mark:
                        if ran is None:
                            ran = collections.Counter()
                        else:
                            frames.append(ran)
                            ran = None
                    elif ran is not None:
                        ran[address] += 1
                elif line.startswith("IN:"):
                    block = -1
                elif block is not None and line.startswith("0x"):
                    address = int(LISTED.match(line).group(1), 16)
                    if block < 0:
                        block = address
                        lengths[block] = 0
                    lengths[block] += 1
        written = process.stdout.read().splitlines()
        process.stderr.read()
        if process.wait():
            raise SystemExit("%s: exit status %d: %s" % (elf, process.returncode, written[-1:]))
        return written, frames, lengths


def profile(qemu, nm, cpu, elf):
    symbols = Symbols(nm, elf)
    mark = next(row[0] for row in symbols.rows if row[1] == "profile_mark")
    written, frames, lengths = follow(qemu, elf, mark)
    if len(written) != len(frames):
        raise SystemExit("%s: %d frames named, %d seen" % (elf, len(written), len(frames)))
    results = []
    for line, ran in zip(written, frames):
        functions, calls = collections.Counter(), collections.Counter()
        for address, times in ran.items():
            entry = symbols.at(address)
            functions[entry] += times * lengths[address]
            calls[entry] += times if entry[0] == address else 0
        results.append((cpu, line.split(","), functions, calls))
    return results


def stages(functions):
    sums = collections.Counter()
    for (_, name, source), count in functions.items():
        stage = stage_of(name, source)
        if stage:
            sums[stage] += count
    return sums


def show(cpu, words, functions, calls, per_function):
    name, variant = words[:2]
    vertices, triangles, culled, references, pixels = map(int, words[2:7])
    sums = stages(functions)
    print("\n%s %s, %s: %d instructions, %d vertices, %d triangles (%d culled), %d references, %d pixels" %
          (name, variant, cpu, sum(sums.values()), vertices, triangles, culled, references, pixels))
    print("  %-24s %10s %10s %10s %10s %10s" % ("stage", "frame", "a vertex", "a triangle", "a tile's", "a pixel"))
    for stage in sorted(sums):
        if sums[stage]:
            print("  %-24s %10d %10.1f %10.1f %10.1f %10.1f" % (
                stage, sums[stage], sums[stage] / vertices, sums[stage] / triangles, sums[stage] / max(references, 1),
                sums[stage] / max(pixels, 1)))
    if per_function:
        for entry, count in functions.most_common(40):
            print("    %-36s %-18s %10d %8d calls" % (entry[1], entry[2], count, calls[entry]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--qemu", required=True)
    parser.add_argument("--nm", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--functions", action="store_true")
    parser.add_argument("firmware", nargs="+")
    arguments = parser.parse_args()
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as workers:
        running = [workers.submit(profile, arguments.qemu, arguments.nm, *pair.split("=", 1)) for pair in arguments.firmware]
        results = [row for future in running for row in future.result()]
    with open(arguments.output, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("name", "variant", "cpu", "stage", "instructions", "vertices", "triangles", "culled", "references", "pixels"))
        for cpu, words, functions, calls in results:
            show(cpu, words, functions, calls, arguments.functions)
            for stage, count in sorted(stages(functions).items()):
                table.writerow(words[:2] + [cpu, stage, count] + words[2:7])
    return 0


if __name__ == "__main__":
    sys.exit(main())
