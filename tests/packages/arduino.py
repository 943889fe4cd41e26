# SPDX-License-Identifier: MIT
"""Arduino and PlatformIO: manifests, and sketches built by arduino-builder on a platform of declarations."""
import fnmatch
import json
import os
import re
import zipfile

from tree import HERE, check, find, path, paths, read, read_netpbm, run, version

HARDWARE = os.path.join(HERE, "arduino", "hardware")
PLATFORM = os.path.join(HARDWARE, "glint", "test")

# What Arduino's IDE (1.x) does not load a library without, and what its library manager wants beside.
FIELDS = ["name", "version", "author", "maintainer", "sentence", "paragraph", "url", "category", "architectures"]
CATEGORIES = ["Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing", "Data Storage",
              "Data Processing", "Other"]


def library(folder):
    """The library as it is installed from the ZIP file."""
    run("python3", path("tools/packages/arduino.py"), folder, version())
    with zipfile.ZipFile(os.path.join(folder, "glint-%s.zip" % version())) as packed:
        packed.extractall(os.path.join(folder, "libraries"))


def compile_sketch(b, sketch, board):
    """By arduino-builder; @return the ELF file."""
    folder = b.folder("arduino-%s-%s" % (sketch, board))
    os.makedirs(os.path.join(folder, "out"))
    library(folder)
    run("arduino-builder", "-compile", "-quiet", "-warnings", "all", "-hardware", "/usr/share/arduino-builder", "-hardware",
        HARDWARE, "-tools", "/usr/bin", "-libraries", os.path.join(folder, "libraries"), "-fqbn", "glint:test:" + board,
        "-build-path", os.path.join(folder, "out"), path("examples", "arduino", sketch, sketch + ".ino"))
    return os.path.join(folder, "out", sketch + ".ino.elf")


def sketch(b, name, panel, turn):
    """What the sketch sends puts on the panel what its scene looks like."""
    got = b.glass(panel, run(compile_sketch(b, name, "host")), turn)
    folder = b.folder("sketch-" + name)
    program, picture = os.path.join(folder, "sketch"), os.path.join(folder, "expected.ppm")
    libraries = ("SPI", "Wire", "TFT_eSPI", "LovyanGFX")
    include = ["-I" + os.path.join(PLATFORM, at) for at in ["cores/test"] + ["libraries/" + library for library in libraries]]
    sources = [os.path.join(HERE, "arduino", "sketch.cpp"), os.path.join(PLATFORM, "cores/test/main.cpp")] + \
        [os.path.join(PLATFORM, "libraries", library, library + ".cpp") for library in libraries]
    run("g++", "-std=gnu++11", *include, "-I" + path("src"), '-DSKETCH="%s"' % path("examples/arduino", name, name + ".ino"),
        *sources, os.path.join(b.build, "host", "libglint.a"), "-o", program)
    run(program, picture)
    expected = read_netpbm(picture)
    check(sum(1 for byte in expected[3] if byte) > 500, name + ": draws next to nothing")
    check(got == expected, name + ": another picture on the panel than in memory")


def test_arduino_torus(b):
    sketch(b, "Torus", "ili9341", 90)


def test_arduino_tft_espi(b):
    sketch(b, "TorusTFT_eSPI", "ili9341", 90)


def test_arduino_lovyangfx(b):
    sketch(b, "TorusLovyanGFX", "ili9341", 90)


def test_arduino_pyramid(b):
    sketch(b, "Pyramid", "ssd1306", 0)


def test_arduino_firmware(b):
    """Compiled for a Cortex-M0, a sketch has what it names, and no other."""
    elf = compile_sketch(b, "Torus", "m0")
    symbols = run("arm-none-eabi-nm", elf)
    check("glint_format_rgb565_be" in symbols, "no pixel format")
    check(os.path.exists(os.path.join(os.path.dirname(elf), "libraries", "glint", "panel", "ili9341.c.o")), "no drivers")
    check("glint_light_spot" not in symbols and "glint_format_mono" not in symbols, "what nothing names")


def test_arduino_manifest(_):
    lines = [line.split("=", 1) for line in read("library.properties").splitlines()]
    check(all(len(line) == 2 for line in lines), "a line without =")
    fields = dict(lines)
    check(len(fields) == len(lines), "a field twice")
    for name in FIELDS:
        check(name in fields, "without " + name)
        check(fields[name], name + " is empty")
    check(set(fields) <= set(FIELDS + ["includes", "depends", "dot_a_linkage", "precompiled", "ldflags"]), "unknown fields")
    check(fields["version"] == version(), "version")
    check(re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 _.-]{0,62}", fields["name"]), "name")
    check(fields["category"] in CATEGORIES, "category")
    for header in fields["includes"].split(","):
        check(os.path.exists(path("src", header)), header)


def test_arduino_tree(_):
    """The IDE takes a folder below examples/ for a sketch by a file of its name; no other folder has one."""
    sketches = find("examples/arduino/*/*.ino")
    check(len(sketches) == 4, "sketches: %s" % sketches)
    for name in find("**/*.ino") + find("*/*/*.ino") + find("*/*/*/*.ino"):
        if not name.startswith("build/"):
            check(name in sketches, name + ": a stray sketch")
    for name in sketches:
        folder = os.path.basename(os.path.dirname(name))
        check(os.path.basename(name) == folder + ".ino", name + ": not of its folder's name")
    check(not os.path.exists(path("utility")), "with src/, a folder utility is not allowed")


def test_arduino_keywords(b):
    """The IDE colours a word by a tab and its kind."""
    folder = b.folder("arduino-keywords")
    library(folder)
    with open(os.path.join(folder, "libraries", "glint", "keywords.txt"), encoding="utf-8") as file:
        kinds = dict(line.split("\t") for line in file.read().splitlines())
    for name, kind in (("glint_scene", 1), ("glint_panel", 1), ("glint_render", 2), ("glint_lines_draw", 2)):
        check(kinds.get(name) == "KEYWORD%d" % kind, name)
    for name in ("GLINT_ONE", "GLINT_Q16", "GLINT_ERROR_ARENA", "glint_per_vertex", "glint_gamma_srgb", "glint_panel_ili9341"):
        check(kinds.get(name) == "LITERAL1", name)
    check(set(kinds.values()) == {"KEYWORD1", "KEYWORD2", "LITERAL1"} and len(kinds) > 200, "%d words" % len(kinds))


def test_addresses(_):
    """Every package names the same home."""
    home = re.search(r"^url=(https://.+)$", read("library.properties"), re.MULTILINE).group(1)
    json_fields, idf = json.loads(read("library.json")), read("idf_component.yml")
    check(json_fields["homepage"] == home and json_fields["repository"]["url"].startswith(home), "library.json")
    check("\nurl: %s\nrepository: %s/" % (home, home) in idf, "idf_component.yml")
    check("<url>%s/</url>" % home in read("tools/packages/pack.py"), "pack.py")


def test_platformio_manifest(_):
    manifest = json.loads(read("library.json"))
    check(manifest["version"] == version(), "version")
    check(re.fullmatch(r"[^:;/,@<>]{1,100}", manifest["name"]), "name")
    check(0 < len(manifest["description"]) <= 1000, "description")
    check(all(re.fullmatch(r"[a-z\d\-_+. ]{1,50}", word) for word in manifest["keywords"]), "keywords")
    check(all(author["name"] for author in manifest["authors"]), "authors")
    check(manifest["license"] == "MIT", "license")
    for header in manifest["headers"]:
        check(os.path.exists(path(manifest["build"]["includeDir"], header)), header)
    for name in manifest["export"]["include"]:
        check(os.path.exists(path(name)), name)
    chosen = [name for name in find("src/**/*") + find("src/*/*") for add in manifest["build"]["srcFilter"]
              if fnmatch.fnmatch(os.path.relpath(name, manifest["build"]["srcDir"]), add[2:-1])]
    check(sorted(set(chosen)) == find("src/*/*.c"), "srcFilter chooses other files")
    examples = [os.path.join(example["base"], name) for example in manifest["examples"] for name in example["files"]]
    check(sorted(examples) == find("examples/arduino/*/*.ino"), "examples")
