# SPDX-License-Identifier: MIT
"""Writes the web page whole: page.py GLINT.wasm FOLDER

What is in port/web/page/ is copied. FOLDER/data.js holds the rest: the program, the models that it brings along, and the
rows of docs/ that the page shows. Both of the first are deflated, by zopfli, and in base 91, so that the page opens from disk too.
"""
import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "port/web/page"
MODELS = ROOT / "examples/models"

# Those of the example scenes.
NAMES = ("teapot pumpkin-merry pumpkin-merry-lining pumpkin-grim pumpkin-grim-lining pumpkin stem tree tombstone stars "
         "glow flame bat-wing picket cylinder-skewed").split()

STREAMS = "x y z nx ny nz corners vertex normal".split()


# Printable characters but quotes and the backslash.
DIGITS = "".join(chr(code) for code in range(33, 127) if chr(code) not in "\"'\\")


def base91(data):
    """Two digits for each 13 bits, lowest first, or for 14 where these are less than 91 * 91 - 2^13 (J. Henke, 2000)."""
    text, bits, count = [], 0, 0
    for byte in data:
        bits |= byte << count
        count += 8
        if count > 13:
            number = bits & 0x1fff
            taken = 13
            if number < len(DIGITS) ** 2 - 0x2000:
                number = bits & 0x3fff
                taken = 14
            bits >>= taken
            count -= taken
            text.append(DIGITS[number % 91] + DIGITS[number // 91])
    if count:
        text.append(DIGITS[bits % 91] + (DIGITS[bits // 91] if count > 7 or bits > 90 else ""))
    return "".join(text)


def packed(data):
    """It deflated, in base 91."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(data)
        file.flush()
        small = subprocess.run(["zopfli", "--deflate", "-c", file.name], check=True, stdout=subprocess.PIPE).stdout
    return base91(small)


# ---- Models: numbers that are small where neighbours are alike

def decimals(rows):
    return max([len(text.partition(".")[2]) for row in rows for text in row], default=0)


def whole(rows, digits):
    return [[int(round(float(text) * 10 ** digits)) for text in row] for row in rows]


class Model:
    """What an OBJ file has of v, vn and f; corners are v//n."""

    def __init__(self, name):
        rows = {"v": [], "vn": [], "f": []}
        for line in (MODELS / f"{name}.obj").read_text().splitlines():
            words = line.split("#")[0].split()
            if words:
                rows[words[0]].append(words[1:])
        self.name = f"{name}.obj"
        self.digits = decimals(rows["v"]), decimals(rows["vn"])
        self.points = whole(rows["v"], self.digits[0])
        self.normals = whole(rows["vn"], self.digits[1])
        self.faces = [[[int(number) for number in corner.split("//")] for corner in face] for face in rows["f"]]

    def head(self):
        return [self.name, *self.digits, len(self.points), len(self.normals), len(self.faces)]

    def put(self, streams):
        before = [0, 0, 0]
        for point in self.points:
            for axis in range(3):
                streams["xyz"[axis]].append(point[axis] - before[axis])
            before = point
        before = [0, 0, 0]
        for normal in self.normals:
            streams["nx"].append(normal[0] - before[0])
            streams["ny"].append(normal[1] - before[1])
            # the third of a unit vector: how far from what the others leave, and its sign
            left = math.isqrt(max(0, 10 ** (2 * self.digits[1]) - normal[0] ** 2 - normal[1] ** 2))
            streams["nz"].append(2 * (abs(normal[2]) - left) + (normal[2] < 0))
            before = normal
        new = 1
        for face in self.faces:
            streams["corners"].append(len(face))
            for corner in face:
                streams["vertex"].append(new - corner[0])
                new = max(new, corner[0] + 1)
                streams["normal"].append(corner[1] - corner[0])


def models():
    """Heads, sizes of the streams, and the streams: the lowest bytes of all its numbers, the middle and the highest ones."""
    streams = {name: [] for name in STREAMS}
    heads = []
    for name in NAMES:
        model = Model(name)
        model.put(streams)
        heads.append(model.head())
    data = bytearray()
    for numbers in streams.values():
        signless = [2 * number if number >= 0 else -2 * number - 1 for number in numbers]
        for shift in (0, 8, 16):
            data += bytes(number >> shift & 255 for number in signless)
        assert max(signless) < 1 << 24
    return {"heads": heads, "sizes": [len(streams[name]) for name in STREAMS], "data": packed(bytes(data))}


# ---- Rows

def rows(name):
    with open(ROOT / "docs" / name, newline="") as file:
        return list(csv.DictReader(file))


def frames():
    """Every choice of shading for one picture: PSNR, and millions of instructions on each core."""
    def is_shown(row):
        return (row["scene"], row["size"], row["format"]) == ("torus2304", "320x240", "rgb565")

    costs = {}
    for row in filter(is_shown, rows("frame-instructions.csv")):
        costs.setdefault(row["choice"], {})[row["cpu"]] = round(int(row["instructions"]) / 1e6, 3)
    return [[row["choice"], float(row["psnr_db"]), costs[row["choice"]]] for row in filter(is_shown, rows("frame-accuracy.csv"))
            if row["against"] == "scene" and row["p"] == "32" and row["choice"] in costs]


def others():
    return [[f"{row['library']}, {row['mode']}", float(row["psnr_db"]), row["cpu"], float(row["million_instructions"])]
            for row in rows("other-libraries.csv")
            if (row["scene"], row["size"]) == ("torus2304", "320x240") and row["psnr_db"]]


def shading():
    return [[row["evaluation"], int(row["triangles"]), float(row["rms"]), round(int(row["instructions"]) / 1e6, 3)]
            for row in rows("charts/shading.csv") if row["format"] == "rgb565"]


def flash():
    """Bytes of flash of each feature, built for size and for speed, on Cortex-M3 and ARMv6-M."""
    tables = []
    for part in (ROOT / "docs/features.md").read_text().split("\n## Built for ")[1:]:
        table = {}
        for line in part.splitlines():
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            numbers = [re.match(r"\d+", cells[i]) if i < len(cells) else None for i in (1, 5)]
            if all(numbers):
                table[cells[0]] = [int(number.group()) for number in numbers]
        tables.append(table)
    return {"size": tables[0], "speed": tables[1]}


def main():
    program, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    version = re.findall(r"#define GLINT_VERSION_\w+ (\d+)", (ROOT / "src/glint.h").read_text())
    data = {"version": ".".join(version), "frames": frames(), "others": others(), "shading": shading(), "flash": flash(),
            "parts": [[row[key] for key in ("part", "cpu", "core", "core_mhz", "bus_mhz")] for row in rows("parts.csv")],
            "models": models(), "program": packed(program.read_bytes())}
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    for file in sorted(PAGE.iterdir()):
        shutil.copyfile(file, folder / file.name)
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(value, separators=(',', ':'))}" for name, value in data.items())
    (folder / "data.js").write_text("// SPDX-License-Identifier: MIT\n// Made by `make figures`, not to be edited.\n"
                                    f'"use strict";\nconst DATA = {{\n{lines}\n}};\n')


main()
