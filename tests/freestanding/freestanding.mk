# SPDX-License-Identifier: MIT
# The library by itself, for every core: what it needs from outside, and what it must not contain. Objects are the boards';
# nothing of a board is in them.

# Built for size, that of the core which suite features takes.
FREESTANDING := $(foreach board,mps2-an385-m0 mps2-an385 mps2-an386-m4f,$(BUILD)/$(board)/O2) \
    $(foreach board,$(call pick,8,mps2-an385 mps2-an385-m0) $(if $(EVERY),mps2-an386-m4f),$(BUILD)/$(board)/Os)

test-freestanding: $(foreach folder,$(FREESTANDING),$(LIBRARY:%.c=$(folder)/%.o) $(folder)/tests/freestanding/planted.o) ## the library needs nothing and has no float, data or recursion, by levels that a seed picks
	@echo "$(if $(EVERY),every level,TEST_SEED=$(TEST_SEED))"
	@python3 tests/freestanding/freestanding.py --cross $(CROSS) $(FREESTANDING)
