# SPDX-License-Identifier: MIT
# What each feature costs; included by port/boards.mk.

# $(call features_core,core,board): compiles and links; {level} stands for the level of optimisation
features_core = "$1=$(CROSS)gcc $($2_CPU) $(FIRMWARE_CFLAGS) -{level} $(FIRMWARE_LDFLAGS) -T $($2_LINKER) \
    tools/features/feature.c $(patsubst %.c,$(BUILD)/$2/Os/%.o,$($2_SOURCES)) $(BUILD)/$2/{level}/libglint.a -lgcc"

FEATURES_BOARD_m3 := mps2-an385
FEATURES_BOARD_m0 := mps2-an385-m0

# $(call features_built,cores,levels): what that takes
features_built = $(BUILD)/bench/bench_scenes.h $(foreach core,$1,$(foreach board,$(FEATURES_BOARD_$(core)),\
    $(patsubst %.c,$(BUILD)/$(board)/Os/%.o,$($(board)_SOURCES)) $(foreach level,$2,$(BUILD)/$(board)/$(level)/libglint.a)))

# $(call features,cores)
features = python3 tools/features/features.py --qemu $(QEMU) --output $(BUILD) --page docs/features.md \
    $(foreach core,$1,$(call features_core,$(core),$(FEATURES_BOARD_$(core))))

# The core and the level whose figures the suite measures.
FEATURES_CORES  := $(call pick,8,m3 m0)
FEATURES_LEVELS := $(call pick,0,Os O2)

.PHONY: features test-features
features: $(call features_built,m3 m0,Os O2)
	@$(call features,m3 m0)

test-features: $(call features_built,$(FEATURES_CORES),$(FEATURES_LEVELS)) ## docs/features.md against what is measured, of a core and a level that a seed picks
	@echo "$(if $(EVERY),every core and level,TEST_SEED=$(TEST_SEED))"
	@$(call features,$(FEATURES_CORES)) --check $(subst $() $(),$(comma),$(FEATURES_LEVELS))
