/* SPDX-License-Identifier: MIT */
/* 16 KB of RAM have no room for the example scenes, whose stack alone takes 10 KB at nodes. */
#include "board.h"
#include "identity.h"

int main(void) {
    static const identity_format formats[] = {
        {"grey4", &glint_format_grey4},         {"grey8", &glint_format_grey8},   {"rgb565", &glint_format_rgb565},
        {"rgb565_be", &glint_format_rgb565_be}, {"rgb888", &glint_format_rgb888},
    };

    return identity_run_turntable(board_write, formats, sizeof formats / sizeof formats[0]) != 0;
}
