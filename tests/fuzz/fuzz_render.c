/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer target: bytes become a scene and a configuration: half of them any values, half what users draw. The
 * sanitizers watch the library; the target itself ends the program when a frame does not send every pixel once, when
 * the arena that glint_arena_need asks for does not suffice, or when other tiles, another arena, a renderer that keeps
 * its arena or one that sends changes alone give another image; and when a scene with spoilt numbers and pointers is
 * not refused by a named error, or changes the next frame.
 */
#include "drawing.h"
#include "every_format.h"
#include "glint_extras.h"

#include <stddef.h>
#include <string.h>

#define PIXELS_MAX 8192

/* Bytes that choose how a scene is drawn. */
#define CHOICES 8

/* ---- Screen -------------------------------------------------------------------------------------------------- */

typedef struct screen {
    const glint_config *config;
    uint8_t *bytes;
    uint8_t *sent;
    uint32_t calls, fail_at;
    int sending;
} screen;

/* A row of a tile out of its page: kept as the other format of 1 bit is. */
static void put_paged_row(screen *to, int x, int y, int width, const uint8_t *page) {
    uint8_t *row = to->bytes + (size_t)y * glint_row_bytes(to->config->format, to->config->width);
    for (int column = 0; column < width; column++) {
        uint8_t *eight = &row[(x + column) / 8];
        const int bit = (x + column) % 8;
        *eight = (uint8_t)((*eight & ~(1 << bit)) | (page[column] >> y % 8 & 1) << bit);
    }
}

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    screen *to = context;
    size_t row_bytes = glint_row_bytes(to->config->format, to->config->width);
    size_t left = glint_row_bytes(to->config->format, (uint32_t)x);
    require(!to->sending && x >= 0 && y >= 0 && width > 0 && height > 0);
    require(x + width <= to->config->width && y + height <= to->config->height);
    for (int row = 0; row < height; row++) {
        if (format_is_paged(to->config->format))
            put_paged_row(to, x, y + row, width, (const uint8_t *)pixels + (size_t)(row & -8) * stride);
        else
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

/* Sends before it returns. */
static int begin_and_end(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const int failed = begin(context, x, y, width, height, pixels, stride);
    ((screen *)context)->sending = 0;
    return failed;
}

static void open_screen(screen *to, const glint_config *config) {
    memset(to, 0, sizeof *to);
    to->config = config;
    to->bytes = calloc(glint_row_bytes(config->format, config->width) + 1u, (size_t)config->height + 1u);
    to->sent = calloc((size_t)config->width + 1u, (size_t)config->height + 1u);
    to->fail_at = UINT32_MAX;
    require(to->bytes != NULL && to->sent != NULL);
}

/* Was every pixel sent? */
static void require_complete(const screen *from) {
    const size_t count = (size_t)from->config->width * from->config->height;
    require(!from->sending && memchr(from->sent, 0, count) == NULL);
}

static void close_screen(screen *to) {
    free(to->bytes);
    free(to->sent);
}

/* ---- Configuration ------------------------------------------------------------------------------------------- */

/* Null, or tables of any values, of exactly their size. */
static const uint16_t (*take_gamma(source *s, uint32_t odds))[GLINT_GAMMA_ENTRIES] {
    uint16_t(*tables)[GLINT_GAMMA_ENTRIES];
    if (!one_in(s, odds))
        return NULL;
    uint32_t state = take(s, 1);
    tables = allocate(3 * sizeof *tables);
    for (int i = 0; i < 3 * GLINT_GAMMA_ENTRIES; i++)
        tables[i / GLINT_GAMMA_ENTRIES][i % GLINT_GAMMA_ENTRIES] = (uint16_t)next_random(&state);
    return (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables;
}

/* Any, wrong ones included; but for the number of pixels. */
static void take_any_config(source *s, glint_config *config) {
    static const uint16_t tiles[16] = {8, 0, 16, 32, 64, 8, 16, 24, 8, 8, 8, 8, 16, 32, 64, 8};
    config->width = (uint16_t)(one_in(s, 8) ? take(s, 2) : 1 + below(s, 128));
    config->height = (uint16_t)(one_in(s, 8) ? take(s, 2) : 1 + below(s, 128));
    if (config->width > 0 && config->height > PIXELS_MAX / config->width)
        config->height = (uint16_t)(PIXELS_MAX / config->width);
    config->tile_width = tiles[below(s, 16)];
    config->tile_height = tiles[below(s, 16)];
    const uint32_t choice = below(s, 32);
    config->format = every_format[choice % FORMAT_COUNT];
    config->skips_degenerate = (uint8_t)(choice / 16);
    config->gamma = take_gamma(s, 4);
}

/* Half of them in the formats that are lit fast. */
static void take_usual_config(source *s, glint_config *config) {
    static const uint16_t tiles[5] = {0, 8, 16, 32, 64};
    config->width = (uint16_t)(8 + below(s, 120));
    config->height = (uint16_t)(8 + below(s, 56));
    config->tile_width = tiles[below(s, 5)];
    config->tile_height = tiles[below(s, 5)];
    config->format = every_format[below(s, 2) ? below(s, FORMAT_COUNT) : below(s, 2)];
    config->gamma = take_gamma(s, 16);
}

/* ---- Frame --------------------------------------------------------------------------------------------------- */

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
    if (status == GLINT_OK)
        require_complete(to);
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

/* The scene without its first object, under another light. */
static glint_scene other_scene(const glint_scene *scene) {
    glint_scene other = *scene;
    other.ambient.g /= 2;
    if (scene->object_count) {
        other.objects++;
        other.object_count--;
    }
    return other;
}

/* By a renderer that keeps its arena, after a frame of another scene and after the same frame. */
static void draw_kept(const glint_config *wanted_config, const glint_scene *scene, size_t size, const screen *wanted) {
    const glint_scene other = other_scene(scene);
    glint_config config = *wanted_config;
    glint_renderer renderer;
    config.arena = allocate(size);
    config.arena_size = size;
    config.keeps_arena = 1;
    require(glint_init(&renderer, &config) == GLINT_OK);
    for (int frame = 0; frame < 3; frame++) {
        screen got;
        open_screen(&got, wanted_config);
        renderer.config.flush.context = &got;
        const glint_status status = glint_render(&renderer, frame ? scene : &other);
        require(status == GLINT_OK || (!frame && status == GLINT_ERROR_ARENA));
        if (frame) {
            require_complete(&got);
            require_same(wanted, &got);
        }
        close_screen(&got);
    }
    free(config.arena);
}

/*
 * On a screen that is sent changes alone, after a frame of another scene; once more nothing changes. After a region of
 * the other scene the frame becomes whole again.
 */
static void draw_changes(source *s, const glint_config *wanted_config, const glint_scene *scene, size_t size,
                         const screen *wanted) {
    const glint_rectangle part = {(int16_t)(8 * below(s, 2)), (int16_t)(8 * below(s, 2)), 8, 8};
    const glint_scene other = other_scene(scene);
    glint_config config = *wanted_config;
    glint_renderer renderer;
    glint_change_filter changes;
    screen got;
    open_screen(&got, wanted_config);
    config.flush.context = &got;
    if (below(s, 2))
        config.flush = (glint_flush){.begin = begin_and_end, .context = &got};
    glint_tile_signature *signatures = allocate(glint_tile_signature_count(&config) * sizeof *signatures);
    require(glint_change_filter_init(&changes, signatures, &config) == GLINT_OK);
    config.flush = glint_change_filter_flush(&changes);
    config.arena = allocate(size);
    config.arena_size = size;
    require(glint_init(&renderer, &config) == GLINT_OK);
    (void)glint_render(&renderer, &other);
    for (int frame = 0; frame < 3; frame++) {
        const uint32_t calls = got.calls;
        memset(got.sent, 0, (size_t)config.width * config.height);
        require(glint_render(&renderer, scene) == GLINT_OK && !got.sending);
        require(frame != 1 || got.calls == calls);
        require_same(wanted, &got);
        memset(got.sent, 0, (size_t)config.width * config.height);
        if (frame == 1)
            (void)glint_render_region(&renderer, &other, &part);
    }
    free(config.arena);
    free(signatures);
    close_screen(&got);
}

/* With the least arena, and pixels apart from it, in just as much memory as they need. */
static void draw_apart(const glint_config *wanted_config, const glint_scene *scene, const screen *wanted) {
    glint_config config = *wanted_config;
    glint_need need;
    config.pixels_size = glint_pixels_need(&config);
    config.pixels = allocate(config.pixels_size);
    require(glint_arena_need(&config, scene, &need) == GLINT_OK);
    draw_with_arena(&config, scene, need.least, 0, wanted);
    free(config.pixels);
}

/* In tiles of another size, with the arena that takes one pass. */
static void draw_with_other_tiles(const glint_config *config, const glint_scene *scene, const screen *wanted) {
    glint_config other = *config;
    glint_need need;
    other.tile_width = config->tile_width == 16 ? 64 : 16;
    other.tile_height = config->tile_height == 8 ? 32 : 8;
    require(glint_arena_need(&other, scene, &need) == GLINT_OK);
    draw_with_arena(&other, scene, need.one_pass, 0, wanted);
}

/* Tile by tile, each from where its rectangle says. */
static void draw_tiles(const glint_config *wanted_config, const glint_scene *scene, size_t size, const screen *wanted) {
    glint_config config = *wanted_config;
    glint_frame frame;
    glint_workspace workspace;
    screen got;
    int status;
    open_screen(&got, wanted_config);
    config.arena = allocate(size);
    config.arena_size = size;
    void *memory = allocate(glint_workspace_size(&config));
    glint_workspace_init(&workspace, &config, memory);
    require(glint_frame_begin(&frame, &config, scene) == GLINT_OK);
    while ((status = glint_frame_next_pass(&frame)) > 0)
        for (uint32_t tile = frame.tile_first; tile < frame.tile_end; tile++)
            if (glint_render_tile(&frame, &workspace, tile)) {
                int x, y, width, height;
                glint_tile_rectangle(&frame, tile, &x, &y, &width, &height);
                require(!begin_and_end(&got, x, y, width, height, workspace.pixels, workspace.stride));
            }
    require(status == 0);
    require_complete(&got);
    require_same(wanted, &got);
    close_screen(&got);
    free(memory);
    free(config.arena);
}

/* A flush that fails ends the frame, at once. */
static void draw_until_failure(const glint_config *config, const glint_scene *scene, size_t size, uint32_t fail_at) {
    screen cut;
    open_screen(&cut, config);
    cut.fail_at = fail_at;
    require(draw(config, scene, size, 0, &cut) == GLINT_ERROR_FLUSH && cut.calls == fail_at + 1);
    close_screen(&cut);
}

/* With some arena between the least and that of one pass. */
static void draw_between(source *s, const glint_config *config, const glint_scene *scene, const glint_need *need,
                         const screen *wanted) {
    const size_t size = need->least + (need->one_pass - need->least) * take(s, 2) / 65535;
    draw_with_arena(config, scene, size, below(s, 8), wanted);
}

/* In one more way. */
static void draw_another_way(source *s, const glint_config *config, const glint_scene *scene, const glint_need *need,
                             const screen *wanted) {
    switch (below(s, 8)) {
    case 0:
        draw_kept(config, scene, need->one_pass, wanted);
        break;
    case 1:
        draw_changes(s, config, scene, need->one_pass, wanted);
        break;
    case 2:
        draw_with_other_tiles(config, scene, wanted);
        break;
    case 3:
        draw_apart(config, scene, wanted);
        break;
    case 4:
        draw_tiles(config, scene, need->one_pass, wanted);
        break;
    case 5:
        draw_until_failure(config, scene, need->one_pass, below(s, 256) % wanted->calls);
        break;
    default:
        draw_between(s, config, scene, need, wanted);
        break;
    }
}

/* In one pass, with the least arena and in one more way, which finds more in the same time than all ways for each. */
static void draw_ways(source *s, const glint_config *config, const glint_scene *scene, const glint_need *need) {
    screen wanted;
    screen refused;
    open_screen(&wanted, config);
    open_screen(&refused, config);
    require(glint_workspace_size(config) > 0 && glint_workspace_size(config) < need->least);
    require(draw(config, scene, need->one_pass, 0, &wanted) == GLINT_OK);
    require(draw(config, scene, need->least - 1, 0, &refused) == GLINT_ERROR_ARENA && refused.calls == 0);
    draw_with_arena(config, scene, need->least, below(s, 8), &wanted);
    draw_another_way(s, config, scene, need, &wanted);
    close_screen(&wanted);
    close_screen(&refused);
}

/* In one pass, and with the smallest arena: nothing but bounds is held. */
static void draw_anyhow(const glint_config *config, const glint_scene *scene, const glint_need *need) {
    for (int i = 0; i < 2; i++) {
        screen any;
        open_screen(&any, config);
        (void)draw(config, scene, i ? need->least : need->one_pass, 0, &any);
        close_screen(&any);
    }
}

/* What cannot be drawn is refused before anything is sent, and for a reason. */
static void draw_refused(const glint_config *config, const glint_scene *scene, glint_status status) {
    glint_change_filter changes;
    glint_tile_signature signature;
    screen refused;
    require(glint_tile_signature_count(config) > 0 ||
            glint_change_filter_init(&changes, &signature, config) != GLINT_OK);
    open_screen(&refused, config);
    require(draw(config, scene, 65536, 0, &refused) != GLINT_OK && refused.calls == 0);
    require(strcmp(glint_strerror(status), "unknown status") != 0);
    close_screen(&refused);
}

/* A region alone: all of its pixels, each once. */
static void draw_region(source s, glint_renderer *renderer, const glint_scene *scene) {
    const int x = (int)(below(&s, 32) * 8), y = (int)(below(&s, 32) * 8);
    const glint_rectangle region = {(int16_t)x, (int16_t)y, (int16_t)(8 + below(&s, 16) * 8),
                                    (int16_t)(8 + below(&s, 16) * 8)};
    size_t sent = 0;
    screen got;
    open_screen(&got, &renderer->config);
    renderer->config.flush.context = &got;
    if (glint_render_region(renderer, scene, &region) == GLINT_OK) {
        for (size_t i = 0; i < (size_t)renderer->config.width * renderer->config.height; i++)
            sent += got.sent[i];
        require(sent == (size_t)region.width * (size_t)region.height);
    }
    close_screen(&got);
}

/* What else can be asked of any scene. */
static void ask(source s, const glint_config *wanted, const glint_scene *scene) {
    glint_config config = *wanted;
    glint_renderer renderer;
    glint_report report;
    glint_hit hit;
    glint_screen_point place;
    glint_camera camera = scene->camera;
    screen none;
    const uint32_t chosen = take(&s, 1);
    const glint_vector point = {any(&s), any(&s), any(&s)}, at = {any(&s), any(&s), any(&s)};
    (void)glint_camera_project(&config, &camera, point, &place);
    (void)glint_camera_look_at(&camera, point, at, point);
    (void)glint_camera_look_at(&camera, point, at, (glint_vector){0, GLINT_ONE, 0});
    glint_camera_orbit(&camera, at, point.x, point.y, point.z);
    camera.pose = glint_pose_rotate(point, at.x);
    camera.pose = glint_pose_quaternion(point.x, point.y, point.z, at.x);
    open_screen(&none, wanted);
    config.flush.context = &none;
    config.arena_size = 65536;
    config.arena = allocate(config.arena_size);
    (void)glint_check(&config, scene, &report);
    require(report.sentence != NULL && none.calls == 0);
    if (glint_init(&renderer, &config) == GLINT_OK) {
        (void)glint_pick(&renderer, scene, config.width * (int)(2 * (chosen % 4) + 1) / 8, config.height / 2, &hit);
        require(none.calls == 0);
        draw_region(s, &renderer, scene);
    }
    free(config.arena);
    close_screen(&none);
}

/* ---- Cameras and lines --------------------------------------------------------------------------------------- */

/* Lines in space, some of them a box's and a mesh's edges. */
typedef struct wires {
    glint_line lines[32];
    glint_segment segments[32];
    uint32_t count;
} wires;

static int paint_wires(void *context, const glint_tile *tile) {
    const wires *const w = context;
    return glint_lines_draw(tile, w->segments, w->count);
}

/* Of magnitudes that scenes have, or any. */
static glint_vector take_point(source *s) {
    const uint32_t down = one_in(s, 4) ? 0 : 12;
    return (glint_vector){any(s) >> down, any(s) >> down, any(s) >> down};
}

/* Lines over what is drawn, or none. */
static void take_wires(source *s, glint_config *config, const drawing *d, wires *w) {
    const uint32_t kind = below(s, 4);
    const glint_colour colour = {GLINT_ONE, (glint_q16)take(s, 2), one_in(s, 16) ? any(s) : 0};
    const glint_pose pose = d->scene.object_count && below(s, 2) ? d->objects[0].pose : glint_pose_identity();
    w->count = 0;
    if (!kind)
        return;
    if (kind == 2) {
        glint_lines_box(w->lines, take_point(s), take_point(s), colour);
        w->count = 12;
    } else if (kind == 3) {
        glint_need need;
        if (d->scene.object_count && glint_arena_need(config, &d->scene, &need) == GLINT_OK)
            w->count = glint_lines_edges(w->lines, 20, d->objects[0].mesh, colour);
        w->count = w->count < 20 ? w->count : 20;
    }
    for (uint32_t more = below(s, 12); more > 0; more--)
        w->lines[w->count++] = (glint_line){take_point(s), take_point(s), colour};
    if (glint_lines_project(w->segments, config, &d->scene.camera, &pose, w->lines, w->count) == GLINT_OK)
        config->overlay = (glint_painter){paint_wires, w};
}

/* Parallel rays, now and then. */
static void take_projection(source *s, glint_camera *camera, int is_sound) {
    if (!one_in(s, 4))
        return;
    camera->projection = &glint_orthographic;
    camera->view_height = GLINT_ONE >> below(s, 8) << below(s, 8);
    if (!is_sound && one_in(s, 4))
        camera->view_height = any(s);
}

/* ---- Spoilt scenes ------------------------------------------------------------------------------------------- */

/* Sets one of the 32-bit numbers from `first` on to an extreme, to any, or one up or down. */
static void spoil_number(source *s, void *first, size_t bytes) {
    static const uint32_t extremes[] = {0, 1, 0xffffffff, 0x80000000, 0x7fffffff, 0x10000, 0xffff0000, 0x100001};
    uint8_t *const at = (uint8_t *)first + 4 * below(s, (uint32_t)(bytes / 4));
    uint32_t number;
    memcpy(&number, at, sizeof number);
    switch (below(s, 4)) {
    case 0:
        number += below(s, 2) ? 1 : 0xffffffff;
        break;
    case 1:
        number = (uint32_t)any(s);
        break;
    default:
        number = extremes[below(s, sizeof extremes / sizeof *extremes)];
        break;
    }
    memcpy(at, &number, sizeof number);
}

/* Removes what a pointer points to, or changes a count, never to more than arrays hold. */
static void spoil_structure(source *s, drawing *d, glint_mesh *mesh, glint_object *object) {
    switch (below(s, 12)) {
    case 0:
        mesh->positions = NULL;
        break;
    case 1:
        mesh->normals = NULL;
        break;
    case 2:
        mesh->triangles = NULL;
        break;
    case 3:
        mesh->layout = NULL;
        break;
    case 4:
        mesh->vertex_count = below(s, mesh->vertex_count + 1);
        break;
    case 5:
        mesh->triangle_count = below(s, mesh->triangle_count + 1);
        break;
    case 6:
        object->mesh = NULL;
        break;
    case 7:
        object->material = NULL;
        break;
    case 8:
        d->lights[0].type = NULL;
        break;
    case 9:
        d->materials[0].model = NULL;
        break;
    case 10:
        d->scene.light_count = GLINT_LIGHTS_MAX + 1 + take(s, 2);
        break;
    default:
        object->hidden ^= 1;
        break;
    }
}

static void spoil(source *s, drawing *d) {
    glint_mesh *const mesh = &d->meshes[below(s, DRAWING_MESHES)];
    glint_object *const object = &d->objects[below(s, DRAWING_OBJECTS)];
    glint_material *const material = &d->materials[below(s, DRAWING_OBJECTS)];
    glint_light *const light = &d->lights[below(s, GLINT_LIGHTS_MAX)];
    switch (below(s, 8)) {
    case 0:
        spoil_number(s, &mesh->offset, offsetof(glint_mesh, flags) + 4 - offsetof(glint_mesh, offset));
        break;
    case 1:
        spoil_number(s, &material->ambient, offsetof(glint_material, flags) + 4 - offsetof(glint_material, ambient));
        break;
    case 2:
        spoil_number(s, &light->position, offsetof(glint_light, outer) + 4 - offsetof(glint_light, position));
        break;
    case 3:
        spoil_number(s, &d->scene.camera.pose, offsetof(glint_camera, near_plane) + 4 - offsetof(glint_camera, pose));
        break;
    case 4:
        spoil_number(s, &d->scene.background, 2 * sizeof(glint_colour));
        break;
    case 5:
        spoil_number(s, &object->pose, sizeof object->pose);
        break;
    default:
        spoil_structure(s, d, mesh, object);
        break;
    }
}

/* Draws into a new screen, which the caller closes. */
static glint_status draw_with(glint_renderer *renderer, const glint_scene *scene, screen *to) {
    open_screen(to, &renderer->config);
    renderer->config.flush.context = to;
    return glint_render(renderer, scene);
}

/*
 * A scene some of whose numbers and pointers are spoilt, between two frames of the sound one by the same renderer: it
 * is drawn, or refused by the error that glint_check names before anything is sent; an answer stays as it was on an
 * error; and both sound frames are the same.
 */
static void draw_spoilt(source *s, const glint_config *wanted_config, const drawing *d) {
    drawing spoilt = *d;
    glint_config config = *wanted_config;
    glint_need need = {1, 2, 3};
    glint_renderer renderer;
    glint_report report;
    screen before, between, after;
    if (!below(s, 2))
        return;
    for (uint32_t i = 0; i < d->scene.object_count; i++) {
        spoilt.objects[i].mesh = &spoilt.meshes[d->objects[i].mesh - d->meshes];
        spoilt.objects[i].material = &spoilt.materials[d->objects[i].material - d->materials];
    }
    spoilt.scene.objects = spoilt.objects;
    spoilt.scene.lights = spoilt.lights;
    for (uint32_t count = 1 + below(s, 3); count > 0; count--)
        spoil(s, &spoilt);
    config.arena_size = 65536;
    config.arena = allocate(config.arena_size);
    if (glint_init(&renderer, &config) == GLINT_OK) {
        const glint_status first = draw_with(&renderer, &d->scene, &before);
        const glint_status told = glint_check(&config, &spoilt.scene, &report);
        const glint_status drawn = draw_with(&renderer, &spoilt.scene, &between);
        require(drawn == told && (drawn == GLINT_OK || between.calls == 0));
        require(glint_arena_need(&config, &spoilt.scene, &need) == GLINT_OK ||
                (need.least == 1 && need.resident == 2 && need.one_pass == 3));
        require(draw_with(&renderer, &d->scene, &after) == first);
        if (first == GLINT_OK && !d->is_loose)
            require_same(&before, &after);
        close_screen(&before);
        close_screen(&between);
        close_screen(&after);
    }
    free(config.arena);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    source s = {data, size};
    glint_config config = {.flush = {.begin = begin, .wait = wait}};
    glint_need need;
    drawing d;
    wires w;
    const int is_usual = take(&s, 1) & 1;
    const size_t length = s.left < CHOICES ? s.left : CHOICES;
    source choices = {s.bytes, length};
    s = (source){s.bytes + length, s.left - length};
    if (is_usual) {
        take_usual_config(&s, &config);
        take_usual_scene(&s, &d, 1);
    } else {
        take_any_config(&s, &config);
        take_any_scene(&s, &d);
    }
    take_projection(&s, &d.scene.camera, is_usual);
    take_layouts(&s, &d, is_usual);
    take_wires(&s, &config, &d, &w);
    const source asked = choices;
    const glint_status status = glint_arena_need(&config, &d.scene, &need);
    require(!is_usual || status == GLINT_OK || status == GLINT_ERROR_RANGE);
    if (status != GLINT_OK)
        draw_refused(&config, &d.scene, status);
    else if (d.is_loose)
        draw_anyhow(&config, &d.scene, &need);
    else
        draw_ways(&choices, &config, &d.scene, &need);
    ask(asked, &config, &d.scene);
    draw_spoilt(&s, &config, &d);
    free_drawing(&d);
    free((void *)(uintptr_t)config.gamma);
    return 0;
}
