# SPDX-License-Identifier: MIT
# What tests reach of src/, port/panel/ and port/host/: lines, branches and MC/DC, by clang-19. Not part of `make test`.

COVERAGE := $(BUILD)/coverage

# The library is built in these ways; `mixed` has pixels for size and all else for speed. All suites run on the first; on
# the others, those that go through most of it.
COVERAGE_BUILDS := host small split divide zeros mixed
COVERAGE_OPTION_host  := -O2
COVERAGE_OPTION_mixed := -O2 $$(if $$(filter src/pixel/%,$$<),-Os)
$(foreach build,small split divide zeros,$(eval COVERAGE_OPTION_$(build) := -O2 $(call option_flags,$(build))))

SUITE_threads    := tests/threads/threads.c $(THREADS_SHARED)
SUITE_bus        := tests/board/bus.c $(TEST_HARNESS)
$(foreach suite,$(PANEL_SUITES),$(eval SUITE_$(suite) := tests/panel/$(suite).c $(filter-out $(PANEL_DRIVERS),$(PANEL_SHARED))))
$(foreach target,render differential,$(eval SUITE_fuzz_$(target) := tests/fuzz/fuzz_$(target).c $(FUZZ_SOURCES_fuzz_$(target))))
COVERAGE_FUZZ    := fuzz_render fuzz_differential

COVERAGE_SUITES_host  := $(TEST_SUITES) old limits stability_regions stability_kept threads
COVERAGE_SUITES_panel := $(PANEL_SUITES) bus
$(foreach build,small split divide zeros mixed,$(eval COVERAGE_SUITES_$(build) := unit stability_regions stability_kept coverage lines))
COVERAGE_SUITES_split := unit

# Names of panels' tests are clang's to judge, as where they run under the sanitisers.
$(eval $(call test_objects,coverage/panel/tests,clang-19 -O2))
$(COVERAGE)/panel/tests/%.o: TEST_INCLUDES += -Itests/panel

# $(call coverage_program,build,suite,flags): tests as the host has them, with all of a build's library or drivers
define coverage_program
$(COVERAGE)/$1/$2: $(SUITE_$2:%.c=$(if $(filter panel,$1),$(COVERAGE)/panel/tests,$(BUILD)/host)/%.o) $(COVERAGE)/$1/libglint.a $(if $(filter panel,$1),$(BUILD)/host/libglint.a)
	$$(Q)clang-19 -fprofile-instr-generate -pthread $3 $$(filter %.o,$$^) \
	    -Wl,--whole-archive $(COVERAGE)/$1/libglint.a -Wl,--no-whole-archive $$(filter $(BUILD)/host/%.a,$$^) -lm -o $$@
endef

# $(call coverage_run,build): a target that runs a build's suites, and replays what fuzzing has kept
define coverage_run
.PHONY: coverage-$1
coverage-$1: $(addprefix $(COVERAGE)/$1/,$(COVERAGE_SUITES_$1) $(COVERAGE_FUZZ_$1))
	@rm -f $(COVERAGE)/$1/*.profraw
	@$$(foreach target,$(COVERAGE_FUZZ_$1),LLVM_PROFILE_FILE=$(COVERAGE)/$1/$$(target).profraw \
	    $(COVERAGE)/$1/$$(target) -runs=0 $(FUZZ_CORPUS)/$$(target) >$(COVERAGE)/$1/$$(target).log 2>&1 && echo "$$(target): no report" &&) true
	$$(call run_suites,$(COVERAGE_SUITES_$1:%=$(COVERAGE)/$1/%))
coverage-$1: export LLVM_PROFILE_FILE = $(COVERAGE)/$1/%m.profraw
endef

COVERAGE_FUZZ_host := $(COVERAGE_FUZZ)
$(foreach build,$(COVERAGE_BUILDS),\
    $(eval $(call library,$(COVERAGE)/$(build),tools/coverage/clang.sh -ffreestanding $(COVERAGE_OPTION_$(build)))))
$(COVERAGE)/panel/port/panel/%.o: port/panel/%.c $(PANEL_HEADERS) tools/coverage/clang.sh
	@mkdir -p $(@D)
	$(Q)tools/coverage/clang.sh $(TEST_CFLAGS) -O2 -c $< -o $@
$(COVERAGE)/panel/libglint.a: $(PANEL_DRIVERS:%.c=$(COVERAGE)/panel/%.o)
	@rm -f $@
	$(Q)$(AR) rcs $@ $^
$(foreach build,$(COVERAGE_BUILDS) panel,$(foreach suite,$(COVERAGE_SUITES_$(build)),\
    $(eval $(call coverage_program,$(build),$(suite)))))
$(foreach target,$(COVERAGE_FUZZ),$(eval $(call coverage_program,host,$(target),-fsanitize=fuzzer)))
$(foreach build,$(COVERAGE_BUILDS) panel,$(eval $(call coverage_run,$(build))))

# The host's programs, built whole for this: counters are written as they change, for tests that limit what a program may
# write, or end it.
COVERAGE_PROGRAMS := $(COVERAGE)/programs
COVERAGE_HOST     := $(addprefix $(COVERAGE_PROGRAMS)/host/,glint glint-without-scenes glint-import glint-view)
COVERAGE_MAKE     := $(MAKE) --no-print-directory BUILD=$(COVERAGE_PROGRAMS) \
    CC="clang-19 -fprofile-instr-generate -fcoverage-mapping -mllvm -runtime-counter-relocation -Wno-unused-command-line-argument"
.PHONY: coverage-programs
coverage-programs: export LLVM_PROFILE_FILE = $(abspath $(COVERAGE))/programs/%m%c.profraw
coverage-programs:
	+@$(COVERAGE_MAKE) $(COVERAGE_HOST)
	@rm -f $(COVERAGE_PROGRAMS)/*.profraw
	@$(COVERAGE_PROGRAMS)/host/glint-import >/dev/null 2>&1; true
	+@$(COVERAGE_MAKE) test-host-cli test-view

COVERAGE_LIBRARY  := $(addprefix coverage-,$(COVERAGE_BUILDS) panel)
COVERAGE_PROFILES := $(foreach build,$(COVERAGE_BUILDS),$(COVERAGE)/$(build)=$(COVERAGE)/$(build)/unit) \
    $(COVERAGE)/panel=$(COVERAGE)/panel/bus
COVERAGE_JUDGE := python3 tools/coverage/coverage.py $(if $(GAPS),--gaps)
COVERAGE_ALL   := $(COVERAGE_PROFILES) $(COVERAGE_PROGRAMS)=$(subst $() $(),$(comma),$(COVERAGE_HOST))
.PHONY: coverage coverage-library
coverage: $(COVERAGE_LIBRARY) coverage-programs ## what tests reach: lines, branches and MC/DC of the library, panel drivers and host programs (GAPS=1: what they do not)
	@$(COVERAGE_JUDGE) $(COVERAGE_ALL)

coverage-library: $(COVERAGE_LIBRARY) ## the same of the library and panel drivers alone
	@$(COVERAGE_JUDGE) $(COVERAGE_PROFILES)
