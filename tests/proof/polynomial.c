/* SPDX-License-Identifier: MIT */
/* Quadratics through six nodes. */
#include "proof.h"

#include "../../src/raster/polynomial.c"
#include "plane.h"

/* Terms, of light either way and of colours from 0 up; bulges. */
#define TERM 17000
#define COLOUR 32767
#define BULGE 12096
#define STEPS (3 << 15)

static glint_barycentric narrow_or_wide;

static void any_scale(glint_scale_by *scale, uint32_t most) {
    scale->right = ANY_UNSIGNED(0, most);
    scale->left = ANY_UNSIGNED(0, most);
}

/* Any terms, bulges and gradients. @contract glint_plane_begin */
PROOF(glint_polynomial_begin) {
    glint_gradients g;
    glint_quadratic quadratic;
    int32_t a[3], b[3];
    narrow_or_wide.g = &g;
    narrow_or_wide.x1 = ANY(-32768, 32768);
    narrow_or_wide.y1 = ANY(-32768, 32768);
    narrow_or_wide.x2 = ANY(-32768, 32768);
    narrow_or_wide.y2 = ANY(-32768, 32768);
    any_scale(&narrow_or_wide.slope, 23);
    any_scale(&narrow_or_wide.curve, 31);
    narrow_or_wide.unit = ANY_UNSIGNED(2, 16);
    FOR_PARTS(is_colour, 0, 1) {
        for (int i = 0; i < 3; i++) {
            a[i] = is_colour ? ANY(0, COLOUR) : ANY(-TERM, TERM);
            b[i] = ANY(-BULGE, BULGE);
        }
        any_narrow(&g);
        glint_polynomial_begin(&quadratic, &narrow_or_wide, a, b);
        any_wide(&g);
        glint_polynomial_begin(&quadratic, &narrow_or_wide, a, b);
    }
}

/* Any gradients: narrow ones by the bits of the longest side. @unreached 1 leading zeros of 0 */
PROOF(glint_barycentric_begin) {
    static glint_gradients g;
    const int32_t unit = ANY(12, 16);
    FOR_PARTS(bits, 1, 11) {
        const int32_t longest = bits < 11 ? (1 << bits) - 1 : 1023;
        any_narrow(&g);
        g.reach = ANY_UNSIGNED((1 << (bits - 1)) - 1, longest);
        g.x1 = ANY(-longest - 1, longest);
        g.y1 = ANY(-longest - 1, longest);
        g.x2 = ANY(-longest - 1, longest);
        g.y2 = ANY(-longest - 1, longest);
        glint_barycentric_begin(&narrow_or_wide, &g, unit);
    }
    any_wide(&g);
    glint_barycentric_begin(&narrow_or_wide, &g, unit);
}

/*
 * Any form, of steps of up to 3 2^15 together, by 16ths of that; bulges of 14 bits and both of 15; any gradients.
 * @contract glint_plane_begin
 */
PROOF(glint_form_begin) {
    glint_gradients g;
    glint_quadratic quadratic;
    glint_form form;
    narrow_or_wide.g = &g;
    narrow_or_wide.x1 = ANY(-32768, 32768);
    narrow_or_wide.y1 = ANY(-32768, 32768);
    narrow_or_wide.x2 = ANY(-32768, 32768);
    narrow_or_wide.y2 = ANY(-32768, 32768);
    any_scale(&narrow_or_wide.slope, 23);
    any_scale(&narrow_or_wide.curve, 31);
    narrow_or_wide.unit = ANY_UNSIGNED(2, 16);
    form.a = ANY_INT;
    form.b1 = ANY(-16383, 16383);
    form.b2 = ANY(-16383, 16383);
    form.both = ANY(-32767, 32767);
    FOR_PARTS(part, 0, 15) {
        const int32_t most = STEPS / 16 * ((int)part + 1), rest = STEPS - STEPS / 16 * (int)part;
        FOR_PARTS(is_wide, 0, 1) {
            form.d1 = ANY(-most, most);
            form.d2 = ANY(-rest, rest);
            if (is_wide)
                any_wide(&g);
            else
                any_narrow(&g);
            glint_form_begin(&quadratic, &narrow_or_wide, &form);
        }
    }
}
