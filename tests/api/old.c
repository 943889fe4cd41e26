/* SPDX-License-Identifier: MIT */
/*
 * Suite: what was written for version 0.1.0 compiles and means what it meant. Structures have grown at their ends
 * alone: initialisers by position fill the fields that they filled.
 */
#include "glint_extras.h"
#include "harness.h"
#include "panel/panel.h"

/* ---- Fields, in the order that they had ----------------------------------------------------------------------------
 */

static const int16_t triples[1][3] = {{1, 2, 3}};
static const uint16_t numbers[1][3] = {{4, 5, 6}}, gamma_tables[3][GLINT_GAMMA_ENTRIES] = {{7}};
static const uint8_t bytes[1][3] = {{8, 9, 10}};

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

static int wait(void *context) {
    (void)context;
    return 0;
}

static int paint(void *context, const glint_tile *tile) {
    (void)context, (void)tile;
    return 0;
}

static void scenes(void) {
    const glint_cluster cluster = {{1, 2, 3}, 4, 5, 6, 7, 8};
    const glint_clusters clusters = {&glint_cull_cones, &cluster, numbers[0], 9};
    const glint_mesh mesh = {triples, triples, numbers, 1, 2, {3, 4, 5}, {6, 7, 8}, 9, bytes, numbers[0], &clusters};
    const glint_material material = {&glint_model_phong, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, 10, 11};
    const glint_light light = {&glint_light_spot, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, 13, 14, 15, 16};
    const glint_object object = {
        &mesh, &material, {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}}, &glint_per_facet, 13};
    const glint_scene scene = {{{{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}}, 13, 14},
                               GLINT_VIEWER_LOCAL,
                               {15, 16, 17},
                               {18, 19, 20},
                               &light,
                               21,
                               &object,
                               22};
    CHECK(cluster.axis[2] == 3 && cluster.spread == 4 && cluster.height == 5 && cluster.triangles == 6 &&
          cluster.vertices == 7 && cluster.borrowers == 8);
    CHECK(clusters.cull == &glint_cull_cones && clusters.list == &cluster && clusters.borrowers == numbers[0] &&
          clusters.count == 9);
    CHECK(mesh.positions == triples && mesh.normals == triples && mesh.triangles == numbers && mesh.vertex_count == 1 &&
          mesh.triangle_count == 2 && mesh.offset.z == 5 && mesh.extent.x == 6 && mesh.flags == 9 &&
          mesh.colours == bytes && mesh.colours565 == numbers[0] && mesh.clusters == &clusters);
    CHECK(material.model == &glint_model_phong && material.ambient.r == 1 && material.diffuse.g == 5 &&
          material.specular.b == 9 && material.shininess == 10 && material.flags == 11);
    CHECK(light.type == &glint_light_spot && light.position.x == 1 && light.direction.y == 5 && light.diffuse.b == 9 &&
          light.specular.g == 11 && light.linear == 13 && light.quadratic == 14 && light.inner == 15 &&
          light.outer == 16);
    CHECK(object.mesh == &mesh && object.material == &material && object.pose.m[2][3] == 12 &&
          object.evaluation == &glint_per_facet && object.hidden == 13);
    CHECK(scene.camera.pose.m[1][0] == 5 && scene.camera.field_of_view == 13 && scene.camera.near_plane == 14 &&
          scene.viewer == GLINT_VIEWER_LOCAL && scene.background.r == 15 && scene.ambient.b == 20 &&
          scene.lights == &light && scene.light_count == 21 && scene.objects == &object && scene.object_count == 22);
}

static void configurations(void) {
    static int16_t room_triples[1][3];
    static uint16_t room_numbers[1][3];
    int own = 0;
    const glint_flush flush = {begin, wait, &own};
    const glint_config config = {1,
                                 2,
                                 3,
                                 4,
                                 &glint_format_grey8,
                                 {begin, wait, &own},
                                 &own,
                                 5,
                                 room_triples,
                                 6,
                                 gamma_tables,
                                 7,
                                 9,
                                 10,
                                 {11, 12, 13, 14},
                                 {paint, &own},
                                 {paint, room_numbers}};
    const glint_mesh_room room = {room_triples, room_triples, room_numbers, 1, 2};
    const glint_tile tile = {1, 2, 3, 4, &own, 5, numbers[0], 6};
    CHECK(flush.begin == begin && flush.wait == wait && flush.context == &own);
    CHECK(config.width == 1 && config.height == 2 && config.tile_width == 3 && config.tile_height == 4 &&
          config.format == &glint_format_grey8 && config.flush.context == &own && config.arena == &own &&
          config.arena_size == 5 && config.pixels == room_triples && config.pixels_size == 6 &&
          config.gamma == gamma_tables && config.keeps_arena == 7 && config.left == 9 && config.top == 10 &&
          config.region.height == 14 && config.background.paint == paint && config.overlay.context == room_numbers);
    CHECK(room.positions == room_triples && room.normals == room_triples && room.triangles == room_numbers &&
          room.vertex_room == 1 && room.triangle_room == 2);
    CHECK(tile.x == 1 && tile.y == 2 && tile.width == 3 && tile.height == 4 && tile.pixels == &own &&
          tile.stride == 5 && tile.depth == numbers[0] && tile.depth_stride == 6);
}

static void results(void) {
    const glint_stats stats = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    const glint_need need = {1, 2, 3};
    const glint_report report = {GLINT_ERROR_MESH, "", 1, 2, 3, 4};
    const glint_screen_point place = {1, 2, 3};
    const glint_hit hit = {1, 2, 3};
    CHECK(stats.passes == 1 && stats.tiles == 2 && stats.vertices == 3 && stats.triangles == 4 &&
          stats.facing_away == 5 && stats.outside == 6 && stats.clipped == 7 && stats.hidden == 8 &&
          stats.references == 9 && stats.arena_used == 10 && stats.flush_error == 11 && stats.skipped == 12);
    CHECK(need.least == 1 && need.resident == 2 && need.one_pass == 3);
    CHECK(report.status == GLINT_ERROR_MESH && !*report.sentence && report.object == 1 && report.light == 2 &&
          report.bytes == 3 && report.shown == 4);
    CHECK(place.x == 1 && place.y == 2 && place.distance == 3);
    CHECK(hit.object == 1 && hit.triangle == 2 && hit.depth == 3);
}

static glint_status send(void *context, const uint8_t *bytes_sent, size_t count) {
    (void)context, (void)bytes_sent, (void)count;
    return GLINT_OK;
}

static glint_status send_rows(void *context, const uint8_t *bytes_sent, size_t row_bytes, size_t rows, size_t stride) {
    (void)context, (void)bytes_sent, (void)row_bytes, (void)rows, (void)stride;
    return GLINT_OK;
}

static glint_status wait_for_bus(void *context) {
    (void)context;
    return GLINT_OK;
}

static void set(void *context, int active) {
    (void)context, (void)active;
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context, (void)milliseconds;
}

static void panels(void) {
    int own = 0;
    const glint_panel_type type = {
        NULL, &glint_format_mono, &glint_format_grey8, bytes[0], 1, 2, 3, 4, 5, 6, 7, {8, 9}, 10, 11, 12};
    const glint_bus bus = {send, send, send_rows, wait_for_bus, set, set, delay, &own, send_rows};
    const glint_panel panel = {&type, &bus, GLINT_PANEL_90, &glint_format_grey8, 1};
    CHECK(!type.family && type.format == &glint_format_mono && type.format_turned == &glint_format_grey8 &&
          type.start == bytes[0] && type.width == 1 && type.height == 2 && type.memory_width == 3 &&
          type.memory_height == 4 && type.left == 5 && type.top == 6 && type.glass == 7 && type.bits[1] == 9 &&
          type.reset_low_ms == 10 && type.reset_wait_ms == 11 && type.clock_max == 12);
    CHECK(bus.command == send && bus.begin == send_rows && bus.wait == wait_for_bus && bus.reset == set &&
          bus.backlight == set && bus.delay == delay && bus.context == &own && bus.begin_words == send_rows);
    CHECK(panel.type == &type && panel.bus == &bus && panel.rotation == GLINT_PANEL_90 &&
          panel.format == &glint_format_grey8 && panel.has_words == 1);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(scenes),
        TEST_CASE(configurations),
        TEST_CASE(results),
        TEST_CASE(panels),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
