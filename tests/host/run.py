# SPDX-License-Identifier: MIT
"""Drives the host program from outside: run.py PROGRAM. Closes with `N passed, N failed`; status 1 on a failure."""
import os
import sys
import traceback

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
import test_animate
import test_clusters
import test_convert
import test_errors
import test_gallery
import test_import
import test_labels
import test_materials
import test_normals
import test_obj
import test_objects
import test_output
import test_place
import test_render
import test_scene
import test_shading
import test_shapes
import test_simplify
import test_terminal
import test_winding
from harness import Host


def main():
    host = Host(sys.argv[1])
    for module in (test_render, test_shading, test_obj, test_materials, test_place, test_winding, test_shapes, test_normals, test_errors, test_convert, test_objects, test_import, test_simplify,
                   test_clusters, test_scene, test_labels, test_animate, test_terminal, test_output, test_gallery):
        for name in (name for name in vars(module) if name.startswith("test_")):
            try:
                vars(module)[name](host)
            except Exception:  # pylint: disable=broad-except # one broken test must not hide the others
                host.check(f"{module.__name__}.{name}", False, traceback.format_exc())
    print(f"{host.passed} passed, {host.failed} failed")
    return 1 if host.failed or not host.passed else 0


if __name__ == "__main__":
    sys.exit(main())
