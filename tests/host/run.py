# SPDX-License-Identifier: MIT
"""Drives the host program from outside: run.py PROGRAM. Closes with `N passed, N failed`; status 1 on a failure."""
import glob
import importlib
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
from harness import Host


def main():
    host = Host(sys.argv[1])
    for file in sorted(glob.glob("test_*.py", root_dir=os.path.dirname(os.path.abspath(__file__)))):
        module = importlib.import_module(file[:-3])
        for name in (name for name in vars(module) if name.startswith("test_")):
            host.test(f"{module.__name__}.{name}", vars(module)[name])
    print(f"{host.passed} passed, {host.failed} failed")
    return 1 if host.failed or not host.passed else 0


if __name__ == "__main__":
    sys.exit(main())
