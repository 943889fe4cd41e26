#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lines, branches and MC/DC that tests reach, over several builds of the same sources:

    coverage.py --exceptions FILE --open FILE [--page FILE | --renew] FOLDER=PROGRAM[,PROGRAM...] ...

Each folder holds the raw profiles of one build, each program maps its code. A branch is two outcomes of a condition. A
condition counts for MC/DC (modified condition/decision coverage) when two evaluations of its decision differ in this
condition and in the result alone. What is reached in any build counts.

What no test can reach is listed in FILE by file, function, text of the line, condition and gap (`true` or `false`: an
outcome that never comes; `alone`: never decides alone), with the reason. What no test reaches yet, and nothing shows to
be beyond reach, is listed in the other FILE as open. A gap that is in neither fails, and so does an entry that is no gap
any more. `--renew` writes what is open anew. Closes with `N passed, N failed`.
"""
import argparse
import csv
import glob
import os
import re
import subprocess
import sys

# Folder, and the least % of lines, branches and conditions that are reached, or listed as beyond reach.
BARS = (("src/", 99.9, 99.9, 100), ("port/panel/", 100, 100, 100), ("port/host/", 98, 0, 0))

LINE = re.compile(r" *(\d+)\| *([\d.]+[kMGTPEZY]?)?\|")
BRANCH = re.compile(r"Branch \((\d+):(\d+)\): \[True: ([^,]+), False: ([^]]+)\]")
DECISION = re.compile(r"MC/DC Decision Region")
CONDITION = re.compile(r"Condition C\d+ --> \((\d+):(\d+)\)")
VECTOR = re.compile(r"\| +\d+ \{ (.*) = ([TF]) +\}")
FOLDED = re.compile(r"C(\d+)-Pair: constant folded")
FUNCTION = re.compile(r"[A-Za-z_].*?(\w+)\(")


class Source:
    """What is known of a file, from all builds."""

    def __init__(self, name):
        self.name = name
        self.lines = {}  # number: whether it is run
        self.branches = {}  # (line, column): [whether it is true, whether it is false]
        self.decisions = {}  # its conditions' places, each (line, column): evaluations
        with open(name, encoding="utf-8") as file:
            self.text = [""] + file.read().split("\n")

    def take_branch(self, place, true, false):
        seen = self.branches.setdefault(place, [False, False])
        seen[0] |= true not in ("0", "Folded")
        seen[1] |= false not in ("0", "Folded")

    def take_decision(self, places, results):
        """Constants of a build are none of its conditions, and so it may differ from the next build's."""
        self.decisions.setdefault(tuple(places), set()).update(results)

    def function(self, line):
        for number in range(line, 0, -1):
            found = FUNCTION.match(self.text[number])
            if found and not self.text[number].endswith(";"):
                return found.group(1)
        return ""

    def condition(self, place):
        """The text of a condition that begins there."""
        line, column = place
        rest = " ".join([self.text[line][column - 1:]] + [text.strip() for text in self.text[line + 1:line + 4]])
        if re.match(r"(case\b|default\b)", rest):
            return rest[:rest.index(":")]
        depth = 0
        for i, letter in enumerate(rest):
            depth += (letter in "([{") - (letter in ")]}")
            if depth < 0 or depth == 0 and (letter in "?;," or rest[i:i + 2] in ("&&", "||")):
                return rest[:i].strip()
        return rest.strip()

    def is_measured(self, places, vectors):
        """Of a decision that picks one of two structs clang 19 records no evaluation: then one whose condition has come to
        both outcomes has none."""
        return vectors or not any(all(self.branches.get(place, ())) for place in places if place in self.branches)

    def conditions(self):
        """@return for each condition of a decision that is measured whether it decides alone"""
        alone = {}
        for places, vectors in self.decisions.items():
            if not self.is_measured(places, vectors):
                continue
            for i, place in enumerate(places):
                alone[place] = alone.get(place, False) or any(is_pair(a, b, i) for a in vectors for b in vectors)
        return alone

    def gaps(self):
        """@return (function, line, condition, gap) of each outcome and condition that is not reached, and its place"""
        found = []
        for place, reached in self.branches.items():
            found += [(place, gap) for gap, is_reached in zip(("true", "false"), reached) if not is_reached]
        found += [(place, "alone") for place, is_alone in self.conditions().items() if not is_alone]
        return {(self.name, self.function(place[0]), self.text[place[0]].strip(), self.condition(place), gap): place
                for place, gap in sorted(found)}


def is_pair(a, b, i):
    """Do two evaluations, each (conditions, result), differ in the result and in condition i alone?"""
    return a[1] != b[1] and [k for k, (x, y) in enumerate(zip(a[0], b[0])) if x != y and "-" not in (x, y)] == [i]


def read(report, sources):
    source, places, vectors, folded = None, [], [], set()
    for text in report.splitlines():
        if text.startswith("/") and text.endswith(":"):
            name = os.path.relpath(text[:-1])
            source = sources.setdefault(name, Source(name)) if name.startswith(tuple(bar[0] for bar in BARS)) else None
        if source is None:
            continue
        if LINE.match(text):
            number, count = LINE.match(text).groups()
            if count is not None:
                source.lines[int(number)] = source.lines.get(int(number), False) or count != "0"
        elif BRANCH.search(text):
            line, column, true, false = BRANCH.search(text).groups()
            source.take_branch((int(line), int(column)), true, false)
        elif DECISION.search(text):
            places, vectors, folded = [], [], set()
        elif CONDITION.search(text):
            places.append(tuple(map(int, CONDITION.search(text).groups())))
        elif VECTOR.search(text):
            values, result = VECTOR.search(text).groups()
            vectors.append(([value.strip() for value in values.split(",")], result))
        elif FOLDED.search(text):
            folded.add(int(FOLDED.search(text).group(1)) - 1)
        elif "MC/DC Coverage for Decision" in text:
            source.take_decision([place for i, place in enumerate(places) if i not in folded],
                                 [(tuple(value for i, value in enumerate(values) if i not in folded), result)
                                  for values, result in vectors])


def measure(builds):
    sources = {}
    for build in builds:
        folder, _, programs = build.partition("=")
        merged = os.path.join(folder, "all.profdata")
        profiles = glob.glob(os.path.join(folder, "*.profraw"))
        subprocess.run(["llvm-profdata-19", "merge", *profiles, "-o", merged], check=True)
        first, *others = programs.split(",")
        report = subprocess.run(["llvm-cov-19", "show", "-show-branches=count", "-show-mcdc", "-instr-profile", merged, first,
                                 *("-object=" + other for other in others)], stdout=subprocess.PIPE, text=True, check=True)
        read(report.stdout, sources)
    return sources


KEY = ("file", "function", "line", "condition", "gap")


def read_list(name):
    """@return the reason of each gap that a list has; what is open has none"""
    with open(name, encoding="utf-8") as file:
        return {tuple(row[key] for key in KEY): row.get("reason", "") for row in csv.DictReader(file)}


def is_judged(gap):
    """Are gaps of its folder to be in a list?"""
    return any(gap[0].startswith(folder) and bars[1] > 0 for folder, *bars in BARS)


def find_gaps(sources):
    return {gap: place for source in sources.values() for gap, place in source.gaps().items() if is_judged(gap)}


def write_open(name, sources, exceptions):
    with open(name, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(KEY)
        rows.writerows(sorted(gap for gap in find_gaps(sources) if gap not in exceptions))


class Tally:
    """Of some files: lines, branches and conditions, how many there are, are reached, and are listed."""

    def __init__(self):
        self.all, self.reached, self.listed = [0] * 3, [0] * 3, [0] * 3

    def take(self, source, exceptions):
        alone = source.conditions()
        for kind, (count, reached) in enumerate(((len(source.lines), sum(source.lines.values())),
                                                 (2 * len(source.branches), sum(map(sum, source.branches.values()))),
                                                 (len(alone), sum(alone.values())))):
            self.all[kind] += count
            self.reached[kind] += reached
        for gap in source.gaps():
            self.listed[2 if gap[-1] == "alone" else 1] += gap in exceptions

    def share(self, kind, with_listed):
        return 100 * (self.reached[kind] + with_listed * self.listed[kind]) / self.all[kind] if self.all[kind] else 100

    def row(self, name):
        cells = ["%6d of %6d %6.2f %%" % (self.reached[kind], self.all[kind], self.share(kind, False)) for kind in range(3)]
        return "%-36s" % name + "  ".join(cells) + "  %3d listed" % sum(self.listed)


def judge(sources, exceptions, still_open):
    """Prints all. @return of each check whether it holds, and the folders' tallies"""
    good, tallies = [], {}
    print("%-36s%23s  %23s  %23s" % ("", "lines", "branches", "MC/DC"))
    for folder, *bars in BARS:
        tallies[folder] = Tally()
        for name in sorted(name for name in sources if name.startswith(folder)):
            tally = Tally()
            tally.take(sources[name], exceptions)
            tallies[folder].take(sources[name], exceptions)
            print(tally.row(name))
        print(tallies[folder].row(folder) + "\n")
    gaps = find_gaps(sources)
    for folder, *bars in BARS:
        if not tallies[folder].all[0]:  # not measured
            continue
        for kind, (bar, what) in enumerate(zip(bars, ("lines", "branches", "MC/DC"))):
            share = tallies[folder].share(kind, True)
            good.append(share >= bar)
            print("%s %s: %.2f %% reached or listed, at least %s %%%s" % (folder, what, share, bar, "" if good[-1] else "  FAILED"))
    for gap, place in gaps.items():
        if gap not in exceptions and gap not in still_open:
            good.append(False)
            print("%s:%d:%d: not listed: %s, '%s' of: %s" % (gap[0], *place, *gap[4:2:-1], gap[2]))
    for gap in [*exceptions, *still_open]:
        good.append(gap in gaps)
        if not good[-1]:
            print("%s: listed, and is reached or gone: %s" % (gap[0], gap[1:]))
    return good, tallies


def write_page(name, tallies, exceptions, still_open):
    """The page of figures: shares, and what is listed."""
    with open(name, "w", encoding="utf-8") as page:
        page.write("# Coverage\n\nWritten by `make coverage-page`; not to be edited. What tests reach, by clang-19's coverage: of "
                   "lines, of outcomes of conditions (branches), and of conditions that are seen to decide alone (MC/DC).\n\n"
                   "| folder | lines | branches | MC/DC | beyond reach | open |\n| --- | --- | --- | --- | --- | --- |\n")
        for folder, tally in tallies.items():
            shares = ["%.1f %% of %d" % (tally.share(kind, False), tally.all[kind]) if bar else "-"
                      for kind, bar in enumerate(next(bars[1:] for bars in BARS if bars[0] == folder))]
            page.write("| `%s` | %s | %d | %d |\n" % (folder, " | ".join(shares), sum(tally.listed),
                                                      sum(gap[0].startswith(folder) for gap in still_open)))
        page.write("\nOpen is what no test reaches and nothing shows to be beyond reach: `tools/coverage/open.csv` lists it.\n"
                   "\nWhat no test can reach:\n\n| file | function | condition | never | why |\n"
                   "| --- | --- | --- | --- | --- |\n")
        for (file, function, _, condition, gap), why in exceptions.items():
            cells = (os.path.basename(file), "`%s`" % function, "`%s`" % condition, "decides alone" if gap == "alone" else gap, why)
            page.write("| %s |\n" % " | ".join(cell.replace("|", "\\|") for cell in cells))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--exceptions", required=True)
    parser.add_argument("--open", required=True)
    parser.add_argument("--page")
    parser.add_argument("--renew", action="store_true")
    parser.add_argument("builds", nargs="+")
    arguments = parser.parse_args()
    exceptions = read_list(arguments.exceptions)
    sources = measure(arguments.builds)
    if arguments.renew:
        write_open(arguments.open, sources, exceptions)
    still_open = read_list(arguments.open)
    good, tallies = judge(sources, exceptions, still_open)
    if arguments.page:
        write_page(arguments.page, tallies, exceptions, still_open)
    failed = good.count(False)
    print("%d passed, %d failed" % (len(good) - failed, failed))
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
