/* SPDX-License-Identifier: MIT */
/**
 * @file gathering.h
 * The contracts of what gathers fragments, which fragments.c is proven to keep.
 */
#ifndef GLINT_PROOF_GATHERING_H
#define GLINT_PROOF_GATHERING_H

#include "../../src/light/fragments.h"
#include "proof.h"

/*@ requires \valid_read(gathering) && \valid(gathering->fragments) && \valid_read(gathering->part);
    requires \valid_read(gathering->draw) && \valid_read(triangle) && \valid_read(main + (0 .. 2));
    requires \valid(attributes);
    assigns *gathering->fragments, *attributes \from *gathering, *triangle, main[0 .. 2];
    ensures gathering->fragments->count == 0 && gathering->fragments->scale <= 30;
    ensures gathering->fragments->part == gathering->part && gathering->fragments->attributes == attributes; */
void glint_gathering_begin(const glint_gathering *gathering, const glint_triangle *triangle,
                           const int16_t *const main[3], glint_attributes *attributes);

/*@ requires \valid_read(gathering) && \valid(gathering->fragments);
    requires gathering->fragments->count <= GLINT_FRAGMENTS_MAX;
    assigns gathering->fragments->count \from \nothing;
    ensures gathering->fragments->count == 0; */
void glint_gathering_store(const glint_gathering *gathering);

#endif
