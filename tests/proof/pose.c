/* SPDX-License-Identifier: MIT */
/* Poses, cameras, lights and paints. */
#include "proof.h"

#include "../../src/scene/helpers.c"
#include "contracts.h"

/* Stands on the root being that of a square of 2^58 to 3 2^60, by glint_square_root: `numbers` tries 200,000 cameras,
 * and runs under UBSan. */
/*@ requires \valid_read(in + (0 .. 2)) && \valid(out + (0 .. 2));
    assigns \result, out[0 .. 2] \from in[0 .. 2];
    admit ensures \result == 0 || \result == 1;
    admit ensures \result == 0 || \initialized(out + (0 .. 2));
    admit ensures \result == 0 || -0x20000 <= out[0] <= 0x20000;
    admit ensures \result == 0 || -0x20000 <= out[1] <= 0x20000;
    admit ensures \result == 0 || -0x20000 <= out[2] <= 0x20000; */
static int normalise(const int64_t in[3], glint_q16 out[3]);

/*@ requires \valid_read(first) && \valid_read(second);
    assigns \result \from *first, *second; */
glint_pose glint_pose_then(const glint_pose *first, const glint_pose *second);

/*
 * Not proven: glint_pose_rotate, glint_pose_quaternion, glint_camera_project: quotients of lengths and of squares that
 * are no less than their parts. Suite `camera` under UBSan: 100,000 turns of each kind, 200,000 points.
 */

static glint_pose any_pose(void) {
    glint_pose pose;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            pose.m[i][j] = ANY_INT;
    return pose;
}

static glint_vector any_vector(void) {
    const glint_vector vector = {ANY_INT, ANY_INT, ANY_INT};
    return vector;
}

/* Any angle. @contract glint_sine glint_phase */
PROOF(glint_sin) {
    glint_sin(ANY_INT);
}

/* Any angle. @contract glint_sine glint_phase */
PROOF(glint_cos) {
    glint_cos(ANY_INT);
}

/* Any angle, about every axis. @contract glint_sin glint_cos */
PROOF(glint_pose_rotate_x) {
    glint_pose_rotate_x(ANY_INT);
    glint_pose_rotate_y(ANY_INT);
    glint_pose_rotate_z(ANY_INT);
}

/* Any two poses. */
PROOF(glint_pose_then) {
    const glint_pose first = any_pose(), second = any_pose();
    glint_pose_then(&first, &second);
}

/* Any pose and point. */
PROOF(glint_pose_apply) {
    const glint_pose pose = any_pose();
    glint_pose_apply(&pose, any_vector());
}

/* Any camera, target, angles and distance. @contract glint_sin glint_cos glint_pose_then */
PROOF(glint_camera_orbit) {
    glint_camera camera;
    glint_camera_orbit(&camera, any_vector(), ANY_INT, ANY_INT, ANY_INT);
}

/* Any eye, target and up. @contract normalise */
PROOF(glint_camera_look_at) {
    glint_camera camera;
    glint_camera_look_at(0, any_vector(), any_vector(), any_vector());
    glint_camera_look_at(&camera, any_vector(), any_vector(), any_vector());
}

/* Any place, colour and range. @narrowing what is left of the square is below it, so that over the range it is below
 * that */
PROOF(glint_lamp) {
    const glint_colour colour = {ANY_INT, ANY_INT, ANY_INT};
    glint_lamp(any_vector(), colour, ANY_INT);
}

/* Any paint and fraction of 0 to 1, any shininess. */
PROOF(glint_material_paint) {
    const glint_colour paint = {ANY(0, GLINT_COLOUR_MAX), ANY(0, GLINT_COLOUR_MAX), ANY(0, GLINT_COLOUR_MAX)};
    glint_material_paint(0, paint, ANY(0, GLINT_ONE), ANY_INT);
}
