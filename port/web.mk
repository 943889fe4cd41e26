# SPDX-License-Identifier: MIT
# The web page: the library, the host program and the reference for wasm32, and what docs/web/ is made of.

WEB := $(BUILD)/web
# Other formats than OBJ are not read there.
WEB_WITHOUT := $(addprefix port/host/,main.c output.c importer.c child.c reader.c stl.c ply.c off.c json.c gltf.c gltf_data.c \
    gltf_material.c physical.c)
WEB_SOURCES := $(LIBRARY) \
    $(filter-out $(WEB_WITHOUT),$(HOST_SOURCES)) $(EXAMPLE_SCENES) $(JUDGE_SOURCES) \
    $(addprefix port/web/,web.c measure.c files.c libc/libc.c) port/libc/memory.c
WEB_OBJECTS := $(call objects,$(WEB),$(WEB_SOURCES)) $(WEB)/scenes/meshes.o
# Scenes take the arrays of these two.
WEB_HEADERS := $(filter-out %/glow.h %/cylinder30x2.h,$(wildcard examples/meshes/*.h))
WEB_CC := clang --target=wasm32 -nostdlibinc -isystem port/web/libc -mbulk-memory -msign-ext -mnontrapping-fptoint -ffreestanding \
    -ffunction-sections -fdata-sections -std=c99 $(WARNINGS) -Isrc -Iport/host -I$(WEB)/scenes -Iexamples -Itests/reference \
    -Itests/image -Iport/web -Iport/web/libc

# Scenes include "meshes/NAME.h": these stand before those in examples/.
$(WEB)/scenes/meshes.c: port/web/meshes.py $(WEB_HEADERS)
	$(Q)python3 $< $(@D) $(WEB_HEADERS)
$(WEB)/scenes/meshes.o: $(WEB)/scenes/meshes.c port/web.mk
	$(Q)$(WEB_CC) $(WEB_OPT) -c $< -o $@

# All is compiled small, but the library takes the ways of one that is built for speed: those of boards.
$(WEB)/src/%.o: WEB_OPT := -Oz -U__OPTIMIZE_SIZE__
$(WEB)/%.o: WEB_OPT := -Oz
$(WEB)/%.o: %.c Makefile port/web.mk $(WEB)/scenes/meshes.c
	@mkdir -p $(@D)
	$(Q)$(WEB_CC) $(WEB_OPT) -MMD -MP -c $< -o $@
-include $(wildcard $(WEB_OBJECTS:.o=.d))

$(WEB)/glint.wasm: $(WEB_OBJECTS)
	$(Q)wasm-ld --no-entry --gc-sections --strip-all -O2 -z stack-size=262144 --allow-undefined-file=port/web/imports.txt $^ -o $@

$(WEB)/page/data.js: $(WEB)/glint.wasm port/web/page.py $(wildcard port/web/page/* examples/models/*.obj docs/*.csv) \
        docs/charts/shading.csv docs/features.md src/glint.h
	$(Q)python3 port/web/page.py $< $(@D)

.PHONY: web
web: $(WEB)/page/data.js
	$(Q)rm -rf docs/web
	$(Q)mkdir -p docs/web
	$(Q)cp $(WEB)/page/* docs/web/
