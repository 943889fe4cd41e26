/* SPDX-License-Identifier: MIT */
/* Kernels of one spot. */
#define LIGHTS FLOAT_ONE_SPOT
#define CHOOSE float_choose_spot
#include "lights.h"
