# SPDX-License-Identifier: MIT
"""What is not opaque, fog and smooth edges, by options and by what files say."""
import re
import subprocess

from harness import SQUARE
from test_convert import STRICT
from test_formats import painted

# The square, which is 3 units away, covers the picture.
NEAR = ["--eye", "0,0,3", "--fov", "30", "--size", "32x32", "--model", "unlit"]
BEHIND, PAINT = (.2, .4, .6), (.8, .5, .1)
COLOURS = ["--background", ".2,.4,.6", "--diffuse", ".8,.5,.1"]


def mixed(part, over=PAINT, under=BEHIND):
    return tuple(255 * ((1 - part) * b + part * a) for a, b in zip(over, under))


def close(pixel, wanted):
    return all(abs(a - min(b, 255)) <= 1.5 for a, b in zip(pixel, wanted))


def square(host, *options):
    host.write("square.obj", SQUARE)
    return host.render("square.obj", *NEAR, *COLOURS, *options)


def test_opacity(host):
    for opacity in (0, .25, .5, 1):
        image = square(host, "--opacity", str(opacity))
        host.check(f"opacity {opacity}", close(image.at(9, 20), mixed(opacity)), str(image.at(9, 20)))
        image = square(host, "--opacity", str(opacity), "--blend", "add")
        wanted = tuple(255 * (b + opacity * a) for a, b in zip(PAINT, BEHIND))
        host.check(f"{opacity} added", close(image.at(9, 20), wanted), str(image.at(9, 20)))
        image = square(host, "--opacity", str(opacity), "--blend", "dithered")
        covered = sum(close(image.at(x, y), mixed(1)) for x in range(8, 16) for y in range(16, 24))
        host.equal(f"{opacity} of 64 pixels", covered, 64 * opacity)
    host.equal("blend none is opaque", square(host, "--opacity", ".5", "--blend", "none").rows, square(host).rows)
    host.equal("so is blend alone", square(host, "--blend", "alpha").rows, square(host).rows)


def test_opacity_of_files(host):
    host.write("glass.obj", "mtllib glass.mtl\nusemtl glass\n" + SQUARE)
    for name, text, opacity in [("d", "d .25", .25), ("Tr", "Tr .75", .25), ("d before Tr", "d .25\nTr 0", .25),
                                ("Tr before d", "Tr 0\nd .25", .25), ("opaque", "d 1\nTr 0", 1)]:
        host.write("glass.mtl", f"newmtl glass\nKd 1 1 1\n{text}\n")
        image = host.render("glass.obj", *NEAR, *COLOURS)
        host.check(name, close(image.at(9, 20), mixed(opacity)), str(image.at(9, 20)))
        image = host.render("glass.obj", *NEAR, *COLOURS, "--opacity", ".75")
        host.check(f"{name}: --opacity overrides", close(image.at(9, 20), mixed(.75)), str(image.at(9, 20)))
    base = {"baseColorFactor": [1, 1, 1, .25]}
    for mode, opacity in (("BLEND", .25), ("MASK", 1), ("OPAQUE", 1)):
        host.write("glass.gltf", painted(alphaMode=mode, doubleSided=True, pbrMetallicRoughness=base))
        run = host.run("convert", "glass.gltf", "-o", "glass.h")
        blend = "GLINT_BLEND_ALPHA,\n    16384," if opacity < 1 else "GLINT_BLEND_NONE,\n    0,"
        host.check(f"glTF: {mode}", run.returncode == 0 and run.stderr == "" and blend in host.read("glass.h").decode(), run.stderr)


def test_conversion(host):
    host.write("glass.obj", "mtllib glass.mtl\nusemtl glass\n" + SQUARE)
    host.write("glass.mtl", "newmtl glass\nKd 1 1 1\nd .25\n")
    host.equal("converts", host.run("convert", "glass.obj", "-o", "glass.h").returncode, 0)
    host.write("glass.c", '#include "glass.h"\n')
    for compiler in (["cc", "-std=c99"], ["c++", "-x", "c++"]):
        run = subprocess.run([*compiler, *STRICT, "-fsyntax-only", "glass.c"], cwd=host.folder, capture_output=True,
                             text=True, check=False)
        host.equal(f"{compiler[0]} takes it", (run.returncode, run.stderr), (0, ""))
    arenas = []
    for text in ("d .25", "d 1"):
        host.write("glass.mtl", f"newmtl glass\nKd 1 1 1\n{text}\n")
        run = host.run("info", "glass.obj", "--panel", "320x240")
        arenas.append(int(re.search(r"^320x240 .* (\d+)$", run.stdout, re.M)[1]))
    clear, opaque = arenas
    host.check("info counts the layers", clear > opaque + 2048, f"{opaque}, {clear}")


def test_fog(host):
    for name, options, part, fog in [
            ("halfway", ["--fog", "2:4"], .5, BEHIND), ("a quarter of the way", ["--fog", "2.75:3.75"], .25, BEHIND),
            ("squared", ["--fog", "2:4", "--fog-type", "squared"], .25, BEHIND), ("before it", ["--fog", "4:5"], 0, BEHIND),
            ("beyond it", ["--fog", "0:2"], 1, BEHIND), ("a colour", ["--fog", "2:4:1,0,.5"], .5, (1, 0, .5)),
            ("grey", ["--fog", "2:4:.5"], .5, (.5,) * 3)]:
        image = square(host, *options)
        host.check(name, close(image.at(9, 20), mixed(part, fog, PAINT)), str(image.at(9, 20)))


def test_samples(host):
    """Each pixel is the mean of the four that are there at twice the size."""
    torus = ["torus:24x12", "--rotate-x", "-50", "--model", "unlit", "--diffuse", ".9,.6,.1", "--background", ".1"]
    smooth, large = host.render(*torus, "--samples", "2x2", "--size", "80x60"), host.render(*torus, "--size", "160x120")
    worst = max(abs(c - sum(large.at(2 * x + i, 2 * y + j)[k] for i in (0, 1) for j in (0, 1)) / 4)
                for y in range(60) for x in range(80) for k, c in enumerate(smooth.at(x, y)))
    host.check("means of four", worst <= 1, str(worst))
    plain = host.render_bytes(*torus, "--size", "80x60")
    host.equal("--samples 1 changes nothing", host.render_bytes(*torus, "--size", "80x60", "--samples", "1"), plain)
    host.check("2x2 does", host.render_bytes(*torus, "--size", "80x60", "--samples", "2x2") != plain)
    for options in (["--size", "640x480"], ["--tile", "64x64"]):
        host.refuses(f"samples, {options[1]}", ["render", *torus, "--samples", "2x2", *options, "-o", "t.png"],
                     "glint: with samples, width or height is above 512, or a tile's above 32")
