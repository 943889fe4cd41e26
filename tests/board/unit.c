/* SPDX-License-Identifier: MIT */
/* The unit tests as firmware: the same bodies that run on the host. */
#include "harness.h"

#include "board.h"
#include "text.h"

int main(void) {
    char digits[TEXT_NUMBER_SIZE];
    const int failed = test_main(board_write);

    board_write("stack used ");
    board_write(text_number(digits, board_stack_used()));
    board_write("\n");
    return failed != 0;
}
