/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer target: bytes become a scene and a configuration: half of them any values, half what users draw. The
 * sanitizers watch the library; the target itself ends the program when a frame does not send every pixel once, when
 * the arena that glint_arena_need asks for does not suffice, or when another way to draw (tests/equivalence/ways.h)
 * gives another image; and when a scene with spoilt numbers and pointers is not refused by a named error, or changes
 * the next frame.
 */
#include "drawing.h"
#include "equivalence/ways.h"
#include "every_format.h"
#include "glint_extras.h"

#include <stddef.h>
#include <string.h>

#define PIXELS_MAX 8192

/* Bytes that choose how a scene is drawn. */
#define CHOICES 8

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

/* How and where a scene is drawn. */
typedef struct screen {
    int width, height;
    const glint_format *format;
    picture_options how;
} screen;

/* With samples, now and then: on a sound screen in tiles that they can have. */
static void take_samples(source *s, screen *to, int is_sound) {
    if (!one_in(s, 4))
        return;
    to->how.samples = &glint_samples_2x2;
    if (is_sound && to->how.tile_width > 32)
        to->how.tile_width = 32;
    if (is_sound && to->how.tile_height > 32)
        to->how.tile_height = 32;
}

/* Any, wrong ones included; but for the number of pixels. */
static void take_any_screen(source *s, screen *to) {
    static const uint16_t tiles[16] = {8, 0, 16, 32, 64, 8, 16, 24, 8, 8, 8, 8, 16, 32, 64, 8};
    to->width = (int)(one_in(s, 8) ? take(s, 2) : 1 + below(s, 128));
    to->height = (int)(one_in(s, 8) ? take(s, 2) : 1 + below(s, 128));
    if (to->width > 0 && to->height > PIXELS_MAX / to->width)
        to->height = PIXELS_MAX / to->width;
    to->how.tile_width = tiles[below(s, 16)];
    to->how.tile_height = tiles[below(s, 16)];
    const uint32_t choice = below(s, 32);
    to->format = every_format[choice % FORMAT_COUNT];
    to->how.skips_degenerate = (uint8_t)(choice / 16);
    to->how.gamma = take_gamma(s, 4);
}

/* Half of them in the formats that are lit fast. */
static void take_usual_screen(source *s, screen *to) {
    static const uint16_t tiles[5] = {0, 8, 16, 32, 64};
    to->width = (int)(8 + below(s, 120));
    to->height = (int)(8 + below(s, 56));
    to->how.tile_width = tiles[below(s, 5)];
    to->how.tile_height = tiles[below(s, 5)];
    to->format = every_format[below(s, 2) ? below(s, FORMAT_COUNT) : below(s, 2)];
    to->how.gamma = take_gamma(s, 16);
}

static picture open_picture(const screen *to) {
    return picture_open(to->width, to->height, to->format);
}

/* ---- Frame --------------------------------------------------------------------------------------------------- */

/* Draws with exactly `size` bytes of arena. @return the status; every pixel was sent once where it is GLINT_OK */
static glint_status draw(const screen *to, const glint_scene *scene, size_t size, picture *image) {
    picture_options options = to->how;
    options.arena_size = size;
    const glint_status status = picture_render(image, scene, &options, NULL);
    require(status != GLINT_OK || picture_is_complete(image));
    return status;
}

/* A panel that fails at a tile. */
typedef struct failing {
    uint32_t calls, fail_at;
} failing;

static int begin_or_fail(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    failing *const to = context;
    (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return to->calls++ == to->fail_at;
}

/* A flush that fails ends the frame, at once. */
static void draw_until_failure(glint_config config, const glint_scene *scene, size_t size, uint32_t fail_at) {
    failing to = {0, fail_at};
    glint_renderer renderer;
    config.flush = (glint_flush){.begin = begin_or_fail, .context = &to};
    config.arena = allocate(size);
    config.arena_size = size;
    require(glint_init(&renderer, &config) == GLINT_OK);
    require(glint_render(&renderer, scene) == GLINT_ERROR_FLUSH && to.calls == fail_at + 1);
    free(config.arena);
}

/* In one pass, with the least arena and in one more way, which finds more in the same time than all ways for each. */
static void draw_ways(source *s, const screen *to, const glint_scene *scene, const glint_need *need) {
    picture wanted = open_picture(to), refused = open_picture(to);
    const glint_config config = picture_config(&wanted, &to->how);
    require(glint_workspace_size(&config) > 0 && glint_workspace_size(&config) < need->least);
    require(draw(to, scene, need->one_pass, &wanted) == GLINT_OK);
    require(draw(to, scene, need->least - 1, &refused) == GLINT_ERROR_ARENA && refused.calls == 0);
    require(draw(to, scene, need->least, &refused) == GLINT_OK && picture_equal(&wanted, &refused));
    const uint32_t which = below(s, way_count + 1), choice = take(s, 4);
    if (which < way_count)
        require(ways[which].draws_same(&wanted, scene, &to->how, choice));
    else
        draw_until_failure(config, scene, need->one_pass, choice % (uint32_t)wanted.calls);
    picture_close(&wanted);
    picture_close(&refused);
}

/* In one pass, and with the smallest arena: nothing but bounds is held. */
static void draw_anyhow(const screen *to, const glint_scene *scene, const glint_need *need) {
    for (int i = 0; i < 2; i++) {
        picture any = open_picture(to);
        (void)draw(to, scene, i ? need->least : need->one_pass, &any);
        picture_close(&any);
    }
}

/* What cannot be drawn is refused before anything is sent, and for a reason. */
static void draw_refused(const screen *to, const glint_scene *scene, glint_status status) {
    glint_change_filter changes;
    glint_tile_signature signature;
    picture refused = open_picture(to);
    const glint_config config = picture_config(&refused, &to->how);
    require(glint_tile_signature_count(&config) > 0 ||
            glint_change_filter_init(&changes, &signature, &config) != GLINT_OK);
    require(draw(to, scene, 65536, &refused) != GLINT_OK && refused.calls == 0);
    require(strcmp(glint_strerror(status), "unknown status") != 0);
    picture_close(&refused);
}

/* What else can be asked of any scene. */
static void ask(source s, const screen *to, const glint_scene *scene) {
    picture none = open_picture(to);
    glint_config config = picture_config(&none, &to->how);
    glint_renderer renderer;
    glint_report report;
    glint_hit hit;
    glint_screen_point place;
    glint_camera camera = scene->camera;
    const uint32_t chosen = take(&s, 1);
    const glint_vector point = {any(&s), any(&s), any(&s)}, at = {any(&s), any(&s), any(&s)};
    (void)glint_camera_project(&config, &camera, point, &place);
    (void)glint_camera_look_at(&camera, point, at, point);
    (void)glint_camera_look_at(&camera, point, at, (glint_vector){0, GLINT_ONE, 0});
    glint_camera_orbit(&camera, at, point.x, point.y, point.z);
    camera.pose = glint_pose_rotate(point, at.x);
    camera.pose = glint_pose_quaternion(point.x, point.y, point.z, at.x);
    config.arena_size = 65536;
    config.arena = allocate(config.arena_size);
    (void)glint_check(&config, scene, &report);
    require(report.sentence != NULL && none.calls == 0);
    if (glint_init(&renderer, &config) == GLINT_OK)
        (void)glint_pick(&renderer, scene, config.width * (int)(2 * (chosen % 4) + 1) / 8, config.height / 2, &hit);
    require(none.calls == 0);
    free(config.arena);
    picture_close(&none);
}

/* ---- Cameras and lines --------------------------------------------------------------------------------------- */

/* Lines in space, some of them a box's and a mesh's edges. */
typedef struct wires {
    glint_line lines[32];
    glint_segment segments[32];
    uint32_t count;
    int is_smooth;
} wires;

static int paint_wires(void *context, const glint_tile *tile) {
    const wires *const w = context;
    return w->is_smooth ? glint_lines_draw_smooth(tile, w->segments, w->count)
                        : glint_lines_draw(tile, w->segments, w->count);
}

/* Of magnitudes that scenes have, or any. */
static glint_vector take_point(source *s) {
    const uint32_t down = one_in(s, 4) ? 0 : 12;
    return (glint_vector){any(s) >> down, any(s) >> down, any(s) >> down};
}

/* Lines over what is drawn, or none. */
static void take_wires(source *s, screen *to, const drawing *d, wires *w) {
    const uint32_t kind = below(s, 4);
    const glint_colour colour = {GLINT_ONE, (glint_q16)take(s, 2), one_in(s, 16) ? any(s) : 0};
    const glint_pose pose = d->scene.object_count && below(s, 2) ? d->objects[0].pose : glint_pose_identity();
    picture unused = {.width = to->width, .height = to->height, .format = to->format};
    const glint_config config = picture_config(&unused, &to->how);
    w->count = 0;
    if (!kind)
        return;
    if (kind == 2) {
        glint_lines_box(w->lines, take_point(s), take_point(s), colour);
        w->count = 12;
    } else if (kind == 3) {
        glint_need need;
        if (d->scene.object_count && glint_arena_need(&config, &d->scene, &need) == GLINT_OK)
            w->count = glint_lines_edges(w->lines, 20, d->objects[0].mesh, colour);
        w->count = w->count < 20 ? w->count : 20;
    }
    w->is_smooth = one_in(s, 2);
    for (uint32_t more = below(s, 12); more > 0; more--)
        w->lines[w->count++] =
            (glint_line){take_point(s), take_point(s), colour, w->is_smooth ? any(s) >> below(s, 24) : 0};
    if (glint_lines_project(w->segments, &config, &d->scene.camera, &pose, w->lines, w->count) == GLINT_OK)
        to->how.overlay = (glint_painter){paint_wires, w};
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

/* The same of what an object wears: sizes only shrink. */
static void spoil_texture(source *s, glint_mesh *mesh, glint_texture *texture) {
    switch (below(s, 6)) {
    case 0:
        mesh->texture_coordinates = NULL;
        break;
    case 1:
        spoil_number(s, mesh->texture_offset, sizeof mesh->texture_offset + sizeof mesh->texture_extent);
        break;
    case 2:
        texture->texels = NULL;
        break;
    case 3:
        texture->width = (uint16_t)below(s, texture->width + 1u);
        break;
    case 4:
        texture->height = (uint16_t)below(s, texture->height + 1u);
        break;
    default:
        texture->flags = (uint16_t)take(s, 1);
        texture->key = (uint16_t)take(s, 2);
        break;
    }
}

static void spoil(source *s, drawing *d) {
    glint_mesh *const mesh = &d->meshes[below(s, DRAWING_MESHES)];
    glint_object *const object = &d->objects[below(s, DRAWING_OBJECTS)];
    glint_material *const material = &d->materials[below(s, DRAWING_OBJECTS)];
    glint_light *const light = &d->lights[below(s, GLINT_LIGHTS_MAX)];
    switch (below(s, 11)) {
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
    case 8:
        spoil_texture(s, mesh, &d->textures[below(s, DRAWING_OBJECTS)]);
        break;
    case 9:
        spoil_number(s, &material->blend, offsetof(glint_material, opacity) + 4 - offsetof(glint_material, blend));
        break;
    case 10:
        spoil_number(s, &d->fog.colour, offsetof(glint_fog, end) + 4 - offsetof(glint_fog, colour));
        break;
    default:
        spoil_structure(s, d, mesh, object);
        break;
    }
}

/*
 * A scene some of whose numbers and pointers are spoilt, between two frames of the sound one by the same renderer: it
 * is drawn, or refused by the error that glint_check names before anything is sent; an answer stays as it was on an
 * error; and both sound frames are the same.
 */
static void draw_spoilt(source *s, const screen *to, const drawing *d) {
    drawing spoilt = *d;
    glint_need need = {1, 2, 3};
    glint_renderer renderer;
    glint_report report;
    if (!below(s, 2))
        return;
    for (uint32_t i = 0; i < d->scene.object_count; i++) {
        spoilt.objects[i].mesh = &spoilt.meshes[d->objects[i].mesh - d->meshes];
        spoilt.objects[i].material = &spoilt.materials[d->objects[i].material - d->materials];
    }
    for (int i = 0; i < DRAWING_OBJECTS; i++)
        if (d->materials[i].texture)
            spoilt.materials[i].texture = &spoilt.textures[i];
    if (d->scene.fog)
        spoilt.scene.fog = &spoilt.fog;
    spoilt.scene.objects = spoilt.objects;
    spoilt.scene.lights = spoilt.lights;
    for (uint32_t count = 1 + below(s, 3); count > 0; count--)
        spoil(s, &spoilt);
    picture before = open_picture(to), between = open_picture(to), after = open_picture(to);
    glint_config config = picture_config(&before, &to->how);
    config.arena_size = 65536;
    config.arena = allocate(config.arena_size);
    if (glint_init(&renderer, &config) == GLINT_OK) {
        const glint_status first = glint_render(&renderer, &d->scene);
        const glint_status told = glint_check(&config, &spoilt.scene, &report);
        renderer.config.flush.context = &between;
        const glint_status drawn = glint_render(&renderer, &spoilt.scene);
        require(drawn == told && (drawn == GLINT_OK || between.calls == 0));
        require(glint_arena_need(&config, &spoilt.scene, &need) == GLINT_OK ||
                (need.least == 1 && need.resident == 2 && need.one_pass == 3));
        renderer.config.flush.context = &after;
        require(glint_render(&renderer, &d->scene) == first);
        require(first != GLINT_OK || d->is_loose || picture_equal(&before, &after));
    }
    free(config.arena);
    picture_close(&before);
    picture_close(&between);
    picture_close(&after);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    source s = {data, size};
    screen to = {.how.waits = 1};
    glint_need need;
    drawing d;
    wires w;
    const int is_usual = take(&s, 1) & 1;
    const size_t length = s.left < CHOICES ? s.left : CHOICES;
    source choices = {s.bytes, length};
    s = (source){s.bytes + length, s.left - length};
    if (is_usual) {
        take_usual_screen(&s, &to);
        take_usual_scene(&s, &d, 1);
    } else {
        take_any_screen(&s, &to);
        take_any_scene(&s, &d);
    }
    take_projection(&s, &d.scene.camera, is_usual);
    take_layouts(&s, &d, is_usual);
    take_wires(&s, &to, &d, &w);
    take_textures(&s, &d, is_usual);
    if (take_layers(&s, &d, is_usual))
        to.how.layers = &glint_layers;
    if (one_in(&s, 4))
        to.how.background = (glint_painter){picture_paint_pattern, (void *)(uintptr_t)to.format};
    take_samples(&s, &to, is_usual);
    picture unused = {.width = to.width, .height = to.height, .format = to.format};
    const glint_config config = picture_config(&unused, &to.how);
    const source asked = choices;
    const glint_status status = glint_arena_need(&config, &d.scene, &need);
    require(!is_usual || status == GLINT_OK || status == GLINT_ERROR_RANGE);
    if (status != GLINT_OK)
        draw_refused(&to, &d.scene, status);
    else if (d.is_loose)
        draw_anyhow(&to, &d.scene, &need);
    else
        draw_ways(&choices, &to, &d.scene, &need);
    ask(asked, &to, &d.scene);
    draw_spoilt(&s, &to, &d);
    free_drawing(&d);
    free((void *)(uintptr_t)to.how.gamma);
    return 0;
}
