/* SPDX-License-Identifier: MIT */
/* Suite: directions and strengths of point lights against long double, at the errors point.h states; and how near they
 * are as nodes keep it; cosines of cones, and which objects these miss; and where polynomials tell that a light's
 * highlight ends. */
#include "light/point.h"
#include "frame/frame.h"
#include "glint.h"
#include "harness.h"
#include "nodes/nearness.h"
#include "nodes/shapes.h"
#include "raster/setup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LIGHTS 100000

/* A linear congruential generator (Knuth, MMIX); its high half. */
static uint32_t random_bits(void) {
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 32);
}

static int32_t random_from(int32_t least, int32_t most) {
    return least + (int32_t)(random_bits() % (uint32_t)(most - least + 1));
}

/* Up to 2^bits in either direction, for a number of bits from `least` to `most`. */
static int32_t random_signed(int32_t least, int32_t most) {
    return (int32_t)random_bits() >> (31 - random_from(least, most));
}

/* Anywhere; attenuation from what shows at no distance to what leaves nothing; sometimes of one kind,
 * or none. */
static void make_light(glint_prepared_light *prepared) {
    glint_light light = {.type = &glint_light_point};
    if (random_bits() & 3)
        light.linear = (int32_t)(random_bits() >> random_from(1, 31));
    if (random_bits() & 3)
        light.quadratic = (int32_t)(random_bits() >> random_from(1, 31));
    CHECK_EQUAL(glint_point_attenuation(&light, prepared), GLINT_OK);
    for (int c = 0; c < 3; c++)
        prepared->point.mantissa[c] = random_signed(20, 29);
    prepared->point.shift = random_from(-17, 62);
}

static void make_fragments(glint_fragments *fragments) {
    fragments->count = GLINT_FRAGMENTS_MAX;
    for (uint32_t i = 0; i < fragments->count; i++) {
        const int32_t bits = random_from(20, 30);
        fragments->inverse_w[i] = (int32_t)(random_bits() >> random_from(1, 25)) + 1;
        for (int c = 0; c < 3; c++)
            fragments->ray[i][c] = random_signed(bits, bits);
    }
}

static long double find_vector(const glint_prepared_light *light, const glint_fragments *fragments, uint32_t i,
                               long double v[3]) {
    for (int c = 0; c < 3; c++)
        v[c] = ldexpl((long double)light->point.mantissa[c] * fragments->inverse_w[i], -light->point.shift) +
               fragments->ray[i][c];
    return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Distances in world units about 1 at the first fragment, or up to 2^16 times more or less. */
static void attenuate_about(glint_prepared_light *light, const glint_fragments *fragments) {
    long double v[3];
    const long double ratio = find_vector(light, fragments, 0, v) / fragments->inverse_w[0];
    light->point.distance_mantissa = (int32_t)(0x40000000u | random_bits() >> 2);
    const int shift = (int)ceill(log2l(ratio)) + 30 + random_from(-16, 16);
    light->point.linear_shift -= shift;
    light->point.quadratic_shift -= 2 * shift;
}

/* The share of light left at such a distance. */
static long double find_strength(const glint_prepared_light *light, const glint_fragments *fragments, uint32_t i,
                                 long double length) {
    if (!light->point.linear && !light->point.quadratic)
        return 1;
    const long double d = length * GLINT_UNIT / 32768 / fragments->inverse_w[i] * light->point.distance_mantissa;
    return 1 / (1 + ldexpl(light->point.linear * d, light->point.linear_shift - 33) +
                ldexpl(light->point.quadratic * d * d, light->point.quadratic_shift - 50));
}

/* Largest errors found: of a direction's component, of strength, in steps. */
typedef struct worst_errors {
    long double direction, strength;
} worst_errors;

/* Is the vector to the light short in the ray's steps, or against the ray? Then rounding to steps is what counts. */
static int is_short(long double length, const int32_t ray[3]) {
    const long double to_eye = sqrtl(powl(ray[0], 2) + powl(ray[1], 2) + powl(ray[2], 2));
    return length < 1 << 18 || length < to_eye / (1 << 13);
}

/* @return 0 for what is short */
static int measure(const glint_prepared_light *light, const glint_fragments *f, uint32_t i, worst_errors *worst) {
    long double v[3];
    const long double length = find_vector(light, f, i, v);
    if (is_short(length, f->ray[i]))
        return 0;
    for (int c = 0; c < 3; c++)
        worst->direction = fmaxl(worst->direction, fabsl(f->light[i][c] - GLINT_UNIT * v[c] / length));
    const long double exact = 32768 * find_strength(light, f, i, length);
    worst->strength = fmaxl(worst->strength, fabsl(f->strength[i] - exact));
    return 1;
}

/* Says how much of what is allowed was found; fails above 1, and below 1/2, where less could be stated. */
static void report(const char *name, long double worst, long double allowed) {
    test_write("  ");
    test_write(name);
    test_write(": ");
    test_write_number((int64_t)(worst / allowed * 1000));
    test_write(" thousandths of the error allowed\n");
    CHECK(worst <= allowed);
    CHECK(worst >= allowed / 2);
}

static void lights_of_every_size_and_place(void) {
    worst_errors worst = {0};
    int measured = 0;
    for (int n = 0; n < LIGHTS; n++) {
        glint_prepared_light light;
        glint_fragments fragments;
        make_light(&light);
        make_fragments(&fragments);
        fragments.is_gated = 0;
        attenuate_about(&light, &fragments);
        glint_point_illuminate(&light, &fragments);
        for (uint32_t i = 0; i < fragments.count; i++)
            measured += measure(&light, &fragments, i, &worst);
    }
    CHECK(measured > LIGHTS * 4);
    report("direction", worst.direction, 2.4L);
    report("strength", worst.strength, 3.4L);
}

/* A light so many steps from a fragment, along an axis, whose ray is longest along another. */
static void check_at_light(int ray_axis, int light_axis, int32_t ray_sign, unsigned bits) {
    const int32_t apart = bits ? 1 << (bits - 1) : 0;
    glint_prepared_light light;
    glint_fragments at;
    make_light(&light);
    at.count = 1;
    at.is_gated = 0;
    at.inverse_w[0] = 1 << 30;
    light.point.shift = 32;
    for (int c = 0; c < 3; c++) {
        at.ray[0][c] = c == ray_axis ? ray_sign * ((1 << 27) + (1 << 20)) : 1 << 10;
        light.point.mantissa[c] = 4 * ((c == light_axis ? apart : 0) - at.ray[0][c]);
    }
    glint_point_illuminate(&light, &at);
    CHECK_EQUAL(at.length[0] == 0, bits + 15 <= 28);
    if (!at.length[0])
        CHECK_EQUAL(at.strength[0], 0);
}

/* What decides is the longest component of the ray, and of the way to the light, whichever these are. */
static void lights_where_fragments_are(void) {
    for (int axes = 0; axes < 9; axes++)
        for (unsigned bits = 0; bits < 28; bits++) {
            check_at_light(axes / 3, axes % 3, 1, bits);
            check_at_light(axes / 3, axes % 3, -1, bits);
        }
}

/* What is kept errs to the safe side, by no more than its bits. */
static void nearness_of_every_closeness(void) {
    int unsafe = 0, far_off = 0, unlike = 0;
    for (uint32_t closeness = 0; closeness <= UINT16_MAX; closeness++) {
        const uint32_t half = closeness & INT16_MAX, nearness = glint_nearness_of(closeness, half),
                       found = glint_closeness_of(nearness), found_half = (nearness & 0x7f) << 8,
                       other = glint_nearness_of(UINT16_MAX - closeness, INT16_MAX - half),
                       both = glint_nearness_of_both(nearness, other);
        unsafe += found < closeness || found_half > half || nearness > UINT16_MAX;
        far_off += 32 * (found - closeness) > closeness || half - found_half > 255;
        unlike += (both >> 7) != (nearness > other ? nearness : other) >> 7 ||
                  (both & 0x7f) != ((nearness & 0x7f) < (other & 0x7f) ? nearness & 0x7f : other & 0x7f);
    }
    CHECK_EQUAL(unsafe, 0);
    CHECK_EQUAL(far_off, 0);
    CHECK_EQUAL(unlike, 0);
}

/* ---- Spots ---- */

static double between(double a, double b) {
    return a + (b - a) * (random_bits() >> 8) / 16777216.0;
}

/* Any direction, of length 1. */
static void make_direction(double v[3]) {
    double square;
    do {
        for (int c = 0; c < 3; c++)
            v[c] = between(-1, 1);
        square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    } while (square > 1 || square < 0.01);
    for (int c = 0; c < 3; c++)
        v[c] /= sqrt(square);
}

static void round_direction(const double v[3], int16_t rounded[3]) {
    int32_t wide[3];
    for (int c = 0; c < 3; c++)
        wide[c] = (int32_t)lrint(v[c] * 0x1p28);
    glint_unit(wide[0], wide[1], wide[2], rounded);
}

/* Of a cone's cosine what turns a direction shows, not what lengthens it. */
static void cosines_of_cones(void) {
    double worst = 0, worst_without = 0;
    for (int i = 0; i < 1000000; i++) {
        double axis[3], beside[3], way[3], square = 0, cosine = 0;
        const double lean = between(0, 0.35);
        glint_prepared_light light;
        int16_t direction[3];
        make_direction(axis);
        make_direction(beside);
        for (int c = 0; c < 3; c++) {
            way[c] = axis[c] + lean * beside[c];
            square += way[c] * way[c];
            cosine += way[c] * axis[c];
        }
        for (int c = 0; c < 3; c++)
            way[c] /= sqrt(square);
        round_direction(axis, light.direction);
        round_direction(way, direction);
        const double unit = (double)GLINT_UNIT * GLINT_UNIT, exact = cosine / sqrt(square);
        const double longer = 1 + glint_square_excess(light.direction) / unit / 2;
        worst = fmax(worst, fabs(glint_cone_cosine(&light, direction) / unit / longer - exact));
        worst_without = fmax(worst_without, fabs(glint_dot(direction, light.direction) / unit - exact));
    }
    report("cosines within 20 degrees of an axis", worst, 0.8 / 32768);
    CHECK(worst_without > 2.0 / 32768);
}

/* Objects that they miss. */

static glint_q16 to_q16(double x) {
    return (glint_q16)lrint(x * GLINT_ONE);
}

/* A box turned and scaled, a camera turned, and a spot, all in a world of one size between 1/2 and 2^12. */
typedef struct spot_and_box {
    glint_light light;
    glint_prepared_light prepared;
    glint_view view;
    glint_mesh mesh;
    glint_object object;
} spot_and_box;

static void make_spot_and_box(spot_and_box *s) {
    const double world = exp2(between(-1, 12)), size = world * exp2(between(-6, 0));
    const glint_pose across = glint_pose_rotate_y(to_q16(between(0, 360))),
                     down = glint_pose_rotate_x(to_q16(between(-90, 90))),
                     scaled =
                         glint_pose_scale(to_q16(between(0.5, 2)), to_q16(between(0.5, 2)), to_q16(between(0.5, 2))),
                     camera = glint_pose_then(&down, &across);
    *s = (spot_and_box){.light = {.type = &glint_light_spot}};
    s->light.vector =
        (glint_vector){to_q16(between(-1, 1) * world), to_q16(between(-1, 1) * world), to_q16(between(-1, 1) * world)};
    s->light.axis = (glint_vector){to_q16(between(-1, 1)), to_q16(between(-1, 1)), to_q16(between(-1, 1))};
    s->light.outer = to_q16(between(0, 120));
    s->mesh.extent =
        (glint_vector){to_q16(between(0, 1) * size), to_q16(between(0, 1) * size), to_q16(between(0, 1) * size)};
    s->mesh.offset =
        (glint_vector){to_q16(between(-1, 1) * size), to_q16(between(-1, 1) * size), to_q16(between(-1, 1) * size)};
    s->object.mesh = &s->mesh;
    s->object.pose = glint_pose_then(&scaled, &camera);
    s->object.pose.m[0][3] = to_q16(between(-1, 1) * world);
    s->object.pose.m[1][3] = to_q16(between(-1, 1) * world);
    s->object.pose.m[2][3] = to_q16(between(-1, 1) * world);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            s->view.rotation[i][j] = camera.m[j][i];
}

/* How far the box's sphere lies outside the cone, over its middle's distance; the least where that is within the box.
 */
static double find_outside(const spot_and_box *s) {
    const double axis[3] = {s->light.axis.x, s->light.axis.y, s->light.axis.z},
                 at[3] = {s->light.vector.x, s->light.vector.y, s->light.vector.z},
                 extent[3] = {s->mesh.extent.x, s->mesh.extent.y, s->mesh.extent.z},
                 offset[3] = {s->mesh.offset.x, s->mesh.offset.y, s->mesh.offset.z};
    const double angle = s->light.outer / 65536.0 * acos(-1) / 180,
                 length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    double along = 0, square = 0, radius = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t *const m = s->object.pose.m[i];
        const double way = m[3] + (m[0] * offset[0] + m[1] * offset[1] + m[2] * offset[2]) / 65536 - at[i];
        along += way * axis[i] / length;
        square += way * way;
    }
    for (int corner = 0; corner < 4; corner++) {
        double reach = 0;
        for (int i = 0; i < 3; i++) {
            const int32_t *const m = s->object.pose.m[i];
            const double x = (m[0] * extent[0] + (corner & 1 ? -1 : 1) * m[1] * extent[1] +
                              (corner & 2 ? -1 : 1) * m[2] * extent[2]) /
                             65536;
            reach += x * x;
        }
        radius = fmax(radius, sqrt(reach));
    }
    return radius * radius >= square
               ? -1
               : (sqrt(fmax(square - along * along, 0)) * cos(angle) - along * sin(angle) - radius) / sqrt(square);
}

/* An object is left out only where it lies outside, and left in only where it hardly does. */
static void objects_that_spots_miss(void) {
    int left_out = 0, left_in = 0;
    for (int n = 0; n < LIGHTS; n++) {
        spot_and_box s;
        make_spot_and_box(&s);
        if (glint_light_spot.prepare(&s.light, &s.prepared, &s.view) != GLINT_OK)
            continue; /* the axis has no length */
        const int misses = glint_light_spot.misses(&s.light, &s.prepared, &s.view, &s.object);
        const double outside = find_outside(&s);
        left_out += misses;
        left_in += !misses;
        if (misses && !CHECK(outside > 1.0 / 64))
            return;
        if (!misses && s.light.outer < 89 * GLINT_ONE && !CHECK(outside < 4.5 / 64))
            return;
    }
    CHECK(left_out > LIGHTS / 4 && left_in > LIGHTS / 4);
}

/* ---- Where the light of squares ends ---- */

enum { SIDES = 3, SQUARE_SHIFT = 2 };

/* A frame of a triangle that three lights shine on, so that there is a draw whose material has terms. */
typedef struct lit_triangle {
    glint_light lights[SIDES];
    glint_material material;
    glint_object object;
    glint_scene scene;
    glint_frame frame;
    void *arena[8192];
} lit_triangle;

static int begin_lit_triangle(lit_triangle *t, uint32_t flags) {
    static const int16_t positions[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}},
                         normals[3][3] = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    static const glint_mesh mesh = {.positions = positions,
                                    .normals = normals,
                                    .triangles = triangle,
                                    .vertex_count = 3,
                                    .triangle_count = 1,
                                    .extent = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    const glint_colour half = {GLINT_ONE / 2, GLINT_ONE / 2, GLINT_ONE / 2};
    const glint_config config = {
        .width = 64, .height = 64, .format = &glint_format_rgb888, .arena = t->arena, .arena_size = sizeof t->arena};
    for (int l = 0; l < SIDES; l++)
        t->lights[l] = (glint_light){.type = &glint_light_directional,
                                     .vector = {l * GLINT_ONE / 4, 0, GLINT_ONE},
                                     .diffuse = half,
                                     .specular = half};
    t->material = (glint_material){.model = &glint_model_blinn_phong,
                                   .diffuse = half,
                                   .specular = half,
                                   .shininess = 20 * GLINT_ONE,
                                   .flags = flags};
    t->object = (glint_object){
        .mesh = &mesh, .material = &t->material, .pose = glint_pose_identity(), .evaluation = &glint_per_node};
    t->object.pose.m[2][3] = -4 * GLINT_ONE;
    t->scene = (glint_scene){.camera = {glint_pose_identity(), 45 * GLINT_ONE, GLINT_ONE / 8},
                             .lights = t->lights,
                             .light_count = SIDES,
                             .viewer = GLINT_VIEWER_INFINITE,
                             .objects = &t->object,
                             .object_count = 1};
    return CHECK_EQUAL(glint_frame_begin(&t->frame, &config, &t->scene), GLINT_OK) &&
           CHECK_EQUAL(glint_frame_next(&t->frame), 1) && CHECK(t->frame.draws && t->frame.draws->shading->terms);
}

/* N.L of one light at a square's nodes; and two nodes whose normals lean, Q14, one to the left, the other to the right.
 */
typedef struct square_sides {
    int light, end, bend[2], at[2], is_below;
    int leaning[2], lean;
} square_sides;

/*
 * From -1 to 1 across and down it is end + bend[0] (u - at[0] / 4)^2 + bend[1] (v - at[1] / 4)^2, or less 0 by that: at
 * one of the square's pixels it comes as near to 0 as `end`.
 */
static int16_t side_at(const square_sides *s, int i) {
    const int u = 4 * (i % 3 - 1) - s->at[0], v = 4 * (i / 3 - 1) - s->at[1];
    const int side = s->end + s->bend[0] / 16 * u * u + s->bend[1] / 16 * v * v;
    return (int16_t)(s->is_below ? -side : side);
}

/* The terms of a square that faces the eye, so that all highlights show; it clearly faces the other lights. */
static int begin_square(const lit_triangle *t, const square_sides *s, glint_terms *terms,
                        glint_polynomials *polynomials) {
    static const glint_part part;
    glint_node nodes[GLINT_CELL_NODES] = {{{0}, {0}, {{0}}, 0, {0}, {0}, 0, 0, 0, 0, 0, 0, 0, 0}};
    glint_node *at[GLINT_CELL_NODES];
    glint_shape shape;
    for (int i = 0; i < GLINT_CELL_NODES; i++) {
        at[i] = &nodes[i];
        nodes[i].inverse_w = 1 << 30;
        nodes[i].normal[2] = 1 << 14;
        nodes[i].lit = (uint8_t)(((1 << SIDES) - 1) & ~(1 << s->light));
        for (int l = 0; l < SIDES; l++) {
            nodes[i].number[l][GLINT_SIDE] = l == s->light ? side_at(s, i) : (int16_t)(200 + 1000 * i);
            nodes[i].number[l][GLINT_STRENGTH] = 1 << 14;
        }
    }
    nodes[s->leaning[0]].normal[0] = (int16_t)-s->lean;
    nodes[s->leaning[1]].normal[0] = (int16_t)s->lean;
    glint_shape_cell(&part, (1u << SIDES) - 1, 0, 0, SQUARE_SHIFT, &shape);
    return glint_shape_begin(&t->frame, t->frame.draws, &shape, at, terms, polynomials);
}

/* How near to 0 its polynomial comes, Q16. */
static int32_t nearest_of(const square_sides *s, const glint_quadratic *side) {
    int32_t nearest = INT32_MAX;
    for (int32_t y = 0; y <= 2 << SQUARE_SHIFT; y++)
        for (int32_t x = 0; x <= 2 << SQUARE_SHIFT; x++) {
            const int32_t value = (int32_t)glint_stride_begin(side, x, y).value;
            nearest = glint_least(nearest, s->is_below ? -value : value);
        }
    return nearest;
}

/* How near to 0 pixels are looked at one by one; 0 where none are. */
static int32_t margin_of(const lit_triangle *t, const square_sides *s) {
    glint_terms terms;
    glint_polynomials polynomials;
    if (!CHECK(begin_square(t, s, &terms, &polynomials)) || !CHECK_EQUAL(terms.apart_count, 1))
        return -1;
    const int32_t nearest = nearest_of(s, &polynomials.of[terms.apart[0].first]);
    CHECK(terms.apart[0].light == s->light && nearest >= (s->end - 1) * 65536 && nearest <= (s->end + 1) * 65536);
    return terms.margin;
}

/* None is forgotten, wherever between the nodes the light comes as near to its edge as its margin. */
static void check_edges(const lit_triangle *t, square_sides s, int32_t margin) {
    s.end = margin;
    for (s.at[0] = -4; s.at[0] <= 4; s.at[0]++)
        for (s.at[1] = -4; s.at[1] <= 4; s.at[1]++)
            for (int i = 0; i < 9; i++) {
                s.bend[0] = i / 3 * 320;
                s.bend[1] = i % 3 * 320;
                CHECK_EQUAL(margin_of(t, &s), margin);
            }
}

/* Half way between nodes that is where they are further away by an eighth of what they differ by, and no other is. */
static void check_half_way(const lit_triangle *t, square_sides s, int32_t margin) {
    for (int way = 0; way < 4; way++)
        for (s.bend[0] = 16; s.bend[0] <= 1600; s.bend[0] += 16) {
            s.bend[1] = s.bend[0];
            s.at[0] = way & 1 ? 2 : -2;
            s.at[1] = way & 2 ? 2 : -2;
            s.end = margin;
            CHECK_EQUAL(margin_of(t, &s), margin);
            s.end = margin + 1;
            CHECK_EQUAL(margin_of(t, &s), 0);
        }
}

static void edges_of_squares(void) {
    static lit_triangle t;
    for (int i = 0; i < 2 * SIDES; i++) {
        const square_sides s = {i / 2, 0, {320, 320}, {1, 1}, i % 2, {0, 1}, 0};
        if (!begin_lit_triangle(&t, 0))
            return;
        const int32_t margin = margin_of(&t, &s);
        CHECK(margin > 0 && margin < 64);
        check_edges(&t, s, margin);
        check_half_way(&t, s, margin);
        if (begin_lit_triangle(&t, GLINT_MATERIAL_UNGATED))
            CHECK_EQUAL(margin_of(&t, &s), 0);
    }
}

/* How far two nodes of a square may lean at most. */
static int most_lean(const lit_triangle *t, int a, int b) {
    square_sides s = {0, 1 << 13, {0, 0}, {0, 0}, 0, {a, b}, 0};
    glint_terms terms;
    glint_polynomials polynomials;
    while (s.lean < 1 << 13 && begin_square(t, &s, &terms, &polynomials))
        s.lean++;
    return s.lean;
}

/*
 * What normals turn by from the middle to a corner, or from node to node along an edge, counts twice as much as from
 * corner to corner: the same wherever it is. Of two corners that lean, or of the middle and an edge's, each leans from
 * a node that does not, by half of what two neighbours lean apart.
 */
static void turns_of_squares(void) {
    static const int far[][2] = {{0, 2}, {0, 6}, {2, 8}, {6, 8}, {0, 8}, {2, 6}, {1, 4}, {3, 4}, {5, 4}, {7, 4}},
                     near[][2] = {{0, 1}, {1, 2}, {2, 5}, {5, 8}, {8, 7}, {7, 6},
                                  {6, 3}, {3, 0}, {0, 4}, {2, 4}, {6, 4}, {8, 4}};
    static lit_triangle t;
    if (!begin_lit_triangle(&t, 0))
        return;
    const int most = most_lean(&t, 0, 2);
    CHECK(most > 100 && most < 1 << 13);
    for (unsigned i = 0; i < TEST_COUNT(far); i++) {
        CHECK_AT_MOST(abs(most_lean(&t, far[i][0], far[i][1]) - most), 4);
        CHECK_AT_MOST(abs(most_lean(&t, far[i][1], far[i][0]) - most), 4);
    }
    for (unsigned i = 0; i < TEST_COUNT(near); i++) {
        CHECK_AT_MOST(abs(2 * most_lean(&t, near[i][0], near[i][1]) - most), 8);
        CHECK_AT_MOST(abs(2 * most_lean(&t, near[i][1], near[i][0]) - most), 8);
    }
}

/* N.L of one light at a triangle's corners, whose normals lean apart by twice so much, Q14; one corner lies further
 * away than the others: its 1/w is 3/4 of theirs. */
typedef struct corner_sides {
    int light, lean;
    int16_t side[3];
    int far;
} corner_sides;

/* What a corner keeps of light: it clearly faces the other lights, and all highlights show. */
static void keep_corner(const lit_triangle *t, const corner_sides *s, int i) {
    static const int leaning[3] = {-1, 1, 0};
    const glint_draw *const draw = t->frame.draws;
    const glint_light_terms *const light = draw->shading->terms;
    int16_t *const kept = draw->nodes + (size_t)i * light->stride, *const rest = kept + light->channels;
    glint_vertex *const vertex = &draw->vertices[i];
    memset(kept, 0, light->stride * sizeof *kept);
    rest[GLINT_KEPT_FACING] = (int16_t)(((1 << SIDES) - 1) & ~(1 << s->light));
    for (int l = 0; l < SIDES; l++)
        kept[light->at[l][GLINT_SIDE]] = l == s->light ? s->side[i] : (int16_t)(200 + 1000 * i);
    vertex->attribute[0] = (int16_t)(leaning[i] * s->lean);
    vertex->attribute[1] = 0;
    vertex->attribute[2] = (int16_t)lrint(sqrt((1 << 28) - s->lean * s->lean * abs(leaning[i])));
    vertex->inverse_w = i == s->far ? 9 << 27 : 3 << 29;
    vertex->flags |= GLINT_VERTEX_LIT;
}

static int begin_triangle(const lit_triangle *t, const corner_sides *s, glint_terms *terms) {
    const glint_draw *const draw = t->frame.draws;
    const glint_vertex *const v = draw->vertices;
    glint_triangle triangle = {.corners = {&v[0], &v[1], &v[2]}};
    glint_polynomials polynomials;
    glint_reach reach;
    glint_part part;
    for (int i = 0; i < 3; i++)
        keep_corner(t, s, i);
    glint_window_begin(&part.window, 16, 16, 32, 32);
    if (!CHECK(glint_raster(&part, triangle.corners)))
        return 0;
    glint_setup(&part, &triangle);
    return glint_terms_begin(&t->frame, draw, &triangle, &part, terms, &polynomials, &reach);
}

/*
 * Pixels are looked at one by one where a corner's light is as near to its edge as the margin, and nowhere else. Over
 * length it is so much nearer as the corner is further away.
 */
static void check_corner(const lit_triangle *t, corner_sides s, int near, int is_over_length) {
    glint_terms terms;
    s.side[near] = 1;
    if (!CHECK(begin_triangle(t, &s, &terms)) || !CHECK(terms.margin > 0 && terms.margin < 400))
        return;
    const int32_t margin = terms.margin, nearer = s.far == near && is_over_length,
                  ends[2] = {nearer ? margin * 4 / 3 : margin, nearer ? (margin * 4 + 6) / 3 : margin + 1};
    for (int i = 0; i < 4; i++) {
        for (int corner = 0; corner < 3; corner++) {
            const int32_t side = ends[i / 2] + (corner == near ? 0 : 300 * (corner + 1));
            s.side[corner] = (int16_t)(i % 2 ? -side : side);
        }
        CHECK(begin_triangle(t, &s, &terms));
        CHECK_EQUAL(terms.margin, i / 2 ? 0 : margin);
        CHECK_EQUAL(terms.is_over_length, is_over_length);
    }
}

/* Normals from alike to far apart: by quadratics, and by those over length. */
static void edges_of_triangles(void) {
    static lit_triangle t;
    int found[2] = {0, 0}; /* not over length, over it */
    for (int i = 0; i < 40 * 3 * SIDES; i++) {
        corner_sides s = {i % SIDES, i / (3 * SIDES) * 200, {1, 200, 300}, i / SIDES % 3};
        glint_terms terms;
        if (!begin_lit_triangle(&t, 0))
            return;
        if (!begin_triangle(&t, &s, &terms))
            continue;
        found[terms.is_over_length]++;
        for (int near = 0; near < 3; near++)
            check_corner(&t, s, near, terms.is_over_length);
        if (begin_lit_triangle(&t, GLINT_MATERIAL_UNGATED) && begin_triangle(&t, &s, &terms))
            CHECK_EQUAL(terms.margin, 0);
    }
    CHECK(found[0] > 20 && found[1] > 20);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(lights_of_every_size_and_place),
        TEST_CASE(lights_where_fragments_are),
        TEST_CASE(nearness_of_every_closeness),
        TEST_CASE(cosines_of_cones),
        TEST_CASE(objects_that_spots_miss),
        TEST_CASE(edges_of_squares),
        TEST_CASE(turns_of_squares),
        TEST_CASE(edges_of_triangles),
    };
    return test_run(write, cases, TEST_COUNT(cases));
}
