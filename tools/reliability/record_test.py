#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What record.py keeps, in a clone of its own: record_test.py. Closes with `N passed, N failed`."""
import os
import subprocess
import sys
import tempfile

RECORD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "record.py")


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def commit(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)
    run("git", "add", name)
    run("git", "-c", "user.name=test", "-c", "user.email=test", "commit", "-q", "-m", name)
    return run("git", "log", "-1", "--format=%h", "--abbrev=12").stdout.strip()


def record(pattern, script, what="calls"):
    """@return exit status and text of a run that prints by a script"""
    done = run(sys.executable, RECORD, "--runs", "runs.csv", "--run", "a", "--counts", what + "=" + pattern, "--sources", "a.c",
               "--", "sh", "-c", script)
    return done.returncode, done.stdout


def kept():
    """@return what, count and commit of each row that was moved to the figures"""
    run(sys.executable, RECORD, "--runs", "runs.csv", "--figures", "figures.csv")
    with open("figures.csv", encoding="utf-8") as file:
        return [tuple(line.split(",")[1:4]) for line in file.read().splitlines()[1:]]


def main():
    good = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        run("git", "init", "-q")
        first = commit("a.c", "")
        commit("other.c", "")
        good.append(record("([0-9]+) calls", "echo 3 calls; echo 5 calls") == (0, "3 calls\n5 calls\n"))
        good.append(kept() == [("calls", "5", first)])
        good.append(record("[0-9] calls", "echo 3 calls; echo 5 calls", "lines")[0] == 0)
        good.append(kept() == [("calls", "5", first), ("lines", "2", first)])
        good.append(record("([0-9]+) calls", "echo 7 calls; exit 3")[0] == 3)  # what failed is not kept
        good.append(record("([0-9]+) calls", "kill -9 $$")[0] != 0)
        status, text = record("([0-9]+) calls", "echo none")
        good.append(status == 1 and "calls" in text)
        with open("a.c", "w", encoding="utf-8") as file:
            file.write("changed")
        good.append("not kept" in record("([0-9]+) calls", "echo 9 calls")[1])
        good.append(kept() == [("calls", "5", first), ("lines", "2", first)])
        second = commit("a.c", "changed")
        record("([0-9]+) calls", "echo 11 calls")
        good.append(kept() == [("calls", "11", second), ("lines", "2", first)])
    print("%d passed, %d failed" % (sum(good), len(good) - sum(good)))
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
