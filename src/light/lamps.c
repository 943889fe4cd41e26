/* SPDX-License-Identifier: MIT */
/* Lamps: sets the lights of a draw, lists the fragments of triangles, and stores them once they are lit; lamps.h. */
#include "lamps.h"

#include "../math/division.h"
#include "../pixel/format.h"
#include "../raster/small.h"
#include "evaluation.h"
#include "wear.h"

/* ---- A draw's lights ---- */

/*
 * Cosines of 15 bits are too coarse for highlights around the half vector from this exponent on. They are off by up to
 * 2^-14, so that a highlight of exponent p is off by up to p 2^-14, which should stay well below a level.
 */
#define NARROW_EXPONENT (120 * GLINT_ONE)

/* Returns a weight, Q12, in levels of `bits` bits, scaled by 2^-headroom and rounded. */
static int32_t weight_in_levels(uint32_t weight, unsigned bits, unsigned headroom) {
    const uint32_t scaled = bits ? weight - ((weight + (1u << (bits - 1))) >> bits) : weight;
    return (int32_t)((scaled + (1u << headroom >> 1)) >> headroom);
}

/*
 * Returns the least n for which colours scaled by 2^-n have a sum below 15, or below 7 if the surface has colours of
 * its own: 32 bits then hold the sum, and its product with these.
 */
static unsigned find_headroom(const glint_shading *shading, int has_colours) {
    unsigned headroom = 0;
    for (int c = 0; c < 3; c++) {
        uint32_t sum = shading->ambient[c] >> 11;
        for (uint32_t i = 0; shading->lights >> i; i++)
            if (shading->lights >> i & 1)
                sum += shading->weights[i].diffuse[c] +
                       (shading->has_specular >> i & 1 ? shading->weights[i].specular[c] : 0);
        while (sum >> headroom >= (has_colours ? 7u : 15u) << 12)
            headroom++;
    }
    return headroom;
}

/* Sets half a level, ambient light, and the colour that fragments begin with. */
static void set_colours(glint_lamps *lamps, const glint_frame *frame) {
    const glint_shading *shading = lamps->shading;
    const uint8_t *bits = frame->config.format->channel;
    const int is_last = !lamps->headroom && !lamps->takes_most && !lamps->has_colours;
    for (int c = 0; c < 3; c++) {
        const unsigned level_bits = frame->config.gamma ? 0 : bits[c];
        const int32_t ambient = (int32_t)((shading->ambient[c] < 15u << 23 ? shading->ambient[c] : 15u << 23) << 4);
        lamps->half[c] = glint_to_levels(0, level_bits);
        lamps->base[c] = glint_to_levels(ambient, level_bits) - (is_last ? 0 : lamps->half[c]);
        lamps->base[c] = glint_shift_right(lamps->base[c], lamps->headroom);
        lamps->first[c] = lamps->takes_most ? 0 : lamps->base[c];
    }
}

/*
 * Sets which highlights and ways are found with all bits. The other highlights are off by up to p / (1 + L.V) steps of
 * 2^-15, as their cosines have 15 bits.
 */
static void set_highlights(glint_lamps *lamps, int has_8_bits) {
    const int32_t p = glint_shift_right(glint_least(lamps->shading->power.exponent, NARROW_EXPONENT), 16);
    lamps->near = has_8_bits ? 15u << 22 : 1u << 20;
    lamps->nearest = has_8_bits ? lamps->near : 1u << 18;
    const glint_power_table *power = &lamps->shading->power;
    const int is_mirror = lamps->shading->material->model->lobe == GLINT_LOBE_MIRROR;
    const int32_t narrow = NARROW_EXPONENT >> (is_mirror + has_8_bits);
    lamps->is_rare = power->direct || power->exponent >= narrow;
    lamps->power = power->value;
    lamps->power_up = (31 - power->index_shift) & 31;
    lamps->cut = 2 * (uint32_t)glint_most(power->cosine_square_floor, 0);
    lamps->least_half_square = glint_most(1 << 10, p << 8);
    lamps->usual_half_square = lamps->is_rare ? INT32_MAX : lamps->least_half_square;
}

/* Sets the numbers of a lamp that depend on its light alone. */
static GLINT_INLINE void set_source(glint_drawn_lamp *to, const glint_prepared_light *source) {
    to->source = source;
    to->has_cone = source->type->has_cone;
    to->has_place = source->type->has_place;
    to->linear = source->lamp.linear;
    to->quadratic = source->lamp.quadratic;
    if (to->has_cone) {
        to->cone_outer = glint_shift_right(source->spot.cosine_outer, 14);
        to->cone_width = glint_shift_right(source->spot.cosine_inner, 14) - to->cone_outer;
        to->over_width = (1u << 30) / (uint32_t)glint_most(to->cone_width, 1);
    }
    to->weakens = 0;
}

/* N.D may be off by this, whatever the length of D. */
#define GATE_MARGIN (4 << 15)

/* Sets the lights of a draw in the walk's tile. */
static GLINT_NOINLINE void set_lamps(glint_row_walk *walk) {
    const glint_frame *frame = walk->frame;
    const glint_view *view = frame->view;
    const glint_draw *draw = walk->draw;
    const glint_shading *shading = draw->shading;
    const glint_window *window = &walk->part->window;
    const uint8_t *bits = frame->config.format->channel;
    glint_lamps *lamps = walk->workspace->lamps;
    glint_drawn_lamp *to = lamps->lamps;
    walk->lit = draw;
    lamps->shading = shading;
    lamps->gate = shading->material->flags & GLINT_MATERIAL_SPECULAR_UNGATED ? INT32_MIN : 0;
    lamps->near_gate = lamps->gate ? lamps->gate : -GATE_MARGIN;
    lamps->far_gate = lamps->gate ? lamps->gate : GATE_MARGIN;
    lamps->takes_most = (shading->material->flags & GLINT_MATERIAL_MAX_WITH_AMBIENT) != 0;
    lamps->has_colours = draw->extra || draw->texture;
    lamps->is_local = view->local_viewer;
    lamps->least_view = view->local_viewer ? 1u << 28 : UINT32_MAX;
    set_highlights(lamps, glint_green_bits(frame->config.format) > 6);
    lamps->headroom = (uint8_t)find_headroom(shading, lamps->has_colours);
    lamps->needs_w = draw->extra != 0;
    lamps->has_gloss = 0;
    lamps->placed = 0;
    lamps->unit = 32;
    lamps->step = 2 * view->ray_scale;
    const int32_t half = 1 << 11;
    lamps->x = (frame->config.width - glint_shift_right(window->left, 3)) * view->ray_scale + half;
    lamps->y = (glint_shift_right(window->top, 3) - frame->config.height) * view->ray_scale + half;
    lamps->z = (int32_t)glint_shift_right64(glint_product(view->focal, view->ray_scale), 12) + half;
    set_colours(lamps, frame);
    lamps->is_mixed = lamps->has_colours | lamps->takes_most | (lamps->headroom != 0);
    const uint32_t lights = shading->lights & ~draw->unreached;
    for (uint32_t i = 0; lights >> i; i++) {
        const glint_prepared_light *source = &view->lights[i];
        if (!(lights >> i & 1))
            continue;
        set_source(to, source);
        to->shines = shading->has_specular >> i & 1;
        for (int c = 0; c < 3; c++) {
            const unsigned level_bits = frame->config.gamma ? 0 : bits[c];
            to->diffuse[c] = weight_in_levels(shading->weights[i].diffuse[c], level_bits, lamps->headroom);
            to->specular[c] = weight_in_levels(shading->weights[i].specular[c], level_bits, lamps->headroom);
            to->place[c] = source->direction[c] + glint_shift_right(source->direction[c], 13);
        }
        lamps->has_gloss |= to->shines;
        if (to->has_place) {
            lamps->needs_w = 1;
            lamps->placed = source->type->places;
        }
        to++;
    }
    lamps->count = (uint32_t)(to - lamps->lamps);
}

/* ---- Fragments ---- */

GLINT_NOINLINE uint32_t glint_lengthen_view(glint_lit_view *view, uint32_t square) {
    const unsigned up = (glint_leading_zeros(square) - 2) >> 1;
    for (int c = 0; c < 3; c++)
        view->v[c] = glint_shift_left(view->v[c], up);
    return square << 2 * up;
}

/* Sets the octave of 1/w that fits the lamps' unit; there is none where rays are parallel. */
static void set_octave(const glint_row_walk *walk) {
    glint_lamps *lamps = walk->workspace->lamps;
    lamps->up = (uint32_t)(16 - lamps->unit) - walk->list->room;
    lamps->least_w = lamps->up > 31 || walk->frame->view->is_parallel ? 0 : 0x80000000u >> lamps->up;
}

void glint_set_lamps_unit(const glint_row_walk *walk, int32_t unit) {
    glint_lamps *lamps = walk->workspace->lamps;
    if (unit != lamps->unit) {
        lamps->unit = unit;
        if (lamps->placed)
            lamps->placed->bring_to_unit(lamps);
    }
    set_octave(walk);
}

GLINT_NOINLINE void glint_light_listed(const glint_row_walk *walk) {
    glint_lamp_list *list = walk->list;
    const glint_config *config = &walk->frame->config;
    glint_lit_fragment *f = list->pixels.fragment;
    const uint32_t count = list->count;
    list->count = 0;
    list->light(walk, f, f + count);
    for (uint32_t i = 0; config->gamma && i < count; i++)
        glint_finish_colours(config, &f[i].out.colour, 1);
    config->format->store_list(walk->pixels, walk->shift, &f->out, sizeof *f, count);
}

/* ---- Triangles ---- */

/* Returns x 2^n modulo 2^32, rounded down. */
static inline uint32_t scale_slope(int32_t x, int32_t n) {
    return n < 0 ? (uint32_t)glint_shift_right(x, (unsigned)-n) : (uint32_t)x << n;
}

/* Returns a sum of products of differences, Q18, times 1/area of 16 bits. */
static inline int32_t divide_by_area(int32_t sum, const glint_area *area) {
    return glint_shift_right(sum, 15) * area->reciprocal +
           (int32_t)((uint32_t)((sum & 0x7fff) * area->reciprocal) >> 15);
}

/* Returns the sides of a small triangle. */
static inline glint_sides sides_of(const glint_corners *corners) {
    return (glint_sides){
        glint_x_of(corners->b) - glint_x_of(corners->a), glint_y_of(corners->b) - glint_y_of(corners->a),
        glint_x_of(corners->c) - glint_x_of(corners->a), glint_y_of(corners->c) - glint_y_of(corners->a)};
}

/* Returns the numbers of a triangle's corners, in the order that set_plane expects. */
static inline const uint8_t *order_of(const glint_row_walk *walk) {
    return glint_corner_order(walk->has_slopes ? walk->corners.top : 0);
}

/*
 * Sets the plane of an attribute that is a, b, c at the corners; it starts at the tile's first pixel. For small
 * triangles, slopes are exact sums of products, of differences of 18 bits, times 1/area of 16 bits: at a pixel of the
 * triangle the plane is off by at most 2^-15 of the corners' difference.
 */
static inline void set_plane(const glint_row_walk *walk, const glint_sides *sides, glint_plane *to, int32_t a,
                             int32_t b, int32_t c) {
    const glint_corners *corners = &walk->corners;
    if (!walk->has_slopes) {
        glint_plane_begin(to, &walk->part->gradients, a, b, c);
        to->start = glint_plane_at(to, walk->part->x, walk->part->y);
        return;
    }
    const int32_t to_b = b - a, to_c = c - a;
    const uint32_t zeros = glint_leading_zeros(glint_magnitude_bits(to_b) | glint_magnitude_bits(to_c));
    const uint32_t down = zeros < 14 ? 14 - zeros : 0;
    const int32_t d1 = glint_shift_right(to_b, down), d2 = glint_shift_right(to_c, down);
    const int32_t x = divide_by_area(d2 * sides->dy1 - d1 * sides->dy2, &corners->area),
                  y = divide_by_area(d1 * sides->dx2 - d2 * sides->dx1, &corners->area);
    const int32_t to_center = glint_shift_right(x, 5) * (~glint_x_of(corners->a) & 15) +
                              glint_shift_right(y, 5) * (~glint_y_of(corners->a) & 15);
    const int32_t up = (int32_t)(corners->area.zeros + down) - 28;
    to->dx = (int32_t)scale_slope(x, up);
    to->dy = (int32_t)scale_slope(y, up);
    to->start =
        (int32_t)((uint32_t)a + scale_slope(to_center, up + 1) - (uint32_t)to->dx * (uint32_t)walk->slopes.column -
                  (uint32_t)to->dy * (uint32_t)walk->slopes.row);
}

void glint_set_fine_w(glint_row_walk *walk) {
    const glint_sides sides = sides_of(&walk->corners);
    const uint8_t *order = order_of(walk);
    int32_t w[3];
    for (int i = 0; i < 3; i++)
        w[i] = (int32_t)((uint32_t)walk->triangle.corners[order[i]]->inverse_w << walk->list->up >> 1);
    set_plane(walk, &sides, &walk->w, w[0], w[1], w[2]);
    walk->list->has_w = 1;
}

/* A corner's attributes, and 1/w of 30 bits in two halves. */
typedef struct weighed_corner {
    const int16_t *attributes;
    int32_t high, low;
} weighed_corner;

static inline weighed_corner weigh_corner(const glint_row_walk *walk, const int16_t *attributes, uint32_t corner,
                                          int32_t sign) {
    const uint32_t w = (uint32_t)walk->triangle.corners[corner]->inverse_w << walk->list->up;
    return (weighed_corner){attributes, sign * (int32_t)(w >> 16), sign * (int32_t)(w >> 1 & 0x7fff)};
}

/* Returns an attribute of 15 bits over w, 30 bits: precise also at a corner that is much farther than the nearest. */
static inline int32_t attribute_over_w(const weighed_corner *corner, int c) {
    return corner->attributes[c] * corner->high + glint_shift_right(corner->attributes[c] * corner->low, 15);
}

/* Sets the planes of three attributes over w, times `sign`. */
static GLINT_NOINLINE void set_planes(const glint_row_walk *walk, glint_plane planes[3],
                                      const int16_t *const attributes[3], int32_t sign) {
    const glint_sides sides = sides_of(&walk->corners);
    const uint8_t *order = order_of(walk);
    const weighed_corner p = weigh_corner(walk, attributes[order[0]], order[0], sign),
                         q = weigh_corner(walk, attributes[order[1]], order[1], sign),
                         r = weigh_corner(walk, attributes[order[2]], order[2], sign);
    for (int c = 0; c < 3; c++)
        set_plane(walk, &sides, &planes[c], attribute_over_w(&p, c), attribute_over_w(&q, c), attribute_over_w(&r, c));
}

GLINT_HOT void glint_list_span(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_lamp_list *const list = walk->list;
    glint_lit_fragment *f = &list->pixels.fragment[list->count];
    uint32_t z = glint_z_at(walk, row, left), position = ((uint32_t)row << 16) + (uint32_t)left,
             pixel = ((uint32_t)row << walk->shift) + (uint32_t)left;
    uint8_t *depth = (uint8_t *)(walk->depth + ((uint32_t)row << walk->shift) + left), *const end =
                                                                                           depth + 2 * (right - left);
    for (;;) {
        const uint32_t here = (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS);
        if (glint_is_nearest(depth, here)) {
            f->position = position;
            f->unseen = 0;
            f->out.pixel = pixel;
            f->inverse_w = (int32_t)(here - GLINT_DEPTH_BIAS) | 1;
            if (++f == &list->pixels.fragment[GLINT_LIST_MAX]) {
                list->count = GLINT_LIST_MAX;
                glint_light_listed(walk);
                f = list->pixels.fragment;
            }
        }
        depth += 2;
        if (depth == end)
            break;
        position++;
        pixel++;
        z += (uint32_t)walk->z.dx;
    }
    list->count = (uint32_t)(f - list->pixels.fragment);
}

/* Returns whether a plane may exceed 32 bits a few pixels outside of the triangle. */
static inline int is_steep_plane(const glint_plane *p) {
    const int32_t most = 1 << 25;
    return p->dx > most || p->dx < -most || p->dy > most || p->dy < -most;
}

/* Highlights of this exponent and above are so narrow that nodes of cells may miss them. */
#define CELLS_EXPONENT (60 * GLINT_ONE)

/* Returns whether the normals of a triangle's corners are about 37 degrees apart, or more: then the square of their
 * sum is below 8.2. */
static int turns_fast(const glint_row_walk *walk) {
    const glint_vertex *const *v = walk->triangle.corners;
    uint32_t square = 0;
    for (int c = 0; c < 3; c++) {
        const int32_t sum = glint_shift_right(v[0]->attribute[c] + v[1]->attribute[c] + v[2]->attribute[c], 2);
        square += (uint32_t)(sum * sum); /* Q26 */
    }
    return square < (41u << 26) / 5;
}

/* Returns whether a highlight may lie between nodes, none of which sees it: a narrow one, one where normals turn fast,
 * or one that shines through a surface, as half vectors turn fast where the light is straight behind it. */
static int may_miss_highlights(const glint_row_walk *walk) {
    const glint_lamps *lamps = walk->workspace->lamps;
    return lamps->has_gloss && (lamps->gate || lamps->shading->power.exponent >= CELLS_EXPONENT || turns_fast(walk));
}

/*
 * Returns whether light may be interpolated between nodes of cells: the triangle is large, its planes keep within 32
 * bits as far outside of it as nodes lie, and nodes miss no highlight.
 */
static int may_have_cells(const glint_row_walk *walk) {
    const glint_vertex *const *v = walk->triangle.corners;
    const glint_lamps *lamps = walk->workspace->lamps;
    const glint_format *format = walk->frame->config.format;
    if (walk->is_deep || (walk->draw->texture && (lamps->takes_most || lamps->headroom)) || walk->frame->config.gamma ||
        (format->is_dithered && glint_green_bits(format) > 6)) /* nodes have no room for their thresholds */
        return 0;
    if (is_steep_plane(&walk->channel[0]) || is_steep_plane(&walk->channel[1]) || is_steep_plane(&walk->channel[2]) ||
        is_steep_plane(&walk->z) || (walk->list->room && is_steep_plane(&walk->w)))
        return 0;
    return glint_magnitude_bits(glint_double_area(v[0], v[1], v[2])) >= 512 * GLINT_CELLS_LEAST &&
           !may_miss_highlights(walk);
}

GLINT_NOINLINE void glint_begin_lamp_list(glint_row_walk *walk) {
    glint_lamp_list *list = walk->list;
    if (walk->lit != walk->draw)
        set_lamps(walk);
    walk->workspace->lamps->walk = walk;
    list->up = glint_find_room(walk->triangle.corners);
    list->room = 0;
    list->has_w = list->lights_nodes = 0;
    set_octave(walk);
    if (walk->draw->extra)
        set_planes(walk, list->surface, walk->triangle.extra, 1);
}

/* Corners count as facing away from a light if N.D is below 0 by this or more: rounding is less. */
#define DARK_MARGIN (16 << 14)

/*
 * Returns whether some fragment of a triangle may face a light. N.D over w^2 is a quadratic on the screen, whose values
 * lie between the nine products of the corners' N and the corners' D: it is below 0 everywhere if all these are.
 */
static int may_face(const glint_row_walk *walk, const glint_drawn_lamp *lamp, const int32_t e[3][3]) {
    for (int j = 0; j < 3; j++) {
        int32_t x = lamp->place[0], y = lamp->place[1], z = lamp->place[2];
        if (lamp->has_place) {
            x += glint_shift_right(e[j][0], lamp->down);
            y += glint_shift_right(e[j][1], lamp->down);
            z += glint_shift_right(e[j][2], lamp->down);
        }
        x = glint_shift_right(x, 1), y = glint_shift_right(y, 1), z = glint_shift_right(z, 1);
        for (int i = 0; i < 3; i++) {
            const int16_t *const n = walk->triangle.corners[i]->attribute;
            const int32_t cosine = n[0] * x + n[1] * y + n[2] * z;
            if ((walk->triangle.back ? -cosine : cosine) > -DARK_MARGIN)
                return 1;
        }
    }
    return 0;
}

/* In triangles of this many pixels, skipping lights that they do not face saves more than finding these costs. */
#define FACING_LEAST 32

/* Lists the lights that a triangle may face. */
static GLINT_NOINLINE void find_faced(const glint_row_walk *walk) {
    const glint_vertex *const *v = walk->triangle.corners;
    glint_lamps *lamps = walk->workspace->lamps;
    const int looks = !lamps->gate && glint_magnitude_bits(glint_double_area(v[0], v[1], v[2])) >= 512 * FACING_LEAST;
    int32_t e[3][3];
    const int32_t zeros = looks && lamps->placed ? lamps->placed->find_corner_ways(walk, e) : -1;
    const int has_ways = zeros >= 0;
    if (has_ways)
        glint_set_lamps_unit(walk, 16 - zeros);
    lamps->directional = lamps->positional = 0;
    for (glint_drawn_lamp *lamp = lamps->lamps + lamps->count; lamp != lamps->lamps;) {
        lamp--;
        const glint_drawn_lamp **first = GLINT_SMALL || lamp->has_place ? &lamps->positional : &lamps->directional;
        if (looks && (has_ways || !lamp->has_place) && !may_face(walk, lamp, (const int32_t(*)[3])e))
            continue;
        lamp->next = *first;
        *first = lamp;
    }
}

/* Sets the lights and planes of a triangle that is visible, and chooses what draws its spans. */
static GLINT_NOINLINE void begin_list(glint_row_walk *walk) {
    const glint_triangle *triangle = &walk->triangle;
    const glint_vertex *const *v = triangle->corners;
    const int16_t *const normals[3] = {v[0]->attribute, v[1]->attribute, v[2]->attribute};
    glint_lamp_list *list = walk->list;
    glint_begin_lamp_list(walk);
    const unsigned up = list->up;
    if (up > 3 && walk->workspace->lamps->needs_w) {
        glint_set_fine_w(walk);
        list->room = up - 1;
        set_octave(walk);
    }
    set_planes(walk, walk->channel, normals, triangle->back ? -1 : 1);
    for (int c = 0; c < 3; c++)
        walk->channel[c].start = glint_add_wrap(walk->channel[c].start, 1 << 14); /* cutting off 15 bits rounds */
    find_faced(walk);
    walk->draw_span = glint_list_span;
    if (may_have_cells(walk))
        walk->draw_span = glint_keep_span;
    else
        glint_leave_holes(walk);
}

/* Draws spans until a pixel passes the depth test: triangles that are hidden need no set-up of lights. */
static void find_visible_fragment(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    const uint16_t *depth = walk->depth + ((uint32_t)row << walk->shift) + left;
    uint32_t z = glint_z_at(walk, row, left);
    for (; (uint32_t)glint_most((int32_t)z, GLINT_DEPTH_BIAS) >> 15 <= *depth; depth++, z += (uint32_t)walk->z.dx)
        if (++left == right)
            return;
    begin_list(walk);
    walk->draw_span(walk, row, left, right);
}

/* Draws the first span of a triangle. */
static void begin_fragments(glint_row_walk *walk, int32_t row, int32_t left, int32_t right) {
    glint_begin_depth(walk);
    walk->draw_span = find_visible_fragment;
    find_visible_fragment(walk, row, left, right);
}

void glint_draw_lamps(glint_row_walk *walk) {
    glint_lamp_list *list = walk->list;
    list->count = 0;
    list->top = list->bottom = 0;
    list->light = glint_lamps_light;
    walk->draw_span = begin_fragments;
    glint_walk_triangle(walk);
    if (list->bottom) {
        glint_leave_holes(walk); /* a texture begins here, where the stack is less deep than in cells */
        glint_draw_cells(walk);
    }
    if (list->count)
        glint_light_listed(walk);
}
