/* SPDX-License-Identifier: MIT */
#include "board.h"
#include "endurance.h"

int main(void) {
    return endurance_run(ENDURANCE_FRAMES, board_write) != 0;
}
