# SPDX-License-Identifier: MIT
# glint: see `make help`.

BUILD    := build
WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
CFLAGS   ?= -O2
LIBRARY  := $(wildcard src/*.c)

# The library for the host: build/host/libglint.a
HOST_CFLAGS := -std=c99 $(WARNINGS) -g $(CFLAGS) -Isrc
$(BUILD)/host/src/%.o: src/%.c $(wildcard src/*.h)
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -ffreestanding -c $< -o $@
$(BUILD)/host/libglint.a: $(LIBRARY:src/%.c=$(BUILD)/host/src/%.o)
	@rm -f $@
	$(AR) rcs $@ $^

-include port/host/host.mk port/boards.mk tests/tests.mk

.PHONY: clean
clean:
	rm -rf $(BUILD)
