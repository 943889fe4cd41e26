# SPDX-License-Identifier: MIT
# The host port: the glint program, its demo, and the meshes that it generates. Included by the top Makefile.

HOST_PROGRAM := $(BUILD)/host/glint
HOST_SOURCES := $(wildcard port/host/*.c)
HOST_OBJECTS := $(HOST_SOURCES:port/host/%.c=$(BUILD)/host/port/%.o)

# The double-precision reference, which maps of errors hold pictures against.
HOST_JUDGE := $(patsubst %.c,$(BUILD)/host/%.o,tests/reference/reference.c tests/reference/lighting.c \
    tests/image/library_geometry.c tests/image/picture.c)
HOST_INCLUDES := -Iexamples -Itests/reference -Itests/image

# The example scenes, which read the meshes that `make meshes` writes: so it takes a program without them. It has no
# library of others either.
SCENE_SOURCES   := $(wildcard examples/scenes/*.c)
SCENE_OBJECTS   := $(SCENE_SOURCES:examples/scenes/%.c=$(BUILD)/host/scenes/%.o)
HOST_CONVERTER  := $(BUILD)/host/glint-without-scenes
BARE_OBJECTS    := $(filter-out %/main.o %/scene.o %/simplify.o,$(HOST_OBJECTS)) $(BUILD)/host/port/bare-main.o \
    $(BUILD)/host/port/bare-simplify.o
-include examples/scenes/meshes.mk

# From the bytes of a file to a quantised mesh: what the OBJ reader's fuzz target links.
HOST_READER_SOURCES := $(addprefix port/host/,obj.c mtl.c text.c mesh.c polygon.c normals.c topology.c quantise.c cluster.c patch.c output.c \
    number.c memory.c problem.c)

# What reads other formats than OBJ is a program of its own, built where the compiler finds assimp (libassimp-dev).
# glint itself simplifies meshes where it finds meshoptimizer (libmeshoptimizer-dev).
HASH           := \#
has_header      = $(shell printf '%cinclude <$1>' '$(HASH)' | $(CC) -E - >/dev/null 2>&1 && echo yes)
IMPORT_PROGRAM := $(if $(call has_header,assimp/cimport.h),$(BUILD)/host/glint-import)
HAS_SIMPLIFIER := $(call has_header,meshoptimizer.h)
SIMPLIFIER     := $(if $(HAS_SIMPLIFIER),-lmeshoptimizer)
IMPORT_OBJECTS := $(patsubst port/host/import/%.c,$(BUILD)/host/import/%.o,$(wildcard port/host/import/*.c))

.PHONY: host demo meshes test-host-cli

host: $(HOST_PROGRAM) $(IMPORT_PROGRAM) ## the glint program for this machine, and glint-import where there is assimp

$(BUILD)/host/import/%.o: port/host/import/%.c $(wildcard port/host/import/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -c $< -o $@

$(BUILD)/host/glint-import: $(IMPORT_OBJECTS)
	$(Q)$(CC) $(HOST_CFLAGS) $^ -lassimp -lm -o $@

$(BUILD)/host/port/%.o: port/host/%.c $(wildcard port/host/*.h src/*.h src/*/*.h tests/reference/*.h tests/image/*.h) examples/scenes/scenes.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) $(HOST_INCLUDES) -c $< -o $@

$(BUILD)/host/port/bare-main.o: port/host/main.c $(wildcard port/host/*.h src/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -DHOST_WITHOUT_SCENES -c $< -o $@

$(BUILD)/host/port/bare-simplify.o: port/host/simplify.c $(wildcard port/host/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -c $< -o $@

$(BUILD)/host/scenes/%.o: examples/scenes/%.c $(wildcard examples/scenes/*.h examples/meshes/*.h src/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -c $< -o $@

# Compiled again where the library has come or gone.
SIMPLIFIER_STAMP := $(BUILD)/host/simplifier-$(or $(HAS_SIMPLIFIER),no)
$(SIMPLIFIER_STAMP):
	@mkdir -p $(@D)
	@rm -f $(BUILD)/host/simplifier-*
	@touch $@
$(BUILD)/host/port/simplify.o: HOST_CFLAGS += $(if $(HAS_SIMPLIFIER),-DHOST_WITH_MESHOPTIMIZER)
$(BUILD)/host/port/simplify.o: $(SIMPLIFIER_STAMP)

$(HOST_PROGRAM): $(HOST_OBJECTS) $(HOST_JUDGE) $(SCENE_OBJECTS) $(BUILD)/host/libglint.a
	$(Q)$(CC) $(HOST_CFLAGS) $^ $(SIMPLIFIER) -lm -o $@

$(HOST_CONVERTER): $(BARE_OBJECTS) $(HOST_JUDGE) $(BUILD)/host/libglint.a
	$(Q)$(CC) $(HOST_CFLAGS) $^ -lm -o $@

include port/host/window/window.mk

demo: $(HOST_PROGRAM) $(IMPORT_PROGRAM) ## draw a sheet of models and name its file
	@$(HOST_PROGRAM) demo -o $(BUILD)/demo.png

# The turntable's meshes are without clusters: what drops them would take more flash than its smallest board has left.
meshes: $(HOST_CONVERTER) ## write examples/meshes anew
	$(HOST_CONVERTER) convert torus:24x12 --name torus576 --licence MIT --no-clusters -o examples/meshes/torus576.h >/dev/null
	$(HOST_CONVERTER) convert examples/models/teapot.obj --licence MIT --no-clusters -o examples/meshes/teapot.h >/dev/null
	$(foreach mesh,$(SCENE_MESHES),$(HOST_CONVERTER) convert $(SCENE_MESH_$(basename $(notdir $(mesh)))) -o $(mesh) >/dev/null &&) true

.PHONY: man
man: $(BUILD)/glint.1 ## write the manual page to build/glint.1
$(BUILD)/glint.1: $(HOST_PROGRAM) port/host/man.sh
	$(Q)sh port/host/man.sh $< > $@

test-host-cli: $(HOST_PROGRAM) $(HOST_CONVERTER) $(BUILD)/host/glint-import ## the command line from outside: every option, every error
	python3 tests/host/run.py $(HOST_PROGRAM)
