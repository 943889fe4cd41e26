#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What tally.py counts, in a clone of its own: tally_test.py. Closes with `N passed, N failed`."""
import os
import subprocess
import sys
import tempfile

TALLY = os.path.join(os.path.dirname(os.path.abspath(__file__)), "tally.py")


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True).stdout


def write(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)


def commit(name, text):
    write(name, text)
    run("git", "add", name)
    run("git", "-c", "user.name=test", "-c", "user.email=test", "commit", "-q", "-m", name)
    return run("git", "log", "-1", "--format=%h", "--abbrev=12").strip()


def fuzz(runs):
    write("out/fuzz_a.log", "#1 a line of progress\nstat::number_of_executed_units: %d\n" % runs)
    return run(sys.executable, TALLY, "--programs", "out", "fuzz_a", "a.c")


def figures():
    """@return runs and commits of what is kept"""
    run(sys.executable, TALLY, "--programs", "out", "--figures", "figures.csv")
    with open("figures.csv", encoding="utf-8") as file:
        return [tuple(line.split(",")[1:3]) for line in file.read().splitlines()[1:]]


def main():
    good = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        run("git", "init", "-q")
        os.mkdir("out")
        write("out/a.d", "out/a.o: a.c \\\n  a.h /usr/include/b.h\n\na.h:\n")
        commit("a.c", "")
        first = commit("a.h", "")
        commit("other.c", "")
        fuzz(10)
        good.append("15 in all" in fuzz(5))
        good.append(figures() == [("15", first)])
        good.append(figures() == [("15", first)])  # once is enough
        fuzz(7)
        good.append(figures() == [("22", first)])
        write("a.h", "changed")
        good.append("not counted" in fuzz(1))
        second = commit("a.h", "changed")
        fuzz(3)
        good.append(figures() == [("22", first), ("3", second)])
        os.chdir("/")
    print("%d passed, %d failed" % (good.count(True), good.count(False)))
    return not all(good)


if __name__ == "__main__":
    sys.exit(main())
