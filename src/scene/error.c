/* SPDX-License-Identifier: MIT */
#include "../glint.h"

const char *glint_strerror(int status) {
    static const char *const sentences[] = {
        "no error",
        "a required pointer is null",
        "width or height is not from 1 to 1024",
        "tile width or height is not 8, 16, 32 or 64",
        "the arena is too small for this scene",
        "the camera's axes, field of view, view height or near plane are not valid",
        "more than 8 lights",
        "a light's direction has length 0",
        "a colour, or a light's times a material's, is not from 0 to 16",
        "a shininess exponent is below 0",
        "a mesh's numbers of vertices or triangles, its extent or its clusters are not valid",
        "a triangle refers to a vertex that its mesh does not have",
        "an object's pose is singular",
        "an object is too far from the camera or too large",
        "the flush callback reported a failure",
        "the viewer is neither infinite nor local",
        "an attenuation coefficient is below 0",
        "a spot's cone is wider inside than outside, or not from 0 to 180 degrees",
        "a generator has too few divisions, a size not above 0, or too little room",
        "a number of former versions",
        "a mesh's or a material's flags have an unknown bit",
        "the memory of pixels is smaller than glint_pixels_need tells, or not aligned as a pointer is",
        "a region is not on the screen or panel, or its edges divide a byte of the format",
        "the background or overlay callback reported a failure",
        "the panel's bus took no byte, or did not fall idle, in time",
        "the panel's bus reported a failed transfer",
        "the panel does not take pixels of this size, or its bus no words",
        "the panel's controller cannot turn the picture so",
        "a layout's type does not serve its attribute",
        "a layout's stride is less than its type takes, or not aligned as that is, or its data are not",
    };
    const int count = (int)(sizeof sentences / sizeof *sentences);
    return status > 0 || status <= -count ? "unknown status" : sentences[-status];
}
