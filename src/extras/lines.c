/* SPDX-License-Identifier: MIT */
/* Brings lines from space to the screen, where they are cut at the near plane and the guard band, and draws them onto
 * finished tiles. Makes the lines of boxes and meshes. */
#include "../blend/blend.h"
#include "../frame/frame.h"

/* ---- From space to the screen ---- */

/* Lines are placed with these. */
typedef struct line_camera {
    const glint_config *config;
    const glint_camera *camera;
    const glint_pose *pose;
    int32_t focal; /* twice the focal length in pixels, Q12: this, of 22 bits, times 2^focal_shift */
    unsigned focal_shift;
} line_camera;

/* An end on its way has x and y against the guard band, all below 2^59, and w, Q28. */
typedef struct line_end {
    int64_t x, y, band, w;
} line_end;

static void find_end(const line_camera *by, glint_vector point, line_end *to) {
    int64_t sight[3]; /* below 2^40, once it is Q19 */
    glint_find_sight(by->camera, glint_pose_apply(by->pose, point), sight);
    to->x = glint_round_shift64(glint_shift_right64(sight[0], 12) * by->focal, 10);
    to->y = glint_round_shift64(glint_shift_right64(sight[1], 12) * by->focal, 10);
    to->w = glint_shift_right64(sight[2], 3);
    /* The focal length is over 2^13, and the products are over 2^10 and 2^focal_shift. */
    const int64_t divisor = glint_find_divisor(by->config, by->camera, sight);
    const unsigned down = glint_magnitude64(divisor) >> 48 ? 12 : 0;
    to->band =
        glint_shift_right64(glint_shift_right64(divisor, down) * (GLINT_GUARD_BAND << 3), 12 - down + by->focal_shift);
}

/* Returns how far inside a plane an end lies. Plane 0 is the near plane, 1 to 4 are the sides. */
static int64_t depth_behind(const line_end *end, int plane, int64_t near_plane) {
    const int64_t side = plane < 3 ? end->x : end->y;
    return plane == 0 ? end->w - near_plane : end->band + (plane & 1 ? side : -side);
}

/* Computes a + (b - a) t, t Q31, off by 2^-30 of the difference. */
static int64_t mix_along(int64_t a, int64_t b, int64_t t) {
    const unsigned bits = glint_bits64(glint_magnitude64(b - a)), down = bits > 31 ? bits - 31 : 0;
    return a + glint_shift_right64(glint_shift_right64(b - a, down) * t, 31 - down);
}

/* Cuts a line between an end inside a plane and one outside. */
static void cut_line(const line_end *inner, line_end *outer, int64_t inside, int64_t outside) {
    const unsigned bits = glint_bits64((uint64_t)(inside - outside)), down = bits > 31 ? bits - 31 : 0;
    const int64_t t = ((inside >> down) << 31) / ((inside - outside) >> down);
    outer->x = mix_along(inner->x, outer->x, t);
    outer->y = mix_along(inner->y, outer->y, t);
    outer->band = mix_along(inner->band, outer->band, t);
    outer->w = mix_along(inner->w, outer->w, t);
}

/* Clips a line. @return 0 where nothing is left */
static int clip_line(line_end end[2], int64_t near_plane) {
    for (int plane = 0; plane < 5; plane++) {
        const int64_t a = depth_behind(&end[0], plane, near_plane), b = depth_behind(&end[1], plane, near_plane);
        if (a < 0 && b < 0)
            return 0;
        if (b < 0)
            cut_line(&end[0], &end[1], a, b);
        else if (a < 0)
            cut_line(&end[1], &end[0], b, a);
    }
    return 1;
}

/* Computes half the size in sixteenths + x / band times the guard band, rounded to nearest, halves up. Rounding may
 * have brought x beyond the band. */
static int16_t to_sixteenths(int64_t x, int64_t band, int32_t size) {
    const unsigned bits = glint_bits64((uint64_t)band), down = bits > 46 ? bits - 46 : 0;
    const int64_t most = (band >> down) + (band == 0), all = 2 * 16 * GLINT_GUARD_BAND;
    const int64_t from_edge = glint_shift_right64(x, down) + most;
    const int64_t inside = from_edge < 0 ? 0 : from_edge > 2 * most ? 2 * most : from_edge;
    return (int16_t)((inside * all + most) / (2 * most) - all / 2 + size * 8);
}

static void finish_end(const line_camera *by, const line_end *end, glint_segment *to, int i) {
    const int64_t near_plane = (int64_t)by->camera->near_plane << 12, w = end->w > near_plane ? end->w : near_plane;
    const int down = (int)glint_bits64((uint64_t)w) - 31;
    const int64_t mantissa = (down > 0 ? w >> down : w << -down) | 1;
    to->x[i] = to_sixteenths(end->x, end->band, by->config->width);
    to->y[i] = to_sixteenths(end->y, end->band, by->config->height);
    to->inverse_w[i] = (uint32_t)(by->camera->projection ? mantissa : (((int64_t)1 << 62) - 1) / mantissa);
    to->exponent[i] = (uint8_t)(62 + down);
}

static void place_line(const line_camera *by, const glint_line *line, glint_segment *to) {
    line_end end[2];
    *to = (glint_segment){0};
    find_end(by, line->from, &end[0]);
    find_end(by, line->to, &end[1]);
    if (!clip_line(end, (int64_t)by->camera->near_plane << 12))
        return;
    finish_end(by, &end[0], to, 0);
    finish_end(by, &end[1], to, 1);
    to->width = (uint16_t)(line->width ? (line->width + 128) >> 8 : 256);
    to->colour = &line->colour;
}

/* The largest width of a smooth line, in pixels. */
#define WIDTH_MOST 64

glint_status glint_lines_project(glint_segment *segments, const glint_config *config, const glint_camera *camera,
                                 const glint_pose *pose, const glint_line *lines, uint32_t count) {
    const glint_status status = glint_check_sight(config, camera);
    if (status != GLINT_OK)
        return status;
    if (!pose || (count && (!lines || !segments)))
        return GLINT_ERROR_NULL;
    for (uint32_t i = 0; i < count; i++) {
        const glint_colour *const c = &lines[i].colour;
        if ((uint32_t)c->r > GLINT_COLOUR_MAX || (uint32_t)c->g > GLINT_COLOUR_MAX || (uint32_t)c->b > GLINT_COLOUR_MAX)
            return GLINT_ERROR_COLOUR;
        if ((uint32_t)lines[i].width > WIDTH_MOST * GLINT_ONE)
            return GLINT_ERROR_WIDTH;
    }
    const int64_t focal = glint_round_shift64(glint_focal_length(config, camera), 31 - 12);
    const unsigned bits = glint_bits64((uint64_t)focal), down = bits > 22 ? bits - 22 : 0;
    const line_camera by = {config, camera, pose, (int32_t)(focal >> down), down};
    for (uint32_t i = 0; i < count; i++)
        place_line(&by, &lines[i], &segments[i]);
    return GLINT_OK;
}

/* ---- Boxes and meshes ---- */

void glint_lines_box(glint_line lines[12], glint_vector from, glint_vector to, glint_colour colour) {
    const glint_q16 x[2] = {from.x, to.x}, y[2] = {from.y, to.y}, z[2] = {from.z, to.z};
    for (int i = 0; i < 4; i++) { /* four along each axis */
        const int a = i & 1, b = i >> 1;
        lines[i] = (glint_line){{x[0], y[a], z[b]}, {x[1], y[a], z[b]}, colour, 0};
        lines[i + 4] = (glint_line){{x[a], y[0], z[b]}, {x[a], y[1], z[b]}, colour, 0};
        lines[i + 8] = (glint_line){{x[a], y[b], z[0]}, {x[a], y[b], z[1]}, colour, 0};
    }
}

/* Computes offset + extent step / 32768. */
static glint_q16 place_step(glint_q16 offset, glint_q16 extent, int16_t step) {
    const int64_t place = offset + glint_round_shift64((int64_t)extent * step, 15);
    return place > INT32_MAX ? INT32_MAX : place < INT32_MIN ? INT32_MIN : (glint_q16)place;
}

static glint_vector place_vertex(const glint_mesh *mesh, uint32_t index) {
    int16_t fetched[3];
    const int16_t *const step = glint_steps_of(mesh, index, fetched);
    return (glint_vector){place_step(mesh->offset.x, mesh->extent.x, step[0]),
                          place_step(mesh->offset.y, mesh->extent.y, step[1]),
                          place_step(mesh->offset.z, mesh->extent.z, step[2])};
}

/* Has a triangle before number `end` an edge between two vertices, in either direction? */
static int names_edge(const glint_mesh *mesh, uint32_t end, uint16_t a, uint16_t b) {
    for (uint32_t i = 0; i < end; i++) {
        uint16_t fetched[3];
        const uint16_t *const v = glint_triangle_of(mesh, i, fetched);
        const int has_a = v[0] == a || v[1] == a || v[2] == a, has_b = v[0] == b || v[1] == b || v[2] == b;
        if (has_a && has_b)
            return 1;
    }
    return 0;
}

uint32_t glint_lines_edges(glint_line *lines, uint32_t room, const glint_mesh *mesh, glint_colour colour) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        uint16_t fetched[3];
        const uint16_t *const v = glint_triangle_of(mesh, i, fetched);
        for (int corner = 0; corner < 3; corner++) {
            const uint16_t a = v[corner], b = v[corner < 2 ? corner + 1 : 0];
            if (a >= mesh->vertex_count || b >= mesh->vertex_count || names_edge(mesh, i, a, b))
                continue;
            if (count < room)
                lines[count] = (glint_line){place_vertex(mesh, a), place_vertex(mesh, b), colour, 0};
            count++;
        }
    }
    return count;
}

/* ---- Onto a tile, where nothing nearer is ---- */

/* 1/w of a line's end over that of the frame's nearest, Q31, is at most this: what is nearer by more than 2^14 counts
 * as that. */
#define LARGEST_DEPTH ((int64_t)1 << 45)

/* A tile's lines are drawn with these: the frame's nearest w is a mantissa times 2^shift, nearer by the width of two
 * pixels. */
typedef struct line_target {
    const glint_tile *tile;
    uint32_t nearest; /* 31 bits */
    int32_t nearest_shift;
} line_target;

/* A line is walked along its longer axis u; v is the other axis. */
typedef struct line_walk {
    int32_t u0, v0, du, dv; /* 28.4; du is not below 0 */
    int64_t depth, slope;   /* Q31 at u0; change over a sixteenth, Q47 */
    int is_steep;
} line_walk;

/* Returns the depth of an end of parallel rays, which keeps w in place of 1/w. */
static int64_t depth_of_parallel(const glint_frame *frame, const glint_segment *segment, int i) {
    const int up = segment->exponent[i] - 62;
    const int64_t kept = segment->inverse_w[i], w = up > 0 ? kept << up : kept >> -up;
    return frame->scene->camera.projection->depth_at(frame->view, w - (2 << glint_sample_shift(frame)) *
                                                                          frame->view->nearest / GLINT_GUARD_BAND);
}

static int64_t depth_of_end(const line_target *target, const glint_segment *segment, int i) {
    if (target->tile->frame->view->is_parallel)
        return depth_of_parallel(target->tile->frame, segment, i);
    const int down = segment->exponent[i] - 31 - target->nearest_shift;
    const uint64_t product = glint_product_unsigned(target->nearest, segment->inverse_w[i]); /* 2^61 to 2^63 */
    const int64_t depth = (int64_t)(down < 64 ? product >> glint_most(down, 16) : 0);
    return depth < LARGEST_DEPTH ? depth : LARGEST_DEPTH;
}

static void begin_line(const line_target *target, const glint_segment *segment, line_walk *walk) {
    const int32_t x = segment->x[1] - segment->x[0], y = segment->y[1] - segment->y[0];
    walk->is_steep = (y < 0 ? -y : y) > (x < 0 ? -x : x);
    const int16_t *const u = walk->is_steep ? segment->y : segment->x, *const v =
                                                                           walk->is_steep ? segment->x : segment->y;
    const int first = u[1] < u[0], last = 1 - first;
    walk->u0 = u[first];
    walk->v0 = v[first];
    walk->du = u[last] - u[first];
    walk->dv = v[last] - v[first];
    walk->depth = depth_of_end(target, segment, first);
    walk->slope = walk->du ? (depth_of_end(target, segment, last) - walk->depth) * (1 << 16) / walk->du : 0;
}

/* Finds a pixel of the screen in its tile. @return its depth, of 16 bits, if it is nearer than what is there; else 0 */
static uint16_t find_nearer(const line_target *target, int32_t x, int32_t y, int64_t depth, glint_canvas *canvas,
                            uint32_t *offset) {
    const glint_frame *const frame = target->tile->frame;
    const glint_workspace *const workspace = target->tile->workspace;
    const unsigned smaller = glint_sample_shift(frame);
    *canvas = (glint_canvas){frame->config.format, workspace->pixels, frame->tile_shift_x - smaller};
    *offset = (((uint32_t)y & (frame->config.tile_height - 1u) >> smaller) << canvas->shift) +
              ((uint32_t)x & (frame->config.tile_width - 1u) >> smaller);
    const int64_t step = glint_shift_right64(depth, 15);
    const uint16_t here = (uint16_t)(step < 0 ? 1 : step < 0xffff ? step + 1 : 0xffff);
    return here > workspace->depth[*offset] ? here : 0;
}

static void store_pixel(const glint_canvas *canvas, uint32_t offset, const int32_t colour[1][3]) {
    const glint_list_pixel pixel = {offset, {colour[0][0], colour[0][1], colour[0][2]}};
    canvas->format->store_list(canvas->pixels, canvas->shift, &pixel, sizeof pixel, 1);
}

/* Draws a pixel of the screen, if it is nearer than what is there. */
static void draw_pixel(const line_target *target, int32_t x, int32_t y, int64_t depth, const int32_t colour[1][3]) {
    glint_canvas canvas;
    uint32_t offset;
    const uint16_t here = find_nearer(target, x, y, depth, &canvas, &offset);
    if (!here)
        return;
    target->tile->workspace->depth[offset] = here;
    store_pixel(&canvas, offset, colour);
}

/* Draws columns, or rows, of a range: one pixel in each, where the other coordinate is in the range. */
static void walk_along(const line_target *target, const line_walk *walk, const glint_range *range,
                       const int32_t colour[1][3]) {
    const int32_t width = glint_most(walk->du, 1), whole = 16 * width;
    int32_t v = GLINT_GUARD_BAND;
    for (int32_t u = range->left; u < range->right; u++) {
        const int32_t along = glint_most(glint_least(16 * u + 8 - walk->u0, walk->du), 0);
        const int32_t there = walk->v0 * width + along * walk->dv; /* v there times width: below 2^30 */
        if (u == range->left)
            v = (there + 1024 * whole) / whole - 1024;
        else /* dv is at most du */
            v += there >= (v + 1) * whole ? 1 : there < v * whole ? -1 : 0;
        if (v >= range->top && v < range->bottom)
            draw_pixel(target, walk->is_steep ? v : u, walk->is_steep ? u : v,
                       walk->depth + glint_shift_right64(walk->slope * along, 16), colour);
    }
}

/* Cuts the range between two places, in sixteenths, and as far around them, to a tile from `first` on, `size` wide. */
static void cut_range(int32_t first, int32_t size, int32_t a, int32_t b, int32_t around, int32_t *from, int32_t *to) {
    *from = glint_most(first, glint_shift_right(glint_least(a, b) - around, 4));
    *to = glint_least(first + size, glint_shift_right(glint_most(a, b) + around, 4) + 1);
}

/* Finds the range of a segment in a tile, with so many sixteenths of a pixel around it, and its colour. @return 0 where
 * the range has no pixel */
static int begin_segment(const glint_tile *tile, const glint_segment *segment, int32_t around, glint_range *range,
                         int32_t colour[1][3]) {
    const glint_colour *const c = segment->colour;
    if (!c)
        return 0;
    cut_range(tile->x, tile->width, segment->x[0], segment->x[1], around, &range->left, &range->right);
    cut_range(tile->y, tile->height, segment->y[0], segment->y[1], around, &range->top, &range->bottom);
    if (range->left >= range->right || range->top >= range->bottom)
        return 0;
    const uint32_t shown[3] = {(uint32_t)c->r << 7, (uint32_t)c->g << 7, (uint32_t)c->b << 7};
    glint_channels_of(shown, colour[0]);
    glint_finish_colours(&tile->frame->config, colour, 1);
    return 1;
}

static void draw_segment(const line_target *target, const glint_segment *segment) {
    glint_range range;
    line_walk walk;
    int32_t colour[1][3];
    if (!begin_segment(target->tile, segment, 0, &range, colour))
        return;
    begin_line(target, segment, &walk);
    if (walk.is_steep)
        range = (glint_range){range.top, range.left, range.bottom, range.right};
    walk_along(target, &walk, &range, (const int32_t(*)[3])colour);
}

/* ---- Smooth lines ---- */

/* A smooth line has its length and width, 1/256 of a pixel; and how far a pixel's middle lies from the line's in both
 * directions, Q20, at pixel 0, 0 of the screen, and its change from pixel to pixel. Their sums have 32 bits. */
typedef struct smooth_line {
    line_walk walk;
    int32_t size[2];
    uint32_t at[2], dx[2], dy[2];
} smooth_line;

/* Sets one direction: x and y of a unit vector, Q20. */
static void set_direction(smooth_line *line, int i, const glint_segment *segment, int32_t x, int32_t y) {
    const int32_t middle_x = 16 - segment->x[0] - segment->x[1], middle_y = 16 - segment->y[0] - segment->y[1];
    line->at[i] = (uint32_t)glint_shift_right64(glint_product(middle_x, x) + glint_product(middle_y, y), 5);
    line->dx[i] = (uint32_t)x;
    line->dy[i] = (uint32_t)y;
}

/* Begins a smooth line. @return 0 where it has no length */
static int begin_smooth(const line_target *target, const glint_segment *segment, smooth_line *line) {
    begin_line(target, segment, &line->walk);
    const line_walk *const walk = &line->walk;
    const uint64_t square = (uint64_t)(glint_product(walk->du, walk->du) + glint_product(walk->dv, walk->dv));
    const int64_t length = glint_square_root(square << 24); /* Q16 */
    if (!length)
        return 0;
    const int32_t u = (int32_t)(((int64_t)walk->du << 32) / length),
                  v = (int32_t)(walk->dv * ((int64_t)1 << 32) / length);
    line->size[0] = (int32_t)(length >> 8);
    line->size[1] = segment->width;
    set_direction(line, 0, segment, walk->is_steep ? v : u, walk->is_steep ? u : v);
    set_direction(line, 1, segment, walk->is_steep ? u : -v, walk->is_steep ? -v : u);
    return 1;
}

/* Returns how much of a pixel is covered in a direction, by its distance from the middle, 1/256. */
static inline int32_t cover_along(int32_t size, int32_t distance) {
    const int32_t from_edge = (size >> 1) + 128 - (distance < 0 ? -distance : distance);
    return glint_most(glint_least_of(256, size, from_edge), 0);
}

/* Blends a pixel that a smooth line covers in part, and whose middle lies so far along it from its middle, Q20. */
static void blend_pixel(const line_target *target, const line_walk *walk, int32_t x, int32_t y, int32_t along_q20,
                        int32_t unit, int32_t part, const int32_t colour[1][3]) {
    const int32_t sixteenths = glint_shift_right(glint_shift_right(along_q20, 14) * glint_shift_right(unit, 8), 14),
                  along = glint_most(glint_least(walk->du / 2 + sixteenths, walk->du), 0);
    glint_canvas canvas;
    uint32_t offset;
    if (!find_nearer(target, x, y, walk->depth + glint_shift_right64(walk->slope * along, 16), &canvas, &offset))
        return;
    const uint32_t old = glint_read_pixel(&canvas, offset);
    store_pixel(&canvas, offset, colour);
    glint_mix_pixel(&canvas, offset, old, (uint32_t)(GLINT_WHOLE - part), 0);
}

static void draw_smooth_segment(const line_target *target, const glint_segment *segment) {
    glint_range range;
    smooth_line line;
    int32_t colour[1][3];
    if (!begin_segment(target->tile, segment, (segment->width >> 5) + 16, &range, colour) ||
        !begin_smooth(target, segment, &line))
        return;
    const int32_t unit = (int32_t)(line.walk.is_steep ? line.dy[0] : line.dx[0]);
    for (int32_t y = range.top; y < range.bottom; y++) {
        uint32_t at[2];
        for (int i = 0; i < 2; i++)
            at[i] = line.at[i] + line.dx[i] * (uint32_t)range.left + line.dy[i] * (uint32_t)y;
        for (int32_t x = range.left; x < range.right; x++, at[0] += line.dx[0], at[1] += line.dx[1]) {
            const int32_t across = cover_along(line.size[1], glint_shift_right((int32_t)at[1], 12));
            if (!across)
                continue;
            const int32_t along = cover_along(line.size[0], glint_shift_right((int32_t)at[0], 12)),
                          part = (along * across + 128) >> 8;
            if (part)
                blend_pixel(target, &line.walk, x, y, (int32_t)at[0], unit, part, (const int32_t(*)[3])colour);
        }
    }
}

/* ---- All lines ---- */

static glint_status draw_lines(const glint_tile *tile, const glint_segment *segments, uint32_t count,
                               void (*draw)(const line_target *target, const glint_segment *segment)) {
    if (!tile || !tile->frame || !tile->workspace || (count && !segments))
        return GLINT_ERROR_NULL;
    const glint_view *const view = tile->frame->view;
    /* This is below 2^55. Parallel rays, whose w may have 54 bits, do not need it. */
    const int64_t nearest =
        view->is_parallel ? 1
                          : view->nearest + view->nearest * (1 << (14 + glint_sample_shift(tile->frame))) / view->focal;
    const int32_t shift = (int32_t)glint_bits64((uint64_t)nearest) - 31;
    const uint32_t mantissa = (uint32_t)(shift > 0 ? nearest >> shift : nearest << -shift);
    const line_target target = {tile, mantissa, shift};
    for (uint32_t i = 0; i < count; i++)
        draw(&target, &segments[i]);
    return GLINT_OK;
}

glint_status glint_lines_draw(const glint_tile *tile, const glint_segment *segments, uint32_t count) {
    return draw_lines(tile, segments, count, draw_segment);
}

glint_status glint_lines_draw_smooth(const glint_tile *tile, const glint_segment *segments, uint32_t count) {
    return draw_lines(tile, segments, count, draw_smooth_segment);
}
