# SPDX-License-Identifier: MIT
# What tests reach of src/, port/panel/ and port/host/: lines, branches and MC/DC, by clang-19. Not part of `make test`.

COVERAGE := $(BUILD)/coverage

# The library is built in these ways; `mixed` has pixels for size and all else for speed. All suites run on the first; on
# the others, those that go through most of it. `panel` is the drivers of panels.
COVERAGE_BUILDS       := host small split divide zeros mixed
COVERAGE_FLAGS_mixed  := $$(if $$(filter src/pixel/%,$$<),-Os)
COVERAGE_SUITES_host  := $(TEST_SUITES) equivalences old limits stability_regions stability_kept threads
COVERAGE_SUITES_split := unit
COVERAGE_SUITES_panel := $(PANEL_SUITES)
COVERAGE_FUZZ_host    := fuzz_render fuzz_differential
coverage_suites = $(or $(COVERAGE_SUITES_$1),unit stability_regions stability_kept coverage lines)

$(foreach build,$(COVERAGE_BUILDS),$(eval $(call library,$(COVERAGE)/$(build),\
    tools/coverage/clang.sh -ffreestanding -O2 $(or $(COVERAGE_FLAGS_$(build)),$(call option_flags,$(build))))))
$(COVERAGE)/panel/port/panel/%.o: port/panel/%.c $(wildcard port/panel/*.h src/*.h src/*/*.h) tools/coverage/clang.sh
	@mkdir -p $(@D)
	$(Q)tools/coverage/clang.sh $(TEST_CFLAGS) -O2 -c $< -o $@
$(COVERAGE)/panel/libglint.a: $(call objects,$(COVERAGE)/panel,$(wildcard port/panel/*.c))
	@rm -f $@
	$(Q)$(AR) rcs $@ $^

# Names of panels' tests are clang's to judge, as where they run under the sanitisers.
VARIANT_coverage/tests := clang-19 -O2
$(eval $(call variant_objects,coverage/tests))

# Tests are as the host has them, with all of a build's library or drivers; fuzz targets replay what fuzzing has kept.
# $(call coverage_programs,build), and $(call coverage_objects,build,suite)
coverage_programs = $(addprefix $(COVERAGE)/$1/,$(coverage_suites) $(COVERAGE_FUZZ_$1))
coverage_objects  = $(call objects,$(BUILD)/$(if $(filter panel,$1),coverage/tests,host),$(filter-out port/panel/%,$(call suite_sources,$2)))
$(foreach build,$(COVERAGE_BUILDS) panel,$(call coverage_programs,$(build))): $(COVERAGE)/%: $$(call coverage_objects,$$(*D),$$(*F)) \
        $(COVERAGE)/$$(*D)/libglint.a $(BUILD)/host/libglint.a
	$(Q)clang-19 -fprofile-instr-generate -pthread $(if $(filter fuzz_%,$(*F)),-fsanitize=fuzzer) $(filter %.o,$^) \
	    -Wl,--whole-archive $(@D)/libglint.a -Wl,--no-whole-archive $(if $(filter panel,$(*D)),$(BUILD)/host/libglint.a) -lm -o $@

COVERAGE_LIBRARY := $(addprefix coverage-,$(COVERAGE_BUILDS) panel)
$(COVERAGE_LIBRARY): export LLVM_PROFILE_FILE = $(COVERAGE)/$(@:coverage-%=%)/%m.profraw
$(COVERAGE_LIBRARY): coverage-%: $$(call coverage_programs,$$*)
	@rm -f $(COVERAGE)/$*/*.profraw
	@$(foreach target,$(COVERAGE_FUZZ_$*),LLVM_PROFILE_FILE=$(COVERAGE)/$*/$(target).profraw \
	    $(COVERAGE)/$*/$(target) -runs=0 $(FUZZ_CORPUS)/$(target) >$(COVERAGE)/$*/$(target).log 2>&1 && echo "$(target): no report" &&) true
	$(call run_suites,$(filter-out %/fuzz_render %/fuzz_differential,$(filter $(COVERAGE)/$*/%,$^)))

# The host's programs, built whole for this: counters are written as they change, for tests that limit what a program may
# write, or end it.
COVERAGE_PROGRAMS := $(COVERAGE)/programs
COVERAGE_HOST     := $(addprefix $(COVERAGE_PROGRAMS)/host/,glint glint-without-scenes glint-import glint-view)
COVERAGE_MAKE     := $(MAKE) --no-print-directory BUILD=$(COVERAGE_PROGRAMS) \
    CC="clang-19 -fprofile-instr-generate -fcoverage-mapping -mllvm -runtime-counter-relocation -Wno-unused-command-line-argument"
coverage-programs: export LLVM_PROFILE_FILE = $(abspath $(COVERAGE))/programs/%m%c.profraw
coverage-programs:
	+@$(COVERAGE_MAKE) $(COVERAGE_HOST)
	@rm -f $(COVERAGE_PROGRAMS)/*.profraw
	@$(COVERAGE_PROGRAMS)/host/glint-import >/dev/null 2>&1; true
	+@$(COVERAGE_MAKE) test-host-cli test-view

# $(call coverage_judge,folder,least % of lines,branches and conditions,folders of profiles,programs)
coverage_judge = @tools/coverage/report.sh $(COVERAGE)/report/$1 $1 $2 "$3" $4
.PHONY: coverage coverage-library coverage-programs $(COVERAGE_LIBRARY)
coverage-library: $(COVERAGE_LIBRARY) ## what tests reach: lines, branches and MC/DC of the library and panel drivers; build/coverage/report/ shows what they do not
	$(call coverage_judge,src,95 90 80,$(COVERAGE_BUILDS:%=$(COVERAGE)/%),$(COVERAGE_BUILDS:%=$(COVERAGE)/%/unit))
	$(call coverage_judge,port/panel,100 100 100,$(COVERAGE)/panel,$(COVERAGE)/panel/panel_pictures)

coverage: coverage-library coverage-programs ## the same, and lines of the host programs
	$(call coverage_judge,port/host,98 0 0,$(COVERAGE_PROGRAMS),$(COVERAGE_HOST))
