# SPDX-License-Identifier: MIT
# docs/boards.md: a row for each board, and what its panel shows. The README has a table of one board.

BOARDS_FIRMWARE := $(foreach board,$(filter-out template mps2-an385-m0,$(BOARDS)),$(BUILD)/$(board)/release/show.elf) \
    $(foreach board,mps2-an385-m0 mps2-an385 virt,$(BUILD)/$(board)/O2/frames.elf)
BOARDS_STREAM := $(BUILD)/pico/release/show.stream
BOARDS_PAGE := python3 tools/boards/boards.py --build $(BUILD) --host $(BUILD)/host/show --stream $(BOARDS_STREAM)

# On a bus that takes no time: instructions that wait for it are not counted.
$(BOARDS_STREAM): $(BUILD)/pico/release/show.bin $(BUILD)/pico/emulator/installed tests/pico/run.js
	$(Q)node tests/pico/run.js $< $@ free > /dev/null

# The example scenes in motion: what each frame takes of the core by the model of cycles, and of the bus.
PROGRAM_animate-marked := $(PROGRAM_animate) tools/boards/marked.c
PROGRAM_animate-marked-polled := $(PROGRAM_animate-marked) tools/boards/marked_polled.c
$(eval $(call firmware_program,mps2-an385,O2,animate-marked,-Wl$(comma)--defsym=stack_size=5120 -Wl$(comma)--wrap=glint_render))
$(eval $(call firmware_program,netduinoplus2,O2,animate-marked-polled,-Wl$(comma)--defsym=stack_size=5120 \
    -Wl$(comma)--wrap=glint_render -Wl$(comma)--wrap=stm32_spi_send))
# They measure; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out %/animate-marked.elf %/animate-marked-polled.elf,$(FIRMWARE))

ANIMATE_MARKED := mps2-an385=$(BUILD)/mps2-an385/O2/animate-marked.elf \
    netduinoplus2=$(BUILD)/netduinoplus2/O2/animate-marked-polled.elf pico=$(BUILD)/pico/O2/animate.bin
ANIMATE_TIMES  := python3 tools/boards/times.py --plugin $(BUILD)/cycles/plugin.so
$(BUILD)/animate-times.csv $(BUILD)/animate-times-part.csv: $(foreach pair,$(ANIMATE_MARKED),$(lastword $(subst =, ,$(pair)))) \
        $(BUILD)/cycles/plugin.so $(BUILD)/pico/emulator/installed tools/boards/times.py tools/cycles/costs.py tests/pico/run.js
	$(Q)$(ANIMATE_TIMES) $(if $(findstring part,$@),--part) $(ANIMATE_MARKED) > $@

BOARDS_ANIMATED := $(foreach board,mps2-an385 netduinoplus2 pico,$(BUILD)/$(board)/O2/animate.elf)

SUITES += test-boards-page
.PHONY: boards-page test-boards-page
boards-page: $(BUILD)/host/show $(BOARDS_FIRMWARE) $(BOARDS_ANIMATED) $(BOARDS_STREAM) $(BUILD)/animate-times.csv
	@mkdir -p docs/boards
	$(Q)$(BOARDS_PAGE) --times $(BUILD)/animate-times.csv --write docs/boards.md docs/boards README.md

test-boards-page: $(BUILD)/host/show $(BOARDS_FIRMWARE) $(BOARDS_ANIMATED) $(BOARDS_STREAM) $(BUILD)/animate-times-part.csv ## the figures and pictures of docs/boards.md and the README are true
	@$(BOARDS_PAGE) --times $(BUILD)/animate-times-part.csv docs/boards.md docs/boards README.md
