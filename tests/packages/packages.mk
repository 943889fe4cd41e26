# SPDX-License-Identifier: MIT
# Every way to take the library: the README's program and a sample built with each, manifests, lists of files.

PACKAGES := $(BUILD)/packages

$(PACKAGES)/minimal: tests/packages/board.c examples/firmware/minimal.c port/panel/panel.c port/panel/solomon.c \
        port/panel/ssd0323.c $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport $^ -o $@

$(PACKAGES)/turntable: tests/packages/turntable.c examples/turntable/turntable.c port/host/framebuffer.c port/host/memory.c \
        port/host/problem.c $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport/host -Iexamples $^ -o $@

SUITES += test-packages
.PHONY: test-packages
test-packages: $(PACKAGES)/minimal $(PACKAGES)/turntable $(PANEL_STREAM) $(HOST_PROGRAM) single ## every package: what it builds, and what it says of itself
	@python3 tests/packages/packages.py --build $(BUILD)
