#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Keeps what the last whole run of a target counted, with the commit that last changed what it ran.

record.py --runs CSV --run NAME --counts WHAT=PATTERN... --sources PATH... -- COMMAND... runs COMMAND and passes on what it
writes and its exit status. If nothing failed, it puts a row into CSV for each WHAT: the last number that PATTERN captures,
or how many lines match a PATTERN that captures none. What no commit has is not kept.
record.py --runs CSV --figures FIGURES puts the rows of CSV into FIGURES.
"""
import argparse
import csv
import datetime
import os
import re
import subprocess
import sys

COLUMNS = ("run", "what", "count", "commit", "date")


def read(name):
    """@return rows by what they are of"""
    if not os.path.exists(name):
        return {}
    with open(name, encoding="utf-8", newline="") as file:
        return {(row["run"], row["what"]): row for row in csv.DictReader(file)}


def write(name, rows):
    with open(name, "w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows[key] for key in sorted(rows))


def git(*arguments):
    done = subprocess.run(("git", *arguments), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return None if done.returncode else done.stdout.strip()


def commit_of(sources):
    """@return the last commit to sources; null where they are not those of a commit"""
    if git("status", "--porcelain", "--", *sources) != "":
        return None
    return git("log", "-1", "--format=%h", "--abbrev=12", "--", *sources) or None


def run(command):
    """@return exit status, what it wrote"""
    lines = []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line)
    return process.returncode, "".join(lines)


def count_of(pattern, text):
    """@return the last number captured, or how many matches there are; null without any"""
    matches = list(re.finditer(pattern, text, re.MULTILINE))
    if not matches:
        return None
    return int(matches[-1].group(1)) if matches[-1].groups() else len(matches)


def record(arguments, command):
    commit = commit_of(arguments.sources)
    status, text = run(command)
    if status:
        return status
    counts = {what: count_of(pattern, text) for what, pattern in (entry.split("=", 1) for entry in arguments.counts)}
    absent = [what for what, count in counts.items() if count is None]
    if absent:
        print(f"{arguments.run}: nothing tells the number of {', '.join(absent)}", file=sys.stderr)
        return 1
    if commit is None or commit_of(arguments.sources) != commit:
        print("    not kept: its sources are not those of a commit")
        return 0
    date = datetime.date.today().isoformat()
    rows = read(arguments.runs)
    rows.update({(arguments.run, what): dict(run=arguments.run, what=what, count=count, commit=commit, date=date)
                 for what, count in counts.items()})
    write(arguments.runs, rows)
    return 0


def main():
    line = sys.argv[1:]
    end = line.index("--") if "--" in line else len(line)
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", required=True)
    parser.add_argument("--figures")
    parser.add_argument("--run")
    parser.add_argument("--counts", nargs="+")
    parser.add_argument("--sources", nargs="+")
    arguments = parser.parse_args(line[:end])
    if arguments.figures:
        write(arguments.figures, {**read(arguments.figures), **read(arguments.runs)})
        return 0
    return record(arguments, line[end + 1:])


if __name__ == "__main__":
    sys.exit(main())
