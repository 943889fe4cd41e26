/* SPDX-License-Identifier: MIT */
/* As on boards of 16 KB of RAM; and 64 KB of flash hold one model. */
#include "board.h"
#include "identity.h"

int main(void) {
    static const identity_format formats[] = {
        {"grey4", &glint_format_grey4},
        {"grey8", &glint_format_grey8},
        {"rgb888", &glint_format_rgb888},
    };

    return identity_run_turntable(board_write, formats, sizeof formats / sizeof formats[0]) != 0;
}
