# SPDX-License-Identifier: MIT
"""Models, lights, where light is evaluated, and how pixels are stored, against their formulas."""
from harness import SQUARE, SQUARE_VIEW

# Matt white under no ambient light, unless a later option says otherwise.
MATT = ["--ambient", "0", "--diffuse", ".8", "--specular", "0"]
SHINY = ["--ambient", "0", "--diffuse", "0", "--specular", "1"]
AHEAD = ["--light", "dir:0,0,1"]


def near(pixel, wanted, steps=1):
    return all(abs(channel - wanted) <= steps for channel in pixel)


def square(host, *options):
    """The square's picture: its side of 2 is 30 pixels, its middle pixel (45, 45)."""
    host.write("square.obj", SQUARE)
    return host.render("square.obj", *SQUARE_VIEW, *options)


def middle(host, *options):
    return square(host, *options).at(45, 45)


def test_models(host):
    aside = ["--light", "dir:1,0,1", *SHINY, "--shininess"]
    for p in (1, 4, 10.5, 50):
        pixel = middle(host, *aside, str(p), "--model", "phong")
        host.check(f"phong, shininess {p}", near(pixel, 255 * 0.7071068 ** p), str(pixel))
        pixel = middle(host, *aside, str(p), "--model", "blinn-phong")
        host.check(f"blinn-phong, shininess {p}", near(pixel, 255 * 0.9238795 ** p), str(pixel))
    host.check("shininess 0", near(middle(host, *aside, "0"), 255))
    host.check("shininess 0, phong", near(middle(host, *aside, "0", "--model", "phong"), 255))
    both = [*AHEAD, "--ambient", ".1", "--diffuse", ".5", "--specular", ".3"]
    host.check("lambert has no highlight", near(middle(host, *both, "--model", "lambert"), 255 * 0.6))
    host.check("phong has", near(middle(host, *both, "--model", "phong"), 255 * 0.9))
    host.check("blinn-phong is the default", middle(host, *both) == middle(host, *both, "--model", "blinn-phong"))
    host.check("unlit is the diffuse colour", near(middle(host, *both, "--model", "unlit"), 255 * 0.5))
    host.check("unlit in the dark", near(middle(host, "--light", "dir:0,0,-1", "--model", "unlit", "--diffuse", ".4"), 102))


def test_gate(host):
    behind = ["--light", "dir:1,0,-0.2", *SHINY, "--shininess", "2"]
    host.equal("no highlight where N.L <= 0", middle(host, *behind), (0, 0, 0))
    pixel = middle(host, *behind, "--ungated")
    host.check("--ungated shines through", near(pixel, 255 * 0.40197, 2), str(pixel))


def test_combine(host):
    for ambient, wanted in ((0.5, 0.5), (0.1, 0.3)):
        lit = [*AHEAD, "--diffuse", ".2", "--specular", ".1", "--ambient", str(ambient)]
        host.check(f"max, ambient {ambient}", near(middle(host, *lit, "--combine", "max"), 255 * wanted))
        host.check(f"sum, ambient {ambient}", near(middle(host, *lit, "--combine", "sum"), 255 * (ambient + 0.3)))
    host.equal("the last --combine holds", middle(host, *lit, "--combine", "max", "--combine", "sum"), middle(host, *lit))


def test_point_light(host):
    for coefficients, wanted in (("", 1), (":1,1,1:1", 1 / 3), (":1,1,1:0:1", 1 / 5), (":1,1,1:0.5:0.25", 1 / 3),
                                 (":1,.5,.25", 1)):
        pixel = middle(host, "--light", "point:0,0,2" + coefficients, *MATT)
        host.check(f"point{coefficients}", near(pixel[:1], 204 * wanted), str(pixel))
    pixel = middle(host, "--light", "point:0,0,2:1,.5,.25", *MATT)
    host.check("a point light's colour", near(pixel[1:2], 102) and near(pixel[2:], 51), str(pixel))
    pixel = square(host, "--light", "point:0,0,2", *MATT).at(31, 45)
    host.check("a point light slants", near(pixel, 204 * 2 / (4 + 0.81) ** 0.5, 2), str(pixel))
    image = square(host, "--light", "point:0,0,-1", *MATT)
    host.equal("a point light behind", image.box((0, 0, 0)), None)
    host.equal("a light in the surface adds nothing", square(host, "--light", "point:0,0,0", *MATT).box((0, 0, 0)), None)


def test_spot_light(host):
    image = square(host, "--light", "spot:0,0,2:0,0,-5:10,20", *MATT)
    host.check("full along the axis", near(image.at(45, 45), 204), str(image.at(45, 45)))
    full = image.at(48, 45)  # 3.5 / 15 from the axis: 6.7 degrees
    host.check("full inside the inner cone", near(full, 204 * 0.9932, 2), str(full))
    between = image.at(53, 45)  # 8.5 / 15: 15.8 degrees
    host.check("weaker between the cones", 20 < between[0] < 170, str(between))
    host.equal("none outside the outer cone", image.at(57, 45), (0, 0, 0))  # 12.5 / 15: 22.6 degrees
    away = square(host, "--light", "spot:0,0,2:0,0,1:10,20", *MATT)
    host.equal("a spot that points away", away.box((0, 0, 0)), None)
    wide = square(host, "--light", "spot:0,0,2:0,0,-1:180,180", *MATT)
    host.equal("a spot of 180 degrees is a point light", wide.rows, square(host, "--light", "point:0,0,2", *MATT).rows)
    sharp = square(host, "--light", "spot:0,0,2:0,0,-1:15,15:1,1,1:1", *MATT)
    host.check("a spot is attenuated", near(sharp.at(45, 45), 68), str(sharp.at(45, 45)))
    host.equal("a sharp cone has one edge", sharp.at(54, 45), (0, 0, 0))


TORUS = ["torus:24x12", "--size", "120x90"]

# Lights of every kind, with their vectors, and what stands before and after each in --light.
LIGHTS = [("dir:", [(-1, 2, 3)], ":1,.5,.25"), ("point:", [(1, 2, -2)], ":1,1,1:0.25:0.125"),
          ("spot:", [(0.5, -1, 1), (-0.25, 1, -4)], ":20,40")]


def world_of(axes, eye, kind, vectors):
    """A light's vectors in world space: those of a camera's right, up and back, and but for directions from its eye."""
    turned = [[sum(v * axis[i] for v, axis in zip(vector, axes)) for i in range(3)] for vector in vectors]
    if kind != "dir:":
        turned[0] = [v + e for v, e in zip(turned[0], eye)]
    return turned


def light_options(lights):
    return [word for kind, vectors, rest in lights
            for word in ("--light", kind + ":".join("%.9f,%.9f,%.9f" % tuple(v) for v in vectors) + rest)]


def unit(vector):
    return [v / sum(w * w for w in vector) ** 0.5 for v in vector]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def camera_axes(eye, up):
    """Right, up and back of a camera at `eye` that looks at the origin."""
    back = unit(eye)
    right = unit(cross(up, back))
    return [right, cross(back, right), back]


def test_camera_lights(host):
    for eye, up, exact in (((4, 0, 0), (0, 1, 0), True), ((0, 4, 0), (1, 0, 0), True), ((0, 0, -4), (0, -1, 0), True),
                           ((1, 2, 3), (0.25, 1, 0), False)):
        view = [*TORUS, "--eye", "%r,%r,%r" % eye, "--up", "%r,%r,%r" % up]
        for lights in ([LIGHTS[0]], [LIGHTS[1]], [LIGHTS[2]], LIGHTS):
            title = f"from {eye}, {', '.join(kind for kind, _, _ in lights)}"
            by_hand = [(kind, world_of(camera_axes(eye, up), eye, kind, v), rest) for kind, v, rest in lights]
            there = host.render(*view, *light_options(lights), "--camera-lights")
            here = host.render(*view, *light_options(by_hand))
            steps = max(abs(p - q) for a, b in zip(there.rows, here.rows) for c, d in zip(a, b) for p, q in zip(c, d))
            host.check(f"{title}: as computed by hand", steps <= (0 if exact else 1), f"{steps} steps")
            host.check(f"{title}: not the light in world space", host.render(*view, *light_options(lights)).rows != there.rows)
    for kind, vectors, rest in LIGHTS:
        light = light_options([(kind, vectors, rest)])
        still = ["--scale", ".5,.5,20", "--eye", "0,0,0", "--at", "0,0,-1"]  # the identity, inside the torus
        plain = host.render(*TORUS, *still, *light)
        host.equal(f"{kind} camera space is world space", host.render(*TORUS, *still, *light, "--camera-lights").rows, plain.rows)
        host.check(f"{kind} shows", len(plain.levels()) > 2)
    framed = [*TORUS, "--light", "dir:0,0,1", "--diffuse", "1", "--specular", "0", "--ambient", "0"]
    host.check("a framing camera", host.render(*framed, "--camera-lights").rows != host.render(*framed).rows)
    host.equal("the default light is in camera space already", host.render(*TORUS, "--camera-lights").rows,
               host.render(*TORUS).rows)
    host.equal("the last word holds for all", host.render(*TORUS, "--camera-lights", *light_options(LIGHTS)).rows,
               host.render(*TORUS, *light_options(LIGHTS), "--camera-lights").rows)
    far = [*TORUS, "--eye", "3,0,3", "--camera-lights", "--light"]
    steps = max(abs(p[0] - q[0]) for a, b in zip(host.render(*far, "dir:32767,0,32767").rows,
                                                 host.render(*far, "dir:1,0,1").rows) for p, q in zip(a, b))
    host.check("a direction as long as can be", steps <= 1, f"{steps} steps")


def test_shading(host):
    torus = ["torus:24x12", "--eye", "1,1.5,3.2", "--size", "120x90"]
    pictures = {name: host.render(*torus, "--shading", name) for name in ("flat", "vertex", "fragment")}
    host.equal("fragment is the default", pictures["fragment"].rows, host.render(*torus).rows)
    host.check("they differ", len({str(p.rows) for p in pictures.values()}) == 3)
    facets = host.render(*torus, "--flat")
    worst = max(abs(a[0] - b[0]) for p, q in zip(facets.rows, pictures["flat"].rows) for a, b in zip(p, q))
    host.check("flat is what facet normals give", worst <= 2, f"{worst} steps")
    lamp = ["--light", "point:0,0,.5:1,1,1:0:2", *MATT]
    host.check("per fragment the lamp is bright below", near(middle(host, *lamp), 204 / 1.5, 2))
    image = square(host, *lamp, "--shading", "vertex")
    corner = 204 * (0.5 / 1.5) / (1 + 2 * 2.25)  # at a distance of 1.5
    levels = image.levels() - {0}
    host.check("per vertex the corners say it all", all(abs(level - corner) <= 1 for level in levels), str(levels))
    image = square(host, *lamp, "--shading", "flat")
    host.check("flat: one level a triangle", len(image.levels() - {0}) <= 2, str(image.levels()))


def test_vertex_colours(host):
    corners = ["1 0 0", "0 1 0", "0 0 1", "1 1 1"]
    lines = SQUARE.splitlines()
    host.write("painted.obj", "\n".join([f"{line} {colour}" for line, colour in zip(lines, corners)] + lines[4:]))
    image = host.render("painted.obj", *SQUARE_VIEW, "--model", "unlit", "--diffuse", ".8")
    for (x, y), wanted in (((30, 59), (1, 0, 0)), ((59, 59), (0, 1, 0)), ((59, 30), (0, 0, 1)), ((30, 30), (1, 1, 1))):
        pixel = image.at(x, y)
        host.check(f"painted corner {x},{y}", all(abs(p - 204 * w) <= 8 for p, w in zip(pixel, wanted)), str(pixel))
    pixel = host.render("painted.obj", *SQUARE_VIEW, "--light", "dir:0,0,-1", "--ambient", ".5").at(30, 59)
    host.check("colours tint the ambient light", near(pixel[:1], 127, 5) and near(pixel[1:], 0, 5), str(pixel))


def test_dither(host):
    for name, top, level in (("grey4", 15, 0.42), ("rgb565", 31, 0.415), ("rgb565_be", 31, 0.415), ("grey8", 255, 0.3),
                             ("rgb444", 15, 0.42), ("mono", 1, 0.42)):
        flat = ["--light", "dir:0,0,-1", "--ambient", str(level), "--format", name]
        plain = {p for row in square(host, *flat).rows[31:59] for p in row[31:59]}
        host.equal(f"{name} undithered is even", len(plain), 1)
        image = square(host, *flat, "--dither")
        pixels = [p[0] * top / 255 for row in image.rows[34:58] for p in row[34:58]]  # three patterns of 8 each way
        host.check(f"{name} dithered lies between two levels", all(abs(p - level * top) <= 1.02 for p in pixels))
        mean = sum(pixels) / len(pixels)
        host.check(f"{name} dithered is right on average", abs(mean - level * top) < 0.06, f"{mean} {level * top}")
    host.check("rgb565_be dithered is rgb565 dithered", square(host, "--dither", "--format", "rgb565").rows ==
               square(host, "--dither", "--format", "rgb565_be").rows)
    host.check("rgb888 can be dithered", square(host, *AHEAD, "--ambient", ".3333", "--dither").at(45, 45)[0] > 0)


def test_gamma(host):
    for gamma in (0.5, 1.8, 2.2, 10):
        for level in (0, 0.02, 0.2, 0.5, 0.9, 1):
            # Between the table's nodes the curve is a chord: near black, where it is steep, the chord lies below it.
            pixel = middle(host, "--light", "dir:0,0,-1", "--ambient", str(level), "--gamma", str(gamma))
            wanted = 255 * level ** (1 / gamma)
            host.check(f"gamma {gamma} of {level}", near(pixel, wanted, 1.5), f"{pixel} {wanted}")
    host.equal("gamma 1 is none", square(host, "--gamma", "1").rows, square(host).rows)
    host.check("the background has gamma too", near(square(host, "--background", ".25", "--gamma", "2").at(0, 0), 128))
