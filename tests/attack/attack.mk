# SPDX-License-Identifier: MIT
# Attacks on the library: extreme arguments between forbidden pages, arenas of every size, bits that flip.

ATTACK_SEED  ?= 1
ATTACK_CALLS ?= 1000000
# Under the sanitisers each takes several times as long.
ATTACK_CALLS_SANITIZED ?= 200000

ATTACK_SCENES := $(addprefix tests/fuzz/,any_scene.c usual_scene.c layouts.c drawing.c) \
    $(addprefix port/host/,cluster.c patch.c memory.c)
ATTACK_SOURCES := $(addprefix tests/attack/,attack.c victim.c stage.c pages.c) $(ATTACK_SCENES)
$(foreach variant,host sanitize,$(eval $(call test_program,$(BUILD)/tests/$(variant)/attack,$(variant),$(ATTACK_SOURCES))))
$(foreach variant,host sanitize,$(eval $(call test_program,$(BUILD)/tests/$(variant)/attack_arenas,$(variant),tests/attack/arenas.c tests/attack/pages.c)))
ATTACK := $(BUILD)/tests/host/attack
ATTACK_SANITIZED := $(BUILD)/tests/sanitize/attack

ATTACK_ARENAS := $(BUILD)/tests/host/attack_arenas
ATTACK_ARENAS_SANITIZED := $(BUILD)/tests/sanitize/attack_arenas

# A report of a sanitiser tells in which call it is.
attack attack-arenas test-attack: export ASAN_OPTIONS := abort_on_error=1
attack attack-arenas test-attack: export UBSAN_OPTIONS := abort_on_error=1

# The first round held a clipped triangle of one vertex three times, with its normal in a layout: it was read beyond the end.
SUITES += test-attack
.PHONY: attack attack-arenas test-attack
test-attack: $(ATTACK) $(ATTACK_SANITIZED) $(ATTACK_ARENAS) $(ATTACK_ARENAS_SANITIZED) ## extreme arguments, between pages that must not be touched
	@$(ATTACK) 1 60000 24372
	@$(ATTACK) 2 12000 > $(ATTACK).log; status=$$?; cat $(ATTACK).log; exit $$status
	@$(ATTACK_SANITIZED) 2 12000 > $(ATTACK_SANITIZED).log; status=$$?; cat $(ATTACK_SANITIZED).log; exit $$status
	@cmp $(ATTACK).log $(ATTACK_SANITIZED).log || { echo "two compilers, other calls or other answers"; exit 1; }
	@$(ATTACK_ARENAS) 97
	@$(ATTACK_ARENAS_SANITIZED) 1009

attack-arenas: $(ATTACK_ARENAS) $(ATTACK_ARENAS_SANITIZED) ## arenas of every size, at both ends of pages that must not be touched: minutes
	@$(ATTACK_ARENAS) 1
	@$(ATTACK_ARENAS_SANITIZED) 13

attack: $(ATTACK) $(ATTACK_SANITIZED) ## a million calls with extreme arguments; ATTACK_SEED chooses which
	@$(ATTACK) $(ATTACK_SEED) $(ATTACK_CALLS)
	@$(ATTACK_SANITIZED) $(ATTACK_SEED) $(ATTACK_CALLS_SANITIZED)
