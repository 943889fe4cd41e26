/* SPDX-License-Identifier: MIT */
/**
 * @file stage.h
 * What the example scenes share: short ways to fill an example_stage.
 */
#ifndef GLINT_EXAMPLE_STAGE_H
#define GLINT_EXAMPLE_STAGE_H

#include "scenes.h"

/** Short names of what initialises a colour and a vector from literals. */
#define RGB(r, g, b) GLINT_COLOUR(r, g, b)
#define GREY(v) RGB(v, v, v)
#define XYZ(x, y, z) GLINT_VECTOR(x, y, z)

#define COUNT_OF(array) ((uint32_t)(sizeof(array) / sizeof((array)[0])))

/** Nothing on the stage: no lights, no objects, white ambient light, which the materials weigh; a local viewer. */
void stage_clear(example_stage *stage, glint_colour background);

/** Sets the camera, y up. `eye` must not be straight above or below `at`. */
void stage_look(example_stage *stage, glint_vector eye, glint_vector at, glint_q16 field_of_view);

/** Adds a directional light of one colour that shines in a direction; the caller may change it. */
glint_light *stage_sun(example_stage *stage, glint_vector direction, glint_colour colour);

/** Adds a point light or a spot of one colour without attenuation; the caller may change it. */
glint_light *stage_lamp(example_stage *stage, const glint_light_type *type, glint_vector position, glint_colour colour);

/** Adds an object with a copy of `material`; the caller may change it. */
glint_object *stage_add(example_stage *stage, const glint_mesh *mesh, const glint_material *material,
                        const glint_pose *pose);

/** Adds an object of the material of the one before. */
glint_object *stage_again(example_stage *stage, const glint_mesh *mesh, const glint_pose *pose);

/** A disc of radius 20 that faces z: its middle, and 8 rings of 24 vertices. Its colours fade from white to black. */
enum { STAGE_DISC_VERTICES = 193 };
extern const glint_mesh stage_disc;

/** Adds a disc of light that faces the camera and fades towards its rim; it is to be set before. */
glint_object *stage_glow(example_stage *stage, glint_vector position, glint_q16 radius, glint_colour colour);

/** Adds fog, from a depth to where nothing else shows. */
void stage_fog(example_stage *stage, const glint_fog_type *type, glint_q16 start, glint_q16 end, glint_colour colour);

/** A scale, a turn about y, and a move. */
glint_pose stage_place(glint_vector scale, glint_q16 turn, glint_vector position);

/** A times b, both Q16.16, rounded to nearest; the product must fit. */
glint_q16 stage_multiply(glint_q16 a, glint_q16 b);

/** A colour times a factor. */
glint_colour stage_times(glint_colour colour, glint_q16 factor);

#endif
