# SPDX-License-Identifier: MIT
# Suites that run firmware in QEMU; included by port/boards.mk.

QEMU       ?= qemu-system-arm
QEMU_RISCV ?= qemu-system-riscv32
export QEMU_RISCV

# ---- What the panel shows is what the host draws

# What the example scenes are made of.
EXAMPLE_SCENES := $(wildcard examples/scenes/*.c)
EXAMPLE_DATA   := $(wildcard examples/turntable/* examples/scenes/*.h examples/meshes/*.h)

PANEL_HOST := $(BUILD)/host/panel
$(PANEL_HOST): tests/board/panel_host.c tests/board/frames.c tests/board/frames.h examples/firmware/shown.c \
        examples/firmware/shown.h $(EXAMPLE_SCENES) $(EXAMPLE_DATA) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Itests $(filter %.c,$^) $(BUILD)/host/libglint.a -o $@

PANEL_PROGRAMS := pattern minimal turntable scenes
test-board-panel: $(PANEL_HOST) $(PANEL_PROGRAMS:%=$(BUILD)/lm3s6965evb/release/%.elf) ## the OLED against the host
	@python3 tests/board/panel.py --qemu $(QEMU) --output $(BUILD)/board --host $(PANEL_HOST) \
	    $(foreach program,$(PANEL_PROGRAMS),--$(program) $(BUILD)/lm3s6965evb/release/$(program).elf)

# ---- The unit tests on boards; what a board leaves out it says by name

# Of two boards of one core, which link one library, one.
UNIT_M3   := lm3s6965evb mps2-an385
UNIT_M4   := netduinoplus2 mps2-an386
UNIT_LEFT := $(filter-out $(call pick,3,$(UNIT_M3)),$(UNIT_M3)) $(filter-out $(call pick,4,$(UNIT_M4)),$(UNIT_M4))

UNIT_FIRMWARE := $(foreach board,$(filter-out $(UNIT_LEFT),$(UNIT_BOARDS)),$(board)=$(BUILD)/$(board)/release/unit.elf)
UNIT_PART     := $(foreach board,$(UNIT_8K_BOARDS),$(board)=$(BUILD)/$(board)/release/unit-8k.elf) pico=$(BUILD)/pico/release/unit-pico.bin
test-board-unit: $(BUILD)/pico/emulator/installed \
        $(foreach pair,$(UNIT_FIRMWARE) $(UNIT_PART),$(lastword $(subst =, ,$(pair)))) ## unit tests on boards of every core
	@echo "$(if $(EVERY),every board,TEST_SEED=$(TEST_SEED))"
	@python3 tests/board/unit.py --qemu $(QEMU) --cases tests/unit/unit.h --part $(UNIT_PART) --whole $(UNIT_FIRMWARE)

# ---- The same frames on every core, compiler and optimisation

IDENTITY_LEVELS := O0 Os O2
IDENTITY_CORES  := mps2-an385 mps2-an385-m0 virt
IDENTITY_ELF    := $(foreach core,$(IDENTITY_CORES),$(foreach level,$(IDENTITY_LEVELS),$(BUILD)/$(core)/$(level)/identity.elf))
# Boards that have room for a part: MACHINE=ELF.
IDENTITY_PART   := sifive_e=$(BUILD)/sifive_e/release/identity-16k.elf lm3s811evb=$(BUILD)/lm3s811evb/release/identity-8k.elf
IDENTITY_VARIANTS := $(MATRIX) sanitize threads
IDENTITY_HOST   := $(patsubst %,$(BUILD)/identity/%,$(MATRIX_TESTED) sanitize threads)
# Of each core what is built for speed, and one of all that is not.
IDENTITY_TESTED := $(filter %/O2/identity.elf,$(IDENTITY_ELF)) $(call pick,1,$(filter-out %/O2/identity.elf,$(IDENTITY_ELF)))
IDENTITY_LEFT   := $(filter-out $(IDENTITY_TESTED),$(IDENTITY_ELF))
IDENTITY_SOURCES := tests/board/identity_host.c tests/board/identity.c tests/board/frames.c \
    examples/turntable/turntable.c $(EXAMPLE_SCENES)
$(foreach variant,$(IDENTITY_VARIANTS),\
    $(eval $(call test_program,$(BUILD)/identity/$(variant),$(variant),$(IDENTITY_SOURCES))))

test-board-identity: $(IDENTITY_TESTED) $(foreach pair,$(IDENTITY_PART),$(lastword $(subst =, ,$(pair)))) $(IDENTITY_HOST) ## the same bits from every core, by compilers and levels that a seed picks; small boards draw a part
	@echo "$(if $(EVERY),every variant,TEST_SEED=$(TEST_SEED))"
	@python3 tests/board/identity.py --qemu $(QEMU) --host $(IDENTITY_HOST) \
	    --firmware $(foreach elf,$(IDENTITY_TESTED),$(if $(findstring /virt/,$(elf)),virt,mps2-an385)=$(elf)) --part $(IDENTITY_PART)

# ---- What firmware may take, and that what is there to copy compiles

# Bytes that the turntable, everything included, may take of lm3s6965evb.
FLASH_MOST   := 92160
RAM_MOST     := 32768
LIBRARY_MOST := 51200

# Of the colour boards whose animation no other suite takes, one.
ANIMATE_RUN   := mps2-an385 netduinoplus2 pico
ANIMATE_OTHER := $(patsubst %,$(BUILD)/%/O2/animate.elf,$(filter-out $(ANIMATE_RUN),$(COLOUR_BOARDS)))
FIRMWARE_LEFT := $(IDENTITY_LEFT) $(UNIT_LEFT:%=$(BUILD)/%/release/unit.elf) $(filter-out $(call pick,2,$(ANIMATE_OTHER)),$(ANIMATE_OTHER))

# Files that are read later add firmware too.
.SECONDEXPANSION:
test-firmware: $$(filter-out $$(FIRMWARE_LEFT),$$(FIRMWARE)) ## flash, RAM and library within their limits
	@echo "$(if $(EVERY),all firmware,TEST_SEED=$(TEST_SEED))"
	@python3 tests/board/firmware.py --flash $(FLASH_MOST) --ram $(RAM_MOST) --library $(LIBRARY_MOST) \
	    $(BUILD)/lm3s6965evb/release/turntable.map --programs $(filter-out $(FIRMWARE_LEFT),$(FIRMWARE)) --examples examples/firmware/minimal.c examples/firmware/own_flush.c

# ---- The panel driver on a bus that records and fails

$(BUILD)/host/bus: tests/board/bus.c tests/harness.c tests/main.c tests/harness.h $(lm3s6965evb_PANEL) \
        $(wildcard port/panel/*.h) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport -Itests $(filter %.c,$^) $(BUILD)/host/libglint.a -o $@

$(BUILD)/host/stm32_spi: tests/board/stm32_spi.c port/stm32/spi.c port/stm32/spi.h tests/harness.c tests/main.c tests/harness.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport -Itests $(filter %.c,$^) -o $@

# Its registers are those of a port whose time passes with each look at them.
$(BUILD)/host/stm32_slow: tests/board/stm32_slow.c tests/board/slow/cortex-m/cortex-m.h port/stm32/spi.c port/stm32/spi.h tests/harness.c tests/main.c tests/harness.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Itests/board/slow -Iport -Itests $(filter %.c,$^) -o $@

test-panel-bus: $(BUILD)/host/bus $(BUILD)/host/stm32_spi $(BUILD)/host/stm32_slow ## what the panel driver sends, and what it does when the bus fails
	$(call run_suites,$^)

# ---- What the panels of boards without one in their emulator show, by a model of the panel

SHOW_HOST := $(BUILD)/host/show
$(SHOW_HOST): tests/board/show_host.c tests/image/picture.c examples/turntable/turntable.c tests/image/picture.h \
        examples/firmware/animation.c examples/firmware/animation.h $(wildcard examples/compose/*.c) examples/moving/moving.c \
        $(wildcard examples/compose/*.h examples/moving/*.h) $(EXAMPLE_SCENES) $(EXAMPLE_DATA) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Itests/image $(filter %.c,$^) $(BUILD)/host/libglint.a -o $@

SHOW_BOARDS   := lm3s6965evb lm3s811evb microbit stm32vldiscovery netduinoplus2 virt sifive_e mps2-an385 mps2-an385-m0 mps2-an386 mps2-an500 mps2-an505
SHOW_FIRMWARE := pico=$(BUILD)/pico/release/show.bin $(foreach board,$(SHOW_BOARDS),$(board)=$(BUILD)/$(board)/release/show.elf)
# The example scenes in motion, on panels in colour; all of it takes the Pico's emulator a minute, so that a test has a part.
ANIMATE_FIRMWARE := $(foreach board,$(COLOUR_BOARDS),$(board)=$(BUILD)/$(board)/O2/animate.$(if $(filter pico,$(board)),bin,elf))
ANIMATE_TESTED   := $(filter $(ANIMATE_RUN:%=%=%),$(ANIMATE_FIRMWARE))
ANIMATE := python3 tests/board/animate.py --host $(SHOW_HOST) --stream $(BUILD)/host/panel_stream

SUITES += test-board-show test-board-animate test-board-compose test-board-moving test-board-own-flush
.PHONY: test-board-show test-board-animate test-board-compose test-board-moving test-board-own-flush test-board-animate-all run
PROGRAM ?= show
RUN_FIRMWARE = $(if $(filter animate,$(PROGRAM)),$(ANIMATE_FIRMWARE),$(SHOW_FIRMWARE))
run: $(SHOW_HOST) $(BUILD)/host/panel_stream $(BUILD)/pico/emulator/installed $$(lastword $$(subst =, ,$$(filter $$(BOARD)=%,$$(RUN_FIRMWARE)))) ## run one board, BOARD=pico PROGRAM=show (or animate) say, and write what its panel shows to build/run
	@test -n "$(filter $(BOARD)=%,$(RUN_FIRMWARE))" || { echo "BOARD must be one of: $(foreach pair,$(RUN_FIRMWARE),$(firstword $(subst =, ,$(pair))))"; exit 1; }
	@python3 tests/board/$(PROGRAM).py --host $(SHOW_HOST) --stream $(BUILD)/host/panel_stream --output $(BUILD)/run $(filter $(BOARD)=%,$(RUN_FIRMWARE))
	@ls $(BUILD)/run/$(BOARD)/*.png

test-board-animate: $(SHOW_HOST) $(BUILD)/host/panel_stream $(BUILD)/pico/emulator/installed \
        $(foreach pair,$(ANIMATE_TESTED),$(lastword $(subst =, ,$(pair)))) ## the example scenes in colour, on three boards, against the host
	@$(ANIMATE) --part --output $(BUILD)/animate-part $(ANIMATE_TESTED)

test-board-animate-all: $(SHOW_HOST) $(BUILD)/host/panel_stream $(BUILD)/pico/emulator/installed \
        $(foreach pair,$(ANIMATE_FIRMWARE),$(lastword $(subst =, ,$(pair)))) ## all of them on every board in colour: minutes
	@$(ANIMATE) --output $(BUILD)/animate $(ANIMATE_FIRMWARE)

test-board-compose: $(SHOW_HOST) $(BUILD)/host/panel_stream $(BUILD)/mps2-an385/O2/compose.elf ## a user interface with 3D in it, on a board, against the host
	@python3 tests/board/compose.py --host $(SHOW_HOST) --stream $(BUILD)/host/panel_stream --output $(BUILD)/compose mps2-an385=$(BUILD)/mps2-an385/O2/compose.elf

test-board-moving: $(SHOW_HOST) $(BUILD)/host/panel_stream $(BUILD)/mps2-an385/O2/moving.elf ## meshes that change each frame, on a board, against the host
	@python3 tests/board/moving.py --host $(SHOW_HOST) --stream $(BUILD)/host/panel_stream --output $(BUILD)/moving mps2-an385=$(BUILD)/mps2-an385/O2/moving.elf

test-board-own-flush: $(HOST_PROGRAM) $(BUILD)/host/panel_stream $(BUILD)/mps2-an385/O2/own_flush.elf ## the README's program on a board, against glint render
	@python3 tests/board/own_flush.py --host $(HOST_PROGRAM) --stream $(BUILD)/host/panel_stream --output $(BUILD)/own_flush mps2-an385=$(BUILD)/mps2-an385/O2/own_flush.elf

test-board-show: $(SHOW_HOST) $(BUILD)/host/panel_stream $(BUILD)/pico/emulator/installed \
        $(foreach pair,$(SHOW_FIRMWARE),$(lastword $(subst =, ,$(pair)))) ## each board's panel, as its bus drives it, against the host
	@python3 tests/board/show.py --host $(SHOW_HOST) --stream $(BUILD)/host/panel_stream --output $(BUILD)/show $(SHOW_FIRMWARE)

# ---- Faults: what breaks on a bus, on the board itself

FAULT_FIRMWARE := $(foreach board,$(FAULT_BOARDS),$(board)=$(BUILD)/$(board)/release/faults-$(board).$(if $(filter pico,$(board)),bin,elf))
SUITES += test-board-faults
.PHONY: test-board-faults
test-board-faults: $(SHOW_HOST) $(BUILD)/host/panel_stream $(BUILD)/pico/emulator/installed \
        $(foreach pair,$(FAULT_FIRMWARE),$(lastword $(subst =, ,$(pair)))) ## on boards: a bus that stops, is slow, fails; a reset in mid-frame
	@python3 tests/board/faults.py --host $(SHOW_HOST) --stream $(BUILD)/host/panel_stream --output $(BUILD)/faults $(FAULT_FIRMWARE)

# ---- RAM that is too small is told at the link, with what is missing

# $(call small_ram,board): links the board's firmware with less RAM than it takes
small_ram = python3 tests/board/small_ram.py $($1_LINKER) $(BUILD)/$1/release/show.size $(BUILD)/small/$1 \
    $(call cross,$1)gcc $($1_CPU) $(FIRMWARE_LDFLAGS) -Wl,-Map=$(BUILD)/small/$1/small.map \
    $(patsubst %.c,$(BUILD)/$1/release/%.o,$(PROGRAM_show) $($1_SOURCES) $($1_PANEL)) $(BUILD)/$1/release/libglint.a -lgcc

SUITES += test-small-ram
.PHONY: test-small-ram
test-small-ram: $(BOARDS:%=$(BUILD)/%/release/show.elf) ## a board with too little RAM: the link fails with the bytes missing
	@failed=0; mkdir -p $(BUILD)/small; $(foreach board,$(BOARDS),mkdir -p $(BUILD)/small/$(board); $(call small_ram,$(board)) || failed=$$((failed + 1));) \
	    echo "$$(($(words $(BOARDS)) - failed)) passed, $$failed failed"; [ $$failed -eq 0 ]
