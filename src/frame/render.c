/* SPDX-License-Identifier: MIT */
/* Draws every tile of a frame through the flush callback, one sent while the next is drawn. */
#include "frame.h"

glint_status glint_init(glint_renderer *renderer, const glint_config *config) {
    if (!renderer)
        return GLINT_ERROR_NULL;
    *renderer = (glint_renderer){0};
    if (!config || !config->flush.begin || !config->arena)
        return GLINT_ERROR_NULL;
    renderer->config = *config;
    glint_status status = glint_check_config(&renderer->config);
    if (status == GLINT_OK)
        status = glint_check_region(&renderer->config);
    if (status == GLINT_OK && config->pixels &&
        (config->pixels_size < glint_pixels_need(config) || glint_align(config->pixels) != config->pixels))
        status = GLINT_ERROR_PIXELS;
    if (status == GLINT_OK && config->arena_size < glint_tile_buffers_size(&renderer->config) + GLINT_ALIGNMENT)
        status = GLINT_ERROR_ARENA;
    if (status != GLINT_OK)
        *renderer = (glint_renderer){0};
    return status;
}

/* A sender knows the tile that is being sent, if any, and the buffers that take turns. */
typedef struct sender {
    const glint_flush *flush;
    void *buffers[2];
    void *background; /* the buffer that holds background alone, or null */
    int busy;
    int error; /* what the flush reported, or 0 */
} sender;

static int wait_for_flush(sender *s) {
    const int error = s->busy && s->flush->wait ? s->flush->wait(s->flush->context) : 0;
    s->busy = 0;
    s->error = s->error ? s->error : error;
    return s->error;
}

static glint_status send(sender *s, const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    glint_tile of;
    glint_tile_find(frame, workspace, tile, &of);
    if (!wait_for_flush(s))
        s->error = s->flush->begin(s->flush->context, of.x + frame->config.left, of.y + frame->config.top, of.width,
                                   of.height, of.pixels, of.stride);
    if (s->error)
        return GLINT_ERROR_FLUSH;
    s->busy = 1;
    workspace->pixels = s->buffers[workspace->pixels == s->buffers[0]];
    return GLINT_OK;
}

/* Draws a tile, unless a buffer already holds its pixels. @return 1 when it is finished, or GLINT_ERROR_PAINT */
static int finish_tile(sender *s, const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    const int empty =
        !frame->config.background.paint && !frame->config.overlay.paint && glint_tile_is_empty(frame, tile);
    if (empty && s->background) {
        workspace->pixels = s->background;
        return 1;
    }
    if (empty)
        s->background = workspace->pixels;
    else if (workspace->pixels == s->background)
        s->background = 0;
    return glint_render_tile(frame, workspace, tile);
}

/* Finds the bytes of the arena that a pass leaves free. */
static glint_spare find_spare(const glint_frame *frame) {
    uint8_t *const low = glint_align(frame->references + frame->reference_count);
    uint8_t *const high = (uint8_t *)frame->clipped;
    return (glint_spare){low, low < high ? (uint32_t)(high - low) : 0, 0};
}

static glint_status render_passes(glint_frame *frame, glint_workspace *workspace, sender *s) {
    int pass;
    while ((pass = glint_frame_next_pass(frame)) > 0) {
        workspace->spare = find_spare(frame);
        for (uint32_t tile = frame->tile_first; tile < frame->tile_end; tile++) {
            const int finished = finish_tile(s, frame, workspace, tile);
            if (!finished)
                continue;
            const glint_status status = finished < 0 ? (glint_status)finished : send(s, frame, workspace, tile);
            if (status != GLINT_OK)
                return status;
        }
    }
    return (glint_status)pass;
}

void glint_take_buffers(glint_config *config, glint_workspace *workspace) {
    uint8_t *const memory = glint_align(config->arena);
    const size_t size = glint_tile_buffers_size(config);
    glint_workspace_init(workspace, config, memory);
    if (config->pixels) {
        workspace->row = (void *)workspace->pixels;
        workspace->pixels = config->pixels;
    } else if (config->flush.wait) {
        workspace->row = (void *)((uint8_t *)workspace->pixels + 2 * glint_second_pixels(config));
    }
    glint_place_lights(workspace);
    config->arena = memory + size;
    config->arena_size -= size; /* glint_frame_begin gives up the bytes that aligning costs */
}

/* Begins a frame in what the tiles' buffers leave of the arena. This is out of line, so that its configuration is not
 * on the stack while tiles are drawn. */
static GLINT_NOINLINE glint_status begin_rendering(glint_frame *frame, glint_workspace *workspace,
                                                   const glint_renderer *renderer, const glint_scene *scene) {
    glint_config config = renderer->config;
    glint_take_buffers(&config, workspace);
    return glint_frame_begin(frame, &config, scene);
}

glint_status glint_render(glint_renderer *renderer, const glint_scene *scene) {
    if (!renderer || !scene || !renderer->config.flush.begin)
        return GLINT_ERROR_NULL;
    glint_frame frame;
    glint_workspace workspace;
    frame.shading = renderer->kept.shadings;
    frame.shading_count = renderer->kept.count;
    frame.prepared_end = renderer->kept.end;
    renderer->stats = (glint_stats){0};
    renderer->kept = (glint_kept){0};
    glint_status status = begin_rendering(&frame, &workspace, renderer, scene);
    if (status != GLINT_OK)
        return status;
    renderer->kept = (glint_kept){frame.shading, frame.shading_count, frame.prepared_end};
    uint8_t *first = workspace.pixels;
    uint8_t *second = frame.config.flush.wait ? first + glint_second_pixels(&frame.config) : first;
    sender s = {&frame.config.flush, {first, second}, 0, 0, 0};
    status = render_passes(&frame, &workspace, &s);
    if (wait_for_flush(&s) && status == GLINT_OK)
        status = GLINT_ERROR_FLUSH;
    frame.stats.arena_used += (uint32_t)(glint_tile_buffers_size(&frame.config) + GLINT_ALIGNMENT - 1);
    frame.stats.flush_error = s.error;
    renderer->stats = frame.stats;
    return status;
}

glint_status glint_render_region(glint_renderer *renderer, const glint_scene *scene, const glint_rectangle *region) {
    if (!renderer || !region)
        return GLINT_ERROR_NULL;
    const glint_rectangle whole = renderer->config.region;
    renderer->config.region = *region;
    const glint_status status = glint_render(renderer, scene);
    renderer->config.region = whole;
    return status;
}
