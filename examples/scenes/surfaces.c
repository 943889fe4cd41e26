/* SPDX-License-Identifier: MIT */
/* One statement about a surface a picture: spheres side by side. */
#include "stage.h"

#include "meshes/sphere48x32.h"

enum { METAL, TERMS, UNGATED, EXPONENTS, TWICE_NEAR, TWICE_FAR };

static const example_label metal_labels[] = {
    {"blue plastic", 56, 138, 0, 0}, {"gold", 160, 138, 0, 0}, {"gold paint", 264, 138, 0, 0}};
static const example_label terms_labels[] = {{"ambient", 40, 138, 0, 0},
                                             {"diffuse", 120, 138, 0, 0},
                                             {"specular", 200, 138, 0, 0},
                                             {"sum, clamped", 280, 138, 0, 0},
                                             {"above 1", 268, 20, 270, 62}};
static const example_label ungated_labels[] = {{"gated", 80, 138, 0, 0}, {"ungated", 240, 138, 0, 0}};
static const example_label exponents_labels[] = {{"1", 36, 138, 0, 0},
                                                 {"4", 98, 138, 0, 0},
                                                 {"16", 160, 138, 0, 0},
                                                 {"64", 222, 138, 0, 0},
                                                 {"256", 284, 138, 0, 0}};
static const example_label twice_labels[] = {{"Phong 12", 40, 138, 0, 0},
                                             {"Blinn-P. 12", 120, 138, 0, 0},
                                             {"Blinn-P. 24", 200, 138, 0, 0},
                                             {"Blinn-P. 48", 280, 138, 0, 0}};

#define LABELS(array) array, COUNT_OF(array)

static const example_variant variants[] = {
    {"metal",
     "Blue plastic has a white highlight, gold one of its own hue; the same gold with a white one looks like plastic.",
     LABELS(metal_labels)},
    {"terms",
     "Ambient, diffuse and specular light, and their sum: where it passes 1 a channel is clamped, and a patch whitens.",
     LABELS(terms_labels)},
    {"ungated",
     "Lit from behind: where N.L is 0 or less the left one gets no highlight; on the right it shines through the body.",
     LABELS(ungated_labels)},
    {"exponents", "Phong's highlight with exponents 1, 4, 16, 64 and 256.", LABELS(exponents_labels)},
    {"twice-near",
     "Light from near the eye: Blinn-Phong looks like Phong at four times the exponent; at twice it is too wide.",
     LABELS(twice_labels)},
    {"twice-far",
     "Light from the side: Phong's highlight is drawn out along the edge, Blinn-Phong's stays round, whatever the "
     "exponent.",
     LABELS(twice_labels)},
};

static const glint_colour gold = RGB(0.62, 0.42, 0.12), blue = RGB(0.12, 0.22, 0.62);

/* A row of `count` of a mesh, the one of number i with a material of its own. */
static void add(example_stage *stage, const glint_mesh *mesh, int i, int count, glint_q16 size,
                const glint_material *material) {
    const glint_pose small = glint_pose_scale(size, size, size);
    const glint_pose place = glint_pose_translate((2 * i - count + 1) * (GLINT_Q16(3.2) / count), GLINT_Q16(0.12), 0);
    const glint_pose pose = glint_pose_then(&small, &place);

    stage_add(stage, mesh, material, &pose);
}

static glint_colour part(glint_colour colour, glint_q16 weight) {
    const glint_colour product = {stage_multiply(colour.r, weight), stage_multiply(colour.g, weight),
                                  stage_multiply(colour.b, weight)};

    return product;
}

/* The same gold twice, once with the highlight of a plastic. */
static void add_metal(example_stage *stage) {
    const glint_colour paints[3] = {blue, gold, gold};
    const glint_colour shine[3] = {GREY(0.75), RGB(0.95, 0.68, 0.22), GREY(0.75)};

    for (int i = 0; i < 3; i++) {
        const glint_material material = {
            &glint_model_phong, part(paints[i], GLINT_Q16(0.2)), paints[i], shine[i], GLINT_Q16(8), 0};

        add(stage, &sphere48x32_mesh, i, 3, GLINT_Q16(0.95), &material);
    }
}

/* The terms one by one, and all of them. */
static void add_terms(example_stage *stage) {
    for (int i = 0; i < 4; i++) {
        glint_material material = {
            &glint_model_phong, part(gold, GLINT_Q16(0.3)), part(gold, GLINT_Q16(1.4)), GREY(0.9), GLINT_Q16(6), 0};

        if (i != 0 && i != 3)
            material.ambient = (glint_colour)GREY(0);
        if (i != 1 && i != 3)
            material.diffuse = (glint_colour)GREY(0);
        if (i != 2 && i != 3)
            material.specular = (glint_colour)GREY(0);
        add(stage, &sphere48x32_mesh, i, 4, GLINT_Q16(0.74), &material);
    }
}

static void add_ungated(example_stage *stage) {
    for (int i = 0; i < 2; i++) {
        const glint_material material = {&glint_model_blinn_phong,
                                         part(blue, GLINT_Q16(0.3)),
                                         blue,
                                         GREY(0.8),
                                         GLINT_Q16(12),
                                         i ? GLINT_MATERIAL_SPECULAR_UNGATED : 0};

        add(stage, &sphere48x32_mesh, i, 2, GLINT_Q16(0.95), &material);
    }
}

static void add_exponents(example_stage *stage) {
    for (int i = 0; i < 5; i++) {
        const glint_material material = {&glint_model_phong, part(blue, GLINT_Q16(0.2)), part(blue, GLINT_Q16(0.7)),
                                         GREY(0.8),          GLINT_ONE << 2 * i,         0};

        add(stage, &sphere48x32_mesh, i, 5, GLINT_Q16(0.6), &material);
    }
}

/* Phong, and Blinn-Phong with once, twice and four times its exponent; with nothing but highlight, told by its shape.
 */
static void add_twice(example_stage *stage) {
    for (int i = 0; i < 4; i++) {
        const glint_material material = {i ? &glint_model_blinn_phong : &glint_model_phong,
                                         RGB(0.04, 0.05, 0.09),
                                         GREY(0),
                                         GREY(0.9),
                                         i < 2    ? GLINT_Q16(12)
                                         : i == 2 ? GLINT_Q16(24)
                                                  : GLINT_Q16(48),
                                         0};

        add(stage, &sphere48x32_mesh, i, 4, GLINT_Q16(0.74), &material);
    }
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    static void (*const adders[])(example_stage * stage) = {add_metal,     add_terms, add_ungated,
                                                            add_exponents, add_twice, add_twice};
    static const glint_vector directions[] = {XYZ(0.4, -0.6, -0.8), XYZ(0.4, -0.6, -0.8), XYZ(-0.5, -0.35, 0.6),
                                              XYZ(0.4, -0.6, -0.8), XYZ(0.06, -0.09, -1), XYZ(1, -0.35, -0.15)};
    const glint_vector eye = XYZ(0, 0, 180), at = XYZ(0, 0, 0);

    (void)frame;
    stage_clear(stage, (glint_colour)GREY(0));
    stage_look(stage, eye, at, GLINT_Q16(1.0186)); /* from so far that all bodies are seen alike: 50 pixels a unit */
    stage_sun(stage, directions[variant], (glint_colour)GREY(1));
    adders[variant](stage);
}

const example_scene example_surfaces = {
    .name = "surfaces",
    .summary = "What each part of a material does: one statement a picture.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = 1,
    .width = 320,
    .height = 160,
    .build = build,
};
