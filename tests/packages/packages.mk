# SPDX-License-Identifier: MIT
# Every way to take the library: minimal.c and a sample built with each, manifests, lists of files.

PACKAGES := $(BUILD)/packages

$(PACKAGES)/minimal: tests/packages/board.c examples/firmware/minimal.c port/panel/panel.c port/panel/solomon.c \
        port/panel/ssd0323.c $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport $^ -o $@

$(PACKAGES)/turntable: tests/packages/turntable.c examples/turntable/turntable.c port/host/framebuffer.c port/host/memory.c \
        port/host/problem.c $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport/host -Iexamples $^ -o $@

SUITES += test-packages
.PHONY: test-packages
test-packages: $(PACKAGES)/minimal $(PACKAGES)/turntable $(BUILD)/host/panel_stream $(HOST_PROGRAM) single ## packages that a seed picks: what each builds, and what it says of itself
	@echo "$(if $(EVERY),every package,TEST_SEED=$(TEST_SEED))"
	@python3 tests/packages/packages.py --build $(BUILD) $(if $(EVERY),,--seed $(TEST_SEED))

# ---- Options: what else than a compiler's level decides what is compiled, one by one and in pairs. The core's own are set
# ---- as another core has them. `small` alone is a part of test-matrix.

OPTION_small  := -Os
OPTION_split  := -DGLINT_SPLIT_PRODUCTS=1
OPTION_divide := -D__riscv
OPTION_zeros  := -D__riscv
# What of the other the core that stands in still has.
OPTION_only_divide := -D__riscv_zbb
OPTION_only_zeros  := -D__riscv_div

OPTIONS := split divide zeros small-split small-divide small-zeros split-divide split-zeros divide-zeros
option_flags = $(foreach option,$(subst -, ,$1),$(OPTION_$(option))) \
    $(if $(findstring zeros,$1),,$(if $(findstring divide,$1),$(OPTION_only_divide))) \
    $(if $(findstring divide,$1),,$(if $(findstring zeros,$1),$(OPTION_only_zeros)))
$(foreach variant,$(OPTIONS),$(eval $(call test_variant,option-$(variant),$(CC) -O1 $(call option_flags,$(variant)))) \
    $(eval $(call test_suite,option-$(variant),unit)))

$(OPTIONS:%=$(BUILD)/option-%/%.o): DEBUG :=

# One by itself, and one of the pairs.
OPTIONS_TESTED := $(call pick,0,split divide zeros) $(call pick,1,small-split small-divide small-zeros split-divide split-zeros divide-zeros)

SUITES += test-options
.PHONY: test-options options-page

test-options: $(OPTIONS_TESTED:%=$(BUILD)/tests/option-%/unit) single ## unit tests with an option and with a pair of them that a seed picks; docs/packages.md against what they take
	@echo "$(if $(EVERY),every pair,TEST_SEED=$(TEST_SEED))"
	$(call run_suites,$(filter %/unit,$^))
	@python3 tests/packages/options.py --build $(BUILD) $(if $(EVERY),,--seed $(TEST_SEED)) $(foreach variant,$(OPTIONS_TESTED),"$(variant)=$(strip $(call option_flags,$(variant)))")

options-page: single
	@python3 tests/packages/options.py --build $(BUILD) --write
