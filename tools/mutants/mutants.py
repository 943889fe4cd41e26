#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges tests by mutants: single changes to the library and the drivers of panels that some suite should notice.

A mutant changes one place of a function's body in src/ or port/panel/: a comparison, a number, a shift, an operator, a
condition that always goes one way, a statement that is left out. The seed puts all mutants in an order, and the first
COUNT are judged of those that compile into other programs. `make` builds each mutant in a copy of the work tree, and each
suite whose program differs runs, quick ones first, until one fails, crashes, or takes far longer than with the library
itself. results.csv keeps what was found: the next call with the same sources and tests goes on from there. known.csv lists
survivors with the reason why nothing can notice them; any other survivor makes the exit status 1.
"""

import argparse
import collections
import csv
import glob
import hashlib
import os
import queue
import re
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

# ---- Changes --------------------------------------------------------------------------------------------------------

Mutant = collections.namedtuple("Mutant", "file line start end text before after")

HIDDEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|^[ \t]*\#(?:\\\n|[^\n])*""", re.S | re.M)
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

# How long a suite may take: so many seconds, and so many times what it takes with the library itself.
LEAST_SECONDS, MOST_TIMES = 5, 10
# Lines are not known to programs, so that those differ only where code does. Mutants may leave what nothing uses.
MAKE = ("make", "-s", "WARNINGS=-w", "LIBRARY_WARNINGS=-w", "DEBUG=", "TEST_SEED=1", "BUILD=build")
FAILED_CHECK = re.compile(rb"[\w./-]+:\d+: ")


def build(folder, programs):
    """@return whether all programs are built"""
    variables = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    return subprocess.run([*MAKE, "-C", folder, *programs], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=variables,
                          check=False).returncode == 0


def passes(folder, program, seconds=None):
    """Runs a suite up to its first failed check. @return whether all checks pass in time"""
    with subprocess.Popen([program], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        timer = threading.Timer(seconds or 1e6, process.kill)
        timer.start()
        failed = any(FAILED_CHECK.match(line) for line in process.stdout)
        if failed:
            process.kill()
        status = process.wait()
        timer.cancel()
    return not failed and status == 0


def digest(paths, names=()):
    sums = hashlib.sha256(" ".join(names).encode())
    for path in paths:
        with open(path, "rb") as file:
            sums.update(path.encode() + b"\0" + file.read() + b"\0")
    return sums.hexdigest()[:16]


class Judge:
    """A copy of the work tree in which all suites are built and timed; mutants are built in copies of that copy."""

    def __init__(self, folder, suites, stamp, jobs):
        """@param suites {folder of what they judge: programs}"""
        self.original, self.suites, self.seconds = os.path.abspath(os.path.join(folder, "original")), suites, {}
        self.folders = queue.Queue()
        for i in range(jobs):
            self.folders.put(os.path.abspath(os.path.join(folder, f"mutant{i}")))
        programs = [program for some in suites.values() for program in some]
        times = os.path.join(folder, "seconds-%s.csv" % stamp)
        if not os.path.exists(times):
            self.prepare(programs, times, jobs)
        with open(times, newline="", encoding="utf-8") as file:
            self.seconds = {program: float(seconds) for program, seconds in csv.reader(file)}
        self.programs = {program: digest_of_program(self.original, program) for program in programs}

    def prepare(self, programs, times, jobs):
        shutil.rmtree(self.original, ignore_errors=True)
        shutil.copytree(".", self.original, symlinks=True, ignore=lambda folder, _: ("build", ".git", "docs") if folder == "." else ())
        if not build(self.original, [f"-j{jobs}", *programs]):
            sys.exit("the suites cannot be built")
        with open(times + ".part", "w", newline="", encoding="utf-8") as file:
            for program in programs:
                begin = time.monotonic()
                if not passes(self.original, program):
                    sys.exit(f"{program} fails on the library itself")
                csv.writer(file).writerow((program, time.monotonic() - begin))
        os.rename(times + ".part", times)

    def judge(self, m):
        """@return the suite that noticed a mutant, `none` where it does not compile, `same` where no program differs, or `survived`"""
        folder = self.folders.get()
        try:
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(self.original, folder, symlinks=True)
            path = os.path.join(folder, m.file)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            with open(path, "w", encoding="utf-8") as file:
                file.write(text[:m.start] + m.text + text[m.end:])
            return self.run_suites(folder, next(some for top, some in self.suites.items() if m.file.startswith(top)))
        finally:
            shutil.rmtree(folder, ignore_errors=True)
            self.folders.put(folder)

    def run_suites(self, folder, programs):
        if not build(folder, programs):
            return "none"
        changed = [program for program in programs if digest_of_program(folder, program) != self.programs[program]]
        for program in sorted(changed, key=self.seconds.get):
            if not passes(folder, program, LEAST_SECONDS + MOST_TIMES * self.seconds[program]):
                return os.path.basename(program)
        return "survived" if changed else "same"


def digest_of_program(folder, program):
    return digest([os.path.join(folder, program)])


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
    parser.add_argument("--build", required=True, help="folder for copies and results")
    parser.add_argument("--known", required=True, help="CSV of survivors: file, line, mutant, reason")
    parser.add_argument("--count", type=int, required=True, help="mutants to judge")
    parser.add_argument("--seed", type=int, required=True, help="their order")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mutants judged at once")
    parser.add_argument("--library", nargs="+", required=True, help="programs that judge src/, as make names them")
    parser.add_argument("--panels", nargs="+", required=True, help="programs that judge port/panel/")
    parser.add_argument("--files", nargs="*", default=[], help="of src/ and port/panel/; all unless some are named")
    arguments = parser.parse_args()

    suites = {"src/": arguments.library, "port/panel/": arguments.panels}
    paths = {top: sorted(glob.glob(top + "/**/*.[ch]", recursive=True)) for top in ("src", "port", "tests", "examples")}
    rules = sorted(path for top in (*paths, "tools") for path in glob.glob(top + "/**/*.mk", recursive=True))
    stamp = digest([*sum(paths.values(), []), *rules, "Makefile"], arguments.library + arguments.panels)
    files = arguments.files or [path for path in paths["src"] + paths["port"] if path.startswith(tuple(suites))]
    mutants = in_order([m for path in files for m in mutants_of(path)], arguments.seed)
    os.makedirs(arguments.build, exist_ok=True)
    known = read_known(arguments.known)
    judge = Judge(arguments.build, suites, stamp, arguments.jobs)
    judged, done = judge_all(judge, Results(os.path.join(arguments.build, "results.csv"), stamp), known, mutants, arguments.count,
                             arguments.jobs)
    survivors = [(m, result) for m, result in judged if result in ("survived", "known")]
    for m, result in survivors:
        reason = known.get((m.file, m.before, m.after))
        print(f"{m.file}:{m.line}: {'known: ' + reason if reason else 'SURVIVED'}\n  - {m.before}\n  + {m.after}")
    print("by suite:", ", ".join(f"{name} {n}" for name, n in collections.Counter(r for _, r in judged).most_common()))
    print(f"{len(judged) - len(survivors)} of {len(judged)} killed, {done - len(judged)} passed over; {len(mutants)} in all")
    return any(result == "survived" for _, result in judged)


if __name__ == "__main__":
    sys.exit(main())
