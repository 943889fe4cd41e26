#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The figures of docs/reliability.md, from files that other targets write:

    reliability.py --suites "SUITE..." [--write]

Without --write the page is held against them, and what it and SECURITY.md name against the tree and the targets that
`make help` lists, on standard input. Closes with `N passed, N failed`; status 1 on a failure.
"""
import argparse
import csv
import os
import re
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
BEGIN, END = "<!-- figures -->\n", "<!-- end of figures -->\n"
PAGE = "docs/reliability.md"


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def rows(name):
    with open(os.path.join(ROOT, name), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def found(pattern, name):
    match = re.search(pattern, read(name))
    if match is None:
        raise SystemExit(f"reliability: {name} has no {pattern}")
    return match.groups()


def fuzzed():
    """Of each target, runs so far, and those since a commit last changed what it is built from."""
    runs = {}
    for row in rows("docs/fuzz.csv"): # of a target the newest stands last
        runs[row["target"]] = runs.get(row["target"], (0,))[0] + int(row["runs"]), int(row["runs"])
    return [(f"runs of `{target}` without a report; of these with its last sources", "%d; %d" % counts, "`docs/fuzz.csv`")
            for target, counts in sorted(runs.items())]


def mutated():
    """Of the last run of mutants, what became of them."""
    run, = rows("docs/mutants.csv")
    judged, killed, listed, survived, commit = (run[name] for name in ("judged", "killed", "listed", "survived", "commit"))
    return (f"of {judged} changes of the sources at {commit}, those that a suite notices; that nothing can; left open",
            f"{killed}; {listed}; {survived}", "`docs/mutants.csv`")


def recorded():
    """Of each run that is too long for `make test`, what it counted last."""
    return [(f"`make {row['run']}` at {row['commit']}: {row['what']}", row["count"], "`docs/runs.csv`") for row in rows("docs/runs.csv")]


def figures():
    """Each as what it is of, the figure, the file or target that it is from."""
    lines, branches, conditions = found(r"\| `src/` \| ([\d.]+ %) of \d+ \| ([\d.]+ %) of \d+ \| ([\d.]+ %) of \d+", "docs/coverage.md")
    host, = found(r"\| `port/host/` \| ([\d.]+ %) of", "docs/coverage.md")
    kernels, = found(r"goes through (\d+) kernels", "docs/proofs.md")
    scenes = [row for row in rows("docs/stability.csv") if row["in_contract"] == "1"]
    judged, missed, broken = (sum(int(row[name]) for row in scenes) for name in ("judged", "missed", "broken"))
    count = sum(int(row["scenes"]) for row in scenes)
    corpus = sum(len(names) for _, _, names in os.walk(os.path.join(ROOT, "tests", "fuzz", "corpus")))
    return [
        ("kernels proven", kernels, "[proofs](proofs.md)"),
        ("lines, branches, MC/DC of `src/` that tests reach", f"{lines}, {branches}, {conditions}", "[coverage](coverage.md)"),
        ("lines of `port/host/` that tests reach", host, "[coverage](coverage.md)"),
        ("conditions that nothing can reach, each with its reason", len(rows("tools/coverage/exceptions.csv")), "`tools/coverage/exceptions.csv`"),
        ("branches and conditions that no test reaches so far", len(rows("tools/coverage/open.csv")), "`tools/coverage/open.csv`"),
        ("changes of the sources that nothing can notice, each with its reason", len(rows("tools/mutants/known.csv")), "`tools/mutants/known.csv`"),
        mutated(),
        ("random scenes where the contract is to hold; where it does not", f"{count}; {broken}", "[stability](stability.md#what-falls-short)"),
        ("their pixels; of them covered otherwise than the reference has them", f"{judged}; {missed}", "[stability](stability.md)"),
        *recorded(),
        ("inputs of fuzz targets that are kept", corpus, "`tests/fuzz/corpus/`"),
        *fuzzed(),
        ("boards that run in emulators", len(rows("tools/boards/boards.csv")), "[boards](boards.md)"),
    ]


def table(entries):
    return "| | | from |\n| --- | ---: | --- |\n" + "".join("| %s | %s | %s |\n" % entry for entry in entries)


def with_table(page, text):
    head, rest = page.split(BEGIN)
    return head + BEGIN + text + END + rest.split(END)[1]


def named(name, targets):
    """What a page names that is not there: targets, files and folders."""
    text = read(name)
    missing = [target for target in re.findall(r"`make ([a-z-]+)", text) if target not in targets]
    links = [os.path.join(os.path.dirname(name), link) for link in re.findall(r"\]\(([^)#]+)", text)]
    paths = [path for path in re.findall(r"`((?:src|port|tests|tools|docs)/[\w./-]*)`", text)]
    return missing + [path for path in links + paths if not os.path.exists(os.path.join(ROOT, path))]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--suites", required=True)
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    suites = arguments.suites.split()
    page = read(PAGE)
    wanted = with_table(page, table(figures()))
    if arguments.write:
        with open(os.path.join(ROOT, PAGE), "w", encoding="utf-8") as file:
            file.write(wanted)
        return 0
    targets = set(re.findall(r"^make (\S+)", sys.stdin.read(), re.MULTILINE)) | {"test", "lint"}
    tests = set(re.findall(r"`make (test-[a-z-]+)`", page))
    problems = [("figures (make reliability-page)", [] if page == wanted else [PAGE]),
                ("suites that make test does not run", sorted(tests - set(suites))),
                *((f"{name} names what is not there", named(name, targets)) for name in (PAGE, "SECURITY.md"))]
    for name, wrong in problems:
        if wrong:
            print(f"FAILED {name}: {', '.join(wrong)}")
    failed = sum(bool(wrong) for _, wrong in problems)
    print(f"{len(problems) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
