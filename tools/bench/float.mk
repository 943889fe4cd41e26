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

PROGRAM_float          := tools/bench/float/frames.c $(FLOAT_RENDERER)
PROGRAM_float-pictures := tests/float/pictures_board.c $(FLOAT_RENDERER)
$(foreach level,Os O2,$(eval $(call firmware_objects,mps2-an386-m4f,$(level))))
$(foreach program,float float-pictures,$(eval $(call firmware_program,mps2-an386-m4f,O2,$(program))))
# They measure; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out $(BUILD)/mps2-an386-m4f/%,$(FIRMWARE))

$(BUILD)/mps2-an386-m4f/O2/%.o: FIRMWARE_CFLAGS += $(FLOAT_INCLUDES)
$(BUILD)/mps2-an386-m4f/O2/tools/bench/workloads.o: $(BUILD)/bench/bench_scenes.h
-include $(wildcard $(foreach folders,* */* */*/*,$(BUILD)/mps2-an386-m4f/*/$(folders)/*.d))

# ---- Its pictures against the double-precision reference: drawn by this machine, and by a Cortex-M4F, with fused
# ---- products and what else its compiler makes of floats

FLOAT_PICTURES := $(TEST_HARNESS) tests/float/pictures.c tests/reference/reference.c tests/reference/lighting.c $(FLOAT_RENDERER)

$(eval $(call test_program,$(BUILD)/tests/host/float,host,$(FLOAT_PICTURES)))
$(BUILD)/host/tools/bench/%.o $(BUILD)/host/tests/float/%.o: TEST_INCLUDES += $(FLOAT_INCLUDES) -I$(BUILD)/bench
$(BUILD)/host/tools/bench/workloads.o: $(BUILD)/bench/bench_scenes.h

$(BUILD)/tests/float-pictures.txt: $(BUILD)/mps2-an386-m4f/O2/float-pictures.elf tests/float/pictures.py tests/board/qemu.py
	@mkdir -p $(@D)
	$(Q)python3 tests/float/pictures.py --qemu $(QEMU) --machine mps2-an386 $< $@

SUITES += test-float
.PHONY: test-float
test-float: $(BUILD)/tests/host/float $(BUILD)/tests/float-pictures.txt ## pictures of the float renderer that frames are compared with, against the reference
	@status=0; $< || status=1; echo "on a Cortex-M4F:"; GLINT_FLOAT_PICTURES=$(word 2,$^) $< || status=1; exit $$status
