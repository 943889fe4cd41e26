/* SPDX-License-Identifier: MIT */
/*
 * Need of objects turned any way about their origins, by spheres about these. A triangle whose longest edge is d, no
 * part of which is nearer than w, spans at most g d / w pixels of the screen along an axis, f being the focal length
 * and g^2 = f^2 + (half of the screen)^2: of points P and Q of an edge, of which Q lies on the screen, x_p - x_q is f
 * (X_p - X_q - (X_q / w_q) (w_p - w_q)) / w_p. Lengths are Q28 2^-down.
 */
#include "../geometry/layout.h"
#include "need.h"

/* A camera's axes are unit and perpendicular to 2^-9: lengths grow by less than 2^-CAMERA. */
#define CAMERA 8

/* An object where it stands, however it is turned. */
typedef struct turned_object {
    int64_t axis[3][3]; /* [row][column], of 2^15 steps: below 2^40 */
    int64_t offset[3];
    int64_t rounding[4]; /* of axes and offset: what two steps of a pose's entries make of each */
    unsigned down;
    int64_t w, near_plane;                 /* w of the origin */
    int64_t same_w;                        /* of parallel rays, of all; else 0 */
    int64_t to_near, to_band, into_screen; /* how far the origin is from what clips, and from the screen's edges */
    int64_t focal[2];                      /* g of x and y, pixels, Q4 */
} turned_object;

/* No less than |v|, components below 2^61. */
static int64_t length_above(const int64_t v[3]) {
    uint64_t bits = 0, square = 0;
    for (int i = 0; i < 3; i++)
        bits |= glint_magnitude64(v[i]);
    const unsigned size = glint_bits64(bits), shift = size > 31 ? size - 31 : 0;
    for (int i = 0; i < 3; i++) {
        const uint64_t part = (glint_magnitude64(v[i]) >> shift) + (shift > 0);
        square += part * part; /* below 2^63.6 */
    }
    return ((int64_t)glint_square_root(square) + 1) * ((int64_t)1 << shift);
}

static int64_t farther_of(int64_t a, int64_t b) {
    return a > b ? a : b;
}

static int64_t nearer_of(int64_t a, int64_t b) {
    return a < b ? a : b;
}

/* Pose times extent and offset. Entries of a turned pose are rounded anew, a column of them by less than two steps. */
static void set_axes(turned_object *t, const glint_object *object) {
    const glint_mesh *mesh = object->mesh;
    const int32_t extent[3] = {mesh->extent.x, mesh->extent.y, mesh->extent.z};
    const int32_t offset[3] = {mesh->offset.x, mesh->offset.y, mesh->offset.z};
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++) {
        t->offset[i] = 0;
        for (int j = 0; j < 3; j++) {
            t->axis[i][j] = glint_round_shift64(glint_product(object->pose.m[i][j], extent[j]), 4);
            t->offset[i] += glint_round_shift64(glint_product(object->pose.m[i][j], offset[j]), 4);
            bits |= glint_magnitude64(t->axis[i][j]);
        }
        bits |= glint_magnitude64(t->offset[i]);
    }
    const unsigned size = glint_bits64(bits);
    t->down = size > 40 ? size - 40 : 0;
    t->rounding[3] = 0;
    for (int j = 0; j < 3; j++) {
        for (int i = 0; i < 3; i++)
            t->axis[i][j] = glint_shift_right64(t->axis[i][j], t->down);
        t->offset[j] = glint_shift_right64(t->offset[j], t->down);
        t->rounding[j] = (extent[j] >> 3 >> t->down) + 2; /* two steps of Q16 are 2^-3 of a Q16 number, Q28 */
        t->rounding[3] += (int64_t)(glint_magnitude64(offset[j]) >> 3 >> t->down) + 2;
    }
}

/* No less than the distance from the origin of so many steps, or the length of so many without the offset. */
static int64_t measure_steps(const turned_object *t, const int32_t steps[3], int is_place) {
    int64_t v[3], rounding = is_place * t->rounding[3] * (1 << 15);
    for (int i = 0; i < 3; i++) {
        v[i] = is_place * t->offset[i] * (1 << 15);
        for (int j = 0; j < 3; j++)
            v[i] += t->axis[i][j] * steps[j]; /* below 2^59 */
        rounding += t->rounding[i] * (int64_t)glint_magnitude64(steps[i]);
    }
    const int64_t length = length_above(v) + rounding;
    return (length >> 15) + (length >> (15 + CAMERA)) + 2;
}

/* The farthest corner of the mesh's box. */
static int64_t find_radius(const turned_object *t) {
    int64_t most = 0;
    for (int corner = 0; corner < 8; corner++) {
        const int32_t steps[3] = {corner & 1 ? 1 << 15 : -(1 << 15), corner & 2 ? 1 << 15 : -(1 << 15),
                                  corner & 4 ? 1 << 15 : -(1 << 15)};
        most = farther_of(most, measure_steps(t, steps, 1));
    }
    return most;
}

/* The longest edge of a triangle, and its farthest corner. */
static int64_t find_edge(const turned_object *t, const glint_mesh *mesh, const uint16_t *corners, int64_t *reach) {
    int64_t most = 0;
    *reach = 0;
    for (int i = 0; i < 3; i++) {
        int16_t fetched[2][3];
        const int16_t *a = glint_steps_of(mesh, corners[i], fetched[0]),
                      *b = glint_steps_of(mesh, corners[(i + 1) % 3], fetched[1]);
        const int32_t place[3] = {a[0], a[1], a[2]}, edge[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
        *reach = farther_of(*reach, measure_steps(t, place, 1));
        most = farther_of(most, measure_steps(t, edge, 0));
    }
    return most;
}

/* How far (x, w), x from 0 up, lies within x focal = w half; a little less. Half pixels, Q12. */
static int64_t find_depth(int64_t x, int64_t w, int32_t focal, int32_t half) {
    const unsigned size = glint_bits64((uint64_t)x | glint_magnitude64(w)), shift = size > 32 ? size - 32 : 0;
    const int64_t length = (int64_t)glint_square_root((uint64_t)((int64_t)focal * focal + (int64_t)half * half)) + 1;
    const int64_t product = glint_shift_right64(w, shift) * half - ((x >> shift) + 1) * focal; /* below 2^62 */
    return (product / length - 3) * ((int64_t)1 << shift);
}

/* The same of an object's origin, or of parallel rays, to which half a screen is as wide everywhere. */
static int64_t find_inside(const turned_object *t, int64_t x, int32_t focal, int32_t half) {
    if (!t->same_w)
        return find_depth(x, t->w, focal, half);
    const unsigned size = glint_bits64((uint64_t)t->same_w), shift = size > 39 ? size - 39 : 0;
    return (t->same_w >> shift) * half / focal * ((int64_t)1 << shift) - x - (x >> CAMERA) - 3 * ((int64_t)1 << shift);
}

static void set_place(turned_object *t, const glint_frame *frame, const glint_object *object) {
    const glint_view *view = frame->view;
    int64_t at[3];
    for (int i = 0; i < 3; i++) {
        at[i] = 0;
        for (int j = 0; j < 3; j++) /* Q32, below 2^51 */
            at[i] += ((int64_t)object->pose.m[j][3] - view->eye[j]) * view->rotation[i][j];
        at[i] = glint_shift_right64(at[i], 4 + t->down);
    }
    t->w = -at[2];
    t->near_plane = view->near_plane >> t->down;
    t->same_w = view->is_parallel ? (view->nearest >> t->down) + 1 : 0;
    t->to_near = t->w - t->near_plane - (t->near_plane >> 12) - 16;
    for (int axis = 0; axis < 2; axis++) {
        const int32_t half = axis ? frame->config.height : frame->config.width, band = 2 * GLINT_GUARD_BAND - 2;
        const int64_t x = (int64_t)glint_magnitude64(at[axis]), short_focal = view->focal >> 9;
        const int64_t to_band = find_inside(t, x, view->focal, band << 12),
                      into_screen = find_inside(t, x, view->focal, (half + 2) << 12);
        t->to_band = axis ? nearer_of(t->to_band, to_band) : to_band;
        t->into_screen = axis ? nearer_of(t->into_screen, into_screen) : into_screen;
        t->focal[axis] = glint_square_root((uint64_t)(short_focal * short_focal + 64 * (int64_t)half * half)) + 2;
    }
}

/* No less than the sixteenths of a pixel that a length spans along an axis, where it is seen, no nearer than that. */
static uint32_t span_of_length(const turned_object *t, int64_t length, int64_t reach, int axis) {
    const int64_t nearest = t->same_w ? t->same_w - 1 : farther_of(t->w - reach, t->near_plane - (t->near_plane >> 12));
    const unsigned size = glint_bits64((uint64_t)length), shift = size > 40 ? size - 40 : 0;
    const uint64_t w = (uint64_t)farther_of(nearest, 0) >> shift, d = ((uint64_t)length >> shift) + 1;
    if (d >> 15 >= w) /* Q22 below 2^38, times 2^21 at most */
        return INT32_MAX;
    const uint64_t span = ((d << 22) / w + 1) * (uint64_t)t->focal[axis] >> 22;
    return span < INT32_MAX ? (uint32_t)span + 1 : INT32_MAX;
}

/* May a length, some of it on the screen, pass the guard band? */
static int passes_band(const glint_frame *frame, const turned_object *t, int64_t length, int64_t reach) {
    const uint32_t x = span_of_length(t, length, reach, 0), y = span_of_length(t, length, reach, 1);
    return reach > t->to_band && (x + 8u * frame->config.width >= 16 * (GLINT_GUARD_BAND - 1) ||
                                  y + 8u * frame->config.height >= 16 * (GLINT_GUARD_BAND - 1));
}

/* Of so many rows or columns of tiles, how many a span may touch; a corner is off by up to 2/16 of a pixel. */
static size_t find_touched(uint32_t span, unsigned shift, size_t count) {
    const size_t touched = ((size_t)span + 4) / ((size_t)16 << shift) + 2;
    return touched < count ? touched : count;
}

static void count_turned_triangle(const glint_frame *frame, const turned_object *t, int64_t edge, int64_t reach,
                                  glint_tally *sum) {
    const size_t columns = frame->tile_columns, quarter = glint_quarter_of_tiles(frame),
                 tiles =
                     find_touched(span_of_length(t, edge, reach, 0), frame->tile_shift_x, columns) *
                     find_touched(span_of_length(t, edge, reach, 1), frame->tile_shift_y, frame->tile_count / columns);
    size_t parts = reach > t->to_near ? 2 : 1;
    if (passes_band(frame, t, edge, reach))
        parts = GLINT_CLIP_CORNERS - 2;
    sum->references += parts * tiles;
    sum->of_quarter[0] += parts * (tiles < quarter ? tiles : quarter);
    sum->clipped += parts > 1 ? parts : 0;
}

static GLINT_NOINLINE glint_status count_turned(glint_frame *frame, const glint_object *object, glint_tally *sum) {
    const glint_mesh *mesh = object->mesh;
    glint_transform transform;
    turned_object t;
    glint_transform_prepare(&transform, frame->view, &frame->config, object); /* the view had no error */
    glint_transform_place(&transform, frame->view);
    if (object->hidden || transform.skipped)
        return GLINT_OK;
    set_axes(&t, object);
    set_place(&t, frame, object);
    const int64_t radius = find_radius(&t), outside = radius + (radius >> 12) + ((int64_t)1 << 10);
    if (t.w + outside < t.near_plane || t.into_screen + outside < 0)
        return GLINT_OK; /* hidden whichever way it is turned */
    const int clips = radius > t.to_near || passes_band(frame, &t, 2 * radius, radius);
    transform.clips = (uint8_t)((transform.clips & GLINT_PARALLEL) | (unsigned)clips);
    sum->vertices += glint_need_object(frame, object, &transform);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        uint16_t fetched[3];
        const uint16_t *corners = glint_triangle_of(mesh, i, fetched);
        int64_t reach;
        if (corners[0] >= mesh->vertex_count || corners[1] >= mesh->vertex_count || corners[2] >= mesh->vertex_count)
            return GLINT_ERROR_INDEX;
        const int64_t edge = find_edge(&t, mesh, corners, &reach);
        count_turned_triangle(frame, &t, edge, reach, sum);
    }
    return GLINT_OK;
}

glint_status glint_arena_need_turned(const glint_config *config, const glint_scene *scene, glint_need *need) {
    if (!config || !scene || !need)
        return GLINT_ERROR_NULL;
    glint_frame frame;
    glint_whole_view whole;
    glint_tally sum;
    glint_status status = glint_need_begin(&frame, &whole.view, config, scene, &sum);
    for (uint32_t i = 0; i < scene->object_count && status == GLINT_OK; i++)
        status = count_turned(&frame, &scene->objects[i], &sum);
    if (status == GLINT_OK)
        glint_need_end(&frame, &sum, need);
    return status;
}
