# SPDX-License-Identifier: MIT
"""What `convert` writes for a program of several parts: objects by their names, two meshes of one model, a camera."""
import os
import re
import subprocess

from harness import MODELS, torus_text
from test_convert import COMPILERS, STRICT, convert, pair, report
from test_formats import gltf
from test_render import near

MATERIALS = "newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 0 1\n"
# A body of two materials, and two wheels, one of which is a group too.
CAR = """mtllib car.mtl
v -1 0 -1\nv 1 0 -1\nv 0 1 0\nv 0 0.5 -1.5
v -1 -0.2 0\nv -0.8 -0.2 0\nv -0.9 0 0.1\nv -0.9 -0.1 -0.2
v 1 -0.2 0\nv 0.8 -0.2 0\nv 0.9 0 0.1
o body\nusemtl red\nf 1 2 3\nf 1 3 4\nusemtl glass\nf 2 4 3\nf 2 1 4
o wheel left\nusemtl red\nf 5 6 7\nf 5 7 8\nf 6 8 7\nf 5 8 6
o wheel "r"\ng tyre\nf 9 11 10
"""


def objects(text, name):
    """(mesh, material, name, centre, triangles) of each object."""
    made = re.findall(r"^    \{&(\w+), &(\w+), \{", text, re.MULTILINE)
    names = re.search(rf"const char \*const {name}_object_names\[(\d+)\] = \{{\n(.*?)\}};", text, re.DOTALL)
    centres = re.search(rf"const glint_vector {name}_object_centres\[(\d+)\] = \{{\n(.*?)\}};", text, re.DOTALL)
    if [int(names[1]), int(centres[1])] != [len(made)] * 2:
        raise AssertionError(f"{len(made)} objects, {names[1]} names, {centres[1]} centres")
    counts = [int(re.search(rf" glint_mesh {mesh} = .*?(\d+)u, /\* triangles", text, re.DOTALL)[1]) for mesh, _ in made]
    return list(zip(*zip(*made), re.findall(r'"(.*)",', names[2]),
                    [tuple(int(v) / 65536 for v in row.split(",")) for row in re.findall(r"\{(.*)\}", centres[2])], counts))


def compiles(host, text, use):
    host.write("car.h", text)
    for compiler, suffix in COMPILERS:
        host.write(f"use.{suffix}", f'#include "car.h"\n#include "car.h"\nint main(void);\nint main(void) {{ return {use}; }}\n')
        run = subprocess.run([compiler, *(["-std=c99"] if suffix == "c" else []), *STRICT, "-fsyntax-only", f"use.{suffix}"],
                             cwd=host.folder, capture_output=True, text=True, check=False)
        host.equal(f"{use} with {compiler}", (run.returncode, run.stderr), (0, ""))
    os.remove(host.path("car.h"))


def test_objects(host):
    host.write("car.mtl", MATERIALS)
    host.write("car.obj", CAR)
    text = convert(host, "car.obj", "--objects")
    made = objects(text, "car")
    host.equal("a mesh for each, by object and material", [row[:3] + row[4:] for row in made], [
        ("car_mesh_body_red", "car_material_red", "body", 2), ("car_mesh_body_glass", "car_material_glass", "body", 2),
        ("car_mesh_wheel_left", "car_material_red", "wheel left", 4),
        ("car_mesh_wheel__r__tyre", "car_material_red", "wheel _r_ tyre", 1)])
    middles = [(0, .5, -.75), (0, .5, -.75), (-.9, -.1, -.05), (.9, -.1, .05)]
    host.check("their middles", all(abs(a - b) < 1e-3 for row, middle in zip(made, middles) for a, b in zip(row[3], middle)), str(made))
    host.check("the head says so", "\n *     glint convert car.obj --objects\n" in text)
    compiles(host, text, "car_objects[3].mesh->triangle_count != 1 || car_object_names[3][0] != 'w' || car_object_centres[3].x < 0")
    host.check("without the option they are one", "car_object_names" not in convert(host, "car.obj") and
               convert(host, "car.obj").count("static const glint_mesh ") == 2)
    source, header = pair(host, "car", "car.obj", "--objects")
    host.check("a pair has them", "\nextern const char *const car_object_names[4];\n" in header and
               "\nextern const glint_vector car_object_centres[4];" in header and objects(source, "car") == made)
    host.write("car.obj", CAR.replace("usemtl", "#").replace("mtllib", "#"))
    made = objects(convert(host, "car.obj", "--objects"), "car")
    host.equal("without materials", [row[:3] for row in made], [
        ("car_mesh_body", "car_material_default", "body"), ("car_mesh_wheel_left", "car_material_default", "wheel left"),
        ("car_mesh_wheel__r__tyre", "car_material_default", "wheel _r_ tyre")])
    for name in ("car.c", "car.obj", "car.mtl"):
        os.remove(host.path(name))


WINDING = r"(a\.obj:0: warning: .* are wound inconsistently .*\n)?"


def test_which_object(host):
    """A name that comes again is the same object; o ends a group; what is before any name, and no name, are the default."""
    points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    for lines, wanted in (("F g a F g b F g a F", [("default", 1), ("a", 2), ("b", 1)]), ("o x g a F o y F g a F", [("x a", 1), ("y", 1), ("y a", 1)]),
                          ("g F", [("default", 1)]), ("o x F o F", [("x", 1), ("default", 1)]), ("F", [("default", 1)])):
        text = lines.replace(" g", "\ng").replace(" o", "\no").replace(" F", "\nF").replace("F", "f 1 2 3")
        host.write("a.obj", points + text + "\n")
        made = objects(convert(host, "a.obj", "--objects", warning=WINDING), "a")
        host.equal(lines, sorted((row[2], row[4]) for row in made), sorted(wanted))
        host.equal(f"{lines}: identifiers differ", len({row[0] for row in made}), len(made))
    host.write("a.obj", points + "".join(f"g {i}\nf 1 2 3\n" for i in range(1025)))
    host.refuses("1025 objects", ["convert", "a.obj", "--objects", "-o", "a.h"], r"a\.obj:0: --objects: more than 1024 objects")
    host.equal("are none of a mesh's", host.info("a.obj")["triangles"], "1025")
    torus = torus_text(16, 12).replace("f ", "o left\nf ", 1)
    half = len(torus) // 2
    at = torus.index("\nf ", torus.index("\nf ") + half // 2)
    host.write("a.obj", torus[:at] + "\no right" + torus[at:])
    before, after = (objects(convert(host, "a.obj", "--objects", *options), "a") for options in ([], ["--simplify", "200"]))
    host.check("--simplify leaves them apart", [row[2] for row in after] == ["left", "right"] and
               sum(row[4] for row in after) <= 200 < sum(row[4] for row in before), f"{before} {after}")
    os.remove(host.path("a.obj"))


def test_nodes_are_objects(host):
    nodes = [{"children": [1, 2], "name": "car"}, {"mesh": 0, "name": "wheel 1"}, {"mesh": 0, "name": "wheel 2", "translation": [5, 0, 0]}]
    host.write("nodes.gltf", gltf(nodes=nodes))
    made = objects(convert(host, "nodes.gltf", "--objects"), "nodes")
    host.equal("nodes of glTF", [(row[2], row[4], round(row[3][0], 2)) for row in made], [("wheel 1", 4, .05), ("wheel 2", 4, 5.05)])


def test_two_in_one_program(host):
    """Two conversions of one model by the names of their files."""
    model = os.path.join(MODELS, "spot.obj")
    for name, options in (("near.h", []), ("far.h", ["--simplify", "200"]), ("whole.c", [])):
        host.equal(name, host.run("convert", model, *options, "-o", name).returncode, 0)
    host.check("the head says which", "\n *     glint convert spot.obj --simplify 200 -o far.h\n" in host.read("far.h").decode())
    host.write("use.c", '#include "far.h"\n#include "near.h"\n#include "whole.h"\nint main(void);\nint main(void) { '
               "return !(far_mesh.triangle_count < near_mesh.triangle_count && near_mesh.triangle_count == whole_mesh.triangle_count); }\n")
    library = os.path.join(os.path.dirname(host.program), "libglint.a")
    run = subprocess.run(["cc", "-std=c99", *STRICT, "use.c", "whole.c", library, "-o", "use"], cwd=host.folder, capture_output=True,
                         text=True, check=False)
    host.equal("both are included", (run.returncode, run.stderr), (0, ""))
    host.equal("and are two", subprocess.run([host.path("use")], check=False).returncode, 0)
    for name in ("near.h", "far.h", "whole.c", "whole.h", "use.c", "use"):
        os.remove(host.path(name))


def test_camera(host):
    """The camera that is told sees what `render` frames; --fit centres the mesh and writes that camera."""
    for model, size, options in ((os.path.join(MODELS, "teapot.obj"), (320, 240), []), (os.path.join(MODELS, "spot.obj"), (128, 64), ["--scale", "7"]),
                                 ("box:0.05,0.02,3", (240, 240), ["--centre"])):
        panel = "%dx%d" % size
        told = report(host, model, "--panel", panel, *options)
        eye, at = (told["camera_" + name].replace(" ", ",") for name in ("eye", "at"))
        drawn = [host.render(model, "--size", panel, *options, *more) for more in ([], ["--eye", eye, "--at", at, "--near", told["camera_near"]])]
        off = sum(not near(a, b) for r, s in zip(drawn[0].rows, drawn[1].rows) for a, b in zip(r, s))
        left, top, right, bottom = drawn[1].box((0, 0, 0))
        host.check(f"{model}: all is seen", min(left, top, size[0] - 1 - right, size[1] - 1 - bottom) > 0 and off < 100, f"{off}")
        text = convert(host, model, "--panel", panel, *options, "--fit", "--name", "car")
        host.check(f"{model}: centred", re.search(r"\{(-?[01]), (-?[01]), (-?[01])\}, /\* offset \*/", text), text[-800:])
        numbers = [int(v) for v in re.findall(r"-?\d+", text.split("glint_camera car_camera = ")[1])]
        told = report(host, model, "--panel", panel, *options, "--fit")
        where = [float(v) * 65536 for v in told["camera_eye"].split()]
        host.check(f"{model}: the header has it", all(abs(a - b) <= 1 for a, b in zip(numbers[3:12:4], where)) and
                   numbers[12] == 45 * 65536 and abs(numbers[13] - float(told["camera_near"]) * 65536) <= 1, f"{numbers} {told}")
        compiles(host, text, "car_camera.near_plane == 0")
    _, header = pair(host, "fit", "torus:12x8", "--fit")
    host.check("a pair declares it", "\nextern const glint_camera fit_camera;" in header)
    host.refuses("none sees it", ["convert", "torus:12x8", "--scale", "16000", "--fit", "-o", "out.h"],
                 r"torus:12x8:0: --fit: no camera in Q16\.16 sees all of it: give --scale fit")
    for name in ("fit.c", "fit.h"):
        os.remove(host.path(name))
