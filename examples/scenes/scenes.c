/* SPDX-License-Identifier: MIT */
#include "scenes.h"

const example_scene *const example_scenes[EXAMPLE_SCENES] = {
    &example_shaders,        &example_three_spheres, &example_halloween, &example_teapot,
    &example_phong_lighting, &example_surfaces,      &example_still_life};
