# SPDX-License-Identifier: MIT
# The window on a screen in memory. What it exports is compiled for this machine and for a board in QEMU.

VIEW_EXPORTED_HOST := $(CC) $(HOST_CFLAGS) -Iport/host tests/view/exported_host.c \
    $(addprefix port/host/,framebuffer.c png.c deflate.c output.c memory.c problem.c) $(BUILD)/host/libglint.a -lm
VIEW_BOARD_PARTS := $(patsubst %.c,$(BUILD)/virt/release/%.o,$(virt_SOURCES)) $(BUILD)/virt/release/libglint.a
VIEW_EXPORTED_BOARD = $(virt_CROSS)gcc $(virt_CPU) $(filter-out -fstack-usage -MMD -MP,$(FIRMWARE_CFLAGS)) -Os \
    -DBOARD_ARENA=$(virt_ARENA) $(FIRMWARE_LDFLAGS) -T $(virt_LINKER) tests/view/exported_board.c $(VIEW_BOARD_PARTS) -lgcc

# Debian's own Python has python3-xlib.
SUITES += test-view
.PHONY: test-view
test-view: $(VIEW_PROGRAM) $(HOST_PROGRAM) $(VIEW_BOARD_PARTS) ## the window, with real keys and mouse on a screen in memory
	@GLINT_EXPORTED_HOST='$(VIEW_EXPORTED_HOST)' GLINT_EXPORTED_BOARD='$(VIEW_EXPORTED_BOARD)' \
	    /usr/bin/python3 tests/view/view.py $(VIEW_PROGRAM) $(HOST_PROGRAM) $(VIEW_TESTS)
