/* SPDX-License-Identifier: MIT */
/* Ground and cylinder under one point light of attenuation 1 / (1 + k d), and what each term of the model does. */
#include "stage.h"

#include "meshes/cylinder30x2.h"
#include "meshes/plane1x1.h"
#include "meshes/sphere12x8.h"

/** The light goes round in steps of 10 degrees. */
#define FRAMES 36

enum {
    SCALED = 1,   /* the cylinder squashed */
    COLOURED = 2, /* with its vertices' colours */
    DARK = 4,     /* diffuse colour 0.2 */
    NO_DIFFUSE = 8,
    NO_SPECULAR = 16,
    DIM_SPECULAR = 32, /* specular colour 0.25 */
    DRAW_LIGHT = 64,
    LOW_LIGHT = 128,
    BLINN_PHONG = 256
};

#define AMBIENT GLINT_Q16(0.2)

/* Shininess, and the steps of a key that makes it more or less. */
#define SHININESS 4
#define COARSE 2
#define FINE 0.5
/* Small enough for a lobe that is still bright where Phong cuts it. */
#define SMALL 0.3

static const example_variant variants[] = {
    {"plain", "Diffuse and specular light of a near lamp, weaker with the distance, and ambient light everywhere."},
    {"scaled", "Squashed in one axis only, the cylinder is lit as its new shape demands: its normals stay right."},
    {"vertex-colours", "The vertices' colours take the place of the diffuse colour; the highlight stays white."},
    {"scaled-vertex-colours", "Squashed and coloured."},
    {"dark", "A diffuse colour of 0.2: on dark surfaces the highlight is seen best."},
    {"specular-only", "Without diffuse light the highlight is left, and ambient light."},
    {"diffuse-only", "Without specular light all is matt."},
    {"specular-quarter", "A specular colour of 0.25: as wide a highlight, but fainter."},
    {"shininess-coarse-up", "Exponent 6 in place of 4: the highlight shrinks."},
    {"shininess-coarse-down", "Exponent 2: the highlight grows."},
    {"shininess-fine-up", "Exponent 4.5: a little smaller than plain."},
    {"shininess-fine-down", "Exponent 3.5: a little larger than plain."},
    {"light", "The lamp itself is drawn, unlit, and circles."},
    {"near",
     "Lamp near ground and cylinder: where their surfaces turn from it, Phong's highlight ends at a sharp edge."},
    {"ring", "Exponent 0.3, Phong: where the reflection turns away from the eye, the light stops along a ring."},
    {"ring-blinn-phong", "The same by Blinn-Phong: the half vector never turns away, and there is no ring."},
};

static const struct option {
    uint32_t flags;
    glint_q16 shininess;
} options[COUNT_OF(variants)] = {
    {0, GLINT_Q16(SHININESS)},
    {SCALED, GLINT_Q16(SHININESS)},
    {COLOURED, GLINT_Q16(SHININESS)},
    {SCALED | COLOURED, GLINT_Q16(SHININESS)},
    {DARK, GLINT_Q16(SHININESS)},
    {NO_DIFFUSE, GLINT_Q16(SHININESS)},
    {NO_SPECULAR, GLINT_Q16(SHININESS)},
    {DIM_SPECULAR, GLINT_Q16(SHININESS)},
    {0, GLINT_Q16(SHININESS + COARSE)},
    {0, GLINT_Q16(SHININESS - COARSE)},
    {0, GLINT_Q16(SHININESS + FINE)},
    {0, GLINT_Q16(SHININESS - FINE)},
    {DRAW_LIGHT, GLINT_Q16(SHININESS)},
    {DRAW_LIGHT | LOW_LIGHT | DARK, GLINT_ONE},
    {DRAW_LIGHT | DARK, GLINT_Q16(SMALL)},
    {DRAW_LIGHT | DARK | BLINN_PHONG, GLINT_Q16(SMALL)},
};

/* A turn of the hue circle, for the columns of the cylinder. Formatted by hand, five columns a line. */
/* clang-format off */
#define HUES(X) \
    X(255, 0, 0) X(255, 51, 0) X(255, 102, 0) X(255, 153, 0) X(255, 204, 0) \
    X(255, 255, 0) X(204, 255, 0) X(153, 255, 0) X(102, 255, 0) X(51, 255, 0) \
    X(0, 255, 0) X(0, 255, 51) X(0, 255, 102) X(0, 255, 153) X(0, 255, 204) \
    X(0, 255, 255) X(0, 204, 255) X(0, 153, 255) X(0, 102, 255) X(0, 51, 255) \
    X(0, 0, 255) X(51, 0, 255) X(102, 0, 255) X(153, 0, 255) X(204, 0, 255) \
    X(255, 0, 255) X(255, 0, 204) X(255, 0, 153) X(255, 0, 102) X(255, 0, 51)

/* A column: its hue below, white in the middle, and another hue above. */
#define COLUMN(r, g, b) {r, g, b}, {255, 255, 255}, {b, r, g},
#define BOTTOM(r, g, b) {r, g, b},
#define TOP(r, g, b) {b, r, g},
#define WHITE {255, 255, 255}

/* In the order of the mesh: sides, and each cap's rim and centre. */
static const uint8_t cylinder_colours[COUNT_OF(cylinder30x2_positions)][3] = {
    HUES(COLUMN)
    HUES(BOTTOM) WHITE,
    HUES(TOP) WHITE
};
/* clang-format on */

static const glint_mesh coloured_cylinder = {
    .positions = cylinder30x2_positions,
    .normals = cylinder30x2_normals,
    .triangles = cylinder30x2_triangles,
    .vertex_count = COUNT_OF(cylinder30x2_positions),
    .triangle_count = COUNT_OF(cylinder30x2_triangles),
    .extent = {65538, 65178, 55708}, /* as in cylinder30x2.h: C takes no constant from a constant structure */
    .colours = cylinder_colours,
};

static glint_colour weigh(glint_colour colour, glint_q16 weight) {
    const glint_colour product = {stage_multiply(colour.r, weight), stage_multiply(colour.g, weight),
                                  stage_multiply(colour.b, weight)};

    return product;
}

/* A paint as the options have it; its ambient light stays. */
static glint_material paint(const struct option *option, glint_colour colour) {
    const uint32_t flags = option->flags;
    const glint_q16 diffuse = flags & NO_DIFFUSE ? 0 : flags & DARK ? GLINT_Q16(0.2) : GLINT_ONE;
    const glint_q16 specular = flags & NO_SPECULAR ? 0 : flags & DIM_SPECULAR ? GLINT_Q16(0.25) : GLINT_ONE;
    const glint_material material = {flags & BLINN_PHONG ? &glint_model_blinn_phong : &glint_model_phong,
                                     weigh(colour, AMBIENT),
                                     weigh(colour, diffuse),
                                     {specular, specular, specular},
                                     option->shininess,
                                     0};

    return material;
}

static glint_vector light_position(uint32_t flags, uint32_t frame) {
    const glint_q16 angle =
        (flags & LOW_LIGHT ? GLINT_Q16(98) : GLINT_Q16(55)) + (glint_q16)(frame % FRAMES) * (360 / FRAMES) * GLINT_ONE;
    const glint_q16 radius = flags & LOW_LIGHT ? GLINT_Q16(1.5) : GLINT_Q16(2.1);
    const glint_vector position = {stage_multiply(radius, glint_sin(angle)),
                                   flags & LOW_LIGHT ? GLINT_Q16(0.5) : GLINT_Q16(1.5),
                                   stage_multiply(radius, glint_cos(angle))};

    return position;
}

static void add_cylinder(example_stage *stage, const struct option *option) {
    glint_material material = paint(option, (glint_colour)RGB(0.75, 0.6, 0.3));
    const glint_pose stand = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_vector scale = {GLINT_ONE, GLINT_ONE, option->flags & SCALED ? GLINT_Q16(0.3) : GLINT_ONE};
    const glint_pose place = stage_place(scale, GLINT_Q16(-25), (glint_vector)XYZ(0, 0.85, 0));
    const glint_pose pose = glint_pose_then(&stand, &place);

    if (option->flags & COLOURED) {
        material.ambient = weigh((glint_colour)GREY(0.8), AMBIENT);
        material.diffuse = (glint_colour)GREY(0.8);
    }
    stage_add(stage, option->flags & COLOURED ? &coloured_cylinder : &cylinder30x2_mesh, &material, &pose);
}

static void add_light(example_stage *stage, glint_vector position, int drawn) {
    const glint_material glow = {&glint_model_unlit, GREY(0), RGB(1, 1, 0.8), GREY(0), 0, 0};
    glint_light *light = stage_light(stage, &glint_light_point, position, (glint_colour)GREY(1));

    light->linear = GLINT_Q16(0.25);
    if (drawn) {
        const glint_pose pose = stage_place((glint_vector)XYZ(0.09, 0.09, 0.09), 0, position);

        stage_add(stage, &sphere12x8_mesh, &glow, &pose);
    }
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const struct option *option = &options[variant];
    const glint_vector eye = XYZ(0.4, 5.2, 7.4), at = XYZ(0.4, 0.25, 0.7);
    const glint_material ground = paint(option, (glint_colour)RGB(0.45, 0.55, 0.6));
    const glint_pose lie = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_pose widen = glint_pose_scale(GLINT_Q16(14), GLINT_ONE, GLINT_Q16(14));
    const glint_pose floor = glint_pose_then(&lie, &widen);

    stage_clear(stage, (glint_colour)RGB(0, 0, 0));
    stage_look(stage, eye, at, GLINT_Q16(32));
    stage_add(stage, &plane1x1_mesh, &ground, &floor);
    add_cylinder(stage, option);
    add_light(stage, light_position(option->flags, frame), (option->flags & DRAW_LIGHT) != 0);
}

const example_scene example_phong_lighting = {
    .name = "phong-lighting",
    .summary = "Ground and cylinder under a point light: what each term of Phong's model does.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = FRAMES,
    .width = 320,
    .height = 240,
    .build = build,
};
