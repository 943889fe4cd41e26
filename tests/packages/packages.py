#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every way to take the library: packages.py --build FOLDER [NAME...]. Names choose checks."""
import argparse
import concurrent.futures
import os
import sys

import arduino
import builds
import systems
import tree
from qemu import Tally

MODULES = [builds, arduino, systems]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True)
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    build, tally = tree.Build(arguments.build), Tally()
    checks = {name: function for module in MODULES for name, function in vars(module).items() if name.startswith("test_")}
    chosen = [name for name in checks if not arguments.names or name in arguments.names]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = {name: pool.submit(checks[name], build) for name in chosen}
        for name in chosen:
            try:
                running[name].result()
                tally.check(True, name)
            except Exception as error:  # whatever it is, the check has failed
                tally.check(False, "%s: %s" % (name, error))
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
