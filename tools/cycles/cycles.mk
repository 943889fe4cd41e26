# SPDX-License-Identifier: MIT
# The plugin that counts instructions by kind, for the model of a core's cycles (costs.py); loops that judge it.

$(BUILD)/cycles/plugin.so: $(wildcard tools/cycles/*.c tools/cycles/*.h) tools/cycles/cycles.mk
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c99 $(WARNINGS) -O2 -fPIC -shared -fvisibility=hidden $(filter %.c,$^) -o $@

PROGRAM_loops := tests/cycles/loops.c
CYCLES_BOARDS := m0=mps2-an385-m0 m3=mps2-an385 m4=mps2-an386 m4f=mps2-an386-m4f
$(foreach pair,$(CYCLES_BOARDS),$(eval $(call firmware_program,$(lastword $(subst =, ,$(pair))),O2,loops)))
# They measure; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out %/loops.elf,$(FIRMWARE))

CYCLES_FIRMWARE := $(foreach pair,$(CYCLES_BOARDS),$(BUILD)/$(lastword $(subst =, ,$(pair)))/O2/loops.elf)

SUITES += test-cycles
.PHONY: test-cycles
test-cycles: $(BUILD)/cycles/plugin.so $(CYCLES_FIRMWARE) ## loops whose cycles are counted by hand, against the model of cores
	@python3 tests/cycles/loops.py --qemu $(QEMU) --plugin $(BUILD)/cycles/plugin.so $(foreach pair,$(CYCLES_BOARDS),\
	    $(firstword $(subst =, ,$(pair)))=$(if $(findstring m4,$(pair)),mps2-an386,mps2-an385)=$(BUILD)/$(lastword $(subst =, ,$(pair)))/O2/loops.elf)
