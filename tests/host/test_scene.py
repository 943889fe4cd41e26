# SPDX-License-Identifier: MIT
"""The example scenes: the list, stills, and animations by a decoder of their own."""
import os
import re
import struct
import subprocess
import sys
import zlib

import png
from harness import ROOT
from test_render import STATS

SMALL = ["--size", "64x48"]


def scenes(host):
    """{name: (width, height, frames, [variant])} from the list, in its order."""
    run = host.run("scene", "--list")
    found, sentences = {}, []
    for line in run.stdout.splitlines():
        variant = re.fullmatch(r"  ([\w-]+):([\w-]+)  (\S.+)", line)
        if variant:
            found[variant.group(1)][3].append(variant.group(2))
            sentences.append(variant.group(3))
        else:
            name, width, height, frames, text = re.fullmatch(r"([\w-]+) \((\d+)x(\d+), (\d+) frames?\): (.+)", line).groups()
            found[name] = (int(width), int(height), int(frames), [])
            sentences.append(text)
    host.check("the list", run.returncode == 0 and run.stderr == "" and all(s[-1] == "." for s in sentences), str(sentences))
    return found


def draw(host, name, *options):
    run = host.run("scene", name, *options, "-o", "scene.png")
    if run.returncode != 0 or run.stderr or (run.stdout and "--stats" not in options):
        raise AssertionError(f"scene {name} {options}: {run.returncode} {run.stdout} {run.stderr}")
    data = host.read("scene.png")
    os.remove(host.path("scene.png"))
    return data


def test_names(host):
    host.equal("the scenes", list(scenes(host)), ["shaders", "three-spheres", "halloween", "teapot", "phong-lighting",
                                                  "surfaces", "still-life"])


def test_data(host):
    """Who changes the script and forgets the header would not see what he did."""
    folder = os.path.join(ROOT, "examples", "scenes")
    made = subprocess.run([sys.executable, os.path.join(folder, "make_still_life.py")], capture_output=True, text=True, check=True)
    with open(os.path.join(folder, "still_life_data.h"), encoding="utf-8") as file:
        host.check("still_life_data.h is what make_still_life.py writes", file.read() == made.stdout)


def test_every_variant(host):
    for name, (width, height, _, variants) in scenes(host).items():
        image = png.decode(draw(host, name))
        host.equal(f"{name}: composed size", (image.width, image.height, image.channels), (width, height, 3))
        host.equal(f"{name}: the first variant is the default", draw(host, name, *SMALL),
                   draw(host, f"{name}:{variants[0]}", *SMALL))
        pictures = [draw(host, f"{name}:{variant}") for variant in variants]
        host.equal(f"{name}: no variant is drawn twice", len(set(pictures)), len(variants))


def test_frames(host):
    for name, (_, _, frames, variants) in scenes(host).items():
        first = draw(host, name, *SMALL)
        host.equal(f"{name}: frame 0 is the default", draw(host, name, *SMALL, "--frame", "0"), first)
        host.equal(f"{name}: it repeats", draw(host, name, *SMALL, "--frame", str(frames)), first)
        if frames > 1:
            host.check(f"{name}: it moves", any(draw(host, f"{name}:{v}", "--frame", str(frames // 3)) != draw(host, f"{name}:{v}")
                                                for v in variants))


def test_options(host):
    plain = png.decode(draw(host, "teapot"))
    for options in (["--format", "grey4"], ["--format", "rgb565"], ["--dither", "--format", "rgb565"], ["--gamma", "2.2"],
                    ["--frame", "3"], SMALL):
        host.check(f"scene {' '.join(options)}", png.decode(draw(host, "teapot", *options)).rows != plain.rows)
    for options in (["--tile", "8x64"], ["--tile", "64x8"], ["--arena", "30000"], ["--gamma", "1"], ["--format", "rgb888"]):
        host.equal(f"scene {' '.join(options)}", png.decode(draw(host, "teapot", *options)).rows, plain.rows)
    run = host.run("scene", "teapot", "--stats", "-o", "scene.png")
    os.remove(host.path("scene.png"))
    host.equal("scene --stats", [line.split(" ")[0] for line in run.stdout.splitlines()],
               STATS)


def decode_movie(host, data, name):
    """[rows of each frame] and [delay] of an APNG, whose structure is checked on the way."""
    parts = png.chunks(data)
    width, height, _, colour = struct.unpack(">IIBB", parts[0][1][:10])
    step = 3 if colour == 2 else 1
    kinds = [kind for kind, _ in parts]
    count, plays = struct.unpack(">II", parts[1][1])
    host.equal(f"{name}: chunks", kinds, [b"IHDR", b"acTL", b"fcTL", b"IDAT"] + [b"fcTL", b"fdAT"] * (count - 1) + [b"IEND"])
    host.equal(f"{name}: for ever", plays, 0)
    numbers = [struct.unpack(">I", body[:4])[0] for kind, body in parts if kind in (b"fcTL", b"fdAT")]
    host.equal(f"{name}: sequence", numbers, list(range(2 * count - 1)))
    canvas, frames, delays = bytearray(width * height * step), [], []
    for (_, control), (kind, body) in zip(parts[2:-1:2], parts[3:-1:2]):
        _, wide, high, left, top, num, den, dispose, blend = struct.unpack(">IIIIIHHBB", control)
        whole = not frames
        host.check(f"{name}: frame {len(frames)}", (dispose, blend) == (0, 0) and wide > 0 and high > 0 and
                   left + wide <= width and top + high <= height and (not whole or (wide, high) == (width, height)))
        raw, above = zlib.decompress(body if kind == b"IDAT" else body[4:]), bytes(wide * step)
        for y in range(high):
            line = raw[y * (wide * step + 1):(y + 1) * (wide * step + 1)]
            above = png.unfilter(line[0], line[1:], above, step)
            at = ((top + y) * width + left) * step
            canvas[at:at + wide * step] = above
        frames.append([[tuple(canvas[(y * width + x) * step:(y * width + x + 1) * step]) for x in range(width)]
                       for y in range(height)])
        delays.append((num, den))
    return frames, delays


def test_animation(host):
    for name, (_, _, frames, _) in scenes(host).items():
        for count, options in ((1, SMALL), (5, SMALL), (3, [*SMALL, "--format", "grey4", "--dither"])):
            title = f"{name} in {count}"
            movie, delays = decode_movie(host, draw(host, name, *options, "--animate", str(count)), title)
            stills = [png.decode(draw(host, name, *options, "--frame", str(i * frames // count))).rows for i in range(count)]
            host.check(f"{title}: its frames are the stills", movie == stills)
            host.check(f"{title}: at 25 of its own a second", all(n / d * count == frames / 25 for n, d in delays), str(delays))
    host.equal("same scene, same bytes", draw(host, "teapot", *SMALL, "--animate", "4"),
               draw(host, "teapot", *SMALL, "--animate", "4"))
    run = host.run("scene", "teapot", *SMALL, "--animate", "1000", "-o", "scene.png")
    host.equal("a thousand frames", (run.returncode, run.stderr), (0, ""))
    os.remove(host.path("scene.png"))
    host.refuses("an animation that cannot be written", ["scene", "teapot", *SMALL, "--animate", "2", "-o", "no/x.apng"],
                 r"no/x\.apng:0: cannot be written: .+")
