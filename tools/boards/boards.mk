# SPDX-License-Identifier: MIT
# docs/boards.md: a row for each board, and what its panel shows. The README has a table of one board.

BOARDS_FIRMWARE := $(foreach board,$(filter-out template mps2-an385-m0,$(BOARDS)),$(BUILD)/$(board)/release/show.elf) \
    $(foreach board,mps2-an385-m0 mps2-an385 virt,$(BUILD)/$(board)/O2/frames.elf)
BOARDS_STREAM := $(BUILD)/pico/release/show.stream
BOARDS_PAGE := python3 tools/boards/boards.py --build $(BUILD) --host $(BUILD)/host/show --stream $(BOARDS_STREAM)

# On a bus that takes no time: instructions that wait for it are not counted.
$(BOARDS_STREAM): $(BUILD)/pico/release/show.bin $(BUILD)/pico/emulator/installed tests/pico/run.js
	$(Q)node tests/pico/run.js $< $@ free > /dev/null

SUITES += test-boards-page
.PHONY: boards-page test-boards-page
boards-page: test-board-show $(BOARDS_FIRMWARE) $(BOARDS_STREAM) ## write the figures and pictures of docs/boards.md and the README's table anew
	@mkdir -p docs/boards
	$(Q)$(BOARDS_PAGE) --shown $(BUILD)/show docs/boards.md docs/boards README.md

test-boards-page: $(BUILD)/host/show $(BOARDS_FIRMWARE) $(BOARDS_STREAM) ## the figures and pictures of docs/boards.md and the README are true
	@$(BOARDS_PAGE) docs/boards.md docs/boards README.md
