# SPDX-License-Identifier: MIT
"""Pictures of JPEG, which glint-import decodes: from each format of models, and whatever may be wrong with them."""
import base64
import math
import os
import struct
import subprocess

from harness import ROOT
from test_formats import gltf
from test_textures import COORDINATES, MODEL, PAINT, SQUARE, VIEW, mean_square, picture, texels, write

SIDE = 16
SOURCES = os.path.join(ROOT, "port", "host", "import")


def blend(x, y):
    """No turn or mirror image is alike. `cjpeg -quality 95 -sample 1x1` made baseline.jpg (with -optimize) and progressive.jpg of it."""
    return 255 if x >= 12 and y < 4 else 16 * x, 16 * y, 255 if x < 4 else 40


def load(name):
    with open(os.path.join(ROOT, "tests", "host", name + ".jpg"), "rb") as file:
        return file.read()


def segment(marker, data):
    return b"\xff" + bytes([marker]) + struct.pack(">H", len(data) + 2) + data


def head(width, height, components):
    """A file of one scan, up to its first pixels; all quantisation steps are 1, and each code is one of a single bit, for 0."""
    frame = b"".join(bytes([i + 1, 0x11, 0]) for i in range(components))
    scan = b"".join(bytes([i + 1, 0]) for i in range(components))
    codes = bytes([1] + 15 * [0] + [0])
    return (b"\xff\xd8" + segment(0xdb, bytes([0] + 64 * [1])) +
            segment(0xc0, struct.pack(">BHHB", 8, height, width, components) + frame) +
            segment(0xc4, b"\0" + codes) + segment(0xc4, b"\x10" + codes) +
            segment(0xda, bytes([components]) + scan + b"\0\x3f\0"))


def expected_error(data):
    """
    The mean square error of a decoded picture: quantisation of a step q adds q^2 / 12 to a coefficient's, and an
    orthonormal transform keeps sums of squares. Red is Y + 1.402 Cr, green Y - .344 Cb - .714 Cr, blue Y + 1.772 Cb.
    Rounding of Y, Cb and Cr when they are made, and of levels, adds steps of 1.
    """
    steps, at = {}, 2
    while data[at + 1] != 0xda:
        length = struct.unpack(">H", data[at + 2:at + 4])[0]
        if data[at + 1] == 0xdb:
            for start in range(at + 4, at + 2 + length, 65):
                steps[data[start]] = data[start + 1:start + 65]
        at += 2 + length
    luma, chroma = (sum(q * q for q in steps[i]) / 64 / 12 + 2 / 12 for i in (0, 1))
    return luma + chroma * (1.402 ** 2 + .344 ** 2 + .714 ** 2 + 1.772 ** 2) / 3 + 1 / 12


def test_colours(host):
    """As exact as quality 95 is, which is less than half of the difference between neighbours; both kinds are alike, bit for bit."""
    write(host, picture(blend, SIDE, SIDE))
    options = ["--texture-type", "rgb565"]
    wanted = texels(host, *options, side=SIDE)
    write(host, load("baseline"))  # whatever its name says
    got = texels(host, *options, side=SIDE)
    baseline = host.render_bytes("t.obj", *VIEW)
    error = mean_square(sum(got, []), sum(wanted, []))
    rounded = 2 * ((255 / 31) ** 2 * 2 + (255 / 63) ** 2) / 3 / 12  # both pictures are drawn from RGB565
    most = expected_error(load("baseline")) + rounded
    host.check("the mean square error", 0 < error <= most and math.sqrt(most) < 8, f"{error}, not {most}")
    host.check("each level", all(abs(a - b) <= 16 for rows in zip(got, wanted) for pair in zip(*rows) for a, b in zip(*pair)))
    write(host, load("progressive"))
    host.equal("progressive", host.render_bytes("t.obj", *VIEW), baseline)
    start = load("baseline").index(b"\xff\xdb")
    write(host, load("baseline")[:start] + b"\0\0\0" + load("baseline")[start:])
    host.equal("bytes between segments", host.render_bytes("t.obj", *VIEW), baseline)
    write(host, head(8, 8, 1) + b"\x3f\xff\xd9")  # codes for no difference, and for no more coefficients: 128
    host.equal("grey", texels(host, *options), [[(132, 130, 132)] * 8] * 8)  # as RGB565 has it


def test_from_each_format(host):
    data = load("baseline")
    view = [*VIEW, "--model", "unlit"]
    write(host, data, PAINT.replace("picture.png", "picture.jpg"))
    host.write("picture.jpg", data)
    plain = host.render_bytes("t.obj", *view)
    host.write("bare.obj", SQUARE + COORDINATES + "f 1/1 2/2 3/3 4/4\n")
    host.equal("--texture", host.render_bytes("bare.obj", *view, "--texture", "picture.jpg"), plain)
    host.check("--texture of a shape", host.info("box", "--texture", "picture.jpg")["materials"] == "1")
    points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    host.write("t.ply", "ply\nformat ascii 1.0\ncomment TextureFile picture.jpg\nelement vertex 4\n" +
               "".join(f"property float {p}\n" for p in "xyzst") + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
               "".join(f"{x} {y} {z} {(x + 1) // 2} {(y + 1) // 2}\n" for x, y, z in points) + "4 0 1 2 3\n")
    host.equal("PLY", host.render_bytes("t.ply", *view), plain)

    def document(image, **more):
        return gltf({"POSITION": ("f", points), "TEXCOORD_0": ("f", [(0, 1), (1, 1), (1, 0), (0, 0)])}, (0, 1, 2, 0, 2, 3),
                    primitive={"material": 0}, materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
                    textures=[{"source": 0}], images=[image], **more)
    for name, text in [("a file", document({"uri": "picture.jpg"})),
                       ("a data URI", document({"uri": "data:image/jpeg;base64," + base64.b64encode(data).decode()})),
                       ("a view", document({"bufferView": "accessor_p", "mimeType": "image/jpeg"}, accessor_p=("B", list(data))))]:
        host.write("t.gltf", text)
        host.equal(f"glTF: {name}", host.render_bytes("t.gltf", *view), plain)


def test_bad_files(host):
    """The model is drawn without the picture, and one line says why, whatever its bytes are."""
    good, grown = load("baseline"), load("progressive")
    frame = good.index(b"\xff\xc0") + 5
    write(host, good, PAINT.replace("map_Kd picture.png\n", ""))
    bare = host.render_bytes("t.obj", *VIEW)
    cases = [(f"cut at {at}", data[:at], None) for data in (good, grown) for at in range(3, len(data) - 2, 31)]
    cases += [
        ("without an end", good[:-2], "Premature end of JPEG file"),
        ("fewer pixels than it says", good[:frame] + struct.pack(">2H", 4096, 4096) + good[frame + 4:],
         "Corrupt JPEG data: premature end of data segment"),
        ("progressive, with fewer", grown.replace(struct.pack(">B2H", 8, SIDE, SIDE), struct.pack(">B2H", 8, 4096, 4096)),
         "Corrupt JPEG data: premature end of data segment"),
        ("of 65535x65535", good[:frame] + b"\xff\xff\xff\xff" + good[frame + 4:], "it has 65535x65535 pixels: at most 4096x4096 are read"),
        ("too wide", good[:frame] + struct.pack(">2H", 1, 4097) + good[frame + 4:], "it has 4097x1 pixels: at most 4096x4096 are read"),
        ("of no size", good[:frame] + bytes(4) + good[frame + 4:], None),
        ("of print", head(8, 8, 4), "its colours are those of print (CMYK): save it as RGB"),
        ("of 12 bits", good[:frame - 1] + b"\x0c" + good[frame:], "Unsupported JPEG data precision 12"),
        ("of text behind its first bytes", b"\xff\xd8\xffhello", None),
        ("a PNG file behind its first bytes", b"\xff\xd8\xff" + picture(blend, SIDE, SIDE), None),
        ("large", b"\xff\xd8\xff" + bytes(1 << 20), None)]
    for name, data, why in cases:
        host.write("picture.png", data)
        run = host.run("render", "t.obj", *VIEW, "-o", "out.png")
        host.equal(f"{name}: no warning without a picture", (run.returncode, run.stderr), (0, ""))
        host.write("t.mtl", PAINT)
        run = host.run("render", "t.obj", *VIEW, "-o", "out.png")
        start = "t.mtl:4: warning: the texture 'picture.png' is not drawn: cannot be imported: "
        told = run.stderr.startswith(start) and run.stderr.count("\n") == 1 and (why is None or run.stderr == start + why + "\n")
        host.check(f"{name} is told", run.returncode == 0 and told and len(run.stderr) > len(start) + 10, run.stderr)
        host.equal(f"{name} is drawn without", host.read("out.png"), bare)
        host.write("t.mtl", PAINT.replace("map_Kd picture.png\n", ""))
    host.write("picture.jpg", good[:-2])
    host.refuses("--texture, cut", ["info", "t.obj", "--texture", "picture.jpg"],
                 r"t\.obj:0: --texture picture\.jpg: cannot be imported: Premature end of JPEG file")


def test_the_program(host):
    """What is to be installed where it is missing or without JPEG; whatever it does comes to one line."""
    write(host, load("baseline") + bytes(1 << 20))  # more than a pipe holds
    small = struct.pack(">2H", 2, 1)
    with open(host.path("main.c"), "w", encoding="ascii") as file:
        file.write('#include "import.h"\n#include <stdio.h>\nint main(void) { fprintf(stderr, "%s\\n", jpeg_print()); return 1; }\n')
    subprocess.run(["cc", "-std=c99", "-I" + SOURCES, host.path("main.c"), os.path.join(SOURCES, "jpeg.c"), "-o", host.path("without")], check=True)
    for what, script, why, options in [
            ("missing", None, "JPEG is read by glint-import: install libassimp-dev and libjpeg-dev, and run make host again", []),
            ("built without JPEG", "exec ./without", "cannot be imported: glint-import was built without JPEG: install libjpeg-dev, and run "
             "make host again", []),
            ("hangs", "exec sleep 60", "cannot be imported: takes longer than 1 s", ["--import-seconds", "1"]),
            ("crashes", "kill -SEGV $$", "cannot be imported: crashed by signal 11, with 2048 MB of memory", []),
            ("prints without end", "exec yes", "cannot be imported: comes to more than 50 MB", []),
            *[(f"prints {len(data)} bytes", "printf '" + "".join(f"\\{byte:03o}" for byte in data) + "'",
               "cannot be imported: the program gave no whole picture", [])
              for data in (b"", b"\0\1", small, small + b"123", small + b"12345", small + b"1234567", bytes(4), b"\0\1\0\0")],
            ("prints a picture that is too wide", "printf '\\020\\001\\000\\001'; head -c 12291 /dev/zero",
             "cannot be imported: the program gave no whole picture", [])]:
        host.write("fake", f"#!/bin/sh\n{script}\n")
        os.chmod(host.path("fake"), 0o755)
        run = host.run("info", "t.obj", *options, env={"GLINT_IMPORT": host.path("fake") if script else "/none/glint-import"})
        host.equal(f"a program that is or does: {what}", (run.returncode, run.stderr),
                   (0, f"t.mtl:4: warning: the texture 'picture.png' is not drawn: {why}\n"))
    host.write("fake", "#!/bin/sh\nprintf '\\000\\002\\000\\001\\377\\000\\000\\000\\377\\000'\n")
    run = host.run("info", "t.obj", env={"GLINT_IMPORT": host.path("fake")})
    host.check("a program that does well", run.stderr == "" and "texture 2x1 " in run.stdout, run.stdout + run.stderr)
    program = os.path.join(os.path.dirname(host.program), "glint-import")
    host.write("limited", f"#!/bin/sh\nulimit -v 60000\nexec {program} --jpeg\n")
    os.chmod(host.path("limited"), 0o755)
    host.write("picture.png", load("progressive").replace(struct.pack(">B2H", 8, SIDE, SIDE), struct.pack(">B2H", 8, 4096, 4096)))
    run = host.run("info", "t.obj", env={"GLINT_IMPORT": host.path("limited")})
    host.check("less memory than a picture needs is told", run.returncode == 0 and "is not drawn: cannot be imported: " in run.stderr, run.stderr)
