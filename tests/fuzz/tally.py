#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts the runs of fuzz targets.

tally.py --programs FOLDER TARGET SOURCES..., after a run without a report, adds what its log tells to TARGET.tally, with
the commit that last changed what the program is built from; runs of sources that no commit has are not counted.
tally.py --programs FOLDER --figures CSV moves to CSV what is not there yet.
"""
import argparse
import collections
import csv
import datetime
import glob
import os
import re
import subprocess

COLUMNS = ("target", "runs", "commit", "date")


def git(*arguments):
    """@return what it prints, null where it fails: outside of a clone"""
    done = subprocess.run(("git", *arguments), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return None if done.returncode else done.stdout.strip()


def read(name):
    """@return the rows of a CSV file, none where there is no file"""
    if not os.path.exists(name):
        return []
    with open(name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def write(name, rows):
    with open(name, "w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def files_of(folder, sources):
    """@return sources and the headers of the tree that they include, as the compiler noted them"""
    files = set(sources)
    for source in sources:
        with open(os.path.join(folder, os.path.splitext(source)[0] + ".d"), encoding="utf-8") as file:
            files.update(re.findall(r"[\w./-]+\.h\b(?!:)", file.read()))
    return sorted(name for name in files if not os.path.isabs(name))


def add(folder, target, sources):
    files = files_of(folder, sources)
    if git("status", "--porcelain", "--", *files) != "":
        print("    not counted: its sources are not those of a commit")
        return
    with open(os.path.join(folder, target + ".log"), encoding="utf-8", errors="replace") as file:
        runs, = re.findall(r"^stat::number_of_executed_units: *(\d+)", file.read(), re.MULTILINE)
    name = os.path.join(folder, target + ".tally")
    commit = git("log", "-1", "--format=%h", "--abbrev=12", "--", *files)
    rows = read(name) + [dict(target=target, runs=int(runs), commit=commit, date=datetime.date.today().isoformat())]
    write(name, rows)
    print("    %d in all with these sources" % sum(int(row["runs"]) for row in rows
                                                   if row["commit"] == rows[-1]["commit"] and int(row["runs"]) > 0))


def move(folder, figures):
    """What goes to the figures is booked out of the tally, whose number of rows then still tells how often was run."""
    kept = {(row["target"], row["commit"]): row for row in read(figures)}
    for name in sorted(glob.glob(os.path.join(folder, "*.tally"))):
        rows = read(name)
        new = collections.Counter()
        for row in rows:
            new[row["commit"]] += int(row["runs"])
        for commit, runs in new.items():
            last = dict([row for row in rows if row["commit"] == commit][-1])
            if runs > 0:
                before = kept.get((last["target"], commit), dict(runs=0))
                kept[last["target"], commit] = dict(last, runs=int(before["runs"]) + runs)
                rows.append(dict(last, runs=-runs))
        write(name, rows)
    write(figures, sorted(kept.values(), key=lambda row: (row["target"], row["date"])))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", required=True)
    parser.add_argument("--figures")
    parser.add_argument("target", nargs="?")
    parser.add_argument("sources", nargs="*")
    arguments = parser.parse_args()
    if arguments.figures:
        move(arguments.programs, arguments.figures)
    else:
        add(arguments.programs, arguments.target, arguments.sources)


if __name__ == "__main__":
    main()
