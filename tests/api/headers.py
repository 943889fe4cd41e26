#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The public headers, as users include them:

- each compiles by itself, and so does every macro in it, as C99, C11 and C17 and as C++98 to C++20, by gcc and clang;
- what they bring has names of their own: functions, types and constants glint_ and GLINT_, macros and guards GLINT_;
- so has every symbol of the library and of the panels; no two of their objects, nor two of src/'s headers for users,
  have one file name;
- no example names a member below `@privatesection`: each compiles where these have other names;
- a function that returns an int answers 1 or 0, and says so; what can fail returns a glint_status;
- each code of glint_status is below the one before it, and has a sentence, as former codes have.
"""
import argparse
import collections
import concurrent.futures
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "board"))
from qemu import Tally

INCLUDES = ["-Isrc", "-Iport"]
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Wundef", "-Werror"]
LANGUAGES = [("c", standard) for standard in ("c99", "c11", "c17")] + \
            [("c++", standard) for standard in ("c++98", "c++11", "c++14", "c++17", "c++20")]
COMPILERS = {"gcc": {"c": ["gcc"], "c++": ["g++"]}, "clang": {"c": ["clang"], "c++": ["clang++"]},
             "arm": {"c": ["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb"],
                     "c++": ["arm-none-eabi-g++", "-mcpu=cortex-m0", "-mthumb"]}}
MORE = {"c": ["-Wstrict-prototypes", "-Wmissing-prototypes"],
        "c++": ["-Wold-style-cast"]}

# Macros that take something, as a user writes them; a list of bytes may stand for several numbers.
CALLS = {"GLINT_Q16": ["GLINT_Q16(0.25)", "GLINT_Q16(-0.25)", "GLINT_Q16(3)"],
         "GLINT_VECTOR": ["GLINT_VECTOR(0.25, -0.25, 3)"], "GLINT_COLOUR": ["GLINT_COLOUR(0, 0.25, 1)"],
         "GLINT_PANEL_SEND": ["GLINT_PANEL_SEND(2)"], "GLINT_PANEL_DELAY": ["GLINT_PANEL_DELAY(5)"]}

# Macros that initialise a structure.
VALUES = {"GLINT_VECTOR": "glint_vector", "GLINT_COLOUR": "glint_colour"}

# Who names what: a board's own functions are its, and the library's are glint's.
PREFIXES = {"port/board.h": "board_", "port/display.h": "glint_"}


def run(*command, text=None):
    return subprocess.run(command, input=text, capture_output=True, text=True)


def macros_of(header):
    """What a header defines beyond the standard's: {name: takes something}, as the preprocessor tells."""
    def defined(text):
        lines = run("gcc", "-std=c99", *INCLUDES, "-dM", "-E", "-x", "c", "-", text=text).stdout.splitlines()
        return {re.split(r"[ (]", line)[1]: "(" == line.split(" ", 2)[1][len(re.split(r"[ (]", line)[1]):][:1]
                for line in lines}
    found = defined('#include "%s"\n' % header)
    for name in defined("#include <stddef.h>\n#include <stdint.h>\n"):
        found.pop(name, None)
    return found


def program(header, macros):
    """A source that includes the header twice, with every macro of it."""
    lines = ['#include "%s"' % header, '#include "%s"' % header]
    for name in sorted(macros):
        if name.endswith("_H"):
            continue
        values = CALLS[name] if macros[name] else [name]
        if name in VALUES:
            lines += ["extern const %s use_%s;" % (VALUES[name], name), "const %s use_%s = %s;" % (VALUES[name], name, values[0])]
            continue
        for at, value in enumerate(values):
            lines += ["extern const long use_%s_%d[];" % (name, at), "const long use_%s_%d[] = {%s};" % (name, at, value)]
    return "\n".join(lines + ["int use(void);", "int use(void) { return 0; }", ""])


def compile_all(tally, headers, macros):
    jobs = []
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for header in headers:
            for language, standard in LANGUAGES:
                path = os.path.join(folder, "%d.%s" % (len(jobs), "c" if language == "c" else "cpp"))
                with open(path, "w") as file:
                    file.write(program(header, macros[header]))
                for compiler, commands in COMPILERS.items():
                    jobs.append(("%s as %s by %s" % (header, standard, compiler),
                                 pool.submit(run, *commands[language], "-std=" + standard, *WARNINGS, *MORE[language],
                                             *INCLUDES,
                                             "-I.", "-fsyntax-only", path)))
        for what, job in jobs:
            done = job.result()
            tally.check(done.returncode == 0, "%s: %s" % (what, done.stderr[:600]))


def declarations(header):
    """Names at file scope that a header and what it includes of the project bring: {name: kind}."""
    tree = json.loads(run("clang", "-std=c99", *INCLUDES, "-I.", "-Xclang", "-ast-dump=json", "-fsyntax-only", "-x", "c",
                          "-", text='#include "%s"\n' % header).stdout)
    found, file = {}, ""
    for node in tree["inner"]:
        at = node.get("loc", {})
        at = at.get("spellingLoc", at)
        file = at.get("file", file)
        if not file or file.startswith("/"):
            continue
        if "name" in node:
            found[node["name"]] = node["kind"]
        for inner in node.get("inner", []) if node["kind"] == "EnumDecl" else []:
            if inner["kind"] == "EnumConstantDecl":
                found[inner["name"]] = inner["kind"]
    return found


def check_names(tally, header, macros, is_mesh):
    prefix = "teapot_" if is_mesh else PREFIXES.get(header, "glint_")
    prefixes = tuple({prefix, "glint_", "GLINT_"} | ({"board_"} if header.startswith("port/") else set()))
    strangers = [name for name in macros if not name.startswith("TEAPOT_" if is_mesh else "GLINT_")
                 and not name.startswith("GLINT_")]
    tally.check(not strangers, "%s: macros %s" % (header, " ".join(strangers)))
    found = declarations(header)
    strangers = [name for name in found if not name.startswith(prefixes)]
    tally.check(found and not strangers, "%s: names %s" % (header, " ".join(strangers)))


def check_linkage(tally, header):
    """Functions and objects keep the names that C gives them where C++ declares them."""
    named = sorted(name for name, kind in declarations(header).items() if kind in ("FunctionDecl", "VarDecl"))
    lines = ['#include "%s"' % header] + ["extern const void *const use_%s;\nconst void *const use_%s = "
                                          "reinterpret_cast<const void *>(&%s);" % (name, name, name) for name in named]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "use.o")
        done = run("g++", "-std=c++17", *INCLUDES, "-I.", "-c", "-o", path, "-x", "c++", "-", text="\n".join(lines) + "\n")
        mangled = [name for name in run("nm", path).stdout.split() if name.startswith("_Z")]
    tally.check(done.returncode == 0 and not [name for name in mangled if "glint_display_start" not in name],
                "%s in C++: %s %s" % (header, mangled, done.stderr[:600]))


def check_symbols(tally, what, objects):
    lines = run("nm", "--defined-only", "--extern-only", *objects).stdout.splitlines()
    names = [line.split()[-1] for line in lines if re.match(r"^[0-9a-f]+ [A-Z] ", line)]
    strangers = [name for name in names if not name.startswith("glint_")]
    tally.check(len(names) > 20 and not strangers, "%s: symbols %s" % (what, " ".join(strangers)))


def check_files(tally):
    """All objects may go into one folder; users see no header of the library's inside by its name alone."""
    sources = glob.glob("src/*/*.c") + glob.glob("port/panel/*.c")
    count = collections.Counter(os.path.basename(path) for path in sources)
    tally.check(sources and max(count.values()) == 1, "more than one: %s" % [n for n, c in count.items() if c > 1])
    headers = glob.glob("src/*.h")
    strangers = [path for path in headers if not os.path.basename(path).startswith("glint")]
    tally.check(headers and not strangers, "headers in src/ that are not glint's: %s" % strangers)


def rename_private(text):
    """A header with other names for what is private. @return it, and how many lines that were"""
    lines, is_private, count = [], False, 0
    for line in text.splitlines():
        starts = line == "    /** @privatesection */"
        is_private = starts or (is_private and not line.startswith("}"))
        if is_private and not starts:
            count += 1
            line = re.sub(r"(\w+)(?=(\)?(\[[^\]]*\])*[,;]))", r"private_\1", line.split("/*")[0])
        lines.append(line)
    return "\n".join(lines) + "\n", count


def check_private(tally):
    renamed = {}
    for name in ("glint.h", "glint_extras.h"):
        with open(os.path.join("src", name)) as file:
            renamed[name] = rename_private(file.read())
    count = sum(lines for _, lines in renamed.values())
    needs_sdk = glob.glob("examples/pico-sdk/*.c")
    examples = sorted(set(glob.glob("examples/*/*.c")) - set(needs_sdk))
    options = [option for path in ("src", "port", "port/host", "examples", "tests/adapters/declarations")
               for option in ("-I", path)] + ["-DBOARD_ARENA=65536", "-DBOARD_TILE_WIDTH=0", "-DBOARD_TILE_HEIGHT=0"]
    adapters = [path for path in examples if path.startswith("examples/adapters/")]
    with tempfile.TemporaryDirectory() as folder:
        for name, (text, _) in renamed.items():
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
        for path in examples:
            flags = ["-Iexamples/adapters", "-I/usr/include/libdrm"] if path in adapters else []
            done = run("gcc", "-std=gnu99", "-I" + folder, *options, *flags, "-fsyntax-only", path)
            tally.check(done.returncode == 0, "%s names what is private: %s" % (path, done.stderr[:600]))
        named = run("gcc", "-std=c99", "-I" + folder, "-Isrc", "-fsyntax-only", "-x", "c", "-", text=
                    '#include "glint.h"\nint use(glint_renderer *r);\nint use(glint_renderer *r) { return r->config.width; }\n')
        tally.check("no member named" in named.stderr and count > 40, "what is private is not found: %d lines" % count)


def check_answers(tally, headers):
    found = []
    for header in headers:
        with open(header) as file:
            found += [(header, name, comment) for comment, name in
                      re.findall(r"/\*\*((?:(?!\*/).)*)\*/\nint (\w+)\(", file.read(), re.DOTALL)]
    silent = ["%s: %s" % (header, name) for header, name, comment in found if "@return 1" not in comment]
    tally.check(len(found) >= 5 and not silent, "returns an int, and does not answer 1 or 0: %s" % silent)


def check_statuses(tally):
    with open("src/glint.h") as file:
        codes = [int(code) for code in re.findall(r"^    GLINT_(?:OK|ERROR_\w+) = (-?\d+)", file.read(), re.MULTILINE)]
    with open("src/frame/check.c") as file:
        sentences = re.findall(r'^        "[^"]+",$', file.read(), re.MULTILINE)
    tally.check(codes == sorted(set(codes), reverse=True) and codes[0] == 0 and len(codes) > 20,
                "codes of glint_status: %s" % codes)
    tally.check(len(sentences) == 1 - codes[-1] == len(set(sentences)),
                "%d sentences for codes to %d" % (len(sentences), codes[-1]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--mesh", required=True, help="a header that glint convert wrote")
    parser.add_argument("--library", required=True)
    parser.add_argument("--panels", required=True, nargs="+", help="objects of all panels")
    arguments = parser.parse_args()
    tally = Tally()
    own = sorted(glob.glob("src/*.h") + glob.glob("port/panel/*.h")) + ["port/board.h", "port/display.h"]
    headers = own + [arguments.mesh]
    macros = {header: macros_of(header) for header in headers}
    compile_all(tally, headers, macros)
    for header in headers:
        check_names(tally, header, macros[header], header == arguments.mesh)
    for header in own:
        check_linkage(tally, header)
    check_symbols(tally, arguments.library, [arguments.library])
    check_symbols(tally, "panels", arguments.panels)
    check_files(tally)
    check_private(tally)
    check_answers(tally, own)
    check_statuses(tally)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
