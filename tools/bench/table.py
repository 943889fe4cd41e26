#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints a benchmark's rows, or what changed in them: table.py CSV [--against CSV]; then exits with 1 if anything did."""
import argparse
import csv
import sys


def read(path):
    with open(path, newline="") as file:
        return {tuple(row[key] for key in ("kind", "name", "variant", "cpu")): row for row in csv.DictReader(file)}


def show(rows):
    for (kind, name, variant, cpu), row in rows.items():
        print("%-11s %-32s %-24s %-4s %11s instructions a %s" % (
            kind, name, variant, cpu, row["instructions"], row["unit"]))


def compare(now, before):
    """@return the number of rows that differ."""
    changed = 0
    for key in sorted(now.keys() | before.keys()):
        new, old = now.get(key), before.get(key)
        if new == old:
            continue
        changed += 1
        if new is None or old is None:
            print("%s: %s" % (" ".join(key), "new" if old is None else "gone"))
            continue
        was, is_now = float(old["instructions"]), float(new["instructions"])
        print("%s: %s, was %s, %+.2f %%" % (" ".join(key), new["instructions"], old["instructions"],
                                            100.0 * (is_now - was) / (was or 1)))
    print("%d of %d rows changed" % (changed, len(now)))
    return changed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--against")
    parser.add_argument("csv")
    arguments = parser.parse_args()
    rows = read(arguments.csv)
    if arguments.against:
        return 1 if compare(rows, read(arguments.against)) else 0
    show(rows)
    return 0 if rows else 1


if __name__ == "__main__":
    sys.exit(main())
