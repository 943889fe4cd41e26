/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer target: bytes become a scene, any values included, and a configuration. The sanitizers watch the library;
 * the target itself ends the program when a frame does not send every pixel once, when the arena that glint_arena_need
 * asks for does not suffice, or when other tiles and another arena give another image.
 */
#include "glint.h"

#include <stdlib.h>
#include <string.h>

#define MESHES 2
#define OBJECTS 4
#define VERTICES_MAX 40
#define TRIANGLES_MAX 30
#define PIXELS_MAX 8192

/* ---- Bytes --------------------------------------------------------------------------------------------------- */

typedef struct source {
    const uint8_t *bytes;
    size_t left;
} source;

static uint32_t take(source *s, int count) {
    uint32_t value = 0;
    for (; count > 0 && s->left > 0; count--, s->left--)
        value = value << 8 | *s->bytes++;
    return value;
}

static uint32_t below(source *s, uint32_t limit) {
    return take(s, limit > 256 ? 2 : 1) % limit;
}

/* Any number, of any magnitude. */
static glint_q16 any(source *s) {
    uint32_t shift = below(s, 32);
    return (int32_t)take(s, 4) >> shift;
}

static glint_vector any_vector(source *s) {
    glint_vector vector;
    vector.x = any(s);
    vector.y = any(s);
    vector.z = any(s);
    return vector;
}

/* One time in `odds` any number, else one from 0 to `most`. */
static glint_q16 likely(source *s, uint32_t odds, glint_q16 most) {
    if (below(s, odds) == 1)
        return any(s);
    return (glint_q16)((uint64_t)take(s, 2) * (uint32_t)most / 65535);
}

static void require(int condition) {
    if (!condition)
        abort();
}

static void *allocate(size_t size) {
    void *memory = malloc(size);
    require(memory != NULL || size == 0);
    return memory;
}

/* ---- Scene --------------------------------------------------------------------------------------------------- */

typedef struct drawing {
    glint_mesh meshes[MESHES];
    glint_clusters clusters[MESHES];
    int is_loose; /* how it looks may depend on the arena */
    glint_material materials[OBJECTS];
    glint_light lights[GLINT_LIGHTS_MAX + 1];
    glint_object objects[OBJECTS];
    glint_scene scene;
} drawing;

/* A linear congruential generator (Numerical Recipes): short inputs are to make whole meshes too. */
static uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* All of int16, or a few values of it, which makes degenerate triangles and ties. */
static int16_t (*take_triples(source *s, uint32_t count))[3] {
    static const int16_t few[8] = {-32768, -16384, -1, 0, 1, 8192, 16384, 32767};
    int16_t(*triples)[3] = allocate(count * sizeof *triples);
    int coarse = below(s, 4) == 1;
    uint32_t state = take(s, 3);
    for (uint32_t i = 0; i < count * 3; i++) {
        uint32_t bits = next_random(&state);
        triples[i / 3][i % 3] = coarse ? few[bits % 8] : (int16_t)bits;
    }
    return triples;
}

static uint16_t (*take_triangles(source *s, uint32_t count, uint32_t vertices))[3] {
    uint16_t(*triangles)[3] = allocate(count * sizeof *triangles);
    uint32_t state = take(s, 3);
    for (uint32_t i = 0; i < count * 3; i++)
        triangles[i / 3][i % 3] = (uint16_t)(next_random(&state) % vertices);
    if (below(s, 16) == 1) {
        uint16_t index = (uint16_t)take(s, 2);
        uint32_t triangle = below(s, count);
        triangles[triangle][below(s, 3)] = index;
    }
    return triangles;
}

/* None, 24 bits, 16 bits, or both. */
static void take_mesh_colours(source *s, glint_mesh *mesh) {
    uint32_t choice = below(s, 6);
    uint32_t state = take(s, 2);
    uint8_t(*colours)[3] = allocate(mesh->vertex_count * sizeof *colours);
    uint16_t *colours565 = allocate(mesh->vertex_count * sizeof *colours565);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        for (int c = 0; c < 3; c++)
            colours[i][c] = (uint8_t)next_random(&state);
        colours565[i] = (uint16_t)next_random(&state);
    }
    if (choice == 1 || choice == 3)
        mesh->colours = (const uint8_t(*)[3])colours;
    else
        free(colours);
    if (choice == 2 || choice == 3)
        mesh->colours565 = colours565;
    else
        free(colours565);
}

/* Arrays of exactly the size that the mesh states, so that reading past them is seen. */
static void take_mesh(source *s, glint_mesh *mesh) {
    mesh->vertex_count = 1 + below(s, VERTICES_MAX);
    mesh->triangle_count = 1 + below(s, TRIANGLES_MAX);
    mesh->positions = (const int16_t(*)[3])take_triples(s, mesh->vertex_count);
    mesh->normals = (const int16_t(*)[3])take_triples(s, mesh->vertex_count);
    mesh->triangles = (const uint16_t(*)[3])take_triangles(s, mesh->triangle_count, mesh->vertex_count);
    mesh->extent.x = likely(s, 8, 4 * GLINT_ONE);
    mesh->extent.y = likely(s, 8, 4 * GLINT_ONE);
    mesh->extent.z = likely(s, 8, 4 * GLINT_ONE);
    if (below(s, 4) == 1)
        mesh->offset = any_vector(s);
    mesh->flags = below(s, 2);
    take_mesh_colours(s, mesh);
}

/* A part of what is left, the last time all of it; now and then something else. */
static uint16_t take_part(source *s, uint32_t *left, int last) {
    const uint32_t part = last ? *left : below(s, *left + 1);
    *left -= part;
    return (uint16_t)(below(s, 64) == 1 ? take(s, 2) : part);
}

/*
 * Clusters of nothing that belongs together: any of them may be dropped. @return 1 where some may look at vertices of
 * others unsaid: which are then drawn, and where, is not told
 */
static int take_clusters(source *s, glint_mesh *mesh, glint_clusters *clusters) {
    const uint32_t choice = below(s, 4);
    const int is_loose = choice == 1;
    if (choice == 0)
        return 0;
    uint32_t triangles = mesh->triangle_count, vertices = mesh->vertex_count, borrower_count = 0;
    clusters->cull = &glint_cull_cones;
    clusters->count = 1 + below(s, 5);
    glint_cluster *list = allocate(clusters->count * sizeof *list);
    for (uint32_t i = 0; i < clusters->count; i++) {
        for (int j = 0; j < 3; j++)
            list[i].axis[j] = (int8_t)take(s, 1);
        list[i].spread = (uint8_t)take(s, 1);
        list[i].spread = (uint8_t)(list[i].spread >> below(s, 8));
        list[i].height = (int16_t)take(s, 2);
        list[i].triangles = take_part(s, &triangles, i + 1 == clusters->count);
        list[i].vertices = take_part(s, &vertices, i + 1 == clusters->count);
        list[i].borrowers = (uint16_t)(is_loose ? below(s, 4) : clusters->count);
        borrower_count += list[i].borrowers;
    }
    uint16_t *borrowers = allocate(borrower_count * sizeof *borrowers);
    for (uint32_t i = 0; i < borrower_count; i++)
        borrowers[i] = (uint16_t)(!is_loose          ? i % clusters->count
                                  : below(s, 8) == 1 ? take(s, 2)
                                                     : below(s, clusters->count));
    clusters->list = list;
    clusters->borrowers = borrowers;
    mesh->clusters = clusters;
    return is_loose;
}

static glint_pose take_pose(source *s) {
    glint_pose pose;
    if (below(s, 8) == 1) {
        for (int i = 0; i < 12; i++)
            pose.m[i / 4][i % 4] = any(s);
        return pose;
    }
    glint_q16 width = likely(s, 4, 2 * GLINT_ONE);
    glint_pose scaling = glint_pose_scale(width, likely(s, 4, 2 * GLINT_ONE), GLINT_ONE);
    glint_pose x = glint_pose_rotate_x(any(s));
    glint_pose y = glint_pose_rotate_y(any(s));
    glint_pose z = glint_pose_rotate_z(any(s));
    pose = glint_pose_then(&scaling, &x);
    pose = glint_pose_then(&pose, &y);
    pose = glint_pose_then(&pose, &z);
    pose.m[0][3] = any(s) / 16;
    pose.m[1][3] = any(s) / 16;
    pose.m[2][3] = -likely(s, 4, 8 * GLINT_ONE);
    return pose;
}

static glint_colour take_colour(source *s) {
    glint_colour colour;
    glint_q16 most = below(s, 8) == 1 ? GLINT_COLOUR_MAX : GLINT_ONE;
    colour.r = likely(s, 64, most);
    colour.g = likely(s, 64, most);
    colour.b = likely(s, 64, most);
    return colour;
}

static void take_camera(source *s, glint_camera *camera) {
    camera->pose = glint_pose_identity();
    if (below(s, 4) == 1) {
        glint_vector eye = any_vector(s);
        glint_vector at = any_vector(s);
        glint_camera_look_at(camera, eye, at, any_vector(s));
    }
    if (below(s, 32) == 1)
        camera->pose = take_pose(s);
    camera->field_of_view = likely(s, 16, 169 * GLINT_ONE) | GLINT_ONE;
    camera->near_plane = likely(s, 8, GLINT_ONE) | 1;
}

/* What lamps have beside the rest: mostly sound, so that frames are drawn. */
static void take_lamp(source *s, glint_light *light) {
    static const glint_light_type *const types[4] = {&glint_light_directional, &glint_light_point, &glint_light_spot,
                                                     &glint_light_point};
    light->type = types[below(s, 4)];
    if (light->type == &glint_light_directional)
        return;
    light->linear = likely(s, 32, GLINT_ONE);
    light->quadratic = likely(s, 32, GLINT_ONE);
    light->axis = any_vector(s);
    light->outer = likely(s, 32, 180 * GLINT_ONE);
    light->inner = below(s, 4) == 1 ? light->outer : likely(s, 32, light->outer < 0 ? 0 : light->outer);
}

static void take_lights(source *s, drawing *d) {
    d->scene.light_count = below(s, 32) == 1 ? GLINT_LIGHTS_MAX + 1 : below(s, GLINT_LIGHTS_MAX + 1);
    for (uint32_t i = 0; i < d->scene.light_count; i++) {
        take_lamp(s, &d->lights[i]);
        d->lights[i].vector = any_vector(s);
        d->lights[i].diffuse = take_colour(s);
        d->lights[i].specular = take_colour(s);
    }
    d->scene.lights = d->lights;
}

static void take_objects(source *s, drawing *d) {
    static const glint_model *const models[4] = {&glint_model_blinn_phong, &glint_model_phong, &glint_model_lambert,
                                                 &glint_model_unlit};
    const glint_evaluation *const evaluations[4] = {NULL, &glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    d->scene.object_count = below(s, OBJECTS + 1);
    for (uint32_t i = 0; i < d->scene.object_count; i++) {
        d->materials[i].model = models[below(s, 4)];
        d->materials[i].flags = below(s, 32) == 1 ? take(s, 4) : below(s, 4);
        d->materials[i].ambient = take_colour(s);
        d->materials[i].diffuse = take_colour(s);
        d->materials[i].specular = take_colour(s);
        d->materials[i].shininess = likely(s, 4, 64 * GLINT_ONE);
        d->objects[i].mesh = &d->meshes[below(s, MESHES)];
        d->objects[i].material = &d->materials[below(s, i + 1)];
        d->objects[i].evaluation = evaluations[below(s, 4)];
        d->objects[i].pose = take_pose(s);
    }
    d->scene.objects = d->objects;
}

static void take_drawing(source *s, drawing *d) {
    memset(d, 0, sizeof *d);
    take_camera(s, &d->scene.camera);
    d->scene.viewer = (glint_viewer)(below(s, 64) == 1 ? 2 : below(s, 2));
    d->scene.error_budget = below(s, 64) == 1 ? any(s) : (int32_t)below(s, GLINT_BUDGET_MAX + 1);
    d->scene.background = take_colour(s);
    d->scene.ambient = take_colour(s);
    for (int i = 0; i < MESHES; i++)
        take_mesh(s, &d->meshes[i]);
    take_objects(s, d);
    take_lights(s, d);
    for (int i = 0; i < MESHES; i++) /* last, so that inputs from before stay what they were */
        d->is_loose |= take_clusters(s, &d->meshes[i], &d->clusters[i]);
}

static void free_drawing(drawing *d) {
    for (int i = 0; i < MESHES; i++) {
        free((void *)(uintptr_t)d->meshes[i].positions);
        free((void *)(uintptr_t)d->meshes[i].normals);
        free((void *)(uintptr_t)d->meshes[i].triangles);
        free((void *)(uintptr_t)d->meshes[i].colours);
        free((void *)(uintptr_t)d->meshes[i].colours565);
        free((void *)(uintptr_t)d->clusters[i].list);
        free((void *)(uintptr_t)d->clusters[i].borrowers);
    }
}

/* ---- Frame --------------------------------------------------------------------------------------------------- */

typedef struct screen {
    const glint_config *config;
    uint8_t *bytes;
    uint8_t *sent;
    uint32_t calls, fail_at;
    int sending;
} screen;

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    screen *to = context;
    size_t row_bytes = glint_row_bytes(to->config->format, to->config->width);
    size_t left = glint_row_bytes(to->config->format, (uint32_t)x);
    require(!to->sending && x >= 0 && y >= 0 && width > 0 && height > 0);
    require(x + width <= to->config->width && y + height <= to->config->height);
    for (int row = 0; row < height; row++) {
        memcpy(to->bytes + (size_t)(y + row) * row_bytes + left, (const uint8_t *)pixels + (size_t)row * stride,
               glint_row_bytes(to->config->format, (uint32_t)width));
        for (int column = 0; column < width; column++)
            require(to->sent[(size_t)(y + row) * to->config->width + (size_t)(x + column)]++ == 0);
    }
    to->sending = 1;
    return to->calls++ == to->fail_at;
}

static int wait(void *context) {
    screen *to = context;
    require(to->sending);
    to->sending = 0;
    return 0;
}

static void open_screen(screen *to, const glint_config *config) {
    memset(to, 0, sizeof *to);
    to->config = config;
    to->bytes = calloc(glint_row_bytes(config->format, config->width) + 1u, (size_t)config->height + 1u);
    to->sent = calloc((size_t)config->width + 1u, (size_t)config->height + 1u);
    to->fail_at = UINT32_MAX;
    require(to->bytes != NULL && to->sent != NULL);
}

static void close_screen(screen *to) {
    free(to->bytes);
    free(to->sent);
}

/* Null, or tables of any values, of exactly their size. */
static const uint16_t (*take_gamma(source *s))[GLINT_GAMMA_ENTRIES] {
    uint16_t(*tables)[GLINT_GAMMA_ENTRIES];
    if (below(s, 4) != 1)
        return NULL;
    uint32_t state = take(s, 1);
    tables = allocate(3 * sizeof *tables);
    for (int i = 0; i < 3 * GLINT_GAMMA_ENTRIES; i++)
        tables[i / GLINT_GAMMA_ENTRIES][i % GLINT_GAMMA_ENTRIES] = (uint16_t)next_random(&state);
    return (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables;
}

static void take_config(source *s, glint_config *config) {
    static const glint_format *const formats[14] = {&glint_format_rgb565,
                                                    &glint_format_rgb565_be,
                                                    &glint_format_rgb888,
                                                    &glint_format_grey8,
                                                    &glint_format_grey4,
                                                    &glint_format_rgb565_dithered,
                                                    &glint_format_rgb888_dithered,
                                                    &glint_format_rgb565_be_dithered,
                                                    &glint_format_grey8_dithered,
                                                    &glint_format_grey4_dithered,
                                                    &glint_format_rgb444,
                                                    &glint_format_rgb444_dithered,
                                                    &glint_format_mono,
                                                    &glint_format_mono_dithered};
    static const uint16_t tiles[16] = {8, 0, 16, 32, 64, 8, 16, 24, 8, 8, 8, 8, 16, 32, 64, 8};
    memset(config, 0, sizeof *config);
    config->width = (uint16_t)(below(s, 8) == 1 ? take(s, 2) : 1 + below(s, 128));
    config->height = (uint16_t)(below(s, 8) == 1 ? take(s, 2) : 1 + below(s, 128));
    if (config->width > 0 && config->height > PIXELS_MAX / config->width)
        config->height = (uint16_t)(PIXELS_MAX / config->width);
    config->tile_width = tiles[below(s, 16)];
    config->tile_height = tiles[below(s, 16)];
    config->format = formats[below(s, 14)];
    config->flush.begin = begin;
    config->flush.wait = wait;
    config->gamma = take_gamma(s);
}

/* Draws with exactly `size` bytes of arena at some alignment. */
static glint_status draw(const glint_config *wanted, const glint_scene *scene, size_t size, size_t skew, screen *to) {
    glint_config config = *wanted;
    glint_renderer renderer;
    uint8_t *memory = allocate(size + skew);
    config.arena = memory + skew;
    config.arena_size = size;
    config.flush.context = to;
    glint_status status = glint_init(&renderer, &config);
    if (status == GLINT_OK)
        status = glint_render(&renderer, scene);
    require(status != GLINT_OK || !to->sending);
    free(memory);
    return status;
}

static void require_same(const screen *a, const screen *b) {
    require(memcmp(a->bytes, b->bytes, glint_row_bytes(a->config->format, a->config->width) * a->config->height) == 0);
}

/* With an arena of `size` bytes the frame is `wanted`. */
static void draw_with_arena(const glint_config *config, const glint_scene *scene, size_t size, size_t skew,
                            const screen *wanted) {
    screen got;
    open_screen(&got, config);
    require(draw(config, scene, size, skew, &got) == GLINT_OK);
    require_same(wanted, &got);
    close_screen(&got);
}

/* By a renderer that keeps its arena, after a frame without the first object and after the same frame. */
static void draw_kept(const glint_config *wanted_config, const glint_scene *scene, size_t size, const screen *wanted) {
    glint_config config = *wanted_config;
    glint_scene fewer = *scene;
    glint_renderer renderer;
    screen got[3];
    config.arena = allocate(size);
    config.arena_size = size;
    config.keeps_arena = 1;
    if (scene->object_count) {
        fewer.objects++;
        fewer.object_count--;
    }
    require(glint_init(&renderer, &config) == GLINT_OK);
    for (int frame = 0; frame < 3; frame++) {
        open_screen(&got[frame], wanted_config);
        renderer.config.flush.context = &got[frame];
        const glint_status status = glint_render(&renderer, frame ? scene : &fewer);
        require(status == GLINT_OK || (!frame && status == GLINT_ERROR_ARENA));
        if (frame)
            require_same(wanted, &got[frame]);
        close_screen(&got[frame]);
    }
    free(config.arena);
}

/* In tiles of another size, with the arena that takes one pass. */
static void draw_with_other_tiles(const glint_config *config, const glint_scene *scene, const screen *wanted) {
    glint_config other = *config;
    glint_need need;
    other.tile_width = config->tile_width == 16 ? 64 : 16;
    other.tile_height = config->tile_height == 8 ? 32 : 8;
    require(glint_arena_need(&other, scene, &need) == GLINT_OK);
    draw_with_arena(&other, scene, need.best, 0, wanted);
}

/* A flush that fails ends the frame, at once. */
static void draw_until_failure(const glint_config *config, const glint_scene *scene, size_t size, uint32_t fail_at) {
    screen cut;
    open_screen(&cut, config);
    cut.fail_at = fail_at;
    require(draw(config, scene, size, 0, &cut) == GLINT_ERROR_FLUSH && cut.calls == fail_at + 1);
    close_screen(&cut);
}

static void draw_every_way(source *s, const glint_config *config, const glint_scene *scene, const glint_need *need) {
    screen wanted;
    screen refused;
    open_screen(&wanted, config);
    open_screen(&refused, config);
    require(draw(config, scene, need->best, 0, &wanted) == GLINT_OK);
    require(draw(config, scene, need->smallest - 1, 0, &refused) == GLINT_ERROR_ARENA && refused.calls == 0);
    for (uint32_t tries = below(s, 4); tries > 0; tries--) {
        size_t size = need->smallest + (need->best - need->smallest) * take(s, 2) / 65535;
        draw_with_arena(config, scene, size, below(s, 8), &wanted);
    }
    draw_with_arena(config, scene, need->smallest, below(s, 8), &wanted);
    draw_kept(config, scene, need->best, &wanted);
    draw_with_other_tiles(config, scene, &wanted);
    draw_until_failure(config, scene, need->best, below(s, 256) % wanted.calls);
    close_screen(&wanted);
    close_screen(&refused);
}

/* In one pass, and with the smallest arena: nothing but bounds is held. */
static void draw_anyhow(const glint_config *config, const glint_scene *scene, const glint_need *need) {
    for (int i = 0; i < 2; i++) {
        screen any;
        open_screen(&any, config);
        (void)draw(config, scene, i ? need->smallest : need->best, 0, &any);
        close_screen(&any);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    source s = {data, size};
    glint_config config;
    glint_need need;
    drawing d;
    take_config(&s, &config);
    source choices = s; /* read again for how to draw: needs no bytes of its own */
    take_drawing(&s, &d);
    if (glint_arena_need(&config, &d.scene, &need) == GLINT_OK) {
        if (d.is_loose)
            draw_anyhow(&config, &d.scene, &need);
        else
            draw_every_way(&choices, &config, &d.scene, &need);
    } else {
        screen refused;
        open_screen(&refused, &config);
        require(draw(&config, &d.scene, 65536, 0, &refused) != GLINT_OK && refused.calls == 0);
        close_screen(&refused);
    }
    free_drawing(&d);
    free((void *)(uintptr_t)config.gamma);
    return 0;
}
