/* SPDX-License-Identifier: MIT */
/* What frame_board.c counts, drawn by the float renderer. */
#define FRAME_FLOAT
#include "frame_board.c" /* NOLINT(bugprone-suspicious-include): the same program, drawn in float */
