#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/reliability.md and SECURITY.md name, against the tree and the targets that `make help` lists, on standard input:

    reliability.py --suites "SUITE..."

Closes with `N passed, N failed`; status 1 on a failure.
"""
import argparse
import os
import re
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
PAGE = "docs/reliability.md"


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def named(name, targets):
    """What a page names that is not there: targets, files and folders."""
    text = read(name)
    missing = [target for target in re.findall(r"`make ([a-z-]+)", text) if target not in targets]
    links = [os.path.join(os.path.dirname(name), link) for link in re.findall(r"\]\(([^)#]+)", text)]
    paths = [path for path in re.findall(r"`((?:src|port|tests|tools|docs)/[\w./-]*)`", text)]
    return missing + [path for path in links + paths if not os.path.exists(os.path.join(ROOT, path))]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--suites", required=True)
    arguments = parser.parse_args()
    suites = arguments.suites.split()
    page = read(PAGE)
    targets = set(re.findall(r"^make (\S+)", sys.stdin.read(), re.MULTILINE)) | {"test", "lint"}
    tests = set(re.findall(r"`make (test-[a-z-]+)`", page))
    problems = [("suites that make test does not run", sorted(tests - set(suites))),
                *((f"{name} names what is not there", named(name, targets)) for name in (PAGE, "SECURITY.md"))]
    for name, wrong in problems:
        if wrong:
            print(f"FAILED {name}: {', '.join(wrong)}")
    failed = sum(bool(wrong) for _, wrong in problems)
    print(f"{len(problems) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
