# SPDX-License-Identifier: MIT
# The float renderer that frames are compared with: its instructions on a Cortex-M4F, and its pictures.

# The MPS2's Cortex-M4 with its FPU in use. Only the library's scenes and poses are linked, no renderer of it.
mps2-an386-m4f_CPU     := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffast-math -ffp-contract=fast
mps2-an386-m4f_SOURCES := $(mps2-an386_SOURCES)
mps2-an386-m4f_LINKER  := $(mps2-an386_LINKER)
mps2-an386-m4f_PANEL   := $(mps2-an386_PANEL)

FLOAT_RENDERER := $(filter-out tools/bench/float/frames.c,$(wildcard tools/bench/float/*.c))
PROGRAM_float := tools/bench/float/frames.c $(FLOAT_RENDERER) tools/bench/workloads.c $(wildcard examples/scenes/*.c)
$(eval $(call firmware_objects,mps2-an386-m4f,O2))
$(eval $(call firmware_program,mps2-an386-m4f,O2,float))
$(BUILD)/mps2-an386-m4f/O2/tools/bench/workloads.o: $(BUILD)/bench/bench_scenes.h
# It measures; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out %/float.elf,$(FIRMWARE))
-include $(wildcard $(foreach folders,* */* */*/*,$(BUILD)/mps2-an386-m4f/O2/$(folders)/*.d))
