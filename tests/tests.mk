# SPDX-License-Identifier: MIT
# The library's suites on the host. Each is a program that closes with `N passed, N failed` and exits 1 on a failure:
# build/tests/<variant>/<suite>, from sources and a library that are compiled as the variant says.

# ---- Variants: a compiler and its flags. Where VARIANT_x does not say, x is the command itself: gcc-O2 is gcc -O2.

VARIANT_host := $(CC) $(CFLAGS)
# Address and undefined-behaviour sanitisers, and conversions that change a value; a report ends the program. Unsigned
# numbers may wrap: sums of hashes do, and two's complement in words.
# What functions require of callers is checked too.
REQUIRED := '-DGLINT_REQUIRE(condition)=((condition)?(void)0:__builtin_unreachable())'
VARIANT_sanitize := clang -O1 -fsanitize=address,undefined,integer -fno-sanitize=unsigned-integer-overflow,unsigned-shift-base \
    -fno-sanitize-recover=all -fno-omit-frame-pointer $(REQUIRED)
# gcc uses all that this machine has, which brings vectors and warnings of their own, or compiles across files; clang watches
# for what was never written, and for what threads share.
VARIANT_gcc-native := gcc -O3 -march=native
VARIANT_gcc-lto    := gcc -O2 -flto=auto
VARIANT_clang19-Os := clang-19 -Os
VARIANT_clang19-O3 := clang-19 -O3
VARIANT_memory     := clang -O1 -fsanitize=memory -fno-sanitize-recover=all
VARIANT_threads    := clang -O1 -fsanitize=thread -pthread
# The code of ARMv6-M, which has no wide product, does not divide and does not count zeros; for size also sanitised.
AS_ARMV6M := -DGLINT_SPLIT_PRODUCTS=1 -DGLINT_DIVIDES=0 -DGLINT_COUNTS_ZEROS=0
VARIANT_v6m-Os := $(CC) -Os $(AS_ARMV6M)
VARIANT_v6m-O2 := $(CC) -O2 $(AS_ARMV6M)
VARIANT_sanitize-small := $(subst -O1,-Os,$(VARIANT_sanitize)) $(AS_ARMV6M)
# Programs of other machines run in QEMU's user mode: one of 32 bits, one whose char is unsigned, one of big-endian byte
# order, one without any of these.
VARIANT_i686    := i686-linux-gnu-gcc -O2 -static
VARIANT_armhf   := arm-linux-gnueabihf-gcc -O2 -static
VARIANT_s390x   := s390x-linux-gnu-gcc -O2 -static
VARIANT_riscv64 := riscv64-linux-gnu-gcc -O2 -static
EMULATOR_i686    := qemu-i386
EMULATOR_armhf   := qemu-arm
EMULATOR_s390x   := qemu-s390x
EMULATOR_riscv64 := qemu-riscv64

# What else than a compiler's level decides what is compiled, one by one and in pairs: option-split, option-small-zeros. A
# core's own options are set as another core has them. `small` alone is a part of test-matrix.
OPTIONS := split divide zeros small-split small-divide small-zeros split-divide split-zeros divide-zeros
OPTION_small  := -Os
OPTION_split  := -DGLINT_SPLIT_PRODUCTS=1
OPTION_divide := -D__riscv
OPTION_zeros  := -D__riscv
# Each of these two leaves the core that stands in what it has of the other.
OPTION_only_divide := -D__riscv_zbb
OPTION_only_zeros  := -D__riscv_div
# $(call option_flags,options)
option_flags = $(foreach option,$(subst -, ,$1),$(OPTION_$(option))) \
    $(if $(findstring zeros,$1),,$(if $(findstring divide,$1),$(OPTION_only_divide))) \
    $(if $(findstring divide,$1),,$(if $(findstring zeros,$1),$(OPTION_only_zeros)))

# Compilers at every level of optimisation; of those that are alike the seed picks one.
MATRIX_PLAIN  := $(foreach compiler,gcc clang,$(foreach level,O0 Os O2 O3,$(compiler)-$(level)))
MATRIX        := $(MATRIX_PLAIN) clang19-Os clang19-O3 gcc-native gcc-lto memory
MATRIX_TESTED := $(call pick,0,gcc-O0 gcc-Os gcc-O2) $(call pick,1,gcc-O3 gcc-native gcc-lto) \
    $(call pick,2,clang-O0 clang-Os clang-O2 clang-O3) $(call pick,4,clang19-Os clang19-O3) memory

# $(call compiler,variant)
compiler = $(or $(VARIANT_$1),$(if $(filter option-%,$1),$(CC) -O1 $(call option_flags,$(1:option-%=%))),$(subst -, -,$1))

TEST_INCLUDES := -Isrc -Iexamples -Iexamples/bench -Itests -Itests/reference -Itests/image -Itests/unit -Iport -Iport/host \
    -Iport/host/window -Iport/web -Itests/panel -Iexamples/compose -Itools/bench -Itools/bench/float -I$(BUILD)/bench
TEST_CFLAGS    = -std=c99 $(WARNINGS) $(DEBUG) $(TEST_INCLUDES)

# $(call variant_objects,variant): the rule of its objects
define variant_objects
$(BUILD)/$1/%.o: %.c
	@mkdir -p $$(@D)
	$$(Q)$(call compiler,$1) $$(TEST_CFLAGS) -MMD -MP -c $$< -o $$@
-include $$(wildcard $$(foreach folder,tests */* */*/* */*/*/*,$(BUILD)/$1/$$(folder)/*.d))
endef
# $(call one_file_library,folder,compiler and flags): as one file the library takes half of the time
define one_file_library
$1/glint.o: $(BUILD)/single/glint.c
	@mkdir -p $$(@D)
	$$(Q)$2 -std=c99 $(LIBRARY_WARNINGS) $$(DEBUG) -c $$< -o $$@
$1/libglint.a: $1/glint.o
	@rm -f $$@
	$$(Q)$(AR) rcs $$@ $$^
endef

# Nobody looks for lines in these. EVERY=1 compiles the library's files.
UNNUMBERED := $(MATRIX) v6m-Os v6m-O2 i686 armhf s390x riscv64 $(OPTIONS:%=option-%)
$(UNNUMBERED:%=$(BUILD)/%/%.o): DEBUG :=
$(foreach variant,$(UNNUMBERED) threads sanitize-small,\
    $(eval $(call $(if $(EVERY),library,one_file_library),$(BUILD)/$(variant),$(call compiler,$(variant)))))
$(eval $(call library,$(BUILD)/sanitize,$(VARIANT_sanitize)))
$(foreach variant,host sanitize $(UNNUMBERED) threads sanitize-small,$(eval $(call variant_objects,$(variant))))

# ---- Suites: their sources. Without a SUITE_x line, suite x is x.c in one of three folders, and what tests share.

CLUSTERS      := $(addprefix port/host/,cluster.c basics.c)
TEST_HARNESS  := tests/harness.c tests/main.c
BENCH_SCENES  := examples/bench/bench.c $(CLUSTERS)
TEST_SCENES   := tests/image/picture.c tests/image/scenes.c $(BENCH_SCENES)
TEST_JUDGE    := $(filter-out %/picture.c,$(JUDGE_SOURCES)) tests/image/judge.c
TEST_CONTRACT := tests/stability/contract.c tests/stability/level_set.c tests/stability/weights.c tests/image/picture.c $(TEST_JUDGE)
RANDOM_SCENES := $(addprefix tests/stability/,random_scene.c random_texture.c random_layers.c grids.c weights.c)
PIXEL_SUMS    := tests/image/pixel_sums.c tests/image/surfaces.c $(RANDOM_SCENES) \
    $(TEST_SCENES) $(EXAMPLE_SCENES)
TEST_SHARED   := $(sort $(TEST_HARNESS) $(TEST_CONTRACT) $(PIXEL_SUMS) tests/image/rows.c tests/stability/large_scene.c)
FUZZ_SCENES   := $(addprefix tests/fuzz/,any_scene.c usual_scene.c layouts.c textures.c layers.c drawing.c) $(CLUSTERS)
STABILITY_REGIONS := $(sort $(filter-out $(patsubst %,tests/stability/%.c,regions kept search table),$(wildcard tests/stability/*.c)) \
    $(TEST_CONTRACT))
PANEL_MODEL   := $(wildcard tests/panel/*model*.c)
PANEL_SHARED  := $(addprefix tests/panel/,wire.c panels.c patterns.c) $(PANEL_MODEL) $(wildcard port/panel/*.c) $(TEST_HARNESS) $(TEST_SCENES)
suite_sources = $(or $(SUITE_$1),$(if $(filter $(PANEL_SUITES),$1),$(1:panel_%=tests/panel/%.c) $(PANEL_SHARED),\
    $(wildcard tests/image/$1.c tests/reference/$1.c tests/api/$1.c) $(TEST_SHARED)))

IMAGE_SUITES := accuracy models formats extremes coverage pixels layouts region callbacks pick kept arenas dark motion lines \
    orthographic patches corners rooms checked workloads textures blend samples smooth
TEST_SUITES  := unit numbers camera identity $(IMAGE_SUITES)
PANEL_SUITES := panel_pictures panel_complaints panel_faults panel_i2c

SUITE_unit  := $(TEST_HARNESS) $(wildcard tests/unit/*.c)
SUITE_stability_regions := $(TEST_HARNESS) tests/stability/regions.c $(STABILITY_REGIONS)
SUITE_stability_kept    := $(TEST_HARNESS) tests/stability/kept.c $(sort $(RANDOM_SCENES) $(TEST_CONTRACT))
SUITE_stability_search  := tests/stability/search.c $(sort $(RANDOM_SCENES) $(TEST_CONTRACT))
SUITE_stability_table   := tests/harness.c tests/stability/table.c $(STABILITY_REGIONS)
SUITE_fuzz_render       := tests/fuzz/fuzz_render.c tests/equivalence/ways.c tests/image/picture.c $(FUZZ_SCENES)
SUITE_fuzz_differential := tests/fuzz/fuzz_differential.c $(FUZZ_SCENES) $(TEST_CONTRACT)
SUITE_threads := $(TEST_HARNESS) tests/threads/threads.c $(TEST_SCENES)
SUITE_planted := $(TEST_HARNESS) tests/threads/planted.c $(TEST_SCENES)
SUITE_numbers := tests/unit/arithmetic/numbers.c $(TEST_HARNESS)
SUITE_domains := tests/unit/arithmetic/domains.c tests/unit/domains.c tests/unit/fixture.c tests/harness.c
SUITE_methods := tests/unit/methods/test.c tests/unit/methods/judge.c $(METHODS) $(TEST_HARNESS)
SUITE_float   := $(TEST_HARNESS) tests/float/pictures.c tests/float/snapped.c tests/reference/reference.c tests/reference/lighting.c \
    tests/reference/sampling.c $(FLOAT_RENDERER)
SUITE_blend     := tests/image/blend.c tests/equivalence/ways.c $(TEST_SHARED)
SUITE_workloads := $(TEST_HARNESS) tests/image/workloads.c tools/bench/workloads.c tools/bench/boxes.c $(EXAMPLE_SCENES) $(TEST_CONTRACT)
SUITE_frames  := tests/board/identity_host.c $(IDENTITY_FRAMES)
VARIED_SCENES := tests/equivalence/varied_scene.c tests/stability/large_scene.c $(RANDOM_SCENES)
SUITE_equivalences := $(sort $(wildcard tests/equivalence/*.c) $(VARIED_SCENES) $(JUDGE_SOURCES))
SUITE_levels  := tests/levels/draw.c tests/image/picture.c $(VARIED_SCENES)
SUITE_endurance     := tests/endurance/endurance_host.c tests/endurance/endurance.c $(EXAMPLE_SCENES)
# These are other programs of this machine.
SUITE_panel_stream     := tests/panel/panel_stream.c $(PANEL_MODEL)
SUITE_panel_host       := tests/board/panel_host.c tests/board/frames.c examples/firmware/shown.c $(TURNTABLE) $(EXAMPLE_SCENES)
SUITE_show             := tests/board/show_host.c tests/image/picture.c $(TURNTABLE) examples/firmware/animation.c \
    $(wildcard examples/compose/*.c) examples/moving/moving.c $(EXAMPLE_SCENES)
SUITE_print_torus      := tests/image/print_torus.c examples/bench/bench.c
SUITE_print_checksums  := tests/image/print_checksums.c tests/harness.c $(addprefix tests/unit/,checksummed.c domains.c fixture.c)
SUITE_print_pixels     := tests/image/print_pixels.c $(PIXEL_SUMS)
SUITE_methods_accuracy := tests/unit/methods/accuracy.c tests/unit/methods/judge.c $(METHODS)

$(BUILD)/tests/%: $$(call objects,$(BUILD)/$$(*D),$$(call suite_sources,$$(*F))) $(BUILD)/$$(*D)/libglint.a
	@mkdir -p $(@D)
	$(Q)$(call compiler,$(*D)) $^ -lm -o $@

# The reference takes most of the time under sanitisers; test-image runs it as it is, `make sanitize` under them.
SANITIZE_ALL ?=
$(foreach variant,sanitize sanitize-small,$(call objects,$(BUILD)/$(variant),$(TEST_JUDGE))): TEST_CFLAGS += $(if $(SANITIZE_ALL),,-O2 -fno-sanitize=all)
# The judge's doubles are the same from every compiler; the float renderer is what a compiler may make of floats.
$(BUILD)/host/tests/unit/methods/%.o: TEST_CFLAGS += -ffp-contract=off
$(BUILD)/host/tools/bench/float/%.o: TEST_CFLAGS += -ffast-math -ffp-contract=fast
$(patsubst %,$(BUILD)/%/tools/bench/workloads.o,host sanitize): $(BUILD)/bench/bench_scenes.h

# $(call run_suites,programs): runs all, also after a failure, as many at once as there are cores; prints them in order
run_suites = @rm -f $(addsuffix .status,$1); \
	printf '%s\n' $1 | xargs -P $$(nproc) -I {} sh -c '{} > {}.log 2>&1; echo $$? > {}.status'; \
	status=0; for suite in $1; do \
	    echo "$$suite"; cat "$$suite.log"; [ "$$(cat "$$suite.status")" = 0 ] || status=1; \
	done; exit $$status

# $(call sample,what): prints what the seed picks from
sample = @echo "$(if $(EVERY),every $1,TEST_SEED=$(TEST_SEED))"

.PHONY: sanitize variants unit-tables levels equivalences domains accuracy stability endurance panel-stream

test-unit-host: $(addprefix $(BUILD)/tests/host/,unit numbers camera) ## unit tests on the host, arithmetic against libm
	$(call run_suites,$^)

test-image: $(IMAGE_SUITES:%=$(BUILD)/tests/host/%) ## images against the double-precision reference
	$(call run_suites,$^)

test-identity: $(BUILD)/tests/host/identity ## the same image for every tile size, arena and order
	$(call run_suites,$^)

# Of the suites that take long one of three or four, which the seed picks.
SANITIZED_LONG   := accuracy models formats identity motion orthographic layouts pixels kept numbers callbacks textures blend
SANITIZED_TESTED := $(if $(SANITIZE_ALL),$(TEST_SUITES),$(filter-out $(SANITIZED_LONG),$(TEST_SUITES)) \
    $(call pick,0,accuracy models) $(call pick,1,formats identity) $(call pick,2,motion orthographic) \
    $(call pick,3,layouts pixels kept) $(call pick,4,numbers callbacks textures blend))
test-sanitize: export GLINT_SAMPLE := $(if $(SANITIZE_ALL),1,8)
test-sanitize: $(SANITIZED_TESTED:%=$(BUILD)/tests/sanitize/%) ## host suites that a seed picks under ASan and UBSan, but for their reference, with an eighth of random scenes and arenas; make sanitize is all
	@echo "$(if $(SANITIZE_ALL),every suite,TEST_SEED=$(TEST_SEED))"
	$(call run_suites,$^)

sanitize: ## the host suites and their reference under ASan and UBSan, with all scenes
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/sanitized SANITIZE_ALL=1 test-sanitize

test-matrix: $(MATRIX_TESTED:%=$(BUILD)/tests/%/unit) ## unit tests by three compilers at levels that a seed picks of -O0, -Os, -O2 and -O3, with vectors or across files, and under MSan
	$(call sample,variant)
	$(call run_suites,$^)

variants: ## suites matrix, options, machines, board-unit, board-identity, firmware, stack, packages, features and freestanding with every compiler, level, option, pair, machine, board and package, where make test takes a sample
	@$(MAKE) --no-print-directory EVERY=1 test-matrix test-options test-machines test-board-unit test-board-identity test-firmware test-stack test-packages test-features test-freestanding

# One option by itself, and one of the pairs.
OPTIONS_TESTED := $(call pick,0,split divide zeros) $(call pick,1,small-split small-divide small-zeros split-divide split-zeros divide-zeros)
test-options: $(OPTIONS_TESTED:%=$(BUILD)/tests/option-%/unit) single ## unit tests with an option and with a pair of them that a seed picks; docs/packages.md against what they take
	$(call sample,pair)
	$(call run_suites,$(filter %/unit,$^))
	@python3 tests/packages/options.py --build $(BUILD) $(if $(EVERY),,--seed $(TEST_SEED)) $(foreach variant,$(OPTIONS_TESTED),"$(variant)=$(strip $(call option_flags,$(variant)))")

# The machine of big-endian byte order, and one of the others, which the seed picks.
MACHINES_TESTED := s390x $(call pick,0,i686 armhf riscv64)
IDENTITY_HOST   := $(patsubst %,$(BUILD)/tests/%/frames,$(MATRIX_TESTED) sanitize threads)
test-machines: $(foreach suite,unit frames,$(MACHINES_TESTED:%=$(BUILD)/tests/%/$(suite))) $(firstword $(IDENTITY_HOST)) ## unit tests and the same bits on a big-endian machine and on another that a seed picks
	$(call sample,machine)
	$(Q)status=0; $(foreach machine,$(MACHINES_TESTED),echo $(machine); $(EMULATOR_$(machine)) $(BUILD)/tests/$(machine)/unit || status=1;) exit $$status
	@python3 tests/board/identity.py --host $(firstword $(IDENTITY_HOST)) $(foreach machine,$(MACHINES_TESTED),"$(EMULATOR_$(machine)) $(BUILD)/tests/$(machine)/frames")

# Builds for size each time, and of the others some that the seed picks. Objects that draw are compiled once: a seed is the
# same scene for all.
LEVELS_TESTED := host gcc-Os v6m-Os sanitize-small $(call pick,0,gcc-O0 gcc-O3 v6m-O2) $(call pick,2,clang-O0 clang-Os clang-O2 clang-O3)
LEVELS_ALL    := host $(MATRIX_PLAIN) v6m-Os v6m-O2 sanitize sanitize-small
LEVEL_SCENES  ?= 100000
LEVEL_SEED    ?= 1
$(LEVELS_ALL:%=$(BUILD)/tests/%/levels): $(BUILD)/tests/%/levels: $(call objects,$(BUILD)/host,$(SUITE_levels)) $(BUILD)/%/libglint.a
	@mkdir -p $(@D)
	$(Q)$(call compiler,$*) $^ -lm -o $@

test-levels: $(LEVELS_TESTED:%=$(BUILD)/tests/%/levels) ## the same bits at every level, and with the code of other cores: 20,000 random scenes, some builds that a seed picks
	$(call sample,build)
	@python3 tests/levels/levels.py --count 20000 --seed 1 $^

levels: $(LEVELS_ALL:%=$(BUILD)/tests/%/levels) ## the same bits by every compiler at every level: LEVEL_SCENES random scenes from LEVEL_SEED
	@python3 tests/levels/levels.py --count $(LEVEL_SCENES) --seed $(LEVEL_SEED) $^

# ---- The public interface

API_MESH   := $(BUILD)/api/teapot.h
API_PANELS := $(call objects,$(BUILD)/host,$(wildcard port/panel/*.c))
$(API_MESH): $(HOST_PROGRAM) examples/models/teapot.obj
	@mkdir -p $(@D)
	$(Q)$(HOST_PROGRAM) convert examples/models/teapot.obj -o $@

test-api: $(addprefix $(BUILD)/tests/host/,old limits helpers) $(API_MESH) $(BUILD)/host/libglint.a $(API_PANELS) ## headers as C and C++, their names, and what older versions' users wrote
	@$<; status=$$?; $(BUILD)/tests/host/limits || status=1; $(BUILD)/tests/host/helpers || status=1; \
	for compiler in gcc clang; do \
	    $$compiler -std=c99 $(WARNINGS) $(TEST_INCLUDES) -fsyntax-only tests/api/old.c || status=1; \
	done; \
	python3 tests/api/headers.py --mesh $(API_MESH) --library $(BUILD)/host/libglint.a \
	    --panels $(API_PANELS) || status=1; exit $$status

# ---- Functions of one argument against double precision; methods, whose cost tools/bench counts; many frames

DOMAINS := $(BUILD)/tests/host/domains
test-domains: $(DOMAINS) ## functions of one argument: small domains and edges whole, others in strides; make domains is all
	@echo "from arguments that TEST_SEED=$(TEST_SEED) chooses"
	@$< 101 $(TEST_SEED)

domains: $(DOMAINS) ## every argument of every function of one argument, up to 2^32 each: about an hour
	@$< names | xargs -P 2 -I NAME nice $< 1 0 NAME

test-methods: $(BUILD)/tests/host/methods ## every method's error is what it states, over samples
	@$<

# As many processes as cores, one method each.
$(BUILD)/accuracy.csv: $(BUILD)/tests/host/methods_accuracy
	$(Q)rm -rf $(BUILD)/methods/rows && mkdir -p $(BUILD)/methods/rows
	$(Q)seq -w 0 $$(($$($<) - 1)) | xargs -P $$(nproc) -I {} sh -c '$< {} > $(BUILD)/methods/rows/{} || exit 255'
	$(Q){ $< header && cat $(BUILD)/methods/rows/*; } > $@

accuracy: $(BUILD)/accuracy.csv ## what every method is off by, over whole domains: minutes; writes docs/accuracy.csv
	@cut -d, -f 1-6,9 $< | column -s, -t
	cp $< docs/

test-float: $(BUILD)/tests/host/float ## pictures of the float renderer that frames are compared with, against the reference
	@$<

# The test has every variant of every scene, and most of them twice or more.
ENDURANCE        := $(BUILD)/tests/host/endurance
ENDURANCE_FRAMES := 10000
$(BUILD)/mps2-an385/O2/tests/endurance/endurance_board.o: FIRMWARE_CFLAGS += -DENDURANCE_FRAMES=$(ENDURANCE_FRAMES)
test-endurance: $(ENDURANCE) ## thousands of animated frames: each revolution is as the first
	@$< 7000 > $<.log; status=$$?; tail -n 2 $<.log; exit $$status

endurance: $(ENDURANCE) $(BUILD)/mps2-an385/O2/endurance.elf ## a million animated frames on the host, ten thousand on an emulated board: half an hour
	@python3 tests/endurance/endurance.py --qemu $(QEMU) $(BUILD)/mps2-an385/O2/endurance.elf $(ENDURANCE) $(ENDURANCE_FRAMES)
	@$(ENDURANCE) 1000000

# ---- Where methods fail: chosen regions and random scenes, docs/stability.md

# A seed makes the same scene with every compiler.
STABILITY_CLANG  := $(BUILD)/tests/$(firstword $(filter clang-%,$(MATRIX_TESTED)))/stability_kept
STABILITY        := $(BUILD)/tests/host/stability
STABILITY_SEARCH := python3 tests/stability/search.py
STABILITY_PAGE   := python3 tests/stability/page.py docs/stability.md $(BUILD)/stability/regions.csv docs/stability.csv
# Scenes and the first one's seed; those of the figures in docs/stability.md. The suite's own scenes are none of these.
SCENES ?= 100000
SEED   ?= 1
STABILITY_TEST_SEED := 1000001

$(BUILD)/stability/regions.csv: $(STABILITY)_table
	@mkdir -p $(@D)
	$(Q)$< > $@

stability: $(BUILD)/stability/regions.csv $(STABILITY)_search ## where methods fail, by table and by SCENES random scenes from SEED: docs/stability.md
	cp $< docs/charts/
	@$(STABILITY_SEARCH) $(STABILITY)_search --scenes $(SCENES) --seed $(SEED) --csv docs/stability.csv --kept
	@$(STABILITY_PAGE)

STABILITY_SANITIZED := $(patsubst %,$(BUILD)/tests/%/stability_search,sanitize sanitize-small)
test-stability: $(BUILD)/stability/regions.csv $(addprefix $(STABILITY)_,regions kept search) $(STABILITY_CLANG) $(STABILITY_SANITIZED) ## where methods fail: the library does not; 2,000 random scenes
	@status=0; for suite in $(STABILITY)_regions $(STABILITY)_kept $(STABILITY_CLANG); do $$suite || status=1; done; \
	$(STABILITY_SEARCH) $(STABILITY)_search --scenes 2000 --seed $(STABILITY_TEST_SEED) --test || status=1; \
	for search in $(STABILITY_SANITIZED); do \
	    $(STABILITY_SEARCH) $$search --scenes 250 --seed $(STABILITY_TEST_SEED) --test || status=1; \
	done; \
	cmp $< docs/charts/regions.csv || status=1; \
	$(STABILITY_PAGE) --check --program $(STABILITY)_search || status=1; exit $$status

# ---- Random scenes drawn in other ways and told otherwise: the pictures are held against each other

EQUIVALENCES := $(patsubst %,$(BUILD)/tests/%/equivalences,host sanitize sanitize-small)
test-equivalences: $(EQUIVALENCES) ## the same bits in any tiles, arena, region and order, of a mesh split in two, moved and turned; all but the same of a light split in two and mirrored: 8,000 random scenes
	@status=0; $< 8000 1 || status=1; for program in $(filter-out $<,$^); do $$program 1000 10001 || status=1; done; exit $$status

equivalences: $(BUILD)/tests/host/equivalences ## the same of SCENES random scenes from SEED, each core every so many
	@cores=$$(nproc); seq 0 $$((cores - 1)) | xargs -P $$cores -I {} sh -c "nice $< $$(($(SCENES) / cores)) \$$(($(SEED) + {})) $$cores > $<-{}.log; status=\$$?; cat $<-{}.log; exit \$$status"

# ---- One prepared frame drawn by two threads at once. The sanitiser must see it when they share what they must not.

THREADS := $(BUILD)/tests/threads
$(BUILD)/threads/tests/threads/planted.o: tests/threads/threads.c
	@mkdir -p $(@D)
	$(Q)$(VARIANT_threads) $(TEST_CFLAGS) -DSHARED_WORKSPACE -MMD -MP -c $< -o $@

test-threads: $(THREADS)/threads $(THREADS)/planted ## two callers draw the tiles of one frame, under ThreadSanitizer
	$(Q)TSAN_OPTIONS=halt_on_error=1:exitcode=66 $(THREADS)/threads
	$(Q)TSAN_OPTIONS=halt_on_error=1:exitcode=66 $(THREADS)/planted >$(THREADS)/planted.log 2>&1; \
	    if [ $$? -eq 66 ] && grep -q 'data race' $(THREADS)/planted.log; then echo '1 passed, 0 failed'; \
	    else echo 'a workspace shared by two threads was not reported'; echo '0 passed, 1 failed'; exit 1; fi

# ---- Drivers of panels against models of their controllers; under the sanitisers, for both count in bytes

PANEL_STREAM := $(BUILD)/host/panel_stream
$(PANEL_STREAM): $(BUILD)/tests/host/panel_stream
	$(Q)cp $< $@
panel-stream: $(PANEL_STREAM) ## the program that shows what a recorded bus stream puts on a panel

test-panel: $(PANEL_SUITES:%=$(BUILD)/tests/sanitize/%) $(PANEL_STREAM) ## every panel, rotation and format through driver and model
	@status=0; for suite in $(PANEL_SUITES:%=$(BUILD)/tests/sanitize/%); do echo "$$suite"; $$suite || status=1; done; \
	    for program in stream traced; do python3 tests/panel/$$program.py $(PANEL_STREAM) || status=1; done; exit $$status

# Its registers are those of a port whose time passes with each look at them.
$(BUILD)/tests/host/stm32_slow: tests/board/stm32_slow.c port/stm32/spi.c $(TEST_HARNESS) $(wildcard tests/board/slow/*/*.h port/stm32/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Itests/board/slow -Iport -Itests $(filter %.c,$^) -o $@

test-panel-bus: $(BUILD)/tests/host/stm32_slow ## a port whose bus is slow, or stands still
	$(call run_suites,$^)

# ---- Adapters of examples/adapters/ against declarations of what they serve, and doubles that keep what arrives there

ADAPTERS        := $(BUILD)/adapters
ADAPTER_SOURCES := $(wildcard examples/adapters/*.c examples/adapters/*.cpp tests/adapters/*.c tests/adapters/*.cpp) $(TEST_HARNESS)
ADAPTER_OBJECTS := $(ADAPTER_SOURCES:%=$(ADAPTERS)/%.o)
ADAPTER_FLAGS   := $(WARNINGS) $(DEBUG) -O1 -pthread -D_GNU_SOURCE -Isrc -Iexamples -Iport -Itests -isystem tests/adapters/declarations \
    -isystem /usr/include/libdrm -MMD -MP
$(ADAPTERS)/%.c.o: %.c
	@mkdir -p $(@D)
	$(Q)gcc -std=c99 $(ADAPTER_FLAGS) -c $< -o $@
$(ADAPTERS)/%.cpp.o: %.cpp
	@mkdir -p $(@D)
	$(Q)g++ -std=c++11 -fno-exceptions -fno-rtti $(ADAPTER_FLAGS) -c $< -o $@
$(ADAPTERS)/adapters: $(ADAPTER_OBJECTS) $(BUILD)/host/libglint.a
	$(Q)gcc -pthread $(patsubst %,-Wl$(comma)--wrap=%,open close ioctl mmap munmap) $^ -o $@
-include $(wildcard $(ADAPTER_OBJECTS:.o=.d))

test-adapters: $(ADAPTERS)/adapters ## LVGL, Zephyr, u8g2, TFT_eSPI, STM32's HAL, Linux and FreeRTOS, by doubles of each
	$(Q)$<

# ---- The host's programs, packages, the archive that is released, the web page, proofs

test-host-cli: $(HOST_PROGRAM) $(HOST_CONVERTER) $(BUILD)/host/glint-import $(BUILD)/tests/host/gallery_figures ## the command line from outside: every option, every error
	python3 tests/host/run.py $(HOST_PROGRAM)

# Debian's own Python has python3-xlib.
test-view: $(VIEW_PROGRAM) $(HOST_PROGRAM) ## the window, with real keys and mouse on a screen in memory
	@/usr/bin/python3 tests/view/view.py $(VIEW_PROGRAM) $(HOST_PROGRAM) $(VIEW_TESTS)

PACKAGES := $(BUILD)/packages
$(PACKAGES)/minimal: tests/packages/board.c examples/firmware/minimal.c $(addprefix port/panel/,$(lm3s6965evb_PANEL)) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport $^ -o $@
$(PACKAGES)/turntable: tests/packages/turntable.c $(TURNTABLE) $(addprefix port/host/,framebuffer.c basics.c) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport/host -Iexamples $^ -o $@
test-packages: $(PACKAGES)/minimal $(PACKAGES)/turntable $(PANEL_STREAM) $(HOST_PROGRAM) single ## packages that a seed picks: what each builds, and what it says of itself
	$(call sample,package)
	@python3 tests/packages/packages.py --build $(BUILD) $(if $(EVERY),,--seed $(TEST_SEED))

test-dist: ## make dist in two clones of the last commit: the same bytes; what is unpacked draws the demo
	@python3 tests/dist/dist.py $(BUILD)/dist-test

WEB_TEST := $(BUILD)/web/test
$(WEB_TEST)/errors: $(call objects,$(BUILD)/host,tests/web/errors.c port/web/measure.c tests/image/judge.c $(JUDGE_SOURCES)) $(HOST_PARTS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) $^ $(SIMPLIFIER) -lm -o $@
test-web: $(WEB)/page/data.js $(BUILD)/npm/web/installed $(WEB_TEST)/errors $(HOST_PROGRAM) $(PANEL_STREAM) \
    $(BUILD)/i686/libglint.a $(call objects,$(BUILD)/i686,$(EXAMPLE_SCENES)) ## the web page in a browser, and what it exports on boards
	NODE_MODULES=$(abspath $(BUILD)/npm/web/node_modules) node tests/web/run.js $(WEB)/page docs/web $(WEB_TEST)

# Frama-C proves that arithmetic of src/ cannot overflow within its documented ranges.
test-prove: ## prove arithmetic free of overflow; build/proof/proofs.md lists what is proven
	@python3 tests/proof/prove.py --folder tests/proof --output $(BUILD)/proof

# ---- Tables of the unit tests and of suite pixels, which make figures renews

unit-tables: $(addprefix $(BUILD)/tests/host/print_,torus checksums pixels)
	$(BUILD)/tests/host/print_torus > $(BUILD)/tests/torus.h && cp $(BUILD)/tests/torus.h tests/unit/
	$(BUILD)/tests/host/print_checksums > $(BUILD)/tests/checksums.h && cp $(BUILD)/tests/checksums.h tests/unit/
	$(BUILD)/tests/host/print_pixels > $(BUILD)/tests/pixel_table.h && cp $(BUILD)/tests/pixel_table.h tests/image/
