/* SPDX-License-Identifier: MIT */
/* One statement about a surface a picture: spheres side by side. */
#include "stage.h"

#include "meshes/sphere48x32.h"
#include "meshes/torus12x8.h"
#include "meshes/torus12x8_averaged.h"

static const example_label metal_labels[] = {
    {"blue plastic", 56, 138, 0, 0}, {"gold", 160, 138, 0, 0}, {"gold paint", 264, 138, 0, 0}};
static const example_label colours_labels[] = {
    {"white surface", 56, 138, 0, 0}, {"green,\nyellow shine", 160, 138, 0, 0}, {"green,\nred shine", 264, 138, 0, 0}};
static const example_label lights_labels[] = {
    {"light 1", 60, 138, 0, 0}, {"light 2", 160, 138, 0, 0}, {"both", 260, 138, 0, 0}};
static const example_label max_labels[] = {{"lit + ambient", 80, 138, 0, 0}, {"max(lit, ambient)", 240, 138, 0, 0}};
static const example_label normals_labels[] = {
    {"facets' normals", 60, 138, 0, 0}, {"their means", 160, 138, 0, 0}, {"the formula's", 260, 138, 0, 0}};
static const example_label terms_labels[] = {{"ambient", 40, 138, 0, 0},
                                             {"diffuse", 120, 138, 0, 0},
                                             {"specular", 200, 138, 0, 0},
                                             {"sum, clamped", 280, 138, 0, 0},
                                             {"above 1", 268, 20, 270, 62}};
static const example_label ungated_labels[] = {{"gated", 80, 138, 0, 0},
                                               {"ungated", 240, 138, 0, 0},
                                               {"N.L = 0", 290, 20, 270, 42},
                                               {"N.L = 0", 130, 20, 110, 42}};
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
     "Blue plastic has a blurred white highlight, exponent 8, gold a sharp one of its own hue, exponent 32; the same "
     "gold with "
     "the plastic's looks like paint.",
     LABELS(metal_labels)},
    {"terms",
     "Ambient, diffuse and specular light, and their sum: where it passes 1 a channel is clamped, and a patch whitens.",
     LABELS(terms_labels)},
    {"ungated",
     "Lit from straight behind, N.L is above 0 in a rim of less than a pixel: gated, the left one is dark; on the "
     "right the "
     "highlight shines through the body.",
     LABELS(ungated_labels)},
    {"exponents", "Phong's highlight with exponents 1, 4, 16, 64 and 256.", LABELS(exponents_labels)},
    {"twice-near",
     "Light from near the eye: Blinn-Phong looks like Phong at four times the exponent; at twice it is too wide.",
     LABELS(twice_labels)},
    {"twice-far",
     "Light from the side: Phong's highlight is drawn out along the edge, 1.8 times as long as wide, Blinn-Phong's "
     "less, 1.3 times, whatever the exponent.",
     LABELS(twice_labels)},
    {"six-colours",
     "A light of blue ambient, amber diffuse and cyan specular light on three surfaces: each term is a product of two "
     "colours, so that a red shine gives nothing back of cyan.",
     LABELS(colours_labels)},
    {"two-lights",
     "An amber light, a blue one, and both: each adds its own diffuse and specular light; ambient light is in all "
     "three the "
     "same.",
     LABELS(lights_labels)},
    {"ambient-max",
     "Ambient light added to the rest, and the larger of the two taken: then the shade is flat, and what is lit no "
     "lighter.",
     LABELS(max_labels)},
    {"normals",
     "A torus of 192 triangles with normals of its facets, with the mean of the facets' at each vertex, and by the "
     "formula of a "
     "torus.",
     LABELS(normals_labels)},
};

static const glint_colour gold = RGB(0.62, 0.42, 0.12), blue = RGB(0.12, 0.22, 0.62);

/* A mesh `hundreds` of pixels right of the middle: the same pixels of each. @return the object */
static glint_object *add_beside(example_stage *stage, const glint_mesh *mesh, int hundreds, glint_q16 tilt,
                                glint_q16 size, const glint_material *material) {
    const glint_pose small = glint_pose_scale(size, size, size);
    const glint_pose turn = glint_pose_rotate_x(tilt);
    const glint_pose place = glint_pose_translate(hundreds * GLINT_Q16(2), GLINT_Q16(0.12), 0);
    const glint_pose turned = glint_pose_then(&small, &turn);
    const glint_pose pose = glint_pose_then(&turned, &place);

    return stage_add(stage, mesh, material, &pose);
}

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
        const glint_material material = {&glint_model_phong, part(paints[i], GLINT_Q16(0.2)),       paints[i],
                                         shine[i],           i == 1 ? GLINT_Q16(32) : GLINT_Q16(8), 0};

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
                                         GLINT_Q16(4),
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

/* The light's three colours and the surface's three: each term is a product. */
static void add_six_colours(example_stage *stage) {
    const glint_colour green = RGB(0.3, 0.7, 0.3);
    const glint_colour shine[3] = {GREY(0.9), RGB(0.9, 0.9, 0), RGB(0.9, 0, 0)};

    stage->scene.ambient = (glint_colour)RGB(0.1, 0.15, 0.4);
    stage->lights[0].diffuse = (glint_colour)RGB(0.9, 0.55, 0.15);
    stage->lights[0].specular = (glint_colour)RGB(0, 0.5, 0.5);
    for (int i = 0; i < 3; i++) {
        const glint_colour paint = i ? green : (glint_colour)GREY(0.7);
        const glint_material material = {&glint_model_phong, paint, paint, shine[i], GLINT_Q16(12), 0};

        add(stage, &sphere48x32_mesh, i, 3, GLINT_Q16(0.95), &material);
    }
}

/* Spots far away, narrow enough to light one sphere each: the first and third get light 1, the second and third
 * light 2. */
static void add_two_lights(example_stage *stage) {
    const glint_material material = {&glint_model_phong, RGB(0.14, 0.14, 0.14), RGB(0.6, 0.6, 0.6),
                                     GREY(0.35),         GLINT_Q16(12),         0};
    static const glint_vector to_light[2] = {XYZ(-6, 4, 8), XYZ(6, 1, 8)};
    const glint_colour colours[2] = {RGB(0.9, 0.5, 0.15), RGB(0.15, 0.35, 0.9)};

    stage->scene.light_count = 0;
    for (int i = 0; i < 3; i++) {
        (void)add_beside(stage, &sphere48x32_mesh, i - 1, 0, GLINT_Q16(0.7), &material);
        for (int j = 0; j < 2; j++) {
            const glint_vector at = {(i - 1) * GLINT_Q16(2) + to_light[j].x, GLINT_Q16(0.12) + to_light[j].y,
                                     to_light[j].z};

            if (i == j || i == 2) {
                glint_light *spot = stage_lamp(stage, &glint_light_spot, at, colours[j]);
                spot->direction = (glint_vector){-to_light[j].x, -to_light[j].y, -to_light[j].z};
                spot->inner = GLINT_Q16(4.5);
                spot->outer = GLINT_Q16(5);
            }
        }
    }
}

static void add_ambient_max(example_stage *stage) {
    for (int i = 0; i < 2; i++) {
        const glint_material material = {&glint_model_phong,
                                         part(gold, GLINT_Q16(0.4)),
                                         gold,
                                         GREY(0.5),
                                         GLINT_Q16(12),
                                         i ? GLINT_MATERIAL_MAX_WITH_AMBIENT : 0};

        add(stage, &sphere48x32_mesh, i, 2, GLINT_Q16(0.95), &material);
    }
}

static void add_normals(example_stage *stage) {
    const glint_material material = {&glint_model_phong, part(blue, GLINT_Q16(0.3)), blue, GREY(0.7), GLINT_Q16(12), 0};
    const glint_mesh *const meshes[3] = {&torus12x8_mesh, &torus12x8_averaged_mesh, &torus12x8_mesh};

    for (int i = 0; i < 3; i++)
        add_beside(stage, meshes[i], i - 1, GLINT_Q16(-35), GLINT_Q16(0.68), &material)->evaluation =
            i ? &glint_per_fragment : &glint_per_facet;
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    static void (*const adders[])(example_stage *
                                  stage) = {add_metal, add_terms,       add_ungated,    add_exponents,   add_twice,
                                            add_twice, add_six_colours, add_two_lights, add_ambient_max, add_normals};
    /* Of the sun; where there is none here it shines from the upper left. */
    static const glint_vector usual = XYZ(0.4, -0.6, -0.8);
    static const glint_vector directions[COUNT_OF(variants)] = {
        [2] = XYZ(-0.1, -0.1, 1), [4] = XYZ(0.06, -0.09, -1), [5] = XYZ(1, -0.35, -0.15)};
    const glint_vector eye = XYZ(0, 0, 180), at = XYZ(0, 0, 0);

    (void)frame;
    stage_clear(stage, (glint_colour)RGB(0.2, 0.22, 0.25)); /* lighter than the shade, darker than the light */
    stage_look(stage, eye, at, GLINT_Q16(1.0186)); /* from so far that all bodies are seen alike: 50 pixels a unit */
    stage_sun(stage, directions[variant].z ? directions[variant] : usual, (glint_colour)GREY(1));
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
