/* SPDX-License-Identifier: MIT */
/* A scene's checks, its camera, lights and materials. @link geometry/transform.c */
#include "proof.h"

#include "../../src/frame/arena.c"
#include "../../src/frame/check.c"
#include "../../src/light/shading.c"
#include "../../src/math/numeric.c"
#include "../../src/scene/view.c"
#include "ranges.h"

/*@ requires 0x8000000 <= focal < 0xffc000000000;
    assigns view->focal, view->focal_shift, view->focal_mantissa \from focal;
    ensures 0x100 <= view->focal <= 0x20000000;
    ensures 18 <= view->focal_shift <= 38;
    ensures 0x800000 <= view->focal_mantissa <= 0x1000000; */
static void set_focal_length(glint_view *view, int64_t focal);

/*@ requires \valid_read(a) && \valid_read(b) && \valid(weight + (0 .. 2));
    requires bits == 12 || bits == 23;
    assigns \result, weight[0 .. 2] \from *a, *b, bits;
    ensures -1 <= \result <= 0x8000000; */
static int32_t weigh_colour(const glint_colour *a, const glint_colour *b, int bits, uint32_t weight[3]);

/*@ requires \valid_read(camera);
    assigns \result \from *camera;
    ensures \result == 0 || \result == 1; */
int glint_camera_is_valid(const glint_camera *camera);

static glint_status any_light_prepare(const glint_light *light, glint_prepared_light *prepared,
                                      const glint_view *view) {
    (void)light;
    (void)prepared;
    (void)view;
    return ANY(0, 1) ? GLINT_OK : GLINT_ERROR_DIRECTION;
}

static void any_illuminate(const glint_prepared_light *light, glint_fragments *fragments) {
    (void)light;
    (void)fragments;
}

static void any_place(const glint_light *light, glint_prepared_light *prepared, const glint_view *view) {
    (void)light;
    (void)prepared;
    (void)view;
}

static void any_model_prepare(glint_shading *shading, uint32_t largest_specular) {
    (void)shading;
    (void)largest_specular;
}

static glint_status any_check(const glint_mesh *mesh) {
    (void)mesh;
    return ANY(0, 1) ? GLINT_OK : GLINT_ERROR_MESH;
}

static int any_validity(const glint_camera *camera) {
    (void)camera;
    return ANY(0, 1);
}

static void any_range(glint_view *view, int64_t nearest, int64_t farthest) {
    (void)view;
    //@ assert 0x1000 <= nearest && 0x1000 <= farthest;
}

static const glint_projection any_projection = {any_validity, 0, any_range, 0, 0, 0};

/*@ requires 0x1000 <= farthest && \valid_read(transform);
    assigns \result \from farthest, *transform;
    ensures 0x1000 <= \result; */
static int64_t farther(int64_t farthest, const glint_transform *transform);

static const glint_cull any_cull = {any_check, 0, 0, 0, 0};
static const glint_clusters some_clusters[2] = {{&any_cull, 0, 0, 0}, {0, 0, 0, 0}};
static const glint_light_type far_light = {any_light_prepare, 0, 0},
                              near_light = {any_light_prepare, any_illuminate, any_place};
static void any_model_light(const glint_shading *shading, uint32_t light, const glint_view *view,
                            glint_fragments *fragments, int has_surface) {
    (void)shading, (void)light, (void)view, (void)fragments, (void)has_surface;
}

static const glint_model plain = {0, 0, 0}, shiny = {any_model_prepare, any_model_light, 0};

/* Everything a scene holds, with any numbers in it; pointers may be null. */
static struct {
    glint_light lights[GLINT_LIGHTS_MAX + 1];
    glint_object objects[2];
    glint_mesh mesh;
    glint_material material;
    glint_scene scene;
} all;

static const int16_t vectors[1][3];
static const uint16_t indices[1][3];

static glint_colour any_colour(int least, int most) {
    const glint_colour colour = {ANY(least, most), ANY(least, most), ANY(least, most)};
    return colour;
}

static void any_lights(int least, int most) {
    for (int i = 0; i <= GLINT_LIGHTS_MAX; i++) {
        all.lights[i].type = ANY(0, 1) ? &far_light : &near_light;
        all.lights[i].diffuse = any_colour(least, most);
        all.lights[i].specular = any_colour(least, most);
    }
}

static void any_material(int least, int most) {
    all.material.model = ANY(0, 1) ? &plain : &shiny;
    all.material.ambient = any_colour(least, most);
    all.material.diffuse = any_colour(least, most);
    all.material.specular = any_colour(least, most);
    all.material.shininess = ANY_INT;
}

static void any_mesh(void) {
    glint_mesh *mesh = &all.mesh;
    mesh->positions = ANY(0, 1) ? vectors : 0;
    mesh->normals = ANY(0, 1) ? vectors : 0;
    mesh->triangles = ANY(0, 1) ? indices : 0;
    mesh->vertex_count = ANY_UNSIGNED(0, UINT_MAX);
    mesh->triangle_count = ANY_UNSIGNED(0, UINT_MAX);
    mesh->extent = (glint_vector){ANY_INT, ANY_INT, ANY_INT};
    mesh->clusters = ANY(0, 1) ? &some_clusters[ANY(0, 1)] : 0;
}

static void any_camera(glint_camera *camera, int most) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            camera->pose.m[i][j] = ANY(-most, most);
        camera->pose.m[i][3] = ANY_INT;
    }
}

/* Any pose, field of view and near plane, by the first component that is too large, if any. */
PROOF(glint_camera_is_valid) {
    const int32_t most = 2 * GLINT_ONE;
    glint_camera camera = {0};
    any_camera(&camera, most);
    camera.field_of_view = ANY_INT;
    camera.near_plane = ANY_INT;
    glint_camera_is_valid(&camera);
    camera.projection = &any_projection;
    glint_camera_is_valid(&camera);
    camera.projection = 0;
    FOR_PARTS(first, 0, 8) {
        any_camera(&camera, INT32_MAX);
        for (int i = 0; i < first; i++)
            camera.pose.m[i % 3][i / 3] = ANY(-most, most);
        camera.pose.m[first % 3][first / 3] = ANY(most + 1, INT32_MAX);
        glint_camera_is_valid(&camera);
        camera.pose.m[first % 3][first / 3] = ANY(INT32_MIN, -most - 1);
        glint_camera_is_valid(&camera);
    }
}

/*
 * Any numbers, null pointers, up to 2 objects and 9 lights.
 * @contract glint_camera_is_valid
 * @options -eva-slevel 40
 * @unreached 6 meshes with a layout: suite `layouts` under ASan and UBSan
 */
PROOF(glint_check_scene) {
    glint_scene *scene = &all.scene;
    any_camera(&scene->camera, INT32_MAX);
    scene->camera.field_of_view = ANY_INT;
    scene->camera.near_plane = ANY_INT;
    scene->viewer = (glint_viewer)ANY(0, 3);
    scene->error_budget = ANY_INT;
    scene->background = any_colour(INT32_MIN, INT32_MAX);
    scene->ambient = any_colour(INT32_MIN, INT32_MAX);
    any_lights(INT32_MIN, INT32_MAX);
    if (ANY(0, 1))
        all.lights[1].type = 0;
    scene->lights = ANY(0, 1) ? all.lights : 0;
    scene->light_count = ANY_UNSIGNED(0, GLINT_LIGHTS_MAX + 1);
    any_mesh();
    any_material(INT32_MIN, INT32_MAX);
    all.mesh.flags = ANY_UNSIGNED(0, UINT_MAX);
    all.material.flags = ANY_UNSIGNED(0, UINT_MAX);
    if (ANY(0, 1))
        all.material.model = 0;
    for (int i = 0; i < 2; i++) {
        all.objects[i].mesh = ANY(0, 1) ? &all.mesh : 0;
        all.objects[i].material = ANY(0, 1) ? &all.material : 0;
    }
    scene->objects = ANY(0, 1) ? all.objects : 0;
    scene->object_count = ANY_UNSIGNED(0, 2);
    glint_config config;
    config.skips_degenerate = (uint8_t)ANY(0, 1);
    glint_check_scene(&config, scene);
}

/*
 * Any three numbers of 64 bits, by the bits and sign of the largest, first or last: an OR tells no places apart.
 * @unreached 1 leading zeros of 0
 * @options -eva-slevel-function glint_magnitude64:0
 */
PROOF(glint_reduce) {
    int32_t out[3];
    FOR_PARTS(bits, 1, 64) {
        const int64_t least = bits < 64 ? -((int64_t)1 << (bits - 1)) : INT64_MIN;
        const int64_t most = bits < 64 ? 2 * (-1 - least) + 1 : INT64_MAX;
        const int64_t rest = ANY_LONG(-most, most);
        FOR_PARTS(place, 0, 1) {
            int64_t in[3] = {rest, rest, rest};
            in[2 * place] = ANY_LONG(bits < 64 ? -most : least, least);
            glint_reduce(in, out);
            if (bits < 64) {
                in[2 * place] = ANY_LONG(-least, most);
                glint_reduce(in, out);
            }
        }
    }
}

/* Any vector, any camera. @contract glint_reduce glint_unit */
PROOF(glint_direction_to_camera) {
    glint_view view;
    int16_t out[3];
    any_view(&view);
    glint_direction_to_camera(&view, (glint_vector){ANY_INT, ANY_INT, ANY_INT}, out);
}

/*
 * Fields of view from 1 to 170 degrees, by degrees or tens of them, and screens of up to 1024 pixels. @contract
 * set_focal_length
 * @unreached 1 sines of more than half a turn
 */
PROOF(prepare_focal_length) {
    glint_view view;
    glint_config config;
    config.height = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    FOR_PARTS(degrees, 1, 9) {
        prepare_focal_length(&view, &config, ANY(degrees * GLINT_ONE, (degrees + 1) * GLINT_ONE));
    }
    FOR_PARTS(tens, 1, 16) {
        prepare_focal_length(&view, &config, ANY(tens * 10 * GLINT_ONE, (tens + 1) * 10 * GLINT_ONE));
    }
}

/* Focal lengths from 2^27 to 1023/1024 2^48, by the bits of their ratio to the guard band.
 * @unreached 1 leading zeros of 0 */
PROOF(set_focal_length) {
    const int64_t first = 1 << 27;
    glint_view view;
    FOR_PARTS(bits, 29, 49) {
        const int64_t least = (((int64_t)1 << (bits - 1)) * (2 * GLINT_GUARD_BAND) + 4095) >> 12;
        const int64_t end = (((int64_t)1 << bits) * (2 * GLINT_GUARD_BAND) + 4095) >> 12;
        set_focal_length(&view, ANY_LONG(least > first ? least : first, end - 1));
    }
}

/* Up to 8 lights of any kind. @options -eva-slevel 40 -eva-min-loop-unroll 9 */
PROOF(prepare_lights) {
    glint_view view;
    any_view(&view);
    any_lights(0, GLINT_COLOUR_MAX);
    all.scene.lights = all.lights;
    all.scene.light_count = ANY_UNSIGNED(0, GLINT_LIGHTS_MAX);
    prepare_lights(&view, &all.scene);
    place_lights(&view, &all.scene);
}

/* Any transform of exponents up to 45, beyond which nothing is seen, and a w from 2^12 up. */
PROOF(farther) {
    glint_transform transform;
    any_transform(&transform);
    FOR_PARTS(exponent, 1, 45) {
        transform.exponent = (int32_t)exponent;
        farther(ANY_LONG(1 << 12, (int64_t)1 << 60), &transform);
    }
}

/*
 * Up to 2 objects of any transform. @contract glint_transform_prepare glint_transform_nearest farther
 * @alarms 1 of a number of 2^12 or more no more than its 2^15th part is taken: it has 2^12 left
 * @unreached 1 where a small build lets no transform wait
 */
PROOF(prepare_nearest) {
    glint_view view;
    glint_config config;
    glint_transform last;
    any_view(&view);
    all.scene.objects = all.objects;
    all.scene.object_count = ANY_UNSIGNED(0, 2);
    all.scene.camera.projection = &any_projection;
    view.is_parallel = 1;
    prepare_nearest(&view, &config, &all.scene, &last, 1);
    view.is_parallel = 0;
    prepare_nearest(&view, &config, &all.scene, &last, 1);
    //@ assert 0x1000 <= view.nearest <= 0x200000000000000;
}

/* Any two colours of up to 16, in Q12 and in Q23. @unreached 1 shift to the left */
PROOF(weigh_colour) {
    uint32_t weight[3];
    const glint_colour a = any_colour(0, GLINT_COLOUR_MAX), b = any_colour(0, GLINT_COLOUR_MAX);
    weigh_colour(&a, &b, 12, weight);
    weigh_colour(&a, &b, 23, weight);
}

/*
 * Colours of up to 16, up to 8 lights, any error budget, every depth of pixels. @contract weigh_colour
 * @options -eva-slevel-function glint_prepare_shading:0,weigh_lights:0 -eva-min-loop-unroll 9
 */
PROOF(glint_prepare_shading) {
    static const uint16_t gamma[3][GLINT_GAMMA_ENTRIES];
    static glint_format format;
    static glint_frame frame;
    static glint_shading shading; /* at first all 0, then what the last frame left */
    any_lights(0, GLINT_COLOUR_MAX);
    any_material(0, GLINT_COLOUR_MAX);
    all.scene.ambient = any_colour(0, GLINT_COLOUR_MAX);
    all.scene.error_budget = ANY(0, GLINT_BUDGET_MAX);
    all.scene.lights = all.lights;
    format.bits = ANY_UNSIGNED(1, 24);
    frame.config.format = &format;
    frame.config.gamma = ANY(0, 1) ? gamma : 0;
    frame.config.keeps_arena = (uint8_t)ANY(0, 1);
    frame.scene = &all.scene;
    FOR_PARTS(count, 0, GLINT_LIGHTS_MAX) {
        all.scene.light_count = (uint32_t)count;
        glint_prepare_shading(&frame, &shading, &all.material);
    }
}
