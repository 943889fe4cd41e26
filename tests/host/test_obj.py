# SPDX-License-Identifier: MIT
"""The OBJ reader through `render` and `info`: what is read, and how."""
import math
import os

from harness import MODELS, SQUARE, SQUARE_VIEW, torus_text
from test_convert import convert, mesh
from test_shapes import cross, minus

BLACK = (0, 0, 0)

# A cube: position 1 + x + 2 y + 4 z, six quads seen counter-clockwise from outside.
CUBE_V = "".join(f"v {2 * x - 1} {2 * y - 1} {2 * z - 1}\n" for z in (0, 1) for y in (0, 1) for x in (0, 1))
CUBE_F = "f 5 6 8 7\nf 2 1 3 4\nf 6 2 4 8\nf 1 5 7 3\nf 7 8 4 3\nf 1 2 6 5\n"
CUBE_VIEW = ["--eye", "2,3,4", "--size", "96x96"]


def test_same_model_written_differently(host):
    host.write("plain.obj", CUBE_V + CUBE_F)
    plain = host.render_bytes("plain.obj", *CUBE_VIEW)
    lines = (CUBE_V + CUBE_F).splitlines()
    negative = [line if line[0] != "f" else "f " + " ".join(str(int(i) - 9) for i in line[2:].split()) for line in lines]
    triangles = [line for line in lines if line[0] == "v"]
    for line in lines:
        if line[0] == "f":
            a, b, c, d = line[2:].split()
            triangles += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    textured = ["vt 0.5", "vt 0 1", "vt 0 1 0"] + [line if line[0] != "f" else
                                                  "f " + " ".join(f"{i}/{1 + int(i) % 3}" for i in line[2:].split())
                                                  for line in lines]
    others = {
        "CRLF": "\r\n".join(lines) + "\r\n", "CR": "\r".join(lines) + "\r", "no final newline": "\n".join(lines),
        "byte order mark": b"\xef\xbb\xbf" + "\n".join(lines).encode(),
        "comments": "# glint\n" + " # v 9\n".join(lines) + " #\n#", "blank lines": "\n\n \t\n" + "\n\n".join(lines),
        "blanks": "\n".join("\t " + line.replace(" ", " \t ") + "  " for line in lines),
        "continued lines, blanks at their ends": "\n".join(line.replace(" ", " \\ \t\n", 2) for line in lines),
        "continued lines": "\n".join(line.replace(" ", " \\\n", 2).replace("\n1 ", "\n1\\\r\n ") for line in lines),
        "negative indices": "\n".join(negative), "triangles": "\n".join(triangles), "v/t": "\n".join(textured),
        "groups": "o box\ng a b\ns off\n" + "\n".join(lines) + "\ng\nvp 1 2\nend\n",
        "weights": "\n".join(line + " 1" if line[0] == "v" else line for line in lines),
        "white": "\n".join(line + " 1 1 1" if line[0] == "v" else line for line in lines),
        "weights and white": "\n".join(line + " 2 1 1.0 1" if line[0] == "v" else line for line in lines),
        "other spellings": "\n".join(lines).replace(" 1", " +1.0e0", 1).replace(" -1", " -.1E+1", 1),
        "fo, as f once was": "\n".join(lines).replace("f ", "fo "),
        "unused positions": "\n".join(lines) + "\nv 100 200 300\n",
    }
    for name, text in others.items():
        host.write("other.obj", text)
        host.equal(f"OBJ: {name}", host.render_bytes("other.obj", *CUBE_VIEW), plain)


# What is warned of at which line, for each of these before or in place of lines of CUBE_V + CUBE_F.
UNREAD = "cannot be read: its materials are missing"
UNKNOWN = "is not among the materials: the default one stands"
TEXTURES = "is skipped: of textures only map_Kd is drawn"
ELEMENTS = "is skipped: only faces are drawn"
WORDS = "is skipped: it is not an OBJ keyword"
EMPTY = "has an empty index: taken as not given"
BYTES = "has a colour above 1: all colours are taken as 0 to 255"
FEW = "is skipped: it has fewer than 3 corners"
NO_NORMAL = "does not have 3 finite numbers: taken as not given"
NO_TEXTURE = "does not have 1 to 3 finite numbers: taken as 0 0"
NORMAL_INDEX = "has a normal index that is none before it: taken as not given"
TEXTURE_INDEX = "has a texture index that is none before it: taken as not given"
ZBRUSH = "is skipped: colours in ZBrush's comments are not read"
SMOOTHING = "is skipped: a smoothing group is a number or off"
BARE = "has no colour, as others have: no colour is kept"


def warned(host, name, text, wanted, plain):
    """The picture is that of a file without what is warned of; warnings are the same of every command, each on a line."""
    lines = "".join(f"warned.obj:{line}: warning: {warning}\n" for line, warning in wanted)
    host.write("warned.obj", text)
    for command, *rest in (("render", *CUBE_VIEW, "-o", "warned.out"), ("convert", "-o", "warned.out"), ("info",)):
        run = host.run(command, "warned.obj", *rest)
        host.equal(f"{command} with {name}", (run.returncode, run.stderr), (0, lines))
        if command == "render":
            host.equal(f"picture with {name}", host.read("warned.out"), plain)
    os.remove(host.path("warned.out"))
    host.refuses(f"{name} and a scene that cannot be drawn",
                 ["render", "warned.obj", "--arena", "100", "-o", "out.png"], r"glint: --arena 100: .*")


def test_what_is_not_followed(host):
    """What can be drawn is drawn, with status 0: what is not followed is told once, with its first line."""
    host.write("plain.obj", CUBE_V + CUBE_F)
    plain = host.render_bytes("plain.obj", *CUBE_VIEW)
    cube = CUBE_V + CUBE_F
    corners = [line[2:].split() for line in CUBE_F.splitlines()]

    def faces(*endings):
        return "vt 0 0\n" + "".join("f " + " ".join(i + endings[k % len(endings)] for k, i in enumerate(face)) + "\n"
                                    for face in corners)

    for name, text, wanted in [
            ("nothing", cube, []),
            ("a library", "mtllib a b.mtl\n" + cube, [(1, f"'a' {UNREAD} (and 1 more)")]),
            ("a material", CUBE_V + "usemtl a\n" + CUBE_F, [(9, f"'a' {UNKNOWN}")]),
            ("materials", "# a\nmtllib a.mtl\n" + CUBE_V + "".join(f"usemtl {line}\n{line}\n" for line in CUBE_F.splitlines()),
             [(2, f"'a.mtl' {UNREAD}"), (11, f"'f 5 6 8 7' {UNKNOWN} (and 5 more)")]),
            ("texture maps", "maplib a\n" + cube + "usemap b\n", [(1, f"'maplib' {TEXTURES} (and 1 more)")]),
            ("lines and points", cube + "l 1 2\np 1\ncurv 0 1 1 2\nsurf 0 1 0 1 1 2 3\n",
             [(15, f"'l' {ELEMENTS} (and 3 more)")]),
            ("a word", cube.replace("f", "foo 1 2\nf", 1), [(9, f"'foo' {WORDS}")]),
            ("a word, often", cube.replace("f", "foo bar\nf"), [(9, f"'foo' {WORDS} (and 5 more)")]),
            ("a word in capitals", "V 1 2 3\n" + cube, [(1, f"'V' {WORDS}")]),
            ("a word over lines", "foo \\\n1\n" + cube + "bar", [(1, f"'foo' {WORDS}"), (17, f"'bar' {WORDS}")]),
            ("a long word", "x" * 5000 + "\n" + cube, [(1, f"'{'x' * 28}...' {WORDS}")]),
            ("bytes", b"\x00\xff\n" + cube.encode(), [(1, f"'??' {WORDS}")]),
            ("many words", "".join(f"w{i % 9}\n" for i in range(40)) + cube,
             [(1, f"'w0' {WORDS} (and 4 more)"), (2, f"'w1' {WORDS} (and 4 more)"), (3, f"'w2' {WORDS} (and 4 more)"),
              (4, f"'w3' {WORDS} (and 4 more)"),
              (5, "'w4' is skipped, as are more words that are not OBJ keywords (and 19 more)")]),
            ("v/t/", CUBE_V + faces("/1/"), [(10, f"'5/1/' {EMPTY} (and 23 more)")]),
            ("v/", CUBE_V + faces("/"), [(10, f"'5/' {EMPTY} (and 23 more)")]),
            ("v//", CUBE_V + faces("//", "", "/1", ""), [(10, f"'5//' {EMPTY} (and 5 more)")]),
            ("faces of two corners and less", cube + "f 1 2\nf 3\nf\n", [(15, f"'f' {FEW} (and 2 more)")]),
            ("a truncated face", cube + "f 1 2", [(15, f"'f' {FEW}")]),
            ("normals that are none", CUBE_V + "vn nan nan nan\nvn 0 inf 0\nvn 0 1\nvn 0 0 1 0\nvn\nvn x 0 0\n" + "".join(
                "f " + " ".join(f"{i}//{n + 1}" for i in face) + "\n" for n, face in enumerate(corners)),
             [(9, f"'vn' {NO_NORMAL} (and 5 more)")]),
            ("texture coordinates that are none", "vt nan nan\nvt\nvt 0 0 0 0\nvt -Infinity 0\n" + cube.replace("f 5 6", "f 5/1 6/4"),
             [(1, f"'vt' {NO_TEXTURE} (and 3 more)")]),
            ("normals that are not there", CUBE_V + "vn 0 0 1\n" + cube.replace(CUBE_V, "").replace("f 5 6", "f 5//2 6//0"),
             [(10, f"'5//2' {NORMAL_INDEX} (and 1 more)")]),
            ("no normals at all", CUBE_V + "".join("f " + " ".join(f"{i}//{i}" for i in face) + "\n" for face in corners),
             [(9, f"'5//5' {NORMAL_INDEX} (and 23 more)")]),
            ("textures that are not there", CUBE_V + faces("/2"), [(10, f"'5/2' {TEXTURE_INDEX} (and 23 more)")]),
            ("colours of ZBrush", cube + "#MRGB " + "ffff0000" * 8 + "\n#MRGB \n", [(15, f"'#MRGB' {ZBRUSH} (and 1 more)")]),
            ("no smoothing group", "s on\ns\ns -1\n" + cube, [(1, f"'s' {SMOOTHING} (and 2 more)")]),
            ("white of 255", cube.replace("1\n", "1 255 255 255\n", 8), [(1, f"'v' {BYTES} (and 7 more)")]),
            ("a position without colour", cube.replace("1\n", "1 1 0.5 0\n", 8).replace(" 1 0.5 0", "", 2),
             [(1, f"'v' {BARE} (and 1 more)")]),
            ("all at once", "mtllib a\nfoo\n" + CUBE_V + "usemtl x\n" + faces("/1/") + "l 1 2\nbar\nfoo\n",
             [(2, f"'foo' {WORDS} (and 1 more)"), (13, f"'5/1/' {EMPTY} (and 23 more)"), (19, f"'l' {ELEMENTS}"),
              (20, f"'bar' {WORDS}"), (1, f"'a' {UNREAD}"), (11, f"'x' {UNKNOWN}")])]:
        warned(host, name, text, wanted, plain)
    run = host.run("demo", "--models", MODELS, "-o", "warned.out")
    host.equal("models of the demo need no warning", (run.returncode, run.stderr), (0, ""))


def test_colours_of_255(host):
    """One colour above 1 makes all of them 0 to 255, those before it too."""
    host.write("bytes.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 127.5 0\nv 1 1 0 51 102 255\nv 0 1 0 1 255 0.4\nf 1 2 3 4\n")
    run = host.run("convert", "bytes.obj", "-o", "bytes.h")
    host.equal("colours of 255", (run.returncode, run.stderr), (0, f"bytes.obj:2: warning: 'v' {BYTES} (and 2 more)\n"))
    host.check("are kept as they are", "{1, 0, 0}, {0, 128, 0}, {51, 102, 255}, {1, 255, 0}," in host.read("bytes.h").decode())


def test_numbers(host):
    cases = {"1": 1, "-1": -1, "+1": 1, "1.": 1, ".5": 0.5, "5e-1": 0.5, "5E-1": 0.5, "0.5e+0": 0.5, "-0": 0,
             "0.000000000000000000000000001e27": 1, "1000000000000000000000000e-24": 1, "1e-999": 0,
             "3." + "0" * 400: 3, "0" * 400 + "7": 7, "123.456": 123.456, "1e-5": 1e-5}
    for text, value in cases.items():
        host.write("number.obj", f"v {text} -1 0\nv {text} 1 0\nv {text} 0 1\nf 1 2 3\n")
        lowest = host.info("number.obj")["lowest"].split()[0]
        host.check(f"number {text[:20]}", abs(float(lowest) - value) <= 1e-6 * abs(value), lowest)
    host.write("comma.obj", SQUARE.replace("1", "0.5", 1))
    host.equal("numbers do not follow the locale", host.run("info", "comma.obj", env={"LC_ALL": "de_DE.UTF-8"}).returncode, 0)


def test_normals(host):
    normals = "vn 0 0 1\nvn 0 0 -1\nvn 1 0 0\nvn -1 0 0\nvn 0 1 0\nvn 0 -1 0\n"
    faces = [line[2:].split() for line in CUBE_F.splitlines()]
    flat = "".join("f " + " ".join(f"{i}//{n + 1}" for i in face) + "\n" for n, face in enumerate(faces))
    both = "vt 0 0\n" + "".join("f " + " ".join(f"{i}/1/{n - 6}" for i in face) + "\n" for n, face in enumerate(faces))
    smooth = "".join(f"vn {2 * (i & 1) - 1} {(i & 2) - 1} {(i & 4) / 2 - 1}\n" for i in range(8)) + \
        "".join("f " + " ".join(f"{i}//{i}" for i in face) + "\n" for face in faces)
    for name, text in [("none", CUBE_F), ("flat", normals + flat), ("both", normals + both), ("smooth", smooth),
                       ("zero", "vn 0 0 0\n" + "".join("f " + " ".join(f"{i}//1" for i in face) + "\n" for face in faces))]:
        host.write(f"{name}.obj", CUBE_V + text)
    flat_picture = host.render_bytes("flat.obj", *CUBE_VIEW)
    host.equal("v/t/n is v//n", host.render_bytes("both.obj", *CUBE_VIEW), flat_picture)
    host.equal("--crease below the angle splits", host.render_bytes("none.obj", *CUBE_VIEW, "--crease", "89"), flat_picture)
    host.equal("--crease overrides normals", host.render_bytes("smooth.obj", *CUBE_VIEW, "--crease", "30"), flat_picture)
    host.equal("missing normals are split at sharp edges", host.render_bytes("none.obj", *CUBE_VIEW), flat_picture)
    host.equal("normals of length 0 are missing", host.render_bytes("zero.obj", *CUBE_VIEW), flat_picture)
    averaged = host.render_bytes("none.obj", *CUBE_VIEW, "--smooth")
    host.equal("--crease at the angle smooths", host.render_bytes("none.obj", *CUBE_VIEW, "--crease", "90"), averaged)
    host.equal("--smooth overrides normals", host.render_bytes("flat.obj", *CUBE_VIEW, "--smooth"), averaged)
    host.equal("info: normals", [host.info(f"{n}.obj")["normals"] for n in ("none", "flat", "zero")],
               ["computed", "given", "computed"])


def test_polygons(host):
    view = ["--eye", "0,0,3", "--size", "120x120", "--light", "dir:0,0,1:0,0,0", "--ambient", "1"]
    shape = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv 0.2 -0.5 0\nv -1 1 0\n"  # dart: no fan from corner 1 covers it
    host.write("dart.obj", shape + "f 1 2 3 4 5\n")
    host.write("parts.obj", shape + "f 1 2 4\nf 2 3 4\nf 1 4 5\n")
    host.equal("a concave polygon", host.render_bytes("dart.obj", *view), host.render_bytes("parts.obj", *view))
    for turn in range(5):
        corners = [str(1 + (i + turn) % 5) for i in range(5)]
        host.write("dart.obj", shape + f"f {' '.join(corners)}\n")
        host.equal(f"a concave polygon from corner {turn + 1}", host.render_bytes("dart.obj", *view),
                   host.render_bytes("parts.obj", *view))
    host.write("back.obj", shape + "f 5 4 3 2 1\n")
    host.equal("a concave polygon seen from behind", host.render("back.obj", *view).box(BLACK), None)
    # A plate whose outline has corners in a row: a triangle without area would leave gaps beside its neighbours.
    ring = [(0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (3, 2), (2, 2), (0, 2), (0, 1)]
    for turn in range(len(ring)):
        corners = ring[turn:] + ring[:turn]
        host.write("plate.obj", "".join(f"v {x / 10:.1f} {(x + 3 * y) / 10:.1f} {y / 10:.1f}\n" for x, y in corners) +
                   "f " + " ".join(str(i + 1) for i in range(len(ring))) + "\n")
        positions, _, triangles, _, _ = mesh(convert(host, "plate.obj"), "plate")
        areas = [math.hypot(*cross(minus(positions[b], positions[a]), minus(positions[c], positions[a]))) for a, b, c in triangles]
        host.check(f"corners in a row, from corner {turn + 1}", len(triangles) == 7 and min(areas) > 0.005, str(areas))
    # Drawn once each: a hole that a bridge leads to, and a corner that turns inwards, four thousand kilometres away.
    hole = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (1, 1), (1, 3), (3, 3), (3, 1), (1, 1)]
    far = [(500000 + x, 4000000 + y) for x, y in ((0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3))]
    for name, corners, area in (("a bridge to a hole", hole, 12), ("far away", far, 5)):
        host.write("plate.obj", "".join(f"v {x} {y} 100\n" for x, y in corners) + "f " + " ".join(str(i + 1) for i in range(len(corners))) + "\n")
        positions, _, triangles, _, _ = mesh(convert(host, "plate.obj", "--centre"), "plate")
        areas = [cross(minus(positions[b], positions[a]), minus(positions[c], positions[a]))[2] / 2 for a, b, c in triangles]
        host.check(name, min(areas) > 0 and abs(sum(areas) - area) < 1e-3, str(areas))
    many = [f"v {x} {y} 0" for x, y in ((i / 600 - 1, -1) for i in range(1200))] + ["v 1 1 0", "v -1 1 0"]
    host.write("many.obj", "\n".join(many) + "\nf " + " ".join(str(i + 1) for i in range(1202)) + "\n")
    host.write("square.obj", SQUARE)
    host.equal("a polygon of 1202 corners", host.info("many.obj")["faces"], "1")
    host.equal("its box", host.render("many.obj", *view).box(BLACK), host.render("square.obj", *view).box(BLACK))


def test_info(host):
    expected = {
        "teapot.obj": {"positions": "1177", "faces": "2256", "triangles": "2256", "boundary_edges": "96",
                       "inconsistent_edges": "0", "shared_edges": "0", "normals": "given", "pieces": "1"},
        "spot.obj": {"positions": "2930", "triangles": "5856", "boundary_edges": "0", "normals": "computed",
                     "vertices": "2930"},
        "spot-control.obj": {"positions": "188", "faces": "180", "triangles": "372", "boundary_edges": "0"},
        "featuretype.obj": {"positions": "1722", "triangles": "3476", "boundary_edges": "0", "normals": "given"},
    }
    for model, wanted in expected.items():
        got = host.info(os.path.join(MODELS, model))
        host.equal(f"info {model}", {name: got[name] for name in wanted}, wanted)
    host.write("bad.obj", SQUARE + "v 5 5 5\ng a\no b\nf 1 2 3\nf 4 1 2 \nf 1 1 2\n")
    got = host.info("bad.obj")
    host.equal("info counts", [got[name] for name in ("positions", "positions_used", "groups", "triangles_dropped")],
               ["5", "4", "2", "1"])
    host.equal("info bounds", (got["lowest"], got["highest"]), ("-1 -1 0", "1 1 0"))
    table = host.run("info", "torus:24x12").stdout.split("\n\n")[1].splitlines()[1:]
    host.equal("info panels", [row.split()[:2] for row in table],
               [["128x64", "grey4"], ["128x128", "rgb565"], ["160x128", "rgb565"], ["240x240", "rgb565"],
                ["320x240", "rgb565"]])
    for row in table:
        size, pixel, smallest, resident, best = row.split()
        arguments = ["torus:24x12", "--size", size, "--format", pixel]
        host.check(f"info arena {size}", 0 < int(smallest) <= int(resident) <= int(best))
        host.equal(f"info smallest arena {size}", host.render_bytes(*arguments, "--arena", smallest),
                   host.render_bytes(*arguments, "--arena", best))
        host.check(f"info arena {size}, a byte less", host.run("render", *arguments, "--arena", str(int(smallest) - 1),
                                                               "-o", "x.png").returncode == 2)


def test_topology(host):
    host.write("inside-out.obj", CUBE_V + CUBE_F.replace("f 5 6 8 7", "f 7 8 6 5"))
    host.equal("a face turned round", host.info("inside-out.obj")["inconsistent_edges"], "4")
    host.write("fin.obj", CUBE_V + "v 3 3 3\n" + CUBE_F + "f 5 6 9\n")
    got = host.info("fin.obj")
    host.equal("a fin", (got["shared_edges"], got["boundary_edges"]), ("1", "2"))
    soup, count = "", 0
    for line in CUBE_F.splitlines():
        for i in line[2:].split():
            soup += CUBE_V.splitlines()[int(i) - 1] + "\n"
        count += 4
        soup += "f -4 -3 -2 -1\n"
    host.write("soup.obj", soup)
    got = host.info("soup.obj")
    host.equal("equal positions are one point", (got["positions"], got["positions_used"], got["boundary_edges"]),
               ("24", "8", "0"))


def test_large_mesh_has_no_seam(host):
    """Two pieces, one offset and extent: no background shows between them."""
    host.write("big.obj", torus_text(512, 256))
    run = host.run("info", "big.obj")
    got = dict(line.split(" ", 1) for line in run.stdout.split("\n\n")[0].splitlines())
    host.check("pieces", int(got["pieces"]) >= 2 and int(got["triangles"]) == 262144, str(got))
    view = ["--eye", "0,0,2.2", "--at", "1,0,0", "--fov", "20", "--light", "dir:0,0,1:0,0,0", "--ambient", "1"]
    large, small = host.render("big.obj", *view), host.render("torus:128x64", *view)
    host.equal("a torus in pieces covers what one does", [row.count(BLACK) for row in large.rows[100:140]],
               [row.count(BLACK) for row in small.rows[100:140]])


def test_quantised_square_keeps_its_place(host):
    host.write("square.obj", SQUARE)
    host.equal("largest move", float(host.info("square.obj")["largest_move"]) < 1 / 32000, True)
    image = host.render("square.obj", *SQUARE_VIEW, "--light", "dir:0,0,1:0,0,0", "--ambient", "1")
    host.equal("square", image.box(BLACK), (30, 30, 59, 59))
