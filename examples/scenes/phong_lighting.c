/* SPDX-License-Identifier: MIT */
/* Ground and cylinder under one point light of attenuation 1 / (1 + k d), and what each term of the model does. */
#include "stage.h"

#include "meshes/cylinder30x2.h"
#include "meshes/cylinder_skewed.h"
#include "meshes/plane1x1.h"
#include "meshes/sphere12x8.h"

/** The light, the cylinder or the eye goes round in steps of 10 degrees. */
#define FRAMES 36

enum {
    SCALED = 1,   /* the cylinder squashed */
    COLOURED = 2, /* with its vertices' colours */
    DARK = 4,     /* diffuse colour 0.2, which ambient light meets too */
    NO_DIFFUSE = 8,
    NO_SPECULAR = 16,
    DIM_SPECULAR = 32, /* specular colour 0.25 */
    DRAW_LIGHT = 64,
    CLOSE_UP = 128, /* the lamp close to the cylinder's far side, the eye close to both */
    BLINN_PHONG = 256,
    SKEWED = 512, /* beside it the same one, its normals scaled as its points are */
    INVERSE_SQUARE = 1024,
    TURNING = 2048,     /* the cylinder turns, the lamp stays */
    ORBIT = 4096,       /* the eye goes round, the lamp stays */
    FAR_VIEWER = 8192,  /* V is the same at all pixels */
    WITH_CAMERA = 16384 /* the lamp goes round with the eye */
};

#define AMBIENT GLINT_Q16(0.2)

/* Shininess, and small enough for a lobe that is still bright where Phong cuts it. */
#define SHININESS 4
#define SMALL 0.3

static const example_label scaled_labels[] = {{"inverse\ntranspose", 86, 142, 0, 0},
                                              {"the matrix\nitself", 202, 142, 0, 0}};
static const example_label near_labels[] = {{"N.L = 0", 96, 90, 151, 116}};
static const example_label ring_labels[] = {{"R.V = 0", 40, 100, 64, 138}};
static const example_label half_labels[] = {{"N.L = 0", 50, 60, 131, 92}};

#define LABELS(array) array, COUNT_OF(array)

static const example_variant variants[] = {
    {"plain", "Diffuse and specular light of a near lamp, weaker with the distance, and ambient light everywhere.", 0,
     0},
    {"scaled", "Squashed in one axis only, the cylinder is lit as its new shape demands: its normals stay right.", 0,
     0},
    {"scaled-normals",
     "Two squashed cylinders: normals by the inverse transpose on the left, by the matrix itself on the right, where "
     "the "
     "broad side is lit as if it were narrow.",
     LABELS(scaled_labels)},
    {"vertex-colours",
     "The vertices' colours take the place of the diffuse colour; the highlight adds white light to them, to (213 255 "
     "157) at its brightest.",
     0, 0},
    {"scaled-vertex-colours", "Squashed and coloured.", 0, 0},
    {"dark", "A diffuse colour of 0.2, for ambient light too: what is left is mostly the highlight.", 0, 0},
    {"dark-specular-quarter", "With a specular colour of 0.25 it is black plastic: the highlight gives it its shape.",
     0, 0},
    {"dark-diffuse-only", "Without the specular term very little is seen of it.", 0, 0},
    {"specular-only", "Without diffuse light the highlight is left, and ambient light of the full colour.", 0, 0},
    {"diffuse-only", "Without specular light all is matt.", 0, 0},
    {"specular-quarter", "A specular colour of 0.25: as wide a highlight, but fainter.", 0, 0},
    {"shininess-up", "Exponent 6 in place of 4: the highlight shrinks.", 0, 0},
    {"shininess-down", "Exponent 2: the highlight grows.", 0, 0},
    {"inverse-square",
     "The lamp's light falls as 1 / (1 + k d^2) in place of 1 / (1 + k d): what is far from it gets darker.", 0, 0},
    {"light", "The lamp itself is drawn, unlit, and circles.", 0, 0},
    {"turning", "The cylinder turns, and its colours with it; the highlight stays where lamp and eye put it.", 0, 0},
    {"orbit", "The eye goes round, and the highlight wanders over cylinder and ground.", 0, 0},
    {"near", "A lamp close to the surface: the highlight is cut off where the surface turns from the lamp, at N.L = 0.",
     LABELS(near_labels)},
    {"ring", "Exponent 0.3, Phong: where the reflection turns from the eye, at R.V = 0, the light stops along a ring.",
     LABELS(ring_labels)},
    {"ring-blinn-phong",
     "The same by Blinn-Phong: the half vector never turns away, and there is no ring. What edge is left is that of "
     "N.L = 0.",
     LABELS(half_labels)},
    {"near-smooth", "The same lamp at exponent 16: the highlight has ended before the edge, which is not seen.",
     LABELS(near_labels)},
    {"far-viewer", "The eye counted as infinitely far away: the ground's highlight moves by 18 pixels.", 0, 0},
    {"dark-orbit", "The black plastic from all sides: highlights tell its shape.", 0, 0},
    {"camera-light",
     "The eye goes round the coloured cylinder, and the lamp with it, its place given in camera space: the highlight "
     "stays in the picture.",
     0, 0},
};

static const struct option {
    uint32_t flags;
    glint_q16 shininess;
} options[COUNT_OF(variants)] = {
    {0, GLINT_Q16(SHININESS)},
    {SCALED, GLINT_Q16(SHININESS)},
    {SCALED | SKEWED, GLINT_Q16(SHININESS)},
    {COLOURED, GLINT_Q16(SHININESS)},
    {SCALED | COLOURED, GLINT_Q16(SHININESS)},
    {DARK, GLINT_Q16(SHININESS)},
    {DARK | DIM_SPECULAR, GLINT_Q16(SHININESS)},
    {DARK | NO_SPECULAR, GLINT_Q16(SHININESS)},
    {NO_DIFFUSE, GLINT_Q16(SHININESS)},
    {NO_SPECULAR, GLINT_Q16(SHININESS)},
    {DIM_SPECULAR, GLINT_Q16(SHININESS)},
    {0, GLINT_Q16(SHININESS + 2)},
    {0, GLINT_Q16(SHININESS - 2)},
    {INVERSE_SQUARE, GLINT_Q16(SHININESS)},
    {DRAW_LIGHT, GLINT_Q16(SHININESS)},
    {COLOURED | TURNING | DRAW_LIGHT, GLINT_Q16(SHININESS)},
    {DRAW_LIGHT | ORBIT, GLINT_Q16(4 * SHININESS)},
    {DRAW_LIGHT | CLOSE_UP | DARK, GLINT_ONE},
    {DRAW_LIGHT | DARK, GLINT_Q16(SMALL)},
    {DRAW_LIGHT | DARK | BLINN_PHONG, GLINT_Q16(SMALL)},
    {DRAW_LIGHT | CLOSE_UP | DARK, GLINT_Q16(4 * SHININESS)},
    {FAR_VIEWER, GLINT_Q16(SHININESS)},
    {DRAW_LIGHT | DARK | DIM_SPECULAR | ORBIT, GLINT_Q16(SHININESS)},
    {COLOURED | DRAW_LIGHT | ORBIT | WITH_CAMERA, GLINT_Q16(4 * SHININESS)},
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

/* A column: its hue below, a shade of two in the middle, and another hue above. */
#define COLUMN(r, g, b) {r, g, b}, {((r) + (b)) / 3, ((g) + (r)) / 3, ((b) + (g)) / 3}, {b, r, g},
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

/* The upper cap alone, whose triangles come last. */
static const glint_mesh disc = {
    .positions = cylinder30x2_positions,
    .normals = cylinder30x2_normals,
    .triangles = cylinder30x2_triangles + COUNT_OF(cylinder30x2_triangles) - 30,
    .vertex_count = COUNT_OF(cylinder30x2_positions),
    .triangle_count = 30,
    .extent = {65538, 65178, 55708},
};

static glint_colour weigh(glint_colour colour, glint_q16 weight) {
    const glint_colour product = {stage_multiply(colour.r, weight), stage_multiply(colour.g, weight),
                                  stage_multiply(colour.b, weight)};

    return product;
}

/* A paint as the options have it. Ambient light meets the diffuse colour, unless that one is only left out. */
static glint_material paint(const struct option *option, glint_colour colour) {
    const uint32_t flags = option->flags;
    const glint_q16 specular = flags & NO_SPECULAR ? 0 : flags & DIM_SPECULAR ? GLINT_Q16(0.25) : GLINT_ONE;
    const glint_colour diffuse = weigh(colour, flags & DARK ? GLINT_Q16(0.2) : GLINT_ONE);
    const glint_material material = {flags & BLINN_PHONG ? &glint_model_blinn_phong : &glint_model_phong,
                                     weigh(diffuse, AMBIENT),
                                     flags & NO_DIFFUSE ? (glint_colour)GREY(0) : diffuse,
                                     {specular, specular, specular},
                                     option->shininess,
                                     0};

    return material;
}

/* On a circle round the axis, begun at `start` degrees from the viewer. */
static glint_vector on_circle(glint_q16 radius, glint_q16 height, glint_q16 start, uint32_t frame) {
    const glint_q16 angle = start + (glint_q16)(frame % FRAMES) * (360 / FRAMES) * GLINT_ONE;
    const glint_vector position = {stage_multiply(radius, glint_sin(angle)), height,
                                   stage_multiply(radius, glint_cos(angle))};

    return position;
}

static glint_vector light_position(uint32_t flags, uint32_t frame) {
    const uint32_t moved = flags & (TURNING | ORBIT) && !(flags & WITH_CAMERA) ? 0 : frame;

    if (flags & CLOSE_UP)
        return on_circle(GLINT_Q16(1.35), GLINT_Q16(0.9), GLINT_Q16(112), moved);
    return on_circle(GLINT_Q16(2.1), GLINT_Q16(1.5), GLINT_Q16(55), moved);
}

static void add_cylinder(example_stage *stage, const struct option *option, const glint_mesh *mesh, glint_q16 x,
                         uint32_t frame) {
    const uint32_t moved = option->flags & TURNING ? frame : 0;
    glint_material material = paint(option, (glint_colour)RGB(0.75, 0.6, 0.3));
    const glint_pose stand = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_vector scale = {GLINT_ONE, GLINT_ONE, option->flags & SCALED ? GLINT_Q16(0.3) : GLINT_ONE};
    const glint_q16 turn = GLINT_Q16(-25) + (glint_q16)moved * (360 / FRAMES) * GLINT_ONE;
    const glint_pose place = stage_place(scale, turn, (glint_vector){x, GLINT_Q16(0.85), 0});
    const glint_pose pose = glint_pose_then(&stand, &place);

    if (option->flags & COLOURED) {
        material.diffuse = (glint_colour)GREY(0.55);
        material.ambient = weigh(material.diffuse, AMBIENT);
    }
    stage_add(stage, mesh, &material, &pose);
}

/* A dark disc just above the ground, in place of the shadow at a cylinder's foot: it is seen to stand. */
static void add_foot(example_stage *stage, const struct option *option) {
    glint_material material = paint(option, (glint_colour)RGB(0.2, 0.25, 0.27));
    const glint_pose lie = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_q16 size = GLINT_Q16(1.12);
    const glint_pose place =
        stage_place((glint_vector){size, GLINT_Q16(0.04), option->flags & SCALED ? GLINT_Q16(0.38) : size},
                    GLINT_Q16(-25), (glint_vector)XYZ(0, 0, 0));
    const glint_pose pose = glint_pose_then(&lie, &place);

    material.diffuse = material.specular = (glint_colour)GREY(0);
    stage_add(stage, &disc, &material, &pose);
}

static void add_light(example_stage *stage, glint_vector position, uint32_t flags) {
    const glint_material glow = {&glint_model_unlit, GREY(0), RGB(1, 1, 0.8), GREY(0), 0, 0};
    glint_light *light = stage_lamp(stage, &glint_light_point, position, (glint_colour)GREY(1));

    if (flags & INVERSE_SQUARE)
        light->quadratic = GLINT_Q16(0.25);
    else
        light->linear = GLINT_Q16(0.25);
    if (flags & DRAW_LIGHT) {
        const glint_pose pose = stage_place((glint_vector)XYZ(0.09, 0.09, 0.09), 0, position);

        stage_add(stage, &sphere12x8_mesh, &glow, &pose);
    }
}

static void look(example_stage *stage, uint32_t flags, uint32_t frame) {
    glint_vector eye = XYZ(0.4, 5.2, 7.4), at = XYZ(0.4, 0.25, 0.7);
    glint_q16 field_of_view = GLINT_Q16(32);

    if (flags & ORBIT) {
        eye = on_circle(GLINT_Q16(7.4), GLINT_Q16(5.2), GLINT_Q16(10), frame);
        at = (glint_vector)XYZ(0, 0.3, 0);
    } else if (flags & CLOSE_UP) {
        eye = (glint_vector)XYZ(4.2, 2.2, 3.4);
        at = (glint_vector)XYZ(0.7, 0.8, 0);
        field_of_view = GLINT_Q16(32);
    }
    stage_look(stage, eye, at, field_of_view);
    if (flags & FAR_VIEWER)
        stage->scene.viewer = GLINT_VIEWER_INFINITE;
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const struct option *option = &options[variant];
    const uint32_t flags = option->flags;
    glint_material ground = paint(option, (glint_colour)RGB(0.45, 0.55, 0.6));
    const glint_pose lie = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_pose widen = glint_pose_scale(GLINT_Q16(26), GLINT_ONE, GLINT_Q16(26));
    const glint_pose floor = glint_pose_then(&lie, &widen);
    const glint_q16 apart = flags & SKEWED ? GLINT_Q16(1.15) : 0;

    if (!(flags & DARK)) /* else its highlight would pass 1 */
        ground.specular = weigh(ground.specular, GLINT_Q16(0.4));
    stage_clear(stage, (glint_colour)RGB(0.2, 0.22, 0.25));
    look(stage, flags, frame);
    stage_add(stage, &plane1x1_mesh, &ground, &floor);
    add_cylinder(stage, option, flags & COLOURED ? &coloured_cylinder : &cylinder30x2_mesh, -apart, frame);
    if (flags & SKEWED)
        add_cylinder(stage, option, &cylinder_skewed_mesh, apart, frame);
    else
        add_foot(stage, option);
    add_light(stage, light_position(flags, frame), flags);
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
