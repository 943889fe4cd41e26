# SPDX-License-Identifier: MIT
# The library by itself, for every core: what it needs from outside, and what it must not contain. Objects are the boards';
# nothing of a board is in them.

FREESTANDING := $(foreach board,mps2-an385-m0 mps2-an385,$(foreach level,Os O2,$(BUILD)/$(board)/$(level))) \
    $(addprefix $(BUILD)/mps2-an386-m4f/,$(if $(EVERY),Os) O2)

test-freestanding: $(foreach folder,$(FREESTANDING),$(LIBRARY:%.c=$(folder)/%.o) $(folder)/tests/freestanding/planted.o) ## the library needs nothing and has no float, data or recursion
	@python3 tests/freestanding/freestanding.py --cross $(CROSS) $(FREESTANDING)
