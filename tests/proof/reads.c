/* SPDX-License-Identifier: MIT */
/*
 * Suite: the table reads of fast lighting, and channels of colours at corners, which rest on how far a plane's value at
 * a pixel can lie from its corners'. Triangles of all sizes, slender ones too, that turn and change in depth as far as
 * is ever let through; and such as clipping leaves, whose normals are short; every pixel.
 */
#include "fast/fast_draw.h"
#include "harness.h"

#define TRIANGLES 500000

static uint32_t random_bits(void) {
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 32);
}

/* From -size to size. */
static int32_t random_within(int32_t size) {
    return (int32_t)(random_bits() % (2 * (uint32_t)size + 1)) - size;
}

/* A unit vector up to `spread` away from another, component by component. */
static void random_unit(const int16_t near[3], int32_t spread, int16_t out[3]) {
    int32_t v[3];
    for (int c = 0; c < 3; c++)
        v[c] = near[c] + random_within(spread);
    glint_unit(v[0], v[1], v[2], out);
}

static const int16_t nowhere[3] = {0, 0, 0};

/* What the kernels would read. */
static struct {
    int64_t diffuse_most, diffuse_least, gated_most, specular_most, stepped_most;
    uint32_t triangles[GLINT_KERNELS], stepped, pixels;
    uint32_t interpolated[2], interpolated_gated, curved[2];
    uint32_t cut[2];
    int64_t root_most, bent_most, channel_most, channel_least;
} seen = {-1, INT32_MAX, -1, -1, -1, {0}, 0, 0, {0}, 0, {0}, {0}, -1, -1, 0, 0};

static int64_t more(int64_t a, int64_t b) {
    return a > b ? a : b;
}

/* `stepped` is null where squares are found pixel by pixel. */
static uint32_t find_square(const glint_fast_planes *planes, const glint_quadratic *stepped, int32_t x, int32_t y) {
    if (stepped) {
        const uint32_t sum = glint_stride_begin(stepped, x, y).value;
        seen.stepped_most = more(seen.stepped_most, sum);
        return sum >> GLINT_SQUARE_BITS;
    }
    return glint_high_square((uint32_t)glint_plane_at(&planes->x, x, y)) +
           glint_high_square((uint32_t)glint_plane_at(&planes->y, x, y));
}

static void see_pixel(glint_fast_kind kind, const glint_fast_terms *fast, const glint_fast_planes *planes,
                      const glint_quadratic *stepped, int32_t x, int32_t y) {
    const int32_t level = glint_plane_at(&planes->cosine, x, y);
    const int64_t entry = (uint32_t)level >> 22;
    seen.pixels++;
    if (kind == GLINT_FAST_GATED) {
        if (level > 0 && entry > seen.gated_most)
            seen.gated_most = entry;
        return;
    }
    seen.diffuse_most = entry > seen.diffuse_most ? entry : seen.diffuse_most;
    seen.diffuse_least = level < seen.diffuse_least ? level : seen.diffuse_least;
    if (kind == GLINT_FAST_SPECULAR) {
        const uint32_t square = find_square(planes, stepped, x, y);
        if (square < fast->specular_end && square >> 15 > seen.specular_most)
            seen.specular_most = square >> 15;
    }
}

/* As the loops of fast_interpolated_spans.h read. */
static void see_interpolated(const glint_fast_terms *fast, const glint_interpolation *light, int shows, int32_t x,
                             int32_t y) {
    const int32_t level = (int32_t)glint_stride_begin(&light->cosine, x, y).value;
    const int64_t entry = (uint32_t)level >> 22;
    if (!shows && light->gated) {
        seen.gated_most = level > 0 ? more(seen.gated_most, entry) : seen.gated_most;
        return;
    }
    seen.diffuse_most = more(seen.diffuse_most, entry);
    seen.diffuse_least = level < seen.diffuse_least ? level : seen.diffuse_least;
    if (shows) {
        const uint32_t square = glint_high_square(glint_stride_begin(&light->x, x, y).value) +
                                glint_high_square(glint_stride_begin(&light->y, x, y).value);
        if (square < fast->specular_end)
            seen.specular_most = more(seen.specular_most, square >> 15);
    }
}

static void see_curved(const glint_fast_terms *fast, const glint_exact_light *light, int shows, int32_t x, int32_t y) {
    const glint_exact_limits *limits = &fast->exact;
    const int32_t level = glint_plane_at(&light->cosine, x, y);
    const uint32_t root = glint_stride_begin(&light->square, x, y).value >> 22;
    seen.root_most = more(seen.root_most, root);
    if (level <= 0 || root > 767)
        return;
    const uint32_t inverse = glint_root_table[root];
    seen.gated_most = more(seen.gated_most, ((uint32_t)level >> 15) * inverse >> 22);
    if (shows) {
        uint32_t square = glint_middle_square(glint_stride_begin(&light->x, x, y).value) +
                          glint_middle_square(glint_stride_begin(&light->y, x, y).value);
        if (square >= limits->limit)
            return;
        square = (square >> limits->shift) * (inverse * inverse >> 16);
        if (square < limits->end)
            seen.bent_most = more(seen.bent_most, square >> 20);
    }
}

/* Triangles that turn further. */
static void see_quadratic(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part) {
    const glint_fast_terms *fast = draw->shading->fast;
    glint_interpolation interpolated;
    glint_exact_light curved;
    glint_exact_kind kind = glint_interpolate_begin(draw, triangle, part, &interpolated);
    const int fits = kind != GLINT_EXACT_UNFIT;
    if (!fits)
        kind = glint_exact_begin(draw, triangle, part, &curved);
    if (kind != GLINT_EXACT_DIFFUSE && kind != GLINT_EXACT_SPECULAR)
        return;
    const int shows = kind == GLINT_EXACT_SPECULAR;
    (fits ? seen.interpolated : seen.curved)[shows]++;
    seen.cut[shows] += !(triangle->corners[0]->flags & GLINT_VERTEX_LIT);
    seen.interpolated_gated += fits && !shows && interpolated.gated;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        for (int32_t column = part->spans[row].left; column < part->spans[row].right; column++) {
            const int32_t x = part->x + column, y = part->y + (int32_t)row;
            if (fits)
                see_interpolated(fast, &interpolated, shows, x, y);
            else
                see_curved(fast, &curved, shows, x, y);
        }
    }
}

/* A channel, black, white or between at each corner: what a pixel's is at most and at least. */
static void see_channel(const glint_part *part) {
    glint_plane channel;
    int32_t at[3];
    for (int i = 0; i < 3; i++) {
        const int16_t colour[3] = {0, GLINT_COLOUR_ONE, (int16_t)(random_bits() % (GLINT_COLOUR_ONE + 1))};
        at[i] = glint_channel_of(colour[random_bits() % 3]);
    }
    glint_plane_begin(&channel, &part->gradients, at[0], at[1], at[2]);
    for (uint32_t row = part->top; row < part->bottom; row++) {
        for (int32_t column = part->spans[row].left; column < part->spans[row].right; column++) {
            const int64_t value = glint_plane_at(&channel, part->x + column, part->y + (int32_t)row);
            seen.channel_most = more(seen.channel_most, value);
            seen.channel_least = -more(-seen.channel_least, -value);
        }
    }
}

static void see(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                const glint_triangle *triangle, const glint_part *part) {
    glint_fast_planes planes;
    const glint_fast_kind kind = glint_fast_begin(draw, triangle, part, &planes);
    (void)frame;
    (void)workspace;
    seen.triangles[kind]++;
    see_channel(part);
    if (kind == GLINT_FAST_UNFIT)
        see_quadratic(draw, triangle, part);
    if (kind == GLINT_FAST_EVEN) {
        const int64_t entry = (uint32_t)planes.cosine.start >> 22;
        if (planes.cosine.start > 0 && entry > seen.gated_most)
            seen.gated_most = entry;
        return;
    }
    if (kind != GLINT_FAST_DIFFUSE && kind != GLINT_FAST_GATED && kind != GLINT_FAST_SPECULAR)
        return;
    const int is_stepped = kind == GLINT_FAST_SPECULAR && triangle->area >= GLINT_LARGE_AREA &&
                           glint_square_fits(&part->gradients, &planes);
    glint_quadratic square;
    if (is_stepped)
        square = glint_square_begin(&planes.x, &planes.y);
    seen.stepped += (uint32_t)is_stepped;
    for (uint32_t row = part->top; row < part->bottom; row++)
        for (int32_t column = part->spans[row].left; column < part->spans[row].right; column++)
            see_pixel(kind, draw->shading->fast, &planes, is_stepped ? &square : 0, part->x + column,
                      part->y + (int32_t)row);
}

/* Limits at the most that any material and error budget sets them to; a highlight of any width. */
static void loosen(glint_fast_terms *fast) {
    const uint32_t entries = 256u << random_bits() % 3, cut = (1u << 30) >> random_bits() % 21;
    const int32_t scale = (int32_t)glint_square_root(((uint64_t)entries << 49) / cut);
    fast->turn = fast->turn_specular = 1 << 26;
    fast->extent = INT32_MAX;
    fast->slant = 0xffff;
    fast->even = random_bits() % 8 ? 0 : INT16_MAX;
    fast->sine_square_end = cut;
    fast->specular_end = entries << 15;
    fast->scale = scale;
    fast->scaled_half = (scale >> 1) + (1 << 15);
    fast->reach = glint_least((GLINT_FAST_REACH << 16) / scale - 1, INT16_MAX);
    fast->within = UINT32_MAX >> 1 >> glint_leading_zeros((uint32_t)fast->reach + 1);
    fast->side = (int32_t)glint_square_root(fast->specular_end) + (scale >> 14) + 2;
    fast->side_diagonal = (fast->side * 23171 >> 14) + 1;
    fast->sides[0] = ((1 << 15) - (uint32_t)fast->side) * 0x10001;
    fast->sides[1] = ((1 << 15) - (uint32_t)fast->side_diagonal / 2 - 1) * 0x10001;
    fast->cut = (int32_t)glint_square_root(cut >> 2) + 4;
    fast->cut_diagonal = (fast->cut * 23171 >> 14) + 1;
}

/* Of quadratics, by what is prepared for a highlight of this width, but that they turn as far as they ever may. */
static void loosen_quadratics(glint_fast_terms *fast, const glint_shading *shading) {
    const glint_frame frame = {.config = {.width = GLINT_SIZE_MAX, .height = GLINT_SIZE_MAX}};
    fast->exact = (glint_exact_limits){0};
    glint_exact_prepare(fast, &frame, shading);
    fast->exact.turn = fast->exact.turn_specular = INT16_MAX;
    fast->exact.large = INT32_MAX;
}

/* A light towards the first corner's normal, near the edge of what it lights, or anywhere. */
static void place_light(glint_fast_terms *fast, const int16_t normal[3]) {
    const int16_t across[3] = {normal[1], (int16_t)-normal[0], 0};
    switch (random_bits() % 3) {
    case 0:
        random_unit(normal, 2000, fast->light);
        break;
    case 1:
        random_unit(across, 2000, fast->light);
        break;
    default:
        random_unit(nowhere, 32767, fast->light);
    }
    glint_unit(fast->light[0], fast->light[1], glint_most(fast->light[2] + GLINT_UNIT, 0), fast->half_vector);
    for (int c = 0; c < 3; c++)
        fast->long_light[c] = fast->light[c] + glint_shift_right(fast->light[c] + (1 << 12), 13);
}

/* Normals up to `turn` from the first, and 1/w up to a quarter apart, as the longest limits let through. */
static void set_up_corners(glint_vertex corners[3], int32_t size) {
    const int32_t turn = 1 + (int32_t)(random_bits() % 30000);
    const int32_t least = 1 << (16 + random_bits() % 15);
    const int32_t x = random_within(9000);
    const int32_t y = random_within(9000);
    int16_t first[3];
    random_unit(nowhere, 32767, first);
    for (int i = 0; i < 3; i++) {
        corners[i].x = (int16_t)(x + random_within(size));
        corners[i].y = (int16_t)(y + random_within(random_bits() % 4 ? size : 16));
        corners[i].inverse_w = least + (int32_t)(random_bits() % (uint32_t)(least / 4));
        corners[i].flags = GLINT_VERTEX_NORMAL;
        random_unit(first, turn, corners[i].attribute);
    }
}

/* As clipping leaves a triangle: each corner somewhere on an edge, its normal between that edge's, and so short. */
static void cut_corners(glint_vertex corners[3]) {
    for (int i = 0; i < 3; i++) {
        int16_t other[3];
        const int32_t t = random_bits() % 2 ? 0 : (int32_t)(random_bits() % (1 << 15));
        random_unit(corners[i].attribute, 32767, other);
        for (int c = 0; c < 3; c++)
            corners[i].attribute[c] =
                (int16_t)(corners[i].attribute[c] + glint_shift_right((other[c] - corners[i].attribute[c]) * t, 15));
        corners[i].flags = 0; /* not lit */
    }
}

/* All of a triangle, tile by tile of 64 x 64 pixels. */
static void draw_tiles(glint_draw *draw, const glint_vertex corners[3]) {
    const int turned = glint_double_area(&corners[0], &corners[1], &corners[2]) > 0; /* to run counter-clockwise */
    int32_t left = INT32_MAX, top = INT32_MAX, right = INT32_MIN, bottom = INT32_MIN;
    for (int i = 0; i < 3; i++) {
        left = corners[i].x < left ? corners[i].x : left;
        right = corners[i].x > right ? corners[i].x : right;
        top = corners[i].y < top ? corners[i].y : top;
        bottom = corners[i].y > bottom ? corners[i].y : bottom;
    }
    for (int32_t y = (top >> 10) * 64; 16 * y <= bottom; y += 64) {
        for (int32_t x = (left >> 10) * 64; 16 * x <= right; x += 64) {
            static glint_part part;
            glint_triangle triangle = {{&corners[0], &corners[1 + turned], &corners[2 - turned]}, {0, 0, 0}, 0, 0, 0};
            glint_window_begin(&part.window, x, y, 64, 64);
            if (!glint_raster(&part, triangle.corners))
                continue;
            glint_setup(&part, &triangle);
            draw->kernel(0, 0, draw, &triangle, &part);
        }
    }
}

static void every_read_is_in_its_table(void) {
    static const uint16_t indices[1][3] = {{0, 1, 2}};
    static glint_fast_terms fast;
    static glint_shading shading;
    static glint_material material;
    static glint_draw draw;
    static glint_vertex corners[3];
    static int16_t terms[3][3];
    shading.fast = &fast;
    shading.lights = 1;
    shading.material = &material;
    material.shininess = 2 * GLINT_ONE;
    draw.triangles = indices;
    draw.vertices = corners;
    draw.terms = terms;
    draw.shading = &shading;
    draw.kernel = see;
    for (int i = 0; i < TRIANGLES; i++) {
        set_up_corners(corners, 4 << random_bits() % (i % 16 ? 9 : 13));
        const int32_t area = glint_double_area(&corners[0], &corners[1], &corners[2]);
        if (area == 0)
            continue;
        draw.mirrored = area > 0;
        loosen(&fast);
        place_light(&fast, corners[0].attribute);
        loosen_quadratics(&fast, &shading);
        glint_fast_light(0, &draw, 0, 0);
        if (i % 8 == 0)
            cut_corners(corners);
        draw_tiles(&draw, corners);
    }
    CHECK(seen.triangles[GLINT_FAST_DIFFUSE] > TRIANGLES / 100);
    CHECK(seen.triangles[GLINT_FAST_GATED] > TRIANGLES / 100);
    CHECK(seen.triangles[GLINT_FAST_SPECULAR] > TRIANGLES / 100);
    CHECK(seen.triangles[GLINT_FAST_EVEN] > TRIANGLES / 1000);
    CHECK(seen.stepped > TRIANGLES / 1000);
    CHECK(seen.interpolated[0] > TRIANGLES / 100);
    CHECK(seen.interpolated[1] > TRIANGLES / 1000);
    CHECK(seen.interpolated_gated > TRIANGLES / 100);
    CHECK(seen.curved[0] > TRIANGLES / 100);
    CHECK(seen.curved[1] > TRIANGLES / 1000);
    CHECK(seen.cut[0] > TRIANGLES / 1000);
    CHECK(seen.cut[1] > TRIANGLES / 1000);
    test_write("  entries read: diffuse ");
    test_write_number(seen.diffuse_most);
    test_write(", gated ");
    test_write_number(seen.gated_most);
    test_write(" of 272, specular ");
    test_write_number(seen.specular_most);
    test_write(" and ");
    test_write_number(seen.bent_most);
    test_write(" of 1024, root ");
    test_write_number(seen.root_most);
    test_write(" of 768; least N.L ");
    test_write_number(seen.diffuse_least);
    test_write(";\n  channels ");
    test_write_number(seen.channel_least);
    test_write(" to ");
    test_write_number(seen.channel_most);
    test_write(" of 2^27\n");
    CHECK(seen.diffuse_least > 0);
    CHECK(seen.diffuse_most >= 256); /* what lengthening makes */
    CHECK_AT_MOST(seen.diffuse_most, GLINT_DIFFUSE_ENTRIES - 1);
    CHECK_AT_MOST(seen.gated_most, GLINT_DIFFUSE_ENTRIES - 1);
    CHECK_AT_MOST(seen.specular_most, 1023);
    CHECK_AT_MOST(seen.stepped_most, INT32_MAX);
    CHECK_AT_MOST(seen.bent_most, 1023);
    CHECK_AT_MOST(seen.root_most, 767);
    CHECK_AT_MOST(-seen.channel_least, GLINT_CHANNEL_ONE / 4096);
    CHECK_AT_MOST(seen.channel_most, GLINT_CHANNEL_ONE + GLINT_CHANNEL_ONE / 4096);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(every_read_is_in_its_table)};
    return test_run(write, cases, TEST_COUNT(cases));
}
