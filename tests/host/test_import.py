# SPDX-License-Identifier: MIT
"""What glint-import reads by assimp, and whatever may go wrong with the program."""
import os
import re

import png
from harness import MODELS
from test_convert import convert
from test_formats import FACES, POINTS, check_solid, gltf, material, near, solid, told


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


def test_collada(host):
    host.write("t.dae", dae())
    check_solid(host, "t.dae", solid(host, "t.dae", name="green"))
    info = host.info("t.dae")
    host.equal("positions are joined", (info["positions"], info["boundary_edges"], info["materials"]), ("4", "0", "1"))
    text = convert(host, "t.dae", "--name", "t")
    host.check("Phong's kind as it stands", near(material(text, "diffuse", "green"), [.1, .6, .2]) and
               near(material(text, "specular", "green"), [.3] * 3) and near(material(text, "shininess", "green"), [20]))
    host.write("matt.dae", dae().replace("<float>20<", "<float>0<"))
    host.equal("an exponent of 0 is one", material(convert(host, "matt.dae", "--name", "t"), "shininess", "green"), [0])
    host.write("lit.dae", dae().replace("<library_geometries>", '<library_lights><light id="l"><technique_common><point><color>1 1 1</color>'
               "</point></technique_common></light></library_lights><library_geometries>").replace(
                   '<instance_geometry', '<instance_light url="#l"/><instance_geometry'))
    told(host, "lit.dae", r"lights are skipped \(1\)")
    host.write("up.dae", dae("Z_UP"))
    check_solid(host, "up.dae", solid(host, "up.dae", name="green"), lambda x, y, z: (x, z, -y))


def test_broken_animation(host):
    """Keys out of order move nothing that is drawn, so the mesh is read."""
    host.write("walk.x", "xof 0303txt 0032\nFrame Body {\nMesh M { 4; " + " ".join("%r;%r;%r;," % p for p in POINTS)[:-1] + ";\n4; " +
               " ".join("3;%d,%d,%d;," % f for f in FACES)[:-1] + "; }\n}\nAnimationSet Walk { Animation { { Body } AnimationKey { 2; 3; "
               "0;3;0.0,0.0,0.0;;, 20;3;1.0,0.0,0.0;;, 10;3;2.0,0.0,0.0;;; } } }\n")
    told(host, "walk.x", r"animations are skipped \(1\)")


def test_one_material_by_every_path(host):
    """What exporters write of one matt green looks the same from OBJ, glTF and Collada."""
    host.write("moss.mtl", "newmtl moss\nNs 0\nKa 1 1 1\nKd 0.2 0.5 0.2\nKs 0.5 0.5 0.5\nillum 2\n")
    host.write("m.obj", "mtllib moss.mtl\n" + "".join("v %r %r %r\n" % p for p in POINTS) + "usemtl moss\n" +
               "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in FACES))
    host.write("m.gltf", gltf(primitive={"material": 0}, materials=[{"pbrMetallicRoughness": {
        "baseColorFactor": [.2, .5, .2, 1], "metallicFactor": 0, "roughnessFactor": 1}}]))
    host.write("m.dae", dae().replace("0.1 0.6 0.2 1", "0.2 0.5 0.2 1").replace("0.3 0.3 0.3 1", "0.5 0.5 0.5 1").replace("<float>20<", "<float>0<"))
    rows = [host.render(name, "--flat").rows for name in ("m.obj", "m.gltf", "m.dae")]
    for name, other in zip(("m.gltf", "m.dae"), rows[1:]):
        most = max(abs(int(a) - int(b)) for p, q in zip(rows[0], other) for s, t in zip(p, q) for a, b in zip(s, t))
        host.check(f"{name} as m.obj", most <= 8, f"{most} levels")


def test_against_our_own_reader(host):
    """assimp reads OBJ too: what it reads, and what we do, is drawn and converted alike."""
    program = os.path.join(os.path.dirname(host.program), "glint-import")
    for name, options in (("spot", ["--smooth"]), ("featuretype", [])):  # assimp knows no smoothing groups
        source = os.path.join(MODELS, name + ".obj")
        host.write("other.sh", f"#!/bin/sh\nexec {program} {source}\n")
        os.chmod(host.path("other.sh"), 0o755)
        host.write(name + ".xyz", "")
        env = {"GLINT_IMPORT": host.path("other.sh")}
        runs = [host.run("info", source, "--weld", "0", *options), host.run("info", name + ".xyz", *options, env=env)]
        # assimp knows no groups, and has positions as floats: a step here and there.
        skipped = re.compile("groups|positions_welded|positions |largest_|clusters|flash|Bytes of flash|--|all|instr|ms_|\\d+x")
        lines = [[line for line in run.stdout.splitlines() if not skipped.match(line)] for run in runs]
        host.equal(f"{name}: info", lines[1], lines[0])
        run = host.run("render", name + ".xyz", "-o", "other.png", *options, env=env)
        images = host.render(source, *options), png.decode(host.read("other.png"))
        count = sum(s != t for p, q in zip(*(i.rows for i in images)) for s, t in zip(p, q))
        host.check(f"{name}: picture", run.stderr == "" and count < 100, f"{count} {run.stderr}")
        os.remove(host.path("other.png"))


def test_broken_files(host):
    """Each is refused in one line, fast, and without a file."""
    for name, content in [("cut.dae", dae()[:900]), ("words.txt", "hello world\n"), ("none.fbx", b"\0" * 100), ("a.3ds", b"\x4d\x4d\xff\xff\xff\xff")]:
        host.write(name, content)
        host.refuses(f"{name} is broken", ["convert", name, "-o", "out.h"], re.escape(name) + r":0: cannot be imported: .{3,170}")


def test_the_program_misbehaves(host):
    """Whatever it does comes to one line, and nothing is left of it."""
    host.write("t.dae", dae())
    solid_text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    for what, script, pattern, options in [
            ("hangs", "exec sleep 60", r"takes longer than 1 s", ["--import-seconds", "1"]),
            ("hangs, and is silent", "exec sleep 60 >&- 2>&-", r"takes longer than 1 s", ["--import-seconds", "1"]),
            ("crashes", "kill -SEGV $$", r"crashed by signal 11, with 2048 MB of memory", []),
            ("is killed", "kill -KILL $$", r"takes longer than 60 s, or more memory than there is", []),
            ("eats memory", "exec python3 -c 'b = bytearray(1 << 30)'", r"Traceback .*", ["--import-memory", "500"]),
            ("writes files", "echo more >> t.dae; exec cat t.dae", r"crashed by signal 25, with 2048 MB of memory", []),
            ("prints without end", "exec yes", r"comes to more than 500 MB", []),
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
        host.refuses(f"a program that {what}", ["convert", "t.dae", *options, "-o", "out.h"],
                     rf"t\.dae:0: cannot be imported: {pattern}", env={"GLINT_IMPORT": host.path("fake")})
    host.equal("the model is as it was", host.read("t.dae").decode(), dae())
    host.write("fake", f"#!/bin/sh\nprintf '# mesh\n{solid_text}# end\n'\n")
    run = host.run("info", "t.dae", env={"GLINT_IMPORT": host.path("fake")})
    host.check("a program that does well", run.returncode == 0 and "\ntriangles 1\n" in run.stdout, run.stderr)
    os.chmod(host.path("fake"), 0o644)
    host.refuses("no program", ["info", "t.dae"], r"t\.dae:0: only OBJ, STL, PLY, OFF and glTF are read: for others install "
                 r"libassimp-dev, and run make host again", env={"GLINT_IMPORT": host.path("fake")})
    host.equal("OBJ without it", host.run("info", os.path.join(MODELS, "spot.obj"), env={"GLINT_IMPORT": "/none/x"}).returncode, 0)
    for option, value, takes in [("--import-seconds", "0", "seconds from 1 to 86400"), ("--import-memory", "x", "MB from 1 to 1048576")]:
        host.refuses(f"{option} {value}", ["info", "t.dae", option, value], rf"glint: {option} {value}: takes {takes}")
