#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Proves the drivers of tests/proof with Frama-C EVA, and writes a page of what it found, proofs.md in the output folder.

A driver passes when EVA reaches its end, raises no alarm, and finds every contract's precondition and postcondition
true. A planted driver passes when one of these is not so. Contracts that no driver proves must say what they stand on.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
import markdown  # noqa: E402

# Without the plug-ins that EVA does not need, frama-c starts in half the time.
FLAGS = ("-no-autoload-plugins -load-module eva -machdep gcc_x86_32 -kernel-warn-key annot:missing-spec=inactive -eva "
         "-eva-no-print -eva-slevel 20000 -eva-auto-loop-unroll 5000 -eva-split-return auto -eva-no-show-progress "
         "-eva-warn-key builtins:missing-spec=inactive -warn-signed-overflow").split()
DRIVER = re.compile(r"/\*((?:(?!\*/).)*)\*/\n(PROOF|PLANTED)\((\w+)\)", re.S)
CONTRACT = re.compile(r"(?:/\* (Stands on [^/]*?) \*/\s*)?/\*@(?:(?!\*/).)*\*/\s*[\w ]*?[ *](\w+)\(", re.S)
UNPROVEN = re.compile(r"/\*\s*(?:\* )?Not proven: ([\w, \n*]+): ((?:(?!\*/).)*?)\s*\*/", re.S)
REACHED = re.compile(r"(\d+) statements reached \(out of (\d+)\)")


class Driver:
    """A driver of a file: what it says of itself, and what EVA found."""

    def __init__(self, path, text, kind, kernel):
        self.path, self.planted, self.kernel = path, kind == "PLANTED", kernel
        self.domain, *tags = re.split(r"\s*@", plain(text))
        tags = dict((tag.split(None, 1) + [""])[:2] for tag in tags)
        self.contracts = tags.pop("contract", "").split()
        self.narrowing = tags.pop("narrowing", "")
        self.unsigned = tags.pop("unsigned", None) is not None
        self.options = tags.pop("options", "").split()
        self.unreached = tags.pop("unreached", "")
        self.alarms = tags.pop("alarms", "")
        if tags:
            raise SystemExit(f"{path}: {kernel}: unknown tag {tags}")
        self.problems = []

    def allowed_alarms(self):
        return int(self.alarms.split()[0]) if self.alarms else 0

    def flags(self):
        """What EVA is told beside the sources."""
        flags = [*FLAGS, "-main", f"prove_{self.kernel}", *self.options]
        if not self.narrowing:
            flags.append("-warn-signed-downcast")
        if self.unsigned:
            flags.append("-warn-unsigned-overflow")
        if self.contracts:
            flags += ["-eva-use-spec", ",".join(self.contracts)]
        return flags

    def allowed_unreached(self):
        return int(self.unreached.split()[0]) if self.unreached else 0

    def prove(self, frama_c, include, log):
        command = [frama_c, f"-cpp-extra-args=-I{include}", *map(str, sources_of(self.path, include)), *self.flags()]
        run = subprocess.run(command, capture_output=True, text=True, timeout=300)
        out = run.stdout + run.stderr
        log.write_text(" ".join(command) + "\n" + out)
        self.problems = find_problems(out, run.returncode, self.kernel, self.allowed_alarms())
        reached = REACHED.findall(out)
        reached, of = (int(n) for n in reached[-1]) if reached else (0, 0)
        allowed = self.allowed_unreached()
        if of - reached != allowed:
            self.problems.append(f"{of - reached} statements are not reached; {allowed} are said to be")
        return self


def find_problems(out, status, kernel, allowed):
    problems = []
    if status:
        problems.append(f"frama-c ended with {status}: {out.strip().splitlines()[-1] if out.strip() else 'silent'}")
    lines = out.splitlines()
    alarms = [" ".join(part.strip() for part in lines[i:i + 2]) for i, line in enumerate(lines) if "[eva:alarm]" in line]
    if len(alarms) != allowed:
        problems += [f"{len(alarms)} alarms; {allowed} are said to be"] + alarms
    if f"Frama_C_show_each_end_{kernel}" not in out:
        problems.append("EVA does not reach the driver's end")
    if f"using specification for function {kernel}\n" in out:
        problems.append("the kernel has no body")
    counted = sum(int(n) for n in re.findall(r"^  (\d+) alarms? generated", out, re.M))
    unknown, invalid = (sum(int(pair[i]) for pair in re.findall(r"(\d+) unknown +(\d+) invalid", out)) for i in (0, 1))
    if "alarms generated" not in out and "alarm generated" not in out or counted + unknown != allowed or invalid:
        problems.append("a property is not proven")
    return problems


def sources_of(path, include):
    """A file of drivers, and what is linked with it."""
    return [path, *(pathlib.Path(include) / source for source in re.findall(r"@link (\S+)", path.read_text()))]


def read_drivers(folder):
    drivers = []
    for path in sorted(folder.glob("*.c")):
        text = path.read_text()
        found = [Driver(path, *match.groups()) for match in DRIVER.finditer(text)]
        if len(found) != len(re.findall(r"^(?:PROOF|PLANTED)\(", text, re.M)):
            raise SystemExit(f"{path}: a driver without a comment")
        drivers += found
    return drivers


HEAD = """# Proofs

Written by `make test-prove`.

[Frama-C](https://frama-c.com) EVA goes through {count} kernels with every input of the domain below. It finds no
signed overflow, bad shift, access out of range, division by zero or read of what was never written, and no conversion
to a narrower signed type that loses bits, unless the last tables say so; it reaches every statement, and the end. The
same check finds every planted error, one of each kind: that is tested too.

A callee that stands by its contract (`tests/proof/contracts.h`) is proven by itself; what it asks of its caller is
proven here. Domains are cut into parts, because EVA keeps a range of each variable but no relation between two.

"""


def table(heads, rows):
    return markdown.table(heads, [[cell.replace("|", "\\|") for cell in row] for row in sorted(rows)])


def plain(text):
    return " ".join(line.strip(" *") for line in text.splitlines()).strip()


def page(drivers, contracts, unproven):
    proven = [d for d in drivers if not d.planted]
    text = HEAD.format(count=len(proven))
    text += table(["file", "kernel", "domain", "callees by contract", "alarms", "statements not reached"],
                  [[d.path.name, f"`{d.kernel}`", d.domain, ", ".join(f"`{c}`" for c in d.contracts),
                    str(len(d.problems) + d.allowed_alarms()), d.unreached or "0"] for d in proven])
    text += "\n## Where something else stands in\n\nBounds that rest on a relation: the reason, and the test.\n\n"
    text += table(["bound of", "reason"],
                  [[f"`{name}`", reason.removeprefix("Stands on ")] for name, reason in contracts.items() if reason])
    text += "\nAlarms above: what a relation rules out that EVA does not keep, and the test.\n\n"
    text += table(["kernel", "why"], [[f"`{d.kernel}`", d.alarms.split(None, 1)[1]] for d in proven if d.alarms])
    text += "\nNot proven: what keeps it in bounds, and the test.\n\n"
    text += table(["kernels", "why"],
                  [[", ".join(f"`{name}`" for name in plain(names).split(", ")), plain(why)] for names, why in unproven])
    text += "\nConversions to a narrower signed type that may lose bits:\n\n"
    return text + table(["kernel", "why"], [[f"`{d.kernel}`", d.narrowing] for d in proven if d.narrowing])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--frama-c", default="frama-c")
    parser.add_argument("--include", default="src")
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--only", help="drivers whose name contains this")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    drivers = read_drivers(arguments.folder)
    contracts, unproven = {}, []
    for path in sorted(arguments.folder.glob("*.[ch]")):
        for reason, name in CONTRACT.findall(path.read_text()):
            contracts[name] = plain(reason)
        unproven += UNPROVEN.findall(path.read_text())
    if arguments.only:
        drivers = [d for d in drivers if arguments.only in d.kernel]
    passed = failed = 0

    def tally(good, text):
        nonlocal passed, failed
        passed, failed = passed + good, failed + (not good)
        if not good:
            print(text)

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(d.prove, arguments.frama_c, arguments.include, arguments.output / f"{d.kernel}.log")
                for d in drivers]
        for job in jobs:
            d = job.result()
            tally(bool(d.problems) == d.planted,
                  f"{d.path.name}: {d.kernel}: " + ("planted, and not found" if d.planted else "; ".join(d.problems[:3])))
    if not arguments.only:
        names = {d.kernel for d in drivers}
        for name, reason in contracts.items():
            tally(bool(reason) or name in names, f"contract of {name}: has neither a driver nor what it stands on")
        used = {c for d in drivers for c in d.contracts}
        tally(used <= set(contracts), f"no contract: {used - set(contracts)}")
        (arguments.output / "proofs.md").write_text(page(drivers, contracts, unproven))
    print(f"{passed} passed, {failed} failed")
    return failed > 0


sys.exit(main())
