/* SPDX-License-Identifier: MIT */
#include "victim.h"

#include "every_format.h"
#include "glint_extras.h"

#include <string.h>

#define ARENA_MOST (192u << 10)
#define PIXELS_MOST (2u * 64 * 64 * 3 + 256)
#define OUT_MOST 8192u
#define SIGNATURES_MOST (16384u * sizeof(glint_tile_signature))

/* What a buffer holds that only an answer may change. */
#define PATTERN 0xa5

#define NEVER 0xffffffffu

/* What every frame is compared with: a scene from the first bytes that give one. */
static drawing sound;

/* ---- Screen: every pixel of the region once, tile by tile, left to right and top to bottom ---- */

static uint32_t add_bytes(uint32_t sum, const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++)
        sum = (sum ^ bytes[i]) * 16777619u; /* FNV-1a (Fowler, Noll and Vo) */
    return sum;
}

static void add_tile(victim_screen *to, const glint_format *format, int width, int height, const uint8_t *pixels,
                     size_t stride) {
    const int is_paged = format_is_paged(format);
    const size_t row_bytes = is_paged ? (size_t)width : glint_row_bytes(format, (uint32_t)width);
    for (int row = 0; row < height; row += is_paged ? 8 : 1)
        to->sum = add_bytes(to->sum, pixels + (size_t)row * stride, row_bytes);
}

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    victim *const v = context;
    victim_screen *const to = &v->screen;
    const glint_rectangle *const region = &to->region;
    const int right = region->x + region->width;
    attack_require(!to->is_sending && width > 0 && height > 0, "calls of a flush in pairs");
    attack_require(x - to->left == to->next_x && y - to->top == to->next_y, "tiles in order");
    to->height = to->next_x == region->x ? height : to->height;
    attack_require(height == to->height, "tiles of a row equally high");
    to->next_x += width;
    attack_require(to->next_x <= right && to->next_y + height <= region->y + region->height, "tiles in the region");
    if (to->next_x == right) {
        to->next_x = region->x;
        to->next_y += height;
    }
    add_tile(to, v->drawing->config.format, width, height, pixels, stride);
    const int fails = to->calls++ == to->fail_at;
    to->is_sending = !fails && v->drawing->config.flush.wait != NULL;
    return fails;
}

static int wait(void *context) {
    victim_screen *const to = &((victim *)context)->screen;
    attack_require(to->is_sending, "calls of a flush in pairs");
    to->is_sending = 0;
    return 0;
}

static void open_screen(victim *v, const glint_config *config) {
    v->screen = (victim_screen){.region = config->region, .left = config->left, .top = config->top};
    if (!(config->region.x | config->region.y | config->region.width | config->region.height))
        v->screen.region = (glint_rectangle){0, 0, (int16_t)config->width, (int16_t)config->height};
    v->screen.next_x = v->screen.region.x;
    v->screen.next_y = v->screen.region.y;
    v->screen.fail_at = NEVER;
}

static void judge_frame(victim *v, int status) {
    const victim_screen *const of = &v->screen;
    attack_ended(status);
    attack_add(&of->sum, sizeof of->sum);
    attack_require(!of->is_sending, "a frame's last tile waited for");
    if (status == GLINT_OK)
        attack_require(of->next_y == of->region.y + of->region.height, "a complete frame");
    else if (status != GLINT_ERROR_FLUSH && status != GLINT_ERROR_PAINT)
        attack_require(of->calls == 0, "errors found before the first tile");
    attack_require(status != GLINT_ERROR_FLUSH || of->calls == of->fail_at + 1, "a frame ended by its flush");
}

static int render(victim *v, const glint_scene *scene) {
    open_screen(v, &v->drawing->config);
    return glint_render(v->drawing, scene);
}

/* ---- Buffers ---- */

static void *place_out(victim *v, source *s, size_t size) {
    void *const out = pages_place(&v->out, size, sizeof(void *), (int)below(s, 2));
    return memset(out, PATTERN, size);
}

static int are_all(const void *bytes, size_t size, uint8_t what) {
    for (size_t i = 0; i < size; i++)
        if (((const uint8_t *)bytes)[i] != what)
            return 0;
    return 1;
}

/* Padding included: what is not to be written is neither. */
static int are_same(const void *a, const void *b, size_t size) {
    return memcmp(a, b, size) == 0;
}

/* An answer is as it was on an error. */
static void judge_answer(const victim *v, int status) {
    attack_ended(status);
    if (status < 0)
        attack_require(are_all(v->out.bytes, v->out.size, PATTERN), "an answer as it was on an error");
}

static void check_canaries(const victim *v) {
    attack_require(pages_are_whole(&v->renderer) && pages_are_whole(&v->arena) && pages_are_whole(&v->pixels) &&
                       pages_are_whole(&v->out) && pages_are_whole(&v->signatures),
                   "no write outside");
}

/* Sets the renderer up as the round has it. */
static void use_sound_config(victim *v) {
    attack_require(glint_init(v->drawing, &v->config) == GLINT_OK, "a sound configuration");
}

/* ---- Rounds ---- */

void victim_open(victim *v) {
    uint8_t bytes[1024];
    uint32_t state = 1;
    glint_need need = {0};
    const glint_config config = {.width = 32, .height = 24, .format = &glint_format_rgb888};
    pages_open(&v->renderer, sizeof *v->drawing);
    pages_open(&v->arena, ARENA_MOST);
    pages_open(&v->pixels, PIXELS_MOST);
    pages_open(&v->out, OUT_MOST);
    pages_open(&v->signatures, SIGNATURES_MOST);
    v->drawing = pages_place(&v->renderer, sizeof *v->drawing, sizeof(void *), 1);
    do {
        for (size_t i = 0; i < sizeof bytes; i++)
            bytes[i] = (uint8_t)next_random(&state);
        source s = {bytes, sizeof bytes};
        free_drawing(&sound);
        take_usual_scene(&s, &sound, 1);
    } while (!sound.scene.object_count || glint_arena_need(&config, &sound.scene, &need) != GLINT_OK ||
             need.one_pass > ARENA_MOST / 4);
}

/* What a round draws with: each number is drawn in a statement of its own, as everywhere here, for the order of calls
 * in one expression is the compiler's. */
static void take_config(victim *v, source *s) {
    static const uint16_t tiles[5] = {0, 8, 16, 32, 64};
    glint_config *const config = &v->config;
    *config = (glint_config){.flush = {begin, NULL, v}};
    config->width = (uint16_t)(1 + below(s, 64));
    config->height = (uint16_t)(1 + below(s, 48));
    config->tile_width = tiles[below(s, 5)];
    config->tile_height = tiles[below(s, 5)];
    config->format = every_format[below(s, FORMAT_COUNT)];
    config->flush.wait = below(s, 2) ? wait : NULL;
    config->gamma = one_in(s, 8) ? glint_gamma_srgb : NULL; /* not written either */
    config->keeps_arena = (uint8_t)below(s, 2);
    config->skips_degenerate = (uint8_t)below(s, 2);
    config->left = (int16_t)take(s, 2);
    config->top = (int16_t)take(s, 2);
}

void victim_begin(victim *v, source *s) {
    glint_config *const config = &v->config;
    take_config(v, s);
    if (one_in(s, 4)) {
        config->pixels_size = glint_pixels_need(config);
        config->pixels = pages_place(&v->pixels, config->pixels_size, sizeof(void *), (int)below(s, 2));
    }
    config->arena_size = ARENA_MOST - take(s, 2) % (ARENA_MOST / 4);
    config->arena = pages_place(&v->arena, config->arena_size, 1, (int)below(s, 2));
    use_sound_config(v);
    attack_require(render(v, &sound.scene) == GLINT_OK, "a sound frame");
    v->wanted = v->screen.sum;
}

void victim_check(victim *v) {
    check_canaries(v);
    const int status = render(v, &sound.scene);
    judge_frame(v, status);
    attack_require(status == GLINT_OK && v->screen.sum == v->wanted, "the next sound frame");
    check_canaries(v);
}

/* ---- Attacks: frames ---- */

static void attack_render(victim *v, attack_stage *stage, source *s) {
    open_screen(v, &v->config);
    v->screen.fail_at = one_in(s, 4) ? below(s, 16) : NEVER;
    judge_frame(v, glint_render(v->drawing, one_in(s, 64) ? NULL : &stage->now->scene));
}

static glint_rectangle take_rectangle(source *s) {
    glint_rectangle to = {0, 0, 0, 0};
    int16_t *const number[4] = {&to.x, &to.y, &to.width, &to.height};
    for (int i = 0; i < 4; i++)
        *number[i] = (int16_t)(8 * (i / 2) + 8 * (int)below(s, 8));
    for (int i = 0; i < 4; i++)
        if (one_in(s, 8))
            *number[i] = (int16_t)attack_number(s, (uint32_t)*number[i]);
    return to;
}

static void attack_region(victim *v, attack_stage *stage, source *s) {
    glint_config config = v->config;
    config.region = take_rectangle(s);
    open_screen(v, &config);
    judge_frame(v, glint_render_region(v->drawing, &stage->now->scene, one_in(s, 64) ? NULL : &config.region));
}

static void spoil_sizes(glint_config *config, source *s) {
    static const uint16_t sizes[] = {0, 1, 2, 7, 9, 63, 65, 255, 1024, 1025, 0x7fff, 0x8000, 0xffff};
    uint16_t *const size[4] = {&config->width, &config->height, &config->tile_width, &config->tile_height};
    uint16_t *const one = size[below(s, 4)];
    *one = sizes[below(s, sizeof sizes / sizeof *sizes)];
}

static void spoil_config(victim *v, glint_config *config, source *s) {
    switch (below(s, 8)) {
    case 0:
        config->format = NULL;
        break;
    case 1:
        config->flush.begin = NULL;
        break;
    case 2:
        config->arena = NULL;
        break;
    case 3: /* of any size, and yet between forbidden pages */
        config->arena_size = (size_t)1 << below(s, 18);
        config->arena_size = take(s, 3) % config->arena_size;
        config->arena = pages_place(&v->arena, config->arena_size, 1, (int)below(s, 2));
        break;
    case 4:
        config->pixels_size = glint_pixels_need(config) - below(s, 2);
        config->pixels_size = config->pixels_size < PIXELS_MOST ? config->pixels_size : 0;
        config->pixels = pages_place(&v->pixels, config->pixels_size, below(s, 2) ? sizeof(void *) : 1, 1);
        break;
    case 5:
        config->region = take_rectangle(s);
        break;
    default:
        spoil_sizes(config, s);
        break;
    }
}

/* Puts back what spoil_config placed anew. */
static void restore_config(victim *v) {
    check_canaries(v);
    if (v->config.pixels)
        (void)pages_place(&v->pixels, v->config.pixels_size, 1, (uint8_t *)v->config.pixels != v->pixels.room);
    (void)pages_place(&v->arena, v->config.arena_size, 1, (uint8_t *)v->config.arena != v->arena.room);
    use_sound_config(v);
}

static void attack_init(victim *v, attack_stage *stage, source *s) {
    glint_config config = v->config;
    for (uint32_t count = 1 + below(s, 2); count > 0; count--)
        spoil_config(v, &config, s);
    memset(v->drawing, PATTERN, sizeof *v->drawing);
    const glint_status status = glint_init(v->drawing, one_in(s, 64) ? NULL : &config);
    attack_ended(status);
    open_screen(v, &config);
    if (status == GLINT_OK) {
        judge_frame(v, glint_render(v->drawing, &stage->now->scene));
    } else {
        attack_require(are_all(v->drawing, sizeof *v->drawing, 0), "a renderer that is all 0");
        attack_require(glint_render(v->drawing, &sound.scene) == GLINT_ERROR_NULL, "nothing to draw with");
    }
    restore_config(v);
}

static int refuse_to_paint(void *context, const glint_tile *tile) {
    victim *const v = context;
    (void)tile;
    return v->screen.painted++ == v->screen.fail_at;
}

/* Painters that fail at a tile. */
static void attack_painters(victim *v, attack_stage *stage, source *s) {
    glint_config config = v->config;
    *(below(s, 2) ? &config.background : &config.overlay) = (glint_painter){refuse_to_paint, v};
    attack_ended(glint_init(v->drawing, &config));
    open_screen(v, &config);
    const uint32_t fails = below(s, 8);
    v->screen.fail_at = fails;
    const glint_status status = glint_render(v->drawing, &stage->now->scene);
    attack_ended(status);
    attack_require(status != GLINT_OK || v->screen.painted <= fails, "a frame ended by its painter");
    attack_require(!v->screen.is_sending, "a frame's last tile waited for");
    use_sound_config(v);
}

/* ---- Attacks: questions ---- */

/* The least arena suffices for the same picture, and one byte less does not. */
static void judge_need(victim *v, const attack_stage *stage, const glint_need *need, source *s) {
    const int status = render(v, &stage->now->scene);
    const uint32_t wanted = v->screen.sum;
    if (status != GLINT_OK || need->least > ARENA_MOST)
        return;
    for (size_t less = 0; less < 2; less++) {
        glint_config config = v->config;
        config.arena_size = need->least - less;
        config.arena = pages_place(&v->arena, config.arena_size, 1, (int)below(s, 2));
        const glint_status initialised = glint_init(v->drawing, &config);
        const int drawn = initialised == GLINT_OK ? render(v, &stage->now->scene) : (int)initialised;
        attack_require(drawn == (less ? GLINT_ERROR_ARENA : GLINT_OK), "the least arena");
        attack_require(less || stage->is_loose || v->screen.sum == wanted, "the least arena's picture");
        check_canaries(v);
    }
    restore_config(v);
}

static void attack_need(victim *v, attack_stage *stage, source *s) {
    glint_need *const need = place_out(v, s, sizeof *need);
    const int asks = one_in(s, 4);
    glint_config config = v->config;
    if (one_in(s, 4))
        spoil_sizes(&config, s);
    const glint_config *const by = one_in(s, 64) ? NULL : &config;
    const glint_scene *const scene = one_in(s, 64) ? NULL : &stage->now->scene;
    glint_need *const answer = one_in(s, 64) ? NULL : need;
    const glint_status status = glint_arena_need(by, scene, answer);
    judge_answer(v, status);
    if (status != GLINT_OK)
        return;
    attack_require(need->least <= need->resident && need->resident <= need->one_pass, "needs in order");
    if (asks && config.width == v->config.width && config.height == v->config.height &&
        config.tile_width == v->config.tile_width && config.tile_height == v->config.tile_height)
        judge_need(v, stage, need, s);
}

static void attack_check(victim *v, attack_stage *stage, source *s) {
    glint_report *const report = place_out(v, s, sizeof *report);
    glint_config config = v->config;
    if (one_in(s, 4))
        spoil_config(v, &config, s);
    open_screen(v, &config);
    const glint_status status = glint_check(&config, &stage->now->scene, report);
    attack_ended(status);
    attack_require(status == report->status && report->sentence && v->screen.calls == 0, "a report");
    open_screen(v, &config);
    glint_status drawn = glint_init(v->drawing, &config);
    if (drawn == GLINT_OK)
        judge_frame(v, drawn = glint_render(v->drawing, &stage->now->scene));
    const int is_memory = drawn == GLINT_ERROR_ARENA || drawn == GLINT_ERROR_PIXELS; /* the scene's errors come first */
    attack_require(drawn == status || (is_memory && status != GLINT_OK), "a report of what drawing returns");
    restore_config(v);
}

static void attack_pick(victim *v, attack_stage *stage, source *s) {
    glint_hit *const hit = place_out(v, s, sizeof *hit);
    const int x = one_in(s, 8) ? (int)attack_number(s, 0) : (int)below(s, 64);
    const int y = one_in(s, 8) ? (int)attack_number(s, 0) : (int)below(s, 48);
    const glint_scene *const scene = one_in(s, 64) ? NULL : &stage->now->scene;
    const int status = glint_pick(v->drawing, scene, x, y, one_in(s, 64) ? NULL : hit);
    judge_answer(v, status);
    if (status == 0)
        attack_require(are_all(hit, sizeof *hit, PATTERN), "no hit, no answer");
    attack_add(&hit->object, sizeof hit->object);
    attack_add(&hit->triangle, sizeof hit->triangle);
    if (status > 0)
        attack_require(hit->object < stage->now->scene.object_count &&
                           hit->triangle < stage->now->objects[hit->object].mesh->triangle_count,
                       "a triangle of the scene");
}

static glint_vector take_vector(source *s) {
    glint_vector to = {0, 0, 0};
    glint_q16 *const number[3] = {&to.x, &to.y, &to.z};
    for (int i = 0; i < 3; i++) {
        const uint32_t old = take(s, 4);
        *number[i] = (glint_q16)attack_number(s, old);
    }
    return to;
}

static void attack_project(victim *v, attack_stage *stage, source *s) {
    glint_screen_point *const place = place_out(v, s, sizeof *place);
    glint_config config = v->config;
    if (one_in(s, 4))
        spoil_sizes(&config, s);
    const glint_config *const by = one_in(s, 64) ? NULL : &config;
    const glint_camera *const camera = one_in(s, 64) ? NULL : &stage->now->scene.camera;
    const glint_vector point = take_vector(s);
    judge_answer(v, glint_camera_project(by, camera, point, one_in(s, 64) ? NULL : place));
    attack_add(place, sizeof *place);
}

/* ---- Attacks: lines ---- */

#define LINES 24

typedef struct wires {
    glint_line lines[LINES];
    const glint_segment *segments;
} wires;

static int paint_wires(void *context, const glint_tile *tile) {
    const wires *const w = context;
    return glint_lines_draw(tile, w->segments, LINES);
}

/* A box, and others. */
static void take_lines(glint_line lines[LINES], source *s) {
    glint_colour colour = {.r = GLINT_ONE};
    colour.g = (glint_q16)take(s, 2);
    colour.b = one_in(s, 8) ? (glint_q16)attack_number(s, 0) : 0;
    for (int i = 11; i < LINES; i++) {
        lines[i] = (glint_line){.colour = colour};
        lines[i].from = take_vector(s);
        lines[i].to = take_vector(s);
    }
    const glint_line corners = lines[11];
    glint_lines_box(lines, corners.from, corners.to, colour);
}

static void attack_lines(victim *v, attack_stage *stage, source *s) {
    wires w;
    glint_segment *const segments = place_out(v, s, LINES * sizeof *segments);
    glint_config config = v->config;
    take_lines(w.lines, s);
    w.segments = segments;
    if (one_in(s, 8))
        spoil_sizes(&config, s);
    glint_segment *const answer = one_in(s, 64) ? NULL : segments;
    const glint_pose *const pose = one_in(s, 64) ? NULL : &stage->now->objects[0].pose;
    const glint_status status = glint_lines_project(answer, &config, &stage->now->scene.camera, pose, w.lines, LINES);
    judge_answer(v, status);
    attack_require(glint_lines_draw(NULL, segments, LINES) == GLINT_ERROR_NULL, "no tile, no lines");
    if (status != GLINT_OK)
        return;
    config = v->config;
    config.overlay = (glint_painter){paint_wires, &w};
    attack_require(glint_init(v->drawing, &config) == GLINT_OK, "a sound configuration");
    judge_frame(v, render(v, &sound.scene));
    use_sound_config(v);
}

/* ---- Attacks: changes, and tile by tile ---- */

static void attack_changes(victim *v, attack_stage *stage, source *s) {
    glint_change_filter *const changes = place_out(v, s, sizeof *changes);
    glint_config config = v->config;
    if (one_in(s, 2))
        spoil_config(v, &config, s);
    const uint32_t count = glint_tile_signature_count(&config);
    void *const signatures =
        pages_place(&v->signatures, count * sizeof(glint_tile_signature), sizeof(uint32_t), (int)below(s, 2));
    glint_tile_signature *const kept = one_in(s, 64) ? NULL : signatures;
    const glint_status status = glint_change_filter_init(changes, kept, one_in(s, 64) ? NULL : &config);
    attack_ended(status);
    config.flush = glint_change_filter_flush(changes);
    if (status != GLINT_OK)
        attack_require(are_all(changes, sizeof *changes, 0) && !config.flush.begin, "a filter that is all 0");
    glint_status drawn = glint_init(v->drawing, &config);
    attack_ended(drawn);
    attack_require(status == GLINT_OK || drawn != GLINT_OK, "no drawing with a filter that is all 0");
    const int frames = config.region.width ? 1 : 2; /* parts of tiles are sent again, whole ones between them are not */
    for (int frame = 0; frame < frames && drawn == GLINT_OK; frame++) {
        drawn = (glint_status)render(v, &stage->now->scene);
        if (!frame)
            judge_frame(v, drawn);
        else
            attack_require(v->screen.calls == 0, "nothing sent that did not change");
    }
    restore_config(v);
}

/* Draws tiles of a frame that is begun. @return how many, or an error */
static int draw_tiles(glint_frame *frame, glint_workspace *workspace) {
    int status, tiles = 0;
    while ((status = glint_frame_next_pass(frame)) > 0)
        for (uint32_t tile = frame->tile_first; tile < frame->tile_end; tile++)
            if (glint_render_tile(frame, workspace, tile)) {
                int at[4];
                glint_tile of;
                glint_tile_rectangle(frame, tile, &at[0], &at[1], &at[2], &at[3]);
                glint_tile_find(frame, workspace, tile, &of);
                attack_require(of.x == at[0] && of.y == at[1] && of.width == at[2] && of.height == at[3] && at[2] > 0 &&
                                   at[3] > 0,
                               "one rectangle of a tile");
                tiles++;
            }
    return status < 0 ? status : tiles;
}

static void attack_tiles(victim *v, attack_stage *stage, source *s) {
    glint_frame *const frame = place_out(v, s, sizeof *frame);
    glint_workspace workspace;
    glint_config config = v->config;
    config.keeps_arena = 0;
    if (one_in(s, 2))
        spoil_config(v, &config, s);
    const glint_config *const by = one_in(s, 64) ? NULL : &config;
    const glint_status status = glint_frame_begin(frame, by, one_in(s, 64) ? NULL : &stage->now->scene);
    attack_ended(status);
    if (status != GLINT_OK) {
        attack_require(are_all(frame, sizeof *frame, 0), "a frame that is all 0");
        attack_require(glint_frame_next_pass(frame) == GLINT_ERROR_NULL, "no pass of a frame that is all 0");
    } else {
        void *const memory = pages_place(&v->signatures, glint_workspace_size(&config), sizeof(void *), 1);
        glint_workspace_init(&workspace, &config, memory);
        const int tiles = draw_tiles(frame, &workspace);
        attack_ended(tiles < 0 ? tiles : 0);
        attack_require(tiles < 0 || (uint32_t)tiles == frame->stats.tiles, "every tile");
    }
    restore_config(v);
}

/* ---- Attacks: bits that flip ---- */

/* Of arrays that say nothing of how long others are: numbers of borrowers would. */
static pages *take_array(attack_stage *stage, source *s) {
    static const uint8_t arrays[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 10};
    pages *const of = stage->arrays[below(s, DRAWING_MESHES)];
    return &of[arrays[below(s, sizeof arrays)]];
}

/* Changes bit number `bit` of some bytes. */
static void flip(uint8_t *bytes, size_t bit) {
    bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
}

/* A bit of a mesh's arrays flips, and one of the structures' numbers; the next frame is drawn without them. */
static void attack_flip(victim *v, attack_stage *stage, source *s) {
    props *const now = stage->now;
    uint8_t *numbers[3];
    numbers[0] = (uint8_t *)&now->objects[below(s, DRAWING_OBJECTS)].pose;
    numbers[1] = (uint8_t *)&now->materials[below(s, DRAWING_OBJECTS)].ambient;
    numbers[2] = (uint8_t *)&now->lights[below(s, GLINT_LIGHTS_MAX)].position;
    pages *const array = take_array(stage, s);
    const size_t bit = array->size ? take(s, 4) % (8 * array->size) : 0;
    pages_unseal(&stage->structures);
    uint8_t *const number = numbers[below(s, 3)];
    flip(number, below(s, 8 * sizeof(glint_colour)));
    pages_seal(&stage->structures);
    for (int frame = 0; frame < 2; frame++) { /* with the array's bit, and without */
        pages_unseal(array);
        if (array->size)
            flip(array->bytes, bit);
        pages_seal(array);
        judge_frame(v, render(v, &now->scene));
    }
}

/* Bits flip between two frames in what the first one left in the arena. */
static void attack_flip_kept(victim *v, attack_stage *stage, source *s) {
    const size_t used = v->drawing->stats.arena_used;
    (void)stage;
    for (uint32_t count = 1 + below(s, 3); count > 0; count--)
        flip(v->arena.bytes, take(s, 4) % (8 * used));
}

/* ---- Attacks: generators and arithmetic ---- */

static glint_status generate(source *s, glint_mesh *mesh, const glint_mesh_room *room) {
    const glint_q16 a = one_in(s, 4) ? (glint_q16)attack_number(s, 0) : (glint_q16)take(s, 3) + 1,
                    b = one_in(s, 4) ? (glint_q16)attack_number(s, 0) : (glint_q16)take(s, 3) + 1;
    const uint32_t m = one_in(s, 8) ? attack_number(s, 65536) : below(s, 12),
                   n = one_in(s, 8) ? attack_number(s, 65536) : below(s, 12);
    const int capped = (int)below(s, 2);
    switch (below(s, 6)) {
    case 0:
        return glint_generate_torus(mesh, room, m, n, a, b);
    case 1:
        return glint_generate_sphere(mesh, room, m, n, a);
    case 2:
        return glint_generate_cylinder(mesh, room, m, n, a, b, capped);
    case 3:
        return glint_generate_cone(mesh, room, m, n, a, b, capped);
    case 4:
        return glint_generate_plane(mesh, room, m, n, a, b);
    default:
        return glint_generate_box(mesh, room, a, b, a);
    }
}

static void attack_generators(victim *v, attack_stage *stage, source *s) {
    const uint32_t vertices = below(s, 200), triangles = below(s, 300);
    glint_mesh_room room = {.vertex_room = vertices, .triangle_room = triangles};
    glint_mesh mesh, before;
    (void)stage;
    memset(&mesh, PATTERN, sizeof mesh);
    room.positions = pages_place(&v->signatures, vertices * sizeof *room.positions, 2, 1);
    room.normals = pages_place(&v->out, vertices * sizeof *room.normals, 2, 1);
    room.triangles = pages_place(&v->pixels, triangles * sizeof *room.triangles, 2, 1);
    before = mesh;
    glint_mesh *const answer = one_in(s, 64) ? NULL : &mesh;
    const glint_mesh_room *const from = one_in(s, 64) ? NULL : &room;
    const glint_status status = generate(s, answer, from);
    attack_ended(status);
    if (status == GLINT_OK) {
        attack_add(mesh.positions, mesh.vertex_count * sizeof *mesh.positions);
        for (uint32_t i = 0; i < 3 * mesh.triangle_count; i++)
            attack_require(mesh.triangles[i / 3][i % 3] < mesh.vertex_count, "indices of vertices that there are");
    } else {
        before.vertex_count = mesh.vertex_count;
        before.triangle_count = mesh.triangle_count;
        attack_require(are_same(&before, &mesh, sizeof mesh), "the rest of a mesh as it was");
    }
    restore_config(v);
}

static void attack_arithmetic(victim *v, attack_stage *stage, source *s) {
    glint_camera camera = stage->now->scene.camera, before = camera;
    const glint_vector a = take_vector(s), b = take_vector(s), c = take_vector(s);
    const glint_pose *const some = &stage->now->objects[0].pose;
    (void)v;
    const glint_status status = glint_camera_look_at(one_in(s, 64) ? NULL : &camera, a, b, c);
    attack_ended(status);
    attack_require(status == GLINT_OK || are_same(&camera, &before, sizeof camera), "a camera as it was");
    glint_camera_orbit(&camera, a, b.x, b.y, b.z);
    glint_pose pose = glint_pose_rotate(a, b.x);
    pose = glint_pose_then(&pose, some);
    pose = glint_pose_then(some, &pose);
    (void)glint_pose_apply(&pose, c);
    (void)glint_pose_quaternion(a.x, a.y, a.z, b.x);
    (void)glint_pose_rotate_x(a.x);
    (void)glint_pose_rotate_y(a.y);
    (void)glint_pose_rotate_z(a.z);
    (void)glint_pose_scale(a.x, a.y, a.z);
    (void)glint_material_paint(NULL, (glint_colour){a.x, a.y, a.z}, b.x, b.y);
    attack_require(glint_sin(a.x) <= GLINT_ONE && glint_cos(a.x) >= -GLINT_ONE, "a sine");
    attack_require(glint_strerror((int)attack_number(s, 0)) != NULL, "a sentence");
}

const victim_attack victim_attacks[] = {
    {"glint_render", attack_render},
    {"glint_render_region", attack_region},
    {"glint_init", attack_init},
    {"painters", attack_painters},
    {"glint_arena_need", attack_need},
    {"glint_check", attack_check},
    {"glint_pick", attack_pick},
    {"glint_camera_project", attack_project},
    {"lines", attack_lines},
    {"changes", attack_changes},
    {"tile by tile", attack_tiles},
    {"generators", attack_generators},
    {"arithmetic", attack_arithmetic},
    {"flipped bits", attack_flip},
    {"flipped bits of the arena", attack_flip_kept},
};

const uint32_t victim_attack_count = sizeof victim_attacks / sizeof *victim_attacks;
