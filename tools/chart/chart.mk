# SPDX-License-Identifier: MIT
# Charts, and the pages that walk through them, from figures measured here: errors on the host, instructions on emulated
# cores. What was measured is kept in docs/ as CSV; `make figures` draws from that.

CHART_IMAGE := tests/image/picture.c tests/image/library_geometry.c tests/reference/reference.c tests/reference/lighting.c

# ---- Errors, on the host

# $(call chart_host,program,sources)
chart_host = $(call test_program,$(BUILD)/chart/$1,host,tools/chart/$1.c $2 $(CHART_IMAGE))
$(eval $(call chart_host,frame_accuracy,examples/bench/bench.c $(addprefix port/host/,cluster.c patch.c memory.c)))
$(eval $(call chart_host,shading,))

$(eval $(call chart_host,gallery_accuracy,tests/stability/contract.c tests/stability/weights.c tests/image/judge.c \
    $(wildcard examples/scenes/*.c)))

$(BUILD)/%-accuracy.csv: $(BUILD)/chart/%_accuracy
	$< > $@

# ---- Instructions, in the emulator

PROGRAM_frame_board   := tools/chart/frame_board.c
PROGRAM_shading_board := tools/chart/shading_board.c
PROGRAM_arena_board := tools/chart/arena_board.c $(wildcard examples/scenes/*.c)

CHART_BOARDS := m0=mps2-an385-m0 m3=mps2-an385 m4=mps2-an386 rv32=virt

# $(call chart_elf,core=board,program), and the same with the machine that runs it
chart_elf = $(BUILD)/$(lastword $(subst =, ,$1))/O2/$2.elf
chart_run = $(firstword $(subst =, ,$1))=$(patsubst %-m0,%,$(lastword $(subst =, ,$1)))=$(call chart_elf,$1,$2)

$(foreach pair,$(CHART_BOARDS),$(eval $(call firmware_program,$(lastword $(subst =, ,$(pair))),O2,frame_board)))
$(eval $(call firmware_program,mps2-an385,O2,shading_board))
$(eval $(call firmware_program,mps2-an385,O2,arena_board))
# They measure; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out %/frame_board.elf %/shading_board.elf %/arena_board.elf,$(FIRMWARE))

$(foreach pair,$(CHART_BOARDS),\
    $(BUILD)/$(lastword $(subst =, ,$(pair)))/O2/tools/chart/frame_board.o): $(BUILD)/bench/bench_scenes.h

CHART_FRAMES := $(foreach pair,$(CHART_BOARDS),$(call chart_elf,$(pair),frame_board))
$(BUILD)/frame-instructions.csv: $(CHART_FRAMES) tools/chart/count.py tools/bench/emulate.py
	python3 tools/chart/count.py --qemu $(QEMU) --head scene,size,format,choice,cpu,instructions \
	    $(foreach pair,$(CHART_BOARDS),$(call chart_run,$(pair),frame_board)) > $@

$(BUILD)/bench/spot.h: examples/models/spot.obj $(BUILD)/host/glint
	@mkdir -p $(@D)
	$(BUILD)/host/glint convert $< -o $@ > /dev/null

$(BUILD)/mps2-an385/O2/tools/chart/arena_board.o: $(BUILD)/bench/bench_scenes.h $(BUILD)/bench/spot.h

$(BUILD)/arena.csv: $(BUILD)/mps2-an385/O2/arena_board.elf tools/chart/count.py tools/bench/emulate.py
	python3 tools/chart/count.py --qemu $(QEMU) --head scene,size,arena,passes,cpu,instructions m3=mps2-an385=$< > $@

# Both in one table.
$(BUILD)/shading.csv: $(BUILD)/chart/shading $(BUILD)/mps2-an385/O2/shading_board.elf tools/chart/count.py
	$(BUILD)/chart/shading > $(BUILD)/chart/errors.csv
	python3 tools/chart/count.py --qemu $(QEMU) --head format,evaluation,triangles,cpu,instructions \
	    m3=mps2-an385=$(BUILD)/mps2-an385/O2/shading_board.elf > $(BUILD)/chart/instructions.csv
	paste -d, $(BUILD)/chart/errors.csv $(BUILD)/chart/instructions.csv | cut -d, -f1-5,9-10 > $@

# ---- Kept, drawn, checked

CHART_FIGURES := $(addprefix $(BUILD)/,bench.csv frame-accuracy.csv gallery-accuracy.csv frame-instructions.csv shading.csv arena.csv)

.PHONY: chart-figures chart test-chart
chart-figures: $(CHART_FIGURES)
	cp $(addprefix $(BUILD)/,bench.csv bench-arena.csv frame-accuracy.csv gallery-accuracy.csv frame-instructions.csv) docs/
	cp $(BUILD)/shading.csv $(BUILD)/arena.csv docs/charts/

chart:
	@tools/setup.sh
	@python3 tools/chart/chart.py

SUITES += test-chart
test-chart: ## charts and figures in pages against the CSV files kept in docs
	@python3 tools/chart/chart.py --check $(BUILD)/chart
