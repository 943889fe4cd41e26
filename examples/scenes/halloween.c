/* SPDX-License-Identifier: MIT */
/* Jack-o'-lanterns that flicker under a cold moon. Things stand in each other, and the depth buffer sorts it out. */
#include "stage.h"

#include "meshes/bat_wing.h"
#include "meshes/box.h"
#include "meshes/cone24x1.h"
#include "meshes/cylinder24x1.h"
#include "meshes/flame.h"
#include "meshes/picket.h"
#include "meshes/plane1x1.h"
#include "meshes/plane24x16.h"
#include "meshes/pumpkin.h"
#include "meshes/pumpkin_grim.h"
#include "meshes/pumpkin_grim_lining.h"
#include "meshes/pumpkin_merry.h"
#include "meshes/pumpkin_merry_lining.h"
#include "meshes/sphere32x16.h"
#include "meshes/stars.h"
#include "meshes/stem.h"
#include "meshes/tombstone.h"
#include "meshes/tree.h"

#define FRAMES 48

enum { NIGHT, VERTEX, FLOODLIT, MISTY };

static const example_variant variants[] = {
    {"night",
     "Warm light flickers inside the pumpkins and on the ground, and skins and stones shine under the moon. Nothing "
     "casts a "
     "shadow: lamps are placed so that no wall would have to stop their light.",
     0, 0},
    {"vertex",
     "The same lit per vertex, its ground of 768 triangles in place of two: vertices that lie in the candles' light "
     "smear "
     "it.",
     0, 0},
    {"floodlit", "The same under white light: what the dark hides, and how thick the pumpkins' walls are.", 0, 0},
    {"misty", "The same in mist: it hides what is far away, and the candles make it glow.", 0, 0},
};

/* The sky, from the moon outwards: its middle, and rings of 24 vertices. Formatted by hand, a ring a line. */
/* clang-format off */
#define FOUR(r, g, b) {r, g, b}, {r, g, b}, {r, g, b}, {r, g, b},
#define TWELVE(r, g, b) FOUR(r, g, b) FOUR(r, g, b) FOUR(r, g, b)
#define RING(r, g, b) TWELVE(r, g, b) TWELVE(r, g, b)

static const uint8_t glow_colours[STAGE_DISC_VERTICES][3] = {
    {150, 160, 220},
    RING(150, 160, 220)
    RING(104, 114, 178)
    RING(74, 82, 142)
    RING(54, 61, 114)
    RING(38, 43, 88)
    RING(25, 29, 66)
    RING(13, 15, 42)
    RING(4, 5, 20)
};
/* clang-format on */

/* A matt surface, which night makes a little blue. */
static glint_material matt(glint_colour paint) {
    const glint_material material = {&glint_model_lambert,
                                     {stage_multiply(paint.r, GLINT_Q16(0.07)),
                                      stage_multiply(paint.g, GLINT_Q16(0.08)),
                                      stage_multiply(paint.b, GLINT_Q16(0.16))},
                                     paint,
                                     GREY(0),
                                     0,
                                     0};

    return material;
}

static glint_material shiny(glint_colour paint, glint_q16 specular, glint_q16 shininess) {
    glint_material material = matt(paint);

    material.model = &glint_model_phong;
    material.specular = (glint_colour){specular, specular, specular};
    material.shininess = shininess;
    return material;
}

static glint_material unlit(glint_colour colour) {
    const glint_material material = {&glint_model_unlit, GREY(0), colour, GREY(0), 0, 0};

    return material;
}

/* Sine of `turns` turns in FRAMES frames, begun at `start` degrees: what moves comes back to where it was. */
static glint_q16 wave(uint32_t frame, int turns, int start) {
    const int degrees = (int)(frame % FRAMES) * turns * 360 / FRAMES + start;

    return glint_sin((degrees % 360) * GLINT_ONE);
}

/* How bright a candle burns, about 1. */
static glint_q16 flicker(uint32_t frame, int start) {
    return GLINT_Q16(0.92) + stage_multiply(GLINT_Q16(0.16), wave(frame, 3, start)) +
           stage_multiply(GLINT_Q16(0.11), wave(frame, 7, 2 * start + 50)) +
           stage_multiply(GLINT_Q16(0.09), wave(frame, 13, 3 * start));
}

/* In mist the moon alone. */
static void add_sky(example_stage *stage, uint32_t variant) {
    const glint_material air = unlit((glint_colour)GREY(1)), star = unlit((glint_colour)RGB(0.6, 0.62, 0.75));
    const glint_material moon = unlit((glint_colour)RGB(0.95, 0.95, 0.85));
    const glint_pose far = stage_place((glint_vector)XYZ(1.35, 1.35, 1.35), 0, (glint_vector)XYZ(2.6, 5.0, -16));
    const glint_pose stars = stage_place((glint_vector)XYZ(10, 5, 1), 0, (glint_vector)XYZ(0, 5, -15.5));
    const glint_pose disc = stage_place((glint_vector)XYZ(1.3, 1.3, 1.3), 0, (glint_vector)XYZ(2.6, 5.0, -15));

    if (variant != MISTY) {
        stage->mesh = stage_disc;
        stage->mesh.colours = glow_colours;
        stage_add(stage, &stage->mesh, &air, &far);
        stage_add(stage, &stars_mesh, &star, &stars);
    }
    stage_add(stage, &sphere32x16_mesh, &moon, &disc);
}

static void add_land(example_stage *stage, uint32_t variant) {
    const glint_material wet = shiny((glint_colour)RGB(0.3, 0.27, 0.2), GLINT_Q16(0.25), GLINT_Q16(10));
    const glint_material grass = matt((glint_colour)RGB(0.3, 0.27, 0.2));
    const glint_material bark = matt((glint_colour)RGB(0.16, 0.13, 0.12));
    const glint_pose lie = glint_pose_rotate_x(GLINT_Q16(-90));
    const glint_pose wide = stage_place((glint_vector)XYZ(16, 1, 12), 0, (glint_vector)XYZ(0, 0, -3));
    const glint_pose ground = glint_pose_then(&lie, &wide);
    const glint_pose left = stage_place((glint_vector)XYZ(9, 2, 3), 0, (glint_vector)XYZ(-7, -0.6, -13));
    const glint_pose right = stage_place((glint_vector)XYZ(8, 1.6, 3), 0, (glint_vector)XYZ(7, -0.5, -12.5));
    const glint_pose root =
        stage_place((glint_vector)XYZ(1.25, 1.25, 1.25), GLINT_Q16(20), (glint_vector)XYZ(3, 0, -3.2));

    stage_add(stage, variant == VERTEX ? &plane24x16_mesh : &plane1x1_mesh, &wet, &ground);
    stage_add(stage, &sphere32x16_mesh, &grass, &left);
    stage_again(stage, &sphere32x16_mesh, &right);
    stage_add(stage, &tree_mesh, &bark, &root);
}

/* Rails right through the pickets, and pickets into the ground. */
static void add_fence(example_stage *stage) {
    const glint_material wood = matt((glint_colour)RGB(1, 0.9, 0.8));

    for (int i = 0; i < 6; i++) {
        const glint_vector at = {GLINT_Q16(0.25) + i * GLINT_Q16(0.52), (i * 5 % 3 - 1) * GLINT_Q16(0.05),
                                 GLINT_Q16(-1.7)};
        const glint_pose lean = glint_pose_rotate_z((i * 7 % 5 - 2) * GLINT_Q16(2.5));
        const glint_pose stand = stage_place((glint_vector)XYZ(1.2, 1.05, 1), 0, at);
        const glint_pose pose = glint_pose_then(&lean, &stand);

        if (i == 0)
            stage_add(stage, &picket_mesh, &wood, &pose);
        else
            stage_again(stage, &picket_mesh, &pose);
    }
    for (int i = 0; i < 2; i++) {
        const glint_pose rail =
            stage_place((glint_vector)XYZ(1.9, 0.055, 0.05), GLINT_Q16(1.5),
                        (glint_vector){GLINT_Q16(1.55), GLINT_Q16(0.35) + i * GLINT_Q16(0.5), GLINT_Q16(-1.7)});

        stage_again(stage, &box_mesh, &rail);
    }
}

static void add_tombstones(example_stage *stage) {
    const glint_material stone = shiny((glint_colour)RGB(0.42, 0.43, 0.46), GLINT_Q16(0.3), GLINT_Q16(5));
    const glint_pose lean = glint_pose_rotate_z(GLINT_Q16(-7));
    const glint_pose turn =
        stage_place((glint_vector)XYZ(0.95, 1.05, 1), GLINT_Q16(28), (glint_vector)XYZ(-2.3, 0, -0.9));
    const glint_pose front = glint_pose_then(&lean, &turn);
    const glint_pose back =
        stage_place((glint_vector)XYZ(0.8, 0.8, 1), GLINT_Q16(-15), (glint_vector)XYZ(-3.5, 0, -3.2));

    stage_add(stage, &tombstone_mesh, &stone, &front);
    stage_again(stage, &tombstone_mesh, &back);
}

/* A carved pumpkin. */
typedef struct lantern {
    const glint_mesh *skin, *lining;
    glint_vector middle;
    glint_q16 size, turn;
    int start; /* of its flicker, degrees */
} lantern;

static const lantern lanterns[] = {
    {&pumpkin_merry_mesh, &pumpkin_merry_lining_mesh, XYZ(-0.85, 0.62, 0.6), GLINT_Q16(1), GLINT_Q16(10), 0},
    {&pumpkin_grim_mesh, &pumpkin_grim_lining_mesh, XYZ(1.0, 0.39, 1.7), GLINT_Q16(0.65), GLINT_Q16(-16), 140},
};

/*
 * A candle. Nothing casts shadows, so what a pumpkin's wall would stop must not be sent there: one lamp looks at the
 * inside of its back, upwards, and falls off fast; the other looks out of its face, and leaves the neighbours alone.
 */
static void add_candle_light(example_stage *stage, const lantern *jack, glint_q16 bright) {
    const glint_colour warm = stage_times((glint_colour)RGB(5.5, 3, 0.9), stage_multiply(bright, jack->size));
    const glint_colour beam = stage_times((glint_colour)RGB(1.7, 0.85, 0.22), stage_multiply(bright, jack->size));
    glint_light *inside = stage_lamp(stage, &glint_light_spot, jack->middle, warm);
    glint_light *out = stage_lamp(stage, &glint_light_spot, jack->middle, beam);

    inside->direction.x = -glint_sin(jack->turn);
    inside->direction.y = GLINT_Q16(0.7);
    inside->direction.z = -glint_cos(jack->turn);
    inside->inner = GLINT_Q16(30);
    inside->outer = GLINT_Q16(62);
    inside->quadratic = GLINT_Q16(4);
    /* What falls through the face. */
    out->direction.x = glint_sin(jack->turn);
    out->direction.y = GLINT_Q16(-0.45);
    out->direction.z = glint_cos(jack->turn);
    out->inner = GLINT_Q16(8);
    out->outer = GLINT_Q16(38);
    out->quadratic = GLINT_Q16(0.12);
}

static void add_lantern(example_stage *stage, const lantern *jack, uint32_t frame) {
    const glint_q16 bright = flicker(frame, jack->start);
    const glint_vector size = {jack->size, jack->size, jack->size};
    const glint_pose pose = stage_place(size, jack->turn, jack->middle);
    const glint_pose up = glint_pose_translate(0, GLINT_Q16(0.5), 0);
    const glint_pose top = glint_pose_then(&up, &pose);
    const glint_pose dance = glint_pose_scale(GLINT_ONE, stage_multiply(bright, GLINT_Q16(0.9)), GLINT_ONE);
    const glint_pose wick = glint_pose_translate(stage_multiply(wave(frame, 5, jack->start), GLINT_Q16(0.03)),
                                                 GLINT_Q16(-0.5), GLINT_Q16(0.1));
    glint_pose flame = glint_pose_then(&dance, &wick);
    glint_material skin = shiny((glint_colour)RGB(0.85, 0.34, 0.05), GLINT_Q16(0.45), GLINT_Q16(10));
    glint_material flesh = matt((glint_colour)RGB(0.8, 0.52, 0.2));
    const glint_material stalk = matt((glint_colour)RGB(0.3, 0.36, 0.14));
    const glint_material fire = unlit((glint_colour)RGB(1, 0.92, 0.55));

    /* A lit pumpkin's skin glows through. */
    skin.ambient = stage_times((glint_colour)RGB(0.3, 0.1, 0.016), bright);
    flesh.ambient = stage_times((glint_colour)RGB(0.95, 0.52, 0.1), bright);
    flame = glint_pose_then(&flame, &pose);
    stage_add(stage, jack->skin, &skin, &pose);
    stage_add(stage, jack->lining, &flesh, &pose);
    stage_add(stage, &stem_mesh, &stalk, &top);
    stage_add(stage, &flame_mesh, &fire, &flame);
    add_candle_light(stage, jack, bright);
}

/* Air that a candle lights, half way to the eye, where the ground does not cut it. */
static void add_glow(example_stage *stage, const lantern *jack, uint32_t frame) {
    const glint_colour warm = stage_times((glint_colour)RGB(0.55, 0.28, 0.07), flicker(frame, jack->start));
    const glint_pose *eye = &stage->scene.camera.pose;
    const glint_vector between = {(eye->m[0][3] + jack->middle.x) / 2, (eye->m[1][3] + jack->middle.y) / 2,
                                  (eye->m[2][3] + jack->middle.z) / 2};

    stage_glow(stage, between, stage_multiply(jack->size, GLINT_Q16(1.2)), warm);
}

/* Brim and cone are stuck into the pumpkin below. */
static void add_hat(example_stage *stage) {
    const glint_material skin = shiny((glint_colour)RGB(0.8, 0.38, 0.07), GLINT_Q16(0.45), GLINT_Q16(10));
    const glint_material felt = shiny((glint_colour)RGB(0.22, 0.12, 0.3), GLINT_Q16(0.3), GLINT_Q16(6));
    const glint_vector middle = XYZ(2.35, 0.38, 0.2);
    const glint_pose body = stage_place((glint_vector)XYZ(0.65, 0.6, 0.65), GLINT_Q16(9), middle);
    const glint_pose stand = glint_pose_rotate_x(GLINT_Q16(-90)), lean = glint_pose_rotate_z(GLINT_Q16(-14));
    const glint_pose upright = glint_pose_then(&stand, &lean);
    const glint_pose long_cone = glint_pose_scale(GLINT_Q16(0.36), GLINT_Q16(0.36), GLINT_Q16(0.55));
    const glint_pose flat = glint_pose_scale(GLINT_Q16(0.62), GLINT_Q16(0.62), GLINT_Q16(0.025));
    const glint_pose tip = glint_pose_translate(GLINT_Q16(2.47), GLINT_Q16(1.14), GLINT_Q16(0.2));
    const glint_pose edge = glint_pose_translate(GLINT_Q16(2.38), GLINT_Q16(0.7), GLINT_Q16(0.2));
    glint_pose cone = glint_pose_then(&long_cone, &upright), brim = glint_pose_then(&flat, &upright);

    cone = glint_pose_then(&cone, &tip);
    brim = glint_pose_then(&brim, &edge);
    stage_add(stage, &pumpkin_mesh, &skin, &body);
    stage_add(stage, &cone24x1_mesh, &felt, &cone);
    stage_again(stage, &cylinder24x1_mesh, &brim);
}

/* A bat on its round before the moon, `start` degrees ahead. */
static void add_bat(example_stage *stage, uint32_t frame, int start, glint_q16 size) {
    const glint_material night = unlit((glint_colour)RGB(0.015, 0.012, 0.03));
    const glint_q16 flap = GLINT_Q16(12) + stage_multiply(GLINT_Q16(38), wave(frame, 8, start));
    const glint_vector at = {GLINT_Q16(0.7) + stage_multiply(GLINT_Q16(1.4), wave(frame, 1, start)),
                             GLINT_Q16(3.3) + stage_multiply(GLINT_Q16(0.35), wave(frame, 2, start + 60)),
                             GLINT_Q16(-4) + stage_multiply(GLINT_Q16(1.2), wave(frame, 1, start + 90))};

    for (int side = 1; side >= -1; side -= 2) {
        const glint_pose lift = glint_pose_rotate_z(flap), tilt = glint_pose_rotate_x(GLINT_Q16(55));
        const glint_pose wing = glint_pose_then(&lift, &tilt);
        const glint_pose place = stage_place((glint_vector){side * size, size, size}, GLINT_Q16(12), at);
        const glint_pose pose = glint_pose_then(&wing, &place);

        stage_add(stage, &bat_wing_mesh, &night, &pose);
    }
}

static void build(example_stage *stage, uint32_t variant, uint32_t frame) {
    const glint_colour dark = RGB(0.01, 0.01, 0.04), mist = RGB(0.07, 0.08, 0.15);
    const glint_vector moonlight = XYZ(-0.55, -0.75, -0.35), sunlight = XYZ(0.4, -0.8, -0.7);
    const glint_vector eye = {stage_multiply(GLINT_Q16(0.5), wave(frame, 1, 0)), GLINT_Q16(1.9), GLINT_Q16(7.6)};

    stage_clear(stage, variant == MISTY ? mist : dark);
    stage_look(stage, eye, (glint_vector)XYZ(0.15, 1.3, 0), GLINT_Q16(33));
    stage->scene.camera.near_plane = GLINT_ONE;
    if (variant != FLOODLIT)
        stage_sun(stage, moonlight, (glint_colour)RGB(0.42, 0.53, 0.8))->specular = (glint_colour)RGB(0.6, 0.75, 1.1);
    else
        stage_sun(stage, sunlight, (glint_colour)GREY(0.9));
    add_sky(stage, variant);
    add_land(stage, variant);
    add_fence(stage);
    add_tombstones(stage);
    for (uint32_t i = 0; i < COUNT_OF(lanterns); i++) {
        add_lantern(stage, &lanterns[i], frame);
        if (variant == MISTY)
            add_glow(stage, &lanterns[i], frame);
    }
    if (variant == MISTY)
        stage_fog(stage, &glint_fog_squared, GLINT_Q16(6), GLINT_Q16(24), mist);
    add_hat(stage);
    add_bat(stage, frame, 0, GLINT_Q16(0.42));
    add_bat(stage, frame, 150, GLINT_Q16(0.32));
    for (uint32_t i = 0; variant == VERTEX && i < stage->scene.object_count; i++)
        stage->objects[i].evaluation = &glint_per_vertex;
}

const example_scene example_halloween = {
    .name = "halloween",
    .summary = "Jack-o'-lanterns flicker under the moon, things stand in each other, and bats fly.",
    .variants = variants,
    .variant_count = COUNT_OF(variants),
    .frames = FRAMES,
    .width = 320,
    .height = 240,
    .build = build,
};
