# SPDX-License-Identifier: MIT
# The host port: the glint program, its demo, and the meshes that it generates. Included by the top Makefile.

HOST_PROGRAM := $(BUILD)/host/glint
HOST_SOURCES := $(wildcard port/host/*.c)
HOST_OBJECTS := $(HOST_SOURCES:port/host/%.c=$(BUILD)/host/port/%.o)

# The example scenes, which read the meshes that `make meshes` writes: so it takes a program without them.
SCENE_SOURCES   := $(wildcard examples/scenes/*.c)
SCENE_OBJECTS   := $(SCENE_SOURCES:examples/scenes/%.c=$(BUILD)/host/scenes/%.o)
HOST_CONVERTER  := $(BUILD)/host/glint-without-scenes
BARE_OBJECTS    := $(filter-out %/main.o %/scene.o,$(HOST_OBJECTS)) $(BUILD)/host/port/bare-main.o
-include examples/scenes/meshes.mk

# From the bytes of a file to a quantised mesh: what the OBJ reader's fuzz target links.
HOST_READER_SOURCES := $(addprefix port/host/,obj.c mtl.c text.c mesh.c polygon.c normals.c topology.c quantise.c cluster.c patch.c output.c \
    number.c memory.c problem.c)

# Calls between the library's files that pass through counts.c.
HOST_WATCHED := glint_render_tile glint_light_all glint_gathering_store glint_draw_facet glint_draw_lit glint_nodes_light \
    glint_terms_begin glint_shape_begin glint_terms_draw_part glint_polynomial_begin glint_prepare_shading \
    glint_fast_make_tables
HOST_WATCH := $(HOST_WATCHED:%=-Wl,--wrap=%)

.PHONY: host demo meshes test-host-cli

host: $(HOST_PROGRAM) ## the glint program for this machine

$(BUILD)/host/port/%.o: port/host/%.c $(wildcard port/host/*.h src/*/*.h) src/glint.h examples/scenes/scenes.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -c $< -o $@

$(BUILD)/host/port/bare-main.o: port/host/main.c $(wildcard port/host/*.h) src/glint.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -DHOST_WITHOUT_SCENES -c $< -o $@

$(BUILD)/host/scenes/%.o: examples/scenes/%.c $(wildcard examples/scenes/*.h examples/meshes/*.h) src/glint.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -c $< -o $@

$(HOST_PROGRAM): $(HOST_OBJECTS) $(SCENE_OBJECTS) $(BUILD)/host/libglint.a
	$(Q)$(CC) $(HOST_CFLAGS) $(HOST_WATCH) $^ -lm -o $@

$(HOST_CONVERTER): $(BARE_OBJECTS) $(BUILD)/host/libglint.a
	$(Q)$(CC) $(HOST_CFLAGS) $(HOST_WATCH) $^ -lm -o $@

demo: $(HOST_PROGRAM) ## draw a sheet of models and name its file
	@$(HOST_PROGRAM) demo -o $(BUILD)/demo.png

# The turntable's meshes are without clusters: what drops them would take more flash than its smallest board has left.
meshes: $(HOST_CONVERTER) ## write examples/meshes anew
	$(HOST_CONVERTER) convert torus:24x12 --name torus576 --licence MIT --no-clusters -o examples/meshes/torus576.h
	$(HOST_CONVERTER) convert examples/models/teapot.obj --licence MIT --no-clusters -o examples/meshes/teapot.h
	$(foreach mesh,$(SCENE_MESHES),$(HOST_CONVERTER) convert $(SCENE_MESH_$(basename $(notdir $(mesh)))) -o $(mesh) &&) true

test-host-cli: $(HOST_PROGRAM) ## the command line from outside: every option, every error
	python3 tests/host/run.py $(HOST_PROGRAM)
