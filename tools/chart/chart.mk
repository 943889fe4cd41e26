# SPDX-License-Identifier: MIT
# Charts, and the pages that walk through them, from figures measured here: errors on the host, instructions on emulated
# cores. What was measured is kept in docs/ as CSV; `make chart` draws from that.

CHART_IMAGE := tests/image/picture.c tests/image/library_geometry.c tests/reference/reference.c tests/reference/lighting.c

# ---- Errors, on the host

# $(call chart_host,program,sources)
chart_host = $(call test_program,$(BUILD)/chart/$1,host,tools/chart/$1.c $2 $(CHART_IMAGE))
$(eval $(call chart_host,frame_accuracy,examples/bench/bench.c $(addprefix port/host/,cluster.c patch.c memory.c)))
$(eval $(call chart_host,shading,))
$(eval $(call chart_host,lobes,))

$(eval $(call chart_host,gallery_accuracy,tests/stability/contract.c tests/stability/weights.c tests/image/judge.c \
    $(wildcard examples/scenes/*.c)))

$(eval $(call chart_host,modelled,tests/image/undropped.c examples/bench/bench.c $(wildcard examples/scenes/*.c)))

$(BUILD)/modelled.csv: $(BUILD)/chart/modelled
	$< > $@

$(BUILD)/lobes.csv: $(BUILD)/chart/lobes
	$< > $@

$(BUILD)/%-accuracy.csv: $(BUILD)/chart/%_accuracy
	$< > $@

# ---- Instructions, in the emulator

PROGRAM_frame_board   := tools/chart/frame_board.c
PROGRAM_shading_board := tools/chart/shading_board.c
PROGRAM_arena_board := tools/chart/arena_board.c $(wildcard examples/scenes/*.c)
PROGRAM_modelled_board := tools/chart/modelled_board.c tests/image/undropped.c $(wildcard examples/scenes/*.c)

CHART_BOARDS := m0=mps2-an385-m0 m3=mps2-an385 m4=mps2-an386 rv32=virt

# $(call chart_elf,core=board,program), and the same with the machine that runs it
chart_elf = $(BUILD)/$(lastword $(subst =, ,$1))/O2/$2.elf
chart_run = $(firstword $(subst =, ,$1))=$(patsubst %-m0,%,$(lastword $(subst =, ,$1)))=$(call chart_elf,$1,$2)

$(foreach pair,$(CHART_BOARDS),$(eval $(call firmware_program,$(lastword $(subst =, ,$(pair))),O2,frame_board)))
$(eval $(call firmware_program,mps2-an385,O2,shading_board))
$(eval $(call firmware_program,mps2-an385,O2,arena_board))
$(foreach board,mps2-an385 mps2-an385-m0,$(eval $(call firmware_program,$(board),O2,modelled_board)))
# They measure; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out %/frame_board.elf %/shading_board.elf %/modelled_board.elf %/arena_board.elf,$(FIRMWARE))

$(foreach pair,$(CHART_BOARDS),\
    $(BUILD)/$(lastword $(subst =, ,$(pair)))/O2/tools/chart/frame_board.o) \
$(foreach board,mps2-an385 mps2-an385-m0,\
    $(BUILD)/$(board)/O2/tools/chart/modelled_board.o): $(BUILD)/bench/bench_scenes.h

CHART_FRAMES := $(foreach pair,$(CHART_BOARDS),$(call chart_elf,$(pair),frame_board))
$(BUILD)/frame-instructions.csv: $(CHART_FRAMES) tools/chart/count.py tools/bench/emulate.py
	python3 tools/chart/count.py --qemu $(QEMU) --head scene,size,format,choice,cpu,instructions \
	    $(foreach pair,$(CHART_BOARDS),$(call chart_run,$(pair),frame_board)) > $@

MODELLED_RUNS := $(foreach pair,$(filter m0=% m3=%,$(CHART_BOARDS)),$(call chart_run,$(pair),modelled_board))
$(BUILD)/modelled-instructions.csv: $(foreach pair,$(filter m0=% m3=%,$(CHART_BOARDS)),$(call chart_elf,$(pair),modelled_board)) \
        tools/chart/count.py tools/bench/emulate.py
	python3 tools/chart/count.py --qemu $(QEMU) --head scene,variant,size,way,cpu,instructions $(MODELLED_RUNS) > $@

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

.PHONY: frame-figures modelled figures chart test-chart
frame-figures: $(BUILD)/frame-accuracy.csv $(BUILD)/gallery-accuracy.csv $(BUILD)/frame-instructions.csv $(BUILD)/shading.csv $(BUILD)/lobes.csv $(BUILD)/arena.csv ## measure accuracy and instructions of whole frames, and keep them in docs
	cp $(BUILD)/frame-accuracy.csv $(BUILD)/gallery-accuracy.csv $(BUILD)/frame-instructions.csv docs/
	cp $(BUILD)/shading.csv $(BUILD)/lobes.csv $(BUILD)/arena.csv docs/charts/

modelled: $(BUILD)/modelled.csv $(BUILD)/modelled-instructions.csv ## measure what scenes model, and what dropping and error budgets save, and keep it in docs
	cp $^ docs/

figures: $(BUILD)/bench.csv $(BUILD)/accuracy.csv frame-figures modelled ## measure all that charts and pages show, keep it in docs, and draw it
	cp $(BUILD)/bench.csv $(BUILD)/bench-arena.csv $(BUILD)/accuracy.csv docs/
	@$(MAKE) --no-print-directory prices
	@$(MAKE) --no-print-directory chart

chart: ## draw the charts of docs/charts and the tables of docs/accuracy.md from the CSV files kept in docs
	@tools/setup.sh
	@python3 tools/chart/chart.py

SUITES += test-chart
test-chart: ## charts and figures in pages against the CSV files kept in docs
	@python3 tools/chart/chart.py --check $(BUILD)/chart
