/* SPDX-License-Identifier: MIT */
/*
 * Suite: a mesh whose attributes are laid out in any way is drawn as one whose arrays hold the decoded numbers, which
 * are decoded here by other means.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "surfaces.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 150
#define HEIGHT 101
#define VERTICES_MAX 4608
#define TRIANGLES_MAX 9216

/* ---- Layouts ---- */

/* What of a mesh is laid out anew; types that are null leave the mesh's own array. */
typedef struct variant {
    const char *name;
    const glint_attribute_type *positions, *normals, *triangles, *colours;
    int is_interleaved;
} variant;

static const variant variants[] = {
    {"int16, uint16, apart", &glint_attribute_int16, &glint_attribute_int16, &glint_attribute_uint16,
     &glint_attribute_rgb888, 1},
    {"int8, octahedral8", &glint_attribute_int8, &glint_attribute_octahedral8, NULL, NULL, 0},
    {"int8, octahedral16, apart", &glint_attribute_int8, &glint_attribute_octahedral16, &glint_attribute_uint8,
     &glint_attribute_rgb565, 1},
    {"normals alone", NULL, &glint_attribute_octahedral8, NULL, NULL, 0},
    {"triangles alone", NULL, NULL, &glint_attribute_uint8, NULL, 0},
    {"int8, int8", &glint_attribute_int8, &glint_attribute_int8, &glint_attribute_uint16, &glint_attribute_rgb888, 0},
};

/* A mesh in arrays of its own, and the same laid out in another way. */
typedef struct pair {
    glint_mesh plain, other;
    glint_mesh_layout layout;
    int16_t positions[VERTICES_MAX][3], normals[VERTICES_MAX][3];
    uint16_t triangles[TRIANGLES_MAX][3];
    uint8_t colours[VERTICES_MAX][3];
    uint16_t colours565[VERTICES_MAX];
    uint8_t vertices[VERTICES_MAX][32], faces[TRIANGLES_MAX][8]; /* places of one vertex and triangle after the other */
    uint8_t apart[3][VERTICES_MAX][6];
} pair;

static void put(uint8_t *to, size_t size, int value) {
    const int16_t word = (int16_t)value;
    const int8_t byte = (int8_t)value;
    memcpy(to, size == 1 ? (const void *)&byte : (const void *)&word, size);
}

/* Bytes of an attribute of one vertex or triangle, as glint.h says. */
static uint32_t size_of(const glint_attribute_type *type) {
    return type == &glint_attribute_int16 || type == &glint_attribute_uint16         ? 6
           : type == &glint_attribute_octahedral16                                   ? 4
           : type == &glint_attribute_octahedral8 || type == &glint_attribute_rgb565 ? 2
                                                                                     : 3;
}

/* Where an attribute begins: within structs of 32 bytes, or by itself. */
static uint8_t *place_of(pair *p, const variant *v, glint_mesh_attribute *a, const glint_attribute_type *type,
                         int which, uint32_t *step) {
    static const uint32_t at[3] = {2, 10, 20}; /* the bytes between hold nothing */
    uint8_t *const from = v->is_interleaved ? &p->vertices[0][at[which]] : &p->apart[which][0][0];
    *step = v->is_interleaved ? (uint32_t)sizeof p->vertices[0] : size_of(type);
    *a = (glint_mesh_attribute){type, from, v->is_interleaved ? *step : 0};
    return from;
}

static void lay_positions(pair *p, const variant *v) {
    uint32_t step;
    uint8_t *to = place_of(p, v, &p->layout.positions, v->positions, 0, &step);
    const int is_small = v->positions == &glint_attribute_int8;
    for (uint32_t i = 0; i < p->plain.vertex_count; i++, to += step)
        for (int c = 0; c < 3; c++) {
            if (is_small) {
                const int value = (int)floor(p->positions[i][c] / 256.0);
                p->positions[i][c] = (int16_t)(value * 256);
                put(to + c, 1, value);
            } else {
                put(to + 2 * c, 2, p->positions[i][c]);
            }
        }
    p->other.positions = NULL;
}

static double sign_of(double x) {
    return x < 0 ? -1 : 1;
}

/* Encodes a normal, and gives the mesh in arrays what the code stands for (Cigolle et al., 2014). */
static void encode(int16_t normal[3], int one, int scale, int code[2]) {
    const double sum = abs(normal[0]) + abs(normal[1]) + abs(normal[2]);
    const double x = normal[0] / sum, y = normal[1] / sum;
    const double u = normal[2] < 0 ? (1 - fabs(y)) * sign_of(x) : x, v = normal[2] < 0 ? (1 - fabs(x)) * sign_of(y) : y;
    code[0] = (int)lround(u * one);
    code[1] = (int)lround(v * one);
    const double a = code[0], b = code[1], z = one - fabs(a) - fabs(b);
    normal[0] = (int16_t)lround(scale * (z < 0 ? (one - fabs(b)) * sign_of(a) : a));
    normal[1] = (int16_t)lround(scale * (z < 0 ? (one - fabs(a)) * sign_of(b) : b));
    normal[2] = (int16_t)lround(scale * z);
}

static void lay_normals(pair *p, const variant *v) {
    uint32_t step;
    uint8_t *to = place_of(p, v, &p->layout.normals, v->normals, 1, &step);
    for (uint32_t i = 0; i < p->plain.vertex_count; i++, to += step) {
        int16_t *const n = p->normals[i];
        const int is_null = !(n[0] | n[1] | n[2]);
        int code[2] = {0, 0};
        if (v->normals == &glint_attribute_int16 || v->normals == &glint_attribute_int8) {
            for (int c = 0; c < 3; c++) {
                const int is_small = v->normals == &glint_attribute_int8;
                n[c] = (int16_t)(is_small ? n[c] / 256 * 256 : n[c]);
                put(to + (is_small ? c : 2 * c), is_small ? 1 : 2, is_small ? n[c] / 256 : n[c]);
            }
            continue;
        }
        if (is_null)
            n[2] = 1; /* which no code stands for */
        if (v->normals == &glint_attribute_octahedral8)
            encode(n, 127, 258, code);
        else
            encode(n, 32767, 1, code);
        put(to, size_of(v->normals) / 2, code[0]);
        put(to + size_of(v->normals) / 2, size_of(v->normals) / 2, code[1]);
    }
    p->other.normals = NULL;
}

static void lay_triangles(pair *p, const variant *v) {
    const uint32_t size = size_of(v->triangles) / 3, step = v->is_interleaved ? sizeof p->faces[0] : 3 * size;
    uint8_t *to = &p->faces[0][0];
    p->layout.triangles = (glint_mesh_attribute){v->triangles, to, v->is_interleaved ? step : 0};
    for (uint32_t i = 0; i < p->plain.triangle_count; i++, to += step)
        for (uint32_t c = 0; c < 3; c++)
            put(to + c * size, size, p->triangles[i][c]);
    p->other.triangles = NULL;
}

static void lay_colours(pair *p, const variant *v) {
    uint32_t step;
    uint8_t *to = place_of(p, v, &p->layout.colours, v->colours, 2, &step);
    for (uint32_t i = 0; i < p->plain.vertex_count; i++, to += step) {
        if (v->colours == &glint_attribute_rgb888)
            memcpy(to, p->colours[i], 3);
        else
            put(to, 2, p->colours565[i]);
    }
    p->other.colours = NULL;
    p->other.colours565 = NULL;
}

static void copy_mesh(pair *p, const glint_mesh *mesh) {
    p->plain = *mesh;
    p->layout = (glint_mesh_layout){0};
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        memcpy(p->positions[i], mesh->positions[i], sizeof p->positions[0]);
        memcpy(p->normals[i], mesh->normals[i], sizeof p->normals[0]);
        if (mesh->colours)
            memcpy(p->colours[i], mesh->colours[i], sizeof p->colours[0]);
        if (mesh->colours565)
            p->colours565[i] = mesh->colours565[i];
    }
    memcpy(p->triangles, mesh->triangles, mesh->triangle_count * sizeof p->triangles[0]);
    p->plain.positions = (const int16_t(*)[3])p->positions;
    p->plain.normals = (const int16_t(*)[3])p->normals;
    p->plain.triangles = (const uint16_t(*)[3])p->triangles;
    p->plain.colours = mesh->colours ? (const uint8_t(*)[3])p->colours : NULL;
    p->plain.colours565 = mesh->colours565 ? p->colours565 : NULL;
}

/* Both meshes of a pair, of a mesh and a variant. @return 0 where the variant does not fit the mesh */
static int make_pair(pair *p, const glint_mesh *mesh, const variant *v) {
    if (v->triangles == &glint_attribute_uint8 && mesh->vertex_count > 256)
        return 0;
    copy_mesh(p, mesh);
    p->other = p->plain;
    p->other.layout = &p->layout;
    if (v->positions)
        lay_positions(p, v);
    if (v->normals)
        lay_normals(p, v);
    if (v->triangles)
        lay_triangles(p, v);
    if ((v->colours == &glint_attribute_rgb888 && mesh->colours) ||
        (v->colours == &glint_attribute_rgb565 && mesh->colours565))
        lay_colours(p, v);
    return 1;
}

/* ---- Frames ---- */

static uint8_t arena[1 << 20];

typedef struct frame {
    picture image;
    glint_status status;
    glint_stats stats;
} frame;

static void draw(frame *f, const glint_scene *scene, size_t arena_size, uint16_t tile, const glint_rectangle *region) {
    picture_options options = {.tile_width = tile, .tile_height = tile, .arena_size = arena_size};
    memset(f->image.bytes, 0x5a, f->image.size);
    if (region)
        options.region = *region;
    f->status = picture_render(&f->image, scene, &options, &f->stats);
}

/* The scene with other meshes; `pairs` are made of a variant. @return how many of its meshes that fits */
static int lay_scene(test_scene *scene, pair *pairs, const variant *v) {
    int count = 0;
    for (uint32_t i = 0; i < scene->scene.object_count; i++) {
        if (!make_pair(&pairs[i], scene->objects[i].mesh, v))
            continue;
        scene->objects[i].mesh = &pairs[i].plain;
        count++;
    }
    return count;
}

static void use_other(test_scene *scene, pair *pairs) {
    for (uint32_t i = 0; i < scene->scene.object_count; i++)
        if (scene->objects[i].mesh == &pairs[i].plain)
            scene->objects[i].mesh = &pairs[i].other;
}

static void use_plain(test_scene *scene, pair *pairs) {
    for (uint32_t i = 0; i < scene->scene.object_count; i++)
        if (scene->objects[i].mesh == &pairs[i].other)
            scene->objects[i].mesh = &pairs[i].plain;
}

static frame first, second;
static pair pairs[SCENE_OBJECTS_MAX];
static uint32_t compared;

static void open_frames(void) {
    first.image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
    second.image = picture_open(WIDTH, HEIGHT, &glint_format_rgb565);
}

static void close_frames(void) {
    picture_close(&first.image);
    picture_close(&second.image);
}

static void report(const char *scene, const variant *v) {
    printf("  %s, %s\n", scene, v->name);
}

/* Draws both, and holds one against the other. */
static int compare(test_scene *scene, size_t arena_size, uint16_t tile, const glint_rectangle *region) {
    use_plain(scene, pairs);
    draw(&first, &scene->scene, arena_size, tile, region);
    use_other(scene, pairs);
    draw(&second, &scene->scene, arena_size, tile, region);
    compared++;
    return CHECK_EQUAL(first.status, GLINT_OK) & CHECK_EQUAL(second.status, GLINT_OK) &
           CHECK(picture_equal(&first.image, &second.image));
}

/* What triangles take beyond, where they are decoded: up to 8 bytes to align each list. */
static size_t bytes_beyond(const test_scene *scene) {
    size_t bytes = 0;
    for (uint32_t i = 0; i < scene->scene.object_count; i++)
        if (!scene->objects[i].mesh->triangles)
            bytes += scene->objects[i].mesh->triangle_count * 6 + 8;
    return bytes;
}

static void check_need(test_scene *scene) {
    use_plain(scene, pairs);
    const glint_need plain = picture_need(&first.image, &scene->scene, NULL);
    use_other(scene, pairs);
    const glint_need other = picture_need(&first.image, &scene->scene, NULL);
    CHECK_EQUAL(other.least, plain.least);
    CHECK(other.resident >= plain.resident && other.resident <= plain.resident + bytes_beyond(scene));
    CHECK(other.one_pass >= plain.one_pass && other.one_pass <= plain.one_pass + bytes_beyond(scene));
    draw(&second, &scene->scene, other.one_pass, 0, NULL);
    CHECK_EQUAL(second.stats.passes, 1);
    CHECK(second.stats.arena_used <= other.one_pass);
}

static void compare_all(test_scene *scene, const char *name, const variant *v) {
    static const glint_rectangle region = {40, 24, 61, 37};
    if (!lay_scene(scene, pairs, v))
        return;
    int same = compare(scene, sizeof arena, 0, NULL);
    const glint_need need = picture_need(&second.image, &scene->scene, NULL);
    same &= compare(scene, need.least, 0, NULL);
    same &= compare(scene, (need.least + need.resident) / 2, 16, NULL);
    same &= compare(scene, need.resident, 0, NULL);
    same &= compare(scene, sizeof arena, 8, &region);
    if (!same)
        report(name, v);
    check_need(scene);
}

static void every_scene_is_the_same(void) {
    open_frames();
    for (unsigned v = 0; v < TEST_COUNT(variants); v++) {
        for (unsigned i = 0; i < scene_count + surface_count; i++) {
            const scene_definition *of =
                i < scene_count ? &scene_definitions[i] : &surface_definitions[i - scene_count];
            static test_scene scene;
            scene_build(&scene, of);
            compare_all(&scene, of->name, &variants[v]);
        }
    }
    close_frames();
    CHECK(compared > 800);
}

static void every_evaluation_is_the_same(void) {
    static const char *const names[] = {"mirrored", "near plane, double-sided", "eight lights"};
    open_frames();
    for (unsigned v = 0; v < TEST_COUNT(variants); v++) {
        for (unsigned i = 0; i < TEST_COUNT(names) * TEST_COUNT(scene_evaluations); i++) {
            static test_scene scene;
            scene_build_named(&scene, names[i / TEST_COUNT(scene_evaluations)]);
            scene_evaluate(&scene, scene_evaluations[i % TEST_COUNT(scene_evaluations)]);
            compare_all(&scene, names[i / TEST_COUNT(scene_evaluations)], &variants[v]);
        }
    }
    close_frames();
}

/* Before each triangle two of a line, which name a vertex twice. */
static void add_lines(glint_mesh *mesh, uint16_t (*triangles)[3]) {
    CHECK_AT_MOST(3 * mesh->triangle_count, TRIANGLES_MAX);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const uint16_t *const corners = mesh->triangles[i];
        const uint16_t lines[3][3] = {{corners[0], corners[0], corners[1]},
                                      {corners[i % 2 ? 2 : 1], corners[i % 2 ? 1 : 2], corners[2]},
                                      {corners[0], corners[1], corners[2]}};
        memcpy(triangles[3 * i], lines, sizeof lines);
    }
    mesh->triangles = (const uint16_t(*)[3])triangles;
    mesh->triangle_count *= 3;
    mesh->clusters = NULL;
}

/* Lines are lit where they are clipped: vertices that a triangle names twice keep their own normals. */
static void lines_change_no_normal(void) {
    static uint16_t triangles[SCENE_OBJECTS_MAX][TRIANGLES_MAX][3];
    static glint_mesh meshes[SCENE_OBJECTS_MAX];
    open_frames();
    for (unsigned v = 0; v < TEST_COUNT(variants); v++) {
        for (unsigned i = 0; i < TEST_COUNT(scene_evaluations); i++) {
            static test_scene scene;
            scene_build_named(&scene, "near plane, double-sided");
            scene_evaluate(&scene, scene_evaluations[i]);
            for (uint32_t j = 0; j < scene.scene.object_count; j++) {
                meshes[j] = *scene.objects[j].mesh;
                add_lines(&meshes[j], triangles[j]);
                scene.objects[j].mesh = &meshes[j];
            }
            compare_all(&scene, "lines at the near plane", &variants[v]);
        }
    }
    close_frames();
}

/* What is picked. */
static void picks_are_the_same(void) {
    static test_scene scene;
    uint32_t hits = 0;
    open_frames();
    for (unsigned v = 0; v < TEST_COUNT(variants); v++) {
        glint_renderer renderer;
        scene_build_named(&scene, "mirrored");
        lay_scene(&scene, pairs, &variants[v]);
        glint_config config = picture_config(&first.image, NULL);
        config.arena = arena;
        config.arena_size = sizeof arena;
        CHECK_EQUAL(glint_init(&renderer, &config), GLINT_OK);
        for (int i = 0; i < 200; i++) {
            glint_hit plain = {0, 0, 0}, other = {0, 0, 0};
            const int x = i * 37 % WIDTH, y = i * 23 % HEIGHT;
            use_plain(&scene, pairs);
            const int found = glint_pick(&renderer, &scene.scene, x, y, &plain);
            use_other(&scene, pairs);
            CHECK_EQUAL(glint_pick(&renderer, &scene.scene, x, y, &other), found);
            CHECK(plain.object == other.object && plain.triangle == other.triangle && plain.depth == other.depth);
            hits += found > 0;
        }
    }
    close_frames();
    CHECK(hits > 100);
}

/* Lines along edges. */
static void edges_are_the_same(void) {
    static test_scene scene;
    static glint_line plain[8192], other[8192];
    for (unsigned v = 0; v < TEST_COUNT(variants); v++) {
        scene_build_named(&scene, "mirrored");
        if (!lay_scene(&scene, pairs, &variants[v]))
            continue;
        const uint32_t count = glint_lines_edges(plain, 8192, &pairs[0].plain, (glint_colour){0, 0, 0});
        CHECK(count > 100);
        CHECK_EQUAL(glint_lines_edges(other, 8192, &pairs[0].other, (glint_colour){0, 0, 0}), count);
        CHECK(!memcmp(plain, other, count * sizeof plain[0]));
    }
}

/* ---- Normals ---- */

#define GRID 64

/* The direction that a code stands for, exactly. */
static void unfold(int x, int y, int one, int scale, int16_t normal[3]) {
    const int a = x < -one ? -one : x, b = y < -one ? -one : y, z = one - abs(a) - abs(b);
    normal[0] = (int16_t)(scale * (z < 0 ? (one - abs(b)) * (a < 0 ? -1 : 1) : a));
    normal[1] = (int16_t)(scale * (z < 0 ? (one - abs(a)) * (b < 0 ? -1 : 1) : b));
    normal[2] = (int16_t)(scale * z);
}

/* A grid across the screen, a normal at each of its points: the i-th code from `first` on, in steps. */
static void make_grid(pair *p, int is_small, uint32_t code, uint32_t step) {
    *p = (pair){.layout = {.normals = {is_small ? &glint_attribute_octahedral8 : &glint_attribute_octahedral16,
                                       p->apart[1], 0}}};
    for (uint32_t i = 0; i < GRID * GRID; i++, code += step) {
        const int x = is_small ? (int8_t)(code >> 8) : (int16_t)(code >> 16),
                  y = is_small ? (int8_t)code : (int16_t)code;
        const uint32_t size = is_small ? 1 : 2;
        p->positions[i][0] = (int16_t)((int)(i % GRID) * 1024 - 32256);
        p->positions[i][1] = (int16_t)((int)(i / GRID) * 1024 - 32256);
        unfold(x, y, is_small ? 127 : 32767, is_small ? 258 : 1, p->normals[i]);
        put(&p->apart[1][0][0] + 2 * size * i, size, x);
        put(&p->apart[1][0][0] + 2 * size * i + size, size, y);
        if (i % GRID < GRID - 1 && i / GRID < GRID - 1) {
            const uint16_t a = (uint16_t)i, corners[2][3] = {{a, (uint16_t)(a + 1), (uint16_t)(a + GRID + 1)},
                                                             {a, (uint16_t)(a + GRID + 1), (uint16_t)(a + GRID)}};
            memcpy(p->triangles[p->plain.triangle_count], corners, sizeof corners);
            p->plain.triangle_count += 2;
        }
    }
    p->plain.vertex_count = GRID * GRID;
    p->plain.extent = (glint_vector){GLINT_ONE, GLINT_ONE, GLINT_ONE};
    p->plain.positions = (const int16_t(*)[3])p->positions;
    p->plain.normals = (const int16_t(*)[3])p->normals;
    p->plain.triangles = (const uint16_t(*)[3])p->triangles;
    p->other = p->plain;
    p->other.normals = NULL;
    p->other.layout = &p->layout;
}

/* All codes of 8 bits, and some of 16, each at a vertex: lit there they show what their directions do. */
static void octahedra_are_unfolded_exactly(void) {
    static test_scene scene;
    scene_build_named(&scene, "mirrored");
    first.image = picture_open(2 * GRID, 2 * GRID, &glint_format_rgb888);
    second.image = picture_open(2 * GRID, 2 * GRID, &glint_format_rgb888);
    scene.scene.object_count = 1;
    scene.scene.camera.projection = &glint_orthographic;
    scene.scene.camera.view_height = 2 * GLINT_ONE;
    scene.objects[0].mesh = &pairs[0].plain;
    scene.objects[0].evaluation = &glint_per_vertex;
    scene.objects[0].pose = scene.scene.camera.pose;
    scene.objects[0].pose.m[2][3] -= 5 * GLINT_ONE;
    for (uint32_t i = 0; i < 48; i++) {
        make_grid(&pairs[0], i < 16, i < 16 ? i * GRID * GRID : i * 0x08000001u, i < 16 ? 1 : 0x000a2cb7u);
        CHECK(compare(&scene, sizeof arena, 0, NULL));
        const uint8_t *const bytes = first.image.bytes;
        CHECK(memcmp(bytes, bytes + first.image.size / 2, first.image.size / 2) != 0);
    }
    close_frames();
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(every_scene_is_the_same), TEST_CASE(every_evaluation_is_the_same),
        TEST_CASE(lines_change_no_normal),  TEST_CASE(picks_are_the_same),
        TEST_CASE(edges_are_the_same),      TEST_CASE(octahedra_are_unfolded_exactly),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
