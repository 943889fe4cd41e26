# SPDX-License-Identifier: MIT
# The float renderer that frames are compared with: its instructions on a Cortex-M4F, and its pictures.

FLOAT_RENDERER := $(filter-out tools/bench/float/frames.c,$(wildcard tools/bench/float/*.c)) tools/bench/workloads.c tools/bench/boxes.c \
    $(wildcard examples/scenes/*.c)
FLOAT_INCLUDES := -Itools/bench -Itools/bench/float

# ---- Firmware for the MPS2's Cortex-M4 with its FPU in use. It links the library for scenes, poses and descriptors; it draws
# ---- with nothing of it.

mps2-an386-m4f_CPU     := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffast-math -ffp-contract=fast
mps2-an386-m4f_SOURCES := $(mps2-an386_SOURCES)
mps2-an386-m4f_LINKER  := $(mps2-an386_LINKER)
mps2-an386-m4f_PANEL   := $(mps2-an386_PANEL)

PROGRAM_float := tools/bench/float/frames.c $(FLOAT_RENDERER)
$(foreach level,Os O2,$(eval $(call firmware_objects,mps2-an386-m4f,$(level))))
$(eval $(call firmware_program,mps2-an386-m4f,O2,float))
# They measure; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out $(BUILD)/mps2-an386-m4f/%,$(FIRMWARE))

$(BUILD)/mps2-an386-m4f/O2/%.o: FIRMWARE_CFLAGS += $(FLOAT_INCLUDES)
$(BUILD)/mps2-an386-m4f/O2/tools/bench/workloads.o: $(BUILD)/bench/bench_scenes.h
-include $(wildcard $(foreach folders,* */* */*/*,$(BUILD)/mps2-an386-m4f/*/$(folders)/*.d))

# ---- Its pictures against the double-precision reference, with what a compiler may make of floats

FLOAT_PICTURES := $(TEST_HARNESS) tests/float/pictures.c tests/reference/reference.c tests/reference/lighting.c $(FLOAT_RENDERER)

$(eval $(call test_program,$(BUILD)/tests/host/float,host,$(FLOAT_PICTURES)))
$(BUILD)/host/tools/bench/%.o $(BUILD)/host/tests/float/%.o: TEST_INCLUDES += $(FLOAT_INCLUDES) -I$(BUILD)/bench
$(BUILD)/host/tools/bench/float/%.o: TEST_CFLAGS += -ffast-math -ffp-contract=fast
$(BUILD)/host/tools/bench/workloads.o: $(BUILD)/bench/bench_scenes.h

SUITES += test-float
.PHONY: test-float
test-float: $(BUILD)/tests/host/float ## pictures of the float renderer that frames are compared with, against the reference
	@$<
