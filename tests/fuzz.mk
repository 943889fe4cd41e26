# SPDX-License-Identifier: MIT
# Fuzz targets, tests/fuzz/fuzz_*.c. Each links what it needs of the library and of two archives: the host's sources, and
# what tests share.

# Runs of each target, in place of seconds.
FUZZ_RUNS    ?=
FUZZ_SECONDS ?= $(if $(FUZZ_RUNS),0,60)
# Another one tries other inputs.
FUZZ_SEED    ?= 6
FUZZ         := $(BUILD)/fuzz
FUZZ_CORPUS  := tests/fuzz/corpus
FUZZ_TARGETS := $(patsubst tests/fuzz/fuzz_%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
FUZZ_DRAWN   := render differential command
FUZZ_WATCHED := -O2 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer $(REQUIRED) \
    -fprofile-instr-generate -fcoverage-mapping
FUZZ_CFLAGS  := $(TEST_CFLAGS) $(FUZZ_WATCHED)

# How the library is built: the commit picks one, so that all come around, or FUZZ_LIBRARY names it.
FUZZ_FLAGS_O2     :=
FUZZ_FLAGS_Os     := -Os
FUZZ_FLAGS_v6m-O2 := $(AS_ARMV6M)
FUZZ_FLAGS_v6m-Os := -Os $(AS_ARMV6M)
FUZZ_LIBRARY  := $(or $(FUZZ_LIBRARY),$(firstword $(call pick,0,O2 Os v6m-O2 v6m-Os)))
FUZZ_PROGRAMS := $(FUZZ)/$(FUZZ_LIBRARY)
# Following comparisons would take most of the library's time.
$(eval $(call library,$(FUZZ_PROGRAMS),clang $(FUZZ_WATCHED) -fno-sanitize-coverage=trace-cmp $(FUZZ_FLAGS_$(FUZZ_LIBRARY))))

FUZZ_SHARED  := $(filter-out tests/fuzz/fuzz_%,$(wildcard tests/fuzz/*.c port/panel/*.c tests/panel/*model*.c)) \
    $(addprefix tests/panel/,wire.c panels.c patterns.c) tests/equivalence/ways.c $(filter-out %/library_geometry.c,$(TEST_CONTRACT))
$(FUZZ)/libhost.a: $(call objects,$(FUZZ),$(wildcard port/host/*.c))
$(FUZZ)/libshared.a: $(call objects,$(FUZZ),$(FUZZ_SHARED))
$(FUZZ)/lib%.a:
	@rm -f $@
	$(Q)$(AR) rcs $@ $^
$(FUZZ_TARGETS:%=$(FUZZ_PROGRAMS)/fuzz_%): $(FUZZ_PROGRAMS)/%: $(FUZZ)/tests/fuzz/%.o $(FUZZ)/libshared.a $(FUZZ)/libhost.a \
        $(FUZZ_PROGRAMS)/library_geometry.o $(FUZZ_PROGRAMS)/libglint.a
	$(Q)clang $(FUZZ_CFLAGS) $^ -lm -o $@
# This looks into the library, whose structures are as it is built.
$(FUZZ_PROGRAMS)/library_geometry.o: tests/image/library_geometry.c
	@mkdir -p $(@D)
	$(Q)clang $(FUZZ_CFLAGS) $(FUZZ_FLAGS_$(FUZZ_LIBRARY)) -MMD -MP -c $< -o $@
$(FUZZ)/%.o: %.c
	@mkdir -p $(@D)
	$(Q)clang $(FUZZ_CFLAGS) -MMD -MP -c $< -o $@
-include $(wildcard $(FUZZ)/*/*.d $(FUZZ)/*/*/*.d)

# Likewise where inputs hold no words to be guessed of.
FUZZ_WORDLESS := $(filter-out tests/fuzz/checks.c,$(FUZZ_SHARED)) $(patsubst %,tests/fuzz/fuzz_%.c,panel render differential) \
    $(addprefix port/host/,cluster.c join.c basics.c mesh.c quantise.c simplify.c topology.c)
$(call objects,$(FUZZ),$(FUZZ_WORDLESS)): FUZZ_CFLAGS += -fno-sanitize-coverage=trace-cmp
# What judges is not what is judged: it is compiled as it is, and no input is kept for its sake.
FUZZ_JUDGES := $(wildcard tests/reference/*.c) tests/image/judge.c tests/panel/panels.c tests/panel/patterns.c
$(call objects,$(FUZZ),$(FUZZ_JUDGES)): FUZZ_CFLAGS := $(filter-out -fsanitize=% -fno-sanitize-recover=% -fprofile-% -fcoverage-%,$(FUZZ_CFLAGS))
# The command line's target calls the program's main function.
$(FUZZ)/port/host/main.o: FUZZ_CFLAGS += -Dmain=glint_main

.PHONY: fuzz fuzz-full fuzz-coverage $(FUZZ_TARGETS:%=fuzz-%)

fuzz: $(FUZZ_TARGETS:%=fuzz-%) ## random scenes and models for FUZZ_SECONDS each, under ASan and UBSan
fuzz-full: ## every target as long as before a release: 10^7 runs of readers and panels, 10^6 of what draws; days
	@$(MAKE) --no-print-directory FUZZ_RUNS=10000000 $(patsubst %,fuzz-%,$(filter-out $(FUZZ_DRAWN),$(FUZZ_TARGETS)))
	@$(MAKE) --no-print-directory FUZZ_RUNS=1000000 $(FUZZ_DRAWN:%=fuzz-%)
fuzz-differential: ## random scenes against the double-precision reference for FUZZ_SECONDS, the worst kept

# Goes on from the kept corpus, and from what was found before, with a seed for each time. An input that was reported goes
# into the kept corpus, by the name of its SHA-1, with the mend; `fuzz_x -merge=1 -use_counters=0 NEW CORPUS...` makes a
# small corpus of large ones. Little freed memory is held back, and inputs are not weighed by how rare their features are:
# a third of the time of scenes.
$(FUZZ_TARGETS:%=fuzz-%): fuzz-%: $(FUZZ_PROGRAMS)/fuzz_%
	@mkdir -p $<-corpus
	@if ! LLVM_PROFILE_FILE=/dev/null ASAN_OPTIONS=quarantine_size_mb=4 $< -max_total_time=$(FUZZ_SECONDS) $(FUZZ_RUNS:%=-runs=%) -timeout=10 -max_len=4096 -len_control=10 -entropic=0 \
	        -seed=`expr $(FUZZ_SEED) + \`ls $<-corpus | wc -l\`` -print_final_stats=1 -artifact_prefix=$<- $<-corpus $(FUZZ_CORPUS)/fuzz_$* > $<.log 2>&1; then \
	    grep -v '^#' $<.log; echo "$<: a report; the input is beside it"; exit 1; \
	fi; \
	grep '^worst' $<.log | tail -n 3; \
	echo "$<: no report in" `sed -n 's/^Done .* in \([0-9]*\) second.*/\1/p' $<.log` s, `sed -n 's/^stat::number_of_executed_units: *//p' $<.log` runs

fuzz-coverage: $(FUZZ_TARGETS:%=$(FUZZ_PROGRAMS)/fuzz_%) ## the kept corpora: no report, and at least 90 % of the lines of each file of the host, 75 % of each folder of the library
	@python3 tests/fuzz/coverage.py --programs $(FUZZ_PROGRAMS) --corpora $(FUZZ_CORPUS)
