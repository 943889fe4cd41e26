# SPDX-License-Identifier: MIT
# The host port: the glint program, its demo, the meshes that it generates, the window, and what is installed.

HOST_PROGRAM   := $(BUILD)/host/glint
# The double-precision reference with the library's own geometry, and what writes pictures.
JUDGE_SOURCES  := tests/reference/reference.c tests/reference/lighting.c tests/reference/sampling.c tests/image/library_geometry.c tests/image/picture.c
PNG_SOURCES    := $(addprefix port/host/,framebuffer.c png.c deflate.c output.c basics.c)
IMPORT_SOURCES := $(wildcard port/host/import/*.c) port/host/physical.c
HOST_SOURCES   := $(wildcard port/host/*.c)
HOST_OBJECTS   := $(call objects,$(BUILD)/host,$(HOST_SOURCES))
# Programs beside glint link all of it but its main function.
HOST_PARTS     := $(filter-out %/main.o,$(HOST_OBJECTS)) $(call objects,$(BUILD)/host,$(EXAMPLE_SCENES)) \
    $(BUILD)/host/libglint.a

# The example scenes read the meshes that `make meshes` writes anew: so a program without scenes writes them. It has no
# library of others either.
HOST_CONVERTER := $(BUILD)/host/glint-without-scenes
BARE_OBJECTS   := $(BUILD)/host/bare-main.o $(BUILD)/host/bare-simplify.o

# A program of its own reads other formats than OBJ; it is built where the compiler finds assimp (libassimp-dev), and
# decodes JPEG where it finds libjpeg (libjpeg-dev).
# glint itself simplifies meshes where the compiler finds meshoptimizer (libmeshoptimizer-dev).
HASH           := \#
has_header      = $(shell printf '%cinclude <$1>' '$(HASH)' | $(CC) -E - >/dev/null 2>&1 && echo yes)
IMPORT_PROGRAM := $(if $(call has_header,assimp/cimport.h),$(BUILD)/host/glint-import)
HAS_JPEG       := $(call has_header,jpeglib.h)
JPEG           := $(if $(HAS_JPEG),-ljpeg)
HAS_SIMPLIFIER := $(call has_header,meshoptimizer.h)
SIMPLIFIER     := $(if $(HAS_SIMPLIFIER),-lmeshoptimizer)

.PHONY: host demo meshes man view install uninstall

host: $(HOST_PROGRAM) $(IMPORT_PROGRAM) ## the glint program for this machine, and glint-import where there is assimp

$(HOST_PROGRAM): $(BUILD)/host/port/host/main.o $(HOST_PARTS)
	$(Q)$(CC) $(HOST_CFLAGS) $^ $(SIMPLIFIER) -lm -o $@

$(BUILD)/host/glint-import: $(call objects,$(BUILD)/host,$(IMPORT_SOURCES))
	$(Q)$(CC) $(HOST_CFLAGS) $^ -lassimp $(JPEG) -lm -o $@

$(HOST_CONVERTER): $(BARE_OBJECTS) $(filter-out %/scene.o %/simplify.o $(BUILD)/host/examples/%,$(HOST_PARTS))
	$(Q)$(CC) $(HOST_CFLAGS) $^ -lm -o $@
$(BARE_OBJECTS): $(BUILD)/host/bare-%.o: port/host/%.c Makefile
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -DHOST_WITHOUT_SCENES -MMD -MP -c $< -o $@
-include $(wildcard $(BARE_OBJECTS:.o=.d))

# The simplifier and the decoder of JPEG are compiled again where a library has come or gone. The file that says which are
# there is looked at each time: that it is missing would not be enough, since all files are secondary.
LIBRARIES := simplifier: $(HAS_SIMPLIFIER), JPEG: $(HAS_JPEG)
.PHONY: FORCE
$(BUILD)/host/libraries: FORCE
	@mkdir -p $(@D)
	@echo '$(LIBRARIES)' | cmp -s - $@ || echo '$(LIBRARIES)' > $@
$(BUILD)/host/port/host/simplify.o: TEST_CFLAGS += $(if $(HAS_SIMPLIFIER),-DHOST_WITH_MESHOPTIMIZER)
$(BUILD)/host/port/host/import/jpeg.o: TEST_CFLAGS += $(if $(HAS_JPEG),-DHOST_WITH_JPEG)
$(BUILD)/host/port/host/simplify.o $(BUILD)/host/port/host/import/jpeg.o: $(BUILD)/host/libraries

demo: $(HOST_PROGRAM) $(IMPORT_PROGRAM) ## draw a sheet of models and name its file
	@$(HOST_PROGRAM) demo -o $(BUILD)/demo.png

# Each says how it was made. The turntable's are without clusters: code that drops clusters would take more flash than its
# smallest board has left.
meshes: $(HOST_CONVERTER) ## write examples/meshes anew
	$(Q)cd examples/models && for mesh in ../meshes/*.h; do \
	    eval "$(abspath $<) `sed -n 's/^ \*     glint //p' $$mesh` -o $$mesh" > /dev/null || exit 1; done

man: $(BUILD)/glint.1 ## write the manual page to build/glint.1
$(BUILD)/glint.1: $(HOST_PROGRAM) port/host/man.sh
	$(Q)sh port/host/man.sh $< > $@

# ---- The window, a program of its own that takes SDL2 (libsdl2-dev); only main.c needs that

VIEW_PROGRAM := $(BUILD)/host/glint-view
VIEW_OBJECTS := $(call objects,$(BUILD)/host,$(filter-out %/main.c,$(wildcard port/host/window/*.c)))
$(BUILD)/host/port/host/window/main.o: TEST_CFLAGS += $$(sdl2-config --cflags)
$(BUILD)/host/port/host/window/main.o: | $(BUILD)/host/has-sdl2

.PHONY: $(BUILD)/host/has-sdl2
$(BUILD)/host/has-sdl2:
	@command -v sdl2-config > /dev/null || { echo "the window takes SDL2: libsdl2-dev"; exit 1; }

$(VIEW_PROGRAM): $(VIEW_OBJECTS) $(BUILD)/host/port/host/window/main.o $(HOST_PARTS)
	$(Q)$(CC) $(HOST_CFLAGS) $^ $$(sdl2-config --libs) $(SIMPLIFIER) -lm -o $@

view: $(VIEW_PROGRAM) ## show VIEW=torus:48x24, or a file, in a window; takes SDL2
	$< $(VIEW)

# ---- Installation, below DESTDIR, as packagers want it, if that is set

PREFIX        ?= /usr/local
INSTALL        = $(DESTDIR)$(PREFIX)
PUBLIC_HEADERS := $(wildcard src/*.h)
PROGRAMS       := $(HOST_PROGRAM) $(IMPORT_PROGRAM)
INSTALLED      = $(PROGRAMS:$(BUILD)/host/%=$(INSTALL)/bin/%) $(INSTALL)/lib/libglint.a $(INSTALL)/lib/pkgconfig/glint.pc \
    $(PUBLIC_HEADERS:src/%=$(INSTALL)/include/%)

install: $(PROGRAMS) $(BUILD)/host/libglint.a ## glint, glint-import where there is assimp, library and headers to DESTDIR and PREFIX
	install -d $(sort $(dir $(INSTALLED)))
	install $(PROGRAMS) $(INSTALL)/bin
	install -m 644 $(BUILD)/host/libglint.a $(INSTALL)/lib
	install -m 644 $(PUBLIC_HEADERS) $(INSTALL)/include
	sed -e 's|@PREFIX@|$(PREFIX)|' -e "s|@VERSION@|`tools/version.sh print`|" tools/packages/glint.pc.in > $(INSTALL)/lib/pkgconfig/glint.pc

uninstall: ## remove what install has put there
	rm -f $(INSTALLED)
