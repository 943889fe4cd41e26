/* SPDX-License-Identifier: MIT */
/* Cells of the lattice. */
#include "proof.h"

#include "../../src/nodes/cells.c"
#include "lit.h"

/*
 * Not proven: glint_shape_begin, begin_sums, begin_apart, find_shape_region, shape_fits,
 * shape_has_edge, set_through: they walk nodes, and call
 * what is proven. Suite `nodes` under ASan and UBSan, and fuzzing.
 */

/*@ assigns \result \from square;
    ensures \result <= 0x40000; */
uint32_t glint_root_above(uint32_t square);

/*@ requires \valid(region) && all <= 0xff && lights <= 0xff;
    assigns \result, region->near_of[0 .. 7] \from all, lights, *region;
    ensures \result <= 0xff; */
uint32_t glint_region_place(uint32_t all, uint32_t lights, glint_region *region);

/*@ requires \valid_read(w) && \valid(region);
    requires w->least <= 0xffff && 1 <= w->change <= 0x10000;
    assigns region->slant, region->reach \from pixel, longest, *w;
    ensures \initialized(&region->reach) && region->reach <= 0x4000; */
void glint_region_measure(uint32_t pixel, uint32_t longest, const glint_w_range *w, glint_region *region);

static glint_node cell[GLINT_CELL_NODES];
static glint_node *nodes[GLINT_CELL_NODES];
static glint_shape shape;
static glint_part part;
static glint_draw draw;
static glint_shading shading;
static glint_material material;
static glint_light_terms terms;

/* A cell anywhere on the screen, with nodes so far apart. */
static void any_cell(unsigned shift) {
    part.x = ANY(-4096, 4096);
    part.y = ANY(-4096, 4096);
    glint_shape_cell(&part, ANY_UNSIGNED(0, 0xff), ANY(-16, 128), ANY(-16, 128), shift, &shape);
}

/* Nodes of any numbers. */
static void any_nodes(void) {
    any_shading(&shading, &material);
    shading.terms = &terms;
    terms.pixel = ANY_UNSIGNED(1 << 10, 1u << 31);
    draw.shading = &shading;
    for (int i = 0; i < GLINT_CELL_NODES; i++) {
        nodes[i] = &cell[i];
        any_unit(cell[i].normal);
        for (int c = 0; c < 3; c++)
            cell[i].surface[c] = ANY_SHORT;
        for (int l = 0; l < GLINT_LIGHTS_MAX; l++)
            for (int kind = 0; kind < GLINT_NUMBERS; kind++)
                cell[i].number[l][kind] = ANY_SHORT;
        cell[i].inverse_w = ANY_INT;
        cell[i].outside = (uint16_t)ANY(0, UINT16_MAX);
    }
    any_cell(3);
}

/* Any nodes, of cells and of pieces. @contract glint_root_above */
PROOF(find_shape_turn) {
    any_nodes();
    shape.shift = ANY_UNSIGNED(0, 3);
    find_shape_turn(&shape, nodes);
}

/* Any nodes. */
PROOF(find_w_range) {
    glint_w_range w;
    any_nodes();
    if (find_w_range(&shape, nodes, &w)) {
        /*@ assert 1 <= w.least <= 0xffff; */
    }
}

/* Any nodes. */
PROOF(find_colour) {
    any_nodes();
    find_colour(&shape, nodes);
}

/* Any nodes of each light. */
PROOF(find_shape_lobe) {
    any_nodes();
    FOR_PARTS(l, 0, GLINT_LIGHTS_MAX - 1) {
        find_shape_lobe(&shape, nodes, (uint32_t)l);
    }
}

/* Any nodes, of any lights. */
PROOF(find_nodes_nearness) {
    glint_region region;
    any_nodes();
    find_nodes_nearness(ANY_UNSIGNED(0, 0xff), GLINT_CELL_NODES, nodes, &region);
}

/* Any nodes of each light. */
PROOF(shape_keeps_side) {
    any_nodes();
    FOR_PARTS(l, 0, GLINT_LIGHTS_MAX - 1) {
        shape_keeps_side(&shape, nodes, (uint32_t)l, ANY(0, 1 << 16));
    }
}

/* Any nodes. @contract glint_region_place glint_region_measure find_w_range */
PROOF(glint_shape_away) {
    any_nodes();
    glint_shape_away(&draw, &shape, nodes);
}

/* Stands on what it returns where that is not so, as its driver asserts. */
/*@ requires \valid_read(shape) && \valid(w);
    assigns \result, *w \from indirect: *shape, indirect: *nodes;
    ensures \result == 0 || \result == 1;
    admit ensures \result == 0 || (\initialized(w) && 1 <= w->least <= 0xffff && 1 <= w->change <= 0x10000); */
static int find_w_range(const glint_shape *shape, glint_node *const nodes[], glint_w_range *w);

/*
 * Numbers of up to 17 bits and a sign, as channels are with a surface's colours of up to 2; cells of 4, 8 and 16
 * pixels, any unit.
 */
PROOF(fit_cell) {
    glint_quadratic to;
    int32_t n[GLINT_CELL_NODES];
    for (int i = 0; i < GLINT_CELL_NODES; i++)
        n[i] = ANY(-(1 << 16), 1 << 16);
    FOR_PARTS(shift, 1, 3) {
        any_cell((unsigned)shift);
        FOR_PARTS(unit, 12, 16) {
            fit_cell(&shape, n, (int)unit, &to);
        }
    }
}
