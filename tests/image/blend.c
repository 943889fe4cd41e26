/* SPDX-License-Identifier: MIT */
/*
 * Suite: glass, glows and fog. Blended pictures are what double precision makes of the same scene, and, bit for bit,
 * what pictures of their objects make when they are blended level by level; in any order of objects, tiles, arena and
 * region. A user would see glass in front of what hides it, seams between tiles, glows that wrap from white to black,
 * or fog that begins at the wrong depth.
 */
#include "equivalence/ways.h"
#include "every_format.h"
#include "glint_extras.h"
#include "harness.h"
#include "library_geometry.h"
#include "picture.h"
#include "reference.h"
#include "sample.h"
#include "stability/contract.h"
#include "stability/random_layers.h"
#include "stability/random_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 120
#define HEIGHT 88
#define PIXELS (WIDTH * HEIGHT)

/* ---- Scenes -------------------------------------------------------------------------------------------------- */

enum { FLOOR, BOX, GLASS, GLOW, MIST, FENCE, OBJECTS };

#define VERTICES_MAX 320
#define TRIANGLES_MAX 512
#define TEXELS 16

typedef struct stage_mesh {
    int16_t positions[VERTICES_MAX][3], normals[VERTICES_MAX][3], coordinates[VERTICES_MAX][2];
    uint16_t triangles[TRIANGLES_MAX][3];
    glint_mesh mesh;
} stage_mesh;

/* A scene and all it points to; not to be moved once made. */
typedef struct stage {
    stage_mesh meshes[OBJECTS];
    glint_material materials[OBJECTS];
    glint_object objects[OBJECTS];
    glint_light lights[2];
    glint_texture fence;
    uint8_t texels[TEXELS * TEXELS];
    glint_fog fog;
    glint_scene scene;
    picture_options how;
} stage;

/* Places on a texture are those of the front seen from +z. */
static void add_mesh(stage *s, int object, int kind) {
    stage_mesh *const m = &s->meshes[object];
    const glint_mesh_room room = {m->positions, m->normals, m->triangles, VERTICES_MAX, TRIANGLES_MAX};
    const glint_q16 one = GLINT_ONE;
    const glint_status status = kind == 0   ? glint_generate_plane(&m->mesh, &room, 4, 4, 3 * one, 3 * one)
                                : kind == 1 ? glint_generate_box(&m->mesh, &room, one / 2, one / 3, one / 2)
                                : kind == 2 ? glint_generate_torus(&m->mesh, &room, 18, 12, one, one / 3)
                                            : glint_generate_sphere(&m->mesh, &room, 14, 9, one / 2);
    CHECK_EQUAL(status, GLINT_OK);
    for (uint32_t i = 0; i < m->mesh.vertex_count; i++)
        for (int axis = 0; axis < 2; axis++)
            m->coordinates[i][axis] = m->positions[i][axis];
    m->mesh.texture_coordinates = (const int16_t(*)[2])m->coordinates;
    m->mesh.texture_extent[0] = m->mesh.texture_extent[1] = 2 * one;
    s->objects[object].mesh = &m->mesh;
}

/* Bars with holes between them. */
static void make_fence(stage *s) {
    for (int i = 0; i < TEXELS * TEXELS; i++)
        s->texels[i] = i % 4 < 2 || i / TEXELS % 8 < 2 ? (uint8_t)(90 + i % 7 * 20) : 0;
    s->fence = (glint_texture){&glint_texture_grey8, s->texels, NULL, TEXELS, TEXELS, GLINT_TEXTURE_HAS_KEY, 0};
    s->materials[FENCE].texture = &s->fence;
}

static void set_look(stage *s, int object, glint_colour paint, glint_blend blend, glint_q16 opacity) {
    s->materials[object] = glint_material_paint(&glint_model_blinn_phong, paint, GLINT_ONE / 4, 20 * GLINT_ONE);
    s->materials[object].specular = (glint_colour)GLINT_COLOUR(0.2, 0.2, 0.2);
    s->materials[object].blend = blend;
    s->materials[object].opacity = opacity;
    s->objects[object].material = &s->materials[object];
    s->objects[object].evaluation = &glint_per_fragment;
}

/*
 * A floor and a box, a ring of glass that stands around the box and through the floor, a glow, a ball that covers half
 * of its pixels, and a fence of glass. The camera goes around them.
 */
static stage *make_stage(int view) {
    static stage the_stage;
    stage *const s = &the_stage;
    const glint_colour white = GLINT_COLOUR(0.7, 0.7, 0.7), sand = GLINT_COLOUR(0.7, 0.6, 0.4),
                       red = GLINT_COLOUR(0.8, 0.2, 0.1), blue = GLINT_COLOUR(0.2, 0.4, 0.9),
                       amber = GLINT_COLOUR(0.9, 0.6, 0.1), green = GLINT_COLOUR(0.2, 0.7, 0.3);
    const glint_vector down = GLINT_VECTOR(-0.5, -1, -0.7);
    static const int kinds[OBJECTS] = {0, 1, 2, 3, 3, 0};
    memset(s, 0, sizeof *s);
    for (int i = 0; i < OBJECTS; i++)
        add_mesh(s, i, kinds[i]);
    set_look(s, FLOOR, sand, GLINT_BLEND_NONE, 0);
    set_look(s, BOX, red, GLINT_BLEND_NONE, 0);
    set_look(s, GLASS, blue, GLINT_BLEND_ALPHA, GLINT_Q16(0.4));
    set_look(s, GLOW, amber, GLINT_BLEND_ADD, GLINT_Q16(0.8));
    set_look(s, MIST, green, GLINT_BLEND_DITHERED, GLINT_Q16(0.5));
    set_look(s, FENCE, white, GLINT_BLEND_ALPHA, GLINT_Q16(0.7));
    make_fence(s);
    s->objects[FLOOR].pose = glint_pose_rotate_x(-90 * GLINT_ONE);
    s->objects[FLOOR].pose.m[1][3] = GLINT_Q16(-0.6);
    s->objects[BOX].pose = glint_pose_rotate_y(30 * GLINT_ONE);
    s->objects[GLASS].pose = glint_pose_rotate_x(20 * GLINT_ONE);
    s->objects[GLOW].pose = glint_pose_translate(GLINT_Q16(0.9), GLINT_Q16(0.3), GLINT_Q16(0.4));
    s->objects[MIST].pose = glint_pose_translate(GLINT_Q16(-0.8), GLINT_Q16(0.1), GLINT_Q16(0.5));
    s->objects[FENCE].pose = glint_pose_scale(GLINT_ONE / 4, GLINT_ONE / 4, GLINT_ONE / 4);
    s->objects[FENCE].pose.m[2][3] = GLINT_Q16(1.5);
    s->meshes[FENCE].mesh.flags = GLINT_MESH_DOUBLE_SIDED;
    s->lights[0] = glint_sun(down, white);
    s->scene = (glint_scene){.camera = glint_camera_default(),
                             .background = GLINT_COLOUR(0.2, 0.4, 0.2),
                             .ambient = white,
                             .lights = s->lights,
                             .light_count = 1,
                             .objects = s->objects,
                             .object_count = OBJECTS};
    glint_camera_orbit(&s->scene.camera, (glint_vector){0, 0, 0}, 47 * view * GLINT_ONE, (11 + 5 * view) * GLINT_ONE,
                       GLINT_Q16(4.2));
    s->how.layers = &glint_layers;
    s->fog = (glint_fog){&glint_fog_linear, GLINT_COLOUR(0.6, 0.6, 0.7), 2 * GLINT_ONE, 7 * GLINT_ONE, 0};
    return s;
}

static picture draw(const stage *s, const glint_format *format, uint16_t *depth) {
    picture image = picture_open(WIDTH, HEIGHT, format);
    picture_options how = s->how;
    how.depth = depth;
    CHECK_EQUAL(picture_render(&image, &s->scene, &how, NULL), GLINT_OK);
    return image;
}

/* ---- Against double precision -------------------------------------------------------------------------------- */

static long judged, left_out;

static void check_contract(const stage *s, const glint_format *format) {
    contract_result result;
    contract_judge_blended(&s->scene, WIDTH, HEIGHT, format, &s->how, &result);
    CHECK_EQUAL(result.found.status, GLINT_OK);
    CHECK_EQUAL(result.found.missed, 0);
    CHECK(contract_holds(&result));
    judged += result.found.judged;
    left_out += PIXELS - result.found.judged;
}

static void begin_count(void) {
    judged = left_out = 0;
}

/* Most pixels were judged. */
static void end_count(void) {
    test_write("  judged: ");
    test_write_number(judged);
    test_write(", left out: ");
    test_write_number(left_out);
    test_write("\n");
    CHECK(left_out < judged / 3);
}

/* Every format, and each way to light. */
static void blended_levels_are_those_of_double_precision(void) {
    static const glint_evaluation *const evaluations[4] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet,
                                                           &glint_per_fragment};
    begin_count();
    for (int i = 0; i < 2 * FORMAT_COUNT; i++) {
        stage *const s = make_stage(i);
        for (int object = 0; object < OBJECTS; object++) {
            s->objects[object].evaluation = evaluations[(i + object / 2) % 4];
            if (i % 4 == 3)
                s->materials[object].model = &glint_model_unlit;
        }
        check_contract(s, every_format[i % FORMAT_COUNT]);
    }
    end_count();
}

/* Parallel rays, a painted background, any opacity. */
static void views_and_opacities_are_blended(void) {
    begin_count();
    for (int i = 0; i < 24; i++) {
        const glint_format *const format = every_format[i % 3 * 5 % FORMAT_COUNT];
        stage *const s = make_stage(i);
        for (int object = GLASS; object < OBJECTS; object++)
            s->materials[object].opacity = (i * 7321 + object * 11003) % (GLINT_ONE + 1);
        if (i % 2) {
            s->scene.camera.projection = &glint_orthographic;
            s->scene.camera.view_height = 4 * GLINT_ONE;
        }
        if (i % 3)
            s->how.background = (glint_painter){picture_paint_pattern, (void *)(uintptr_t)format};
        check_contract(s, format);
    }
    end_count();
}

/* Any lights, meshes and depths, some with textures or parallel rays, half of them in fog. */
static void random_scenes_are_blended(void) {
    static random_scene s;
    begin_count();
    for (uint64_t seed = 0; seed < 900 / sample_share(); seed++) {
        source random = {~seed};
        contract_result result;
        if (seed % 3)
            random_scene_make(&s, seed);
        else
            random_scene_make_in(&s, RANDOM_TEXTURED_REGION, seed);
        if (!random_regions[s.region].in_contract)
            continue;
        random_layers_add(&s.scene, s.objects, s.materials, &s.fog, &random);
        if (seed % 5 == 1 && s.region < RANDOM_DEEP_REGION) {
            s.scene.camera.projection = &glint_orthographic;
            s.scene.camera.view_height = 4 * GLINT_ONE;
        }
        contract_judge(&s.scene, s.width, s.height, s.format, &result);
        CHECK_EQUAL(result.found.status, GLINT_OK);
        if (!CHECK(contract_holds(&result)))
            test_write_number((int64_t)seed);
        judged += result.found.judged;
        left_out += s.width * s.height - result.found.judged;
    }
    end_count();
}

/* ---- Against its own objects ------------------------------------------------------------------------------------- */

/* Makes an object a texture that is all hole: it counts for depths and is not seen. */
static void make_ghost(stage *s, int object) {
    static const uint16_t hole = 7;
    static const glint_texture nothing = {&glint_texture_rgb565, &hole, NULL, 1, 1, GLINT_TEXTURE_HAS_KEY, 7};
    s->materials[object].texture = &nothing;
    s->materials[object].blend = GLINT_BLEND_NONE;
}

static int is_layer(const stage *s, int object) {
    return s->materials[object].blend == GLINT_BLEND_ALPHA || s->materials[object].blend == GLINT_BLEND_ADD;
}

/* A stage like another; what points into the first one stays there but for materials. */
static stage *copy_stage(const stage *s) {
    static stage copy;
    copy = *s;
    for (int i = 0; i < OBJECTS; i++)
        copy.objects[i].material = &copy.materials[i];
    copy.scene.objects = copy.objects;
    return &copy;
}

/* Blends levels as glint_extras.h says. */
static int blend_level(const glint_format *format, int x, int y, int old, int over, int most,
                       const glint_material *material) {
    const int fine = (material->opacity + 128) / 256, part_of_32 = (fine + 4) / 8; /* rounded to nearest */
    const double part = glint_row_bytes(format, 8) == 16 ? part_of_32 / 32.0 : fine / 256.0;
    const double kept = material->blend == GLINT_BLEND_ADD ? 1 : 1 - part;
    const double level = floor(kept * old + part * over + picture_threshold(format, x, y));
    return level > most ? most : (int)level;
}

/* The picture of a stage without what is blended, then of each layer alone, blended over the levels before. */
static void check_composition(const stage *s, const glint_format *format) {
    static uint16_t depth[PIXELS], layer_depth[PIXELS];
    static int levels[PIXELS][3];
    uint32_t layers[OBJECTS];
    const uint32_t count = reference_find_layers(&s->scene, layers);
    long wrong = 0;
    for (uint32_t layer = 0; layer <= count; layer++) {
        stage *const alone = copy_stage(s);
        for (int i = 0; i < OBJECTS; i++)
            if (layer ? i != (int)layers[layer - 1] : is_layer(s, i))
                make_ghost(alone, i);
        if (layer)
            alone->materials[layers[layer - 1]].blend = GLINT_BLEND_NONE;
        picture image = draw(alone, format, layer ? layer_depth : depth);
        for (int i = 0; i < PIXELS; i++)
            for (int c = 0; c < picture_channels(format); c++) {
                const int x = i % WIDTH, y = i / WIDTH, level = picture_level(&image, x, y, c);
                if (!layer)
                    levels[i][c] = level;
                else if (layer_depth[i] > depth[i])
                    levels[i][c] = blend_level(format, x, y, levels[i][c], level, picture_level_max(format, c),
                                               &s->materials[layers[layer - 1]]);
            }
        picture_close(&image);
    }
    picture blended = draw(s, format, layer_depth);
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < picture_channels(format); c++)
            wrong += picture_level(&blended, i % WIDTH, i / WIDTH, c) != levels[i][c];
    picture_close(&blended);
    CHECK_EQUAL(wrong, 0);
    CHECK(memcmp(depth, layer_depth, sizeof depth) == 0); /* what is blended leaves none */
}

/* In every format, with and without output tables, over a plain background and a painted one. */
static void levels_are_blended_exactly(void) {
    for (int i = 0; i < 2 * FORMAT_COUNT; i++) {
        const glint_format *const format = every_format[i % FORMAT_COUNT];
        stage *const s = make_stage(i);
        for (int object = GLASS; object < OBJECTS; object++)
            s->materials[object].opacity = (i * 5417 + object * 9001) % (GLINT_ONE + 1);
        if (i / FORMAT_COUNT)
            s->how.gamma = glint_gamma_srgb;
        if (i % 3 == 1)
            s->how.background = (glint_painter){picture_paint_pattern, (void *)(uintptr_t)format};
        if (i % 5 == 1)
            s->scene.camera.projection = &glint_orthographic;
        s->scene.camera.view_height = 4 * GLINT_ONE;
        check_composition(s, format);
    }
}

/* Sums end at white. */
static void glows_end_at_white(void) {
    for (int i = 0; i < FORMAT_COUNT; i++) {
        stage *const s = make_stage(i);
        long white = 0;
        for (int object = GLASS; object < OBJECTS; object++) {
            s->materials[object].blend = GLINT_BLEND_ADD;
            s->materials[object].opacity = GLINT_ONE;
            s->materials[object].ambient = (glint_colour)GLINT_COLOUR(1, 1, 1);
        }
        s->objects[GLOW].pose = s->objects[FENCE].pose = s->objects[GLASS].pose;
        check_composition(s, every_format[i]);
        picture image = draw(s, every_format[i], NULL);
        for (int j = 0; j < PIXELS; j++)
            white += picture_level(&image, j % WIDTH, j / WIDTH, 0) == picture_level_max(every_format[i], 0);
        picture_close(&image);
        CHECK(white > PIXELS / 50);
    }
}

/* A pattern of pixels shows the object as if it were opaque, in colour and depth, and the others as if there were
 * none. */
static void dithered_objects_cover_their_pixels(void) {
    static uint16_t depths[3][PIXELS];
    for (int i = 0; i < 40; i++) {
        const glint_format *const format = every_format[i % FORMAT_COUNT];
        stage *const s = make_stage(i);
        long wrong = 0;
        for (int object = GLASS; object < OBJECTS; object++)
            make_ghost(s, object);
        s->materials[MIST] = s->materials[BOX];
        s->materials[MIST].blend = GLINT_BLEND_DITHERED;
        s->materials[MIST].opacity = i < 4 ? GLINT_ONE * (i / 2) : (i * 8191) % GLINT_ONE;
        if (i % 2) {
            const glint_object first = s->objects[FLOOR]; /* the order does not count */
            s->objects[FLOOR] = s->objects[MIST];
            s->objects[MIST] = first;
        }
        stage *const other = copy_stage(s);
        for (int j = 0; j < OBJECTS; j++)
            other->objects[j].material = &other->materials[s->objects[j].material - s->materials];
        picture images[3];
        images[0] = draw(s, format, depths[0]);
        other->materials[MIST].blend = GLINT_BLEND_NONE;
        images[1] = draw(other, format, depths[1]);
        make_ghost(other, MIST);
        images[2] = draw(other, format, depths[2]);
        for (int j = 0; j < PIXELS; j++) {
            const int x = j % WIDTH, y = j / WIDTH;
            const double threshold = picture_threshold(&glint_format_mono_dithered, x, y);
            const int which = threshold * GLINT_ONE < s->materials[MIST].opacity ? 1 : 2;
            wrong += depths[0][j] != depths[which][j];
            for (int c = 0; c < picture_channels(format); c++)
                wrong += picture_level(&images[0], x, y, c) != picture_level(&images[which], x, y, c);
        }
        CHECK_EQUAL(wrong, 0);
        for (int j = 0; j < 3; j++)
            picture_close(&images[j]);
    }
}

/* ---- Order --------------------------------------------------------------------------------------------------- */

static void swap_objects(stage *s, int a, int b) {
    const glint_object object = s->objects[a];
    s->objects[a] = s->objects[b];
    s->objects[b] = object;
}

/* Layers are sorted, so that where they stand in the scene changes nothing, and from where they are seen does. */
static void order_in_the_scene_changes_nothing(void) {
    for (int i = 0; i < 12; i++) {
        stage *const s = make_stage(i);
        picture image = draw(s, &glint_format_rgb888, NULL);
        swap_objects(s, GLASS, i % 2 ? FENCE : GLOW);
        CHECK(picture_draws_same(&image, &s->scene, &s->how, NULL));
        swap_objects(s, FLOOR, FENCE);
        CHECK(picture_draws_same(&image, &s->scene, &s->how, NULL));
        picture_close(&image);
    }
}

/* The field decides before depth does; and where both tie, the scene's order. */
static void order_is_asked_for_and_ties_are_the_scenes(void) {
    static const int16_t orders[6][3] = {{0, 1, 2}, {2, 1, 0}, {-1, 0, -2}, {32767, -32768, 0}, {0, 0, -1}, {5, 5, 5}};
    long changed = 0;
    for (int i = 0; i < 12; i++) {
        stage *const s = make_stage(i);
        for (int object = GLASS; object < OBJECTS; object++) {
            s->materials[object].blend = GLINT_BLEND_ALPHA;
            if (i % 2)
                s->objects[object].pose = s->objects[GLASS].pose;
        }
        picture image = draw(s, &glint_format_rgb888, NULL);
        for (int object = 0; object < 3; object++)
            s->objects[GLASS + object].order = orders[i % 6][object];
        changed += !picture_draws_same(&image, &s->scene, &s->how, NULL);
        check_composition(s, &glint_format_rgb888);
        check_contract(s, &glint_format_rgb565);
        picture_close(&image);
    }
    CHECK(changed > 4);
}

/* ---- Ends ---------------------------------------------------------------------------------------------------- */

/* With opacity 0 nothing changes, and with opacity 1 glass is as opaque: the same bits, with fog too. */
static void ends_of_opacity_are_exact(void) {
    for (int i = 0; i < 3 * FORMAT_COUNT; i++) {
        const glint_format *const format = every_format[i % FORMAT_COUNT];
        stage *const s = make_stage(i);
        for (int object = GLOW; object < OBJECTS; object++)
            make_ghost(s, object);
        s->scene.fog = i % 2 ? &s->fog : NULL;
        s->materials[GLASS].blend = GLINT_BLEND_NONE;
        picture opaque = draw(s, format, NULL);
        s->materials[GLASS].blend = GLINT_BLEND_ALPHA;
        s->materials[GLASS].opacity = GLINT_ONE;
        CHECK(picture_draws_same(&opaque, &s->scene, &s->how, NULL));
        s->materials[GLASS].blend = GLINT_BLEND_DITHERED;
        CHECK(picture_draws_same(&opaque, &s->scene, &s->how, NULL));
        stage *const other = copy_stage(s);
        make_ghost(other, GLASS);
        picture without = draw(other, format, NULL);
        for (int blend = GLINT_BLEND_ALPHA; blend <= GLINT_BLEND_DITHERED; blend++) {
            s->materials[GLASS].blend = (glint_blend)blend;
            s->materials[GLASS].opacity = 0;
            CHECK(picture_draws_same(&without, &s->scene, &s->how, NULL));
        }
        picture_close(&opaque);
        picture_close(&without);
    }
}

/* ---- Fog ----------------------------------------------------------------------------------------------------- */

static void set_fog(stage *s, int i, const glint_format *format) {
    s->scene.fog = &s->fog;
    s->fog.type = i % 2 ? &glint_fog_squared : &glint_fog_linear;
    s->fog.to_background = (uint8_t)(i / 2 % 2);
    if (i / 2 % 4 == 3)
        s->how.background = (glint_painter){picture_paint_pattern, (void *)(uintptr_t)format};
    if (i / 8 % 2) {
        s->scene.camera.projection = &glint_orthographic;
        s->scene.camera.view_height = 4 * GLINT_ONE;
    }
}

/* Linear and squared, to a colour, a background and a painted one, with parallel rays or not, in all formats. */
static void fog_is_that_of_double_precision(void) {
    begin_count();
    for (int i = 0; i < 4 * FORMAT_COUNT; i++) {
        const glint_format *const format = every_format[i % 5 * 3 % FORMAT_COUNT];
        stage *const s = make_stage(i);
        set_fog(s, i, format);
        if (i % 3 == 0) /* nothing but fog */
            for (int object = GLASS; object < OBJECTS; object++)
                s->materials[object].blend = GLINT_BLEND_NONE;
        check_contract(s, format);
    }
    end_count();
}

/* A floor from before the fog to behind it, leaning away from the eye; it is no nearer than it has to be, so that
 * depth has many steps. */
static void fog_reaches_from_start_to_end(void) {
    static const int lengths[8][2] = {{0, 1}, {1, 40}, {3, 10}, {30, 60}, {2, 3}, {20, 22}, {0, 100}, {50, 51}};
    begin_count();
    for (int i = 0; i < 128; i++) {
        const int start = lengths[i / 16][0], end = lengths[i / 16][1];
        const glint_q16 size = (end - start) * GLINT_ONE / 4;
        stage *const s = make_stage(0);
        s->scene.object_count = 1;
        set_fog(s, i, i % 3 ? &glint_format_rgb888 : &glint_format_rgb565);
        s->fog.start = start * GLINT_ONE + 3 * i;
        s->fog.end = end * GLINT_ONE + 5 * i;
        s->objects[FLOOR].pose = glint_pose_rotate_x(-80 * GLINT_ONE);
        const glint_pose wide = glint_pose_scale(size, size, size);
        s->objects[FLOOR].pose = glint_pose_then(&wide, &s->objects[FLOOR].pose);
        s->objects[FLOOR].pose.m[2][3] = -(start + end) * GLINT_ONE / 2;
        s->scene.camera.pose = glint_pose_identity();
        s->scene.camera.near_plane = GLINT_ONE / 16;
        s->scene.camera.field_of_view = (end - start) * 32 > end ? 40 * GLINT_ONE : 4 * GLINT_ONE;
        s->scene.camera.view_height = size;
        check_contract(s, i % 3 ? &glint_format_rgb888 : &glint_format_rgb565);
    }
    end_count();
}

/* A plane that faces parallel rays, and nothing else: all that is seen is as far, and as deep in the fog. */
static void fog_of_one_distance(void) {
    begin_count();
    for (int i = 0; i < FORMAT_COUNT; i++) {
        stage *const s = make_stage(0);
        s->scene.object_count = 1;
        set_fog(s, 8 + i % 2, every_format[i]);
        s->objects[FLOOR].pose = glint_pose_translate(0, 0, -(3 + i % 3) * GLINT_ONE);
        s->scene.camera.pose = glint_pose_identity();
        check_contract(s, every_format[i]);
    }
    end_count();
}

/* Fog that begins behind all is none; and fog to a plain background is fog of its colour. */
static void fog_beyond_and_of_the_background(void) {
    long changed = 0;
    for (int i = 0; i < FORMAT_COUNT; i++) {
        stage *const s = make_stage(i);
        picture clear = draw(s, every_format[i], NULL);
        s->scene.fog = &s->fog;
        s->fog.start = 1000 * GLINT_ONE;
        s->fog.end = 1001 * GLINT_ONE;
        CHECK(picture_draws_same(&clear, &s->scene, &s->how, NULL));
        s->fog.start = GLINT_ONE;
        s->fog.end = 9 * GLINT_ONE;
        s->fog.colour = s->scene.background;
        picture coloured = draw(s, every_format[i], NULL);
        s->fog.to_background = 1;
        CHECK(picture_draws_same(&coloured, &s->scene, &s->how, NULL));
        changed += !picture_equal(&coloured, &clear);
        s->how.layers = NULL; /* no need of layers where nothing blends */
        for (int object = GLASS; object < OBJECTS; object++)
            s->materials[object].blend = GLINT_BLEND_NONE;
        picture opaque = draw(s, every_format[i], NULL);
        s->how.layers = &glint_layers;
        CHECK(picture_draws_same(&opaque, &s->scene, &s->how, NULL));
        picture_close(&clear);
        picture_close(&coloured);
        picture_close(&opaque);
    }
    CHECK(changed > FORMAT_COUNT / 2);
}

/* ---- Ways ---------------------------------------------------------------------------------------------------- */

/* Draws with all of ways.c, and every share of the arena, where passes divide a tile too. */
static void tiles_arenas_and_regions_change_nothing(void) {
    for (int i = 0; i < 3 * FORMAT_COUNT; i++) {
        const glint_format *const format = every_format[i % FORMAT_COUNT];
        stage *const s = make_stage(i);
        if (i % 2)
            set_fog(s, i / 2, format);
        if (i % 3 == 0)
            s->how.gamma = glint_gamma_srgb;
        picture image = draw(s, format, NULL);
        for (uint32_t j = 0; j < 4 * way_count; j++)
            CHECK(ways[j / 4].draws_same(&image, &s->scene, &s->how, (uint32_t)i * 977 + j * 2654435761u));
        picture_options how = s->how;
        how.tile_width = how.tile_height = 64;
        const glint_need need = picture_need(&image, &s->scene, &how);
        uint32_t most = 0;
        for (uint32_t share = 0; share <= 256; share += i < 4 ? 4 : 64) {
            glint_stats stats;
            how.arena_size = picture_arena(&need, share);
            CHECK(picture_draws_same(&image, &s->scene, &how, &stats));
            most = stats.passes > most ? stats.passes : most;
        }
        CHECK(most > 4); /* of 4 tiles: passes divided one */
        picture_close(&image);
    }
}

/* What is painted last is painted over all, where depth shows what is not blended. */
static glint_segment segments[8];

static int paint_lines(void *context, const glint_tile *tile) {
    (void)context;
    return glint_lines_draw(tile, segments, TEST_COUNT(segments));
}

static void lines_are_drawn_over_layers(void) {
    static uint16_t depths[2][PIXELS];
    glint_line lines[TEST_COUNT(segments)];
    const glint_pose still = glint_pose_identity();
    for (uint32_t i = 0; i < TEST_COUNT(lines); i++)
        lines[i] = (glint_line){{-3 * GLINT_ONE, (glint_q16)i * 9000 - 30000, (glint_q16)i * 20000 - 60000},
                                {3 * GLINT_ONE, 20000 - (glint_q16)i * 5000, 50000 - (glint_q16)i * 9000},
                                GLINT_COLOUR(1, 1, 0)};
    for (int i = 0; i < 8; i++) {
        long wrong = 0, shown = 0;
        stage *const s = make_stage(i), *const other = copy_stage(s);
        picture image = draw(s, &glint_format_rgb888, depths[0]);
        for (int object = GLASS; object < OBJECTS; object++)
            if (is_layer(other, object))
                make_ghost(other, object);
        const glint_config config = picture_config(&image, &s->how);
        CHECK_EQUAL(glint_lines_project(segments, &config, &s->scene.camera, &still, lines, TEST_COUNT(lines)),
                    GLINT_OK);
        s->how.overlay = other->how.overlay = (glint_painter){paint_lines, NULL};
        picture lined = draw(s, &glint_format_rgb888, depths[1]), bare = draw(other, &glint_format_rgb888, depths[1]);
        for (int j = 0; j < PIXELS; j++) {
            const picture *const expected = depths[0][j] == depths[1][j] ? &image : &bare;
            wrong += memcmp(&lined.bytes[3 * j], &expected->bytes[3 * j], 3) != 0;
            shown += expected == &bare;
        }
        CHECK_EQUAL(wrong, 0);
        CHECK(shown > 100);
        picture_close(&image);
        picture_close(&lined);
        picture_close(&bare);
    }
}

/* ---- Picks --------------------------------------------------------------------------------------------------- */

/* What is picked is the nearest surface, whether it is blended or not. */
static void blended_surfaces_are_picked(void) {
    static reference_pixel pixels[PIXELS], alone[PIXELS];
    const reference_image nearest = {WIDTH, HEIGHT, pixels}, layer = {WIDTH, HEIGHT, alone};
    long seen[OBJECTS] = {0};
    for (int view = 0; view < 8; view++) {
        stage *const s = make_stage(view);
        uint32_t layers[OBJECTS];
        library_geometry geometry;
        glint_renderer renderer;
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        glint_config config = picture_config(&image, &s->how);
        CHECK_EQUAL(library_geometry_open(&geometry, &config, &s->scene), GLINT_OK);
        const reference_position *const *const at = (const reference_position *const *)geometry.positions;
        reference_render(&nearest, &s->scene, at);
        for (uint32_t i = reference_find_layers(&s->scene, layers); i-- > 0;) {
            reference_render_object(&layer, &s->scene, layers[i], at);
            for (int j = 0; j < PIXELS; j++) {
                const double apart = alone[j].nearest - pixels[j].nearest;
                const int is_unsure = pixels[j].uncertain || alone[j].uncertain ||
                                      (alone[j].covered && fabs(apart) * geometry.depth_scale < JUDGE_CLOSE_STEPS);
                if (apart > 0)
                    pixels[j] = alone[j];
                pixels[j].uncertain = is_unsure;
            }
        }
        config.arena_size = view % 2 ? picture_need(&image, &s->scene, &s->how).least : 1 << 20;
        config.arena = malloc(config.arena_size);
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        for (int j = 0; j < PIXELS; j += 29) {
            glint_hit hit = {77, 77, 77};
            const int found = glint_pick(&renderer, &s->scene, j % WIDTH, j / WIDTH, &hit);
            if (pixels[j].uncertain)
                continue;
            CHECK_EQUAL(found, pixels[j].covered);
            CHECK_EQUAL(hit.object, pixels[j].covered ? pixels[j].object : 77);
            if (found > 0 && hit.object < OBJECTS)
                seen[hit.object]++;
        }
        free(config.arena);
        library_geometry_close(&geometry);
        picture_close(&image);
    }
    for (int i = 0; i < OBJECTS; i++)
        CHECK(seen[i] > 10);
}

/* ---- Errors -------------------------------------------------------------------------------------------------- */

/* Draws what is to be refused: nothing is sent, and all that looks at a scene names the same. */
static void check_refused(const stage *s, glint_status status) {
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    glint_config config = picture_config(&image, &s->how);
    glint_renderer renderer;
    glint_frame frame = {0};
    glint_report report;
    glint_need need = {1, 2, 3};
    config.arena_size = 1 << 20;
    config.arena = malloc(config.arena_size);
    CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
    CHECK_EQUAL(glint_render(&renderer, &s->scene), status);
    CHECK_EQUAL(glint_check(&config, &s->scene, &report), status);
    CHECK_EQUAL(glint_arena_need(&config, &s->scene, &need), status);
    CHECK_EQUAL(glint_frame_begin(&frame, &config, &s->scene), status);
    CHECK((image.calls == 0 && need.least == 1 && need.one_pass == 3) || status == GLINT_OK);
    CHECK(strlen(glint_strerror(status)) > 1);
    free(config.arena);
    picture_close(&image);
}

#define CHANGED(status, change)         \
    do {                                \
        stage *const s = make_stage(0); \
        s->scene.fog = &s->fog;         \
        change;                         \
        check_refused(s, status);       \
    } while (0)

static void what_cannot_be_blended_is_refused(void) {
    static const glint_q16 no_opacities[] = {-1, INT32_MIN, GLINT_ONE + 1, INT32_MAX};
    CHANGED(GLINT_OK, (void)s);
    for (unsigned i = 0; i < TEST_COUNT(no_opacities); i++)
        for (int object = GLASS; object < OBJECTS; object++)
            CHANGED(GLINT_ERROR_BLEND, s->materials[object].opacity = no_opacities[i]);
    CHANGED(GLINT_OK, s->materials[BOX].opacity = -1);
    CHANGED(GLINT_ERROR_BLEND, s->materials[BOX].blend = (glint_blend)4);
    CHANGED(GLINT_ERROR_BLEND, s->materials[GLASS].blend = (glint_blend)-1);
    CHANGED(GLINT_ERROR_LAYERS, s->how.layers = NULL);
    for (int object = GLASS; object < OBJECTS; object++)
        CHANGED(GLINT_ERROR_LAYERS, {
            for (int other = GLASS; other < OBJECTS; other++)
                if (other != object)
                    s->materials[other].blend = GLINT_BLEND_NONE;
            s->how.layers = NULL;
        });
}

/* What is wrong is said of its object, and glass alone is not taken for an empty picture. */
static void glint_check_knows_layers(void) {
    picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    stage *const s = make_stage(0);
    glint_config config = picture_config(&image, &s->how);
    glint_report report;
    config.arena_size = 1 << 20;
    config.arena = malloc(config.arena_size);
    s->materials[GLOW].opacity = -1;
    CHECK_EQUAL(glint_check(&config, &s->scene, &report), GLINT_ERROR_BLEND);
    CHECK_EQUAL(report.object, GLOW);
    s->scene.objects = &s->objects[GLASS];
    s->scene.object_count = 1;
    CHECK_EQUAL(glint_check(&config, &s->scene, &report), GLINT_OK);
    CHECK_EQUAL(report.shown, 0);
    CHECK(!*report.sentence);
    free(config.arena);
    picture_close(&image);
}

/* Fails at a call, where that is above 0. */
static int paint_or_fail(void *context, const glint_tile *tile) {
    int *const left = context;
    (void)tile;
    return *left > 0 && --*left == 0;
}

/* A painter that fails where fog asks for the background, as anywhere, ends the frame. */
static void painters_may_fail_at_any_call(void) {
    for (int call = 1; call < 24; call++) {
        stage *const s = make_stage(call);
        int left = call;
        picture image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
        set_fog(s, 2 + call % 2, &glint_format_rgb565);
        s->how.background = (glint_painter){paint_or_fail, &left};
        CHECK_EQUAL(picture_render(&image, &s->scene, &s->how, NULL), GLINT_ERROR_PAINT);
        CHECK_EQUAL(left, 0);
        CHECK(image.calls <= call / 2 + 1);
        picture_close(&image);
    }
}

static void make_opaque(stage *s) {
    for (int object = GLASS; object < OBJECTS; object++)
        s->materials[object].blend = GLINT_BLEND_NONE;
    s->how.layers = NULL;
}

static void what_is_no_fog_is_refused(void) {
    const glint_painter painter = {picture_paint_pattern, (void *)(uintptr_t)&glint_format_rgb565};
    CHANGED(GLINT_ERROR_NULL, s->fog.type = NULL);
    CHANGED(GLINT_ERROR_FOG, s->fog.start = -1);
    CHANGED(GLINT_ERROR_FOG, s->fog.start = INT32_MIN);
    CHANGED(GLINT_ERROR_FOG, s->fog.end = s->fog.start);
    CHANGED(GLINT_ERROR_FOG, s->fog.end = s->fog.start - 1);
    CHANGED(GLINT_ERROR_FOG, s->fog.end = INT32_MIN);
    CHANGED(GLINT_OK, (s->fog.start = 0, s->fog.end = 1));
    CHANGED(GLINT_OK, (s->fog.start = INT32_MAX - 1, s->fog.end = INT32_MAX));
    CHANGED(GLINT_ERROR_COLOUR, s->fog.colour.r = -1);
    CHANGED(GLINT_ERROR_COLOUR, s->fog.colour.g = GLINT_COLOUR_MAX + 1);
    CHANGED(GLINT_ERROR_COLOUR, s->fog.colour.b = INT32_MIN);
    CHANGED(GLINT_OK, s->fog.colour = (glint_colour)GLINT_COLOUR(16, 16, 16));
    CHANGED(GLINT_OK, make_opaque(s));
    CHANGED(GLINT_OK, (make_opaque(s), s->fog.to_background = 1));
    CHANGED(GLINT_OK, (make_opaque(s), s->how.background = painter));
    CHANGED(GLINT_ERROR_LAYERS, (make_opaque(s), s->how.background = painter, s->fog.to_background = 1));
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(blended_levels_are_those_of_double_precision),
        TEST_CASE(views_and_opacities_are_blended),
        TEST_CASE(random_scenes_are_blended),
        TEST_CASE(levels_are_blended_exactly),
        TEST_CASE(glows_end_at_white),
        TEST_CASE(dithered_objects_cover_their_pixels),
        TEST_CASE(order_in_the_scene_changes_nothing),
        TEST_CASE(order_is_asked_for_and_ties_are_the_scenes),
        TEST_CASE(ends_of_opacity_are_exact),
        TEST_CASE(fog_is_that_of_double_precision),
        TEST_CASE(fog_reaches_from_start_to_end),
        TEST_CASE(fog_of_one_distance),
        TEST_CASE(fog_beyond_and_of_the_background),
        TEST_CASE(tiles_arenas_and_regions_change_nothing),
        TEST_CASE(lines_are_drawn_over_layers),
        TEST_CASE(blended_surfaces_are_picked),
        TEST_CASE(what_cannot_be_blended_is_refused),
        TEST_CASE(what_is_no_fog_is_refused),
        TEST_CASE(glint_check_knows_layers),
        TEST_CASE(painters_may_fail_at_any_call),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
