# SPDX-License-Identifier: MIT
# The library's suites on the host. Each is a program that closes with `N passed, N failed` and exits 1 on a failure.

TEST_INCLUDES := -Isrc -Iexamples -Iexamples/bench -Itests -Itests/reference -Itests/image -Itests/unit \
    -Iport -Iport/host
TEST_CFLAGS    = -std=c99 $(WARNINGS) $(DEBUG) $(TEST_INCLUDES)

TEST_HARNESS := tests/harness.c tests/main.c
TEST_UNIT    := $(wildcard tests/unit/*.c)
TEST_SCENES  := tests/image/picture.c tests/image/scenes.c examples/bench/bench.c \
    port/host/cluster.c port/host/patch.c port/host/memory.c
TEST_JUDGE   := tests/image/library_geometry.c tests/image/judge.c tests/reference/reference.c \
    tests/reference/lighting.c

SUITE_unit      := $(TEST_HARNESS) $(TEST_UNIT)
SUITE_numbers   := $(TEST_HARNESS) tests/reference/numbers.c
SUITE_camera    := $(TEST_HARNESS) tests/reference/camera.c tests/reference/reference.c tests/reference/lighting.c
SUITE_accuracy  := $(TEST_HARNESS) tests/image/accuracy.c tests/image/rows.c $(TEST_SCENES) $(TEST_JUDGE)
SUITE_models    := $(TEST_HARNESS) tests/image/models.c tests/image/surfaces.c tests/image/rows.c $(TEST_SCENES) $(TEST_JUDGE) \
    tests/stability/contract.c tests/stability/weights.c $(wildcard examples/scenes/*.c)
SUITE_corners   := $(TEST_HARNESS) tests/image/corners.c tests/image/picture.c $(TEST_JUDGE)
SUITE_formats   := $(TEST_HARNESS) tests/image/formats.c tests/stability/contract.c tests/stability/random_scene.c \
    tests/stability/weights.c $(TEST_SCENES) $(TEST_JUDGE) $(wildcard examples/scenes/*.c)
SUITE_extremes  := $(TEST_HARNESS) tests/image/extremes.c tests/image/rows.c $(TEST_SCENES) $(TEST_JUDGE)
SUITE_coverage  := $(TEST_HARNESS) tests/image/coverage.c tests/stability/random_scene.c tests/stability/weights.c $(TEST_SCENES) \
    $(TEST_JUDGE) $(wildcard examples/scenes/*.c)
SUITE_kept      := $(TEST_HARNESS) tests/image/kept.c $(TEST_SCENES)
SUITE_arenas    := $(TEST_HARNESS) tests/image/arenas.c $(TEST_SCENES)
SUITE_layouts   := $(TEST_HARNESS) tests/image/layouts.c tests/image/surfaces.c tests/image/rows.c $(TEST_SCENES) $(TEST_JUDGE)
SUITE_pick      := $(TEST_HARNESS) tests/image/pick.c $(TEST_SCENES)
SUITE_region    := $(TEST_HARNESS) tests/image/region.c $(TEST_SCENES)
SUITE_callbacks := $(TEST_HARNESS) tests/image/callbacks.c $(TEST_SCENES)
SUITE_lines     := $(TEST_HARNESS) tests/image/lines.c $(TEST_SCENES) $(TEST_JUDGE)
SUITE_orthographic := $(TEST_HARNESS) tests/image/orthographic.c tests/stability/contract.c tests/stability/weights.c \
    $(TEST_SCENES) $(TEST_JUDGE)
SUITE_patches   := $(TEST_HARNESS) tests/image/patches.c tests/stability/contract.c tests/stability/weights.c tests/image/picture.c \
    $(TEST_JUDGE)
SUITE_motion    := $(TEST_HARNESS) tests/image/motion.c $(TEST_SCENES) $(TEST_JUDGE) $(wildcard examples/scenes/*.c)
SUITE_dark      := $(TEST_HARNESS) tests/image/dark.c tests/stability/random_scene.c \
    tests/stability/weights.c $(TEST_SCENES) $(wildcard examples/scenes/*.c)
SUITE_parts     := $(TEST_HARNESS) tests/host/parts.c \
    $(addprefix port/host/,compare.c numbered.c png_read.c inflate.c png.c deflate.c output.c memory.c problem.c)
PIXEL_SUMS      := $(addprefix tests/image/,pixel_sums.c surfaces.c) tests/stability/random_scene.c tests/stability/weights.c \
    $(TEST_SCENES) $(wildcard examples/scenes/*.c)
SUITE_pixels    := $(TEST_HARNESS) tests/image/pixels.c $(PIXEL_SUMS)
SUITE_rooms     := $(TEST_HARNESS) tests/image/rooms.c tests/image/picture.c tests/stability/large_scene.c
SUITE_checked   := $(TEST_HARNESS) tests/image/checked.c tests/stability/large_scene.c $(TEST_SCENES)
SUITE_identity  := $(TEST_HARNESS) tests/image/identity.c $(TEST_SCENES)
TEST_SUITES     := unit parts numbers accuracy models formats extremes coverage identity pixels layouts region callbacks pick camera kept arenas dark motion lines orthographic patches corners rooms checked

# $(call test_objects,variant,compiler and flags): build/<variant>/<source>.o
define test_objects
VARIANT_$1 := $2
$(BUILD)/$1/%.o: %.c
	@mkdir -p $$(@D)
	$$(Q)$2 $$(TEST_CFLAGS) -MMD -MP -c $$< -o $$@
-include $$(wildcard $$(foreach folder,tests */* */*/*,$(BUILD)/$1/$$(folder)/*.d))
endef

# $(call test_variant,variant,compiler and flags): tests, and a library of their own, both compiled with these. As one file
# the library takes half of the time; EVERY=1 compiles its files.
define test_variant
$(call $(if $(EVERY),library,one_file_library),$(BUILD)/$1,$2)
$(call test_objects,$1,$2)
endef
define one_file_library
$1/glint.o: $(BUILD)/single/glint.c
	@mkdir -p $$(@D)
	$$(Q)$2 -std=c99 $(LIBRARY_WARNINGS) $$(DEBUG) -c $$< -o $$@
$1/libglint.a: $1/glint.o
	@rm -f $$@
	$$(Q)$(AR) rcs $$@ $$^
endef

# $(call test_program,program,variant,sources): objects of the variant, and its library
define test_program
$1: $(patsubst %.c,$(BUILD)/$2/%.o,$3) $(BUILD)/$2/libglint.a
	@mkdir -p $$(@D)
	$$(Q)$$(VARIANT_$2) $$^ -lm -o $$@
endef

# $(call test_suite,variant,suite): build/tests/<variant>/<suite>
test_suite = $(call test_program,$(BUILD)/tests/$1/$2,$1,$(SUITE_$2))

# The host's suites link the library that its programs do.
$(eval $(call test_objects,host,$(CC) $(CFLAGS)))
$(foreach suite,$(TEST_SUITES),$(eval $(call test_suite,host,$(suite))))

# Address and undefined-behaviour sanitisers, and conversions that change a value; a report ends the program. Unsigned
# numbers may wrap: sums of hashes do, and two's complement in words.
SANITIZE := -O1 -fsanitize=address,undefined,integer -fno-sanitize=unsigned-integer-overflow,unsigned-shift-base \
    -fno-sanitize-recover=all -fno-omit-frame-pointer
# What they put in takes most of the time, and a report names the file.
$(eval $(call library,$(BUILD)/sanitize,clang $(SANITIZE)))
$(eval $(call test_objects,sanitize,clang $(SANITIZE)))
# The double-precision reference, which takes most of the time and is run as it is by test-image, is not under them but in
# `make sanitize`.
SANITIZE_ALL ?=
$(TEST_JUDGE:%.c=$(BUILD)/sanitize/%.o): TEST_CFLAGS += $(if $(SANITIZE_ALL),,-O2 -fno-sanitize=all)
$(foreach suite,$(TEST_SUITES),$(eval $(call test_suite,sanitize,$(suite))))

# Compilers at every level of optimisation; gcc with all that this machine has, which brings vectors and warnings of their
# own, and across files; clang watching for what was never written.
MATRIX_PLAIN := $(foreach compiler,gcc clang,$(foreach level,O0 Os O2 O3,$(compiler)-$(level)))
MATRIX := $(MATRIX_PLAIN) clang19-Os clang19-O3 gcc-native gcc-lto memory
$(foreach variant,$(MATRIX_PLAIN),$(eval $(call test_variant,$(variant),$(subst -, -,$(variant)))))
$(foreach level,Os O3,$(eval $(call test_variant,clang19-$(level),clang-19 -$(level))))
$(eval $(call test_variant,gcc-native,gcc -O3 -march=native))
$(eval $(call test_variant,gcc-lto,gcc -O2 -flto=auto))
$(eval $(call test_variant,memory,clang -O1 -fsanitize=memory -fno-sanitize-recover=all))
$(foreach variant,$(MATRIX),$(eval $(call test_suite,$(variant),unit)))
$(MATRIX:%=$(BUILD)/%/%.o): DEBUG :=

# Of those that are alike one, which the seed picks.
MATRIX_TESTED := $(call pick,0,gcc-O0 gcc-Os gcc-O2) $(call pick,1,gcc-O3 gcc-native gcc-lto) \
    $(call pick,2,clang-O0 clang-Os clang-O2 clang-O3) $(call pick,4,clang19-Os clang19-O3) memory

# $(call run_suites,programs): runs all, also after a failure, as many at once as there are cores; prints them in order
run_suites = @rm -f $(addsuffix .status,$1); \
	printf '%s\n' $1 | xargs -P $$(nproc) -I {} sh -c '{} > {}.log 2>&1; echo $$? > {}.status'; \
	status=0; for suite in $1; do \
	    echo "$$suite"; cat "$$suite.log"; [ "$$(cat "$$suite.status")" = 0 ] || status=1; \
	done; exit $$status

.PHONY: rooms test-unit-host test-image test-identity test-sanitize sanitize test-matrix variants unit-tables

test-unit-host: $(addprefix $(BUILD)/tests/host/,unit parts numbers camera) ## unit tests on the host, arithmetic against libm, files of others
	$(call run_suites,$^)

test-image: $(addprefix $(BUILD)/tests/host/,accuracy models formats extremes coverage pixels layouts region callbacks pick kept arenas dark motion lines orthographic patches corners rooms checked) ## images against the double-precision reference
	$(call run_suites,$^)

test-identity: $(BUILD)/tests/host/identity ## the same image for every tile size, arena and order
	$(call run_suites,$^)

ROOMS      ?= 100000
ROOMS_SEED ?= 1
rooms: export GLINT_ROOMS := $(ROOMS)
rooms: export GLINT_ROOMS_SEED := $(ROOMS_SEED)
rooms: $(BUILD)/tests/host/rooms $(BUILD)/tests/sanitize/rooms ## large triangles with the eye inside: ROOMS random scenes from ROOMS_SEED, also under sanitisers
	$(call run_suites,$^)

# Of the suites that take long one of three or four, which the seed picks.
SANITIZED_LONG   := accuracy models formats identity motion orthographic layouts pixels kept numbers callbacks
SANITIZED_TESTED := $(if $(SANITIZE_ALL),$(TEST_SUITES),$(filter-out $(SANITIZED_LONG),$(TEST_SUITES)) \
    $(call pick,0,accuracy models) $(call pick,1,formats identity) $(call pick,2,motion orthographic) \
    $(call pick,3,layouts pixels kept) $(call pick,4,numbers callbacks))

test-sanitize: export GLINT_SAMPLE := $(if $(SANITIZE_ALL),1,8)
test-sanitize: $(SANITIZED_TESTED:%=$(BUILD)/tests/sanitize/%) ## host suites that a seed picks under ASan and UBSan, but for their reference, with an eighth of random scenes and arenas; make sanitize is all
	@echo "$(if $(SANITIZE_ALL),every suite,TEST_SEED=$(TEST_SEED))"
	$(call run_suites,$^)

sanitize: ## the host suites and their reference under ASan and UBSan, with all scenes
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/sanitized SANITIZE_ALL=1 test-sanitize

test-matrix: $(MATRIX_TESTED:%=$(BUILD)/tests/%/unit) ## unit tests by three compilers at levels that a seed picks of -O0, -Os, -O2 and -O3, with vectors or across files, and under MSan
	@echo "$(if $(EVERY),every variant,TEST_SEED=$(TEST_SEED))"
	$(call run_suites,$^)

variants: ## suites matrix, options, machines, board-unit, board-identity, firmware, stack, packages, features and freestanding with every compiler, level, option, pair, machine, board and package, where make test takes a sample
	@$(MAKE) --no-print-directory EVERY=1 test-matrix test-options test-machines test-board-unit test-board-identity test-firmware test-stack test-packages test-features test-freestanding

# ---- Tables of the unit tests and of suite pixels, which make figures renews

$(eval $(call test_program,$(BUILD)/tests/print_torus,host,tests/image/print_torus.c examples/bench/bench.c))
$(eval $(call test_program,$(BUILD)/tests/print_checksums,host,tests/image/print_checksums.c tests/harness.c \
    $(addprefix tests/unit/,checksummed.c domains.c fixture.c)))

$(eval $(call test_program,$(BUILD)/tests/print_pixels,host,tests/image/print_pixels.c $(PIXEL_SUMS)))

unit-tables: $(addprefix $(BUILD)/tests/,print_torus print_checksums print_pixels)
	$(BUILD)/tests/print_torus > $(BUILD)/tests/torus.h && cp $(BUILD)/tests/torus.h tests/unit/
	$(BUILD)/tests/print_checksums > $(BUILD)/tests/checksums.h && cp $(BUILD)/tests/checksums.h tests/unit/
	$(BUILD)/tests/print_pixels > $(BUILD)/tests/pixel_table.h && cp $(BUILD)/tests/pixel_table.h tests/image/

# ---- Fuzzing

FUZZ_SECONDS ?= 60
# Another one tries other inputs.
FUZZ_SEED    ?= 2
FUZZ_CC      := clang
FUZZ_CFLAGS  := -std=c99 $(WARNINGS) $(DEBUG) -O2 -Isrc -Iport -Iport/host -Itests -Itests/reference -Itests/image \
    -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer \
    -fprofile-instr-generate -fcoverage-mapping
FUZZ_CORPUS  := tests/fuzz/corpus
FUZZ_TARGETS := $(patsubst tests/fuzz/%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
FUZZ_LIBRARY := $(LIBRARY:%.c=$(BUILD)/fuzz/%.o)

# What a target links beside the library.
FUZZ_SCENES := tests/fuzz/usual_scene.c tests/fuzz/drawing.c $(addprefix port/host/,cluster.c patch.c memory.c)
FUZZ_SOURCES_fuzz_obj          := $(HOST_READER_SOURCES) tests/fuzz/checks.c
FUZZ_SOURCES_fuzz_mtl          := $(FUZZ_SOURCES_fuzz_obj) port/host/material.c
FUZZ_SOURCES_fuzz_import       := $(FUZZ_SOURCES_fuzz_obj) $(addprefix port/host/,importer.c join.c materials.c)
FUZZ_SOURCES_fuzz_command      := $(FUZZ_SOURCES_fuzz_import) $(wildcard port/host/parse_*.c) $(addprefix port/host/,main.c settings.c \
    values.c nearest.c numbered.c framebuffer.c shapes.c material.c load.c child.c winding.c simplify.c place.c view.c)
FUZZ_SOURCES_fuzz_png          := $(addprefix port/host/,png_read.c inflate.c png.c deflate.c output.c memory.c problem.c)
FUZZ_SOURCES_fuzz_panel        := $(wildcard port/panel/*.c tests/panel/*model*.c) $(addprefix tests/panel/,wire.c panels.c patterns.c)
FUZZ_SOURCES_fuzz_render       := tests/fuzz/any_scene.c tests/fuzz/layouts.c $(FUZZ_SCENES)
FUZZ_SOURCES_fuzz_differential := $(FUZZ_SCENES) tests/stability/contract.c tests/stability/weights.c \
    tests/image/picture.c $(TEST_JUDGE)

define fuzz_target
$(BUILD)/fuzz/$1: $(addprefix $(BUILD)/fuzz/,$(patsubst %.c,%.o,tests/fuzz/$1.c $(FUZZ_SOURCES_$1))) $(FUZZ_LIBRARY)
	$$(Q)$(FUZZ_CC) $(FUZZ_CFLAGS) $$^ -lm -o $$@
endef
$(foreach target,$(FUZZ_TARGETS),$(eval $(call fuzz_target,$(target))))

# Where inputs hold no words to be guessed of, following comparisons would take most of the time.
FUZZ_WORDLESS := $(foreach target,panel render differential,tests/fuzz/fuzz_$(target).c $(FUZZ_SOURCES_fuzz_$(target))) \
    $(addprefix port/host/,cluster.c join.c mesh.c patch.c quantise.c simplify.c winding.c)
$(FUZZ_LIBRARY) $(FUZZ_WORDLESS:%.c=$(BUILD)/fuzz/%.o): FUZZ_CFLAGS += -fno-sanitize-coverage=trace-cmp

# What judges is not what is judged: it is compiled as it is, and no input is kept for its sake.
FUZZ_JUDGES := $(wildcard tests/reference/*.c) tests/image/judge.c tests/panel/panels.c tests/panel/patterns.c
$(FUZZ_JUDGES:%.c=$(BUILD)/fuzz/%.o): FUZZ_CFLAGS := $(filter-out -fsanitize=% -fno-sanitize-recover=% -fprofile-% -fcoverage-%,$(FUZZ_CFLAGS))

# The program's main function, for the command line's target to call.
$(BUILD)/fuzz/port/host/main.o: FUZZ_CFLAGS += -Dmain=glint_main

$(BUILD)/fuzz/%.o: %.c
	@mkdir -p $(@D)
	$(Q)$(FUZZ_CC) $(FUZZ_CFLAGS) -MMD -MP -c $< -o $@
-include $(wildcard $(BUILD)/fuzz/*/*.d $(BUILD)/fuzz/*/*/*.d)

.PHONY: fuzz fuzz-coverage $(FUZZ_TARGETS:fuzz_%=fuzz-%)

fuzz: $(FUZZ_TARGETS:fuzz_%=fuzz-%) ## random scenes and models for FUZZ_SECONDS each, under ASan and UBSan
fuzz-differential: ## random scenes against the double-precision reference for FUZZ_SECONDS, the worst kept

# Goes on from the kept corpus, and from what was found before, with a seed for each time. An input that was reported goes
# into the kept corpus, by the name of its SHA-1, with the mend; `fuzz_x -merge=1 -use_counters=0 NEW CORPUS...` makes a
# small corpus of large ones. Little freed memory is held back, and inputs are not weighed by how rare their features are:
# a third of the time of scenes.
$(FUZZ_TARGETS:fuzz_%=fuzz-%): fuzz-%: $(BUILD)/fuzz/fuzz_%
	@mkdir -p $<-corpus
	@if ! LLVM_PROFILE_FILE=/dev/null ASAN_OPTIONS=quarantine_size_mb=4 $< -max_total_time=$(FUZZ_SECONDS) -timeout=10 -max_len=4096 -len_control=10 -entropic=0 \
	        -seed=`expr $(FUZZ_SEED) + \`ls $<-corpus | wc -l\`` -print_final_stats=1 -artifact_prefix=$<- $<-corpus $(FUZZ_CORPUS)/fuzz_$* > $<.log 2>&1; then \
	    grep -v '^#' $<.log; echo "$<: a report; the input is beside it"; exit 1; \
	fi; \
	grep '^worst' $<.log | tail -n 3; \
	echo "$<: no report in $(FUZZ_SECONDS) s," `sed -n 's/^stat::number_of_executed_units: *//p' $<.log` runs

SUITES += fuzz-coverage
fuzz-coverage: $(FUZZ_TARGETS:%=$(BUILD)/fuzz/%) ## the kept corpora: no report, and at least 90 % of the lines of each file of the host, 75 % of each folder of the library
	@python3 tests/fuzz/coverage.py --programs $(BUILD)/fuzz --corpora $(FUZZ_CORPUS)
