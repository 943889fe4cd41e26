# SPDX-License-Identifier: MIT
# docs/boards.md: a row for each board, and what its panel shows.

BOARDS_FIRMWARE := $(foreach board,$(filter-out template mps2-an385-m0,$(BOARDS)),$(BUILD)/$(board)/release/show.elf) \
    $(foreach board,mps2-an385-m0 mps2-an385 virt,$(BUILD)/$(board)/O2/frames.elf)
BOARDS_PAGE := python3 tools/boards/boards.py --build $(BUILD) --host $(BUILD)/host/show

SUITES += test-boards-page
.PHONY: boards-page test-boards-page
boards-page: test-board-show $(BOARDS_FIRMWARE) ## write the figures and pictures of docs/boards.md anew
	@mkdir -p docs/boards
	$(Q)$(BOARDS_PAGE) --shown $(BUILD)/show docs/boards.md docs/boards

test-boards-page: $(BUILD)/host/show $(BOARDS_FIRMWARE) ## the figures and pictures of docs/boards.md are true
	@$(BOARDS_PAGE) docs/boards.md docs/boards
