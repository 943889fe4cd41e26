#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the library's objects, one directory for each core and optimisation:

- no undefined symbol but those listed below;
- no floating point: no helper function, and on a core with an FPU no instruction of it;
- no floating point in what a program makes of literals by glint.h's macros, without optimisation either;
- no writable data;
- no recursion through direct calls;
- no function that nothing refers to: a compiler leaves one when it wrongly drops its calls (gcc 12's -Os has done so);
- where int has 16 bits numeric.h does not compile, and says why;
- what compilers other than gcc and clang do not know stands behind __GNUC__.

Each check is also shown to find what tests/freestanding/planted.c plants. tools/stack bounds the stack.
"""
import argparse
import glob
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "board"))
from qemu import Tally

# What the compiler may call: memory blocks (port/libc for firmware without a C library), and libgcc's integer helpers.
ALLOWED = re.compile(r"""^(
    memcpy | memset |
    __aeabi_u?idiv | __aeabi_u?idivmod |          # 32-bit division
    __aeabi_u?ldivmod | __aeabi_lmul |            # 64-bit division and product
    __aeabi_lasr | __aeabi_llsl | __aeabi_llsr |  # 64-bit shifts
    __aeabi_lcmp | __aeabi_ulcmp |                # 64-bit comparison
    __clzsi2 | __clzdi2 | __ctzsi2 | __popcountsi2 |
    __gnu_thumb1_case_(si|shi|sqi|uhi|uqi)        # switch tables on ARMv6-M
)$""", re.VERBOSE)

# Run-time functions of floating point: Arm's names, and gcc's (sf, df, tf; also in conversions such as floatsisf).
FLOAT_HELPER = re.compile(r"^(__aeabi_(f|d|cf|cd|i2|ui2|l2|ul2|h2)\w*|__\w*[sdt]f\w*|__\w*(fix|float)\w*)$")
FLOAT_INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\t[0-9a-f ]+\t(v(?:add|sub|mul|div|neg|abs|sqrt|cvt|cmp|mov|ldr|str|ldm|stm|"
                               r"push|pop|mla|mls|fm|fnm|nm|sel|mrs|msr|rint)\w*)", re.MULTILINE)


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def of_each(tool, objects):
    """[(object, what the tool prints of it)], by one run of it for all."""
    text = run(*tool, *objects, objects[0])  # nm names objects where there is more than one
    parts = re.split(r"^(%s):(?: +file format \S+)?$" % "|".join(map(re.escape, objects)), text, flags=re.MULTILINE)
    return list(zip(parts[1::2], parts[2::2]))[:len(objects)]


def undefined(cross, objects, output):
    """Undefined symbols of all objects linked together."""
    run(cross + "ld", "-r", "-o", output, *objects)
    return [line.split()[-1] for line in run(cross + "nm", "-u", output).splitlines()]


LITERALS = """#include "glint.h"
glint_light use(glint_camera *camera);
glint_light use(glint_camera *camera) {
    const glint_vector place = GLINT_VECTOR(-1, 0.1, 2.7);
    const glint_colour colour = GLINT_COLOUR(1, 0.5, 0.1);
    *camera = glint_camera_default();
    camera->near_plane = GLINT_Q16(-0.3);
    return camera->projection ? glint_sun(place, colour) : glint_lamp(place, colour, GLINT_Q16(7.5));
}
"""


def check_literals(tally, cross):
    """The compiler folds literals, in C and in C++."""
    for compiler, language in (("gcc", "c"), ("g++", "c++")):
        for level in ("-O0", "-Os"):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "literals.o")
                compiled = subprocess.run([cross + compiler, "-mcpu=cortex-m0", "-mthumb", level, "-Isrc", "-c", "-x", language,
                                           "-", "-o", path], input=LITERALS, capture_output=True, text=True)
                tally.check(compiled.returncode == 0, "literals: " + compiled.stderr)
                names = [line.split()[-1] for line in run(cross + "nm", "-u", path).splitlines()]
                floats = [name for name in names if FLOAT_HELPER.match(name)]
                tally.check("glint_sun" in names and not floats, "literals in %s, %s: %s" % (language, level, floats))


def writable(cross, objects):
    """Sections that would take RAM, as `object: section`."""
    found = []
    for path, text in of_each((cross + "objdump", "-h", "-w"), objects):
        for line in text.splitlines():
            fields = line.split()
            if len(fields) > 7 and fields[0].isdigit() and int(fields[2], 16) and "ALLOC" in line and \
                    "READONLY" not in line:
                found.append("%s: %s" % (path, fields[1]))
    for path, text in of_each((cross + "nm",), objects):
        found += ["%s: common" % path for line in text.splitlines() if " C " in line]
    return found


def unreferenced(cross, objects):
    """Static functions that nothing in their object refers to but what debuggers read; each has a section of its own."""
    found = []
    references, symbols = of_each((cross + "objdump", "-r"), objects), of_each((cross + "nm",), objects)
    for (path, relocations), (_, names) in zip(references, symbols):
        sections = re.split(r"^RELOCATION RECORDS FOR \[", relocations, flags=re.MULTILINE)
        code = "".join(section for section in sections if not section.startswith(".debug"))
        targets = set(re.findall(r"\sR_ARM_\w+\s+(?:\.text\.)?([\w.$]+)", code))
        statics = re.findall(r"^[0-9a-f]+ t ([A-Za-z_][\w.]*)$", names, re.MULTILINE)
        found += ["%s: %s" % (path, name) for name in statics if name not in targets]
    return found


def float_instructions(cross, objects):
    return FLOAT_INSTRUCTION.findall(run(cross + "objdump", "-d", *objects))


def call_graph(paths):
    """From gcc's -fcallgraph-info: {function: (stack, set of called functions)}; statics are named file:function."""
    graph = {}
    for path in paths:
        with open(path) as file:
            text = file.read()
        for name, label in re.findall(r'node: \{ title: "([^"]*)" label: "([^"]*)"', text):
            stack = re.search(r"(\d+) bytes \((\w+)", label)
            if stack:
                graph.setdefault(name, [0, set()])[0] = int(stack[1])
        for caller, callee in re.findall(r'edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', text):
            graph.setdefault(caller, [0, set()])[1].add(callee)
    return graph


def cycle(graph):
    """A function that reaches itself by direct calls, or None."""
    state = {}

    def visit(name):
        state[name] = 1
        for callee in graph.get(name, (0, ()))[1]:
            if state.get(callee) == 1 or (callee not in state and visit(callee)):
                return True
        state[name] = 2
        return False

    return next((name for name in graph if name not in state and visit(name)), None)


def public_functions():
    found = []
    for header in ("src/glint.h", "src/glint_extras.h"):
        with open(header) as file:
            found += re.findall(r"^[\w ]+[ *](glint_\w+)\(", file.read(), re.MULTILINE)
    return found


def built(directory, end):
    """What is built of each source that there is: a folder built earlier also has what is left of others."""
    return [os.path.join(directory, source[:-len("c")] + end) for source in sorted(glob.glob("src/*/*.c"))]


def check_planted(tally, cross, directory):
    objects = [directory + "/tests/freestanding/planted.o"]
    outside = undefined(cross, objects, directory + "/planted.out")
    graph = call_graph([directory + "/tests/freestanding/planted.ci"])
    tally.check([name for name in outside if not ALLOWED.match(name)], directory + ": planted call not found")
    tally.check([name for name in outside if FLOAT_HELPER.match(name)], directory + ": planted float helper not found")
    tally.check(writable(cross, objects), directory + ": planted variable not found")
    tally.check(cycle(graph), directory + ": planted recursion not found")
    tally.check(unreferenced(cross, objects), directory + ": planted function without a call not found")
    if "m4f" in directory:
        tally.check(float_instructions(cross, objects), directory + ": planted instruction not found")


def check_library(tally, cross, directory):
    objects = built(directory, "o")
    outside = undefined(cross, objects, directory + "/glint.out")
    graphs = built(directory, "ci")
    lost = [path for path in graphs if not os.path.exists(path)]
    tally.check(not lost, "no call graph, which the compiler writes beside the object: %s" % " ".join(lost))
    graph = call_graph([path for path in graphs if path not in lost])
    floats = [name for name in outside if FLOAT_HELPER.match(name)] + float_instructions(cross, objects)
    strangers = [name for name in outside if not ALLOWED.match(name)]
    tally.check(not strangers, "%s: undefined: %s" % (directory, " ".join(strangers)))
    tally.check(not floats, "%s: floating point: %s" % (directory, " ".join(floats)))
    data = writable(cross, objects)
    tally.check(not data, "%s: writable: %s" % (directory, " ".join(data)))
    uncalled = unreferenced(cross, objects)
    tally.check(not uncalled, "%s: nothing refers to %s" % (directory, " ".join(uncalled)))
    turning = cycle(graph)
    tally.check(not turning, "%s: recursion through %s" % (directory, turning))
    public = public_functions()
    missing = [name for name in public if name not in graph]
    tally.check(public and not missing, "%s: declared but not defined: %s" % (directory, " ".join(missing)))
    print("  %s: needs %s" % (directory, " ".join(outside) or "nothing"))


# What firmware that names none of it is to be without, and what names it.
OPTIONAL = (("glint_lines_draw", "walk_along"), ("glint_lines_project", "clip_line"), ("glint_orthographic", "set_range"),
            ("glint_sun", "glint_sun"), ("glint_lamp", "glint_lamp"), ("glint_spot", "glint_spot"))


def check_linked(tally, cross, directory):
    """What only some programs name is in those alone, as a linker that collects sections leaves it."""
    objects = built(directory, "o")
    for name, inside in OPTIONAL:
        for is_named in (False, True):
            output = directory + "/linked.out"
            run(cross + "ld", "--gc-sections", "--unresolved-symbols=ignore-all", "-e", "glint_render",
                *(["-u", name] if is_named else []), "-o", output, *objects)
            found = set(re.findall(r" (\w+)$", run(cross + "nm", output), re.MULTILINE))
            there = [symbol for symbol in (name, inside) if symbol in found]
            tally.check(bool(there) == is_named, "%s: %s linked, %snamed" % (directory, there, "" if is_named else "not "))


def check_int(tally):
    """What numeric.h says where int has 16 bits, and that it compiles where int has 32."""
    for target, fits in (("msp430-elf", False), ("arm-none-eabi", True)):
        compiled = subprocess.run(["clang", "--target=" + target, "-std=c99", "-ffreestanding", "-fsyntax-only", "-Isrc",
                                   "-include", "math/numeric.h", "-x", "c", os.devnull], capture_output=True, text=True)
        said = "glint_int_of_32_bits" in compiled.stderr
        tally.check((compiled.returncode == 0) == fits and said != fits, "numeric.h for %s: %s" % (target, compiled.stderr))


def check_plain_c(tally):
    """The library without what only GNU's compilers know: each such word is an error here."""
    foreign = ["-D%s=outside_of_c99" % word for word in ("__attribute__(x)", "__asm__", "__builtin_clz")]
    compiled = subprocess.run(["gcc", "-U__GNUC__", *foreign, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
                               "-ffreestanding", "-fsyntax-only", "-Isrc", *sorted(glob.glob("src/*/*.c"))],
                              capture_output=True, text=True)
    tally.check(compiled.returncode == 0, "without GNU's extensions: " + compiled.stderr)


def check_one_file(tally):
    """All of the library as one file, as some builds take it: no two names of file scope are the same."""
    sources = "".join('#include "%s"\n' % path for path in sorted(glob.glob("src/*/*.c")))
    compiled = subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-Wno-unused-function",
                               "-ffreestanding", "-fsyntax-only", "-I.", "-x", "c", "-"],
                              input=sources, capture_output=True, text=True)
    tally.check(sources and compiled.returncode == 0, "as one file: " + compiled.stderr)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cross", required=True)
    parser.add_argument("directories", nargs="+")
    arguments = parser.parse_args()
    tally = Tally()
    check_int(tally)
    check_plain_c(tally)
    check_one_file(tally)
    check_literals(tally, arguments.cross)
    for directory in arguments.directories:
        check_planted(tally, arguments.cross, directory)
        check_library(tally, arguments.cross, directory)
        check_linked(tally, arguments.cross, directory)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
