# SPDX-License-Identifier: MIT
# The same bits at every level of optimisation, by every compiler, and with the code of cores that have no wide product, do
# not divide or do not count zeros.

LEVEL_SOURCES := tests/levels/draw.c tests/image/picture.c \
    $(addprefix tests/stability/,random_scene.c large_scene.c weights.c)

# As ARMv6-M has it.
LEVEL_v6m := -DGLINT_SPLIT_PRODUCTS=1 -DGLINT_DIVIDES=0 -DGLINT_COUNTS_ZEROS=0
LEVEL_VARIANTS := v6m-Os v6m-O2
$(foreach level,Os O2,$(eval $(call test_variant,v6m-$(level),$(CC) -$(level) $(LEVEL_v6m))))
$(LEVEL_VARIANTS:%=$(BUILD)/%/%.o): DEBUG :=

# What is compiled for size alone, and for such cores, under ASan and UBSan.
$(eval $(call test_variant,sanitize-small,clang $(subst -O1,-Os,$(SANITIZE)) $(LEVEL_v6m)))

# Who draws is compiled once: a seed is the same scene for all.
define level_program
$(BUILD)/tests/$1/levels: $(LEVEL_SOURCES:%.c=$(BUILD)/host/%.o) $(BUILD)/$1/libglint.a
	@mkdir -p $$(@D)
	$$(Q)$$(VARIANT_$1) $$^ -lm -o $$@
endef
$(foreach variant,host $(MATRIX_PLAIN) $(LEVEL_VARIANTS) sanitize sanitize-small,$(eval $(call level_program,$(variant))))

# What is built for size each time, and of the others some that the seed picks.
LEVELS_TESTED := host gcc-Os v6m-Os sanitize-small $(call pick,0,gcc-O0 gcc-O3 v6m-O2) $(call pick,2,clang-O0 clang-Os clang-O2 clang-O3)
LEVELS_ALL    := host $(MATRIX_PLAIN) $(LEVEL_VARIANTS) sanitize sanitize-small
LEVEL_SCENES  ?= 100000
LEVEL_SEED    ?= 1

SUITES += test-levels
.PHONY: levels test-levels
test-levels: $(LEVELS_TESTED:%=$(BUILD)/tests/%/levels) ## the same bits at every level, and with the code of other cores: 20,000 random scenes, some builds that a seed picks
	@echo "$(if $(EVERY),every build,TEST_SEED=$(TEST_SEED))"
	@python3 tests/levels/levels.py --count 20000 --seed 1 $^

levels: $(LEVELS_ALL:%=$(BUILD)/tests/%/levels) ## the same bits by every compiler at every level: LEVEL_SCENES random scenes from LEVEL_SEED
	@python3 tests/levels/levels.py --count $(LEVEL_SCENES) --seed $(LEVEL_SEED) $^
