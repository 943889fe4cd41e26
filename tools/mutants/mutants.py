#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges tests by mutants: single changes to the library and the drivers of panels that some suite should notice.

A mutant changes one place of a function's body in src/ or port/panel/: a comparison, a number, a shift, an operator, a
condition that always goes one way, a statement that is left out. The seed puts all mutants in an order, and the first
COUNT are judged of those that compile into other code. A mutant stands in a copy of the work tree, where `make` renews the
objects that depend on it. Suites under sanitizers are linked and run, quick ones first, until one fails, ends with a report,
crashes, or takes far longer than with the library itself. results.csv keeps what was found: the next call with the same
sources and tests goes on from there. known.csv lists survivors with the reason why nothing can notice them; any other
survivor makes the exit status 1, unless so many are let through, and so does a row that no mutant has.
"""

import argparse
import collections
import csv
import glob
import hashlib
import math
import os
import queue
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor

# ---- Changes --------------------------------------------------------------------------------------------------------

Mutant = collections.namedtuple("Mutant", "file line start end text before after")

HIDDEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|^[ \t]*\#(?:\\\n|[^\n])*|\bGLINT_REQUIRE\(.*?\);""", re.S | re.M)
# clang-format closes a function at the start of a line.
BODY = re.compile(r"^\S[^;={}]*\)\s*\{\n(?P<body>.*?)^\}", re.S | re.M)

FLIPPED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&", "+=": "-=", "-=": "+=",
           " + ": " - ", " - ": " + "}
OPERATOR = re.compile(r"(?<=\s)(<=?|>=?|==|!=|&&|\|\||\+=|-=)(?=\s)|(?<=[\w)\]]) [-+] (?=[\w(*&])")
NUMBER = re.compile(r"(?<![\w.\]])(0[xX][0-9a-fA-F]+|[0-9]+)([uUlL]*)(?![\w.])")
SHIFT = re.compile(r"(<<|>>) (?=[A-Za-z(])")
CONDITION = re.compile(r"\b(?:if|while) \(([^{};]*)\)(?= \{?$|\n)|(?<=[=(,] )([^;{}?=,]+?)(?= \?)|(?<=return )([^;{}?]+?)(?= \?)", re.M)
STATEMENT = re.compile(r"^ +((?:\*|\+\+|--)?[a-z_][\w.\[\]>-]*(?: [-+*/%&|^<>]*= |\(|\+\+|--)[^;{}]*);$|^ +(return(?: [^;{}]+)?|break|continue);$",
                       re.M)
# The place of the number of elements in a declaration.
SIZE = re.compile(r"\w+ \*?\w+(?:\[\w+\])*\[$")


def normal(text):
    return " ".join(text.split())


def changes(code, start, stop):
    """@return (start, end, text in its place) of every change in a body of code without comments and strings"""
    for found in OPERATOR.finditer(code, start, stop):
        yield found.start(), found.end(), FLIPPED[found.group()]
    for found in SHIFT.finditer(code, start, stop):
        yield from ((found.start(), found.end(), found[1] + more) for more in (" 1 + ", " -1 + "))
    for found in NUMBER.finditer(code, start, stop):
        digits = found[1]
        value = int(digits, 16 if digits[:2].lower() == "0x" else 8 if digits[0] == "0" else 10)
        if not SIZE.search(code[code.rindex("\n", 0, found.start()):found.start()]):
            yield from ((found.start(), found.end(), (hex(n) if "x" in digits.lower() else str(n)) + found[2])
                        for n in (value - 1, value + 1) if n >= 0)
    for found in CONDITION.finditer(code, start, stop):
        group = found.lastindex
        if found[group].count("(") == found[group].count(")"):
            yield from ((found.start(group), found.end(group), text) for text in "10")
    for found in STATEMENT.finditer(code, start, stop):
        group = found.lastindex
        before = code[:found.start()].rstrip()
        if group == 1 or before.endswith((")", "else")):
            yield found.start(group), found.end(group), ""


def mutants_of(path):
    """Every mutant of a file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    code = HIDDEN.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    for body in BODY.finditer(code):
        for start, end, changed in changes(code, *body.span("body")):
            above, below = text.rfind("\n", 0, start) + 1, text.index("\n", end)
            yield Mutant(path, text.count("\n", 0, start) + 1, start, end, changed, normal(text[above:below]),
                         normal(text[above:start] + changed + text[end:below]))


def in_order(mutants, seed):
    return sorted(mutants, key=lambda m: hashlib.sha256(f"{seed} {m.file} {m.start} {m.end} {m.text}".encode()).digest())


# ---- Building and running -------------------------------------------------------------------------------------------

# How long a suite may compute: so many seconds, and so many times as long as with the library itself.
LEAST_SECONDS, MOST_TIMES = 1, 5
# Mutants may leave what nothing uses.
MAKE = ("make", "-s", "WARNINGS=-w", "LIBRARY_WARNINGS=-w", "TEST_SEED=1")
# Without sanitizers and lines objects differ only where code does.
PLAIN = "gcc -std=c99 -O2 -w -Isrc -Iport -c -o".split()
FAILED_CHECK = re.compile(rb"[\w./-]+:\d+: ")
REPORT = re.compile(rb"runtime error: |ERROR: AddressSanitizer")
# What suites take samples of.
SUITE_ENVIRONMENT = {**os.environ, "GLINT_SAMPLE": "8"}


def make(folder, build, *targets):
    """@return whether make makes all targets of a work tree, whose folder of what is built is `build`"""
    variables = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    return subprocess.run([*MAKE, "-C", folder, f"BUILD={build}", *targets], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=variables,
                          check=False).returncode == 0


def run_suite(folder, program, seconds=None):
    """Runs a suite up to its first failed check or report. @return what it found, "" or a word, and its seconds"""
    with subprocess.Popen([os.path.abspath(os.path.join(folder, program))], cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env=SUITE_ENVIRONMENT) as process:
        if seconds:
            resource.prlimit(process.pid, resource.RLIMIT_CPU, (seconds, seconds))
        found = next((word for line in process.stdout for word in
                      (REPORT.search(line) and "sanitizers", FAILED_CHECK.match(line) and "check") if word), "")
        if found:
            os.kill(process.pid, signal.SIGKILL)  # which leaves it to be waited for, as process.kill() may not
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return found or ("crash or time" if process.returncode else ""), usage.ru_utime + usage.ru_stime


def digest(paths, names=()):
    sums = hashlib.sha256(" ".join(names).encode())
    for path in paths:
        with open(path, "rb") as file:
            sums.update(path.encode() + b"\0" + file.read() + b"\0")
    return sums.hexdigest()[:16]


class Judge:
    """Copies of the work tree with what is built of it. A mutant is put into one, where make renews what depends on it."""

    def __init__(self, build, variant, suites, jobs):
        """@param build folder of make, in the work tree @param suites {folder of what they judge: programs, quick ones first}"""
        self.build, self.variant, self.suites = build, os.path.join(build, variant), suites
        self.seconds, self.timing = {}, threading.Lock()
        self.library = os.path.join(self.variant, "libglint.a")
        self.trees = queue.Queue()
        for i in range(jobs):
            tree = os.path.abspath(os.path.join(build, "mutants", f"tree{i}"))
            shutil.rmtree(tree, ignore_errors=True)
            shutil.copytree(".", tree, symlinks=True,
                            ignore=lambda folder, _: (build.split("/")[0], ".git", "docs") if folder == "." else ())
            for part in (variant, "bench", f"tests/{variant}"):
                shutil.copytree(os.path.join(build, part), os.path.join(tree, build, part), symlinks=True)
            self.trees.put(tree)
        self.objects = collections.defaultdict(set)
        for path in glob.glob(self.variant + "/**/*.d", recursive=True):
            with open(path, encoding="utf-8") as file:
                names = file.read().split(":", 1)[1].replace("\\\n", " ").split("\n")[0].split()
            if os.path.exists(names[0]):  # Of a source that is gone the folder still has the object, which nothing makes.
                for name in names:
                    self.objects[os.path.normpath(name)].add(path[:-len("d")] + "o")

    def limit(self, program):
        """@return the seconds that a suite may compute"""
        with self.timing:
            if program not in self.seconds:
                found, seconds = run_suite(".", program)
                if found:
                    raise SystemExit(f"{program} fails on the library itself: {found}")
                self.seconds[program] = LEAST_SECONDS + math.ceil(MOST_TIMES * seconds)
        return self.seconds[program]

    def judge(self, m):
        """@return what noticed a mutant, `none` where it does not compile, `same` where no code differs, or `survived`"""
        tree = self.trees.get()
        saved = tree + "-saved"
        changed = [m.file, *self.objects[m.file]] + [self.library] * m.file.startswith("src/")
        try:
            for path in changed:
                os.makedirs(os.path.dirname(os.path.join(saved, path)), exist_ok=True)
                shutil.copy2(os.path.join(tree, path), os.path.join(saved, path))
            with open(os.path.join(tree, m.file), "r+", encoding="utf-8") as file:
                text = file.read()
                file.seek(0)
                file.write(text[:m.start] + m.text + text[m.end:])
                file.truncate()
            return self.find(tree, m.file)
        finally:
            for path in changed:
                shutil.copy2(os.path.join(saved, path), os.path.join(tree, path))
            shutil.rmtree(saved)
            self.trees.put(tree)

    def find(self, tree, path):
        if not make(tree, self.build, *self.objects[path]):
            return "none"
        sources = [os.path.relpath(name, self.variant)[:-len("o")] + "c" for name in self.objects[path]]
        if all(plain(".", source) == plain(tree, source) for source in sources):
            return "same"
        for program in next(some for top, some in self.suites.items() if path.startswith(top)):
            if not make(tree, self.build, program):
                sys.exit(f"{program} cannot be linked")
            found, _ = run_suite(tree, program, self.limit(program))
            if found:
                return f"{os.path.basename(program)}: {found}"
        return "survived"


def plain(folder, source):
    """@return the code of a source by a compiler without sanitizers, or None"""
    if not source.startswith(("src/", "port/panel/")):
        return None
    with tempfile.NamedTemporaryFile(suffix=".o") as file:
        subprocess.run([*PLAIN, file.name, source], cwd=folder, stderr=subprocess.DEVNULL, check=False)
        with open(file.name, "rb") as made:  # A cache of the compiler may put another file in its place.
            return made.read()


# ---- Results --------------------------------------------------------------------------------------------------------

def read_known(path):
    with open(path, newline="", encoding="utf-8") as file:
        return {(row["file"], row["line"], row["mutant"]): row["reason"] for row in csv.DictReader(file)}


class Results:
    """What became of mutants of one state of sources and tests, in a file that only grows."""

    def __init__(self, path, stamp):
        self.path, self.stamp, self.found = path, stamp, {}
        if os.path.exists(path):
            with open(path, newline="", encoding="utf-8") as file:
                self.found = {tuple(key): result for was, *key, result in csv.reader(file) if was == stamp}

    def key(self, m):
        return m.file, str(m.start), str(m.end), m.text

    def get(self, m):
        return self.found.get(self.key(m))

    def add(self, m, result):
        with open(self.path, "a", newline="", encoding="utf-8") as file:
            csv.writer(file).writerow((self.stamp, *self.key(m), result))
        print(f"{m.file}:{m.line}: {result}", file=sys.stderr, flush=True)


def judge_all(judge, results, known, mutants, count, jobs):
    """@return (mutant, result) of the first mutants that make `count` to be judged, and how many were looked at"""
    def result_of(m):
        if (m.file, m.before, m.after) in known:
            return "known"
        result = results.get(m)
        if result is None:
            result = judge.judge(m)
            results.add(m, result)
        return result

    judged, done = [], 0
    with ThreadPoolExecutor(jobs) as pool:
        while len(judged) < count and done < len(mutants):
            batch = mutants[done:done + count - len(judged)]
            done += len(batch)
            judged += [(m, result) for m, result in zip(batch, pool.map(result_of, batch)) if result not in ("none", "same")]
    return judged, done


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True, help="folder of make in the work tree, in which all programs are built")
    parser.add_argument("--known", required=True, help="CSV of survivors: file, line, mutant, reason")
    parser.add_argument("--count", type=int, required=True, help="mutants to judge")
    parser.add_argument("--seed", type=int, required=True, help="their order")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mutants judged at once")
    parser.add_argument("--variant", required=True, help="of the suites, as make names it")
    parser.add_argument("--library", nargs="+", required=True, help="suites that judge src/, quick ones first")
    parser.add_argument("--panels", nargs="+", required=True, help="suites that judge port/panel/")
    parser.add_argument("--left", type=int, default=0, help="survivors without a reason that are let through")
    parser.add_argument("--files", nargs="*", default=[], help="of src/ and port/panel/; all unless some are named")
    arguments = parser.parse_args()
    if os.path.relpath(arguments.build) != arguments.build or arguments.build.startswith(".."):
        parser.error("--build names no folder below the work tree")

    suites = {top: [os.path.join(arguments.build, "tests", arguments.variant, suite) for suite in some]
              for top, some in (("src/", arguments.library), ("port/panel/", arguments.panels))}
    paths = {top: sorted(glob.glob(top + "/**/*.[ch]", recursive=True)) for top in ("src", "port", "tests", "examples")}
    rules = sorted(path for top in (*paths, "tools") for path in glob.glob(top + "/**/*.mk", recursive=True))
    stamp = digest([*sum(paths.values(), []), *rules, "Makefile"], sorted(arguments.library + arguments.panels))
    all_mutants = [m for path in paths["src"] + paths["port"] if path.startswith(tuple(suites)) for m in mutants_of(path)]
    known = read_known(arguments.known)
    unknown = set(known) - {(m.file, m.before, m.after) for m in all_mutants}
    if unknown:
        sys.exit(f"{arguments.known}: no mutant has " + "\n".join(map(str, unknown)))
    mutants = in_order([m for m in all_mutants if not arguments.files or m.file in arguments.files], arguments.seed)
    print(f"{arguments.count} of {len(mutants)} mutants in the order of seed {arguments.seed}", flush=True)
    judge = Judge(arguments.build, arguments.variant, suites, arguments.jobs)
    results = Results(os.path.join(arguments.build, "mutants", "results.csv"), stamp)
    judged, done = judge_all(judge, results, known, mutants, arguments.count, arguments.jobs)
    survivors = [(m, result) for m, result in judged if result in ("survived", "known")]
    for m, result in survivors:
        reason = known.get((m.file, m.before, m.after))
        print(f"{m.file}:{m.line}: {'known: ' + reason if reason else 'SURVIVED'}\n  - {m.before}\n  + {m.after}")
    print("by suite:", ", ".join(f"{name} {n}" for name, n in collections.Counter(r for _, r in judged).most_common()))
    print(f"{len(judged) - len(survivors)} of {len(judged)} killed, {done - len(judged)} passed over")
    return sum(result == "survived" for _, result in judged) > arguments.left


if __name__ == "__main__":
    sys.exit(main())
