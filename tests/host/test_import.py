# SPDX-License-Identifier: MIT
"""Formats that glint-import reads: the same mesh from each, materials, and whatever may go wrong with the program."""
import base64
import json
import os
import re
import struct

import png
from harness import MODELS
from test_convert import convert, mesh

# A lopsided solid, wound counter-clockwise from outside, as every format below has it.
POINTS = [(-.7, -.5, -.4), (.8, -.5, -.3), (.1, .9, .2), (.3, -.4, .9)]
FACES = [(0, 2, 1), (1, 2, 3), (2, 0, 3), (0, 1, 3)]


def stl_text():
    return "solid t\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % POINTS[i] for i in f) + "endloop\nendfacet\n"
        for f in FACES) + "endsolid t\n"


def stl_binary():
    return b" " * 80 + struct.pack("<I", len(FACES)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *POINTS[f[0]], *POINTS[f[1]], *POINTS[f[2]], 0) for f in FACES)


def ply(colours=True):
    head = "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")) if colours else ""
    return ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + head +
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n" +
            "".join("%r %r %r" % p + (f" 255 {51 * i} 0\n" if colours else "\n") for i, p in enumerate(POINTS)) +
            "".join("3 %d %d %d\n" % f for f in FACES))


def gltf(nodes=None, count=12, uri=None, **material):
    data = b"".join(struct.pack("<3f", *p) for p in POINTS) + b"".join(struct.pack("<3H", *f) for f in FACES)
    uri = uri or "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes or [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
            "materials": [{"name": "paint", **material}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-.7, -.5, -.4],
                           "max": [.8, .9, .9]}, {"bufferView": 1, "componentType": 5123, "count": count, "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
            "buffers": [{"byteLength": len(data), "uri": uri}]}


def glb(document):
    """The binary form, with the buffer in its second chunk."""
    data = base64.b64decode(document["buffers"][0].pop("uri").partition(",")[2])
    text = json.dumps(document).encode()
    chunks = b"".join(struct.pack("<I4s", len(c), kind) + c for c, kind in
                      [(text + b" " * (-len(text) % 4), b"JSON"), (data + b"\0" * (-len(data) % 4), b"BIN\0")])
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def dae(up="Y_UP"):
    points, faces = (" ".join(" ".join(map(repr, t)) for t in s) for s in (POINTS, FACES))
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>{up}</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="common"><phong>
<diffuse><color>0.1 0.6 0.2 1</color></diffuse><specular><color>0.3 0.3 0.3 1</color></specular>
<shininess><float>20</float></shininess></phong></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="green"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">{points}</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="s" count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>{faces}</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="w"><node id="n"><instance_geometry url="#g">
<bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>
"""


def off():
    return "OFF\n4 4 0\n" + "".join("%r %r %r\n" % p for p in POINTS) + "".join("3 %d %d %d\n" % f for f in FACES)


def solid(host, file, *options, name=None, warning=""):
    """The triangles of a converted model: three positions each, from the smallest on; so windings can be compared."""
    text = convert(host, file, "--no-clusters", *options, "--name", "t", warning=warning)
    text = text.replace(f"t_mesh_{name} =", "t_mesh =").replace(f"_{name}[", "[") if name else text
    positions, _, triangles, _, _ = mesh(text, "t")
    turned = []
    for triangle in triangles:
        corners = [positions[i] for i in triangle]
        first = corners.index(min(corners))
        turned.append(tuple(corners[first:] + corners[:first]))
    return sorted(turned)


def check_solid(host, what, got, change=lambda *p: p, mirrored=False):
    wanted = []
    for face in FACES:
        corners = [change(*POINTS[i]) for i in (face[::-1] if mirrored else face)]
        first = corners.index(min(corners))
        wanted.append(tuple(corners[first:] + corners[:first]))
    off_by = [max(abs(a - b) for p, q in zip(s, t) for a, b in zip(p, q)) for s, t in zip(got, sorted(wanted))]
    host.check(f"{what} has the triangles", len(got) == len(FACES) and max(off_by) < 1e-3, f"{off_by} {got}")


def test_the_same_mesh_from_each_format(host):
    for name, content, material in [
            ("text.stl", stl_text(), None), ("binary.STL", stl_binary(), None), ("colours.ply", ply(), None),
            ("plain.ply", ply(False), None), ("t.gltf", json.dumps(gltf()), "paint"), ("t.glb", glb(gltf()), "paint"),
            ("t.dae", dae(), "green"), ("t.off", off(), None)]:
        host.write(name, content)
        check_solid(host, name, solid(host, name, name=material))
        info = host.info(name)
        host.equal(f"{name}: positions are joined", (info["positions"], info["boundary_edges"], info["materials"]),
                   ("4", "0", "1" if material else "0"))
        host.equal(f"{name}: colours", info["colours"], "given" if name.startswith("colours") else "none")
    host.write("up.dae", dae("Z_UP"))
    check_solid(host, "up.dae", solid(host, "up.dae", name="green"), lambda x, y, z: (x, z, -y))


def test_nodes(host):
    nodes = [{"children": [1], "translation": [1, 2, 3]}, {"children": [2], "scale": [-2, 1, 1]}, {"mesh": 0, "scale": [1, 3, 1]}]
    host.write("nodes.gltf", json.dumps(gltf(nodes)))
    check_solid(host, "a mirrored node", solid(host, "nodes.gltf", name="paint"), lambda x, y, z: (1 - 2 * x, 2 + 3 * y, 3 + z), True)
    info = host.info("nodes.gltf")
    host.equal("it faces outwards", info["inward_parts"], "0")
    nodes = [{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}]
    host.write("twice.gltf", json.dumps(gltf(nodes)))
    info = host.info("twice.gltf")
    host.equal("a mesh of two nodes", (info["triangles"], info["parts"], info["highest"]), ("8", "2", "5.8 0.9 0.9"))


def colour(text, material, what):
    body = re.search(r"glint_material t_material_" + material + r" = \{(.*?)\n\};", text, re.DOTALL).group(1)
    found = re.search(r"\{([^{}]*)\}, /\* " + what, body) or re.search(r"(\d+), /\* " + what, body)
    return [int(v) / 65536 for v in found.group(1).split(",")]


def near(got, wanted):
    return len(got) == len(wanted) and all(abs(a - b) <= 1e-4 * max(1, abs(b)) for a, b in zip(got, wanted))


def physical(base, metal, rough):
    """The formulas of docs/assets.md."""
    alpha = rough ** 2
    shininess = min(max(2 / alpha ** 2 - 2, 1), 1024) if alpha else 1024
    kd = [b * (1 - metal * (1 - alpha)) for b in base]
    ks = [(.04 * (1 - metal) + b * metal) * (shininess + 2) / 8 * (1 - alpha) for b in base]
    return kd, [k / max(1, *ks) for k in ks], [shininess]


def test_physical_materials(host):
    for base, metal, rough in [((.8, .2, .1), 0, .5), ((1, .77, .34), 1, .3), ((.5, .5, .5), .5, .8), ((.9, .9, .9), 0, 0),
                               ((.2, .4, .6), 1, 1)]:
        host.write("t.gltf", json.dumps(gltf(pbrMetallicRoughness={
            "baseColorFactor": [*base, 1], "metallicFactor": metal, "roughnessFactor": rough}, emissiveFactor=[0, .25, 0])))
        text = convert(host, "t.gltf", "--name", "t")
        got = [colour(text, "paint", what) for what in ("diffuse", "specular", "shininess")]
        host.check(f"base {base}, metal {metal}, roughness {rough}", all(map(near, got, physical(base, metal, rough))), str(got))
        kd = got[0]
        host.check("what it emits", near(colour(text, "paint", "ambient"), [.1 * kd[0], .1 * kd[1] + .25, .1 * kd[2]]))
    host.write("unlit.gltf", json.dumps({**gltf(extensions={"KHR_materials_unlit": {}}), "extensionsUsed": ["KHR_materials_unlit"]}))
    host.check("unlit", "&glint_model_unlit," in convert(host, "unlit.gltf"))
    host.write("t.dae", dae())
    text = convert(host, "t.dae", "--name", "t")
    host.check("Phong's kind as it stands", near(colour(text, "green", "diffuse"), [.1, .6, .2]) and
               near(colour(text, "green", "specular"), [.3] * 3) and near(colour(text, "green", "shininess"), [20]))


def test_what_is_not_followed(host):
    document = gltf(pbrMetallicRoughness={"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 1, 1, .5]}, alphaMode="BLEND")
    document |= {"textures": [{"source": 0}], "images": [{"uri": "no.png"}]}
    host.write("t.gltf", json.dumps(document))
    run = host.run("info", "t.gltf")
    host.equal("textures and transparency", (run.returncode, sorted(run.stderr.splitlines())),
               (0, ["t.gltf:0: warning: 'd' is skipped: transparency is not drawn",
                    "t.gltf:0: warning: 'map_Kd' is skipped: textures are not drawn"]))
    document = gltf()
    document["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "mode": 0})
    host.write("t.gltf", json.dumps(document))
    run = host.run("info", "t.gltf")
    host.equal("points", (run.returncode, run.stderr),
               (0, "t.gltf:0: warning: 'p' is skipped: only faces are drawn (and 3 more)\n"))
    document["materials"] = [{"name": "two\n words # and \\"}, {"name": "two\n words # and \\"}, {}]
    document["meshes"][0]["primitives"] = [{"attributes": {"POSITION": 0}, "indices": 1, "material": i} for i in range(3)]
    host.write("t.gltf", json.dumps(document))
    names = re.findall(r"glint_material t_material_(\w+) =", convert(host, "t.gltf", "--name", "t"))
    host.equal("names that an MTL file could not have, or not twice", names, ["two__words___and__", "two__words___and___1", "_2"])


def test_colours(host):
    host.write("colours.ply", ply())
    text = convert(host, "colours.ply", "--name", "t", "--no-clusters")
    got = re.search(r"t_colours\[4\]\[3\] = \{(.*?)\n\};", text, re.DOTALL).group(1).replace(" ", "").strip()
    host.equal("colours of PLY", got, "{255,0,0},{255,51,0},{255,102,0},{255,153,0},")


def test_against_our_own_reader(host):
    """assimp reads OBJ too: what it reads, and what we do, is drawn and converted alike."""
    program = os.path.join(os.path.dirname(host.program), "glint-import")
    for name in ("spot", "featuretype"):
        source = os.path.join(MODELS, name + ".obj")
        host.write("other.sh", f"#!/bin/sh\nexec {program} {source}\n")
        os.chmod(host.path("other.sh"), 0o755)
        host.write(name + ".xyz", "")
        env = {"GLINT_IMPORT": host.path("other.sh")}
        runs = [host.run("info", source, "--weld", "0"), host.run("info", name + ".xyz", env=env)]
        # assimp knows no groups, and has positions as floats: a step here and there.
        skipped = re.compile("groups|positions_welded|positions |largest_|clusters|flash|Bytes of flash|--|all|instr|ms_|\\d+x")
        lines = [[line for line in run.stdout.splitlines() if not skipped.match(line)] for run in runs]
        host.equal(f"{name}: info", lines[1], lines[0])
        run = host.run("render", name + ".xyz", "-o", "other.png", env=env)
        images = host.render(source), png.decode(host.read("other.png"))
        count = sum(s != t for p, q in zip(*(i.rows for i in images)) for s, t in zip(p, q))
        host.check(f"{name}: picture", run.stderr == "" and count < 100, f"{count} {run.stderr}")
        os.remove(host.path("other.png"))


def test_broken_files(host):
    """Each is refused in one line, fast, and without a file."""
    stl = stl_binary()
    os.mkdir(host.path("in"))
    host.write("buffer.bin", base64.b64decode(gltf()["buffers"][0]["uri"].partition(",")[2]))
    for name, content in [
            ("cut.stl", stl[:-40]), ("count.stl", stl[:80] + b"\xff\xff\xff\x7f" + stl[84:]), ("empty.stl", ""),
            ("count.ply", ply().replace("vertex 4", "vertex 4000000000")), ("index.ply", ply().replace("3 0 2 1", "3 0 2 99")),
            ("nan.ply", ply().replace("-0.7", "nan")), ("cut.gltf", json.dumps(gltf())[:700]), ("empty.glb", ""),
            ("count.gltf", json.dumps(gltf(count=4000000000))), ("cut.dae", dae()[:900]), ("cut.glb", glb(gltf())[:-30]),
            ("in/up.gltf", json.dumps(gltf(uri="../buffer.bin"))), ("in/none.gltf", json.dumps(gltf(uri="none.bin"))),
            ("words.txt", "hello world\n"), ("none.fbx", b"\0" * 100), ("a.3ds", b"\x4d\x4d\xff\xff\xff\xff")]:
        host.write(name, content)
        host.refuses(f"{name} is broken", ["convert", name, "-o", "out.h"], re.escape(name) + r":0: cannot be imported: .{3,170}")
    host.write("in/buffer.bin", host.read("buffer.bin"))
    host.write("in/down.gltf", json.dumps(gltf(uri="buffer.bin")))
    check_solid(host, "a buffer beside it", solid(host, "in/down.gltf", name="paint"))
    host.refuses("a file that is not there", ["info", "none.stl"], r"none\.stl:0: cannot be opened: No such file or directory")


def test_the_program_misbehaves(host):
    """Whatever it does comes to one line, and nothing is left of it."""
    host.write("t.stl", stl_text())
    solid_text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    for what, script, pattern, options in [
            ("hangs", "exec sleep 60", r"takes longer than 1 s", ["--import-seconds", "1"]),
            ("hangs, and is silent", "exec sleep 60 >&- 2>&-", r"takes longer than 1 s", ["--import-seconds", "1"]),
            ("crashes", "kill -SEGV $$", r"crashed by signal 11, with 2048 MB of memory", []),
            ("is killed", "kill -KILL $$", r"takes longer than 60 s, or more memory than there is", []),
            ("eats memory", "exec python3 -c 'b = bytearray(1 << 30)'", r"Traceback .*", ["--import-memory", "500"]),
            ("writes files", "echo more >> t.stl; exec cat t.stl", r"crashed by signal 25, with 2048 MB of memory", []),
            ("prints without end", "exec yes", r"comes to more than 500 MB of text", []),
            ("prints nothing", "exit 0", r"the program gave no whole mesh", []),
            ("fails without a word", "exit 3", r"failed without a word", []),
            ("fails with words", "printf 'a\\001b\\nsecond' >&2; exit 3", r"a\?b", []),
            ("fails with many words", "yes x | head -c 99999 | tr '\\n' ' ' >&2; exit 3", r"(x ){80}", []),
            ("prints garbage", "head -c 9999 /dev/urandom", r"the program gave no whole mesh", []),
            ("prints half", f"printf '# mesh\n{solid_text}'", r"the program gave no whole mesh", []),
            ("prints no faces", "printf '# mesh\nv 0 0 0\n# end\n'", r"no faces", []),
            ("prints a wrong index", f"printf '# mesh\n{solid_text}f 1 2 4\n# end\n'", r"position index 4 is out of range: 3 so far", []),
            ("is no program", None, r"(could not be run|.*: .*)", [])]:
        host.write("fake", f"#!/bin/sh\n{script}\n" if script else b"\x7fELFnone")
        os.chmod(host.path("fake"), 0o755)
        host.refuses(f"a program that {what}", ["convert", "t.stl", *options, "-o", "out.h"],
                     rf"t\.stl:0: cannot be imported: {pattern}", env={"GLINT_IMPORT": host.path("fake")})
    host.equal("the model is as it was", host.read("t.stl").decode(), stl_text())
    host.write("fake", f"#!/bin/sh\nprintf '# mesh\n{solid_text}# end\n'\n")
    run = host.run("info", "t.stl", env={"GLINT_IMPORT": host.path("fake")})
    host.check("a program that does well", run.returncode == 0 and "\ntriangles 1\n" in run.stdout, run.stderr)
    os.chmod(host.path("fake"), 0o644)
    host.refuses("no program", ["info", "t.stl"], r"t\.stl:0: only OBJ files are read: for others install libassimp-dev, and run "
                 r"make host again", env={"GLINT_IMPORT": host.path("fake")})
    host.equal("OBJ without it", host.run("info", os.path.join(MODELS, "spot.obj"), env={"GLINT_IMPORT": "/none/x"}).returncode, 0)
    for option, value, takes in [("--import-seconds", "0", "seconds from 1 to 86400"), ("--import-memory", "x", "MB from 1 to 1048576")]:
        host.refuses(f"{option} {value}", ["info", "t.stl", option, value], rf"glint: {option} {value}: takes {takes}")
