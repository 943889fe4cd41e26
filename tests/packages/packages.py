#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ways to take the library: packages.py --build FOLDER [--seed N] [NAME...]. Names choose checks; without them, a seed
picks one of those that differ little, and no seed takes all."""
import argparse
import concurrent.futures
import os
import random
import sys

import arduino
import builds
import systems
import tree
from qemu import Tally

MODULES = [builds, arduino, systems]

# Each compiles the whole library: for this machine or another, or by another of a system's ways.
GROUPS = [("test_copy", "test_copy_firmware", "test_single_gcc", "test_single_clang"),
          ("test_cmake_subdirectory", "test_cmake_fetch", "test_cmake_firmware"),
          ("test_meson_subproject", "test_meson_installed", "test_meson_firmware"),
          ("test_arduino_torus", "test_arduino_pyramid", "test_arduino_tft_espi", "test_arduino_lovyangfx"),
          ("test_pico", "test_pico_firmware"),
          ("test_esp_idf", "test_esp_idf_firmware", "test_zephyr", "test_zephyr_firmware")]


def left_out(seed):
    """What a seed leaves out: of each group all but one."""
    if seed is None:
        return set()
    chosen = random.Random(seed)
    return {name for group in GROUPS for name in set(group) - {chosen.choice(group)}}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True)
    parser.add_argument("--seed", type=int)
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    build, tally = tree.Build(arguments.build), Tally()
    checks = {name: function for module in MODULES for name, function in vars(module).items() if name.startswith("test_")}
    assert all(name in checks for group in GROUPS for name in group)
    chosen = arguments.names or [name for name in checks if name not in left_out(arguments.seed)]
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
