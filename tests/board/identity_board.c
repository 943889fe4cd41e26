/* SPDX-License-Identifier: MIT */
#include "board.h"
#include "identity.h"

int main(void) {
    return identity_run(board_write) != 0;
}
