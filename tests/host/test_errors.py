# SPDX-License-Identifier: MIT
"""Bad input: one line on stderr, status 2, no file."""
import math
import os
import re
import resource

from harness import SQUARE

POINTS = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

# What is wrong with a file, the file, and `line: message` as a pattern.
BAD_MODELS = [
    ("an empty file", "", r"1: no faces"),
    ("no faces", POINTS, r"4: no faces"),
    ("only comments", "# a\n# b", r"2: no faces"),
    ("garbage", "hello world\n", r"1: 'hello' is not an OBJ keyword"),
    ("a PNG", b"\x89PNG\r\n\x1a\n\x00\x00", r"1: is not an OBJ file: it is a picture"),
    ("zero bytes", b"v 0 0 0\n\x00\x00\x00\n", r"2: '\?\?\?' is not an OBJ keyword"),
    ("a long word", "x" * 5000, r"1: 'x{28}\.\.\.' is not an OBJ keyword"),
    ("a keyword in capitals", "V 0 0 0\n", r"1: 'V' is not an OBJ keyword"),
    ("index 0", POINTS + "f 1 2 0\n", r"4: position index 0 is out of range: 3 so far"),
    ("index too large", POINTS + "f 1 2 4\n", r"4: position index 4 is out of range: 3 so far"),
    ("index too far back", POINTS + "f 1 2 -4\n", r"4: position index -4 is out of range: 3 so far"),
    ("index of a later position", "v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0\n", r"3: position index 3 is out of range: 2 so far"),
    ("huge index", POINTS + "f 1 2 99999999999999999999\n", r"4: '99999999999999999999' is not a position index"),
    ("no number as index", POINTS + "f 1 2 x\n", r"4: 'x' is not a position index"),
    ("fraction as index", POINTS + "f 1 2 3.5\n", r"4: '3\.5' is not a position index"),
    ("no number as normal", POINTS + "f 1//x 2 3\n", r"4: 'x' is not a normal index"),
    ("no position but a texture", POINTS + "vt 0 0\nf 1 2 /1/\n", r"5: '' is not a position index"),
    ("empty position", POINTS + "f /1 2 3\n", r"4: '' is not a position index"),
    ("four parts", POINTS + "f 1/1/1/1 2 3\n", r"4: corner '1/1/1/1' is not v, v/t, v//n or v/t/n"),
    ("only faces of two corners", POINTS + "f 1 2\nf 2 3\n", r"4: no face has 3 or more corners"),
    ("only a face without corners", POINTS + "f", r"4: no face has 3 or more corners"),
    ("UTF-16", ("\ufeff" + SQUARE).encode("utf-16-le"), r"1: is not an OBJ file: it is text in UTF-16: save it as UTF-8 or ASCII"),
    ("UTF-16, high byte first", ("\ufeff" + SQUARE).encode("utf-16-be"), r"1: is not an OBJ file: it is text in UTF-16: .*"),
    ("a web page", "<!DOCTYPE html>\n<html>", r"1: is not an OBJ file: it is a web page: download the file itself"),
    ("an archive", b"PK\x03\x04\0\0", r"1: is not an OBJ file: it is a ZIP archive: unpack it first"),
    ("an STL file", "solid a\n facet normal 0 0 1\n", r"1: is not an OBJ file: it is STL: name it \.stl"),
    ("a compiler's .obj", b"\x64\x86\x02\0\0\0", r"1: is not an OBJ file: it is a compiler's object file"),
    ("a truncated position", "v 0 0 0\nv 1 0\n", r"2: v takes 3 coordinates, here are 2 numbers"),
    ("an empty position", "v\n", r"1: v takes 3 coordinates, here are 0 numbers"),
    ("five numbers", "v 1 2 3 4 5\n", r"1: v takes 3 coordinates, here are 5 numbers"),
    ("nine numbers", "v 1 2 3 4 5 6 7 8 9\n", r"1: too many numbers"),
    ("no number", "v 0 0 zero\n", r"1: 'zero' is not a finite number"),
    ("NaN", "v 0 nan 0\n", r"1: 'nan' is not a finite number"),
    ("infinity", "v 0 0 0\nv inf 0 0\n", r"2: 'inf' is not a finite number"),
    ("minus infinity", "v 0 -Infinity 0\n", r"1: '-Infinity' is not a finite number"),
    ("overflow", "v 1e999 0 0\n", r"1: '1e999' is not a finite number"),
    ("a colour above 255", "v 0 0 0 0 1 255.5\n", r"1: colour 255\.5 is not from 0 to 1, nor to 255"),
    ("a colour below 0", "v 0 0 0\nv 0 0 0 -1 0 0\n", r"2: colour -1 is not from 0 to 1, nor to 255"),
    ("a colour of 256 after a weight", "v 0 0 0 1 256 0 0\n", r"1: colour 256 is not from 0 to 1, nor to 255"),
    ("words and no faces", "mtllib a\n" + POINTS + "foo\nbar\n", r"5: 'foo' is not an OBJ keyword"),
    ("materials and no faces", "mtllib a\nl 1\n" + POINTS, r"6: no faces"),
    ("a word, and a face that cannot be drawn", "foo\n" + POINTS + "f 1 2 9\n", r"5: position index 9 .*"),
    ("a comma", "v 0,5 0 0\n", r"1: '0,5' is not a finite number: it takes a point in place of the comma"),
    ("hexadecimal", "v 0x10 0 0\n", r"1: '0x10' is not a finite number"),
    ("two points", "v 1.2.3 0 0\n", r"1: '1\.2\.3' is not a finite number"),
    ("an empty exponent", "v 1e 0 0\n", r"1: '1e' is not a finite number"),
    ("a lone sign", "v - 0 0\n", r"1: '-' is not a finite number"),
    ("a number and more", "v 1f 0 0\n", r"1: '1f' is not a finite number"),
    ("a continuation without a line", POINTS + "f 1 2 3 \\", r"4: '\\' is not a position index"),
    ("the line inside a continued one", POINTS + "f 1 \\\n2 \\\nx\n", r"6: 'x' is not a position index"),
    ("the line after CRLF", (POINTS + "f 1 2 9\n").replace("\n", "\r\n"), r"4: position index 9 .*"),
    ("the line after CR", (POINTS + "f 1 2 9\n").replace("\n", "\r"), r"4: position index 9 .*"),
    ("a coordinate beyond all", "v 1e40 0 0\n", r"1: coordinate of 1e\+40 is too large"),
    ("no area at all", POINTS + "f 1 1 2\nf 3 3 3\n", r"0: all 2 triangles are without area"),
]

# Options of `render` and what stands after `glint: `.
BAD_OPTIONS = [
    (["--size", "0x240"], r"--size 0x240: takes WxH, each from 1 to 1024"),
    (["--size", "320x0"], r"--size 320x0: takes .*"),
    (["--size", "1025x240"], r"--size 1025x240: takes .*"),
    (["--size", "320x1025"], r"--size 320x1025: takes .*"),
    (["--size", "-1x5"], r"--size -1x5: takes .*"),
    (["--size", "320"], r"--size 320: takes .*"),
    (["--size", "320x"], r"--size 320x: takes .*"),
    (["--size", "320x240x1"], r"--size 320x240x1: takes .*"),
    (["--size", "3 20x240"], r"--size 3 20x240: takes .*"),
    (["--size", "99999999999999999999x1"], r"--size 99999999999999999999x1: takes .*"),
    (["--size="], r"--size : takes .*"),
    (["--format", "rgb"], r"--format rgb: takes rgb565, rgb565_be, rgb444, rgb888, grey8, grey4 or mono"),
    (["--eye", "1,2"], r"--eye 1,2: takes x,y,z, each from -32767 to 32767"),
    (["--eye", "1,2,3,4"], r"--eye 1,2,3,4: takes .*"),
    (["--eye", "1,2,nan"], r"--eye 1,2,nan: takes .*"),
    (["--eye", "1,2,"], r"--eye 1,2,: takes .*"),
    (["--eye", "0,0,32768"], r"--eye 0,0,32768: takes .*"),
    (["--at", "1e9,0,0"], r"--at 1e9,0,0: takes .*"),
    (["--up", "0,0,0"], r"--up 0,0,0: takes a direction, and this one's length is 0"),
    (["--up", "x"], r"--up x: takes .*"),
    (["--fov", "0"], r"--fov 0: takes degrees from 1 to 170"),
    (["--fov", "171"], r"--fov 171: takes .*"),
    (["--fov", "inf"], r"--fov inf: takes .*"),
    (["--orthographic", "0"], r"--orthographic 0: takes a height from 1/256 to 32767"),
    (["--orthographic", "32768"], r"--orthographic 32768: takes .*"),
    (["--near", "0"], r"--near 0: takes a distance from 1/65536 to 32767"),
    (["--near", "-1"], r"--near -1: takes .*"),
    (["--rotate-y", "ninety"], r"--rotate-y ninety: takes .*"),
    (["--rotate-y", "40000"], r"--rotate-y 40000: takes .*"),
    (["--scale", "0,1,1"], r"--scale 0,1,1: takes .*"),
    (["--scale", "1,1"], r"--scale 1,1: takes .*"),
    (["--scale", "1,1,40000"], r"--scale 1,1,40000: takes .*"),
    (["--light", "1,2,3"], r"--light 1,2,3: takes dir:, point: or spot: and what the help says"),
    (["--light", "lamp:1,2,3"], r"--light lamp:1,2,3: takes dir:, point: or spot: .*"),
    (["--light", "dir:1,2,3:1,1,1:1"], r"--light dir:1,2,3:1,1,1:1: takes dir:x,y,z\[:r,g,b\]"),
    (["--light", "point:1,2"], r"--light point:1,2: takes x,y,z, .*"),
    (["--light", "point:1,2,3:1,1,17"], r"--light point:1,2,3:1,1,17: takes r,g,b .*"),
    (["--light", "point:1,2,3:1,1,1:-0.1"], r"--light point:1,2,3:1,1,1:-0\.1: takes attenuation from 0 to 32767"),
    (["--light", "point:1,2,3:1,1,1:0:-1"], r"--light point:1,2,3:1,1,1:0:-1: takes attenuation from 0 to 32767"),
    (["--light", "point:1,2,3:1,1,1:x"], r"--light point:1,2,3:1,1,1:x: takes attenuation .*"),
    (["--light", "point:1,2,3:1,1,1:0:0:0"], r"--light point:1,2,3:1,1,1:0:0:0: takes point:x,y,z\[.*"),
    (["--light", "spot:1,2,3"], r"--light spot:1,2,3: takes spot:x,y,z:ax,ay,az:inner,outer.*"),
    (["--light", "spot:1,2,3:0,0,0:1,2"], r"--light spot:1,2,3:0,0,0:1,2: takes a direction, and this one's length is 0"),
    (["--light", "spot:1,2,3:0,0,1:20,15"], r"--light spot:1,2,3:0,0,1:20,15: takes a cone that is not wider inside .*"),
    (["--light", "spot:1,2,3:0,0,1:-1,15"], r"--light spot:1,2,3:0,0,1:-1,15: takes a cone inner,outer in degrees .*"),
    (["--light", "spot:1,2,3:0,0,1:1,181"], r"--light spot:1,2,3:0,0,1:1,181: takes a cone inner,outer .*"),
    (["--light", "spot:1,2,3:0,0,1:15"], r"--light spot:1,2,3:0,0,1:15: takes a cone inner,outer .*"),
    (["--light", "spot:1,2,3:0,0,1:1,2:1,1,1:1:-1"], r"--light spot:1,2,3:0,0,1:1,2:1,1.*: takes attenuation .*"),
    (["--light", "point:1,1,1"] * 9, r"--light point:1,1,1: can be given 8 times at most"),
    (["--camera-lights=1"], r"--camera-lights takes no value"),
    (["--camera-lights", "--light", "point:0,0,32767", "--eye", "0,0,9"],
     r"--camera-lights: a light lies beyond \+-32767 in world space"),
    (["--camera-lights", "--light", "dir:0,0,1", "--light", "spot:0,0,32767:0,0,1:5,9", "--eye", "0,0,-9"],
     r"--camera-lights: a light lies beyond \+-32767 in world space"),
    (["--model", "gouraud"], r"--model gouraud: takes lambert, phong, blinn-phong or unlit"),
    (["--model", "Phong"], r"--model Phong: takes lambert, .*"),
    (["--shading", "smooth"], r"--shading smooth: takes flat, vertex or fragment"),
    (["--combine", "min"], r"--combine min: takes sum or max"),
    (["--gamma", "0"], r"--gamma 0: takes a number from 0\.1 to 10"),
    (["--gamma", "-2.2"], r"--gamma -2\.2: takes .*"),
    (["--gamma", "11"], r"--gamma 11: takes .*"),
    (["--dither=1"], r"--dither takes no value"),
    (["--weights", "size"], r"--weights size: takes area, angle or equal"),
    (["--flat=1"], r"--flat takes no value"),
    (["--frame", "1"], r"unknown option --frame"),
    (["--light", "dir:1,2"], r"--light dir:1,2: takes .*"),
    (["--light", "dir:0,0,0"], r"--light dir:0,0,0: takes a direction, and this one's length is 0"),
    (["--light", "dir:1,2,3:"], r"--light dir:1,2,3:: takes .*"),
    (["--light", "dir:1,2,3:1,1"], r"--light dir:1,2,3:1,1: takes .*"),
    (["--light", "dir:1,2,3:1,1,17"], r"--light dir:1,2,3:1,1,17: takes .*"),
    (["--light", "dir:1,1,1"] * 9, r"--light dir:1,1,1: can be given 8 times at most"),
    (["--ambient", "-0.1"], r"--ambient -0\.1: takes r,g,b or one grey level, each from 0 to 16"),
    (["--ambient", "1,1"], r"--ambient 1,1: takes .*"),
    (["--diffuse", "16.1,0,0"], r"--diffuse 16\.1,0,0: takes .*"),
    (["--specular", "a,b,c"], r"--specular a,b,c: takes .*"),
    (["--background", "0,0,-1"], r"--background 0,0,-1: takes .*"),
    (["--diffuse", "8", "--light", "dir:0,0,1:4,4,4"], r".*[Cc]olour.*"),
    (["--shininess", "-1"], r"--shininess -1: takes an exponent from 0 to 32767"),
    (["--shininess", "-0.001"], r"--shininess -0\.001: takes .*"),
    (["--shininess", "40000"], r"--shininess 40000: takes .*"),
    (["--opacity", "1.1"], r"--opacity 1\.1: takes a number from 0 to 1"),
    (["--blend", "glass"], r"--blend glass: takes none, alpha, add or dithered"),
    (["--fog", "5"], r"--fog 5: takes START:END\[:r,g,b\], depths from 0 to 32767, the second above the first"),
    (["--fog", "-1:5"], r"--fog -1:5: takes START:END\[:r,g,b\], depths from 0 to 32767, the second above the first"),
    (["--fog", "5:5"], r"--fog 5:5: takes START:END\[:r,g,b\], depths from 0 to 32767, the second above the first"),
    (["--fog", "1:5:1,2"], r"--fog 1:5:1,2: takes r,g,b or one grey level, each from 0 to 16"),
    (["--fog-type", "thick"], r"--fog-type thick: takes linear or squared"),
    (["--samples", "4"], r"--samples 4: takes 1 or 2x2"),
    (["--viewer", "near"], r"--viewer near: takes infinite or local"),
    (["--tile", "32"], r"--tile 32: takes WxH, each 8, 16, 32 or 64"),
    (["--tile", "24x32"], r"--tile 24x32: takes .*"),
    (["--tile", "128x8"], r"--tile 128x8: takes .*"),
    (["--arena", "0"], r"--arena 0: takes bytes, from 1 to 1073741824"),
    (["--arena", "1.5"], r"--arena 1\.5: takes .*"),
    (["--arena", "1K"], r"--arena 1K: takes .*"),
    (["--crease", "181"], r"--crease 181: takes degrees from 0 to 180"),
    (["--crease", "-1"], r"--crease -1: takes .*"),
    (["--stats=1"], r"--stats takes no value"),
    (["--colour", "1"], r"unknown option --colour"),
    (["-x"], r"unknown option -x"),
    (["--name", "a"], r"unknown option --name"),
    (["--siz", "10x10"], r"unknown option --siz: did you mean --size\?"),
    (["--shinyness=3"], r"unknown option --shinyness=3: did you mean --shininess\?"),
    (["another.obj"], r"unexpected argument 'another\.obj'"),
    (["--fov"], r"--fov takes a value: DEG"),
    (["--eye", "0,3,0"], r"--eye, --at and --up lie on one line"),
]

BAD_SHAPES = [
    ("torus:", r"torus takes two counts, as in torus:24x12"), ("torus:24", r"torus takes two counts, as in torus:24x12"),
    ("torus:2x12", r"torus takes counts from 3x3, and at most 65536 vertices"),
    ("torus:300x300", r"torus takes counts from 3x3, and at most 65536 vertices"),
    ("torus:99999999x3", r"torus takes counts from 3x3, .*"), ("torus:24x-12", r"torus takes counts from 3x3, .*"),
    ("torus:24x12 ", r"torus takes two counts, .*"), ("sphere:3x1", r"sphere takes counts from 3x2, .*"),
    ("sphere:axb", r"sphere takes two counts, .*"), ("cylinder:3x0", r"cylinder takes counts from 3x1, .*"),
    ("cylinder-capped:2x1", r"cylinder-capped takes counts from 3x1, .*"), ("cone:3x", r"cone takes two counts, .*"),
    ("plane:0x1", r"plane takes counts from 1x1, .*"), ("torus:24x12:", r"torus takes 2 sizes above 0, up to 8192"),
    ("torus:24x12:1", r"torus takes 2 sizes above 0, up to 8192"), ("torus:24x12:1,2,3", r"torus takes 2 sizes .*"),
    ("torus:24x12:1,0", r"torus takes 2 sizes .*"), ("sphere:8x8:-1", r"sphere takes 1 size above 0, up to 8192"),
    ("sphere:8x8:8193", r"sphere takes 1 size .*"), ("sphere:8x8:1:1", r"sphere takes 1 size .*"),
    ("torus:8x8:8000,8000", r"torus: its sizes come to more than 8192"), ("box:", r"box takes 3 sizes above 0, up to 8192"),
    ("box:1,1", r"box takes 3 sizes .*"), ("box:1,1,x", r"box takes 3 sizes .*"),
]


def test_bad_models(host):
    for name, text, pattern in BAD_MODELS:
        host.write("bad.obj", text)
        host.refuses(f"render {name}", ["render", "bad.obj", "-o", "out.png"], r"bad\.obj:" + pattern)
        host.refuses(f"convert {name}", ["convert", "bad.obj", "-o", "out.h"], r"bad\.obj:" + pattern)
    host.refuses("info of a bad model", ["info", "bad.obj"], r"bad\.obj:0: .*")


def test_files_that_cannot_be_read(host):
    for command, output in (("render", ["-o", "out.png"]), ("info", []), ("convert", ["-o", "out.h"])):
        host.refuses(f"{command} a missing file", [command, "missing.obj", *output],
                     r"missing\.obj:0: cannot be opened: No such file or directory")
        os.mkdir(host.path("folder.obj"))
        host.refuses(f"{command} a folder", [command, "folder.obj", *output], r"folder\.obj:0: cannot be (read|opened): .+")
        os.rmdir(host.path("folder.obj"))
    host.refuses("a line end in a name", ["info", "a\nb"], r"a\?b:0: cannot be opened: .+")


def test_bad_options(host):
    host.write("good.obj", SQUARE)
    for options, pattern in BAD_OPTIONS:
        host.refuses(f"render {' '.join(options)}", ["render", "good.obj", "-o", "out.png", *options], "glint: " + pattern)


def test_bad_shapes(host):
    for name, pattern in BAD_SHAPES:
        host.refuses(f"render {name}", ["render", name, "-o", "out.png"], name + ":0: " + pattern)


def test_bad_commands(host):
    host.write("good.obj", SQUARE)
    for arguments, pattern in [
            ([], r"a command is missing: see glint help"), (["draw"], r"unknown command 'draw': see glint help"),
            (["render", "-o", "x.png"], r"render: a model is missing: .*"),
            (["render", "good.obj"], r"render: the file to write is missing: -o FILE"),
            (["render", "good.obj", "-o"], r"-o takes a value: FILE"),
            (["render", "good.obj", "-o", "x.jpg"], r"-o: pictures are PNG files: name it \.png, not \.jpg"),
            (["scene", "teapot", "-o", "a.png/x.JPEG"], r"-o: pictures are PNG files: name it \.png, not \.JPEG"),
            (["render", "good.obj", "-o", ""], r"-o : takes the name of a file"),
            (["convert", "good.obj"], r"convert: the file to write is missing: -o FILE"),
            (["convert"], r"convert: a model is missing: .*"), (["info"], r"info: a model is missing: .*"),
            (["info", "good.obj", "-o", "x"], r"unknown option -o"),
            (["convert", "good.obj", "-o", "x.h", "--name", "1st"], r"--name 1st: takes a C identifier .*"),
            (["convert", "good.obj", "-o", "x.h", "--name", "a-b"], r"--name a-b: takes a C identifier .*"),
            (["convert", "good.obj", "-o", "x.h", "--name", ""], r"--name : takes a C identifier .*"),
            (["convert", "good.obj", "-o", "x.h", "--licence", "*/"], r"--licence \*/: takes an SPDX licence expression"),
            (["scene"], r"scene: a scene is missing: see glint scene --list"),
            (["scene", "-o", "x.png"], r"scene: a scene is missing: .*"),
            (["scene", "teapot"], r"scene: the file to write is missing: -o FILE"),
            (["scene", "kettle", "-o", "x.png"], r"unknown scene 'kettle': see glint scene --list"),
            (["scene", "teapo", "-o", "x.png"], r"unknown scene 'teapo': .*"),
            (["scene", "", "-o", "x.png"], r"unknown scene '': .*"),
            (["scene", "teapot:", "-o", "x.png"], r"scene teapot has no variant '': see glint scene --list"),
            (["scene", "teapot:blue", "-o", "x.png"], r"scene teapot has no variant 'blue': see glint scene --list"),
            (["scene", "teapot:vertex:vertex", "-o", "x.png"], r"scene teapot has no variant 'vertex:vertex': .*"),
            (["scene", "teapot", "torus:8x8", "-o", "x.png"], r"unexpected argument 'torus:8x8'"),
            (["scene", "teapot", "-o", "x.png", "--frame", "-1"], r"--frame -1: takes a frame, from 0 to 1000000"),
            (["scene", "teapot", "-o", "x.png", "--frame", "1.5"], r"--frame 1\.5: takes a frame, .*"),
            (["scene", "teapot", "-o", "x.png", "--animate", "0"], r"--animate 0: takes a number of frames, .*"),
            (["scene", "teapot", "-o", "x.png", "--animate", "1001"], r"--animate 1001: takes a number of frames, .*"),
            (["scene", "teapot", "-o", "x.png", "--animate", "2", "--frame", "1"],
             r"scene: --frame and --animate exclude each other"),
            (["scene", "teapot", "-o", "x.png", "--animate", "2", "--stats"],
             r"scene: --stats and --animate exclude each other"),
            (["scene", "teapot", "-o", "x.png", "--size", "0x1"], r"--size 0x1: takes .*"),
            (["scene", "teapot", "-o", "x.png", "--labels=1"], r"--labels takes no value"),
            (["render", "good.obj", "-o", "x.png", "--labels"], r"unknown option --labels"),
            (["scene", "teapot", "-o", "x.png", "--model", "phong"], r"unknown option --model"),
            (["scene", "teapot", "-o", "x.png", "--arena", "100"], r"--arena 100: this scene takes \d+ bytes, .*"),
            (["scene", "teapot", "-o", "x.png", "--animate", "2", "--arena", "100"], r"--arena 100: this scene takes .*"),
            (["demo"], r"demo: the file to write is missing: -o FILE"),
            (["demo", "good.obj", "-o", "x.png"], r"unexpected argument 'good\.obj'")]:
        host.refuses(f"glint {' '.join(arguments)}", arguments, "glint: " + pattern)


def test_extreme_scenes_are_refused_or_drawn(host):
    """Within what options take, the library may still refuse: by its sentence, never by a crash."""
    host.write("far.obj", "v -32766 -32766 0\nv 32766 -32766 0\nv 0 32766 0\nf 1 2 3\n")
    for options in (["--scale", "32767"], ["--scale", "1,1,0.00002"], ["--eye", "0,0,32767"], ["--near", "32767"],
                    ["--eye", "32767,32767,32767", "--at", "-32767,-32767,-32767"], ["--fov", "170"], ["--fov", "1"],
                    ["--shininess", "32767"], ["--shininess", "0"], ["--scale", "0.00002"]):
        run = host.run("render", "far.obj", *options, "-o", "far.png")
        noted = run.stderr == "" or re.fullmatch(r"far\.obj:\d: note: .* at the origin\n", run.stderr) is not None
        drawn = run.returncode == 0 and noted and os.path.exists(host.path("far.png"))
        refused = run.returncode == 2 and run.stderr.startswith("glint: ") and run.stderr.count("\n") == 1
        host.check(f"far.obj {' '.join(options)}", drawn or refused, f"{run.returncode} {run.stderr!r}")
        if os.path.exists(host.path("far.png")):
            os.remove(host.path("far.png"))


def limit_memory(megabytes):
    resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20,) * 2)


def test_long_lines(host):
    """Lines as long as the file take no more memory than it."""
    files = host.files()
    for name, text in (("comment", POINTS + "f 1 2 3\n#"), ("word", POINTS + "f 1 2 3\nword")):
        host.write("long.obj", text)
        os.truncate(host.path("long.obj"), 100000000)
        run = host.run("info", "long.obj", before=lambda: limit_memory(256))
        host.check(f"a {name} of 100 MB", run.returncode == 0 and len(run.stderr) < 100, f"{run.returncode} {run.stderr[:200]}")
    host.write("long.obj", POINTS + "f" + " 1" * 60000000)
    host.refuses("a face of 60 million corners", ["info", "long.obj"], r"long\.obj:4: a face of more than 65536 corners",
                 before=lambda: limit_memory(256))
    os.remove(host.path("long.obj"))
    host.equal("nothing is left", host.files(), files)


def test_one_triangle_many_times(host):
    host.write("same.obj", POINTS + "f 1 2 3\n" * 4095)
    host.equal("as often as is taken", host.run("info", "same.obj").returncode, 0)
    host.write("same.obj", POINTS + "f 1 2 3\n" * 4096)
    for command in (["info"], ["render", "-o", "out.png"], ["convert", "-o", "out.h"]):
        host.refuses(f"once more: {command[0]}", [*command, "same.obj"],
                     r"same\.obj:0: 4096 triangles on 3 vertices: more than the 1024 a vertex that are taken")


def test_what_is_too_large(host):
    """Limits, and a message, in place of minutes and gigabytes."""
    turns = [.2 * i for i in range(512)]
    spiral = [(t * math.cos(t), t * math.sin(t)) for t in turns] + [((t - .5) * math.cos(t), (t - .5) * math.sin(t)) for t in turns[::-1]]
    many = r"\d+: more than the 4000000 positions, normals or triangles that are read"
    for name, text, pattern in [
            ("corners", POINTS + "f" + " 1 2 3" * 30000, r"4: a face of more than 65536 corners"),
            ("triangles", POINTS + ("f" + " 1 2 3" * 20000 + "\n") * 70, many),
            ("positions", "v 0 0 0\n" * 4000001, many),
            ("ears", "".join("v %.9g %.9g 0\n" % p for p in spiral) + ("f " + " ".join(map(str, range(1, 1025))) + "\n") * 100,
             r"\d+: faces that are not convex have too many corners: make them triangles first")]:
        host.write("large.obj", text)
        host.refuses(f"too many {name}", ["info", "large.obj"], r"large\.obj:" + pattern)
    host.write("large.obj", POINTS + "f 1 2 3\n")
    os.truncate(host.path("large.obj"), 500000001)
    host.refuses("a file of 500 MB", ["info", "large.obj"], r"large\.obj:0: is larger than the 500 MB that are read")
    os.truncate(host.path("large.obj"), 1 << 30)
    host.refuses("a file of 1 GB, which is not read", ["info", "large.obj"], r"large\.obj:0: is larger than the 500 MB that are read",
                 before=lambda: limit_memory(64))
    host.refuses("a stream without end", ["info", "/dev/zero"], r"/dev/zero:0: is larger than the 500 MB that are read",
                 before=lambda: limit_memory(1500))
    host.write("many.mtl", "newmtl a\n" * 65537)
    host.write("long.mtl", "#" * 4000001)
    host.write("large.obj", "mtllib " + "none.mtl " * 99 + "\nmtllib many.mtl\nmtllib long.mtl\n" + POINTS + "f 1 2 3\n")
    run = host.run("info", "large.obj")
    host.equal("files of materials", run.stderr.splitlines(), [
        "large.obj:1: warning: 'none.mtl' cannot be read: its materials are missing (and 63 more)",
        "large.obj:1: warning: 'none.mtl' is skipped: no more than 64 files of materials are read (and 36 more)"])
    host.write("large.obj", "mtllib many.mtl\nmtllib long.mtl\n" + POINTS + "f 1 2 3\n")
    run = host.run("info", "large.obj")
    host.equal("large files of materials", run.stderr.splitlines(), [
        "large.obj:2: warning: 'long.mtl' cannot be read: its materials are missing",
        "many.mtl:65537: warning: 'newmtl' is skipped: there are 65536 materials before it"])
    names = list(range(1024)) * 2
    host.write("large.obj", POINTS + "".join(f"usemtl {n}\nf 1 2 3\n" for n in names))
    host.equal("1024 materials", host.run("info", "large.obj").returncode, 0)
