# SPDX-License-Identifier: MIT
# Fuzz targets, tests/fuzz/fuzz_*.c. Each links what it needs of the library and of two archives: the host's sources, and
# what tests share.

FUZZ_SECONDS ?= 60
# Another one tries other inputs.
FUZZ_SEED    ?= 6
FUZZ         := $(BUILD)/fuzz
FUZZ_CORPUS  := tests/fuzz/corpus
FUZZ_TARGETS := $(patsubst tests/fuzz/fuzz_%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
FUZZ_CFLAGS  := $(TEST_CFLAGS) -O2 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer \
    -fprofile-instr-generate -fcoverage-mapping

FUZZ_SHARED  := $(filter-out tests/fuzz/fuzz_%,$(wildcard tests/fuzz/*.c port/panel/*.c tests/panel/*model*.c)) \
    $(addprefix tests/panel/,wire.c panels.c patterns.c) $(TEST_CONTRACT)
$(FUZZ)/libglint.a: $(call objects,$(FUZZ),$(LIBRARY))
$(FUZZ)/libhost.a: $(call objects,$(FUZZ),$(wildcard port/host/*.c))
$(FUZZ)/libshared.a: $(call objects,$(FUZZ),$(FUZZ_SHARED))
$(FUZZ)/lib%.a:
	@rm -f $@
	$(Q)$(AR) rcs $@ $^
$(FUZZ_TARGETS:%=$(FUZZ)/fuzz_%): $(FUZZ)/%: $(FUZZ)/tests/fuzz/%.o $(FUZZ)/libshared.a $(FUZZ)/libhost.a $(FUZZ)/libglint.a
	$(Q)clang $(FUZZ_CFLAGS) $^ -lm -o $@
$(FUZZ)/%.o: %.c
	@mkdir -p $(@D)
	$(Q)clang $(FUZZ_CFLAGS) -MMD -MP -c $< -o $@
-include $(wildcard $(FUZZ)/*/*.d $(FUZZ)/*/*/*.d)

# Where inputs hold no words to be guessed of, following comparisons would take most of the time.
FUZZ_WORDLESS := $(LIBRARY) $(filter-out tests/fuzz/checks.c,$(FUZZ_SHARED)) $(patsubst %,tests/fuzz/fuzz_%.c,panel render differential) \
    $(addprefix port/host/,cluster.c join.c basics.c mesh.c quantise.c simplify.c topology.c)
$(call objects,$(FUZZ),$(FUZZ_WORDLESS)): FUZZ_CFLAGS += -fno-sanitize-coverage=trace-cmp
# What judges is not what is judged: it is compiled as it is, and no input is kept for its sake.
FUZZ_JUDGES := $(wildcard tests/reference/*.c) tests/image/judge.c tests/panel/panels.c tests/panel/patterns.c
$(call objects,$(FUZZ),$(FUZZ_JUDGES)): FUZZ_CFLAGS := $(filter-out -fsanitize=% -fno-sanitize-recover=% -fprofile-% -fcoverage-%,$(FUZZ_CFLAGS))
# The command line's target calls the program's main function.
$(FUZZ)/port/host/main.o: FUZZ_CFLAGS += -Dmain=glint_main

.PHONY: fuzz fuzz-coverage $(FUZZ_TARGETS:%=fuzz-%)

fuzz: $(FUZZ_TARGETS:%=fuzz-%) ## random scenes and models for FUZZ_SECONDS each, under ASan and UBSan
fuzz-differential: ## random scenes against the double-precision reference for FUZZ_SECONDS, the worst kept

# Goes on from the kept corpus, and from what was found before, with a seed for each time. An input that was reported goes
# into the kept corpus, by the name of its SHA-1, with the mend; `fuzz_x -merge=1 -use_counters=0 NEW CORPUS...` makes a
# small corpus of large ones. Little freed memory is held back, and inputs are not weighed by how rare their features are:
# a third of the time of scenes.
$(FUZZ_TARGETS:%=fuzz-%): fuzz-%: $(FUZZ)/fuzz_%
	@mkdir -p $<-corpus
	@if ! LLVM_PROFILE_FILE=/dev/null ASAN_OPTIONS=quarantine_size_mb=4 $< -max_total_time=$(FUZZ_SECONDS) -timeout=10 -max_len=4096 -len_control=10 -entropic=0 \
	        -seed=`expr $(FUZZ_SEED) + \`ls $<-corpus | wc -l\`` -print_final_stats=1 -artifact_prefix=$<- $<-corpus $(FUZZ_CORPUS)/fuzz_$* > $<.log 2>&1; then \
	    grep -v '^#' $<.log; echo "$<: a report; the input is beside it"; exit 1; \
	fi; \
	grep '^worst' $<.log | tail -n 3; \
	echo "$<: no report in $(FUZZ_SECONDS) s," `sed -n 's/^stat::number_of_executed_units: *//p' $<.log` runs

fuzz-coverage: $(FUZZ_TARGETS:%=$(FUZZ)/fuzz_%) ## the kept corpora: no report, and at least 90 % of the lines of each file of the host, 75 % of each folder of the library
	@python3 tests/fuzz/coverage.py --programs $(FUZZ) --corpora $(FUZZ_CORPUS)
