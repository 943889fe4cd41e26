/* SPDX-License-Identifier: MIT */
/* What a frame looks like where it can be told without a reference, and what the rest of the interface says. */
#include "fixture.h"
#include "glint_extras.h"
#include "harness.h"
#include "unit.h"

void status_sentences(void) {
    for (int status = GLINT_OK; status >= GLINT_ERROR_WIDTH; status--) {
        const char *sentence = glint_strerror(status);
        CHECK(sentence != 0 && sentence[0] != '\0');
        for (int other = GLINT_OK; other > status; other--)
            CHECK(sentence != glint_strerror(other));
        CHECK(sentence != glint_strerror(1));
    }
    static const int none[] = {1, 2, GLINT_ERROR_WIDTH - 1, -1000000, INT32_MAX, INT32_MIN};
    for (unsigned i = 0; i < TEST_COUNT(none); i++) {
        const char *wanted = "unknown status";
        const char *sentence = glint_strerror(none[i]);
        while (*wanted != '\0' && *wanted == *sentence) {
            wanted++;
            sentence++;
        }
        CHECK_EQUAL(*sentence, *wanted);
    }
}

void row_bytes(void) {
    CHECK_EQUAL(glint_row_bytes(&glint_format_rgb565, 7), 14);
    CHECK_EQUAL(glint_row_bytes(&glint_format_rgb565_be, GLINT_SIZE_MAX), 2 * GLINT_SIZE_MAX);
    CHECK_EQUAL(glint_row_bytes(&glint_format_rgb888, 5), 15);
    CHECK_EQUAL(glint_row_bytes(&glint_format_grey8, 9), 9);
    CHECK_EQUAL(glint_row_bytes(&glint_format_grey4, 8), 4);
    CHECK_EQUAL(glint_row_bytes(&glint_format_grey4, 9), 5);
    CHECK_EQUAL(glint_row_bytes(&glint_format_grey4, 0), 0);
    CHECK_EQUAL(glint_row_bytes(&glint_format_rgb444, 8), 12);
    CHECK_EQUAL(glint_row_bytes(&glint_format_rgb444, 7), 11);
    CHECK_EQUAL(glint_row_bytes(&glint_format_mono, 8), 1);
    CHECK_EQUAL(glint_row_bytes(&glint_format_mono, 9), 2);
    CHECK_EQUAL(glint_row_bytes(&glint_format_mono_pages, 32), 4);
}

void statistics(void) {
    fixture *f = fixture_begin();
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    const glint_stats *stats = &f->renderer.stats;
    CHECK_EQUAL(stats->tiles, f->begins);
    CHECK(stats->passes >= 1);
    CHECK(stats->vertices >= 72);
    CHECK(stats->triangles >= 144);
    CHECK(stats->facing_away > 0 && stats->facing_away < stats->triangles);
    CHECK_EQUAL(stats->clipped, 0);
    CHECK_EQUAL(stats->hidden, 0);
    CHECK(stats->references > 0);
    CHECK(stats->arena_used > 0);
    CHECK_AT_MOST(stats->arena_used, FIXTURE_ARENA_BYTES);
    f->objects[0].pose.m[2][3] = GLINT_Q16(-0.7);
    f->scene.camera.near_plane = GLINT_Q16(0.3);
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK(f->renderer.stats.clipped > 0);
    glint_need need = {0, 0, 0};
    CHECK_EQUAL(glint_arena_need(&f->config, &f->scene, &need), GLINT_OK);
    /* an object that does not fit is drawn in parts, which leave such triangles out before they are counted */
    CHECK(f->renderer.stats.outside > 0 || need.resident > FIXTURE_ARENA_BYTES);
    f->objects[0].pose.m[0][3] = GLINT_Q16(-100);
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK(f->renderer.stats.hidden > 0);
}

/* Bytes of the arena before the longest run of those that a frame left as they were, and behind it. */
static void find_written(const fixture *f, uint32_t *before, uint32_t *behind) {
    const uint8_t *arena = fixture_arena();
    const uint8_t untouched = arena[FIXTURE_ARENA_BYTES];
    uint32_t run = 0, longest = 0;
    for (uint32_t i = 0; i < f->config.arena_size; i++) {
        run = arena[i] == untouched ? run + 1 : 0;
        if (run > longest) {
            longest = run;
            *before = i + 1 - run;
        }
    }
    *behind = (uint32_t)f->config.arena_size - *before - longest;
}

/* What lies between both ends of the arena is free; up to sizeof(void *) - 1 bytes are lost to aligning at each. */
static void expect_used(fixture *f, int clips) {
    const uint32_t lost = 2 * sizeof(void *) - 2;
    uint32_t before = 0, behind = 0;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_EQUAL(f->renderer.stats.passes, 1);
    CHECK_EQUAL(f->renderer.stats.clipped > 0, clips);
    find_written(f, &before, &behind);
    const uint32_t written = before + (clips ? behind : 0); /* else nothing stays at the high end */
    /* the last part of a triangle, which nobody sees, and what the arena ends with */
    const uint32_t more = clips ? 256 : 0;
    CHECK_AT_MOST(written, f->renderer.stats.arena_used + more);
    CHECK_AT_MOST(f->renderer.stats.arena_used, written + lost);
}

void arena_used_is_what_was_written(void) {
    fixture *f = fixture_begin();
    f->config.tile_width = f->config.tile_height = 8;
    expect_used(f, 0);
    f->objects[0].pose.m[2][3] = GLINT_Q16(-0.2);
    f->scene.camera.near_plane = GLINT_Q16(0.3);
    f->torus.triangle_count = 48;
    expect_used(f, 1);
}

/* ---- Clusters ------------------------------------------------------------------------------------------------- */

/* A torus without its first triangles, or without its last. */
static uint32_t checksum_of_part(uint32_t first, uint32_t count) {
    fixture *f = fixture_begin();
    f->torus.triangles += first;
    f->torus.triangle_count = count;
    f->scene.object_count = count ? 1 : 0;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    return fixture_checksum(f);
}

/* The torus in two clusters, of 60 triangles and of 84, each of which faces away from every eye or from none. */
#define CLUSTERS(first, second)             \
    {                                       \
        {{0, 0, 0}, 0, first, 60, 30, 1}, { \
            {0, 0, 0}, 0, second, 84, 42, 1 \
        }                                   \
    }

static const glint_cluster lists[4][2] = {CLUSTERS(-32767, -32767), CLUSTERS(32767, -32767), CLUSTERS(-32767, 32767),
                                          CLUSTERS(32767, 32767)};
static const uint16_t borrowers[2] = {1, 0};
static const glint_clusters clusters[4] = {{&glint_cull_cones, lists[0], borrowers, 2},
                                           {&glint_cull_cones, lists[1], borrowers, 2},
                                           {&glint_cull_cones, lists[2], borrowers, 2},
                                           {&glint_cull_cones, lists[3], borrowers, 2}};

static void expect_dropped(int which) {
    const uint32_t first = which & 1 ? 60 : 0, count = 144 - first - (which & 2 ? 84 : 0);
    const uint32_t expected = checksum_of_part(first, count);
    fixture *f = fixture_begin();
    f->torus.clusters = &clusters[which];
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_EQUAL(fixture_checksum(f), expected);
    CHECK_EQUAL(f->renderer.stats.triangles, 144);
    CHECK(f->renderer.stats.facing_away >= 144 - count);
    CHECK_EQUAL(f->renderer.stats.vertices > 0, count > 0);
    f->config.arena_size = fixture_need(f).least; /* in runs */
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_EQUAL(fixture_checksum(f), expected);
    f->torus.flags = GLINT_MESH_DOUBLE_SIDED; /* then all is seen */
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK(f->renderer.stats.facing_away < 60);
}

/* Borrowers without numbers, or with such as no cluster has, count as seen: then so do the vertices that they borrow.
 */
static void expect_seen_borrowers(int which, uint16_t count, const uint16_t *numbers) {
    const uint32_t first = which & 1 ? 60 : 0, triangles = 144 - first - (which & 2 ? 84 : 0);
    const uint32_t expected = checksum_of_part(first, triangles);
    glint_cluster list[2] = {lists[which][0], lists[which][1]};
    const glint_clusters seen = {&glint_cull_cones, list, numbers, 2};
    for (int small = 0; small < 2; small++) {
        fixture *f = fixture_begin();
        list[0].borrowers = list[1].borrowers = count;
        f->torus.clusters = &seen;
        f->config.arena_size = small ? fixture_need(f).least : f->config.arena_size;
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        CHECK_EQUAL(fixture_checksum(f), expected);
        if (!small)
            CHECK_EQUAL(f->renderer.stats.vertices, count ? 72 : (which & 1 ? 0 : 30) + (which & 2 ? 0 : 42));
    }
}

void clusters_that_face_away_are_dropped(void) {
    for (int which = 0; which < 4; which++)
        expect_dropped(which);
    static const uint16_t nobody[2] = {2, 2};
    for (int which = 0; which < 4; which++) {
        expect_seen_borrowers(which, 1, 0);
        expect_seen_borrowers(which, 1, nobody);
    }
    expect_seen_borrowers(3, 0, 0); /* others' triangles name vertices of both clusters */
    fixture *f = fixture_begin();   /* what is dropped takes no arena; tables would hide it */
    f->config.format = &glint_format_rgb888;
    f->torus.clusters = &clusters[0];
    const size_t with_all = fixture_need(f).one_pass;
    f->torus.clusters = &clusters[3];
    CHECK(fixture_need(f).one_pass < with_all);
}

/* ---- Materials -------------------------------------------------------------------------------------------------- */

void paint_is_diffuse_and_its_fraction_ambient(void) {
    static const glint_colour paint = {GLINT_Q16(0.8), 3, GLINT_COLOUR_MAX};
    static const struct {
        glint_q16 fraction;
        glint_colour ambient; /* rounded to nearest */
    } parts[] = {{0, {0, 0, 0}},
                 {GLINT_ONE / 4, {GLINT_Q16(0.2), 1, 4 * GLINT_ONE}},
                 {GLINT_ONE / 2, {GLINT_Q16(0.4) + 1, 2, 8 * GLINT_ONE}},
                 {GLINT_ONE, {GLINT_Q16(0.8), 3, GLINT_COLOUR_MAX}}};
    for (unsigned i = 0; i < TEST_COUNT(parts); i++) {
        const glint_colour *ambient = &parts[i].ambient;
        const glint_material m = glint_material_paint(&glint_model_phong, paint, parts[i].fraction, 77);
        CHECK(m.model == &glint_model_phong);
        CHECK(m.ambient.r == ambient->r && m.ambient.g == ambient->g && m.ambient.b == ambient->b);
        CHECK(m.diffuse.r == paint.r && m.diffuse.g == paint.g && m.diffuse.b == paint.b);
        CHECK(m.specular.r == GLINT_ONE && m.specular.g == GLINT_ONE && m.specular.b == GLINT_ONE);
        CHECK(m.shininess == 77 && m.flags == 0);
    }
}

/* ---- Pixels -------------------------------------------------------------------------------------------------- */

/* A square facing the camera, far larger than the screen. */
static fixture *begin_square(void) {
    fixture *f = fixture_begin();
    f->objects[0].mesh = &f->floor;
    f->objects[0].pose = glint_pose_rotate_x(90 * GLINT_ONE);
    f->objects[0].pose.m[2][3] = -10 * GLINT_ONE;
    f->config.format = &glint_format_rgb888;
    f->config.width = 40;
    return f;
}

/* @return largest difference of a channel of any pixel from the colour wanted. */
static int worst_difference(const fixture *f, const int wanted[3]) {
    int worst = 0;
    for (int y = 0; y < f->config.height; y++) {
        const uint8_t *row = fixture_row(f, y);
        for (int i = 0; i < 3 * f->config.width; i++) {
            int difference = row[i] - wanted[i % 3];
            difference = difference < 0 ? -difference : difference;
            worst = difference > worst ? difference : worst;
        }
    }
    return worst;
}

/* A triangle around (0, 0, -depth), lit at its centroid, without gate and with p = 0: any light would be seen. */
static int red_of_facet(int depth, int light_above) {
    static const int16_t positions[3][3] = {{-30000, 0, 15000}, {30000, 0, 15000}, {0, 0, -30000}};
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    fixture *f = begin_square();
    f->floor.positions = positions;
    f->floor.triangles = triangle;
    f->floor.vertex_count = 3;
    f->floor.triangle_count = 1;
    f->objects[0].evaluation = &glint_per_facet;
    f->objects[0].pose.m[2][3] = -depth * GLINT_ONE;
    f->lights[0].type = &glint_light_point;
    f->lights[0].position = (glint_vector){0, 0, (light_above - depth) * GLINT_ONE};
    f->materials[0].ambient.r = f->materials[0].ambient.g = f->materials[0].ambient.b = GLINT_ONE / 5;
    f->materials[0].specular.r = GLINT_ONE;
    f->materials[0].shininess = 0;
    f->materials[0].flags = GLINT_MATERIAL_SPECULAR_UNGATED;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    return fixture_row(f, f->config.height / 2)[3 * (f->config.width / 2)];
}

/* At depths that fixed point holds exactly and at others. */
void light_at_no_distance_adds_nothing(void) {
    for (int depth = 4; depth <= 12; depth++) {
        CHECK_EQUAL(red_of_facet(depth, 0), 51);
        CHECK_EQUAL(red_of_facet(depth, 1), 255);
    }
}

/* The screen's one pixel sees 170 degrees: its ray is too short to tell how near the light is. */
void light_at_the_only_pixel_is_left_out(void) {
    fixture *f = begin_square();
    f->config.width = f->config.height = 1;
    f->scene.camera.field_of_view = 170 * GLINT_ONE;
    f->objects[0].pose.m[2][3] = -3 * GLINT_ONE;
    f->lights[0].type = &glint_light_point;
    f->lights[0].position = (glint_vector){0, 0, -3 * GLINT_ONE};
    f->materials[0].ambient.r = GLINT_ONE / 5;
    f->materials[0].specular.r = GLINT_ONE;
    f->materials[0].shininess = 0;
    f->materials[0].flags = GLINT_MATERIAL_SPECULAR_UNGATED;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_EQUAL(fixture_row(f, 0)[0], 51);
}

/* Normals of length sqrt(3), all of which a squashed object turns into one component: the largest there is. */
void longest_normals_are_made_unit(void) {
    static const int16_t normals[4][3] = {
        {32767, 32767, 32767}, {32767, 32767, 32767}, {32767, 32767, 32767}, {32767, 32767, 32767}};
    static const glint_q16 squash[3][3] = {{9, 9, 9}, {46341, -46341, 0}, {26755, 26755, -53510}};
    static const int wanted[3] = {255, 0, 0};
    fixture *f = begin_square();
    f->floor.normals = normals;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            f->objects[0].pose.m[i][j] = squash[i][j];
    f->scene.camera.pose = glint_pose_rotate_y(90 * GLINT_ONE);
    f->objects[0].pose.m[0][3] = -10 * GLINT_ONE;
    f->objects[0].pose.m[2][3] = 0;
    f->lights[0].direction = (glint_vector){-GLINT_ONE, 0, 0};
    f->scene.ambient.r = f->scene.ambient.g = f->scene.ambient.b = 0;
    f->materials[0].diffuse.r = GLINT_ONE;
    f->materials[0].diffuse.g = f->materials[0].diffuse.b = 0;
    f->materials[0].specular.r = f->materials[0].specular.g = f->materials[0].specular.b = 0;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_AT_MOST(worst_difference(f, wanted), 1);
}

/* A normal and a light of such lengths that both come out longest as unit vectors, 32766. */
void mirrored_light_is_at_full_strength(void) {
    static const int16_t normals[4][3] = {{0, 16496, 0}, {0, 16496, 0}, {0, 16496, 0}, {0, 16496, 0}};
    static const int wanted[3] = {0, 255, 0};
    fixture *f = begin_square();
    f->scene.viewer = GLINT_VIEWER_INFINITE;
    f->lights[0].direction = (glint_vector){0, 0, GLINT_Q16(-1.0064)};
    f->floor.normals = normals;
    f->objects[0].evaluation = &glint_per_vertex;
    f->materials[0].model = &glint_model_phong;
    f->materials[0].ambient = f->materials[0].diffuse = f->materials[0].specular = (glint_colour){0, 0, 0};
    f->materials[0].specular.g = GLINT_ONE;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_AT_MOST(worst_difference(f, wanted), 1);
}

/* A square so far away, beside what is near, that 1/w rounds to 0: lit at its corners, or its triangles, it is white.
 */
void far_squares_without_depth(void) {
    static const int white[3] = {255, 255, 255};
    fixture *f = begin_square();
    f->scene.light_count = 0;
    f->scene.object_count = 2;
    f->scene.camera.field_of_view = GLINT_ONE;
    f->scene.camera.near_plane = 1;
    f->objects[1] = f->objects[0]; /* upright through the eye, which sees its edge alone */
    f->objects[1].pose = glint_pose_identity();
    f->objects[0].evaluation = &glint_per_vertex;
    f->materials[0].ambient = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            f->objects[0].pose.m[row][column] *= 10;
    f->objects[0].pose.m[2][3] = -32767 * GLINT_ONE;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_EQUAL(f->renderer.stats.hidden, 0);
    CHECK_AT_MOST(worst_difference(f, white), 1);
    f->objects[0].evaluation = &glint_per_facet; /* a light at the eye, which nothing weakens, reaches it */
    f->scene.light_count = 1;
    f->lights[0].type = &glint_light_point;
    f->lights[0].position = (glint_vector){0, 0, 0};
    f->materials[0].ambient = f->materials[0].specular = (glint_colour){0, 0, 0};
    f->materials[0].diffuse = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_AT_MOST(worst_difference(f, white), 1);
}

/* A mesh of a few steps lies where it lies as an object moved by its offset: a user would see it beside its place. */
void offset_of_one_step_moves_a_mesh(void) {
    uint32_t checksum[3];
    for (int i = 0; i < 3; i++) {
        fixture *f = fixture_begin();
        f->torus.extent = (glint_vector){8, 8, 8};
        f->torus.offset.x = i == 1;
        f->objects[0].pose = glint_pose_translate(i == 2, 0, 0);
        f->scene.camera.pose = glint_pose_translate(0, 0, 24);
        f->scene.camera.near_plane = 1;
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        checksum[i] = fixture_checksum(f);
    }
    CHECK_EQUAL(checksum[1], checksum[2]);
    CHECK(checksum[0] != checksum[1]);
}

/* Two corners face one way, and the third its mirror image: no order of the corners makes that one colour. */
void normals_that_differ_in_x_shade_a_triangle(void) {
    static const int16_t positions[3][3] = {{-32767, -32767, 0}, {0, 32767, 0}, {32767, -32767, 0}};
    static const int16_t normals[3][3] = {{-20000, 0, 25956}, {-20000, 0, 25956}, {20000, 0, 25956}};
    static const uint16_t orders[3][1][3] = {{{2, 1, 0}}, {{1, 0, 2}}, {{0, 2, 1}}};
    uint32_t checksum[3];
    for (int i = 0; i < 3; i++) {
        fixture *f = fixture_begin();
        f->floor = (glint_mesh){.positions = positions,
                                .normals = normals,
                                .triangles = orders[i],
                                .vertex_count = 3,
                                .triangle_count = 1,
                                .extent = {GLINT_ONE, GLINT_ONE, 0}};
        f->objects[0].mesh = &f->floor;
        f->objects[0].pose = glint_pose_translate(0, 0, 0);
        f->materials[0] = (glint_material){.model = &glint_model_lambert, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
        f->lights[0].direction = (glint_vector){-GLINT_ONE, 0, -GLINT_ONE};
        f->scene.camera.pose = glint_pose_translate(0, 0, 2 * GLINT_ONE);
        CHECK_EQUAL(fixture_render(f), GLINT_OK);
        checksum[i] = fixture_checksum(f);
    }
    CHECK_EQUAL(checksum[0], checksum[1]);
    CHECK_EQUAL(checksum[1], checksum[2]);
}
