# SPDX-License-Identifier: MIT
# The host port: the glint program, its demo, and the meshes that it generates. Included by the top Makefile.

HOST_PROGRAM := $(BUILD)/host/glint
HOST_SOURCES := $(wildcard port/host/*.c)
HOST_OBJECTS := $(HOST_SOURCES:port/host/%.c=$(BUILD)/host/port/%.o)

# From the bytes of a file to a quantised mesh: what the OBJ reader's fuzz target links.
HOST_READER_SOURCES := $(addprefix port/host/,obj.c mesh.c polygon.c normals.c topology.c quantise.c number.c \
    memory.c problem.c)

.PHONY: host demo meshes test-host-cli

host: $(HOST_PROGRAM) ## the glint program for this machine

$(BUILD)/host/port/%.o: port/host/%.c $(wildcard port/host/*.h) src/glint.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -c $< -o $@

$(HOST_PROGRAM): $(HOST_OBJECTS) $(BUILD)/host/libglint.a
	$(Q)$(CC) $(HOST_CFLAGS) $^ -lm -o $@

demo: $(HOST_PROGRAM) ## draw a sheet of models and name its file
	@$(HOST_PROGRAM) demo -o $(BUILD)/demo.png

meshes: $(HOST_PROGRAM) ## write examples/meshes anew
	$(HOST_PROGRAM) convert torus:24x12 --name torus576 --licence MIT -o examples/meshes/torus576.h
	$(HOST_PROGRAM) convert examples/models/teapot.obj --licence MIT -o examples/meshes/teapot.h

test-host-cli: $(HOST_PROGRAM) ## the command line from outside: every option, every error
	python3 tests/host/run.py $(HOST_PROGRAM)
