/* SPDX-License-Identifier: MIT */
/*
 * Suite: the arithmetic of clipping, edges and planes, against exact quotients and long double, at the errors it
 * states; and what the ring of found polynomials keeps.
 */
#include "raster/setup.h"
#include "frame/arena.h"
#include "geometry/geometry.h"
#include "harness.h"
#include "math/division.h"
#include "nodes/terms.h"
#include "raster/found.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint32_t random_bits(void) {
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 32);
}

static int32_t random_below(int32_t limit) {
    return (int32_t)(random_bits() % (uint32_t)limit);
}

static void reciprocals_of_16_bits(void) {
    int wrong = 0;
    for (uint32_t x = 1u << 15; x <= 1u << 16; x++) {
        const int64_t nearest = (int64_t)floorl(2147483648.0L / x + 0.5L);
        wrong += glint_reciprocal16_by_division(x) != nearest;
        wrong += glint_reciprocal16_by_table(x) != nearest;
    }
    CHECK_EQUAL(wrong, 0);
}

/* Largest error of the crossings of an edge, in steps times 16 dy: at its first row and its last, for all positions. */
static int64_t worst_crossing(int32_t slope, int32_t dx, int32_t dy) {
    int64_t worst = 0;
    for (int32_t first = 0; first < 16; first++) {
        const int32_t last = first + (dy - 1 - first) / 16 * 16;
        for (int32_t down = first; down<dy; down += last> first ? last - first : 16) {
            const int64_t found = (int64_t)glint_edge_start(slope, first) + (int64_t)slope * ((down - first) / 16);
            int64_t error = found * 16 * dy - (int64_t)down * dx * (1 << 20);
            error = error < 0 ? -error : error;
            worst = error > worst ? error : worst;
        }
    }
    return worst;
}

static void check_edges(const char *name, int32_t (*slope)(int32_t, int32_t), int32_t end) {
    double worst = 0;
    for (int32_t dy = 1; dy < end; dy++) {
        for (int32_t dx = 1 - GLINT_EDGE_DX; dx < GLINT_EDGE_DX; dx++)
            worst = fmax(worst, (double)worst_crossing(slope(dx, dy), dx, dy) / (16 * dy));
    }
    test_write("  ");
    test_write(name);
    test_write(": ");
    test_write_number((int64_t)(worst * 1000 / GLINT_EDGE_ERROR));
    test_write(" thousandths of the error allowed\n");
    CHECK(worst < GLINT_EDGE_ERROR);
    CHECK((1 << 20) / (16 * (end - 1)) >= 2 * GLINT_EDGE_ERROR); /* exact crossings lie so far apart */
}

static void crossings_of_all_short_edges(void) {
    check_edges("edges by division", glint_slope_by_division, 512);
    check_edges("edges by table", glint_slope_by_table, 512);
    CHECK(GLINT_EDGE_DY <= 512);
}

/* ---- Planes */

/* A corner, in sixteenths from a pixel's centre. */
typedef struct place {
    int32_t x, y;
} place;

typedef struct drawn {
    place places[3];
    glint_vertex corners[3];
    glint_triangle triangle;
    glint_part part;
} drawn;

/* A triangle with corners up to `size` sixteenths apart and depths up to `range`. @return 0 when it has no area */
static int draw(drawn *d, int32_t size, int32_t range) {
    int32_t x[3], y[3];
    const int32_t base = random_below(0x7fff0000 - range + 1);
    for (int i = 0; i < 3; i++) {
        x[i] = random_below(size) - size / 2;
        y[i] = random_below(size) - size / 2;
        d->corners[i].inverse_w = base + random_below(range);
        d->triangle.corners[i] = &d->corners[i];
    }
    const int32_t area = (x[2] - x[0]) * (y[1] - y[0]) - (x[1] - x[0]) * (y[2] - y[0]);
    if (area == 0)
        return 0;
    if (area < 0) { /* counter-clockwise, as raster turns it */
        const int32_t swapped[2] = {x[1], y[1]};
        x[1] = x[2];
        y[1] = y[2];
        x[2] = swapped[0];
        y[2] = swapped[1];
    }
    for (int i = 0; i < 3; i++) {
        d->places[i] = (place){x[i], y[i]};
        d->corners[i].x = (int16_t)(x[i] + 8);
        d->corners[i].y = (int16_t)(y[i] + 8);
    }
    glint_setup(&d->part, &d->triangle);
    return 1;
}

/* A pixel near a random place of a triangle, and what of it lies towards its other corners. @return is it inside? */
static int find_pixel(const place p[3], double area, int32_t *x, int32_t *y, double *u, double *v) {
    const double s = random_below(1000) / 1000.0, t = random_below(1000) / 1000.0 * (1 - s);
    *x = (int32_t)floor((p[0].x + s * (p[1].x - p[0].x) + t * (p[2].x - p[0].x)) / 16 + 0.5);
    *y = (int32_t)floor((p[0].y + s * (p[1].y - p[0].y) + t * (p[2].y - p[0].y)) / 16 + 0.5);
    *u = ((16.0 * *x - p[0].x) * (p[2].y - p[0].y) - (16.0 * *y - p[0].y) * (p[2].x - p[0].x)) / area;
    *v = ((16.0 * *y - p[0].y) * (p[1].x - p[0].x) - (16.0 * *x - p[0].x) * (p[1].y - p[0].y)) / area;
    return *u >= 0 && *v >= 0 && *u + *v <= 1;
}

/* Largest error over the pixels of a triangle, as a part of the corners' largest difference, or of `least`. */
static double worst_plane(const drawn *d, const glint_plane *plane, double least) {
    const place *p = d->places;
    const int32_t anchor_x = (p[0].x + 8) >> 4, anchor_y = (p[0].y + 8) >> 4;
    const double area = -d->triangle.area, a = d->corners[0].inverse_w;
    const double da = d->corners[1].inverse_w - a, db = d->corners[2].inverse_w - a;
    double worst = 0;
    for (int tries = 0; tries < 64; tries++) {
        double u, v;
        int32_t x, y;
        if (!find_pixel(p, area, &x, &y, &u, &v))
            continue;
        const double found = glint_plane_at(plane, x - anchor_x, y - anchor_y);
        const double rounding = 4 + abs(x - anchor_x) + abs(y - anchor_y); /* slopes are whole */
        worst = fmax(worst, fabs(found - (a + u * da + v * db)) - rounding);
    }
    return worst / fmax(fmax(fabs(da), fabs(db)), least);
}

/* M.M of normals that are 1 at the corners and so far apart, squares in Q14: largest error over a triangle's pixels. */
static double worst_square(const drawn *d, const int32_t apart[3]) {
    const place *p = d->places;
    const int32_t anchor_x = (p[0].x + 8) >> 4, anchor_y = (p[0].y + 8) >> 4;
    const int32_t one[3] = {1 << 14, 1 << 14, 1 << 14}, bulge[3] = {-apart[0], -apart[1], -apart[2]};
    const double area = -d->triangle.area;
    glint_barycentric barycentric;
    glint_quadratic q;
    double worst = 0;
    glint_barycentric_begin(&barycentric, &d->part.gradients, 16);
    glint_polynomial_begin(&q, &barycentric, one, bulge);
    for (int tries = 0; tries < 64; tries++) {
        double u, v;
        int32_t x, y;
        if (!find_pixel(p, area, &x, &y, &u, &v))
            continue;
        const double found = (int32_t)glint_stride_begin(&q, x - anchor_x, y - anchor_y).value / 0x1p30;
        const double exact = 1 - ((1 - u - v) * (u * apart[0] + v * apart[2]) + u * v * apart[1]) / 0x1p14;
        worst = fmax(worst, fabs(found - exact));
    }
    return worst;
}

static void report(const char *name, double worst, double allowed) {
    test_write("  ");
    test_write(name);
    test_write(": ");
    test_write_number((int64_t)(worst / allowed * 1000));
    test_write(" thousandths of the error allowed\n");
    CHECK(worst > 0 && worst <= allowed);
}

static void planes(void) {
    static const int32_t ranges[4] = {1 << 16, 1 << 24, 1 << 28, 0x7fff0000};
    double worst_narrow = 0, worst_small = 0, worst_tiny = 0, worst_wide = 0, worst_slender = -1;
    for (int i = 0; i < 3000000; i++) {
        static drawn d;
        if (!draw(&d, 4 << random_below(13), ranges[i % 4]))
            continue;
        const glint_gradients *g = &d.part.gradients;
        double *worst = d.triangle.area < 16 ? &worst_tiny : d.triangle.area < 512 ? &worst_small : &worst_narrow;
        if (g->reciprocal)
            *worst = fmax(*worst, worst_plane(&d, &d.part.depth, 1 << 17));
        else if (g->shift)
            worst_wide = fmax(worst_wide, worst_plane(&d, &d.part.depth, 1));
        else
            worst_slender = fmax(worst_slender, worst_plane(&d, &d.part.depth, 1));
    }
    report("planes of narrow triangles", worst_narrow, 0x1p-15);
    report("planes of those below a pixel", worst_small, 0x1p-12);
    report("planes of those below 1/32 of a pixel", worst_tiny, 0x1p-10);
    report("planes of wide triangles", worst_wide, 0x1p-18);
    CHECK(worst_slender == 0); /* they are drawn, and all that they lack is rounding */
}

/* Of a few pixels, from a place to up to 2^20 times as far: what is left of 1/w there is as exact as if they were
 * large.
 */
static void planes_of_steep_triangles(void) {
    double worst = 0;
    long narrow = 0, wide = 0;
    for (int i = 0; i < 1000000; i++) {
        static drawn d;
        if (!draw(&d, 16 << random_below(7), 1 << 16))
            continue;
        const int32_t most = 0x7fc00000 >> random_below(16); /* not next to the top, below which planes are kept */
        for (int k = 0; k < 3; k++)
            d.corners[k].inverse_w = random_below(most) >> random_below(20);
        d.corners[i % 3].inverse_w = most;
        d.corners[(i + 1) % 3].inverse_w = most >> 5 >> random_below(16);
        glint_setup(&d.part, &d.triangle);
        narrow += d.part.gradients.reciprocal != 0;
        if (!d.part.gradients.shift)
            continue;
        worst = fmax(worst, worst_plane(&d, &d.part.depth, 1));
        wide++;
    }
    CHECK(wide > 100000);
    CHECK_EQUAL(narrow, 0);
    report("planes of steep triangles", worst, 0x1p-17);
}

/* Slender triangles keep fewer digits, the fewer the further their normals turn. */
static void squares_of_normals(void) {
    long kept = 0, left = 0;
    double worst = 0, worst_left = 0;
    for (int i = 0; i < 1000000; i++) {
        static drawn d;
        if (!draw(&d, 64 << random_below(8), 1 << 16) || d.triangle.area < GLINT_POLYNOMIAL_LEAST_AREA ||
            glint_slenderness(&d.part.gradients, d.triangle.area) > GLINT_SLENDER)
            continue;
        const int32_t most = (1 << (4 + random_below(11))) + 1; /* Q14: up to 1, 60 degrees */
        const int32_t apart[3] = {random_below(most), random_below(most), random_below(most)};
        const int32_t largest = glint_most_of(apart[0], apart[1], apart[2]);
        const double error = worst_square(&d, apart);
        if (glint_keeps_digits(&d.part.gradients, d.triangle.area, (uint32_t)largest << 12)) {
            kept++;
            worst = fmax(worst, error);
        } else {
            left++;
            worst_left = fmax(worst_left, error);
        }
    }
    CHECK(kept > 100000 && left > 1000);
    report("squares of normals", worst, 0.0013);
    CHECK(worst_left > 0x1p-9); /* it is these that are left out */
}

/* Depths at a corner that is the frame's nearest, on a pixel's centre: rounded up they still have 31 bits. */
static void depth_at_the_nearest_corner(void) {
    const int32_t top = 0x7fff0000;
    long judged = 0, above = 0;
    for (int i = 0; i < 3000000; i++) {
        const int which = i % 3;
        static drawn d;
        if (!draw(&d, 4 << random_below(13), top))
            continue;
        const place *corner = &d.places[which], *first = &d.places[0];
        if (corner->x & 15 || corner->y & 15)
            continue;
        for (int k = 0; k < 3; k++)
            d.corners[k].inverse_w = k == which ? top : d.corners[k].inverse_w >> random_below(8);
        glint_setup(&d.part, &d.triangle);
        const int32_t x = corner->x / 16 - ((first->x + 8) >> 4), y = corner->y / 16 - ((first->y + 8) >> 4);
        above += ((uint32_t)glint_plane_at(&d.part.depth, x, y) + (1 << 15)) >> 31;
        judged++;
    }
    CHECK(judged > 10000);
    CHECK_EQUAL(above, 0);
}

/* 1/w of vertices, over the nearest's: where that is much nearer, too. */
static void depth_far_behind_the_nearest(void) {
    double worst = 0;
    for (int i = 0; i < 3000000; i++) {
        const int32_t w = (1 << 28) + random_below(1 << 29);
        glint_transform transform = {.nearest = random_below(w >> random_below(20)) + 1};
        const glint_position position = {0, 0, w};
        glint_vertex vertex;
        glint_project(&transform, &position, &vertex);
        const double exact = fmin((double)transform.nearest / w, 0x7fff0000 / 0x1p31);
        worst = fmax(worst, fabs(vertex.inverse_w / 0x1p31 - exact) / (exact * 0x1p-18 + 0x1p-25));
    }
    report("1/w of vertices", worst, 2);
}

/* The longest edge, whichever it is, to 2^-12 of it and a step. */
static void longest_edges(void) {
    double worst = 0;
    for (int i = 0; i < 300000; i++) {
        const int32_t limit = 1 << (i % 15 + 1);
        glint_vertex v[3] = {{0}};
        for (int j = 0; j < 3; j++) {
            v[j].x = (int16_t)random_below(limit);
            v[j].y = (int16_t)random_below(limit);
        }
        const glint_vertex *const corners[3] = {&v[0], &v[1], &v[2]};
        double longest = 0;
        for (int j = 0; j < 3; j++)
            longest = fmax(longest, hypot(v[j].x - v[(j + 1) % 3].x, v[j].y - v[(j + 1) % 3].y));
        worst = fmax(worst, fabs(glint_find_longest(corners) - longest) / (longest / 4096 + 1));
    }
    report("longest edges", worst, 1);
}

/* ---- Clipping ---- */

enum { NEAR_PLANE = 1000000 };

typedef struct point {
    double x, y, w;
} point;

static double distance_to(const point *p, int plane) {
    const double distances[5] = {p->w - NEAR_PLANE, p->w + p->x, p->w - p->x, p->w + p->y, p->w - p->y};
    return distances[plane];
}

/* Clips a polygon of up to 8 corners in floating point. @return its corners then */
static int clip_exactly(point *polygon, int count) {
    for (int plane = 0; plane < 5; plane++) {
        point kept[16] = {{0}};
        int n = 0;
        for (int i = 0; i < count; i++) {
            const point *a = &polygon[i], *b = &polygon[(i + 1) % count];
            const double da = distance_to(a, plane), db = distance_to(b, plane), t = da / (da - db);
            if (da >= 0)
                kept[n++] = *a;
            if ((da >= 0) != (db >= 0))
                kept[n++] = (point){a->x + (b->x - a->x) * t, a->y + (b->y - a->y) * t, a->w + (b->w - a->w) * t};
        }
        count = n;
        memcpy(polygon, kept, sizeof *kept * (size_t)count);
    }
    return count;
}

static int clip_triangle(const point triangle[3], glint_corner *corners) {
    const glint_transform transform = {.near_plane = NEAR_PLANE, .clips = 1};
    memset(corners, 0, GLINT_CLIP_CORNERS * sizeof *corners);
    for (int i = 0; i < 3; i++)
        corners[i].position = (glint_position){(int32_t)triangle[i].x, (int32_t)triangle[i].y, (int32_t)triangle[i].w};
    return glint_clip(&transform, corners);
}

/* Are two of a polygon's corners that close that rounding may make them one? */
static int has_short_edge(const point *polygon, int count) {
    int is_short = 0;
    for (int i = 0; i < count; i++) {
        const point *a = &polygon[i], *b = &polygon[(i + 1) % count];
        is_short |= hypot(hypot(a->x - b->x, a->y - b->y), a->w - b->w) < 16;
    }
    return is_short;
}

/* Triangles that leave 8 corners, all five planes cut: none is lost, whichever corner comes first. */
static void clipping_leaves_all_corners(void) {
    static const point around[3][3] = {
        {{1310551, -1924734, 1864846}, {517536, 2720101, -1181152}, {-2832657, -441045, 3242720}},
        {{1606443, -86650, 3819149}, {-2481818, -2815590, 2164897}, {1293851, 2317306, -734555}},
        {{1474467, -1354473, 2790131}, {-1726894, -1057977, 580480}, {1156594, 1321447, 1070639}}};
    int judged = 0, wrong = 0;
    double worst = 0;
    for (int number = 0; number < 30000; number++) {
        point triangle[3], polygon[16];
        glint_corner corners[GLINT_CLIP_CORNERS];
        for (int i = 0; i < 3; i++) {
            const point *p = &around[number % 3][(number / 3 + i) % 3];
            triangle[i] = (point){p->x + random_below(20001) - 10000, p->y + random_below(20001) - 10000,
                                  p->w + random_below(20001) - 10000};
        }
        memcpy(polygon, triangle, sizeof triangle);
        const int exact = clip_exactly(polygon, 3), count = clip_triangle(triangle, corners);
        if (exact != GLINT_CLIP_CORNERS || has_short_edge(polygon, exact))
            continue;
        judged++;
        wrong += count != exact;
        for (int i = 0; i < count && count == exact; i++) {
            const glint_position *p = &corners[i].position;
            worst = fmax(worst, hypot(hypot(p->x - polygon[i].x, p->y - polygon[i].y), p->w - polygon[i].w));
        }
    }
    CHECK(judged > 10000);
    CHECK_EQUAL(wrong, 0);
    report("corners of clipped triangles", worst, 8);
}

/* Triangles along a plane, seen edge on: rounding tells of corners on both its sides in turn. What is left is inside.
 */
static void clipping_along_planes(void) {
    int wrong = 0, left = 0;
    for (int number = 0; number < 300000; number++) {
        const int32_t near_plane = number % 4 ? NEAR_PLANE : 16;
        glint_corner corners[GLINT_CLIP_CORNERS] = {0};
        const glint_transform transform = {.near_plane = near_plane, .clips = 1};
        for (int i = 0; i < 3; i++) {
            const int32_t w = random_below(6 * near_plane) - near_plane, across = w + random_below(3) - 1;
            const int32_t along = random_below(8 * near_plane) - 4 * near_plane;
            corners[i].position = (glint_position){along, number % 2 ? across : -across, w};
        }
        const int count = glint_clip(&transform, corners);
        left += count > 0;
        wrong += count > GLINT_CLIP_CORNERS;
        for (int i = 0; i < count; i++) {
            const glint_position *p = &corners[i].position;
            wrong += p->w < near_plane || abs(p->x) > p->w || abs(p->y) > p->w;
        }
    }
    CHECK(left > 10000);
    CHECK_EQUAL(wrong, 0);
}

/* ---- The ring of what tiles find ---- */

enum { RING_BYTES = 8192, RING_CANARIES = 64, RING_KEYS = 8 };
static union {
    void *aligned;
    uint8_t bytes[RING_BYTES + RING_CANARIES];
} ring_memory;

/* A pass that leaves so many bytes, words of what was there before; what lies behind them is not the pass's own. */
static void open_ring(glint_workspace *workspace, uint32_t size, uint32_t word) {
    for (uint32_t i = 0; i < size; i++)
        ring_memory.bytes[i] = (uint8_t)(word >> 8 * (i % 4));
    memset(ring_memory.bytes + size, 0xa5, RING_CANARIES);
    *workspace = (glint_workspace){.spare = {.memory = ring_memory.bytes, .size = size}};
}

static int ring_is_within(uint32_t size) {
    int within = 1;
    for (uint32_t i = 0; i < RING_CANARIES; i++)
        within &= ring_memory.bytes[size + i] == 0xa5;
    return within;
}

/* The most bytes that one record of a ring may have. */
static uint32_t most_of_ring(uint32_t size) {
    glint_workspace workspace;
    uint32_t most = size;
    open_ring(&workspace, size, 0);
    while (most && !glint_ring_begin(&workspace, most))
        most--;
    return most;
}

/* Fills the room that a record may take, and keeps so many bytes of it. */
static int keep_in_ring(glint_workspace *workspace, uint32_t key, uint32_t most, uint32_t size) {
    uint8_t *const room = glint_ring_begin(workspace, most);
    if (!room)
        return 0;
    memset(room, (int)key, most);
    glint_ring_keep(workspace, key, size);
    return 1;
}

/* Is a key there, with what was kept by it? */
static int is_in_ring(const glint_workspace *workspace, uint32_t key, uint32_t size) {
    const uint8_t *const found = glint_ring_find(workspace, key);
    uint32_t wrong = 0;
    for (uint32_t i = 0; found && i < size; i++)
        wrong += found[i] != (uint8_t)key;
    CHECK_EQUAL(wrong, 0);
    return found != 0;
}

/* Those from `first` up to `end` are there, and no other. */
static void check_ring(const glint_workspace *workspace, uint32_t first, uint32_t end, uint32_t size) {
    for (uint32_t key = 0; key < 2 * RING_KEYS; key++)
        CHECK_EQUAL(is_in_ring(workspace, key, size), key >= first && key < end);
}

/*
 * Records that fill a ring to its last byte: all are there until one more begins, which takes the place of the oldest
 * alone, kept or not.
 */
static void rings_keep_all_that_fits(void) {
    const uint32_t head = (uint32_t)GLINT_ALIGNED(sizeof(uint32_t));
    for (uint32_t spare = 4096; spare <= RING_BYTES; spare += (uint32_t)GLINT_ALIGNMENT) {
        const uint32_t whole = most_of_ring(spare) + head;
        if (whole % (RING_KEYS * GLINT_ALIGNMENT))
            continue;
        const uint32_t size = whole / RING_KEYS - head;
        glint_workspace workspace;
        open_ring(&workspace, spare, spare); /* as a key, and as a place, of the first turn */
        check_ring(&workspace, 0, 0, size);
        CHECK(glint_ring_begin(&workspace, size) != 0);
        check_ring(&workspace, 0, 0, size);
        CHECK(!glint_ring_find(&workspace, spare));
        for (uint32_t key = 0; key < RING_KEYS; key++) {
            CHECK(keep_in_ring(&workspace, key, size, size));
            check_ring(&workspace, 0, key + 1, size);
        }
        for (uint32_t key = RING_KEYS; key < 2 * RING_KEYS; key++) {
            CHECK(glint_ring_begin(&workspace, size) != 0);
            check_ring(&workspace, key + 1 - RING_KEYS, key, size);
            CHECK(keep_in_ring(&workspace, key, size, size));
            check_ring(&workspace, key + 1 - RING_KEYS, key + 1, size);
        }
        CHECK(ring_is_within(spare));
    }
}

/* Records of any size, of which less may be kept than was written: what is found is what was kept. */
static void rings_find_what_was_kept(void) {
    for (uint32_t spare = 4096; spare <= RING_BYTES; spare += 31 * (uint32_t)GLINT_ALIGNMENT) {
        const uint32_t whole = most_of_ring(spare);
        uint32_t sizes[256] = {0}, found = 0;
        glint_workspace workspace;
        open_ring(&workspace, spare, 0);
        for (uint32_t i = 0; i < 200; i++) {
            const uint32_t key = random_bits() % TEST_COUNT(sizes),
                           most = random_bits() % (i % 8 ? whole / 16 : whole) + 1, size = random_bits() % most + 1;
            if (i % 16 == 15) { /* begun in vain */
                uint8_t *const room = glint_ring_begin(&workspace, most);
                if (CHECK(room != 0))
                    memset(room, 0xff, most);
                continue;
            }
            sizes[key] = size;
            CHECK(keep_in_ring(&workspace, key, most, size));
            CHECK(is_in_ring(&workspace, key, size));
            for (uint32_t other = 0; other < TEST_COUNT(sizes) - 1; other++)
                found += (uint32_t)(is_in_ring(&workspace, other, sizes[other]) && sizes[other]);
        }
        CHECK(found > 200);
        CHECK(keep_in_ring(&workspace, 1, whole, whole));
        CHECK(is_in_ring(&workspace, 1, whole));
        CHECK(!glint_ring_begin(&workspace, whole + 1));
        CHECK(ring_is_within(spare));
    }
}

/* Nothing is kept where a pass leaves no memory, and nothing but what there is room for where it leaves little. */
static void rings_without_room(void) {
    glint_workspace workspace = {0};
    CHECK(!glint_ring_find(&workspace, 0));
    CHECK(!glint_ring_begin(&workspace, 1));
    CHECK(!glint_ring_find(&workspace, 0));
    for (uint32_t spare = 0; spare <= 1024; spare += (uint32_t)GLINT_ALIGNMENT) {
        open_ring(&workspace, spare, 0);
        for (uint32_t key = 0; key <= 16; key++)
            keep_in_ring(&workspace, key, 8, 8);
        CHECK(ring_is_within(spare));
    }
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(reciprocals_of_16_bits),
        TEST_CASE(crossings_of_all_short_edges),
        TEST_CASE(planes),
        TEST_CASE(planes_of_steep_triangles),
        TEST_CASE(squares_of_normals),
        TEST_CASE(depth_at_the_nearest_corner),
        TEST_CASE(depth_far_behind_the_nearest),
        TEST_CASE(longest_edges),
        TEST_CASE(clipping_leaves_all_corners),
        TEST_CASE(clipping_along_planes),
        TEST_CASE(rings_keep_all_that_fits),
        TEST_CASE(rings_find_what_was_kept),
        TEST_CASE(rings_without_room),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
