#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws and judges random scenes on all cores: search.py PROGRAM --scenes N --seed FIRST [--csv FILE] [--test | --kept].

Prints what each region's scenes came to, and every scene that breaks the contract. --csv writes the figures; --test closes
with `N passed, N failed`, a region being a test; --kept prints each region's worst scene as tests/stability/kept.h has it.
"""
import argparse
import concurrent.futures
import csv
import os
import subprocess
import sys

COUNTS = ("scenes", "covered", "judged", "uncertain", "close", "gated", "left_out", "over_fine", "over_one", "over_two",
          "missed", "spilled", "moved", "broken")
WORST = ("worst_share", "worst", "bound", "worst_seed", "worst_checksum")
COLUMNS = ("region", "in_contract") + COUNTS + WORST

# Seeds judged by one run of the program.
SHARE = 2000


def run(program, first, count):
    process = subprocess.run([program, str(first), str(count)], stdout=subprocess.PIPE, text=True, check=True)
    return process.stdout.splitlines()


def merge(total, values):
    row = dict(zip(COLUMNS, values))
    known = total.setdefault(row["region"], dict(row, **dict.fromkeys(COUNTS, 0)))
    for count in COUNTS:
        known[count] += int(row[count])
    if float(row["worst_share"]) > float(known["worst_share"]):
        known.update({column: row[column] for column in WORST})


def search(program, first, scenes):
    """@return the regions' rows and the lines of scenes that break the contract, both in the order of the seeds."""
    starts = range(first, first + scenes, SHARE)
    counts = [min(SHARE, first + scenes - start) for start in starts]
    total, broken = {}, []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for lines in pool.map(lambda share: run(program, *share), zip(starts, counts)):
            for line in lines:
                kind, rest = line.split(",", 1)
                if kind == "region":
                    merge(total, rest.split(","))
                else:
                    broken.append(rest)
    return list(total.values()), broken


def faults(row):
    """What of the contract a region's scenes break; beyond it, where p is below 1 or above 1024, coverage counts."""
    found = [name for name in ("missed", "spilled", "moved") if row[name]]
    if row["in_contract"] == "1":
        found += ["broken"] * (row["broken"] > 0)
        found += ["over_one"] * (row["over_one"] * 10000 > row["judged"])
        found += ["over_fine"] * (row["over_fine"] * 1000 > row["judged"])
    return found if row["scenes"] else ["no scenes"]


def report(rows, broken):
    for line in broken:
        print("    scene " + line)
    print("%-28s %7s %9s %9s %9s %8s %8s %7s %6s %12s" % (
        "region", "scenes", "judged", "left out", "over fine", "over one", "over two", "missed", "worst", "seed"))
    for row in rows:
        print("%-28s %7d %9d %9d %9d %8d %8d %7d %6.2f %12s %s" % (
            row["region"], row["scenes"], row["judged"], row["left_out"], row["over_fine"], row["over_one"],
            row["over_two"], row["missed"], float(row["worst_share"]), row["worst_seed"], " ".join(faults(row))))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--scenes", type=int, required=True)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--csv")
    parser.add_argument("--test", action="store_true")
    parser.add_argument("--kept", action="store_true")
    arguments = parser.parse_args()
    rows, broken = search(arguments.program, arguments.seed, arguments.scenes)
    report(rows, broken)
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, ("first_seed",) + COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(dict(row, first_seed=arguments.seed) for row in rows)
    if arguments.kept:
        for region, row in enumerate(rows):
            print("    {%d, %d, %su, %su, 0, 0, 0}, /* %s: %s of %s */" % (
                region, int(row["worst_seed"]) // len(rows) % 2, row["worst_seed"], row["worst_checksum"], row["region"], row["worst"], row["bound"]))
    if arguments.test:
        failed = sum(bool(faults(row)) for row in rows)
        print("%d passed, %d failed" % (len(rows) - failed, failed))
        return failed > 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
