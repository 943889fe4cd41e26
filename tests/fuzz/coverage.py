#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs fuzz targets over their kept corpora and holds what these reach: coverage.py --programs FOLDER --corpora FOLDER.

Each corpus is replayed; the renderer's is also changed at random, RANDOM times by a fixed seed. An input that is
reported fails, and so does a folder of the library of which the renderer's corpus runs fewer than 75 % of the lines, and
a file of which fewer than 90 % are run: those of the readers of models and of what glint-import prints, of the command line
and of panels' drivers by their own. Closes with `N passed, N failed`.
"""
import argparse
import os
import subprocess
import sys
import tempfile

RANDOM = {"fuzz_render": 2000}

LEAST = 90  # % of a file's lines
LEAST_OF_FOLDER = 75  # % of the lines of a folder of the library

# What each target's corpus must reach: files whose names begin so.
REACHES = {
    "fuzz_render": ("src/",),
    "fuzz_differential": (),
    "fuzz_obj": ("port/host/obj.c", "port/host/text.c", "port/host/polygon.c", "port/host/topology.c"),
    "fuzz_mtl": ("port/host/mtl.c", "port/host/text.c", "port/host/material.c"),
    "fuzz_formats": tuple("port/host/" + name for name in ("reader.c", "stl.c", "ply.c", "off.c", "json.c", "gltf", "physical.c",
                                                              "png_read.c", "inflate.c", "texture.c")),
    "fuzz_import": ("port/host/importer.c", "port/host/join.c"),
    "fuzz_command": tuple("port/host/" + name for name in ("main.c", "settings.c", "values.c", "number.c", "shapes.c")),
    "fuzz_panel": ("port/panel/",),
}


# What other cores than the host run in its place: the host's forms alone are run here.
OTHER_CORES = ("src/math/division.h", "src/math/product.h")


def run(*command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)


def replay(program, corpus, profile):
    """@return whether each input passed"""
    done = run(program, "-runs=0", "-timeout=60", "-artifact_prefix=%s-" % program, corpus,
               env=dict(os.environ, LLVM_PROFILE_FILE=profile))
    count = len(os.listdir(corpus))
    more = RANDOM.get(os.path.basename(program), 0)
    if more and done.returncode == 0:
        with tempfile.TemporaryDirectory() as found:
            done = run(program, "-runs=%d" % (count + more), "-seed=1", "-timeout=60", "-max_len=4096",
                       "-artifact_prefix=%s-" % program, found, corpus, env=dict(os.environ, LLVM_PROFILE_FILE="/dev/null"))
    for line in done.stdout.splitlines():
        if done.returncode or line.startswith("worst"):
            print("    " + line)
    print("    %s: %d inputs and %d random ones, %s" % (os.path.basename(program), count, more,
                                                        "a report" if done.returncode else "no report"))
    return done.returncode == 0 and count > 0


def lines_of(program, profile):
    """@return of each file the lines that can be run, and of these those that were"""
    merged = profile + ".merged"
    subprocess.run(["llvm-profdata", "merge", "-sparse", profile, "-o", merged], check=True)
    export = subprocess.run(["llvm-cov", "export", "-format=lcov", "-instr-profile", merged, program],
                            stdout=subprocess.PIPE, text=True, check=True)
    files, lines = {}, None
    for record in export.stdout.splitlines():
        kind, _, value = record.partition(":")
        if kind == "SF":
            lines = files.setdefault(os.path.relpath(value), [0, 0])
        elif kind == "DA":
            lines[0] += 1
            lines[1] += int(value.split(",")[1]) > 0
    return files


def judge(program, prefixes, profile):
    """@return for each file that the corpus must reach, or each folder of the library, whether it does"""
    found = {}
    for name, lines in lines_of(program, profile).items():
        if name.startswith(prefixes) and name not in OTHER_CORES:
            place = os.path.dirname(name) + "/" if name.startswith("src/") else name
            found[place] = [a + b for a, b in zip(found.get(place, (0, 0)), lines)]
    good = []
    for name, (count, reached) in sorted(found.items()):
        good.append(100 * reached >= (LEAST_OF_FOLDER if name.endswith("/") else LEAST) * count)
        print("%-32s %5d of %5d lines, %5.1f %%%s" % (name, reached, count, 100 * reached / count,
                                                      "" if good[-1] else "  too few"))
    return good or [False]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", required=True)
    parser.add_argument("--corpora", required=True)
    arguments = parser.parse_args()
    good = []
    for target, prefixes in REACHES.items():
        program = os.path.join(arguments.programs, target)
        profile = program + ".profraw"
        good.append(replay(program, os.path.join(arguments.corpora, target), profile))
        if prefixes and good[-1]:
            good += judge(program, prefixes, profile)
    failed = good.count(False)
    print("%d passed, %d failed" % (len(good) - failed, failed))
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
