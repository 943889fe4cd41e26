/* SPDX-License-Identifier: MIT */
/* Kernels of any number of lights. */
#define LIGHTS FLOAT_MANY
#define CHOOSE float_choose_many
#include "lights.h"
