# SPDX-License-Identifier: MIT
# Suites of firmware, in QEMU and in the Pico's emulator, against the same pictures drawn by the host.

QEMU       ?= qemu-system-arm
QEMU_RISCV ?= qemu-system-riscv32
export QEMU_RISCV

# The emulator of the Raspberry Pi Pico, and what drives the page's browser, are from npm: versions and checksums stand in
# package-lock.json.
export NODE_MODULES := $(abspath $(BUILD)/npm/pico/node_modules)
PICO_EMULATOR := $(BUILD)/npm/pico/installed
$(BUILD)/npm/%/installed: tests/%/package.json tests/%/package-lock.json
	@mkdir -p $(@D)
	$(Q)cp $^ $(@D)
	$(Q)cd $(@D) && npm ci --no-audit --no-fund --silent
	@touch $@

# $(call files,BOARD=FILE...): the files
files = $(foreach pair,$1,$(lastword $(subst =, ,$(pair))))

# Pictures of the host, and of panels that an emulator has not, by a model of the panel.
SHOW_HOST := $(BUILD)/tests/host/show
BY_HOST   := --host $(SHOW_HOST) --stream $(PANEL_STREAM)
HOST_SIDE := $(SHOW_HOST) $(PANEL_STREAM)

# ---- Panels

PANEL_PROGRAMS := pattern minimal turntable scenes
test-board-panel: $(BUILD)/tests/host/panel_host $(PANEL_PROGRAMS:%=$(BUILD)/lm3s6965evb/release/%.elf) ## the OLED against the host
	@python3 tests/board/panel.py --qemu $(QEMU) --output $(BUILD)/board --host $< \
	    $(foreach program,$(PANEL_PROGRAMS),--$(program) $(BUILD)/lm3s6965evb/release/$(program).elf)

SHOW_BOARDS   := lm3s6965evb lm3s811evb microbit stm32vldiscovery netduinoplus2 virt sifive_e mps2-an385 mps2-an385-m0 mps2-an386 mps2-an500 mps2-an505
SHOW_FIRMWARE := pico=$(BUILD)/pico/release/show.bin $(foreach board,$(SHOW_BOARDS),$(board)=$(BUILD)/$(board)/release/show.elf)
test-board-show: $(HOST_SIDE) $(PICO_EMULATOR) $(call files,$(SHOW_FIRMWARE)) ## each board's panel, as its bus drives it, against the host
	@python3 tests/board/show.py $(BY_HOST) --output $(BUILD)/show $(SHOW_FIRMWARE)

# The example scenes in motion, on panels in colour; all of it takes the Pico's emulator a minute, so that a test has a part.
ANIMATE_RUN      := mps2-an385 netduinoplus2 pico
ANIMATE_FIRMWARE := $(foreach board,$(COLOUR_BOARDS),$(board)=$(BUILD)/$(board)/O2/animate.$(if $(filter pico,$(board)),bin,elf))
ANIMATE_TESTED   := $(filter $(ANIMATE_RUN:%=%=%),$(ANIMATE_FIRMWARE))
test-board-animate: $(HOST_SIDE) $(PICO_EMULATOR) $(call files,$(ANIMATE_TESTED)) ## the example scenes in colour, on three boards, against the host
	@python3 tests/board/animate.py $(BY_HOST) --part --output $(BUILD)/animate-part $(ANIMATE_TESTED)

.PHONY: run test-board-animate-all
test-board-animate-all: $(HOST_SIDE) $(PICO_EMULATOR) $(call files,$(ANIMATE_FIRMWARE)) ## all of them on every board in colour: minutes
	@python3 tests/board/animate.py $(BY_HOST) --output $(BUILD)/animate $(ANIMATE_FIRMWARE)

$(RUN_MODEL): $(HOST_PROGRAM) $(if $(filter-out %.obj,$(firstword $(MODEL))),$(IMPORT_PROGRAM))
	@mkdir -p $(@D)
	$(Q)$(HOST_PROGRAM) convert --centre --scale fit $(MODEL) --name model -o $@ > $(@:.h=.txt)

# $(call or_say,condition,sentence)
or_say = @$1 || { echo "$2" >&2; exit 1; }
# An emulator takes the ELF file or, that of the Pico, the plain one; a programmer or a boot loader the others.
RUN_FILES = $(addprefix $(RUN)/run.,elf hex $(if $(filter pico,$(BOARD)),bin uf2))
FRAMES   ?= 4
# On Arm's cores in QEMU a plugin counts.
RUN_COUNTED = $(if $(filter cortex-m%,$(RUN_CPU)),$(if $(filter pico,$(BOARD)),,$(CYCLES_PLUGIN)))
RUN_CPU     = $(patsubst -mcpu=%,%,$(filter -mcpu=%,$(call of,$(BOARD),CPU)))
run: ## build MODEL=my.obj, or PROGRAM=main.c (or show, animate), for BOARD=pico, run it, and write what the panel shows to build/run
	$(call or_say,test -n "$(RUN)",there is no board '$(BOARD)': BOARD is one of $(BOARDS))
	$(call or_say,command -v $(call cross,$(BOARD))gcc > /dev/null,the compiler $(call cross,$(BOARD))gcc is missing: tools/setup.sh installs it)
	$(call or_say,command -v $(if $(filter pico,$(BOARD)),npm,true) > /dev/null,npm is missing; the Pico's emulator comes by it: tools/setup.sh installs npm)
	$(call or_say,ls $(PROGRAM_run) > /dev/null 2>&1,there is no program '$(PROGRAM)': PROGRAM is a C file or show or animate)
	@$(MAKE) --no-print-directory $(if $(V),,-s) $(RUN_FILES) $(PANEL_STREAM) $(RUN_COUNTED) $(if $(filter pico,$(BOARD)),$(PICO_EMULATOR))
	@python3 tests/board/run.py --stream $(PANEL_STREAM) --output $(BUILD)/run/$(BOARD) $(RUN_COUNTED:%=--plugin % --cpu $(RUN_CPU)) \
	    $(if $(PROGRAM_$(PROGRAM):$(PROGRAM_model)=),,--frames $(FRAMES)) $(BOARD) $(RUN_FILES)

# A board that the seed picks; its objects are there before another make builds the program.
RUN_TESTED := $(call pick,5,$(SHOW_BOARDS) pico)
run_parts   = $(call objects,$1,$(call board_sources,$(call board,$(1:$(BUILD)/%=%)))) $1/libglint.a
# Programs that the web page exports run on these.
test-web: $(foreach board,mps2-an385 lm3s6965evb,$(call run_parts,$(call run_folder,$(board))))
test-board-run: $(HOST_PROGRAM) $(PANEL_STREAM) $(PICO_EMULATOR) $(foreach board,$(RUN_TESTED) template,$(call run_parts,$(call run_folder,$(board)))) ## make run: a model and a program of one's own on a board that a seed picks, against glint render; what it says
	$(call sample,board)
	@for board in $(RUN_TESTED); do python3 tests/board/run_test.py --host $(HOST_PROGRAM) --build $(BUILD) $$board || exit 1; done

test-board-compose: $(HOST_SIDE) $(BUILD)/mps2-an385/O2/compose.elf ## a user interface with 3D in it, on a board, against the host
	@python3 tests/board/compose.py $(BY_HOST) --output $(BUILD)/compose mps2-an385=$(BUILD)/mps2-an385/O2/compose.elf

test-board-moving: $(HOST_SIDE) $(BUILD)/mps2-an385/O2/moving.elf ## meshes that change each frame, on a board, against the host
	@python3 tests/board/moving.py $(BY_HOST) --output $(BUILD)/moving mps2-an385=$(BUILD)/mps2-an385/O2/moving.elf

test-board-own-flush: $(HOST_PROGRAM) $(PANEL_STREAM) $(BUILD)/mps2-an385/O2/own_flush.elf ## the README's program on a board, against glint render
	@python3 tests/board/own_flush.py --host $(HOST_PROGRAM) --stream $(PANEL_STREAM) --output $(BUILD)/own_flush mps2-an385=$(BUILD)/mps2-an385/O2/own_flush.elf

# ---- Faults of a bus, on the board itself; a board whose power is cut at any instruction

FAULT_FIRMWARE := $(foreach board,$(FAULT_BOARDS),$(board)=$(BUILD)/$(board)/release/faults-$(board).$(if $(filter pico,$(board)),bin,elf))
test-board-faults: $(HOST_SIDE) $(PICO_EMULATOR) $(call files,$(FAULT_FIRMWARE)) ## on boards: a bus that stops, is slow, fails; a reset in mid-frame
	@python3 tests/board/faults.py $(BY_HOST) --output $(BUILD)/faults $(FAULT_FIRMWARE)

# As many cuts within each part of what the firmware does, half of them with the panel's reset line. Tables that frames keep
# in the arena are not of a library built for size.
POWER_CUTS ?= 14
POWER_SEED ?= 1
test-board-power: $(BUILD)/mps2-an385/O2/power_cut.elf $(HOST_SIDE) ## a board whose power is cut POWER_CUTS times, anywhere: the next frame is whole; POWER_SEED chooses where
	@python3 tests/board/power_cut.py --qemu $(QEMU) --nm $(CROSS)nm $(BY_HOST) --output $(BUILD)/power --cuts $(POWER_CUTS) --seed $(POWER_SEED) $<

# ---- Unit tests on boards; what a board leaves out it says by name

# Of two boards of one core, which link one library, one.
UNIT_M3   := lm3s6965evb mps2-an385
UNIT_M4   := netduinoplus2 mps2-an386
UNIT_LEFT := $(filter-out $(call pick,3,$(UNIT_M3)),$(UNIT_M3)) $(filter-out $(call pick,4,$(UNIT_M4)),$(UNIT_M4))
UNIT_WHOLE := $(foreach board,$(filter-out $(UNIT_LEFT),$(UNIT_BOARDS)),$(board)=$(BUILD)/$(board)/release/unit.elf)
UNIT_PART  := $(foreach board,$(UNIT_8K_BOARDS),$(board)=$(BUILD)/$(board)/release/unit-8k.elf) pico=$(BUILD)/pico/release/unit-pico.bin
test-board-unit: $(PICO_EMULATOR) $(call files,$(UNIT_WHOLE) $(UNIT_PART)) ## unit tests on boards of every core
	$(call sample,board)
	@python3 tests/board/unit.py --qemu $(QEMU) --cases tests/unit/unit.h --part $(UNIT_PART) --whole $(UNIT_WHOLE)

# ---- The same frames on every core, compiler and optimisation: of each core what is built for speed, and one of all that
# ---- is not. Boards that have room for a part draw a part.

IDENTITY_ELF    := $(filter %/identity.elf,$(FIRMWARE))
IDENTITY_TESTED := $(filter %/O2/identity.elf,$(IDENTITY_ELF)) $(call pick,1,$(filter-out %/O2/identity.elf,$(IDENTITY_ELF)))
IDENTITY_PART   := sifive_e=$(BUILD)/sifive_e/release/identity-16k.elf lm3s811evb=$(BUILD)/lm3s811evb/release/identity-8k.elf
test-board-identity: $(IDENTITY_TESTED) $(call files,$(IDENTITY_PART)) $(IDENTITY_HOST) ## the same bits from every core, by compilers and levels that a seed picks; small boards draw a part
	$(call sample,variant)
	@python3 tests/board/identity.py --qemu $(QEMU) --host $(IDENTITY_HOST) \
	    --firmware $(foreach elf,$(IDENTITY_TESTED),$(or $(if $(findstring /virt/,$(elf)),virt),$(if $(findstring /xtensa/,$(elf)),sim),mps2-an385)=$(elf)) --part $(IDENTITY_PART)

# ---- What firmware takes: bytes of flash, RAM and library that the turntable, everything included, may take of lm3s6965evb;
# ---- its stack; RAM that is too small. Firmware of which no suite runs all is sampled.

FLASH_MOST    := 92160
RAM_MOST      := 32768
LIBRARY_MOST  := 51200
ANIMATE_OTHER := $(patsubst %,$(BUILD)/%/O2/animate.elf,$(filter-out $(ANIMATE_RUN),$(COLOUR_BOARDS)))
TESTED_FIRMWARE := $(filter-out $(filter-out $(IDENTITY_TESTED),$(IDENTITY_ELF)) $(UNIT_LEFT:%=$(BUILD)/%/release/unit.elf) \
    $(filter-out $(call pick,2,$(ANIMATE_OTHER)),$(ANIMATE_OTHER)),$(FIRMWARE))
test-firmware: $(TESTED_FIRMWARE) ## flash, RAM and library within their limits
	@echo "$(if $(EVERY),all firmware,TEST_SEED=$(TEST_SEED))"
	@python3 tests/board/firmware.py --flash $(FLASH_MOST) --ram $(RAM_MOST) --library $(LIBRARY_MOST) \
	    $(BUILD)/lm3s6965evb/release/turntable.map --programs $(TESTED_FIRMWARE) --examples examples/firmware/minimal.c examples/firmware/own_flush.c

# What people flash, and what is measured; tests take what stack they like. The stack of planted programs must be refused.
STACK_PROGRAMS := $(filter-out %/identity.elf %/identity-16k.elf %/identity-8k.elf %/methods.elf %/unit.elf %/unit-pico.elf \
    %/unit-8k.elf %/faults-pico.elf %/faults-lm3s6965evb.elf %/power_cut.elf,$(TESTED_FIRMWARE))
STACK_PLANTED  := RECURSION UNBOUNDED UNLISTED DEEP
$(BUILD)/stack/%/planted.elf: tests/stack/startup.c
	@mkdir -p $(@D)
	$(Q)cd $(@D) && $(CROSS)gcc -mcpu=cortex-m0 -mthumb -g -Os -ffreestanding -fstack-usage -nostdlib -DPLANTED=$* \
	    -Wl,-e,reset,-Ttext=0 $(abspath $<) -lgcc -o planted.elf
	@echo 'planted: flash 0 (library 0), RAM 0 (stack 1024)' > $(@:.elf=.size)
# The stack of public functions is painted, on both cores and built for size and for speed.
PAINTED_CSV := $(BUILD)/stack/painted.csv
$(PAINTED_CSV): $(PAINTED:%=$(BUILD)/%.elf) tests/stack/painted.py
	@mkdir -p $(@D)
	@python3 tests/stack/painted.py --qemu $(QEMU) --csv $@.new "M0 -Os=$(BUILD)/mps2-an385-m0/Os/painted.elf" "M0 -O2=$(BUILD)/mps2-an385-m0/O2/painted.elf" \
	    "M3 -Os=$(BUILD)/mps2-an385/Os/painted.elf" "M3 -O2=$(BUILD)/mps2-an385/O2/painted.elf"
	@mv $@.new $@

test-stack: $(STACK_PROGRAMS) $(PAINTED_CSV) $(patsubst %,$(BUILD)/stack/%/planted.elf,NOTHING $(STACK_PLANTED)) ## the deepest chain of calls of every firmware against the stack it has; that of public functions, painted
	@tools/stack/stack.py $(STACK_PROGRAMS)
	@tools/stack/stack.py --targets tests/stack/targets.csv $(BUILD)/stack/NOTHING/planted.elf
	@good=0; for planted in $(STACK_PLANTED); do \
	    tools/stack/stack.py --targets tests/stack/targets.csv $(BUILD)/stack/$$planted/planted.elf > $(BUILD)/stack/$$planted/log; \
	    if [ $$? -eq 1 ] && grep -q FAILED $(BUILD)/stack/$$planted/log; then good=$$((good + 1)); \
	    else echo "$$planted was not refused:"; cat $(BUILD)/stack/$$planted/log; fi; done; \
	    echo "$$good passed, $$(( $(words $(STACK_PLANTED)) - good )) failed"; [ $$good -eq $(words $(STACK_PLANTED)) ]

# $(call small_ram,board): links the board's firmware with less RAM than it takes
small_ram = python3 tests/board/small_ram.py $(call linker,$1) $(BUILD)/$1/release/show.size $(BUILD)/small/$1 \
    $(call board_gcc,$1) $(FIRMWARE_LDFLAGS) -Wl,-Map=$(BUILD)/small/$1/small.map \
    $(call objects,$(BUILD)/$1/release,$(call firmware_sources,$1/release/show)) $(BUILD)/$1/release/libglint.a -lgcc
test-small-ram: $(BOARDS:%=$(BUILD)/%/release/show.elf) ## a board with too little RAM: the link fails with the bytes missing
	@failed=0; mkdir -p $(BUILD)/small; $(foreach board,$(BOARDS),mkdir -p $(BUILD)/small/$(board); $(call small_ram,$(board)) || failed=$$((failed + 1));) \
	    echo "$$(($(words $(BOARDS)) - failed)) passed, $$failed failed"; [ $$failed -eq 0 ]

# ---- The library by itself, for every core: what it needs from outside, and what it must not contain. Built for size, that
# ---- of the core which suite features takes.

FREESTANDING := $(foreach board,mps2-an385-m0 mps2-an385 mps2-an386-m4f,$(BUILD)/$(board)/O2) \
    $(foreach board,$(call pick,8,mps2-an385 mps2-an385-m0) $(if $(EVERY),mps2-an386-m4f),$(BUILD)/$(board)/Os)
test-freestanding: $(foreach folder,$(FREESTANDING),$(call objects,$(folder),$(LIBRARY) tests/freestanding/planted.c)) ## the library needs nothing and has no float, data or recursion, by levels that a seed picks
	$(call sample,level)
	@python3 tests/freestanding/freestanding.py --cross $(CROSS) $(FREESTANDING)
