/* SPDX-License-Identifier: MIT */
/* Corners: what those of a triangle tell of its light, which lights shine on it and whose highlights show. */
#include "corners.h"

#include "nearness.h"

/* |a - b|^2 on the screen, 28.4. */
static inline uint32_t screen_square(const glint_vertex *a, const glint_vertex *b) {
    const int32_t x = a->x - b->x, y = a->y - b->y;
    return (uint32_t)(x * x) + (uint32_t)(y * y);
}

uint32_t glint_find_longest(const glint_vertex *const corners[3]) {
    uint32_t most = screen_square(corners[0], corners[1]);
    const uint32_t b = screen_square(corners[1], corners[2]), c = screen_square(corners[2], corners[0]);
    most = b > most ? b : most;
    return glint_root_above(c > most ? c : most);
}

static inline void measure(uint32_t pixel, const glint_triangle *triangle, glint_candidate *t) {
    glint_region *region = &t->region;
    const glint_vertex *const *v = triangle->corners;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    t->apart[0] = glint_square_apart(a, b);
    t->apart[1] = glint_square_apart(b, c);
    t->apart[2] = glint_square_apart(a, c);
    const int32_t turn = glint_most_of(t->apart[0], t->apart[1], t->apart[2]);
    region->turn = glint_root_above((uint32_t)turn >> 2);
    const glint_w_range w = glint_find_w_range(v);
    glint_region_measure(pixel, glint_find_longest(v), &w, region);
}

/* Where a highlight lies at the corners. */
static inline glint_lobe_range find_lobe_range(const uint8_t at[GLINT_NUMBERS], const glint_candidate *t) {
    const uint8_t x = at[GLINT_LOBE_X], y = at[GLINT_LOBE_Y];
    glint_lobe_range range = glint_lobe_range_of(t->kept[0][x], t->kept[0][y]);
    glint_lobe_range_take(&range, t->kept[1][x], t->kept[1][y]);
    glint_lobe_range_take(&range, t->kept[2][x], t->kept[2][y]);
    return range;
}

/* Which highlights among some show. */
static void find_lobes(const glint_shading *shading, uint32_t lobes, glint_candidate *t) {
    for (uint32_t l = 0; lobes >> l; l++)
        if (lobes >> l & 1) {
            const glint_lobe_bounds bounds = glint_find_lobe_bounds(shading, glint_lobe_bulge(shading, &t->region, l));
            const glint_lobe_range range = find_lobe_range(shading->terms->at[l], t);
            glint_region_add_lobe(shading, &bounds, l, &range, &t->region);
        }
}

/* How near a light is to the corners at most; of one with a position how strong, and on which side. */
static void find_corners_nearness(uint32_t l, const uint8_t at[GLINT_NUMBERS], glint_candidate *t) {
    const int16_t *const a = t->kept[0], *const b = t->kept[1], *const c = t->kept[2];
    const uint8_t nearness = at[GLINT_NEARNESS], strength = at[GLINT_STRENGTH], side = at[GLINT_SIDE];
    t->region.nearness[l] = (uint16_t)glint_nearness_of_both(
        glint_nearness_of_both((uint16_t)a[nearness], (uint16_t)b[nearness]), (uint16_t)c[nearness]);
    if (!strength)
        return;
    t->region.strength[l] = (uint16_t)glint_most_of(a[strength], b[strength], c[strength]);
    t->region.side_least[l] = (int16_t)glint_least_of(a[side], b[side], c[side]);
    t->region.side_most[l] = (int16_t)glint_most_of(a[side], b[side], c[side]);
}

/* A colour at the middle of an edge, which is linear over w. */
static int16_t between(int32_t a, int32_t b, int32_t wa, int32_t wb) {
    return (int16_t)(a == b ? a >> 1 : (a * (wa >> 1) + b * (wb >> 1)) / (wa + wb));
}

/* Sets the surface's colours at the nodes. @return by how much they differ, Q12 */
static uint32_t find_surface(const glint_triangle *triangle, glint_candidate *t) {
    int32_t apart = 0, w[3];
    const glint_vertex *const *v = triangle->corners;
    const unsigned zeros =
        glint_leading_zeros((uint32_t)v[0]->inverse_w | (uint32_t)v[1]->inverse_w | (uint32_t)v[2]->inverse_w);
    for (int i = 0; i < 3; i++)
        w[i] = (int32_t)((uint32_t)v[i]->inverse_w << zeros >> 17);
    for (int c = 0; c < 3; c++) {
        const int32_t a[3] = {triangle->extra[0][c], triangle->extra[1][c], triangle->extra[2][c]};
        for (int i = 0; i < 3; i++) {
            const int from = glint_ends[i][0], to = glint_ends[i][1];
            t->surface[i][c] = (int16_t)((a[i] + 1) >> 1);
            t->surface[3 + i][c] = between(a[from] + 1, a[to] + 1, w[from], w[to]);
        }
        apart = glint_most(apart, glint_most_of(a[0], a[1], a[2]) - glint_least_of(a[0], a[1], a[2]));
    }
    return (uint32_t)apart >> 3;
}

glint_reach glint_reach_of(const glint_draw *draw, const glint_region *region, int is_known) {
    const glint_shading *shading = draw->shading;
    glint_reach reach = {draw->unreached, shading->terms->lobes & ~draw->unreached};
    if (shading->terms->shown < 2)
        return reach;
    if (is_known) /* else highlights may turn too far to tell */
        reach.lobes &= region->lobes | region->summed | region->far;
    if (!(shading->material->flags & GLINT_MATERIAL_UNGATED))
        reach.away = shading->lights & ~(region->held | region->sides);
    return reach;
}

int glint_find_region(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                      glint_candidate *t) {
    const glint_shading *shading = draw->shading;
    const glint_light_terms *light = shading->terms;
    glint_region *region = &t->region;
    for (int i = 0; i < 3; i++)
        t->kept[i] = draw->nodes + (size_t)(triangle->corners[i] - draw->vertices) * light->stride;
    const int16_t *a = t->kept[0] + light->channels, *b = t->kept[1] + light->channels,
                  *c = t->kept[2] + light->channels;
    const uint32_t facing = (uint16_t)(a[GLINT_KEPT_FACING] & b[GLINT_KEPT_FACING] & c[GLINT_KEPT_FACING]);
    const uint32_t flags = (uint16_t)(a[GLINT_KEPT_FLAGS] | b[GLINT_KEPT_FLAGS] | c[GLINT_KEPT_FLAGS]);
    measure(light->pixel, triangle, t);
    region->levels = (uint32_t)glint_most_of(a[GLINT_KEPT_LEVELS], b[GLINT_KEPT_LEVELS], c[GLINT_KEPT_LEVELS]) << 2;
    region->lit = facing & 0xff;
    region->dark = facing >> 8;
    region->far = flags & 0xff;
    region->unfit = flags >> 8;
    region->steep = (uint32_t)(a[GLINT_KEPT_STEEP] | b[GLINT_KEPT_STEEP] | c[GLINT_KEPT_STEEP]);
    region->left = draw->unreached;
    region->outside = (uint16_t)(a[GLINT_KEPT_OUTSIDE] & b[GLINT_KEPT_OUTSIDE] & c[GLINT_KEPT_OUTSIDE]);
    t->has_surface = draw->extra != 0;
    region->colour = t->has_surface ? find_surface(triangle, t) : 0;
    const uint32_t lights = shading->lights & ~draw->unreached, measured = lights & (light->placed | light->lobes);
    for (uint32_t l = 0; lights >> l; l++) {
        region->strength[l] = 1 << 14;
        if (measured >> l & 1)
            find_corners_nearness(l, light->at[l], t);
    }
    const uint32_t lobes = glint_region_sort(frame, shading, region);
    region->lobes = region->slope = 0;
    region->has_edge = 0;
    if (lobes)
        find_lobes(shading, lobes, t);
    return glint_region_fits(shading, t->has_surface, region);
}
