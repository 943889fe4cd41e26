# SPDX-License-Identifier: MIT
# How the cost of a frame grows with triangles, pixels, lights and objects.

PROGRAM_scaling  := tools/scaling/scaling.c
SCALING_PROGRAMS := m3=$(BUILD)/mps2-an385/O2/scaling.elf m0=$(BUILD)/mps2-an385-m0/O2/scaling.elf

$(foreach board,mps2-an385 mps2-an385-m0,$(eval $(call firmware_program,$(board),O2,scaling)))
$(foreach board,mps2-an385 mps2-an385-m0,$(BUILD)/$(board)/O2/tools/scaling/scaling.o): FIRMWARE_CFLAGS += -Itools
$(foreach board,mps2-an385 mps2-an385-m0,$(BUILD)/$(board)/O2/tools/scaling/scaling.o): $(BUILD)/bench/bench_scenes.h

$(BUILD)/scaling.csv: $(foreach program,$(SCALING_PROGRAMS),$(lastword $(subst =, ,$(program)))) tools/scaling/scaling.py tools/bench/emulate.py
	$(Q)python3 tools/scaling/scaling.py --qemu $(QEMU) --output $@ $(SCALING_PROGRAMS)

.PHONY: scaling
scaling: $(BUILD)/scaling.csv
	cp $< docs/charts/scaling.csv
