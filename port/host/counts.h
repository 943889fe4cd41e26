/* SPDX-License-Identifier: MIT */
/**
 * @file counts.h
 * What a frame consists of, counted while it is drawn: what a cost model prices (cost.h). glint_stats tells most. Of
 * light that is found at points, calls from one of the library's files to another are counted, which the linker leads
 * through here (--wrap): drawing for a board takes nothing for it.
 */
#ifndef GLINT_HOST_COUNTS_H
#define GLINT_HOST_COUNTS_H

#include "glint.h"

/** Each item: its name, and what one of it is. */
#define COUNTS_ITEMS(X)                                                                       \
    X(frame, "a frame")                                                                       \
    X(object, "an object that may show")                                                      \
    X(material, "a material prepared")                                                        \
    X(fast_material, "tables of fast lighting for a material")                                \
    X(vertex, "a vertex transformed")                                                         \
    X(triangle, "a triangle looked at")                                                       \
    X(shown, "a triangle that faces the eye and is on the screen")                            \
    X(reference, "a triangle put into a tile")                                                \
    X(tile, "a tile sent")                                                                    \
    X(byte, "a byte sent")                                                                    \
    X(cleared, "a pixel of a tile that is cleared")                                           \
    X(general_part, "a part of a triangle, in one tile, lit by fragments or on the lattice")  \
    X(general_pixel, "a pixel of such a part")                                                \
    X(ambient_part, "a part that no light reaches")                                           \
    X(ambient_pixel, "a pixel of such a part")                                                \
    X(diffuse_part, "a part without highlight, fast lighting")                                \
    X(diffuse_pixel, "a pixel of such a part")                                                \
    X(gated_part, "a part that the light reaches in part, without highlight, fast lighting")  \
    X(gated_pixel, "a pixel of such a part")                                                  \
    X(specular_part, "a part with a highlight, fast lighting")                                \
    X(specular_pixel, "a pixel of such a part")                                               \
    X(curved_diffuse_part, "a part whose normals turn far, without highlight, fast lighting") \
    X(curved_diffuse_pixel, "a pixel of such a part")                                         \
    X(curved_specular_part, "a part whose normals turn far, with a highlight, fast lighting") \
    X(curved_specular_pixel, "a pixel of such a part")                                        \
    X(curved_local_part, "the local viewer, for such a part")                                 \
    X(even_part, "a part of one colour")                                                      \
    X(even_pixel, "a pixel of such a part")                                                   \
    X(facet_part, "a part lit once a facet, more")                                            \
    X(channels_pixel, "a pixel of a part lit at corners or at nodes")                         \
    X(corner_part, "a part lit at corners")                                                   \
    X(corner_row, "a row of such a part")                                                     \
    X(lit, "a fragment, vertex or facet lit exactly")                                         \
    X(lit_by_directional, "a directional light on it")                                        \
    X(lit_by_point, "a point light on it")                                                    \
    X(lit_by_spot, "a spot on it")                                                            \
    X(lit_highlight, "a highlight on it")                                                     \
    X(stored, "a fragment gathered and stored")                                               \
    X(node, "a node")                                                                         \
    X(node_by_directional, "a directional light at a node")                                   \
    X(node_by_point, "a point light at a node")                                               \
    X(node_by_spot, "a spot at a node")                                                       \
    X(node_highlight, "a highlight at a node")                                                \
    X(region, "a part of a triangle for which polynomials are tried")                         \
    X(curved_region, "one drawn by quadratics, more")                                         \
    X(shape, "a square or a piece for which they are tried")                                  \
    X(polynomial, "a polynomial of any of these")                                             \
    X(quadratic, "a quadratic through corners and middles, more")                             \
    X(term_row, "a row of a part, a square or a piece drawn term by term")                    \
    X(term_pixel, "a pixel of such a row")                                                    \
    X(length_pixel, "one over the normal's length, more")                                     \
    X(side_pixel, "a light with terms of its own, at a pixel")                                \
    X(lobe_pixel, "a highlight at a pixel")                                                   \
    X(wide_lobe_pixel, "one of a wide highlight, more")                                       \
    X(surface_pixel, "the surface's colours at a pixel")                                      \
    X(gamma_pixel, "a pixel through output tables")                                           \
    X(spread_pixel, "a pixel that fast lighting leaves to the format to pack")                \
    X(dithered_pixel, "a lit pixel dithered")                                                 \
    X(dithered_even_pixel, "a pixel of one colour dithered")                                  \
    X(grey_pixel, "a pixel of one channel")                                                   \
    X(packed_pixel, "a pixel that is no whole number of bytes")

#define COUNTS_NAME(name, what) COUNTS_##name,
enum { COUNTS_ITEMS(COUNTS_NAME) COUNTS };
#undef COUNTS_NAME

/** What a frame took, and how many of each item it consists of. */
typedef struct frame_counts {
    glint_stats stats;
    double of[COUNTS];
} frame_counts;

/** Draws a frame by a renderer whose configuration has counts_drawn, and counts it. One at a time. */
glint_status counts_render(glint_renderer *renderer, const glint_scene *scene, frame_counts *counts);

#endif
