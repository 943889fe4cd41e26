# SPDX-License-Identifier: MIT
# Instructions per stage and per unit of the benchmark scenes, by emulation.

PROGRAM_profile  := tools/profile/profile.c
PROFILE_PROGRAMS := m3=$(BUILD)/mps2-an385/O2/profile.elf m0=$(BUILD)/mps2-an385-m0/O2/profile.elf

$(foreach board,mps2-an385 mps2-an385-m0,$(eval $(call firmware_program,$(board),O2,profile)))
$(foreach board,mps2-an385 mps2-an385-m0,$(BUILD)/$(board)/O2/tools/profile/profile.o): $(BUILD)/bench/bench_scenes.h

.PHONY: profile
profile: $(foreach program,$(PROFILE_PROGRAMS),$(lastword $(subst =, ,$(program)))) ## instructions per stage and unit of one frame of each benchmark scene (FUNCTIONS=1: per function)
	$(Q)python3 tools/profile/profile.py --qemu $(QEMU) --nm $(CROSS)nm $(if $(FUNCTIONS),--functions) \
	    --output $(BUILD)/profile.csv $(PROFILE_PROGRAMS)
