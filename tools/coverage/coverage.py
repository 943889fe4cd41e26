#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lines, branches and MC/DC that tests reach, over several builds of the same sources:

    coverage.py [--gaps] FOLDER=PROGRAM[,PROGRAM...] ...

Each folder holds the raw profiles of one build, each program maps its code. A branch is two outcomes of a condition. A
condition counts for MC/DC (modified condition/decision coverage) when two evaluations of its decision differ in this
condition and in the result alone. What is reached in any build counts. --gaps prints each outcome that no test reaches,
and each condition that never decides alone. Closes with `N passed, N failed`: a folder fails whose share is below its bar.
"""
import argparse
import glob
import os
import re
import subprocess
import sys

# Folder, and the least % of lines, branches and conditions that are reached.
BARS = (("src/", 95, 90, 80), ("port/panel/", 100, 100, 100), ("port/host/", 98, 0, 0))

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


class Tally:
    """Of some files: lines, branches and conditions, how many there are and are reached."""

    def __init__(self):
        self.all, self.reached = [0] * 3, [0] * 3

    def take(self, source):
        alone = source.conditions()
        for kind, (count, reached) in enumerate(((len(source.lines), sum(source.lines.values())),
                                                 (2 * len(source.branches), sum(map(sum, source.branches.values()))),
                                                 (len(alone), sum(alone.values())))):
            self.all[kind] += count
            self.reached[kind] += reached

    def share(self, kind):
        return 100 * self.reached[kind] / self.all[kind] if self.all[kind] else 100

    def row(self, name):
        return "%-36s" % name + "  ".join("%6d of %6d %6.2f %%" % (self.reached[kind], self.all[kind], self.share(kind)) for kind in range(3))


def judge(sources):
    """Prints all. @return of each check whether it holds"""
    good, tallies = [], {}
    print("%-36s%23s  %23s  %23s" % ("", "lines", "branches", "MC/DC"))
    for folder, *bars in BARS:
        tallies[folder] = Tally()
        for name in sorted(name for name in sources if name.startswith(folder)):
            tally = Tally()
            tally.take(sources[name])
            tallies[folder].take(sources[name])
            print(tally.row(name))
        print(tallies[folder].row(folder) + "\n")
    for folder, *bars in BARS:
        if not tallies[folder].all[0]:  # not measured
            continue
        for kind, (bar, what) in enumerate(zip(bars, ("lines", "branches", "MC/DC"))):
            share = tallies[folder].share(kind)
            good.append(share >= bar)
            print("%s %s: %.2f %% reached, at least %s %%%s" % (folder, what, share, bar, "" if good[-1] else "  FAILED"))
    return good


def print_gaps(sources):
    for name in sorted(sources):
        if any(name.startswith(folder) and bars[1] > 0 for folder, *bars in BARS):
            for (file, function, line, condition, gap), place in sources[name].gaps().items():
                print("%s:%d:%d: %s: not %s, '%s' of: %s" % (file, *place, function, gap, condition, line))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--gaps", action="store_true")
    parser.add_argument("builds", nargs="+")
    arguments = parser.parse_args()
    sources = measure(arguments.builds)
    if arguments.gaps:
        print_gaps(sources)
    good = judge(sources)
    failed = good.count(False)
    print("%d passed, %d failed" % (len(good) - failed, failed))
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
