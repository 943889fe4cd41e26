# SPDX-License-Identifier: MIT
# The library by itself, for every core: what it needs from outside, and what it must not contain.

freestanding_m0  := -mcpu=cortex-m0 -mthumb
freestanding_m3  := -mcpu=cortex-m3 -mthumb
freestanding_m4f := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard

# $(call freestanding_core,core,optimisation)
define freestanding_core
$(BUILD)/freestanding/$1-$2/%.o: %.c $(wildcard src/*.h src/*/*.h) tests/freestanding/freestanding.mk
	@mkdir -p $$(@D)
	$$(Q)$(CROSS)gcc $$(freestanding_$1) -std=c99 $(LIBRARY_WARNINGS) -$2 -ffreestanding -ffunction-sections -fdata-sections \
	    -fcallgraph-info=su -Isrc -c $$< -o $$@
FREESTANDING_OBJECTS += $(LIBRARY:%.c=$(BUILD)/freestanding/$1-$2/%.o) \
    $(BUILD)/freestanding/$1-$2/tests/freestanding/planted.o
endef

$(foreach core,m0 m3 m4f,$(foreach level,Os O2,$(eval $(call freestanding_core,$(core),$(level)))))

test-freestanding: $(FREESTANDING_OBJECTS) ## the library needs nothing and has no float, data or recursion
	@python3 tests/freestanding/freestanding.py --cross $(CROSS) \
	    $(foreach core,m0 m3 m4f,$(foreach level,Os O2,$(BUILD)/freestanding/$(core)-$(level)))
