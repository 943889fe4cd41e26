# SPDX-License-Identifier: MIT
# The window, a program of its own that takes SDL2 (libsdl2-dev); only main.c needs that. Included by port/host/host.mk.

VIEW_PROGRAM := $(BUILD)/host/glint-view
VIEW_SOURCES := $(filter-out %/main.c,$(wildcard port/host/window/*.c))
VIEW_OBJECTS := $(VIEW_SOURCES:port/host/window/%.c=$(BUILD)/host/window/%.o)
VIEW_HOST    := $(filter-out %/main.o,$(HOST_OBJECTS)) $(HOST_JUDGE) $(SCENE_OBJECTS) $(BUILD)/host/libglint.a

$(BUILD)/host/window/%.o: port/host/window/%.c $(wildcard port/host/window/*.h port/host/*.h src/*.h src/*/*.h) \
        $(wildcard tests/reference/*.h) examples/scenes/scenes.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) $(HOST_INCLUDES) -Iport/host -c $< -o $@

$(BUILD)/host/window/main.o: HOST_CFLAGS += $$(sdl2-config --cflags)
$(BUILD)/host/window/main.o: | $(BUILD)/host/window/has-sdl2

.PHONY: view $(BUILD)/host/window/has-sdl2
$(BUILD)/host/window/has-sdl2:
	@command -v sdl2-config > /dev/null || { echo "the window takes SDL2: libsdl2-dev"; exit 1; }

$(VIEW_PROGRAM): $(VIEW_OBJECTS) $(BUILD)/host/window/main.o $(VIEW_HOST)
	$(Q)$(CC) $(HOST_CFLAGS) $^ $$(sdl2-config --libs) $(SIMPLIFIER) -lm -o $@

view: $(VIEW_PROGRAM) ## show VIEW=torus:48x24, or a file, in a window; takes SDL2
	$< $(VIEW)
