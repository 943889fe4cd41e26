/* SPDX-License-Identifier: MIT */
/* Bad scenes: each gives its documented error before anything is sent, and spoils nothing. */
#include "fixture.h"
#include "harness.h"
#include "unit.h"

void null_pointers_in_scenes_are_refused(void) {
    for (int which = 0; which < 10; which++) {
        fixture *f = fixture_begin();
        const void **const pointers[10] = {
            (const void **)(void *)&f->scene.lights,        (const void **)(void *)&f->scene.objects,
            (const void **)(void *)&f->lights[0].type,      (const void **)(void *)&f->objects[0].mesh,
            (const void **)(void *)&f->objects[0].material, (const void **)(void *)&f->materials[0].model,
            (const void **)(void *)&f->torus.positions,     (const void **)(void *)&f->torus.normals,
            (const void **)(void *)&f->torus.triangles,     (const void **)(void *)&f->objects[0].evaluation};
        *pointers[which] = 0;
        fixture_expect_error(f, GLINT_ERROR_NULL);
    }
}

/* ---- Camera and viewer --------------------------------------------------------------------------------------- */

static void expect_camera(glint_q16 field_of_view, glint_q16 near_plane) {
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.field_of_view = field_of_view, f->scene.camera.near_plane = near_plane);
}

static void expect_look_at(glint_vector eye, glint_vector at, glint_vector up) {
    glint_camera camera;
    CHECK_EQUAL(glint_camera_look_at(&camera, eye, at, up), GLINT_ERROR_CAMERA);
}

void bad_cameras_are_refused(void) {
    const glint_vector zero = {0, 0, 0};
    const glint_vector along = {GLINT_ONE, 2 * GLINT_ONE, 3 * GLINT_ONE};
    const glint_vector twice = {2 * GLINT_ONE, 4 * GLINT_ONE, 6 * GLINT_ONE};
    expect_camera(GLINT_ONE - 1, GLINT_ONE);
    expect_camera(0, GLINT_ONE);
    expect_camera(-60 * GLINT_ONE, GLINT_ONE);
    expect_camera(170 * GLINT_ONE + 1, GLINT_ONE);
    expect_camera(INT32_MAX, GLINT_ONE);
    expect_camera(60 * GLINT_ONE, 0);
    expect_camera(60 * GLINT_ONE, -1);
    expect_camera(60 * GLINT_ONE, INT32_MIN);
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.pose.m[0][0] = 2 * GLINT_ONE);
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.pose.m[1][1] = 0);
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.pose.m[2][2] = GLINT_ONE / 2);
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.pose.m[0][1] = GLINT_ONE / 4);
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.pose.m[2][0] = INT32_MIN);
    ACCEPTED(f->scene.camera.pose.m[0][0] = GLINT_ONE + 63); /* its square is off by less than 2^-9 */
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.pose.m[0][0] = GLINT_ONE + 64);
    REFUSED(GLINT_ERROR_CAMERA, f->scene.camera.pose.m[0][0] = GLINT_ONE - 65);
    expect_look_at(zero, zero, along);
    expect_look_at(zero, along, zero);
    expect_look_at(zero, along, twice);
    expect_look_at(twice, along, along);
    for (int viewer = 2; viewer < 4; viewer++)
        REFUSED(GLINT_ERROR_VIEWER, f->scene.viewer = (glint_viewer)viewer);
}

/* ---- Lights and colours -------------------------------------------------------------------------------------- */

void bad_lights_are_refused(void) {
    static const glint_q16 exponents[] = {-1, -GLINT_ONE, INT32_MIN};
    const glint_vector zero = {0, 0, 0};
    REFUSED(GLINT_ERROR_LIGHTS, f->scene.light_count = GLINT_LIGHTS_MAX + 1);
    REFUSED(GLINT_ERROR_LIGHTS, f->scene.light_count = 0xffffffffu);
    REFUSED(GLINT_ERROR_DIRECTION, f->scene.light_count = GLINT_LIGHTS_MAX,
            f->lights[GLINT_LIGHTS_MAX - 1].direction = zero);
    for (unsigned i = 0; i < TEST_COUNT(exponents); i++)
        REFUSED(GLINT_ERROR_SHININESS, f->materials[0].shininess = exponents[i]);
}

/* A sound spot as the last light. */
static glint_light *last_spot(fixture *f) {
    glint_light *light = &f->lights[GLINT_LIGHTS_MAX - 1];
    f->scene.light_count = GLINT_LIGHTS_MAX;
    light->type = &glint_light_spot;
    light->direction = (glint_vector){0, 0, -1};
    light->outer = GLINT_ONE;
    return light;
}

static void set_cone(fixture *f, glint_q16 inner, glint_q16 outer) {
    glint_light *light = last_spot(f);
    light->inner = inner;
    light->outer = outer;
}

static void set_attenuation(fixture *f, const glint_light_type *type, glint_q16 linear, glint_q16 quadratic) {
    glint_light *light = last_spot(f);
    light->type = type;
    light->linear = linear;
    light->quadratic = quadratic;
}

void bad_lamps_are_refused(void) {
    for (int spot = 0; spot < 2; spot++) {
        const glint_light_type *type = spot ? &glint_light_spot : &glint_light_point;
        REFUSED(GLINT_ERROR_ATTENUATION, set_attenuation(f, type, -1, 0));
        REFUSED(GLINT_ERROR_ATTENUATION, set_attenuation(f, type, 0, -1));
        REFUSED(GLINT_ERROR_ATTENUATION, set_attenuation(f, type, INT32_MIN, INT32_MAX));
    }
    REFUSED(GLINT_ERROR_CONE, set_cone(f, 2, 1));
    REFUSED(GLINT_ERROR_CONE, set_cone(f, -1, GLINT_ONE));
    REFUSED(GLINT_ERROR_CONE, set_cone(f, -2, -1));
    REFUSED(GLINT_ERROR_CONE, set_cone(f, 0, 180 * GLINT_ONE + 1));
    REFUSED(GLINT_ERROR_CONE, set_cone(f, INT32_MAX, INT32_MAX));
    REFUSED(GLINT_ERROR_CONE, set_cone(f, 0, -1));
    ACCEPTED(set_cone(f, 0, 0));
    ACCEPTED(set_cone(f, 45 * GLINT_ONE, 45 * GLINT_ONE));
    ACCEPTED(set_cone(f, 0, 180 * GLINT_ONE));
    ACCEPTED(set_cone(f, 180 * GLINT_ONE, 180 * GLINT_ONE));
    REFUSED(GLINT_ERROR_DIRECTION, last_spot(f)->direction.z = 0);
    fixture *f = fixture_begin(); /* a position may be anywhere, and the rest is no spot's */
    glint_light *light = last_spot(f);
    light->type = &glint_light_point;
    light->direction.z = 0;
    light->inner = 2 * GLINT_ONE;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
}

static glint_q16 *channel_of(glint_colour *colour, int channel) {
    return channel == 0 ? &colour->r : channel == 1 ? &colour->g : &colour->b;
}

/* Every colour of a scene, every channel. */
static void expect_colour(int which, int channel, glint_q16 value) {
    fixture *f = fixture_begin();
    glint_colour *const colours[7] = {&f->scene.background,     &f->scene.ambient,        &f->lights[0].diffuse,
                                      &f->lights[0].specular,   &f->materials[0].ambient, &f->materials[0].diffuse,
                                      &f->materials[0].specular};
    *channel_of(colours[which], channel) = value;
    fixture_expect_error(f, GLINT_ERROR_COLOUR);
}

void bad_colours_are_refused(void) {
    for (int which = 0; which < 7; which++) {
        expect_colour(which, which % 3, -1);
        expect_colour(which, (which + 1) % 3, GLINT_COLOUR_MAX + 1);
        expect_colour(which, (which + 2) % 3, INT32_MIN);
        expect_colour(which, which % 3, INT32_MAX);
    }
    /* each within its limits, their product is not */
    REFUSED(GLINT_ERROR_COLOUR, f->lights[0].diffuse.g = 5 * GLINT_ONE, f->materials[0].diffuse.g = 4 * GLINT_ONE);
    REFUSED(GLINT_ERROR_COLOUR, f->lights[0].specular.b = f->materials[0].specular.b = GLINT_COLOUR_MAX);
}

/* Bits that are defined are accepted, all others are refused. */
void unknown_flags_are_refused(void) {
    for (int bit = 0; bit < 32; bit++) {
        const uint32_t flag = 1u << bit;
        if (flag & GLINT_MESH_DOUBLE_SIDED)
            ACCEPTED(f->torus.flags = flag);
        else
            REFUSED(GLINT_ERROR_FLAGS, f->torus.flags = flag);
        if (flag < 2 * GLINT_MATERIAL_BILINEAR)
            ACCEPTED(f->materials[0].flags = flag);
        else
            REFUSED(GLINT_ERROR_FLAGS, f->materials[0].flags = flag);
    }
}

/* ---- Meshes and poses ---------------------------------------------------------------------------------------- */

static void expect_index(uint16_t index, int corner) {
    uint16_t triangles[3][3] = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    fixture *f = fixture_begin();
    triangles[2][corner] = index;
    f->torus.triangles = (const uint16_t(*)[3])triangles;
    f->torus.triangle_count = 3;
    fixture_expect_error(f, GLINT_ERROR_INDEX);
}

/* The torus as most draws have it, clipped, mirrored, double-sided, and all of these at once. */
static void set_up_draw(fixture *f, int kind) {
    const glint_pose mirror = glint_pose_scale(-GLINT_ONE, GLINT_ONE, GLINT_ONE);
    if (kind & 1) {
        f->objects[0].pose.m[2][3] = GLINT_Q16(-0.2);
        f->scene.camera.near_plane = GLINT_Q16(0.3);
    }
    if (kind & 2)
        f->objects[0].pose = glint_pose_then(&mirror, &f->objects[0].pose);
    if (kind & 4)
        f->torus.flags = GLINT_MESH_DOUBLE_SIDED;
}

/* The last index of a mesh, with an arena that takes one pass or many: found before the first tile all the same. */
static void expect_last_index(int kind, int corner, int small) {
    static uint16_t triangles[48][3];
    fixture *f = fixture_begin();
    const uint32_t count = TEST_COUNT(triangles);
    set_up_draw(f, kind);
    f->torus.triangle_count = count;
    for (uint32_t i = 0; i < 3 * count; i++)
        triangles[i / 3][i % 3] = f->torus.triangles[i / 3][i % 3];
    f->torus.triangles = (const uint16_t(*)[3])triangles;
    const glint_need need = fixture_need(f);
    f->config.arena_size = small ? need.least : f->config.arena_size;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK(f->renderer.stats.clipped > 0 || !(kind & 1));
    CHECK(small ? f->renderer.stats.passes > 1 : f->renderer.stats.passes == 1 || need.one_pass > f->config.arena_size);
    triangles[count - 1][corner] = 72;
    fixture_expect_error(f, GLINT_ERROR_INDEX);
}

/* Two clusters; the second faces away from every eye. */
#define CLUSTERS(spread, height, triangles, vertices)          \
    {                                                          \
        {{0, 0, 0}, spread, height, triangles, vertices, 1}, { \
            {0, 0, 0}, 0, 32767, 44, 22, 1                     \
        }                                                      \
    }

static const glint_cluster lists[6][2] = {CLUSTERS(0, 32767, 100, 50), CLUSTERS(255, -1, 100, 50),
                                          CLUSTERS(0, 32767, 99, 50),  CLUSTERS(0, 32767, 101, 50),
                                          CLUSTERS(0, 32767, 100, 51), CLUSTERS(0, 32767, 100, 65535)};
static const uint16_t borrowers[2] = {1, 2}; /* there is no cluster 2 */
static const glint_clusters clusters[8] = {{&glint_cull_cones, lists[0], borrowers, 2},
                                           {&glint_cull_cones, lists[1], borrowers, 2},
                                           {0, 0, 0, 0},
                                           {&glint_cull_cones, lists[2], borrowers, 2},
                                           {&glint_cull_cones, lists[3], borrowers, 2},
                                           {&glint_cull_cones, lists[4], borrowers, 2},
                                           {&glint_cull_cones, lists[5], borrowers, 2},
                                           {&glint_cull_cones, 0, borrowers, 2}};

static void expect_clusters(int which, glint_status expected) {
    for (int small = 0; small < 2; small++) {
        fixture *f = fixture_begin();
        f->config.arena_size = small ? fixture_need(f).least : f->config.arena_size;
        f->torus.clusters = &clusters[which];
        if (expected == GLINT_OK)
            CHECK_EQUAL(fixture_render(f), GLINT_OK);
        else
            fixture_expect_error(f, expected);
    }
}

/* With no way to drop them, clusters are as if they were not there, whatever the rest says. */
static void expect_clusters_unused(void) {
    static const uint32_t counts[] = {1, 65537, 4294954080u, UINT32_MAX};
    fixture *f = fixture_begin();
    const glint_need plain = fixture_need(f);
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    const uint32_t wanted = fixture_checksum(f);
    for (unsigned i = 0; i < TEST_COUNT(counts); i++) {
        const glint_clusters unused = {0, lists[0], borrowers, counts[i]};
        f = fixture_begin();
        f->torus.clusters = &unused;
        const glint_need need = fixture_need(f);
        CHECK_EQUAL(need.least, plain.least);
        CHECK_EQUAL(need.one_pass, plain.one_pass);
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        CHECK_EQUAL(fixture_checksum(f), wanted);
    }
}

void bad_clusters_are_refused(void) {
    for (int which = 0; which < 7; which++)
        expect_clusters(which, which < 3 ? GLINT_OK : GLINT_ERROR_MESH);
    expect_clusters(7, GLINT_ERROR_NULL);
    expect_clusters_unused();
}

void bad_meshes_are_refused(void) {
    for (int which = 0; which < 6; which++) {
        fixture *f = fixture_begin();
        f->torus.vertex_count = which == 0 ? 0 : which == 1 ? 65537 : which == 2 ? 0xffffffffu : 72;
        f->torus.triangle_count = which == 3 ? 0 : 144;
        f->torus.extent.x = which == 4 ? -1 : GLINT_ONE;
        f->torus.extent.z = which == 5 ? INT32_MIN : GLINT_ONE;
        fixture_expect_error(f, GLINT_ERROR_MESH);
    }
    for (int corner = 0; corner < 3; corner++) {
        expect_index(72, corner);
        expect_index(65535, corner);
    }
    for (int kind = 0; kind < 8; kind++)
        for (int corner = 0; corner < 3; corner++)
            for (int small = 0; small < 2; small++)
                expect_last_index(kind, corner, small);
}

static void expect_pose(glint_q16 x, glint_q16 y, glint_q16 z) {
    fixture *f = fixture_begin();
    glint_pose scaling = glint_pose_scale(x, y, z);
    f->objects[0].pose = glint_pose_then(&scaling, &f->objects[0].pose);
    fixture_expect_error(f, GLINT_ERROR_POSE);
}

void bad_poses_are_refused(void) {
    expect_pose(0, 0, 0);
    expect_pose(0, GLINT_ONE, GLINT_ONE);
    expect_pose(GLINT_ONE, 0, GLINT_ONE);
    expect_pose(GLINT_ONE, GLINT_ONE, 0);
    fixture *f = fixture_begin(); /* two columns alike */
    for (int row = 0; row < 3; row++)
        f->objects[0].pose.m[row][1] = f->objects[0].pose.m[row][2];
    fixture_expect_error(f, GLINT_ERROR_POSE);
    f = fixture_begin();
    for (int row = 0; row < 3; row++)
        f->objects[0].pose.m[row][row] = INT32_MAX;
    f->torus.extent.x = f->torus.extent.y = f->torus.extent.z = INT32_MAX;
    f->torus.offset.x = INT32_MAX;
    fixture_expect_error(f, GLINT_ERROR_RANGE);
}

/* ---- What is allowed ----------------------------------------------------------------------------------------- */

/* Scenes at their limits, none beyond them. */
void limits_are_accepted(void) {
    ACCEPTED(f->scene.camera.field_of_view = GLINT_ONE);
    ACCEPTED(f->scene.camera.field_of_view = 170 * GLINT_ONE);
    ACCEPTED(f->scene.camera.near_plane = 1);
    ACCEPTED(f->scene.camera.near_plane = INT32_MAX);
    ACCEPTED(f->lights[0].direction.x = f->lights[0].direction.y = f->lights[0].direction.z = INT32_MIN);
    ACCEPTED(f->lights[0].direction.x = f->lights[0].direction.y = 0, f->lights[0].direction.z = -1);
    ACCEPTED(f->scene.light_count = 0, f->scene.lights = 0);
    ACCEPTED(f->scene.background.r = f->materials[0].ambient.r = f->lights[0].diffuse.g = GLINT_COLOUR_MAX);
    ACCEPTED(f->materials[0].shininess = INT32_MAX);
    ACCEPTED(f->torus.extent.x = f->torus.extent.y = f->torus.extent.z = 0);
}
