/* SPDX-License-Identifier: MIT */
/* Lighting by quadratics that are interpolated. */
#include "proof.h"

#include "../../src/fast/fast_interpolate.c"
#include "../../src/fast/fast_interpolate_prepare.c"
#include "lit.h"
#include "plane.h"

/* Any light's weights stand for those of the one that shows. */
const glint_weights *glint_weights_shown(const glint_shading *shading) {
    return &shading->weights[0];
}

/* Bulges of an edge, and what spreading leaves of terms and bulges. */
#define BULGE_MOST 10848
#define SPREAD_TERM 17000
#define SPREAD_BULGE 12096

/*@ requires \valid(e) && 28672 <= wa <= 32767 && 28672 <= wb <= 32767;
    assigns e->across, e->turn \from indirect: a[0 .. 2], indirect: b[0 .. 2], wa, wb;
    ensures -1168 <= e->across <= 1168 && -16 <= e->turn <= 0x20000; */
static inline void begin_edge(interpolated_edge *e, const int16_t a[3], const int16_t b[3], int32_t wa, int32_t wb);

/*@ requires \valid(e) && -1168 <= e->across <= 1168 && -16 <= e->turn <= 19661;
    assigns e->shorter \from e->across, e->turn;
    ensures -4 <= e->shorter <= 2880; */
static inline void shorten_edge(interpolated_edge *e);

/*@ requires \valid_read(e) && -16384 <= a <= 16384 && -16384 <= b <= 16384;
    requires -1168 <= e->across <= 1168 && -4 <= e->shorter <= 2880;
    assigns \result \from *e, a, b;
    ensures -BULGE_MOST <= \result <= BULGE_MOST; */
static inline int32_t find_bulge(const interpolated_edge *e, int32_t a, int32_t b);

/*@ requires \valid_read(e + (0 .. 2)) && \valid(a + (0 .. 2)) && \valid(b + (0 .. 2));
    requires \subset(a[0 .. 2], (-16384 .. 16384)) && \subset(b[0 .. 2], (-BULGE_MOST .. BULGE_MOST));
    assigns a[0 .. 2], b[0 .. 2] \from e[0 .. 2], a[0 .. 2], b[0 .. 2];
    ensures \subset(a[0 .. 2], (-SPREAD_TERM .. SPREAD_TERM));
    ensures \subset(b[0 .. 2], (-SPREAD_BULGE .. SPREAD_BULGE)); */
static inline void spread(const interpolated_edge e[3], int32_t a[3], int32_t b[3]);

static interpolated_edge edges[3];

/* What find_edges leaves: turns up to 0.6, 1/w up to an eighth apart. */
#define ANY_ACROSS ANY(-1168, 1168)
#define ANY_TURN_OF_EDGE ANY(-16, GLINT_INTERPOLATE_TURN)
#define ANY_SHORTER ANY(-4, 2880)

static void any_edges(void) {
    for (int i = 0; i < 3; i++) {
        edges[i].across = ANY_ACROSS;
        edges[i].turn = ANY_TURN_OF_EDGE;
        edges[i].shorter = ANY_SHORTER;
    }
}

/* Weights of 1/w from 7/8 to 1, any normals. @contract glint_dot */
PROOF(begin_edge) {
    int16_t a[3], b[3];
    interpolated_edge e;
    any_unit(a);
    any_unit(b);
    begin_edge(&e, a, b, ANY(28672, 32767), ANY(28672, 32767));
}

/* Any edge. */
PROOF(shorten_edge) {
    any_edges();
    shorten_edge(&edges[0]);
}

/* Any edge, any terms. */
PROOF(find_bulge) {
    any_edges();
    find_bulge(&edges[0], ANY(-16384, 16384), ANY(-16384, 16384));
}

/* Any edges, any terms and bulges. */
PROOF(spread) {
    int32_t a[3], b[3];
    any_edges();
    for (int i = 0; i < 3; i++) {
        a[i] = ANY(-16384, 16384);
        b[i] = ANY(-BULGE_MOST, BULGE_MOST);
    }
    spread(edges, a, b);
}

/* Any weights. */
PROOF(largest_level) {
    const uint32_t weight[3] = {ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12), ANY_UNSIGNED(0, 16u << 12)};
    largest_level(weight);
}

/* Any error budget. */
PROOF(find_limit) {
    glint_shading shading;
    shading.spare = ANY_UNSIGNED(0, 16u << 12);
    find_limit(&shading, COSINE_LIMIT);
    find_limit(&shading, HIGHLIGHT_LIMIT);
}

/* Any limit and any levels. @options -eva-slevel 0 */
PROOF(find_turn) {
    find_turn(ANY_UNSIGNED(0, 63u << 16), ANY_UNSIGNED(1, 1u << 31));
}

/* Any light. */
PROOF(find_full) {
    glint_material material;
    glint_shading shading;
    any_shading(&shading, &material);
    find_full(&shading);
}

static bulged_deviation deviations;
static glint_fast_terms fast;

static void any_nodes(int32_t term, int32_t bulge) {
    for (int i = 0; i < 3; i++) {
        deviations.x[i] = ANY(-term, term);
        deviations.y[i] = ANY(-term, term);
        deviations.bulge_x[i] = ANY(-bulge, bulge);
        deviations.bulge_y[i] = ANY(-bulge, bulge);
    }
}

/* Any terms, any side of an octagon, any sides and margin. */
PROOF(is_outside_octagon) {
    any_nodes(16384, 0);
    fast.side = ANY(0, 1 << 17);
    fast.side_diagonal = ANY(0, 1 << 18);
    is_outside_octagon(&fast, ANY_UNSIGNED(0, UINT_MAX), &deviations, ANY(-(1 << 14), 1 << 28));
}

/* Any nodes, tables of up to 1024 entries, both margins, any error. */
PROOF(is_beyond) {
    any_nodes(SPREAD_TERM, SPREAD_BULGE);
    fast.side = ANY(0, 5793 + 1024 + 2);
    is_beyond(&fast, &deviations, ANY(16, 256 + MOST_BULGE));
}

/* Any terms and bulges. */
PROOF(find_most) {
    int32_t a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = ANY(-16384, 16384);
        b[i] = ANY(-BULGE_MOST, BULGE_MOST);
    }
    find_most(a, b);
}
