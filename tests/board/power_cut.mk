# SPDX-License-Identifier: MIT
# A board whose power is cut at any instruction; included by the Makefile after port/boards.mk.

# As many within each part of what the firmware does, half of them with the panel's reset line.
POWER_CUTS ?= 14
POWER_SEED ?= 1

# Tables that frames keep in the arena are not of a library built for size.
PROGRAM_power_cut := tests/board/power_cut_board.c examples/turntable/turntable.c
$(eval $(call firmware_program,mps2-an385,O2,power_cut))
POWER_ELF := $(BUILD)/mps2-an385/O2/power_cut.elf

SUITES += test-board-power
.PHONY: test-board-power
test-board-power: $(POWER_ELF) $(BUILD)/host/show $(BUILD)/host/panel_stream ## a board whose power is cut POWER_CUTS times, anywhere: the next frame is whole; POWER_SEED chooses where
	@python3 tests/board/power_cut.py --qemu $(QEMU) --nm $(CROSS)nm --host $(BUILD)/host/show --stream $(BUILD)/host/panel_stream \
	    --output $(BUILD)/power --cuts $(POWER_CUTS) --seed $(POWER_SEED) $(POWER_ELF)
