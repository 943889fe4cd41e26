#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worst-case stack of firmware: stack.py [--targets CSV] ELF...

Frames come from the compiler (-fstack-usage, files *.su beside the objects) or, for what is not C, from the prologue;
calls from the disassembly; the targets of a call through a pointer from the table, by the source function it stands in. A
row `above>function` has those of a call from `function` where `above` is among its callers.
Fails on recursion, on a frame without bound, on an indirect call whose function is not in the table, and when main and
the deepest interrupt need more than the linker script reserves.
The table is the targets.csv beside this file where no other is named.
"""
import argparse
import bisect
import collections
import csv
import fnmatch
import glob
import os
import re
import subprocess
import sys

# What the core saves when an interrupt comes: eight words, and one to align them.
EXCEPTION_FRAME = 36

TARGETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "targets.csv")

# `calls` are by the function above, or None: that of a row `above>function` in place of others.
Function = collections.namedtuple("Function", "name file frame calls")


class Wrong(Exception):
    """A stack that cannot be bounded."""


def run(*command, text=None):
    return subprocess.run(command, input=text, stdout=subprocess.PIPE, text=True, check=True).stdout


def prefix(elf):
    return "riscv64-unknown-elf-" if "RISC-V" in run("readelf", "-h", elf) else "arm-none-eabi-"


def frames(directory):
    """{(file, function): bytes} from the compiler; Wrong where one has no bound."""
    found = {}
    for path in glob.glob(os.path.join(directory, "**", "*.su"), recursive=True):
        with open(path) as file:
            for line in file:
                place, size, kind = line.rsplit("\t", 2)
                source, _, _, name = place.split(":", 3)
                if kind.strip() not in ("static", "dynamic,bounded"):
                    raise Wrong("%s in %s has a frame without bound" % (name, source))
                key = os.path.basename(source), name.split(".")[0]
                found[key] = max(found.get(key, 0), int(size))
    return found


def prologue(lines):
    """Bytes that a function's instructions push, all of them together."""
    total = 0
    for _, operation, operands in lines:
        if operation in ("push", "stmdb") or operation.startswith("push."):
            names = re.search(r"\{(.*)\}", operands)
            for part in names[1].split(",") if names and (operation != "stmdb" or operands.startswith("sp!")) else ():
                ends = [int(word) for word in re.findall(r"r(\d+)", part)]
                total += 4 * (ends[-1] - ends[0] + 1 if len(ends) == 2 else 1)
        elif operation in ("sub", "subw", "sub.w") and operands.startswith("sp"):
            total += int(re.search(r"#(\d+)", operands)[1])
        elif operation in ("addi", "c.addi16sp", "c.addi") and operands.startswith("sp,sp,-"):
            total += int(operands[7:])
    return total


def is_indirect(operation, operands):
    if operation in ("blx", "bx"):
        return operands.split()[0] != "lr"
    return operation in ("jalr", "jr") and operands.split(",")[0] not in ("ra", "t0") or \
        operation == "c.jalr" or operation == "c.jr" and operands != "ra"


def disassemble(tools, elf):
    """{address: (name, [(address, operation, operands)])} of every function."""
    functions, current = {}, None
    for line in run(tools + "objdump", "-d", "--no-show-raw-insn", elf).splitlines():
        head = re.match(r"^([0-9a-f]{8}) <(.+)>:$", line)
        if head:
            current = functions.setdefault(int(head[1], 16), (head[2], []))
            continue
        body = re.match(r"^\s*([0-9a-f]+):\t(\S+)\s*(.*)$", line)
        if body and current and not body[2].startswith(".") and not is_return(current[1], body[2], body[3]):
            current[1].append((int(body[1], 16), body[2], body[3]))
    return functions


def is_return(before, operation, operands):
    """ARMv6-M returns by `pop {r3}`, `add sp, #8`, `bx r3` where arguments lie above the return address."""
    return operation == "bx" and [line[1:] for line in before[-2:-1]] == [("pop", "{%s}" % operands)] and \
        before[-1][1] == "add" and before[-1][2].startswith("sp,")


def sources(tools, elf, addresses):
    """{address: [(function, file)] from the innermost inlined one outwards}."""
    if not addresses:
        return {}
    text = run(tools + "addr2line", "-a", "-f", "-i", "-e", elf, text="".join("0x%x\n" % a for a in addresses))
    found, current, name = {}, None, None
    for line in text.splitlines():
        if re.match(r"^0x[0-9a-f]{8}$", line):
            current, name = found.setdefault(int(line, 16), []), None
        elif name is None:
            name = line
        else:
            current.append((name, os.path.basename(line.split(":")[0])))
            name = None
    return found


def targets_of(place, table, known, above=""):
    """Functions that an indirect call in a source function may reach, below another one."""
    for function, source in place:
        for caller in (above + "%s:%s" % (source, function), above + function):
            if caller in table:
                return [address for address, (name, file) in known.items()
                        for pattern in table[caller] if fnmatch.fnmatch("%s:%s" % (file, name), pattern)]
    return None


def functions_above(table):
    return {caller.split(">")[0] for caller in table if ">" in caller}


def read(elf, table):
    """{address: Function} of a firmware."""
    tools = prefix(elf)
    code = disassemble(tools, elf)
    starts = sorted(code)
    # build/<board>/<level>/<program>.elf: the objects lie beside it
    sizes = frames(os.path.dirname(elf))
    indirect = [address for _, lines in code.values() for address, operation, operands in lines
                if is_indirect(operation, operands)]
    places = sources(tools, elf, starts + indirect)
    known = {start: (code[start][0].split(".")[0], places[start][-1][1]) for start in starts}
    functions, all_above = {}, functions_above(table)
    for start in starts:
        name, file = known[start]
        calls, lines = set(), code[start][1]
        reached_below = {above: set() for above in (None, *all_above)}
        for address, operation, operands in lines:
            target = re.search(r"\b(?:0x)?([0-9a-f]+) <([^+>]+)>", operands)
            if target and re.match(r"^(b|bl|jal|j|c\.j|tail|call|c\.jal|beq|bne|blt|bge|bgt|ble|bcc|bcs|bhi|bls|bmi|bpl)(\.[nw])?$", operation):
                to = starts[bisect.bisect_right(starts, int(target[1], 16)) - 1]
                if to != start or operation.startswith(("bl", "jal")) and not operation.startswith(("ble", "blt", "bls")):
                    calls.add(to)
            elif is_indirect(operation, operands):
                reached = targets_of(places[address], table, known)
                if reached is None:
                    raise Wrong("an indirect call in %s (%s) is in no table: a row of it names what the call reaches (--targets)" % (
                        places[address][0][0], file))
                for above, of in reached_below.items():
                    below = targets_of(places[address], table, known, above + ">") if above else None
                    of.update(reached if below is None else below)
        frame = sizes.get((file, name))
        functions[start] = Function(name, file, prologue(lines) if frame is None else frame,
                                    {above: calls | of for above, of in reached_below.items()})
    return functions


def deepest(functions, start, path=(), known=None, above=None):
    """(bytes, chain of names) of the worst chain of calls from a function, below another one or None."""
    known = {} if known is None else known
    above = functions[start].name if functions[start].name in functions[start].calls else above
    if start in path:
        raise Wrong("recursion: " + " -> ".join(functions[a].name for a in path[path.index(start):] + (start,)))
    if (start, above) not in known:
        below = max((deepest(functions, call, path + (start,), known, above) for call in functions[start].calls[above]),
                    default=(0, []))
        known[start, above] = below[0] + functions[start].frame, [functions[start].name] + below[1]
    return known[start, above]


def reserve(elf):
    with open(elf[:-len(".elf")] + ".size") as file:
        return int(re.search(r"\(stack (\d+)\)", file.read())[1])


def read_table(path=TARGETS):
    """{calling function: patterns of what it may reach}"""
    with open(path, newline="") as file:
        return {row["caller"]: row["targets"].split() for row in csv.DictReader(file)}


def check(elf, functions):
    """@return (worst bytes, reserved bytes, chain)"""
    known = {}
    entry = next((address for address, function in functions.items()
                  if function.file == "startup.c" and function.name in ("reset", "start")), None)
    if entry is None:
        raise Wrong("no reset or start in a startup.c, from which the program begins")
    worst, chain = deepest(functions, entry, known=known)
    interrupts = [deepest(functions, address, known=known)[0] + EXCEPTION_FRAME
                  for address, function in functions.items() if function.name == "interrupt"]
    return worst + max(interrupts, default=0), reserve(elf), chain


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--targets", default=TARGETS)
    parser.add_argument("elf", nargs="+")
    arguments = parser.parse_args()
    table = read_table(arguments.targets)
    passed = failed = 0
    for elf in arguments.elf:
        try:
            functions = read(elf, table)
            worst, reserved, chain = check(elf, functions)
            good = worst <= reserved
            print("%s: %d of %d bytes: %s" % (elf, worst, reserved, " > ".join(chain)))
        except (Wrong, OSError, subprocess.CalledProcessError) as problem:
            good = False
            print("%s: %s" % (elf, problem))
        passed, failed = passed + good, failed + (not good)
        if not good:
            print("FAILED: " + elf)
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
