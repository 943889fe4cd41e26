# SPDX-License-Identifier: MIT
# Worst-case stack of every firmware, and programs whose stack must be refused.

# What people flash, and what is measured; tests take what stack they like.
STACK_PROGRAMS = $(filter-out %/identity.elf %/identity-16k.elf %/identity-8k.elf %/methods.elf %/unit.elf %/unit-pico.elf %/unit-8k.elf %/faults-pico.elf \
    %/faults-lm3s6965evb.elf %/power_cut.elf $(FIRMWARE_LEFT),$(FIRMWARE))
STACK_PLANTED := NOTHING RECURSION UNBOUNDED UNLISTED DEEP
STACK         := python3 tools/stack/stack.py

$(BUILD)/stack/%/planted.elf: tests/stack/startup.c
	@mkdir -p $(@D)
	$(Q)cd $(@D) && $(CROSS)gcc -mcpu=cortex-m0 -mthumb -g -Os -ffreestanding -fstack-usage -nostdlib -DPLANTED=$* \
	    -Wl,-e,reset,-Ttext=0 $(abspath $<) -lgcc -o planted.elf
	@echo 'planted: flash 0 (library 0), RAM 0 (stack 1024)' > $(@:.elf=.size)

SUITES += test-stack
.PHONY: test-stack
test-stack: $$(STACK_PROGRAMS) $(STACK_PLANTED:%=$(BUILD)/stack/%/planted.elf) ## the deepest chain of calls of every firmware against the stack it has
	@$(STACK) $(STACK_PROGRAMS)
	@$(STACK) --targets tests/stack/targets.csv $(BUILD)/stack/NOTHING/planted.elf
	@good=0; for planted in $(filter-out NOTHING,$(STACK_PLANTED)); do \
	    $(STACK) --targets tests/stack/targets.csv $(BUILD)/stack/$$planted/planted.elf > $(BUILD)/stack/$$planted/log; \
	    if [ $$? -eq 1 ] && grep -q FAILED $(BUILD)/stack/$$planted/log; then good=$$((good + 1)); \
	    else echo "$$planted was not refused:"; cat $(BUILD)/stack/$$planted/log; fi; done; \
	    echo "$$good passed, $$(( $(words $(filter-out NOTHING,$(STACK_PLANTED))) - good )) failed"; \
	    [ $$good -eq $(words $(filter-out NOTHING,$(STACK_PLANTED))) ]
