#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables of docs/stability.md: page.py PAGE REGIONS.csv SEARCH.csv writes them anew; with --check, says whether they are
those, and with --program PROGRAM draws each region's worst scene again and compares.

REGIONS.csv is table.c's, SEARCH.csv search.py's.
"""
import argparse
import csv
import difflib
import os
import sys

from search import search

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
from markdown import fill, table  # noqa: E402


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def percent(part, whole):
    return "%.4f" % (100 * part / whole) if whole else "-"


def describe_regions(rows):
    def found(row, column):
        bound = row[column + "_bound"]
        return row[column] + (" of " + bound if float(bound) > 0 else "")

    return table(["region", "plain method", "its error", "RGB888", "RGB565", "what the library does"],
                 [[row["region"], row["plain_method"], row["plain"] + " " + row["unit"], found(row, "rgb888"),
                   found(row, "rgb565"), row["does"]] for row in rows])


def describe_search(rows):
    total = {name: sum(int(row[name]) for row in rows) for name in
             ("scenes", "judged", "left_out", "over_fine", "over_one", "over_two", "missed")}
    head = ["region", "scenes", "pixels", "% beyond the bound", "beyond one step", "beyond two", "wrongly covered", "left out",
            "worst, of its bound", "its seed"]
    lines = []
    for row in rows:
        judged = int(row["judged"])
        lines.append([row["region"] + ("" if row["in_contract"] == "1" else " (beyond the contract)"), row["scenes"], row["judged"],
                      percent(int(row["over_fine"]), judged), row["over_one"], row["over_two"], row["missed"], row["left_out"],
                      "%.2f of %.2f" % (float(row["worst"]), float(row["bound"])), row["worst_seed"]])
    lines.append(["**all**", str(total["scenes"]), str(total["judged"]), percent(total["over_fine"], total["judged"])] +
                 [str(total[name]) for name in ("over_one", "over_two", "missed", "left_out")] + ["", ""])
    return "%d scenes from seed %s, %d pixels judged. Left out beyond a bound: %d.\n\n" % (
        total["scenes"], rows[0]["first_seed"], total["judged"], total["left_out"]) + table(head, lines, right=range(1, 10))


def check_worst(program, rows):
    """@return whether each region's worst scene still comes out as the figures say."""
    failed = 0
    for row in rows:
        found = {again["region"]: again for again in search(program, int(row["worst_seed"]), 1)[0]}[row["region"]]
        same = all(found[name] == row[name] for name in ("worst", "bound", "worst_checksum"))
        failed += not same
        if not same:
            print("%s, seed %s: worst %s of %s where the figures say %s of %s" % (
                row["region"], row["worst_seed"], found["worst"], found["bound"], row["worst"], row["bound"]))
    return failed


def check(text, page, rows, program):
    failed = check_worst(program, rows)
    if text != page:
        failed += 1
        sys.stdout.writelines(difflib.unified_diff(page.splitlines(True), text.splitlines(True), "page", "as found"))
    if failed:
        print("docs/stability.md is not what the library does; `make figures` writes it anew")
    print("%d passed, %d failed" % (len(rows) + 1 - failed, failed))
    return failed > 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page")
    parser.add_argument("regions")
    parser.add_argument("search")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--program")
    arguments = parser.parse_args()
    with open(arguments.page) as file:
        page = file.read()
    regions, rows = read(arguments.regions), read(arguments.search)
    text = fill(fill(page, "regions", describe_regions(regions)), "search", describe_search(rows))
    if arguments.check:
        return check(text, page, rows, arguments.program)
    with open(arguments.page, "w") as file:
        file.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
