/* SPDX-License-Identifier: MIT */
/* Kernels of one point light. */
#define LIGHTS FLOAT_ONE_POINT
#define CHOOSE float_choose_point
#include "lights.h"
