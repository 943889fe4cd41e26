/* SPDX-License-Identifier: MIT */
#include "command.h"

int command_demo(const host_settings *settings) {
    (void)settings;
    return COMMAND_FAILED;
}
