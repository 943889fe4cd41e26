#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mutants: single changes to the library and the drivers of panels that some suite should notice.

Every mutant is one change at one place of a function's body in src/ or port/panel/: a comparison, a number, a shift, an operator, swapped
operands, a choice that always goes one way, a statement left out. The seed puts all of them in an order; they are
taken one by one until COUNT of them have been judged. A mutant that does not compile, or whose objects are those of
the library, is passed over.

The work tree is only read: mutants are built from a copy, and only those objects that the change reaches. Each mutant
goes through the suites, quick ones and those that noticed most first, up to the first that fails, crashes, or takes far
more processor time than with the library itself. What was found is kept in results.csv: the next call goes on from there. Survivors stay in known.csv with
the reason why nothing can notice them; any other makes the exit status 1. An entry whose line has changed counts no more.
"""

import argparse
import collections
import csv
import filecmp
import glob
import hashlib
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

# ---- Changes --------------------------------------------------------------------------------------------------------

TOKEN = re.compile(
    r"""(?P<skip>\s+|//[^\n]*|/\*.*?\*/)
    |(?P<directive>(?<![^\n])[ \t]*\#(?:\\\n|/\*.*?\*/|[^\n])*)
    |(?P<string>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
    |(?P<number>0[xX][0-9a-fA-F]+[uUlL]*|[0-9][0-9.]*[uUlL]*)
    |(?P<name>[A-Za-z_]\w*)
    |(?P<operator><<=|>>=|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)""",
    re.S | re.X)

Token = collections.namedtuple("Token", "text start end kind")
Mutant = collections.namedtuple("Mutant", "file line start end text before after")

FLIPPED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==",
           "&&": "||", "||": "&&", "+=": "-=", "-=": "+="}
OPENING = {")": "(", "]": "[", "}": "{"}
# Tokens at which a sum, and at which a term of it, ends.
BEYOND_TERM = {"+", "-", "<<", ">>", "<", "<=", ">", ">=", "==", "!=", "&", "^", "|", "&&", "||", "?", ":", ",", ";", "=",
               "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "return", "{", "}", "(", "[", ")", "]"}
BEYOND_CONDITION = {"?", ":", ",", ";", "=", "+=", "-=", "*=", "|=", "&=", "^=", "<<=", ">>=", "return", "{", "}", "(", "["}
CONTROL = {"if", "for", "while", "switch"}
# GLINT_OPAQUE hides from compilers what a value is, and does nothing.
NO_EXPRESSION = CONTROL | {"do", "else", "case", "default", "const", "static", "struct", "unsigned", "int", "goto",
                           "GLINT_OPAQUE"}


def tokens_of(text):
    """Tokens without comments, strings and directives; strings and directives stay as what they are, to be passed by."""
    found = (Token(m.group(), m.start(), m.end(), m.lastgroup) for m in TOKEN.finditer(text))
    return [token for token in found if token.kind not in ("skip", "directive")]


def partners_of(tokens):
    """The index of each bracket's partner."""
    partners, opened = {}, []
    for i, token in enumerate(tokens):
        if token.text in OPENING.values():
            opened.append(i)
        elif token.text in OPENING:
            partners[i] = opened.pop()
            partners[partners[i]] = i
    return partners


def bodies_of(tokens, partners):
    """Ranges of indices between a function's braces."""
    i = 0
    while i < len(tokens):
        if tokens[i].text == "{":
            if tokens[i - 1].text == ")":
                yield i, partners[i]
                i = partners[i]
            elif not (tokens[i - 1].kind == "string" and tokens[i - 2].text == "extern"):
                i = partners[i]
        i += 1


class Body:
    """Changes within one function."""

    def __init__(self, text, tokens, partners):
        self.text, self.tokens, self.partners = text, tokens, partners

    def source(self, first, last):
        return self.text[self.tokens[first].start:self.tokens[last].end]

    def back(self, i, beyond):
        """The first token of what ends at i."""
        while self.tokens[i].text not in beyond or self.tokens[i].text in OPENING:
            i = self.partners[i] if self.tokens[i].text in OPENING else i
            i -= 1
        return i + 1

    def ahead(self, i, beyond):
        """The last token of what begins at i."""
        while self.tokens[i].text not in beyond or self.tokens[i].text in OPENING.values():
            i = self.partners[i] if self.tokens[i].text in OPENING.values() else i
            i += 1
        return i - 1

    def is_binary(self, i):
        before = self.tokens[i - 1]
        return before.text != "return" and (before.kind in ("number", "name") or before.text in (")", "]"))

    def is_cast(self, i):
        """Is i the end of a cast?"""
        return self.tokens[i].text == ")" and i - self.partners[i] <= 4 and \
            re.search(r"^\(\s*(const\s+)?(u?int\d*_t|size_t|int|unsigned|\w+_t|struct \w+)[\s*]*\)$",
                      self.source(self.partners[i], i)) is not None

    def is_size(self, i):
        """Is i the number of elements of what is declared?"""
        return self.tokens[i - 1].text == "[" and self.tokens[i + 1].text == "]" and \
            self.tokens[i + 2].text in (";", ",", "=") and \
            (self.tokens[i - 3].kind == "name" or self.tokens[i - 3].text in ("]", "*"))

    def swapped(self, first, middle_first, middle_last, last):
        return (first, last, self.source(middle_last + 1, last) + " " + self.source(middle_first, middle_last) + " " +
                self.source(first, middle_first - 1))

    def changes(self, begin, end):
        """(first token, last token, what comes in their place) of every change between two braces."""
        parentheses = 0
        for i in range(begin, end):
            token = self.tokens[i]
            parentheses += {"(": 1, ")": -1}.get(token.text, 0)
            if token.kind == "number":
                if "." not in token.text and not self.is_size(i):
                    yield from self.numbers(i)
            elif token.text in FLIPPED:
                yield i, i, FLIPPED[token.text]
            elif token.text in ("<<", ">>") and self.tokens[i + 1].kind != "number":
                yield i, i, token.text + " 1 +"
                yield i, i, token.text + " -1 +"
            elif token.text in ("+", "-") and self.is_binary(i) and not self.is_cast(i - 1):
                yield i, i, "-" if token.text == "+" else "+"
                if token.text == "-":
                    first, last = self.back(i - 1, BEYOND_TERM), self.ahead(i + 1, BEYOND_TERM)
                    yield self.swapped(first, i, i, last)
            elif token.text == "?":
                first = self.back(i - 1, BEYOND_CONDITION)
                yield first, i - 1, "1"
                yield first, i - 1, "0"
            elif token.text == "(" and self.tokens[i - 1].kind == "name":
                yield from self.arguments(i)
            if not parentheses and token.text in (";", "{", "}", ")", "else"):
                yield from self.statement(i)

    def numbers(self, i):
        digits = self.tokens[i].text.rstrip("uUlL")
        value = int(digits, 16 if digits[:2].lower() == "0x" else 8 if digits[0] == "0" and len(digits) > 1 else 10)
        for changed in (value - 1, value + 1):
            if changed >= 0:
                yield i, i, (hex(changed) if "x" in digits.lower() else str(changed)) + self.tokens[i].text[len(digits):]

    def arguments(self, i):
        """A call of two arguments: swapped; of least or most: one of them."""
        end = self.partners[i]
        commas, at = [], i + 1
        while at < end:
            if self.tokens[at].text == ",":
                commas.append(at)
            at = (self.partners[at] if self.tokens[at].text in OPENING.values() else at) + 1
        if len(commas) != 1 or self.tokens[i - 1].text in CONTROL:
            return
        yield self.swapped(i + 1, commas[0], commas[0], end - 1)
        if self.tokens[i - 1].text in ("glint_least", "glint_most"):
            yield i - 1, end, "(" + self.source(i + 1, commas[0] - 1) + ")"
            yield i - 1, end, "(" + self.source(commas[0] + 1, end - 1) + ")"

    def statement(self, i):
        """What follows i, without: an expression, or a jump that depends on a condition."""
        follows = self.tokens[i].text == "else" or \
            self.tokens[i].text == ")" and self.tokens[self.partners[i] - 1].text in CONTROL
        if self.tokens[i].text == ")" and not follows:
            return
        first = self.tokens[i + 1]
        jump = first.text in ("return", "break", "continue")
        if jump and not follows or first.text in NO_EXPRESSION or not (jump or first.kind == "name" or first.text in "*++--("):
            return
        after = self.tokens[i + 2]
        if not jump and (after.kind == "name" or after.text == "*"): # a declaration
            return
        last = self.ahead(i + 1, {";", "{", "}", ")", "]"})
        if self.tokens[last + 1].text == ";":
            yield i + 1, last, ""


def normal(text):
    return " ".join(text.split())


def mutants_of(path):
    """Every mutant of a file."""
    with open(path) as file:
        text = file.read()
    tokens = tokens_of(text)
    partners = partners_of(tokens)
    body = Body(text, tokens, partners)
    for begin, end in bodies_of(tokens, partners):
        for first, last, changed in body.changes(begin, end):
            start, stop = tokens[first].start, tokens[last].end
            above, below = text.rfind("\n", 0, start) + 1, text.index("\n", stop)
            if normal(changed) != normal(text[start:stop]):
                yield Mutant(path, text.count("\n", 0, start) + 1, start, stop, changed, normal(text[above:below]),
                             normal(text[above:start] + changed + text[stop:below]))


def in_order(mutants, seed):
    def key(m):
        return hashlib.sha256(f"{seed} {m.file} {m.start} {m.end} {m.text}".encode()).digest()
    return sorted(mutants, key=key)


# ---- Building and running ---------------------------------------------------------------------------------------------

# Of processor time: what any suite may take, and how many times what it takes with the library itself.
LEAST_SECONDS, MOST_TIMES = 2, 5
# Suites that take less are run on all mutants first: what is left to the others is soon known.
QUICK_SECONDS = 0.5


def run(command, seconds=None, **variables):
    """@param seconds of processor time @return exit status, processor time"""
    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if seconds:
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
            resource.setrlimit(resource.RLIMIT_AS, (1 << 31, 1 << 31))
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, preexec_fn=limit, env=dict(os.environ, **variables))
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


# What is mutated, and copied for it. All of it becomes one shared library, which suites load when they start.
MUTATED = ("src", "port/panel")
LIBRARY = "libmutated.so"


def mutated(end):
    """The files of MUTATED whose names end so."""
    return sorted(path for folder in MUTATED for path in glob.glob(folder + "/**/*" + end, recursive=True))


def copy(old, new):
    shutil.rmtree(new, ignore_errors=True)
    for folder in MUTATED:
        shutil.copytree(os.path.join(old, folder), os.path.join(new, folder))


class Builder:
    """The library and the suites, compiled once; mutants in folders of their own, which hold what differs."""

    def __init__(self, build, compiler, flags, suites):
        self.build, self.compiler, self.flags = build, shlex.split(compiler), shlex.split(flags)
        self.mutated = mutated(".c")
        self.suites = {name: [source for source in sources if source not in self.mutated]
                       for name, sources in suites.items()}
        self.is_of_panels = {name: any(source in self.mutated for source in sources) for name, sources in suites.items()}
        self.slowest, self.seconds = {}, {} # what each suite takes with the library itself, anew and where the judge remembers
        self.needs = {} # source -> what of MUTATED it is made from
        self.reached = {} # suite -> sources that a linker would take for it from an archive

    def object(self, folder, source):
        return os.path.join(folder, source.replace("/", "_") + ".o")

    def compile(self, folder, source, headers, more=()):
        """@return whether it compiles. Files are named as in the work tree, whose headers come after `headers`."""
        path = os.path.join(headers, source) if source in self.mutated else source
        first = ["-I" + os.path.join(headers, top) for top in ("src", "port")]
        return run(self.compiler + first + self.flags +
                   ["-w", "-O2", "-fPIC", *more, f"-ffile-prefix-map={headers}/=", "-c", path,
                    "-o", self.object(folder, source)])[0] == 0

    def link(self, folder, sources, more):
        """@return whether it links, with what `folder` has of its own"""
        own = [self.object(folder, source) for source in sources]
        objects = [path if os.path.exists(path) else self.object(self.original, source)
                   for path, source in zip(own, sources)]
        return run(self.compiler + objects + more)[0] == 0

    def link_library(self, folder):
        return self.link(folder, self.mutated,
                         ["-shared", f"-Wl,-soname,{LIBRARY}", "-o", os.path.join(folder, LIBRARY)])

    def link_suite(self, name, folder):
        return self.link(folder, self.suites[name],
                         [os.path.join(self.original, LIBRARY), "-lm", "-o", os.path.join(folder, "suite_" + name)])

    def prepare(self, stamp, jobs):
        """The work tree's src/ copied, everything compiled, and suites timed, unless that was done with the same sources."""
        self.original = os.path.join(self.build, "original")
        stamps = os.path.join(self.original, "stamp")
        if not os.path.exists(stamps) or open(stamps).read() != stamp:
            copy(".", self.original)
            with ThreadPoolExecutor(jobs) as pool:
                list(pool.map(self.compile_original, self.sources()))
                if not self.link_library(self.original):
                    sys.exit("the library does not link")
                list(pool.map(self.time_original, self.suites))
            with open(stamps, "w") as file:
                file.write(stamp)
        for source in self.sources():
            with open(self.depends(source)) as file:
                names = [os.path.normpath(name) for name in file.read().replace("\\\n", " ").split()[1:]]
            prefix = os.path.join(os.path.normpath(self.original), "")
            self.needs[source] = {name[len(prefix):] for name in names if name.startswith(prefix)}
        symbols = {source: self.symbols_of(source) for source in self.sources()}
        for name in self.suites:
            self.reached[name] = self.linked(self.suites[name], symbols)
            with open(self.times(name)) as file:
                self.slowest[name], self.seconds[name] = map(float, file.read().split())

    def symbols_of(self, source):
        """@return what a source's object defines, what it asks others for"""
        listed = subprocess.run(["nm", "-gP", self.object(self.original, source)], check=True, capture_output=True, text=True)
        rows = [line.split() for line in listed.stdout.splitlines()]
        return {row[0] for row in rows if row[1] != "U"}, {row[0] for row in rows if row[1] == "U"}

    def linked(self, sources, symbols):
        """The sources, and what of MUTATED they call, directly or not."""
        place = {symbol: source for source in self.mutated for symbol in symbols[source][0]}
        found, left = set(), list(sources)
        while left:
            source = left.pop()
            if source not in found:
                found.add(source)
                left += [place[symbol] for symbol in symbols[source][1] if symbol in place]
        return found

    def concerns(self, name, mutant):
        """May a suite notice a mutant? Those of panels are asked about panels alone."""
        return self.is_of_panels[name] == mutant.file.startswith("port/panel/") and \
            any(mutant.file in self.needs[source] for source in self.reached[name])

    def sources(self):
        return self.mutated + sorted({source for name in self.suites for source in self.suites[name]})

    def depends(self, source):
        return self.object(self.original, source) + ".d"

    def times(self, name):
        return os.path.join(self.original, name + ".seconds")

    def judged(self, name):
        return os.path.join(self.original, name + ".judged")

    def compile_original(self, source):
        if not self.compile(self.original, source, self.original, ("-MMD", "-MF", self.depends(source))):
            sys.exit(f"{source} does not compile")

    def run_suite(self, name, folder, program, seconds=None, **variables):
        """Runs the program that one folder has of a suite with the library of another."""
        return run([os.path.join(program, "suite_" + name)], seconds, LD_LIBRARY_PATH=folder, GLINT_JUDGED=self.judged(name),
                   **variables)

    def time_original(self, name):
        """A suite's processor time, and where the judge of images remembers all; it must pass with the library as it is."""
        if not self.link_suite(name, self.original):
            sys.exit(f"{name} does not link")
        found = [self.run_suite(name, self.original, self.original, GLINT_JUDGED_ADD="1"),
                 self.run_suite(name, self.original, self.original)]
        if any(status != 0 for status, _ in found):
            sys.exit(f"{name} fails on the library itself")
        with open(self.times(name), "w") as file:
            file.write(" ".join(str(seconds) for _, seconds in found))

    def judge(self, mutant, folder, noticed, found):
        """
        @param folder the original's src/ and port/panel/, and nothing else
        @param noticed how often each suite noticed a mutant, of this file and of any: which to run first
        @param found "left" where quick suites have noticed nothing: the others are run
        @return what became of a mutant: none, same, the name of the suite that noticed, left, or survived
        """
        path = os.path.join(folder, mutant.file)
        with open(path) as file:
            text = file.read()
        with open(path, "w") as file:
            file.write(text[:mutant.start] + mutant.text + text[mutant.end:])
        try:
            changed = False
            for source in self.mutated:
                if mutant.file in self.needs[source]:
                    if not self.compile(folder, source, folder):
                        return "none"
                    changed |= not filecmp.cmp(self.object(folder, source), self.object(self.original, source), False)
            return self.run_suites(mutant, folder, noticed, found) if changed else "same"
        finally:
            for name in os.listdir(folder):
                if os.path.isfile(os.path.join(folder, name)):
                    os.remove(os.path.join(folder, name))
            shutil.copyfile(os.path.join(self.original, mutant.file), path)

    def in_order(self, mutant, noticed):
        """Suites that notice much in little time come first; which one notices a mutant depends on that, whether one does not."""
        of_file, of_any = noticed
        return sorted(self.suites, key=lambda name: self.seconds[name] / (1 + of_any[name] + 20 * of_file[mutant.file, name]))

    def run_suites(self, mutant, folder, noticed, found):
        if not self.link_library(folder):
            return "link"
        for name in self.in_order(mutant, noticed):
            if not self.concerns(name, mutant) or (self.seconds[name] > QUICK_SECONDS) != (found == "left"):
                continue
            own = [source for source in self.suites[name] if mutant.file in self.needs[source]]
            for source in own:
                if not os.path.exists(self.object(folder, source)) and not self.compile(folder, source, folder):
                    return name
            if own and not self.link_suite(name, folder):
                return name
            most = max(LEAST_SECONDS, int(MOST_TIMES * self.slowest[name]) + 1)
            if self.run_suite(name, folder, folder if own else self.original, most)[0] != 0:
                return name
        return "survived" if found == "left" else "left"


# ---- Results ------------------------------------------------------------------------------------------------------------

COLUMNS = ("seed", "library", "suites", "file", "start", "end", "text", "line", "result")


def digest(paths):
    sums = hashlib.sha256()
    for path in sorted(paths):
        with open(path, "rb") as file:
            sums.update(path.encode() + b"\0" + file.read())
    return sums.hexdigest()[:16]


class Results:
    """What became of mutants, in a file that only grows. A mutant that a suite noticed stays noticed when tests change."""

    def __init__(self, path, seed, library, suites):
        self.path, self.own, self.found = path, (str(seed), library, suites), {}
        self.noticed = collections.Counter(), collections.Counter() # by file and suite, by suite
        if os.path.exists(path):
            with open(path, newline="") as file:
                for row in csv.DictReader(file):
                    self.count(row["file"], row["result"])
                    if row["library"] == library and (row["result"] not in ("left", "survived") or row["suites"] == suites):
                        self.found[row["file"], row["start"], row["end"], row["text"]] = row["result"]
        else:
            with open(path, "w", newline="") as file:
                csv.writer(file).writerow(COLUMNS)

    def get(self, m):
        return self.found.get((m.file, str(m.start), str(m.end), m.text))

    def count(self, file, result):
        self.noticed[0][file, result] += 1
        self.noticed[1][result] += 1

    def add(self, m, result):
        self.count(m.file, result)
        with open(self.path, "a", newline="") as file:
            csv.writer(file).writerow((*self.own, m.file, m.start, m.end, m.text, m.line, result))


def read_known(path):
    with open(path, newline="") as file:
        return {(row["file"], row["line"], row["mutant"]): row["reason"] for row in csv.DictReader(file)}


def judge_all(builder, results, known, mutants, count, jobs):
    """@return (mutant, result) of the first mutants that make `count` to be judged"""
    free = [os.path.join(builder.build, f"mutant{i}") for i in range(jobs)]
    for folder in free:
        copy(builder.original, folder)

    def judge(m):
        if (m.file, m.before, m.after) in known:
            return "known"
        return results.get(m) or judge_anew(m, None)

    def judge_anew(m, found):
        folder = free.pop()
        result = builder.judge(m, folder, results.noticed, found)
        free.append(folder)
        results.add(m, result)
        print(f"{m.file}:{m.line}: {result}", file=sys.stderr, flush=True)
        return result

    def judge_left(pair):
        m, result = pair
        return m, judge_anew(m, result) if result == "left" else result

    judged, done = [], 0
    with ThreadPoolExecutor(jobs) as pool:
        while len(judged) < count and done < len(mutants):
            batch = mutants[done:done + count - len(judged)]
            done += len(batch)
            judged += [(m, result) for m, result in zip(batch, pool.map(judge, batch)) if result not in ("none", "same")]
        return list(pool.map(judge_left, judged)), done


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True, help="folder for copies, objects and results")
    parser.add_argument("--known", required=True, help="CSV of survivors: file, line, mutant, reason")
    parser.add_argument("--count", type=int, required=True, help="mutants to judge")
    parser.add_argument("--seed", type=int, required=True, help="their order")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mutants judged at once")
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--flags", required=True, help="of the compiler")
    parser.add_argument("--files", nargs="*", default=[], help="of src/ and port/panel/; all unless some are named")
    parser.add_argument("--suite", action="append", required=True, metavar="NAME=SOURCES", help="suites, in order")
    arguments = parser.parse_args()

    suites = {}
    for suite in arguments.suite:
        name, sources = suite.split("=", 1)
        suites[name] = sources.split()
    files = mutated(".[ch]")
    mutants = [m for path in arguments.files or files for m in mutants_of(path)]
    tests = [os.path.join(folder, name) for top in ("tests", "examples", "port/host", "tools/mutants") for folder, _, names in os.walk(top)
             for name in names if re.search(r"\.[ch]$", name)]
    library, others = digest(files), digest(tests) + "".join("," + name for name in suites)
    mutants = in_order(mutants, arguments.seed)
    os.makedirs(arguments.build, exist_ok=True)
    results = Results(os.path.join(arguments.build, "results.csv"), arguments.seed, library, others)
    known = read_known(arguments.known)
    builder = Builder(arguments.build, arguments.compiler, arguments.flags, suites)
    builder.prepare(library + others, arguments.jobs)
    judged, done = judge_all(builder, results, known, mutants, arguments.count, arguments.jobs)

    survivors = [(m, result) for m, result in judged if result in ("survived", "known")]
    for m, result in survivors:
        reason = known.get((m.file, m.before, m.after))
        print(f"{m.file}:{m.line}: {'known: ' + reason if reason else 'SURVIVED'}\n  - {m.before}\n  + {m.after}")
    print("by suite:", ", ".join(f"{name} {n}" for name, n in collections.Counter(r for _, r in judged).most_common()))
    print(f"{len(judged) - len(survivors)} of {len(judged)} killed, {done - len(judged)} passed over; {len(mutants)} in all")
    return any(result == "survived" for _, result in judged)


if __name__ == "__main__":
    sys.exit(main())
