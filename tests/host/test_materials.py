# SPDX-License-Identifier: MIT
"""Materials of OBJ files: what MTL says, what is drawn of it, and what `convert` writes."""
import os
import re
import shutil
import subprocess

import png
from test_convert import STRICT, fnv1a

# Two squares beside each other that face the camera, the left one of the first material.
HEAD = "mtllib colours.mtl\n"
POINTS = "v -2 -1 0\nv 0 -1 0\nv 2 -1 0\nv -2 1 0\nv 0 1 0\nv 2 1 0\n"
LEFT, RIGHT = "f 1 2 5 4\n", "f 2 3 6 5\n"
PAIR = HEAD + POINTS + "usemtl red paint\n" + LEFT + "usemtl blue\n" + RIGHT
VIEW = ["--eye", "0,0,3", "--fov", "90", "--size", "96x48"]
LIGHT = ["--light", "dir:0,0,1"]

RED = {"Ka": (.5, .4, .3), "Kd": (.7, .1, .05), "Ks": (.1, .2, .3)}
LIBRARY = ("newmtl red paint\nKa .5 .4 .3\nKd .7 .1 .05\nKs .1 .2 .3\nNs 20\nNi 1.45\nd 1.0\nTr 0\nTf 1 1 1\nillum 2\n"
           "newmtl blue\nKd .1 .2 .8\nKe 0 .1 0\nillum 1\n")


def write(host, library=LIBRARY, model=PAIR):
    host.write("colours.mtl", library)
    host.write("pair.obj", model)


def sides(host, *options, view=(*VIEW, *LIGHT)):
    """Pixels of the left and the right square."""
    image = host.render("pair.obj", *view, *options)
    return image.at(36, 24), image.at(60, 24)


def close(pixel, colour):
    return all(abs(p - 255 * min(c, 1)) <= 1 for p, c in zip(pixel, colour))


def add(*colours):
    return tuple(sum(channels) for channels in zip(*colours))


def scale(factor, colour):
    return tuple(factor * c for c in colour)


def test_formulas(host):
    """Seen along the light all angles are 0: 0.1 Ka + Kd + Ks + Ke, by docs/assets.md."""
    write(host)
    left, right = sides(host)
    host.check("Ka, Kd and Ks", close(left, add(scale(.1, RED["Ka"]), RED["Kd"], RED["Ks"])), str(left))
    host.check("Ke, illum 1, and Kd for Ka", close(right, add(scale(1.1, (.1, .2, .8)), (0, .1, 0))), str(right))
    away = sides(host, view=[*VIEW, "--light", "dir:0,0,-1"])
    host.check("Ka in the dark", close(away[0], scale(.1, RED["Ka"])), str(away[0]))
    host.check("Ke in the dark", close(away[1], (.01, .12, .08)), str(away[1]))
    for name, text, colour in [
            ("Ka of 1 is Kd", "Ka 1 1 1\nKd .5 .4 .2\n", (.55, .44, .22)), ("black Ka", "Ka 0 0 0\nKd .5 .4 .2\n", (.5, .4, .2)),
            ("one number", "Ka 0\nKd .5\n", (.5, .5, .5)), ("illum 0", "Kd .5 .4 .2\nKe .1 0 .1\nKs 1\nillum 0\n", (.6, .4, .3)),
            ("illum 1", "Ka 0\nKd .5 .4 .2\nKs .3\nillum 1\n", (.5, .4, .2)), ("no Kd", "Ka 0\n", (.6, .6, .6)),
            ("nothing", "", (.66, .66, .66)), ("sums are clamped", "Kd .9 .9 .1\nKs .9 .1 .1\n", (1.89, 1.09, .21)),
            ("the last of a word", "Ka 0\nKd 1 1 1\nKd .2 .3 .4\n", (.2, .3, .4))]:
        write(host, "newmtl red paint\n" + text)
        run = host.run("render", "pair.obj", *VIEW, *LIGHT, "-o", "pair.png")
        host.equal(f"{name}: the other material is missing", (run.returncode, run.stderr),
                   (0, "pair.obj:10: warning: 'blue' is not among the materials: the default one stands\n"))
        image = png.decode(host.read("pair.png"))
        host.check(f"{name}", close(image.at(36, 24), colour), f"{image.at(36, 24)}, not {colour}")
        host.check(f"{name}: the default", close(image.at(60, 24), (1.1,) * 3), str(image.at(60, 24)))
        os.remove(host.path("pair.png"))
    write(host, "newmtl red paint\nKa 0\nKd 0\nKs 1\nNs 12\nnewmtl blue\nKa 0\nKd 0\nKs 1\n")
    slanted = sides(host, view=[*VIEW, "--light", "dir:1,0,1"])
    host.check("Ns, and 32 without", close(slanted[0], (.9238795 ** 12,) * 3) and close(slanted[1], (.9238795 ** 32,) * 3),
               str(slanted))


def test_options_override(host):
    write(host)
    for options, wanted in [(["--diffuse", ".2"], add(scale(.1, RED["Ka"]), (.2,) * 3, RED["Ks"])),
                            (["--ambient", "0"], add(RED["Kd"], RED["Ks"])),
                            (["--specular", "0"], add(scale(.1, RED["Ka"]), RED["Kd"])),
                            (["--model", "lambert"], add(scale(.1, RED["Ka"]), RED["Kd"])),
                            (["--model", "unlit"], RED["Kd"])]:
        left = sides(host, *options)[0]
        host.check(f"{' '.join(options)} overrides the file", close(left, wanted), f"{left}, not {wanted}")
    write(host, "newmtl red paint\nKa 0\nKd 0\nKs 1\nNs 12\nnewmtl blue\nNs 3\n")
    left = sides(host, "--shininess", "5", view=[*VIEW, "--light", "dir:1,0,1"])[0]
    host.check("--shininess overrides the file", close(left, (.9238795 ** 5,) * 3), str(left))


def test_models_are_the_same_however_written(host):
    write(host)
    plain = host.render_bytes("pair.obj", *VIEW)
    host.check("materials show", plain != host.render_bytes("pair.obj", *VIEW, "--diffuse", ".6"))
    host.equal("info counts them", [host.info("pair.obj")[name] for name in ("materials", "pieces", "triangles")],
               ["2", "2", "4"])
    turns = HEAD + POINTS + "".join(f"usemtl {name}\n{face}" for name, face in
                                    [("blue", "f 2 3 6\n"), ("red paint", "f 1 2 5\n"), ("blue", "f 2 6 5\n"),
                                     ("red paint", "f 1 5 4\n")])
    for name, library, model in [("in turns", LIBRARY, turns), ("mtllib at the end", LIBRARY, PAIR.replace(HEAD, "") + HEAD),
                                 ("comments", LIBRARY.replace("\n", " # a\n").replace("paint # a", "paint").replace(
                                     "blue # a", "blue"), PAIR.replace("usemtl blue", "usemtl blue # v")),
                                 ("CRLF", LIBRARY.replace("\n", "\r\n"), PAIR.replace("\n", "\r\n")),
                                 ("a second definition", LIBRARY + "newmtl blue\nKd 1 1 1\n", PAIR),
                                 ("twice the library", LIBRARY, HEAD + PAIR),
                                 ("blanks", LIBRARY.replace("newmtl ", " newmtl \t ").replace("\n", " \n"), PAIR)]:
        write(host, library, model)
        host.equal(f"materials: {name}", host.render_bytes("pair.obj", *VIEW), plain)
    write(host, LIBRARY.split("newmtl blue")[0], PAIR.replace("mtllib colours.mtl", "mtllib colours.mtl more.mtl"))
    host.write("more.mtl", "newmtl blue" + LIBRARY.split("newmtl blue")[1])
    host.equal("two libraries", host.render_bytes("pair.obj", *VIEW), plain)
    write(host, LIBRARY, PAIR.replace("colours.mtl", "my colours.mtl"))
    host.write("my colours.mtl", LIBRARY)
    host.equal("a library with a blank in its name", host.render_bytes("pair.obj", *VIEW), plain)
    os.mkdir(host.path("sub"))
    for name in ("pair.obj", "my colours.mtl"):
        os.rename(host.path(name), host.path("sub/" + name))
    host.equal("libraries are in the model's folder", host.render_bytes("sub/pair.obj", *VIEW), plain)


def test_names_as_other_systems_write_them(host):
    """Backslashes, quotes, drives and folders of another machine: the library that lies beside the model is found."""
    write(host)
    host.write("my colours.mtl", LIBRARY)
    plain = host.render_bytes("pair.obj", *VIEW)
    for name in (".\\colours.mtl", "C:\\Users\\me\\colours.mtl", "/home/me/models/colours.mtl", "../colours.mtl", '"colours.mtl"',
                 '"my colours.mtl"', "my colours.mtl", ".\\my colours.mtl", "./colours.mtl"):
        write(host, LIBRARY, PAIR.replace("colours.mtl", name))
        host.equal(f"mtllib {name}", host.render_bytes("pair.obj", *VIEW), plain)
    write(host, LIBRARY, PAIR.replace("usemtl red paint", 'usemtl "red paint"'))
    host.equal("usemtl with quotes", host.render_bytes("pair.obj", *VIEW), plain)
    write(host, LIBRARY.replace("newmtl red paint", 'newmtl "red paint"'))
    host.equal("newmtl with quotes", host.render_bytes("pair.obj", *VIEW), plain)
    write(host, LIBRARY.replace("newmtl blue", "newmtl"), PAIR.replace("usemtl blue", "usemtl"))
    host.equal("names that are empty", host.render_bytes("pair.obj", *VIEW), plain)
    write(host, LIBRARY.encode("utf-16"))
    told(host, "UTF-16", ["pair.obj:1: warning: 'colours.mtl' is text in UTF-16, and is skipped: save it as UTF-8 or ASCII",
                          "pair.obj:8: warning: 'red paint' is not among the materials: the default one stands (and 1 more)"])


def test_no_highlight_without_an_exponent(host):
    """Exporters write Ns 0 for matt: not a white veil over all that is lit."""
    for ns, part in ((0, 0), (0.25, 0.25), (1, 1)):
        write(host, f"newmtl red paint\nKa 0\nKd .2 .5 .2\nKs .5 .5 .5\nNs {ns}\nnewmtl blue\n")
        left = sides(host)[0]
        host.check(f"Ns {ns}", close(left, add((.2, .5, .2), scale(part, (.5,) * 3))), str(left))
        left = sides(host, "--shininess", "20")[0]
        host.check(f"Ns {ns}, --shininess 20", close(left, (.7, 1, .7)), str(left))


def told(host, name, wanted):
    run = host.run("render", "pair.obj", *VIEW, "-o", "pair.png")
    host.equal(f"{name} is told", (run.returncode, run.stderr), (0, "".join(line + "\n" for line in wanted)))
    os.remove(host.path("pair.png"))


def test_what_is_not_followed(host):
    blue = "newmtl red paint\nnewmtl blue\n"
    at = "colours.mtl:"
    for name, text, wanted in [
            ("a texture, each once", "map_Ks a.png\nmap_Ks b.png\nbump c.png\n",
             [at + "3: warning: 'map_Ks' is skipped: of textures only map_Kd is drawn (and 1 more)",
              at + "5: warning: 'bump' is skipped: of textures only map_Kd is drawn"]),
            ("transparency", "d 0\nTr 1\nTf .5 1 1\nd -halo 1\n",
             [at + "3: warning: 'd' is skipped: of transparency only d and Tr are drawn, above 0 and up to 1 of d (and 3 more)"]),
            ("reflection", "illum 7\n", [at + "3: warning: 'illum' above 2 is taken as 2: reflections and refraction are not drawn"]),
            ("a word", "Pr 0.5\n", [at + "3: warning: 'Pr' is skipped: it is not followed"]),
            ("a colour", "Kd nan 0 0\nKa 1 1\nKs 17\nKe -1 0 0\nKd spectral a.rfl\nKd 1 1 1 1\nKd\nKa inf\n",
             [at + "3: warning: 'Kd' is skipped: it takes 1 or 3 numbers from 0 to 16 (and 7 more)"]),
            ("a number", "Ns -1\nNs 1e9\nNs 1 2\nillum 11\nillum\n",
             [at + "3: warning: 'Ns' is skipped: it takes one number in its range (and 4 more)"]),
            ("odd words", "".join(f"w{i}\n" for i in range(40)),
             [at + f"{i + 3}: warning: 'w{i}' is skipped: it is not followed" for i in range(12)] +
             [at + "15: warning: 'w12' is skipped, as are more words that are not followed (and 27 more)"])]:
        write(host, blue + text)
        told(host, name, wanted)
    write(host, "Kd 1 1 1\n" + blue)
    told(host, "a statement of no material", [at + "1: warning: 'Kd' is skipped: it stands before any newmtl"])


def test_hostile_files(host):
    outside = "is skipped: it is not in the model's folder"
    missing = "'red paint' is not among the materials: the default one stands (and 1 more)"
    for name in ("../none.mtl", "/etc/passwd", "a/../../b.mtl", ".."):
        write(host, LIBRARY, PAIR.replace("colours.mtl", name))
        told(host, name, [f"pair.obj:1: warning: '{name}' {outside}", f"pair.obj:8: warning: {missing}"])
    for name, quote in [("none.mtl", "none.mtl"), (".", "."), ("\x01\x7f", "??")]:
        write(host, LIBRARY, PAIR.replace("colours.mtl", name))
        told(host, repr(name), [f"pair.obj:1: warning: '{quote}' cannot be read: its materials are missing",
                                f"pair.obj:8: warning: {missing}"])
    write(host, b"newmtl red paint\n\x00\xff\xfe 1\nnewmtl \xc3\xa4\n" + b"K" * 100000 + b"\nKd " + b"1" * 100000 + b"\n",
          HEAD + POINTS + "usemtl red paint\n" + LEFT)
    run = host.run("info", "pair.obj")
    host.check("bytes and endless words", run.returncode == 0 and run.stderr.count("\n") == 3, run.stderr)
    write(host, "".join(f"newmtl m{i}\nKd 0 0 1\n" for i in range(10000)),
          HEAD + POINTS + "".join(f"usemtl m{9999 - i}\n{LEFT}" for i in range(1000)))
    host.equal("10,000 materials, of which 1,000 are used", host.info("pair.obj")["materials"], "1000")
    write(host, LIBRARY, HEAD + POINTS + "".join(f"usemtl m{i}\n{LEFT}" for i in range(10000)))
    host.refuses("10,000 used materials", ["info", "pair.obj"], r"pair\.obj:2056: more than 1024 materials")
    write(host, LIBRARY, "".join(f"mtllib {i}.mtl\n" for i in range(100)) + POINTS + LEFT)
    run = host.run("info", "pair.obj")
    host.equal("100 libraries", run.stderr, "pair.obj:65: warning: 'mtllib' is skipped: no more than 64 files of materials "
               "are read (and 35 more)\npair.obj:1: warning: '0.mtl' cannot be read: its materials are missing (and 63 more)\n")


def test_without_materials_nothing_changes(host):
    """A model whose materials are not defined comes out as one without, and its header too but for the hash."""
    host.write("pair.obj", POINTS + LEFT + RIGHT)
    plain = host.render_bytes("pair.obj", *VIEW)
    host.run("convert", "pair.obj", "--name", "pair", "-o", "plain.h")
    write(host, "", PAIR)
    run = host.run("render", "pair.obj", *VIEW, "-o", "pair.png")
    host.check("unknown materials warn", run.stderr.count("\n") == 1 and host.read("pair.png") == plain, run.stderr)
    host.run("convert", "pair.obj", "-o", "pair.h")

    def body(name):
        return host.read(name).decode().split("*/", 1)[1]

    host.equal("their header is the same", body("pair.h"), body("plain.h"))


def convert(host, *options):
    run = host.run("convert", "pair.obj", *options, "-o", "pair.h")
    host.equal("convert with materials", (run.returncode, run.stderr), (0, ""))
    return host.read("pair.h").decode()


def test_header(host):
    write(host)
    text = convert(host)
    host.equal("convert twice", convert(host), text)
    host.check("the library's hash", f" * Also read: colours.mtl, whose hash is {fnv1a(LIBRARY.encode())}.\n" in text)
    material = re.search(r"glint_material pair_material_red_paint = \{\n(.*?)\n\};", text, re.DOTALL).group(1)
    numbers = [tuple(int(v) / 65536 for v in colour.split(",")) for colour in re.findall(r"\{([^{}]*)\}", material)]
    wrong = max(abs(a - b) for got, wanted in zip(numbers, (scale(.1, RED["Ka"]), RED["Kd"], RED["Ks"]))
                for a, b in zip(got, wanted))
    host.check("a material's colours", len(numbers) == 3 and wrong <= .5001 / 65536 and "&glint_model_blinn_phong" in material and
               f"    {20 * 65536}, /* shininess */" in material, material)
    host.check("a Lambert material", re.search(r"pair_material_blue = \{\n    &glint_model_lambert,", text) is not None)
    host.equal("objects", re.findall(r"\{&(\w+), &(\w+), ", text), [("pair_mesh_red_paint", "pair_material_red_paint"),
                                                                   ("pair_mesh_blue", "pair_material_blue")])
    names = ["a b", "a_b", "a.b", "default", "int", "9", "*/", "\xc3\xa4", "x" * 100, "x" * 99, "_", "//"]
    write(host, "".join(f"newmtl {name}\n" for name in names),
          HEAD + POINTS + LEFT + "".join(f"usemtl {name}\n{LEFT}" for name in names))
    text = convert(host)
    found = re.findall(r"static const glint_mesh pair_mesh_(\w+) = ", text)
    host.equal("names become different identifiers", (len(set(found)), found[:5]), (13, ["default", "a_b", "a_b_2", "a_b_3",
                                                                                        "default_2"]))
    host.equal("an object for each", text.count("    {&pair_mesh_"), 13)
    compiles(host, "names")
    write(host)
    convert(host, "--double-sided", "--name", "two")
    compiles(host, "two materials")


def compiles(host, what):
    for suffix in ("c", "cpp"):
        host.write(f"use.{suffix}", '#include "pair.h"\n#include "pair.h"\nint main(void);\nint main(void) { return 0; }\n')
    for compiler, options, suffix in [("cc", ["-std=c99"], "c"), ("clang", ["-std=c99"], "c"), ("c++", [], "cpp"),
                                      ("clang++", [], "cpp")]:
        if shutil.which(compiler) is not None:
            run = subprocess.run([compiler, *options, *STRICT, "-fsyntax-only", f"use.{suffix}"], cwd=host.folder,
                                 capture_output=True, text=True, check=False)
            host.check(f"{what} with {compiler}", run.returncode == 0, run.stderr[:500])


def test_large_material(host):
    """A material of more vertices than 16 bits can index becomes several objects of it."""
    side = 257
    rows = "".join(f"v {x} {y} {(x * y) % 7}\n" for y in range(side) for x in range(side))
    faces = "".join(f"f {y * side + x + 1} {y * side + x + 2} {(y + 1) * side + x + 2} {(y + 1) * side + x + 1}\n"
                    for y in range(side - 1) for x in range(side - 1))
    write(host, LIBRARY, HEAD + rows + "usemtl blue\ns 1\n" + faces)
    host.equal("convert a large material", host.run("convert", "pair.obj", "-o", "pair.h").returncode, 0)
    text = host.read("pair.h").decode()
    host.equal("pieces of one material", re.findall(r"\{&(\w+), &(\w+), ", text),
               [("pair_mesh_blue_1", "pair_material_blue_1"), ("pair_mesh_blue_2", "pair_material_blue_1")])
    compiles(host, "a large material")
