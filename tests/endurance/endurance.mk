# SPDX-License-Identifier: MIT
# Endurance: frames for a long time, whose pixels must not drift.

ENDURANCE_FRAMES       := 1000000
ENDURANCE_BOARD_FRAMES := 10000
# Every variant of every scene, and most of them twice or more.
ENDURANCE_TEST_FRAMES  := 7000
ENDURANCE_SOURCES := tests/endurance/endurance.c $(wildcard examples/scenes/*.c)
ENDURANCE_ELF     := $(BUILD)/mps2-an385/O2/endurance.elf

$(eval $(call test_program,$(BUILD)/tests/endurance,host,tests/endurance/endurance_host.c $(ENDURANCE_SOURCES)))

PROGRAM_endurance := tests/endurance/endurance_board.c $(ENDURANCE_SOURCES)
$(BUILD)/mps2-an385/O2/tests/endurance/endurance_board.o: FIRMWARE_CFLAGS += -DENDURANCE_FRAMES=$(ENDURANCE_BOARD_FRAMES)
$(eval $(call firmware_program,mps2-an385,O2,endurance,-Wl$(comma)--defsym=stack_size=5120))

SUITES += test-endurance
.PHONY: endurance test-endurance
test-endurance: $(BUILD)/tests/endurance ## thousands of animated frames: each revolution is as the first
	@$< $(ENDURANCE_TEST_FRAMES) > $<.log; status=$$?; tail -n 2 $<.log; exit $$status

endurance: $(BUILD)/tests/endurance $(ENDURANCE_ELF) ## a million animated frames on the host, ten thousand on an emulated board: half an hour
	@python3 tests/endurance/endurance.py --qemu $(QEMU) $(ENDURANCE_ELF) $(BUILD)/tests/endurance $(ENDURANCE_BOARD_FRAMES)
	@$(BUILD)/tests/endurance $(ENDURANCE_FRAMES)
