# SPDX-License-Identifier: MIT
# The gallery: every example scene and variant, what is measured in the pictures, and what each takes to draw.

GALLERY_FIGURES := $(BUILD)/host/gallery-figures

$(eval $(call test_program,$(GALLERY_FIGURES),host,tools/gallery/figures.c tests/image/picture.c $(SCENE_SOURCES)))

# Instructions of each picture, in the emulator; core=board, run as charts are (chart.mk).
PROGRAM_gallery_costs := tools/gallery/costs_board.c $(SCENE_SOURCES)
GALLERY_BOARDS := $(filter m0=% m3=%,$(CHART_BOARDS))
GALLERY_ELVES  := $(foreach pair,$(GALLERY_BOARDS),$(call chart_elf,$(pair),gallery_costs))
$(foreach pair,$(GALLERY_BOARDS),$(eval $(call firmware_program,$(lastword $(subst =, ,$(pair))),O2,gallery_costs)))
# It measures; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out %/gallery_costs.elf,$(FIRMWARE))

$(BUILD)/gallery-instructions.csv: $(GALLERY_ELVES) tools/chart/count.py tools/bench/emulate.py
	$(Q)python3 tools/chart/count.py --qemu $(QEMU) --head scene,variant,size,cpu,instructions \
	    $(foreach pair,$(GALLERY_BOARDS),$(call chart_run,$(pair),gallery_costs)) > $@

.PHONY: gallery
gallery: $(HOST_PROGRAM) $(GALLERY_FIGURES) $(BUILD)/gallery-instructions.csv
	cp $(BUILD)/gallery-instructions.csv docs/
	python3 tools/gallery/gallery.py $(HOST_PROGRAM) $(GALLERY_FIGURES) docs/gallery-instructions.csv docs/gallery

test-host-cli: $(GALLERY_FIGURES)
