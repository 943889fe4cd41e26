/* SPDX-License-Identifier: MIT */
#include "workloads.h"

#include "../../examples/scenes/stage.h"
#include "../../port/text.h"

#include <bench_scenes.h>

/** The benchmark scene that is changed. */
enum { TORUS576 = 1 };

static const uint16_t sizes[][2] = {{320, 240}, {128, 64}};

/* ---- Lights, materials and meshes ---- */

/** Of the torus. */
static const glint_vector centre = XYZ(0, 0, -3.7);

/* Around the torus, from 2.1 to 2.6 away from its centre. */
static const struct {
    glint_vector position;
    glint_colour colour;
} points[GLINT_LIGHTS_MAX] = {
    {XYZ(1.0, 1.5, -1.95), RGB(1, 1, 1)},     {XYZ(-1.7, 0.5, -2.5), RGB(0.5, 0.7, 1)},
    {XYZ(0.3, -1.8, -2.2), RGB(1, 0.6, 0.4)}, {XYZ(1.9, -0.6, -4.9), RGB(0.4, 1, 0.6)},
    {XYZ(-1.2, 1.6, -5.0), RGB(1, 1, 0.5)},   {XYZ(-1.4, -1.5, -4.9), RGB(1, 0.4, 0.8)},
    {XYZ(2.0, 0.4, -2.2), RGB(0.4, 0.9, 1)},  {XYZ(-0.6, 0.8, -1.4), RGB(0.8, 0.8, 0.8)},
};

static glint_material *material_of(workload_stage *stage) {
    return &stage->example.materials[0];
}

static glint_vector between(glint_vector from, glint_vector to) {
    return (glint_vector){to.x - from.x, to.y - from.y, to.z - from.z};
}

static glint_colour dimmed(glint_colour full, glint_q16 brightness) {
    return (glint_colour){stage_multiply(full.r, brightness), stage_multiply(full.g, brightness),
                          stage_multiply(full.b, brightness)};
}

static void light_with_points(workload_stage *stage, uint32_t count, glint_q16 brightness) {
    stage->example.scene.light_count = 0;
    for (uint32_t i = 0; i < count; i++) {
        glint_light *light =
            stage_lamp(&stage->example, &glint_light_point, points[i].position, dimmed(points[i].colour, brightness));

        light->linear = GLINT_Q16(0.1);
        light->quadratic = GLINT_Q16(0.05);
    }
}

/* Each from where a point is, towards the torus's centre; the scene's own and the second are near the first two. */
static void add_directional(workload_stage *stage, uint32_t count, glint_q16 brightness) {
    for (uint32_t i = stage->example.scene.light_count; i < count; i++) {
        stage_sun(&stage->example, between(points[i].position, centre), dimmed(points[i].colour, brightness));
    }
}

static void two_directional(workload_stage *stage) {
    const glint_vector from_left = XYZ(0.7, -0.2, -0.5);

    stage_sun(&stage->example, from_left, (glint_colour)GREY(0.7));
}

static void four_directional(workload_stage *stage) {
    two_directional(stage);
    add_directional(stage, 4, GLINT_Q16(0.6));
}

static void eight_directional(workload_stage *stage) {
    two_directional(stage);
    add_directional(stage, 8, GLINT_Q16(0.4));
}

static void second_black(workload_stage *stage) {
    const glint_vector from_left = XYZ(0.7, -0.2, -0.5);

    stage_sun(&stage->example, from_left, (glint_colour)GREY(0));
}

static void one_point(workload_stage *stage) {
    light_with_points(stage, 1, GLINT_Q16(1.4));
}

static void two_points(workload_stage *stage) {
    light_with_points(stage, 2, GLINT_Q16(1.2));
}

static void four_points(workload_stage *stage) {
    light_with_points(stage, 4, GLINT_Q16(0.9));
}

static void eight_points(workload_stage *stage) {
    light_with_points(stage, 8, GLINT_Q16(0.6));
}

/* Points made spots that look at the torus's centre; no cone holds all of it. */
static void make_spots(workload_stage *stage) {
    for (uint32_t i = 0; i < stage->example.scene.light_count; i++) {
        glint_light *light = &stage->example.lights[i];

        light->type = &glint_light_spot;
        light->direction = between(light->position, centre);
        light->inner = GLINT_Q16(18);
        light->outer = GLINT_Q16(28);
    }
}

static void one_spot(workload_stage *stage) {
    one_point(stage);
    make_spots(stage);
}

static void two_spots(workload_stage *stage) {
    two_points(stage);
    make_spots(stage);
}

static void four_spots(workload_stage *stage) {
    four_points(stage);
    make_spots(stage);
}

static void eight_spots(workload_stage *stage) {
    eight_points(stage);
    make_spots(stage);
}

static void phong(workload_stage *stage) {
    material_of(stage)->model = &glint_model_phong;
}

/* Red, green and blue rise along the mesh's axes. */
static void mesh_colours(workload_stage *stage) {
    for (uint32_t i = 0; i < stage->mesh.vertex_count && i < COUNT_OF(stage->colours); i++) {
        for (int axis = 0; axis < 3; axis++) {
            stage->colours[i][axis] = (uint8_t)(160 + stage->mesh.positions[i][axis] / 345);
        }
    }
    stage->mesh.colours = (const uint8_t(*)[3])stage->colours;
}

static void flag_max(workload_stage *stage) {
    material_of(stage)->flags = GLINT_MATERIAL_MAX_WITH_AMBIENT;
}

static void flag_ungated(workload_stage *stage) {
    material_of(stage)->flags = GLINT_MATERIAL_SPECULAR_UNGATED;
}

static void double_sided(workload_stage *stage) {
    stage->mesh.flags = GLINT_MESH_DOUBLE_SIDED;
}

static void per_vertex(workload_stage *stage) {
    stage->example.objects[0].evaluation = &glint_per_vertex;
}

static void per_vertex_eight_points(workload_stage *stage) {
    eight_points(stage);
    per_vertex(stage);
}

static void per_facet(workload_stage *stage) {
    stage->example.objects[0].evaluation = &glint_per_facet;
}

static void unlit(workload_stage *stage) {
    material_of(stage)->model = &glint_model_unlit;
}

/* ---- Textures ---- */

/* The integer part of the square root, bit by bit. */
static uint32_t square_root(uint32_t square) {
    uint32_t root = 0;
    for (uint32_t bit = 1u << 15; bit; bit >>= 1) {
        if ((root + bit) * (root + bit) <= square) {
            root += bit;
        }
    }
    return root;
}

/* A chequered texture of 64x64 with grain, the same each time. */
static void wear_texture(workload_stage *stage) {
    uint32_t grain = 1;

    for (uint32_t i = 0; i < COUNT_OF(stage->texels); i++) {
        const uint32_t is_light = (i / 8 ^ i / 512) & 1;
        grain = grain * 1664525 + 1013904223;
        stage->texels[i] = (uint16_t)((is_light ? 0xffe0 : 0x8410) ^ (grain >> 16 & 0x18e3));
    }
    stage->texture = (glint_texture){.type = &glint_texture_rgb565, .texels = stage->texels, .width = 64, .height = 64};
    stage->mesh.texture_coordinates = (const int16_t(*)[2])stage->coordinates;
    material_of(stage)->texture = &stage->texture;
}

/* x / (|x| + |y|), which goes from 1 to -1 and back around a circle, in steps. */
static int16_t part_of_turn(int32_t x, int32_t y) {
    const int32_t sum = (x < 0 ? -x : x) + (y < 0 ? -y : y);

    return (int16_t)(sum ? 32767 * x / sum : 0);
}

/* Coordinates go there and back around the ring and around the tube, so that nothing is torn at a seam. */
static void textured(workload_stage *stage) {
    const int32_t ring = 32768 * 2 / 3; /* of radius 1, in steps of 1.5 / 32768 */

    for (uint32_t i = 0; i < stage->mesh.vertex_count && i < COUNT_OF(stage->coordinates); i++) {
        const int16_t *at = stage->mesh.positions[i];
        const int32_t out = (int32_t)square_root((uint32_t)(at[0] * at[0]) + (uint32_t)(at[1] * at[1])) - ring;

        stage->coordinates[i][0] = part_of_turn(at[0], at[1]);
        stage->coordinates[i][1] = part_of_turn(out, at[2] / 3); /* steps of 0.5 / 32768 */
    }
    stage->mesh.texture_extent[0] = stage->mesh.texture_extent[1] = GLINT_Q16(0.25);
    wear_texture(stage);
}

/* Texels as they are. */
static void unlit_white(workload_stage *stage) {
    unlit(stage);
    material_of(stage)->diffuse = (glint_colour)GREY(1);
}

static void textured_unlit(workload_stage *stage) {
    textured(stage);
    unlit_white(stage);
}

static void textured_bilinear(workload_stage *stage) {
    textured_unlit(stage);
    material_of(stage)->flags |= GLINT_MATERIAL_BILINEAR;
}

/* Each four vertices are the corners of a square that shows the texture so many times. */
static void wear_squares(workload_stage *stage, glint_q16 times) {
    for (uint32_t i = 0; i < stage->mesh.vertex_count; i++) {
        stage->coordinates[i][0] = i % 4 == 1 || i % 4 == 2 ? 32767 : 0;
        stage->coordinates[i][1] = i % 4 < 2 ? 32767 : 0;
    }
    stage->mesh.texture_extent[0] = stage->mesh.texture_extent[1] = times;
    stage->poses = stage->turned;
    wear_texture(stage);
}

/* A cube whose half edge is 1. */
static void crate(workload_stage *stage) {
    const glint_q16 edge = GLINT_Q16(1.7321);

    stage->mesh = *boxes_definitions[0].mesh;
    stage->mesh.extent = (glint_vector){edge, edge, edge};
    for (int32_t frame = 0; frame < BENCH_FRAMES; frame++) {
        const glint_pose turned = glint_pose_rotate_y((30 + 6 * frame) * GLINT_ONE);
        const glint_pose tilted = glint_pose_rotate_x(GLINT_Q16(25)),
                         moved = glint_pose_translate(0, 0, GLINT_Q16(-2.9));
        const glint_pose both = glint_pose_then(&turned, &tilted);

        stage->turned[frame] = glint_pose_then(&both, &moved);
    }
    wear_squares(stage, GLINT_ONE);
}

static void crate_unlit(workload_stage *stage) {
    crate(stage);
    unlit_white(stage);
}

/* Two triangles, of which a part fills the screen. */
static void ground(workload_stage *stage) {
    static const int16_t positions[4][3] = {
        {-32767, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32767}, {-32767, 0, -32767}};
    static const int16_t normals[4][3] = {{0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}, {0, 32767, 0}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const glint_vector eye = XYZ(0, 1.5, 6), at = XYZ(0.2, 0, 2);

    stage->mesh = (glint_mesh){.positions = positions,
                               .normals = normals,
                               .triangles = triangles,
                               .vertex_count = 4,
                               .triangle_count = 2,
                               .extent = XYZ(20, 0, 20)};
    stage_look(&stage->example, eye, at, BENCH_FIELD_OF_VIEW);
    stage->example.scene.camera.near_plane = GLINT_Q16(0.1);
    for (int32_t frame = 0; frame < BENCH_FRAMES; frame++) {
        stage->turned[frame] = glint_pose_rotate_y((10 + 8 * frame) * GLINT_ONE);
    }
    wear_squares(stage, GLINT_Q16(10));
}

static void ground_unlit(workload_stage *stage) {
    ground(stage);
    unlit_white(stage);
}

static void ground_bilinear(workload_stage *stage) {
    ground_unlit(stage);
    material_of(stage)->flags |= GLINT_MATERIAL_BILINEAR;
}

/* ---- Layers, fog and samples ---- */

static void blend(workload_stage *stage, glint_blend how) {
    material_of(stage)->blend = how;
    material_of(stage)->opacity = GLINT_Q16(0.5);
    stage->example.layers = &glint_layers;
}

static void opacity(workload_stage *stage) {
    blend(stage, GLINT_BLEND_ALPHA);
}

static void added(workload_stage *stage) {
    blend(stage, GLINT_BLEND_ADD);
}

static void opacity_dithered(workload_stage *stage) {
    blend(stage, GLINT_BLEND_DITHERED);
}

static void fog(workload_stage *stage) {
    stage_fog(&stage->example, &glint_fog_linear, GLINT_Q16(2.5), GLINT_Q16(5.5), (glint_colour)GREY(0.25));
}

static void fog_squared(workload_stage *stage) {
    fog(stage);
    stage->example.fog.type = &glint_fog_squared;
}

static void samples(workload_stage *stage) {
    stage->example.samples = &glint_samples_2x2;
}

static void exponent_8(workload_stage *stage) {
    material_of(stage)->shininess = GLINT_Q16(8);
}

static void exponent_256(workload_stage *stage) {
    material_of(stage)->shininess = GLINT_Q16(256);
}

static void no_highlight(workload_stage *stage) {
    material_of(stage)->specular = (glint_colour)GREY(0);
}

static const struct {
    const char *name;
    workload_change change;
} looks[] = {
    /* WORKLOADS_LIGHTS - 1 of them: the scene as it is has one directional light */
    {"2 directional", two_directional},
    {"4 directional", four_directional},
    {"8 directional", eight_directional},
    {"1 point", one_point},
    {"2 points", two_points},
    {"4 points", four_points},
    {"8 points", eight_points},
    {"1 spot", one_spot},
    {"2 spots", two_spots},
    {"4 spots", four_spots},
    {"8 spots", eight_spots},
    {"phong", phong},
    {"mesh colours", mesh_colours},
    {"max", flag_max},
    {"ungated", flag_ungated},
    {"double-sided", double_sided},
    {"per vertex", per_vertex},
    {"per vertex 8 points", per_vertex_eight_points},
    {"per facet", per_facet},
    {"unlit", unlit},
    {"p 8", exponent_8},
    {"p 256", exponent_256},
    {"second light black", second_black},
    {"no highlight", no_highlight},
    {"textured", textured},
    {"textured unlit", textured_unlit},
    {"textured unlit bilinear", textured_bilinear},
    {"opacity", opacity},
    {"added", added},
    {"opacity dithered", opacity_dithered},
    {"fog", fog},
    {"fog squared", fog_squared},
    {"2x2 samples", samples},
};

static const workload_output rgb565 = {"", &glint_format_rgb565, 0, 0},
                             rgb565_dithered = {"rgb565 dithered", &glint_format_rgb565_dithered, 0, 0};

/* What replaces the torus, and a look in another format. */
static const struct {
    const char *scene;
    const char *look;
    workload_change change;
    const workload_output *output;
} others[] = {
    {"crate", "textured", crate, &rgb565},
    {"crate", "textured unlit", crate_unlit, &rgb565},
    {"floor", "textured", ground, &rgb565},
    {"floor", "textured unlit", ground_unlit, &rgb565},
    {"floor", "textured unlit bilinear", ground_bilinear, &rgb565},
    {"torus576", "2x2 samples", samples, &rgb565_dithered},
};

/* ---- Formats ---- */

static const workload_output outputs[] = {
    {"rgb565 tables", &glint_format_rgb565, 0, 1},
    {"rgb565 dithered", &glint_format_rgb565_dithered, 0, 0},
    {"rgb565_be", &glint_format_rgb565_be, 0, 0},
    {"rgb565_be dithered", &glint_format_rgb565_be_dithered, 0, 0},
    {"rgb888", &glint_format_rgb888, 0, 0},
    {"rgb888 dithered", &glint_format_rgb888_dithered, 0, 0},
    {"grey8", &glint_format_grey8, 0, 0},
    {"grey8 dithered", &glint_format_grey8_dithered, 0, 0},
    {"grey4", &glint_format_grey4, 0, 0},
    {"grey4 dithered", &glint_format_grey4_dithered, 0, 0},
    {"rgb444", &glint_format_rgb444, 0, 0},
    {"rgb444 dithered", &glint_format_rgb444_dithered, 0, 0},
    {"mono", &glint_format_mono, 0, 0},
    {"mono dithered", &glint_format_mono_dithered, 0, 0},
    {"mono_pages", &glint_format_mono_pages, 1, 0},
    {"mono_pages dithered", &glint_format_mono_pages_dithered, 1, 0},
};

void workload_gamma(uint16_t tables[3][GLINT_GAMMA_ENTRIES]) {
    for (uint32_t i = 0; i < GLINT_GAMMA_ENTRIES; i++) {
        const uint32_t full = GLINT_GAMMA_ENTRIES - 1;
        const uint16_t level = i < full ? (uint16_t)square_root(i << 24) : 65535;

        tables[0][i] = tables[1][i] = tables[2][i] = level;
    }
}

/* ---- Example scenes ---- */

/* What is left without light: each object in one colour. */
static void all_of_one_colour(workload_stage *stage) {
    for (uint32_t i = 0; i < stage->example.scene.object_count; i++) {
        glint_object *object = &stage->example.objects[i];

        stage->example.materials[i].model = &glint_model_unlit;
        stage->meshes[i] = *object->mesh;
        stage->meshes[i].colours = 0;
        stage->meshes[i].colours565 = 0;
        object->mesh = &stage->meshes[i];
    }
}

static const struct {
    const example_scene *scene;
    const char *variant;
    const char *look;       /* where it is changed: what rows call it, */
    workload_change change; /* and how */
} examples[] = {
    {&example_three_spheres, "phong"},
    {&example_three_spheres, "blinn-phong"},
    {&example_three_spheres, "vertex-dense"},
    {&example_teapot, "fragment"},
    {&example_teapot, "vertex"},
    {&example_teapot, "flood-wide"},
    {&example_shaders, "torus-50"},
    {&example_shaders, "cylinder-50"},
    {&example_shaders, "sphere-50"},
    {&example_phong_lighting, "plain"},
    {&example_phong_lighting, "near"},
    {&example_phong_lighting, "ring"},
    {&example_phong_lighting, "turning"},
    {&example_phong_lighting, "scaled-vertex-colours"},
    {&example_phong_lighting, "light"},
    {&example_halloween, "night"},
    {&example_halloween, "night", "night without light", all_of_one_colour},
    {&example_halloween, "vertex"},
    {&example_halloween, "floodlit"},
    {&example_surfaces, "metal"},
    {&example_surfaces, "terms"},
    {&example_surfaces, "ungated"},
    {&example_surfaces, "exponents"},
    {&example_surfaces, "twice-near"},
    {&example_surfaces, "twice-far"},
    {&example_still_life, "turning"},
    {&example_still_life, "dusk"},
};

static int same_text(const char *a, const char *b) {
    while (*a && *a == *b) {
        a++, b++;
    }
    return *a == *b;
}

static int build_example(workload_stage *stage, const workload *built) {
    const example_scene *scene = built->example;
    for (uint32_t variant = 0; variant < scene->variant_count; variant++) {
        if (same_text(scene->variants[variant].name, built->variant)) {
            scene->build(&stage->example, variant, scene->frames / 2);
            if (built->change) {
                built->change(stage);
            }
            return 0;
        }
    }
    return 1;
}

/* ---- The list ---- */

enum {
    SIZES = COUNT_OF(sizes),
    LOOKS = SIZES * COUNT_OF(looks),
    OUTPUTS = 2 * COUNT_OF(outputs), /* lit and unlit */
    OTHERS = COUNT_OF(others),
    EXAMPLES = COUNT_OF(examples)
};

/* Boxes have the benchmark's light, four points, or none. */
enum { BOX_LOOKS = 3, BOXES = BOX_LOOKS * BOXES_SCENES };

uint32_t workload_count(void) {
    return WORKLOADS_PLAIN + LOOKS + OUTPUTS + BOXES + OTHERS + EXAMPLES;
}

static workload bench_workload(uint32_t bench, const uint16_t size[2]) {
    const workload plain = {.scene = bench_scenes[bench].name,
                            .look = "",
                            .width = size[0],
                            .height = size[1],
                            .frames = BENCH_FRAMES,
                            .output = &rgb565,
                            .bench = bench};

    return plain;
}

static workload look_workload(uint32_t number) {
    workload changed = bench_workload(TORUS576, sizes[number % SIZES]);

    changed.look = looks[number / SIZES].name;
    changed.change = looks[number / SIZES].change;
    return changed;
}

static workload output_workload(uint32_t number) {
    workload changed = bench_workload(TORUS576, sizes[0]);

    changed.output = &outputs[number / 2];
    if (number % 2) {
        changed.look = "unlit";
        changed.change = unlit;
    }
    return changed;
}

static workload boxes_workload(uint32_t number) {
    const boxes_definition *boxes = &boxes_definitions[number / BOX_LOOKS];
    workload drawn = bench_workload(TORUS576, sizes[0]);

    drawn.scene = boxes->name;
    drawn.boxes = boxes;
    drawn.width = boxes->width;
    drawn.height = boxes->height;
    if (number % BOX_LOOKS == 1) {
        drawn.look = "4 points";
        drawn.change = four_points;
    } else if (number % BOX_LOOKS == 2) {
        drawn.look = "unlit";
        drawn.change = unlit;
    }
    return drawn;
}

static workload other_workload(uint32_t number) {
    workload drawn = bench_workload(TORUS576, sizes[0]);

    drawn.scene = others[number].scene;
    drawn.look = others[number].look;
    drawn.change = others[number].change;
    drawn.output = others[number].output;
    return drawn;
}

static workload example_workload(uint32_t number) {
    const example_scene *scene = examples[number].scene;
    const workload drawn = {.scene = scene->name,
                            .look = examples[number].change ? examples[number].look : examples[number].variant,
                            .width = scene->width,
                            .height = scene->height,
                            .frames = BENCH_FRAMES,
                            .output = &rgb565,
                            .example = scene,
                            .variant = examples[number].variant,
                            .change = examples[number].change};

    return drawn;
}

workload workload_get(uint32_t number) {
    if (number < WORKLOADS_PLAIN) {
        return bench_workload(number / SIZES, sizes[number % SIZES]);
    }
    number -= WORKLOADS_PLAIN;
    if (number < LOOKS) {
        return look_workload(number);
    }
    number -= LOOKS;
    if (number < OUTPUTS) {
        return output_workload(number);
    }
    number -= OUTPUTS;
    if (number < BOXES) {
        return boxes_workload(number);
    }
    number -= BOXES;
    if (number < OTHERS) {
        return other_workload(number);
    }
    return example_workload(number - OTHERS);
}

workload workload_get_lights(uint32_t number) {
    return number == 0 ? bench_workload(TORUS576, sizes[0]) : look_workload((number - 1) * SIZES);
}

/* Boxes in place of the scene's object, of its material. */
static void build_boxes(workload_stage *stage, const boxes_definition *boxes) {
    for (uint32_t i = 0; i < boxes->count; i++) {
        stage->box_objects[i] = stage->example.objects[0];
    }
    stage->poses = 0;
    stage->boxes = boxes;
    boxes_place(stage->box_objects, boxes, 0);
    stage->example.scene.objects = stage->box_objects;
    stage->example.scene.object_count = boxes->count;
}

static void build_bench(workload_stage *stage, const workload *built) {
    example_stage *example = &stage->example;

    stage_clear(example, (glint_colour)GREY(0));
    example->scene.camera.field_of_view = BENCH_FIELD_OF_VIEW;
    example->scene.camera.near_plane = BENCH_NEAR_PLANE;
    example->scene.ambient = (glint_colour){BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT};
    example->lights[example->scene.light_count++] = bench_light;
    stage->mesh = *bench_scenes[built->bench].mesh;
    stage->poses = bench_scenes[built->bench].poses;
    stage_add(example, &stage->mesh, &bench_material, &stage->poses[0]);
    if (built->boxes) {
        build_boxes(stage, built->boxes);
    }
    if (built->change) {
        built->change(stage);
    }
}

int workload_build(workload_stage *stage, const workload *built) {
    stage->poses = 0;
    stage->boxes = 0;
    if (built->example) {
        return build_example(stage, built);
    }
    build_bench(stage, built);
    if (built->by_default) {
        stage->example.scene.viewer = GLINT_VIEWER_INFINITE;
    }
    return 0;
}

int workload_is_bare(const workload_stage *stage) {
    const example_stage *example = &stage->example;
    int is_bare = !example->scene.fog && !example->layers && !example->samples;
    for (uint32_t i = 0; i < example->scene.object_count; i++) {
        is_bare &= example->scene.objects[i].material->texture == 0;
    }
    return is_bare;
}

void workload_set_frame(workload_stage *stage, uint32_t frame) {
    if (stage->poses) {
        stage->example.objects[0].pose = stage->poses[frame];
    } else if (stage->boxes) {
        boxes_place(stage->box_objects, stage->boxes, frame);
    }
}

/* Puts what fits of `more` at `*length`, and the end of the text behind it. */
static void append(char text[WORKLOAD_TEXT], uint32_t *length, const char *more) {
    while (*more && *length + 1 < WORKLOAD_TEXT) {
        text[(*length)++] = *more++;
    }
    text[*length] = '\0';
}

const char *workload_variant(const workload *named, char text[WORKLOAD_TEXT]) {
    char digits[TEXT_NUMBER_SIZE];
    uint32_t length = 0;

    append(text, &length, text_number(digits, named->width));
    append(text, &length, "x");
    append(text, &length, text_number(digits, named->height));
    append(text, &length, named->by_default ? " infinite 32x32 anew" : " local 32x32");
    append(text, &length, *named->look ? " " : "");
    append(text, &length, named->look);
    append(text, &length, *named->output->name ? " " : "");
    append(text, &length, named->output->name);
    return text;
}
