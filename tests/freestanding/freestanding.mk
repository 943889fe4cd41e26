# SPDX-License-Identifier: MIT
# The library by itself, for every core: what it needs from outside, and what it must not contain. Cores without an FPU have
# it from the boards; nothing of a board is in it.

freestanding_m4f := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard

# $(call freestanding_fpu,optimisation)
define freestanding_fpu
$(BUILD)/freestanding/m4f-$1/%.o: %.c $(wildcard src/*.h src/*/*.h) tests/freestanding/freestanding.mk
	@mkdir -p $$(@D)
	$$(Q)$(CROSS)gcc $$(freestanding_m4f) -std=c99 $(LIBRARY_WARNINGS) -$1 -ffreestanding -ffunction-sections -fdata-sections \
	    -fcallgraph-info=su -Isrc -c $$< -o $$@
endef

$(foreach level,Os O2,$(eval $(call freestanding_fpu,$(level))))

FREESTANDING := $(foreach board,mps2-an385-m0 mps2-an385,$(foreach level,Os O2,$(BUILD)/$(board)/$(level))) \
    $(addprefix $(BUILD)/freestanding/m4f-,$(call pick,0,Os O2))

test-freestanding: $(foreach folder,$(FREESTANDING),$(LIBRARY:%.c=$(folder)/%.o) $(folder)/tests/freestanding/planted.o) ## the library needs nothing and has no float, data or recursion
	@python3 tests/freestanding/freestanding.py --cross $(CROSS) $(FREESTANDING)
