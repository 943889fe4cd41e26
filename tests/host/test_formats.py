# SPDX-License-Identifier: MIT
"""STL, PLY, OFF and glTF, as their formats mean them: what each file holds is drawn, or the user is told that it is not."""
import base64
import json
import os
import re
import struct

from test_convert import convert, mesh

# A lopsided solid, wound counter-clockwise from outside, as every format has it.
POINTS = [(-.7, -.5, -.4), (.8, -.5, -.3), (.1, .9, .2), (.3, -.4, .9)]
FACES = [(0, 2, 1), (1, 2, 3), (2, 0, 3), (0, 1, 3)]

# Two triangles that meet at 23 degrees: smooth where normals are made, but not where a format means facets.
BENT = [(-1, 0, 0), (0, -1, .2), (0, 1, .2), (1, 0, 0)]
FOLDED = [(0, 1, 2), (3, 2, 1)]

QUAD = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]


def stl_text(points=POINTS, faces=FACES):
    return "solid t\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % points[i] for i in f) + "endloop\nendfacet\n"
        for f in faces) + "endsolid t\n"


def stl_binary(header=b" ", attributes=(0, 0, 0, 0), points=POINTS, faces=FACES):
    return header.ljust(80) + struct.pack("<I", len(faces)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *points[f[0]], *points[f[1]], *points[f[2]], a) for f, a in zip(faces, attributes))


def ply(vertex="float x y z", vertices=None, face="list uchar int vertex_indices", faces=None, form="ascii", element="face", comment=""):
    """A file of rows; a property is a type and names, several by commas; a list's row has its items in a list."""
    codes = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d", "int64": "q"}
    head, data = "", b"" if form != "ascii" else ""
    order = ">" if form == "binary_big_endian" else "<"
    for name, properties, rows in (("vertex", vertex, vertices or POINTS), (element, face, faces or [[list(f)] for f in FACES])):
        head += f"element {name} {len(rows)}\n"
        types = []
        for part in properties.split(", "):
            words = part.split()
            kind = words[:3] if words[0] == "list" else words[:1]
            types += [kind] * len(words[len(kind):])
            head += "".join(f"property {' '.join(kind)} {word}\n" for word in words[len(kind):])
        for row in rows:
            if form == "ascii":
                data += " ".join(str(v) for item in row for v in ([len(item), *item] if isinstance(item, list) else [item])) + "\n"
                continue
            for kind, item in zip(types, row):
                if isinstance(item, list):
                    data += struct.pack(order + codes[kind[1]], len(item)) + struct.pack(order + str(len(item)) + codes[kind[2]], *item)
                else:
                    data += struct.pack(order + codes[kind[0]], item)
    head = f"ply\nformat {form} 1.0\n{comment}{head}end_header\n"
    return head + data if form == "ascii" else head.encode() + data


def off(kind="OFF", vertices=POINTS, faces=None):
    return f"{kind}\n# by hand\n{len(vertices)} {len(faces or FACES)} 0\n\n" + "".join(
        " ".join(map(str, p)) + "\n" for p in vertices) + "".join(
            " ".join(map(str, f)) + "\n" for f in (faces or [(3, *f) for f in FACES]))


def gltf(attributes=None, indices=sum(FACES, ()), nodes=None, primitive=None, **top):
    """A document of one primitive. An attribute is a struct code, `+` after it for normalised, and its rows."""
    kinds = {"b": 5120, "B": 5121, "h": 5122, "H": 5123, "I": 5125, "f": 5126}
    data, views, accessors = b"", [], []

    def add(code, rows):
        nonlocal data
        rows = [row if isinstance(row, tuple) else (row,) for row in rows]
        width = len(rows[0])
        stride = (struct.calcsize(code[0]) * width + 3) // 4 * 4 if width > 1 else 0
        packed = b"".join(struct.pack(f"<{width}{code[0]}", *row).ljust(stride, b"\0") for row in rows)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed), **({"byteStride": stride} if stride else {})})
        accessors.append({"bufferView": len(views) - 1, "componentType": kinds[code[0]], "count": len(rows), "normalized": "+" in code,
                          "type": {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[width]})
        data += packed.ljust((len(packed) + 3) // 4 * 4, b"\0")
        return len(accessors) - 1

    made = {"attributes": {name: add(*value) for name, value in (attributes or {"POSITION": ("f", POINTS)}).items()}, **(primitive or {})}
    if indices:
        made["indices"] = add("H", indices)
    extra = {name: add(*top.pop(name)) for name in [n for n in top if n.startswith("accessor_")]}
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes or [{"mesh": 0}],
                "meshes": [{"primitives": [made]}], "accessors": accessors, "bufferViews": views,
                "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
    text = json.dumps({**document, **top})
    for name, number in extra.items():
        text = text.replace(f'"{name}"', str(number))
    return text


def quad(**more):
    normals = ("f", [(0, 0, 1)] * 4)
    return gltf({"POSITION": ("f", QUAD), "NORMAL": normals, **more.pop("attributes", {})}, (0, 1, 2, 0, 2, 3), **more)


def painted(**material):
    return quad(primitive={"material": 0}, materials=[{"name": "paint", **material}])


def glb(text, in_file=True, pad=b" "):
    """The binary form; the buffer is its second chunk, or stays in the text."""
    document, data = json.loads(text), b""
    if in_file:
        data = base64.b64decode(document["buffers"][0].pop("uri").partition(",")[2])
    packed = json.dumps(document).encode()
    chunks = b"".join(struct.pack("<I4s", len(c), kind) + c for c, kind in
                      [(packed + pad * (4 - len(packed) % 4), b"JSON"), (data + b"\0" * (-len(data) % 4), b"BIN\0")] if c)
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def solid(host, file, *options, name=None, warning=""):
    """The triangles of a converted model: three positions each, from the smallest on; so windings can be compared."""
    text = convert(host, file, "--no-clusters", *options, "--name", "t", warning=warning)
    text = text.replace(f"t_mesh_{name} =", "t_mesh =").replace(f"_{name}[", "[") if name else text
    positions, _, triangles, _, _ = mesh(text, "t")
    turned = []
    for triangle in triangles:
        corners = [positions[i] for i in triangle]
        first = corners.index(min(corners))
        turned.append(tuple(corners[first:] + corners[:first]))
    return sorted(turned)


def check_solid(host, what, got, change=lambda *p: p, mirrored=False):
    wanted = []
    for face in FACES:
        corners = [change(*POINTS[i]) for i in (face[::-1] if mirrored else face)]
        first = corners.index(min(corners))
        wanted.append(tuple(corners[first:] + corners[:first]))
    off_by = [max(abs(a - b) for p, q in zip(s, t) for a, b in zip(p, q)) for s, t in zip(got, sorted(wanted))]
    host.check(f"{what} has the triangles", len(got) == len(FACES) and max(off_by) < 1e-3, f"{off_by} {got}")


def colours(host, name, *options):
    """The different colours of a converted model's vertices, and how often each stands there."""
    text = convert(host, name, "--name", "t", "--no-clusters", *options)
    body = re.search(r"t_colours\w*\[\d+\]\[3\] = \{(.*?)\n\};", text, re.DOTALL)
    found = re.findall(r"\{(\d+), (\d+), (\d+)\}", body.group(1)) if body else []
    return {tuple(map(int, c)): found.count(c) for c in found}


def told(host, name, pattern):
    """Drawn all the same, with that one warning."""
    run = host.run("info", name)
    host.check(f"{name}: {pattern}", run.returncode == 0 and re.fullmatch(rf"{re.escape(name)}:\d+: warning: {pattern}\n", run.stderr),
               f"{run.returncode} {run.stderr}")


def test_the_same_mesh_from_each_format(host):
    for name, content, material in [
            ("text.stl", stl_text(), None), ("binary.STL", stl_binary(), None), ("t.ply", ply(), None), ("t.off", off(), None),
            ("little.ply", ply(form="binary_little_endian"), None), ("big.ply", ply(form="binary_big_endian"), None),
            ("t.gltf", gltf(), "default"), ("t.glb", glb(gltf()), "default"), ("in.glb", glb(gltf(), False), "default")]:
        host.write(name, content)
        check_solid(host, name, solid(host, name, name=material))
        info = host.info(name)
        host.equal(f"{name}: positions are joined, nothing is white", (info["positions"], info["boundary_edges"], info["colours"]),
                   ("4", "0", "none"))


def test_stl(host):
    upper = stl_text().upper()
    for name, content in [
            ("upper.stl", upper), ("crlf.stl", stl_text().replace("\n", "\r\n")), ("indented.stl", stl_text().replace("\n", "\n\t ")),
            ("one-line.stl", stl_text().replace("\n", " ").replace("solid t", "solid t\n", 1)), ("end.stl", stl_text().replace("endsolid", "end solid")),
            ("backslash.stl", stl_text().replace("solid t\n", "solid C:\\parts\\\n", 1)), ("plus.stl", stl_text().replace("0.9", "+9.0E-01")),
            ("solidworks.stl", stl_binary(b"solid part exported")), ("zeros.stl", stl_binary(b"\0" * 80)),
            ("normals.stl", stl_text().replace("normal 0 0 0", "normal nan -nan(ind) 1.#QNAN"))]:
        host.write(name, content)
        check_solid(host, name, solid(host, name))
    for name, content in [("bent.stl", stl_text(BENT, FOLDED)), ("bent-binary.stl", stl_binary(points=BENT, faces=FOLDED))]:
        host.write(name, content)
        host.equal(f"{name} is faceted, with normals or without", host.info(name)["vertices"], "6")
    for name, content, pattern in [
            ("empty-solid.stl", "solid a\nendsolid a\n" + stl_text(), r"solids without facets are skipped \(1\)"),
            ("no-end.stl", stl_text()[:-len("endsolid t\n")], "the file ends without endsolid: it may be cut off"),
            ("longer.stl", stl_binary() + b"padding", "bytes behind the 4 facets that the file names are skipped"),
            ("edge.stl", stl_text().replace("endloop", "endloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nendloop", 1),
             r"faces of fewer than 3 corners are skipped \(1\)")]:
        host.write(name, content)
        told(host, name, pattern)
    host.write("two.stl", stl_text() + stl_text().replace("solid t", "solid other"))
    host.equal("solids are objects", re.findall(r"t_mesh_(\w+) =", convert(host, "two.stl", "--objects", "--name", "t")), ["t", "other"])
    red, blue, white = (255, 0, 0), (0, 0, 255), (255, 255, 255)
    host.write("viscam.stl", stl_binary(attributes=(0xFC00, 0xFC00, 0x801F, 0)))
    host.equal("VisCAM's colours", colours(host, "viscam.stl"), {red: 6, blue: 3, white: 3})
    host.write("magics.stl", stl_binary(b"made by COLOR=\xff\0\0\xff,MATERIAL=", (0x8000, 0x8000, 0x7C00, 0x7C00)))
    host.equal("Magics' colours", colours(host, "magics.stl"), {red: 6, blue: 6})


def test_ply(host):
    """Exporters' habits: types, orders and elements of their own change nothing; colours and strips are kept."""
    listed, sided = [[list(f)] for f in FACES], [[list(f), 255 * (i < 2), 0, 255 * (i > 1)] for i, f in enumerate(FACES)]
    for name, content in [
            ("double.ply", ply("double x y z", form="binary_big_endian")), ("index.ply", ply(face="list uint8 int32 vertex_index")),
            ("int64.ply", ply(face="list int int64 vertex_indices", form="binary_little_endian")),
            ("quality.ply", ply("float x y z quality", [(*p, "nan") for p in POINTS], "list uchar uint vertex_indices, uchar flags",
                                [[f, 3] for f, in listed])),
            ("texture.ply", ply("float s t x y z", [(0, 1, *p) for p in POINTS], "list uchar float texcoord, list uchar int vertex_indices",
                                [[[.5] * 6, f] for f, in listed], form="binary_big_endian")),
            ("nan.ply", ply(vertices=[*POINTS, ("nan", "-inf", 0)])), ("backslash.ply", ply(comment="comment C:\\models\\\n")),
            ("crlf.ply", ply().replace("\n", "\r\n")), ("mac.ply", ply().replace("\n", "\r")),
            ("white.ply", ply("float x y z, uchar red green blue alpha", [(*p, 255, 255, 255, 255) for p in POINTS])),
            ("strip.ply", ply(face="list int int vertex_indices", faces=[[[0, 2, 1, 3, 0]], [[0, 1, 3, -1, 2, 0]]], element="tristrips"))]:
        host.write(name, content)
        if name != "strip.ply":
            check_solid(host, name, solid(host, name))
        host.equal(f"{name}: white is no colour", host.info(name)["colours"], "none")
    host.equal("a strip has all its triangles, and -1 ends it", host.info("strip.ply")["triangles"], "4")
    host.write("strip.ply", ply(vertices=QUAD[:2] + [QUAD[3], QUAD[2]], faces=[[[0, 1, 2, 3]]], element="tristrips"))
    info = host.info("strip.ply")
    host.equal("they face one way", (info["triangles"], info["mixed_parts"]), ("2", "0"))
    for name, vertex, value in [("uchar", "uchar red green blue", 51), ("float", "float red green blue", .2), ("ushort", "ushort r g b", 13107),
                                ("old", "uchar diffuse_red diffuse_green diffuse_blue", 51)]:
        host.write(name + ".ply", ply("float x y z, " + vertex, [(*p, 0, 0, value) for p in POINTS], form="binary_little_endian"))
        host.equal(f"colours of {name}", colours(host, name + ".ply", "--smooth"), {(0, 0, 51): 4})
    host.write("sides.ply", ply(face="list uchar int vertex_indices, uchar red green blue", faces=sided))
    host.equal("colours of faces", {c: n > 0 for c, n in colours(host, "sides.ply").items()}, {(255, 0, 0): True, (0, 0, 255): True})
    check_solid(host, "sides.ply", solid(host, "sides.ply"))
    smooth = [set(mesh(convert(host, name, "--name", "t", "--smooth"), "t")[1]) for name in ("sides.ply", "double.ply")]
    host.equal("and change no normal", smooth[0], smooth[1])
    host.write("normals.ply", ply("float x y z nx ny nz", [(*p, 0, 0, 2) for p in POINTS]))
    host.equal("normals", set(mesh(convert(host, "normals.ply", "--name", "t"), "t")[1]), {(0, 0, 1)})
    for name, content, pattern in [
            ("meshlab.ply", ply(comment="comment TextureFile wood.png\n"),
             "the texture 'wood.png' is not drawn: the triangles have no texture coordinates"),
            ("lines.ply", ply().replace("end_header", "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header") + "0 1\n",
             "the elements 'edge' are skipped"),
            ("both.ply", ply("float x y z, uchar red green blue", [(*p, 9, 9, 9) for p in POINTS],
                             "list uchar int vertex_indices, uchar red green blue", sided), "colours of faces are skipped: vertices have some"),
            ("glass.ply", ply("float x y z, uchar red green blue alpha", [(*p, 9, 9, 9, 128) for p in POINTS]), "transparency of colours is not drawn"),
            ("edges.ply", ply(faces=listed + [[[0, 1]]]), r"faces of fewer than 3 corners are skipped \(1\)")]:
        host.write(name, content)
        told(host, name, pattern)


def test_off(host):
    for name, content in [
            ("no-word.off", off("")), ("fourth.off", off("4OFF", [(*(2 * v for v in p), 2) for p in POINTS])),
            ("texture.off", off("STOFF", [(*p, .5, .5) for p in POINTS])), ("one-line.off", off().replace("OFF\n# by hand\n", "OFF "))]:
        host.write(name, content)
        check_solid(host, name, solid(host, name))
    host.write("normals.off", off("NOFF", [(*p, 0, 0, 2) for p in POINTS]))
    host.equal("normals", set(mesh(convert(host, "normals.off", "--name", "t"), "t")[1]), {(0, 0, 1)})
    for name, last in [("bytes", (0, 0, 51)), ("floats", ("0.0", "0.0", "0.2")), ("alpha", (0, 0, 51, 255))]:
        host.write(name + ".off", off("COFF", [(*p, *last) for p in POINTS]))
        host.equal(f"colours of vertices as {name}", colours(host, name + ".off", "--smooth"), {(0, 0, 51): 4})
    host.write("faces.off", off(faces=[(3, *f, *((255, 0, 0) if i < 2 else ("0.0", "0.0", "1.0"))) for i, f in enumerate(FACES)]))
    host.equal("colours of faces", set(colours(host, "faces.off")), {(255, 0, 0), (0, 0, 255)})
    host.write("map.off", off(faces=[(3, *f, 7) for f in FACES]))
    told(host, "map.off", "colours by their number in a map are skipped")
    host.write("glass.off", off("COFF", [(*p, 0, 0, 51, 128) for p in POINTS]))
    told(host, "glass.off", "transparency of colours is not drawn")


def test_gltf_normals(host):
    host.write("flat.gltf", gltf({"POSITION": ("f", BENT)}, sum(FOLDED, ())))
    host.equal("without normals it is flat", host.info("flat.gltf")["vertices"], "6")
    host.write("given.gltf", gltf({"POSITION": ("f", POINTS), "NORMAL": ("b+", [(0, 0, 127)] * 4)}))
    host.equal("normals are followed", set(mesh(convert(host, "given.gltf").replace("_default", ""), "given")[1]), {(0, 0, 1)})


def test_gltf_geometry(host):
    """Accessors, modes and nodes of every kind give the same triangles."""
    flat = sum(([POINTS[i] for i in f] for f in FACES), [])
    sparse = json.loads(gltf({"POSITION": ("f", [POINTS[0], (9, 9, 9), POINTS[2], (9, 9, 9)])}, accessor_i=("H", [1, 3]), accessor_v=("f", [POINTS[1], POINTS[3]])))
    views = [a["bufferView"] for a in sparse["accessors"][-2:]]
    sparse["accessors"][0]["sparse"] = {"count": 2, "indices": {"bufferView": views[0], "componentType": 5123}, "values": {"bufferView": views[1]}}
    two = json.loads(gltf())
    uri = two["buffers"][0]["uri"]
    two["buffers"].append({"byteLength": two["buffers"][0]["byteLength"], "uri": uri})
    two["bufferViews"][1]["buffer"] = 1
    mixed = json.loads(glb(json.dumps(two))[20:].partition(b"BIN\0")[0].rpartition(b"}")[0] + b"}")
    host.check("one buffer is the file's, one its own", "uri" not in mixed["buffers"][0] and "uri" in mixed["buffers"][1])
    turn = {"children": [1], "rotation": [0, 0, .6, .8], "translation": [1, 2, 3]}
    steps = [tuple(round(100 * v) for v in p) for p in POINTS]
    for name, content, change, mirrored in [
            ("unindexed.gltf", gltf({"POSITION": ("f", flat)}, None), None, False),
            ("strip.gltf", gltf(indices=(0, 2, 1, 3, 0, 2), primitive={"mode": 5}), None, False),
            ("sparse.gltf", json.dumps(sparse), None, False), ("buffers.glb", glb(json.dumps(two)), None, False),
            ("quantised.gltf", gltf({"POSITION": ("h", steps)}, nodes=[{"mesh": 0, "scale": [.01] * 3}], extensionsUsed=["KHR_mesh_quantization"],
                                    extensionsRequired=["KHR_mesh_quantization"]), None, False),
            ("bytes.gltf", gltf({"POSITION": ("b+", [tuple(round(127 * v) for v in p) for p in POINTS])}), lambda *p: tuple(round(127 * v) / 127 for v in p), False),
            ("mirrored.gltf", gltf(nodes=[{"children": [1], "translation": [1, 2, 3]}, {"children": [2], "scale": [-2, 1, 1]}, {"mesh": 0, "scale": [1, 3, 1]}]),
             lambda x, y, z: (1 - 2 * x, 2 + 3 * y, 3 + z), True),
            ("matrix.gltf", gltf(nodes=[{"mesh": 0, "matrix": [0, 2, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0, 5, 6, 7, 1]}]), lambda x, y, z: (y + 5, 2 * x + 6, 7 - z), False),
            ("turned.gltf", gltf(nodes=[turn, {"mesh": 0}]), lambda x, y, z: (1 + .28 * x - .96 * y, 2 + .96 * x + .28 * y, 3 + z), False),
            ("no-scene.gltf", gltf(scenes=[]), None, False), ("listed-twice.gltf", gltf(scenes=[{"nodes": [0, 0]}]), None, False), ("bom.gltf", "\ufeff" + gltf(), None, False),
            ("padded.glb", glb(gltf(), pad=b"\0"), None, False)]:
        host.write(name, content)
        check_solid(host, name, solid(host, name, name="default"), change or (lambda *p: p), mirrored)
        host.equal(f"{name} faces outwards", host.info(name)["inward_parts"], "0")
    host.write("fan.gltf", gltf({"POSITION": ("f", QUAD)}, None, primitive={"mode": 6}))
    host.equal("a fan", (host.info("fan.gltf")["triangles"], host.info("fan.gltf")["mixed_parts"]), ("2", "0"))
    host.write("twice.gltf", gltf(nodes=[{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}]))
    info = host.info("twice.gltf")
    host.equal("a mesh of two nodes", (info["triangles"], info["parts"], info["highest"]), ("8", "2", "5.8 0.9 0.9"))
    colour = [(255, 0, 0, 255), (0, 0, 0, 255), (255, 51, 0, 255), (255, 255, 255, 255)]
    host.write("colours.gltf", quad(attributes={"COLOR_0": ("B+", colour)}))
    host.equal("colours", colours(host, "colours.gltf"), {c[:3]: 1 for c in colour})
    part = json.loads(quad(attributes={"COLOR_0": ("B+", colour)}, accessor_i=("H", [0, 1, 2])))
    part["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "indices": 4})
    part["accessors"][3] |= {"count": 3, "byteOffset": 6}
    host.write("partly.gltf", json.dumps(part))
    host.equal("a part without colours is white", colours(host, "partly.gltf").get((255, 255, 255)), 4)


def test_gltf_skins_and_morphs(host):
    """A mesh stands as its joints and weights have it at rest: anywhere else it is not what any viewer shows."""
    bind = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1)
    skinned = {"POSITION": ("f", POINTS), "JOINTS_0": ("B", [(0, 1, 0, 0)] * 4), "WEIGHTS_0": ("B+", [(51, 204, 0, 0)] * 4)}
    nodes = [{"mesh": 0, "skin": 0, "translation": [10, 0, 0], "scale": [3, 3, 3]}, {"translation": [0, 2, 0], "children": [2]}, {"translation": [5, 0, 0]}]
    host.write("skinned.gltf", gltf(skinned, nodes=nodes, scenes=[{"nodes": [0, 1]}], accessor_b=("f", [bind, bind]),
                                    skins=[{"joints": [1, 2], "inverseBindMatrices": "accessor_b"}]))
    check_solid(host, "a skin", solid(host, "skinned.gltf", name="default"), lambda x, y, z: (x + 4, y + 1, z))
    for where in ("mesh", "node"):
        document = json.loads(gltf(accessor_m=("f", [(0, 0, 4)] * 4)))
        document["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": len(document["accessors"]) - 1}]
        (document["meshes"] if where == "mesh" else document["nodes"])[0]["weights"] = [.5]
        host.write("morph.gltf", json.dumps(document))
        check_solid(host, f"weights of a {where}", solid(host, "morph.gltf", name="default"), lambda x, y, z: (x, y, z + 2))


def material(text, what, name="paint"):
    body = re.search(r"glint_material t_material_" + name + r" = \{(.*?)\n\};", text, re.DOTALL).group(1)
    found = re.search(r"\{([^{}]*)\}, /\* " + what, body) or re.search(r"(\d+), /\* " + what, body)
    return [int(v) / 65536 for v in found.group(1).split(",")]


def near(got, wanted):
    return len(got) == len(wanted) and all(abs(a - b) <= 1e-4 * max(1, abs(b)) for a, b in zip(got, wanted))


def physical(base, metal, rough):
    """The formulas of docs/assets.md."""
    alpha = rough ** 2
    shininess = min(max(2 / alpha ** 2 - 2, 1), 1024) if alpha else 1024
    kd = [b * (1 - metal * (1 - alpha)) for b in base]
    ks = [(.04 * (1 - metal) + b * metal) * (shininess + 2) / 8 * (1 - alpha) for b in base]
    return kd, [k / max(1, *ks) for k in ks], [shininess]


def test_gltf_materials(host):
    for base, metal, rough in [((.8, .2, .1), 0, .5), ((1, .77, .34), 1, .3), ((.5, .5, .5), .5, .8), ((.9, .9, .9), 0, 0),
                               ((.2, .4, .6), 1, 1), ((.2, .5, .2), 0, 1)]:
        host.write("t.gltf", painted(pbrMetallicRoughness={"baseColorFactor": [*base, 1], "metallicFactor": metal, "roughnessFactor": rough},
                                     emissiveFactor=[0, .25, 0], extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 2}}))
        text = convert(host, "t.gltf", "--name", "t")
        got = [material(text, what) for what in ("diffuse", "specular", "shininess")]
        host.check(f"base {base}, metal {metal}, roughness {rough}", all(map(near, got, physical(base, metal, rough))), str(got))
        kd = got[0]
        host.check("what it emits, by its strength", near(material(text, "ambient"), [.1 * kd[0], .1 * kd[1] + .5, .1 * kd[2]]))
    for diffuse, specular, gloss, same in [([.1, .7, .1], [.04] * 3, .5, ([.1, .7, .1], 0, .5)), ([0] * 3, [1, .77, .34], .7, ([1, .77, .34], 1, .3))]:
        host.write("t.gltf", painted(extensions={"KHR_materials_pbrSpecularGlossiness": {
            "diffuseFactor": [*diffuse, 1], "specularFactor": specular, "glossinessFactor": gloss}}))
        text = convert(host, "t.gltf", "--name", "t")
        got = [material(text, what) for what in ("diffuse", "specular", "shininess")]
        host.check(f"glossiness {gloss} as roughness", all(map(near, got, physical(*same))), str(got))
    host.write("unlit.gltf", painted(extensions={"KHR_materials_unlit": {}}))
    host.check("unlit", "&glint_model_unlit," in convert(host, "unlit.gltf"))
    host.write("none.gltf", quad())
    host.check("what has no material has the format's default", near(material(convert(host, "none.gltf", "--name", "t"), "diffuse", "default"), [1] * 3))
    three = json.loads(painted())
    three["materials"] = [{"name": "two\n words # and \\"}, {"name": "two\n words # and \\"}, {}]
    three["meshes"][0]["primitives"] = [{**three["meshes"][0]["primitives"][0], "material": i} for i in range(3)]
    host.write("t.gltf", json.dumps(three))
    names = re.findall(r"glint_material t_material_(\w+) =", convert(host, "t.gltf", "--name", "t"))
    host.equal("names that no identifier has, or twice, or not at all", names, ["two__words___and__", "two__words___and___2", "2"])


def test_gltf_double_sided(host):
    """doubleSided is set where a back can be seen: on closed parts, where exporters set it too, it would cost time for nothing."""
    behind = {"nodes": [{"mesh": 0, "rotation": [0, 1, 0, 0]}], "primitive": {"material": 0}}
    view = ["--eye", "0,0,4", "--size", "60x60"]
    host.write("one.gltf", quad(materials=[{}], **behind))
    host.write("two.gltf", quad(materials=[{"doubleSided": True}], **behind))
    both, one = host.render("two.gltf", *view), host.render("one.gltf", *view)
    host.check("the back is drawn", both.rows == host.render("one.gltf", "--double-sided", *view).rows != one.rows)
    closed = {"primitive": {"material": 0}, "materials": [{"name": "paint", "doubleSided": True}]}
    for name, content, wanted in [("closed", gltf(**closed), 0), ("open", gltf(indices=sum(FACES[:3], ()), **closed), 1),
                                  ("inward", gltf(indices=sum((f[::-1] for f in FACES), ()), **closed), 1)]:
        host.write(name + ".gltf", content)
        for options in ([], ["--objects"]):
            text = convert(host, name + ".gltf", *options, warning=".*see --repair\n" if name == "inward" else "")
            host.equal(f"{name} {options}", text.count("GLINT_MESH_DOUBLE_SIDED"), wanted)


def test_what_gltf_has_and_a_mesh_has_not(host):
    camera = {"cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": .1}}], "nodes": [{"mesh": 0, "camera": 0}]}
    lights = {"extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}, "extensionsUsed": ["KHR_lights_punctual"]}
    points = json.loads(gltf())
    points["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "mode": 0})
    bumps = {"materials": [{"normalTexture": {"index": 0}}], "primitive": {"material": 0}}
    unsorted = {"animations": [{"samplers": [{"input": 99, "output": -1}], "channels": [{"sampler": 7, "target": {}}]}]}
    for name, content, pattern in [
            ("camera", gltf(**camera), r"cameras are skipped \(1\)"), ("light", gltf(**lights), r"lights are skipped \(1\)"),
            ("points", json.dumps(points), r"points and lines are skipped \(1\)"), ("bumps", gltf(**bumps), "of textures only base colours are drawn: 1 materials have others"),
            ("motion", gltf(**unsorted), r"animations are skipped \(1\)"), ("scenes", gltf(scenes=[{"nodes": [0]}, {}]), "of 2 scenes only scene 0 is read"),
            ("coat", gltf(extensionsUsed=["KHR_materials_clearcoat"]), "the extension 'KHR_materials_clearcoat' is not followed")]:
        host.write(name + ".gltf", content)
        told(host, name + ".gltf", pattern)
    for name in ("EXT_meshopt_compression", "KHR_draco_mesh_compression"):
        host.write("needs.gltf", gltf(extensionsUsed=[name], extensionsRequired=[name]))
        host.refuses(name, ["info", "needs.gltf"], rf"needs\.gltf:0: the file requires '{name}', which is not read")


def beside(uri):
    document = json.loads(gltf())
    document["buffers"][0]["uri"] = uri
    return json.dumps(document)


def test_gltf_files_beside_it(host):
    os.mkdir(host.path("in"))
    data = base64.b64decode(json.loads(gltf())["buffers"][0]["uri"].partition(",")[2])
    host.write("up.bin", data)
    host.write("in/my data.bin", data)
    for name, uri in [("escaped", "my%20data.bin"), ("raw", "my data.bin")]:
        host.write(f"in/{name}.gltf", beside(uri))
        check_solid(host, name, solid(host, f"in/{name}.gltf", name="default"))
        host.check("the header names the buffer and its hash", "Also read: my data.bin, whose hash is" in convert(host, f"in/{name}.gltf"))
    for name, uri, pattern in [("missing", "missing.bin", "the buffer 'missing.bin' cannot be opened: No such file or directory"),
                               ("up", "../up.bin", "the buffer '../up.bin' is not in the model's folder"),
                               ("hidden", "%2e%2e/up.bin", "the buffer '../up.bin' is not in the model's folder")]:
        host.write(f"in/{name}.gltf", beside(uri))
        host.refuses(name, ["info", f"in/{name}.gltf"], rf"in/{name}\.gltf:0: " + re.escape(pattern))


def test_broken_files(host):
    """Each is refused in one line that names the cause, and without a file."""
    binary, text = stl_binary(), json.loads(gltf())
    loop = gltf(nodes=[{"mesh": 0}, {"children": [2]}, {"children": [1]}], scenes=[{"nodes": [1]}])
    short = json.loads(gltf())
    short["accessors"][0]["count"] = 4000000000
    view = json.loads(gltf())
    view["bufferViews"][0]["byteLength"] = 40
    for name, content, line, pattern in [
            ("cut.stl", binary[:-40], 0, "the file is cut off, or no STL: it names 4 facets and has 3"),
            ("count.stl", binary[:80] + b"\xff\xff\xff\x7f" + binary[84:], 0, "the file is cut off, or no STL: it names 2147483647 facets .*"),
            ("text.stl", stl_text()[:150], 11, "the file is cut off: it ends within an element"),
            ("facet.stl", stl_text().replace("endfacet", "", 1), 9, "a facet without endfacet before it"),
            ("none.stl", "solid t\nendsolid t\n", 0, "no faces"), ("short.stl", "", 0, "the file is neither text of STL .*"),
            ("word.stl", stl_text().replace("0.9", "x"), 5, "'x' is not a number"), ("nan.stl", stl_text().replace("0.9", "nan"), 8, "a corner's coordinates .*"),
            ("other.stl", "solid\nhello\n", 2, "'hello' is not a keyword of STL"),
            ("count.ply", ply().replace("vertex 4", "vertex 4000000000"), None, "'?.*"), ("index.ply", ply().replace("3 0 2 1", "3 0 2 99"), 14, "a face names vertex 99 of 4"),
            ("nan.ply", ply(vertices=[("nan", 0, 0), *POINTS[1:]]), 14, "a corner's coordinates are not finite.*"),
            ("nan-side.ply", ply("float x y z", [("nan", 0, 0), *POINTS[1:]], "list uchar int vertex_indices, uchar red green blue",
                                 [[list(f), 255, 0, 0] for f in FACES]), 17, "a corner's coordinates are not finite.*"), ("cut.ply", ply()[:-9], 16, "the file is cut off: .*"),
            ("cut-binary.ply", ply(form="binary_big_endian")[:-1], 0, "the file is cut off: it ends within an element"),
            ("cloud.ply", ply(faces=[[[0]]], element="ray"), None, "no faces: a cloud of points"), ("type.ply", ply("real x y z"), 4, "'real' is not a type of PLY"),
            ("head.ply", "ply\nformat ascii 1.0\n", None, "the file is cut off: its header has no end"), ("word.ply", "plain\n", 1, "the file does not begin with 'ply'"),
            ("cut.off", off()[:-9], 11, "the file is cut off: .*"), ("index.off", off().replace("3 0 2 1", "3 0 2 4"), 9, "'4' is not one of 4 vertices"),
            ("binary.off", "OFF BINARY\n", 1, "binary OFF is not read: take text"), ("three.off", off("nOFF"), 1, "OFF of more than 3 dimensions is not read"),
            ("cut.gltf", gltf()[:400], 1, "the JSON text is cut off"), ("word.gltf", gltf().replace('"scene": 0', '"scene": zero'), 1, "'zero' is no value of JSON"),
            ("deep.gltf", "[" * 200, 1, "more than 128 arrays and objects in one another"), ("more.gltf", gltf() + "x", 1, "something behind the end of the JSON text"),
            ("old.gltf", json.dumps({**text, "asset": {"version": "1.0"}}), 0, "not glTF of version 2"), ("empty.glb", "", 1, "the JSON text is cut off"),
            ("cut.glb", glb(gltf())[:-30], 0, "the file is cut off: a chunk has .*"), ("one.glb", b"glTF\1\0\0\0\0\0\0\0", 0, "GLB of another version than 2 is not read"),
            ("count.gltf", json.dumps(short), 0, "accessor 0 has more numbers than are read"), ("view.gltf", json.dumps(view), 0, "a view is too short for the 4 elements of its accessor"),
            ("index.gltf", gltf(indices=(0, 1, 4)), 0, "a triangle names vertex 4 of 4"), ("minus.gltf", gltf(indices=(0, 1, 65535)).replace('"componentType": 5123', '"componentType": 5122'), 0, "a triangle names vertex -1 of 4"), ("empty.gltf", beside("data:;base64,"), 0, "buffer 0 is cut off: it has 0 bytes, view 0 ends at 48"), ("loop.gltf", loop, 0, "node 1 is below itself"),
            ("tree.gltf", gltf(nodes=[{"mesh": 0, "children": [1, 1]}, {}]), 0, "node 0 has a child that is not there, or is another's"),
            ("nan.gltf", gltf({"POSITION": ("f", [(float("nan"), 0, 0), *POINTS[1:]])}), 0, "a corner's coordinates are not finite.*"),
            ("normals.gltf", gltf({"POSITION": ("f", POINTS), "NORMAL": ("f", POINTS[:3])}), 0, "NORMAL has 3 elements, POSITION 4"),
            ("none.gltf", gltf(primitive={"mode": 1}), 0, "no faces"), ("material.gltf", gltf(primitive={"material": 3}), 0, "'material' is missing, .*")]:
        host.write(name, content)
        host.refuses(f"{name} is broken", ["convert", name, "-o", "out.h"], re.escape(name) + f":{r'[0-9]+' if line is None else line}: " + pattern)
    host.refuses("a file that is not there", ["info", "none.ply"], r"none\.ply:0: cannot be opened: No such file or directory")
