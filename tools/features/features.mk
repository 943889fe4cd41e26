# SPDX-License-Identifier: MIT
# What each feature costs; included by port/boards.mk.

# $(call features_core,core,board): compiles and links; {level} stands for the level of optimisation
features_core = "$1=$(CROSS)gcc $($2_CPU) $(FIRMWARE_CFLAGS) -{level} $(FIRMWARE_LDFLAGS) -T $($2_LINKER) \
    tools/features/feature.c $(patsubst %.c,$(BUILD)/$2/Os/%.o,$($2_SOURCES)) $(BUILD)/$2/{level}/libglint.a -lgcc"

FEATURES_BUILT := $(BUILD)/bench/bench_scenes.h $(foreach board,mps2-an385 mps2-an385-m0,\
    $(patsubst %.c,$(BUILD)/$(board)/Os/%.o,$($(board)_SOURCES)) \
    $(BUILD)/$(board)/Os/libglint.a $(BUILD)/$(board)/O2/libglint.a)

FEATURES = python3 tools/features/features.py --qemu $(QEMU) --output $(BUILD) --page docs/features.md \
    $(call features_core,m3,mps2-an385) $(call features_core,m0,mps2-an385-m0)

# Levels whose figures the suite measures.
FEATURES_LEVELS := $(if $(EVERY),Os$(comma)O2,$(call pick,0,Os O2))

.PHONY: features test-features
features: $(FEATURES_BUILT) ## measure what each feature costs, and write it into docs/features.md
	@$(FEATURES)

test-features: $(FEATURES_BUILT) ## docs/features.md against what is measured, of one level that a seed picks
	@echo "$(if $(EVERY),every level,TEST_SEED=$(TEST_SEED))"
	@$(FEATURES) --check $(FEATURES_LEVELS)
