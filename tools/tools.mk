# SPDX-License-Identifier: MIT
# What is measured, drawn and written to docs/, and what packages take. What was measured is kept in docs/ as CSV;
# `make figures` draws from that.

# ---- Programs of this machine

SUITE_scenes           := tools/bench/scenes.c $(BENCH_SCENES)
SUITE_frame_accuracy   := tools/chart/frame_accuracy.c $(BENCH_SCENES) $(JUDGE_SOURCES)
SUITE_ways_accuracy    := tools/chart/ways_accuracy.c tests/float/snapped.c $(FLOAT_RENDERER) $(JUDGE_SOURCES)
SUITE_shading          := tools/chart/shading.c $(JUDGE_SOURCES)
SUITE_depth            := tools/chart/depth.c $(sort $(RANDOM_SCENES) $(TEST_CONTRACT))
SUITE_gallery_accuracy := tools/chart/gallery_accuracy.c $(TEST_CONTRACT) $(EXAMPLE_SCENES)
SUITE_gallery_figures  := tools/gallery/figures.c tests/image/picture.c $(EXAMPLE_SCENES)
SUITE_cost_means       := tools/cost/means.c $(WORKLOADS) $(JUDGE_SOURCES)
SUITE_cost_edges       := tools/cost/edges.c $(WORKLOADS) $(JUDGE_SOURCES)
SUITE_cost_pictures    := tools/cost/pictures.c $(WORKLOADS) $(PNG_SOURCES)
SUITE_page_pictures    := tools/pages/pictures.c $(wildcard examples/compose/*.c examples/lines/*.c examples/moving/*.c) $(PNG_SOURCES)
HOST_TOOLS             := $(BUILD)/tests/host

$(BUILD)/bench/bench_scenes.h: $(HOST_TOOLS)/scenes
	@mkdir -p $(@D)
	$(Q)$< > $@
$(BUILD)/bench/spot.h: examples/models/spot.obj $(HOST_PROGRAM)
	@mkdir -p $(@D)
	$(HOST_PROGRAM) convert $< -o $@ > /dev/null

# ---- Instructions, counted in QEMU; the plugin counts them by kind, for the model of a core's cycles (costs.py)

# $(call machine,core): the emulated machine. Cores without floating point, and ARMv6-M, run on another core's.
machine   = $(patsubst %-m0,%,$(BOARD_$(1:m4f=m4)))
# $(call core_elf,core,program), the firmware of several cores, and CORE=FIRMWARE and CORE=MACHINE=FIRMWARE of each
core_elf  = $(BUILD)/$(BOARD_$1)/O2/$2.elf
core_elfs = $(foreach core,$1,$(call core_elf,$(core),$2))
core_runs = $(foreach core,$1,$(core)=$(call core_elf,$(core),$2))
machine_runs = $(foreach core,$1,$(core)=$(call machine,$(core))=$(call core_elf,$(core),$2))
COUNT     := python3 tools/chart/count.py --qemu $(QEMU)

CYCLES_PLUGIN := $(BUILD)/cycles/plugin.so
$(CYCLES_PLUGIN): $(wildcard tools/cycles/*.c tools/cycles/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c99 $(WARNINGS) -O2 -fPIC -shared -fvisibility=hidden $(filter %.c,$^) -o $@

test-cycles: $(CYCLES_PLUGIN) $(call core_elfs,m0 m3 m4 m4f,loops) ## loops whose cycles are counted by hand, against the model of cores
	@python3 tests/cycles/loops.py --qemu $(QEMU) --plugin $(CYCLES_PLUGIN) $(call machine_runs,m0 m3 m4 m4f,loops)

# Loops over pixels in RAM, where flash makes the core wait: the table of docs/packages.md.
HOT       := $(foreach program,frames workloads,$(call core_elfs,m0 hot,$(program)))
HOT_TABLE := python3 tools/cycles/hot.py --qemu $(QEMU) --plugin $(CYCLES_PLUGIN) --page docs/packages.md \
    $(foreach core,m0 hot,$(BUILD)/$(BOARD_$(core))/O2)
.PHONY: hot-page
hot-page: $(HOT) $(CYCLES_PLUGIN)
	$(HOT_TABLE) --write
test-hot-page: $(call core_elfs,m0 hot,frames) $(CYCLES_PLUGIN) ## what loops in RAM gain and take, against docs/packages.md
	@$(HOT_TABLE)

.PHONY: bench bench-diff
BENCH_CORES := m3 m0 m4 rv32
$(BUILD)/bench.csv: $(foreach program,frames workloads methods,$(call core_elfs,$(BENCH_CORES),$(program))) $(call core_elf,m4f,float) \
        $(call core_elf,m3,default_frames) $(CYCLES_PLUGIN) $(wildcard tools/bench/*.py tools/cycles/*.py) tests/board/qemu.py
	$(Q)python3 tools/bench/bench.py --qemu $(QEMU) --output $(BUILD) --plugin $(CYCLES_PLUGIN) \
	    --frames $(call machine_runs,$(BENCH_CORES),frames) $(call machine_runs,$(BENCH_CORES),workloads) $(call machine_runs,m3,default_frames) \
	    --float $(call machine_runs,m4f,float) --methods $(call machine_runs,$(BENCH_CORES),methods)

bench: $(BUILD)/bench.csv ## count the instructions of whole frames of every kind of scene, and of methods; writes build/bench.csv
	@column -s , -t $<

bench-diff: $(BUILD)/bench.csv ## what changed against docs/bench.csv; fails when anything did
	@git --no-pager diff --no-index --word-diff=plain --word-diff-regex='[^,]+' -U0 docs/bench.csv $<

# ---- What each feature costs, for a core and a level that the seed picks

# $(call features_core,core): compiles and links; {level} stands for the level of optimisation
features_core = "$1=$(call board_gcc,$(BOARD_$1)) $(FIRMWARE_CFLAGS) -{level} $(FIRMWARE_LDFLAGS) -T $(call linker,$(BOARD_$1)) \
    tools/features/feature.c $(call objects,$(BUILD)/$(BOARD_$1)/Os,$(call port_sources,$(BOARD_$1))) $(BUILD)/$(BOARD_$1)/{level}/libglint.a -lgcc"
# $(call features_built,cores,levels): what that takes
features_built = $(BUILD)/bench/bench_scenes.h $(foreach core,$1,$(call objects,$(BUILD)/$(BOARD_$(core))/Os,$(call port_sources,$(BOARD_$(core)))) \
    $(foreach level,$2,$(BUILD)/$(BOARD_$(core))/$(level)/libglint.a))
features = python3 tools/features/features.py --qemu $(QEMU) --output $(BUILD) --page docs/features.md $(foreach core,$1,$(call features_core,$(core)))

FEATURES_CORES  := $(call pick,8,m3 m0)
FEATURES_LEVELS := $(call pick,0,Os O2)
.PHONY: features
features: $(call features_built,m3 m0,Os O2)
	@$(call features,m3 m0)

test-features: $(call features_built,$(FEATURES_CORES),$(FEATURES_LEVELS)) ## docs/features.md against what is measured, of a core and a level that a seed picks
	$(call sample,core and level)
	@$(call features,$(FEATURES_CORES)) --check $(subst $() $(),$(comma),$(FEATURES_LEVELS))

# ---- Charts, and the pages that walk through them

CHART_CORES := m0 m3 m4 rv32
$(BUILD)/%-accuracy.csv: $(HOST_TOOLS)/%_accuracy
	$< > $@
$(BUILD)/frame-instructions.csv: $(call core_elfs,$(CHART_CORES),frame_board) $(call core_elf,m4f,frame_float_board) tools/chart/count.py tools/bench/emulate.py
	$(COUNT) --head scene,size,format,lights,choice,cpu,instructions $(call machine_runs,$(CHART_CORES),frame_board) \
	    $(call machine_runs,m4f,frame_float_board) > $@
$(BUILD)/arena.csv: $(call core_elf,m3,arena_board) tools/chart/count.py tools/bench/emulate.py
	$(COUNT) --head scene,size,arena,passes,cpu,instructions $(call machine_runs,m3,arena_board) > $@
$(BUILD)/gallery-instructions.csv: $(call core_elfs,m0 m3,gallery_costs) tools/chart/count.py tools/bench/emulate.py
	$(Q)$(COUNT) --head scene,variant,size,cpu,instructions $(call machine_runs,m0 m3,gallery_costs) > $@
$(BUILD)/means.csv $(BUILD)/edges.csv: $(BUILD)/%.csv: $(HOST_TOOLS)/cost_%
	$< > $@
# Errors and instructions in one table.
$(BUILD)/shading.csv: $(HOST_TOOLS)/shading $(call core_elf,m3,shading_board) tools/chart/count.py
	@mkdir -p $(BUILD)/chart
	$< > $(BUILD)/chart/errors.csv
	$(COUNT) --head format,evaluation,triangles,cpu,instructions $(call machine_runs,m3,shading_board) > $(BUILD)/chart/instructions.csv
	paste -d, $(BUILD)/chart/errors.csv $(BUILD)/chart/instructions.csv | cut -d, -f1-5,9-10 > $@

.PHONY: chart-figures depth chart gallery
# How exact colours and depths are over the depth ratio: minutes.
$(BUILD)/depth.csv: $(HOST_TOOLS)/depth
	$(Q)$< > $@
depth: $(BUILD)/depth.csv
	cp $< docs/charts/

CHART_TABLES := $(addprefix $(BUILD)/,bench.csv frame-accuracy.csv gallery-accuracy.csv frame-instructions.csv ways-accuracy.csv)
chart-figures: $(CHART_TABLES) $(BUILD)/shading.csv $(BUILD)/arena.csv $(BUILD)/means.csv $(BUILD)/edges.csv
	cp $(CHART_TABLES) $(BUILD)/bench-arena.csv docs/
	cp $(BUILD)/shading.csv $(BUILD)/arena.csv $(BUILD)/means.csv $(BUILD)/edges.csv docs/charts/

chart:
	@tools/setup.sh
	@python3 tools/chart/chart.py $(BUILD)/chart

test-chart: ## charts and figures in pages against the CSV files kept in docs
	@python3 tools/chart/chart.py --check $(BUILD)/chart

# The gallery: every example scene and variant, what is measured in the pictures, and what each costs to draw.
gallery: $(HOST_PROGRAM) $(HOST_TOOLS)/gallery_figures $(BUILD)/gallery-instructions.csv
	cp $(BUILD)/gallery-instructions.csv docs/
	python3 tools/gallery/gallery.py $(HOST_PROGRAM) $(HOST_TOOLS)/gallery_figures docs/gallery-instructions.csv docs/gallery

# ---- docs/boards.md: a row for each board, and what its panel shows. The README has a table of one board.

BOARDS_STREAM := $(BUILD)/pico/release/show.stream
# The README's moving picture: a first frame, which includes the start, and three whose time is told.
NIGHT_STREAM  := $(BUILD)/pico/O2/night.stream
BOARDS_PAGE   := python3 tools/boards/boards.py --build $(BUILD) --host $(SHOW_HOST) --stream $(BOARDS_STREAM) --night $(NIGHT_STREAM) \
    --panel $(PANEL_STREAM)
BOARDS_BUILT  := $(SHOW_HOST) $(foreach board,$(filter-out template mps2-an385-m0,$(BOARDS)),$(BUILD)/$(board)/release/show.elf) \
    $(PAINTED_CSV) $(ANIMATE_RUN:%=$(BUILD)/%/O2/animate.elf) $(BOARDS_STREAM) \
    $(NIGHT_STREAM) $(PANEL_STREAM)

# On a bus that takes no time: instructions that wait for it are not counted.
$(BOARDS_STREAM): $(BUILD)/pico/release/show.bin $(PICO_EMULATOR) tests/pico/run.js
	$(Q)node tests/pico/run.js $< $@ free > /dev/null
$(NIGHT_STREAM): $(BUILD)/pico/O2/night.bin $(PICO_EMULATOR) tests/pico/run.js
	$(Q)node tests/pico/run.js $< $@ real 4 > /dev/null

# The example scenes in motion: what each frame takes of the core by the model of cycles, and of the bus.
ANIMATE_MARKED := mps2-an385=$(BUILD)/mps2-an385/O2/animate-marked.elf \
    netduinoplus2=$(BUILD)/netduinoplus2/O2/animate-marked-polled.elf pico=$(BUILD)/pico/O2/animate.bin
$(BUILD)/animate-times.csv $(BUILD)/animate-times-part.csv: $(call files,$(ANIMATE_MARKED)) $(CYCLES_PLUGIN) $(PICO_EMULATOR) \
        tools/boards/times.py tools/cycles/costs.py tests/pico/run.js
	$(Q)python3 tools/boards/times.py --plugin $(CYCLES_PLUGIN) $(if $(findstring part,$@),--part) $(ANIMATE_MARKED) > $@

.PHONY: boards-page
boards-page: $(BOARDS_BUILT) $(BUILD)/animate-times.csv
	@mkdir -p docs/boards
	$(Q)$(BOARDS_PAGE) --times $(BUILD)/animate-times.csv --write docs/boards.md docs/boards README.md docs/night.png

test-boards-page: $(BOARDS_BUILT) $(BUILD)/animate-times-part.csv ## the figures and pictures of docs/boards.md and the README are true
	@$(BOARDS_PAGE) --times $(BUILD)/animate-times-part.csv docs/boards.md docs/boards README.md docs/night.png

# ---- Pictures of pages

WINDOW_PICTURE := $(BUILD)/pages/window
$(WINDOW_PICTURE): $(BUILD)/host/tools/pages/window.o $(VIEW_OBJECTS) $(HOST_PARTS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) $^ $(SIMPLIFIER) -lm -o $@

.PHONY: cost-pictures page-pictures demo-picture web-picture
# $(call draw_anew,folder,programs)
draw_anew = @rm -rf $1 && mkdir -p $1 $(patsubst %,&& % $1,$2)
cost-pictures: $(HOST_TOOLS)/cost_pictures
	$(call draw_anew,docs/cost,$^)
page-pictures: $(HOST_TOOLS)/page_pictures $(WINDOW_PICTURE)
	$(call draw_anew,docs/pages,$^)

demo-picture: $(HOST_PROGRAM)
	$(Q)$(HOST_PROGRAM) demo -o docs/demo.png

web-picture: web $(BUILD)/npm/web/installed
	NODE_MODULES=$(abspath $(BUILD)/npm/web/node_modules) node tests/web/picture.js docs/web/index.html docs/web.png

test-cost: $(HOST_TOOLS)/cost_pictures ## the pictures of docs/cost.md against what is drawn
	$(call draw_anew,$(BUILD)/cost/drawn,$^)
	@python3 tools/cost/compare.py $(BUILD)/cost/drawn docs/cost docs/cost.md

test-pages: $(HOST_TOOLS)/page_pictures $(WINDOW_PICTURE) ## the pictures of docs/compose.md, docs/black.md, docs/meshes.md and docs/view.md against what is drawn
	$(call draw_anew,$(BUILD)/pages/drawn,$^)
	@python3 tools/cost/compare.py $(BUILD)/pages/drawn docs/pages docs/compose.md docs/black.md docs/meshes.md docs/view.md

# ---- After a changed pixel, or a changed instruction: everything that a test or lint compares, and all that pages show. In
# ---- this order: what is measured, what is written from that, and the page, which holds both.

FIGURES := unit-tables chart-figures depth gallery features options-page hot-page stability boards-page cost-pictures page-pictures \
    demo-picture chart web web-picture
.PHONY: figures options-page
figures: ## after a changed pixel: measure, draw and write anew all that pages show and that tests compare
	@tools/setup.sh
	+@for step in $(FIGURES); do printf '######## %s\n' $$step; $(MAKE) --no-print-directory $$step || exit 1; done

options-page: single
	@python3 tests/packages/options.py --build $(BUILD) --write

# What docs/reliability.md and SECURITY.md name is there.
test-reliability: ## the targets, files and links that docs/reliability.md and SECURITY.md name
	@$(MAKE) --no-print-directory help | python3 tools/reliability/reliability.py --suites "$(SUITES)"

# ---- Packages: one source and two headers, a CMSIS-Pack, an archive of the sources; the headers as pages

SINGLE := $(BUILD)/single
.PHONY: single pack dist doxygen mutants
single: $(SINGLE)/glint.c ## the library as one source and two headers, in build/single
$(SINGLE)/glint.c $(SINGLE)/glint.h $(SINGLE)/glint_extras.h &: tools/packages/single.py $(LIBRARY) $(wildcard src/*.h src/*/*.h)
	$(Q)python3 $< $(SINGLE)

pack: ## the library as a CMSIS-Pack, and as a ZIP file for Arduino and PlatformIO, in build/pack
	@for made in pack arduino; do python3 tools/packages/$$made.py $(BUILD)/pack `tools/version.sh print` || exit 1; done

dist: ## the sources of the last commit as an archive, the same bytes anywhere, with its SHA256SUMS in build/dist
	@tools/packages/dist.sh $(BUILD)/dist

doxygen: ## the public headers as pages, in build/doxygen/html; what is not documented is an error
	@mkdir -p $(BUILD)/doxygen
	@doxygen tools/doxygen/Doxyfile

# ---- Single changes to src/ and port/panel/ that some suite should notice, under sanitizers. A mutant takes seconds, a
# ---- survivor minutes.

# How many are judged, in the order of a seed; files of src/ and port/panel/ that they are in, all unless some are named.
MUTANTS       ?= 20
MUTANTS_SEED  ?= $(TEST_SEED)
MUTANTS_FILES ?=
MUTANTS_JOBS  ?= $(shell nproc)
# How many may survive without a reason.
MUTANTS_LEFT  ?= 0
# What judges the library, quick suites first; workloads would build the host's program with each mutant. Drivers of panels
# are judged by the suites of panels.
MUTANTS_QUICK  := unit extremes camera region pick numbers checked
MUTANTS_SLOW   := stability_kept stability_regions callbacks identity accuracy
MUTANTS_SUITES := $(MUTANTS_QUICK) $(filter-out $(MUTANTS_QUICK) $(MUTANTS_SLOW) motion corners rooms workloads,$(TEST_SUITES)) $(MUTANTS_SLOW)
mutants: $(patsubst %,$(BUILD)/tests/sanitize/%,$(MUTANTS_SUITES) $(PANEL_SUITES)) ## change MUTANTS places of src/ and port/panel/, one at a time, from MUTANTS_SEED (MUTANTS_FILES: only there): does a suite notice?
	@python3 tools/mutants/mutants.py --build $(BUILD) --known tools/mutants/known.csv --count $(MUTANTS) \
	    --seed $(MUTANTS_SEED) --jobs $(MUTANTS_JOBS) --variant sanitize --library $(MUTANTS_SUITES) --panels $(PANEL_SUITES) \
	    --left $(MUTANTS_LEFT) --files $(MUTANTS_FILES)
