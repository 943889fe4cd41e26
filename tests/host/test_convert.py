# SPDX-License-Identifier: MIT
"""`convert`: the header, its numbers against the model, and the headers that are checked in."""
import os
import re
import shutil
import subprocess

from harness import MODELS, ROOT, SQUARE, torus_text

STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-I", os.path.join(ROOT, "src"), "-I", "."]
TOO_LARGE = r"big\.obj:0: warning: .* MB of flash, more than microcontrollers have: .*\n"


def convert(host, *arguments, warning=""):
    """The header that `convert` writes, with no warning, or one that the pattern matches. Its names are the model's."""
    name = os.path.splitext(os.path.basename(arguments[0]))[0] + ".h"
    run = host.run("convert", *arguments, "-o", name)
    if run.returncode != 0 or re.fullmatch(warning, run.stderr) is None:
        raise AssertionError(f"convert {arguments}: {run.returncode} {run.stderr} {run.stdout}")
    text = host.read(name).decode()
    os.remove(host.path(name))
    return text


def array(text, name):
    """The triples of an array, and how many the header declares."""
    match = re.search(r"static const u?int16_t " + name + r"\[(\d+)\]\[3\] = \{(.*?)\n\};", text, re.DOTALL)
    triples = [tuple(int(v) for v in t.split(",")) for t in re.findall(r"\{([^{}]*)\}", match.group(2))]
    return triples, int(match.group(1))


def mesh(text, name):
    """Positions, normals, triangles, offset and extent, as numbers of object space."""
    body = re.search(r"static const glint_mesh " + name + r"_mesh = \{(.*?)\n\};", text, re.DOTALL).group(1)
    (offset, extent) = [[int(v) / 65536 for v in t.split(",")] for t in re.findall(r"\{([^{}]*)\}", body)[:2]]
    steps, _ = array(text, name + "_positions")
    positions = [tuple(offset[a] + extent[a] * step[a] / 32768 for a in range(3)) for step in steps]
    normals = [tuple(v / 32767 for v in n) for n in array(text, name + "_normals")[0]]
    return positions, normals, array(text, name + "_triangles")[0], offset, extent


def test_checked_in_meshes(host):
    """Each says how it was made."""
    folder = os.path.join(ROOT, "examples", "meshes")
    headers = sorted(file for file in os.listdir(folder) if file.endswith(".h"))
    host.check("there are meshes", len(headers) > 20)
    for header in headers:
        with open(os.path.join(folder, header), encoding="utf-8") as file:
            text = file.read()
        model, *options = re.search(r"^ \*     glint convert (.+)$", text, re.MULTILINE)[1].split()
        path = os.path.join(MODELS, model)
        host.check(f"examples/meshes/{header} is up to date (make meshes)",
                   text == convert(host, path if os.path.exists(path) else model, *options))


def test_same_input_same_bytes(host):
    host.write("a.obj", SQUARE)
    first = convert(host, "a.obj")
    host.equal("convert twice", convert(host, "a.obj"), first)
    os.mkdir(host.path("sub"))
    shutil.copy(host.path("a.obj"), host.path("sub/a.obj"))
    host.run("convert", "sub/a.obj", "-o", "sub/a.h")
    host.equal("convert elsewhere", host.read("sub/a.h").decode(), first)
    shutil.rmtree(host.path("sub"))
    host.write("a.obj", SQUARE + "# more\n")
    host.check("the hash is the file's", convert(host, "a.obj") != first)


def fnv1a(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & (1 << 64) - 1
    return f"{value:016x}"


def test_head(host):
    host.write("my model.2.obj", SQUARE)
    text = convert(host, "my model.2.obj", "--crease", "30", "--scale", "2,2,2", "--double-sided", "--licence", "CC0-1.0")
    host.check("default name", "static const glint_mesh my_model_2_mesh = {" in text)
    host.check("guard", "#ifndef MY_MODEL_2_MESH_H\n#define MY_MODEL_2_MESH_H\n" in text and text.endswith("\n#endif\n"))
    host.check("hash", fnv1a(SQUARE.encode()) in text)
    host.check("command line", '\n *     glint convert "my model.2.obj" --crease 30 --scale 2,2,2 --double-sided --licence CC0-1.0\n' in text)
    host.check("licence", text.startswith("/* SPDX-License-" "Identifier: CC0-1.0 */\n"))
    host.check("flag", "    GLINT_MESH_DOUBLE_SIDED,\n    0,\n    0, /* no colours */\n    0, /* no clusters */\n    0, /* no layout */\n" in text)
    host.check("Q formats", "Q16.16" in text and "Q15" in text and "offset + extent * step / 32768" in text)
    host.check("hash of a shape is its name's", fnv1a(b"torus:24x12") in convert(host, "torus:24x12"))
    host.write("*_ \\.obj", SQUARE)
    host.check("a name that would end the comment", convert(host, "*_ \\.obj").count("*/") == 9)
    host.write("9.obj", SQUARE)
    host.check("a name that begins with a digit", "static const glint_mesh m9_mesh = {" in convert(host, "9.obj"))


def obj_triangles(path):
    """Corner positions and normals of a file of triangles with v//n, read plainly."""
    positions, normals, triangles = [], [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                positions.append(tuple(float(v) for v in words[1:4]))
            elif words and words[0] == "vn":
                normals.append(tuple(float(v) for v in words[1:4]))
            elif words and words[0] == "f":
                triangles.append([(positions[int(c.split("/")[0]) - 1], normals[int(c.split("/")[2]) - 1])
                                  for c in words[1:]])
    return triangles


def test_numbers_against_the_model(host):
    for name in ("teapot", "featuretype"):
        path = os.path.join(MODELS, name + ".obj")
        positions, normals, triangles, _, extent = mesh(convert(host, path, "--no-clusters"), name)
        source = obj_triangles(path)
        host.equal(f"{name}: triangles", len(triangles), len(source))
        moved = turned = 0.0
        for indices, corners in zip(triangles, source):
            for index, (position, normal) in zip(indices, corners):
                length = sum(v * v for v in normal) ** 0.5
                moved = max([moved] + [abs(positions[index][a] - position[a]) / extent[a] for a in range(3)])
                turned = max([turned] + [abs(normals[index][a] - normal[a] / length) for a in range(3)])
        host.check(f"{name}: positions within half a step", moved <= 0.5001 / 32768, f"{moved * 32768} steps")
        host.check(f"{name}: normals within half a step", turned <= 0.5001 / 32767, f"{turned * 32767} steps")
        host.equal(f"{name}: no vertex twice", len(set(zip(positions, normals))), len(positions))
        host.equal(f"{name}: no vertex unused", {i for t in triangles for i in t}, set(range(len(positions))))


def test_range_of_steps(host):
    for name, text in [("odd", "v 0.1 0.2 0.3\nv 0.7 -12.3 7.77\nv 3.3 0 -1\nf 1 2 3\n"),
                       ("far", "v 32766 -32766 0\nv -32766 32766 0\nv 0 1 0.00001\nf 1 2 3\n"),
                       ("flat", SQUARE), ("aside", SQUARE.replace("0\n", "1234.567\n")),
                       ("tiny", "v 1e-5 0 0\nv 0 1e-5 0\nv 0 0 1e-5\nf 1 2 3\n")]:
        host.write(name + ".obj", text)
        steps, _ = array(convert(host, name + ".obj"), name + "_positions")
        host.check(f"{name}: steps within +-32767", all(-32767 <= v <= 32767 for step in steps for v in step), str(steps))
    steps, _ = array(convert(host, "odd.obj"), "odd_positions")
    host.check("steps use the range", all(max(abs(step[a]) for step in steps) > 32700 for a in range(3)), str(steps))


def test_scale(host):
    host.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
    plain, scaled = mesh(convert(host, "a.obj"), "a"), mesh(convert(host, "a.obj", "--scale", "-2,3,1"), "a")
    wrong = max(abs(s[0] + 2 * p[0]) + abs(s[1] - 3 * p[1]) + abs(s[2] - p[2]) for p, s in zip(plain[0], scaled[0]))
    host.check("positions are scaled", wrong < 1e-3, str(wrong))
    host.equal("a mirrored mesh turns its triangles", (plain[2], scaled[2]), ([(0, 1, 2)], [(0, 2, 1)]))
    wanted = (0, -1 / 10 ** 0.5, 3 / 10 ** 0.5)  # (0, -1, 1) by the inverse transpose: (0, -1/3, 1)
    host.check("normals go by the inverse transpose", max(abs(a - b) for a, b in zip(scaled[1][0], wanted)) < 1e-4,
               str(scaled[1][0]))


def test_pieces(host):
    host.write("big.obj", torus_text(512, 256))
    text = convert(host, "big.obj", warning=TOO_LARGE)
    triangles = vertices = 0
    host.check("pieces as an array", "static const glint_mesh big_meshes[" in text)
    for piece in range(int(re.search(r"big_meshes\[(\d+)\]", text).group(1))):
        positions, declared = array(text, f"big_positions_{piece}")
        indices, _ = array(text, f"big_triangles_{piece}")
        host.check(f"piece {piece}", len(positions) == declared <= 65536 and
                   max(max(t) for t in indices) == len(positions) - 1)
        triangles += len(indices)
        vertices += len(positions)
    host.check("pieces hold it all", triangles == 262144 and vertices >= 131072, f"{triangles} {vertices}")
    host.equal("pieces share offset and extent", len(set(re.findall(r"\{.*\}, /\* (?:offset|extent) \*/", text))), 2)


# Of the largest mesh every other will do: it takes seconds.
COMPILERS = (("cc", "c"), ("clang", "c"), ("c++", "cpp"), ("clang++", "cpp"))


PAINTED = "mtllib two.mtl\nv -1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nusemtl front\nf 1 2 3\nusemtl sides\nf 2 1 4\nf 3 2 4\nf 1 3 4\n"
USE_OF_PAIR = """#include "{name}.h"
#include "{name}.h"
const glint_mesh *of_{file}(void);
const glint_mesh *of_{file}(void) {{ return &{mesh}; }}
"""
MAIN_OF_PAIR = """extern {c} const glint_mesh *of_first(void);
extern {c} const glint_mesh *of_second(void);
int main(void) {{ return of_first() != of_second() || of_first()->vertex_count == 0; }}
"""


def pair(host, name, *arguments, warning=""):
    """The source and the header that `convert` writes."""
    run = host.run("convert", *arguments, "-o", name + ".c")
    if run.returncode != 0 or re.fullmatch(warning, run.stderr) is None:
        raise AssertionError(f"convert {arguments}: {run.returncode} {run.stderr}")
    return host.read(name + ".c").decode(), host.read(name + ".h").decode()


def link_pair(host, name, mesh_name, compiler, suffix):
    """Whether two files that include a pair's header see one mesh, the pair's source being C, which is compiled once by
    each C compiler."""
    for file in ("first", "second"):
        host.write(f"{file}.{suffix}", ('extern "C" {\n' if suffix == "cpp" else "") +
                   USE_OF_PAIR.format(name=name, file=file, mesh=mesh_name) + ("}\n" if suffix == "cpp" else ""))
    host.write(f"main.{suffix}", '#include "glint.h"\n' + MAIN_OF_PAIR.format(c='"C"' if suffix == "cpp" else ""))
    c_compiler, library = {"c++": "cc", "clang++": "clang"}.get(compiler, compiler), os.path.join(os.path.dirname(host.program), "libglint.a")
    made = f"{name}.{c_compiler}.o"
    sources = [(f"{file}.{suffix}", f"{file}.o", compiler, ["-std=c99"] if suffix == "c" else []) for file in ("first", "second", "main")]
    if not os.path.exists(host.path(made)):
        sources.append((name + ".c", made, c_compiler, ["-std=c99"]))
    for file, to, by, options in sources:
        run = subprocess.run([by, *options, *STRICT, "-Wmissing-declarations", "-c", file, "-o", to], cwd=host.folder,
                             capture_output=True, text=True, check=False)
        if run.returncode != 0:
            return run.stderr[:500]
    run = subprocess.run([compiler, made, "first.o", "second.o", "main.o", library, "-o", "pair"], cwd=host.folder, capture_output=True, text=True, check=False)
    return run.stderr or ("" if subprocess.run([host.path("pair")], check=False).returncode == 0 else "two meshes")


def test_pair(host):
    files = host.files()
    host.write("two.mtl", "newmtl front\nKd 0.8 0.1 0.05\nnewmtl sides\nKd 0.3 0.3 0.35\n")
    host.write("two.obj", PAINTED)
    host.write("big.obj", torus_text(264, 256))
    for name, value, arguments, warning in (
            ("two", "two_mesh_front", ["two.obj", "--licence", "MIT"], ""), ("plain", "two_mesh", ["torus:24x12", "--name", "two"], ""),
            ("small", "small_mesh", ["torus:12x8", "--name", "small", "--positions", "int8", "--normals", "octahedral", "--indices", "8"], ""),
            ("big", "big_meshes[1]", ["big.obj"], TOO_LARGE)):
        one = convert(host, *arguments, warning=warning)
        source, header = pair(host, name, *arguments, warning=warning)
        host.equal(f"{name}: the same whenever it is made", pair(host, name, *arguments, warning=warning), (source, header))
        data = source.split(f'#include "{name}.h"\n')[1]
        host.equal(f"{name}: data as in a header", re.sub(r"^const ", "static const ", data, flags=re.M), re.split(r'#include "glint\w*\.h"\n', one)[1][:-len("\n#endif\n")])
        declared = sorted(re.findall(r"^extern (const \w+ [\w\[\]]+);", header, re.M))
        host.equal(f"{name}: what is defined is declared", declared, sorted(re.findall(r"^(const \w+ [\w\[\]]+) = \{$", source, re.M)))
        host.check(f"{name}: nothing else", len(declared) == (5 if name == "two" else 1) and "static" not in header)
        for text in (source, header):
            host.check(f"{name}: formats and command", "Q16.16" in text and "object space is offset + extent * step / 32768" in text
                       and re.search(r"\n \*     glint convert .* -o " + name + r"\.c\n", text) is not None)
        host.equal(f"{name}: licence in both", [text.startswith("/* SPDX-License-Identifier: MIT */\n") for text in (source, header)],
                   ["--licence" in arguments] * 2)
        for compiler, suffix in COMPILERS[::2 if name == "big" else 1]:
            host.equal(f"{name} in two files with {compiler}", link_pair(host, name, value, compiler, suffix), "")


def test_names_of_pairs(host):
    host.write("model.h", SQUARE)
    host.refuses("the header is the model", ["convert", "model.h", "-o", "model.c"], r"model\.h:0: cannot be written: it is the model")
    os.remove(host.path("model.h"))
    for name in ('a"b.c', "a\\\\b.c", "a\tb.c"):
        host.refuses(f"a name that #include cannot have: {name!r}", ["convert", "box", "-o", name], r"a.+b\.c:0: cannot be written: #include .*")
    os.mkdir(host.path("sub"))
    host.equal("in a folder", host.run("convert", "box", "-o", "sub/b.c").returncode, 0)
    host.check("the header is found beside its source", '\n#include "b.h"\n' in host.read("sub/b.c").decode())
    shutil.rmtree(host.path("sub"))
    host.equal("a name of nothing but .c", host.run("convert", "box", "-o", ".c").returncode, 0)
    host.check("is a header", b"#ifndef M_C_MESH_H" in host.read(".c"))


def test_colours(host):
    body = "f 1 2 3\nf 1 3 4\n"
    host.write("painted.obj", "v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 1 1 0 0.2 0.4 0.6\nv 0 1 0 1 1 1\n" + body)
    text = convert(host, "painted.obj")
    colours = re.search(r"static const uint8_t painted_colours\[4\]\[3\] = \{(.*?)\n\};", text, re.DOTALL).group(1)
    host.equal("colours, 255 is 1", colours.split(), "{255, 0, 128}, {0, 255, 0}, {51, 102, 153}, {255, 255, 255},".split())
    host.check("the mesh has them", "    painted_colours,\n    0, /* no 16-bit colours */\n    0, /* no clusters */\n    0, /* no layout */\n"
               "    0,\n    {0, 0},\n    {0, 0}, /* no texture */\n};" in text)
    host.check("the head says so", "\n * colours    uint8 red, green, blue: 255 is 1\n" in text and
               f"{4 * 15 + 2 * 6} bytes of flash" in text)
    host.write("partly.obj", "v 0 0 0 1 0 0.5\nv 1 0 0\nv 1 1 0 0.2 0.4 0.6\nv 0 1 0 1 1 1\n" + body)
    run = host.run("convert", "partly.obj", "-o", "partly.h")
    host.equal("colours of some only: a warning", (run.returncode, run.stderr),
               (0, "partly.obj:2: warning: 'v' has no colour, as others have: no colour is kept\n"))
    host.check("colours of some only are left out", "colours" not in host.read("partly.h").decode().replace("no colours", ""))
    os.remove(host.path("partly.h"))
    host.write("white.obj", "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 1 1 0 1 1 1\nv 0 1 0 1 1 1\n" + body)
    host.check("colours that are all white cost no flash", "/* no colours */" in convert(host, "white.obj"))
    same = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 0 0 0 0 1\nv 1 1 0 0 0 1\nv 0 1 0 0 0 1\n"
    host.write("edge.obj", same + "f 1 2 3\nf 4 5 6\n")
    host.check("equal places of two colours stay two vertices", "edge_colours[6]" in convert(host, "edge.obj"))


def numbers(text, name):
    """The rows of an array of any type, and that type."""
    match = re.search(r"static const (\w+) " + name + r"\[\d+\]\[\d\] = \{(.*?)\n\};", text, re.DOTALL)
    return match.group(1), [tuple(int(v) for v in row.split(",")) for row in re.findall(r"\{([^{}]*)\}", match.group(2))]


def unfold(code, one):
    """The direction of an octahedral code."""
    u, v = (c / one for c in code)
    z = 1 - abs(u) - abs(v)
    x, y = (u, v) if z >= 0 else ((1 - abs(v)) * (-1 if u < 0 else 1), (1 - abs(u)) * (-1 if v < 0 else 1))
    length = (x * x + y * y + z * z) ** .5
    return x / length, y / length, z / length


def test_types(host):
    """Types of attributes: the same surface, within the errors that are told."""
    model = os.path.join(MODELS, "stem.obj")
    for options in (["--positions", "int8"], ["--normals", "octahedral"], ["--normals", "octahedral16"], ["--indices", "8"],
                    ["--positions", "int8", "--normals", "octahedral", "--indices", "auto"]):
        told = host.run("convert", model, "--name", "t", "--no-clusters", *options, "-o", "t.h").stdout
        told = dict(line.split(" ", 1) for line in told.splitlines())
        text, plain = host.read("t.h").decode(), convert(host, model, "--name", "t", "--no-clusters")
        host.check(f"{options}: command line", f" --no-clusters {' '.join(options)}\n" in text)
        (kind, points), (normal_kind, normals), (index_kind, triangles) = (numbers(text, "t_" + w) for w in ("positions", "normals", "triangles"))
        wanted = ("int8_t" if "int8" in options else "int16_t",
                  "int8_t" if "octahedral" in options else "int16_t", "uint8_t" if "--indices" in options else "uint16_t")
        host.equal(f"{options}: types", (kind, normal_kind, index_kind), wanted)
        body = re.search(r"glint_mesh t_mesh = \{(.*?)\n\};", text, re.DOTALL).group(1)
        offset, extent = ([int(v) / 65536 for v in row.split(",")] for row in re.findall(r"\{([^{}]*)\}", body)[:2])
        old = mesh(plain, "t")
        one = {2: 127 if normal_kind == "int8_t" else 32767}.get(len(normals[0]))
        directions = [unfold(n, one) if one else tuple(v / 32767 for v in n) for n in normals]
        steps = 128 if kind == "int8_t" else 32768
        places = [tuple(offset[a] + extent[a] * p[a] / steps for a in range(3)) for p in points]
        host.equal(f"{options}: triangles", len(triangles), len(old[2]))
        move = max(abs(places[v][a] - old[0][w][a]) for t, u in zip(triangles, old[2]) for v, w in zip(t, u) for a in range(3))
        cross = [(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])
                 for t, u in zip(triangles, old[2]) for p, q in ((directions[v], old[1][w]) for v, w in zip(t, u))]
        turn = max(sum(c * c for c in n) ** .5 for n in cross) * 57.2958
        host.check(f"{options}: move", abs(move - float(told["largest_move"])) < 1e-4, f"{move} {told['largest_move']}")
        host.check(f"{options}: turn", abs(turn - float(told["largest_turn"])) < 5e-3 and turn < .64, f"{turn} {told['largest_turn']}")
        size = len(points) * (3 if kind == "int8_t" else 6) + len(triangles) * (3 if index_kind == "uint8_t" else 6) + \
            len(normals) * len(normals[0]) * (1 if normal_kind == "int8_t" else 2)
        host.equal(f"{options}: bytes", told["flash_bytes"], str(size))
        host.write("use.c", '#include "t.h"\nconst glint_mesh *used(void);\nconst glint_mesh *used(void) { return &t_mesh; }\n')
        run = subprocess.run(["cc", "-std=c99", *STRICT, "-I", os.path.dirname(host.path("t.h")), "-c", host.path("use.c"), "-o", host.path("use.o")],
                             capture_output=True, text=True, check=False)
        host.equal(f"{options}: compiles", (run.returncode, run.stderr), (0, ""))
    for option, value in (("--positions", "int4"), ("--normals", ""), ("--indices", "9")):
        host.check(f"{option} {value}", host.run("convert", model, option, value, "-o", "t.h").returncode != 0)
    run = host.run("convert", "torus:24x12", "--indices", "8", "-o", "t.h")
    host.check("indices that do not fit", run.returncode != 0 and "288 vertices" in run.stderr, run.stderr)


def test_page_of_types(host):
    """The table of docs/meshes.md is what `info` prints."""
    with open(os.path.join(ROOT, "docs", "meshes.md"), encoding="utf-8") as file:
        table = re.findall(r"^\| ([\w-]+) \| (\d+) \| (.*) \|$", file.read(), re.MULTILINE)
    host.check("models", len(table) >= 5, str(table))
    for model, total, rest in table:
        told = host.run("info", os.path.join(MODELS, model + ".obj")).stdout
        part = {tuple(row[:2]): row[2:] for row in (line.split() for line in told.splitlines()) if row and row[0][:2] in ("--", "al")}
        points, fine, coarse, few = (part[key] for key in (("--positions", "int8"), ("--normals", "octahedral16"),
                                                           ("--normals", "octahedral"), ("--indices", "8")))
        wanted = [f"{points[1][:-1]} %, {points[2]}", f"{fine[1][:-1]} %, {fine[3]}", f"{coarse[1][:-1]} %, {coarse[3]}",
                  "does not fit" if few[0] == "does" else f"{few[1][:-1]} %", part["all", "8"][3][:-1] + " %"]
        host.equal(f"{model} in the page", (total, rest), (re.search(r"of (\d+) without", told).group(1), " | ".join(wanted)))


def test_repair_is_in_the_head(host):
    host.write("a.obj", SQUARE)
    text = convert(host, "a.obj", "--weights", "angle", "--flat", "--repair")
    host.check("command line", "\n *     glint convert a.obj --weights angle --flat --repair\n" in text)


def report(host, *arguments):
    """The `name value` lines that `convert` prints."""
    run = host.run("convert", *arguments, "-o", "out.h")
    host.equal(f"convert {arguments}", (run.returncode, run.stderr), (0, ""))
    os.remove(host.path("out.h"))
    return dict(line.split(" ", 1) for line in run.stdout.splitlines())


def alike(a, b, part):
    return abs(float(a) / float(b) - 1) < part


def test_report(host):
    """What a converted mesh takes is what `info` tells of the model, however large and wherever it is."""
    spot = os.path.join(MODELS, "spot.obj")
    for options in (["--panel", "128x64:grey4"], ["--panel=240x240"], [], ["--no-clusters", "--up-axis", "z"]):
        got = report(host, spot, *options)
        told = host.run("info", spot, *options).stdout
        names = dict(re.findall(r"^(\w+) (\S+)$", told, re.MULTILINE))
        size, form = options[1].split(":") if ":" in "".join(options) else ("240x240" if "=" in "".join(options) else "320x240", "rgb565")
        host.equal(f"{options}: panel", got["panel"], f"{size} {form}")
        table = re.search(rf"^{size} +{form} +(\d+) +(\d+) +(\d+)$", told, re.MULTILINE)
        arena = [got["arena_" + part] for part in ("least", "resident", "one_pass")]
        host.check(f"{options}: arena", all(alike(a, b, .001) for a, b in zip(arena, table.groups())), f"{arena} {table.groups()}")
        host.equal(f"{options}: flash", [got[n] for n in ("vertices", "triangles", "flash_bytes")],
                   [names[n] for n in ("vertices", "triangles", "flash_bytes")])
    host.equal("with --panel info tells of that one", len(re.findall(r"^\d+x\d+ ", host.run("info", spot, "--panel", "9x9").stdout,
                                                                   re.MULTILINE)), 1)
    plain = report(host, spot, "--rotate-x", "60")
    for scale in ("9000", "0.001"):
        got = report(host, spot, "--rotate-x", "60", "--scale", scale)
        for name in ("flash_bytes", "arena_one_pass"): # steps round otherwise, and clusters with them
            host.check(f"scaled by {scale}: {name}", alike(got[name], plain[name], .02), f"{got[name]} {plain[name]}")
    host.check("smaller panels take less", int(report(host, spot, "--panel", "128x128")["arena_one_pass"]) < int(plain["arena_one_pass"]))
    host.write("a.obj", SQUARE)
    text = convert(host, "a.obj")
    host.equal("no report within the mesh", host.run("convert", "a.obj", "-o", "/dev/stdout").stdout, text)
    for value in ("0x9", "9", "1025x9", "9x9:rgb", "9x9:", "123456789012x12345678901234", ":", ""):
        host.refuses(f"--panel {value}", ["convert", "a.obj", "-o", "out.h", "--panel", value],
                     rf"glint: --panel {value}: takes WxH\[:FORMAT\], as in 128x64:grey4; .*")
