# SPDX-License-Identifier: MIT
# Firmware for every board, from one pattern. A board is the few lines below; a program is its sources.
# build/<board>/<level>/<program>.elf, with what it takes of flash, RAM and stack beside it in <program>.size.

CROSS ?= arm-none-eabi-

# ---- Boards: core flags, sources of the port, linker script, sources of the driver for its panel, bytes of arena that it
# ---- can spare (ARENA), width and height of its tiles where not the default (TILE; one number for both), what an ELF file
# ---- needs before it is whole (FINISH), and the prefix of its compiler's commands where that is not Arm's

BOARDS := lm3s6965evb lm3s811evb microbit stm32vldiscovery netduinoplus2 mps2-an385 mps2-an385-m0 mps2-an386 mps2-an500 mps2-an505 virt sifive_e pico template

CORTEX_M := $(wildcard port/cortex-m/*.c) port/semihosting/semihosting.c port/libc/memory.c
RISCV    := port/riscv/startup.c port/semihosting/semihosting.c port/libc/memory.c

lm3s6965evb_CPU     := -mcpu=cortex-m3 -mthumb
lm3s6965evb_SOURCES := $(CORTEX_M) $(wildcard port/lm3s6965evb/*.c) port/lm3s/clock.c port/pl022/pl022.c
lm3s6965evb_LINKER  := linker/lm3s6965evb.ld
lm3s6965evb_PANEL   := port/panel/panel.c port/panel/solomon.c port/panel/ssd0323.c
lm3s6965evb_ARENA   := 49152

# 8 KB of RAM, 64 KB of flash: tiles of one page.
lm3s811evb_CPU     := -mcpu=cortex-m3 -mthumb
lm3s811evb_SOURCES := $(CORTEX_M) $(wildcard port/lm3s811evb/*.c) port/lm3s/clock.c
lm3s811evb_LINKER  := linker/lm3s811evb.ld
lm3s811evb_PANEL   := port/panel/panel.c port/panel/pages.c port/panel/ssd0303.c port/panel/i2c.c
lm3s811evb_ARENA   := 4624
lm3s811evb_TILE    := 32 8
lm3s811evb_MODELS  := 1

microbit_CPU     := -mcpu=cortex-m0 -mthumb
microbit_SOURCES := $(CORTEX_M) $(wildcard port/microbit/*.c)
microbit_LINKER  := linker/microbit.ld
microbit_PANEL   := port/panel/panel.c port/panel/pages.c port/panel/ssd1306.c
microbit_ARENA   := 12288

mps2-an385_CPU     := -mcpu=cortex-m3 -mthumb
mps2-an385_SOURCES := $(CORTEX_M) $(wildcard port/mps2-an385/*.c) port/pl022/pl022.c
mps2-an385_LINKER  := linker/mps2-an385.ld
mps2-an385_PANEL   := port/panel/panel.c port/panel/dcs.c port/panel/ili9341.c
mps2-an385_ARENA   := 262144

# ARMv6-M code on the M3 of the same board: a Cortex-M0 with room to spare.
mps2-an385-m0_CPU     := -mcpu=cortex-m0 -mthumb
mps2-an385-m0_SOURCES := $(mps2-an385_SOURCES)
mps2-an385-m0_LINKER  := $(mps2-an385_LINKER)
mps2-an385-m0_PANEL   := $(mps2-an385_PANEL)
mps2-an385-m0_ARENA   := $(mps2-an385_ARENA)

# The same board with a Cortex-M4F; nothing here uses its floating point.
mps2-an386_CPU     := -mcpu=cortex-m4 -mthumb
mps2-an386_SOURCES := $(mps2-an385_SOURCES)
mps2-an386_LINKER  := $(mps2-an385_LINKER)
mps2-an386_PANEL   := $(mps2-an385_PANEL)
mps2-an386_ARENA   := $(mps2-an385_ARENA)

# And with a Cortex-M7.
mps2-an500_CPU     := -mcpu=cortex-m7 -mthumb
mps2-an500_SOURCES := $(mps2-an385_SOURCES)
mps2-an500_LINKER  := $(mps2-an385_LINKER)
mps2-an500_PANEL   := $(mps2-an385_PANEL)
mps2-an500_ARENA   := $(mps2-an385_ARENA)

# And with a Cortex-M33, in its secure state, where every Armv8-M core starts.
mps2-an505_CPU     := -mcpu=cortex-m33 -mthumb
mps2-an505_SOURCES := $(mps2-an385_SOURCES)
mps2-an505_LINKER  := linker/mps2-an505.ld
mps2-an505_PANEL   := $(mps2-an385_PANEL)
mps2-an505_ARENA   := $(mps2-an385_ARENA)

# Raspberry Pi Pico. Its boot ROM wants a checksum in the first 256 bytes of flash.
pico_CPU     := -mcpu=cortex-m0plus -mthumb
pico_SOURCES := $(CORTEX_M) $(wildcard port/pico/*.c)
pico_LINKER  := linker/pico.ld
pico_PANEL   := port/panel/panel.c port/panel/dcs.c port/panel/st7789.c
pico_ARENA   := 131072
pico_FINISH  := python3 tools/uf2.py checksum

netduinoplus2_CPU     := -mcpu=cortex-m4 -mthumb
netduinoplus2_SOURCES := $(CORTEX_M) $(wildcard port/netduinoplus2/*.c) port/stm32/spi.c
netduinoplus2_LINKER  := linker/netduinoplus2.ld
netduinoplus2_PANEL   := $(pico_PANEL)
netduinoplus2_ARENA   := 98304

# 8 KB of RAM: tiles of 16x16 leave some for vertices.
stm32vldiscovery_CPU     := -mcpu=cortex-m3 -mthumb
stm32vldiscovery_SOURCES := $(CORTEX_M) $(wildcard port/stm32vldiscovery/*.c) port/stm32/spi.c
stm32vldiscovery_LINKER  := linker/stm32vldiscovery.ld
stm32vldiscovery_PANEL   := $(microbit_PANEL)
stm32vldiscovery_ARENA   := 4416
stm32vldiscovery_TILE    := 16

# RISC-V without floating point, and without a global pointer to small data.
virt_CPU     := -march=rv32imc -mabi=ilp32 -msmall-data-limit=0
virt_SOURCES := $(RISCV) $(wildcard port/virt/*.c)
virt_ARENA   := 262144
virt_LINKER  := linker/virt.ld
virt_CROSS   := riscv64-unknown-elf-

sifive_e_CPU     := -march=rv32imac -mabi=ilp32 -msmall-data-limit=0
sifive_e_SOURCES := $(RISCV) $(wildcard port/sifive_e/*.c)
sifive_e_LINKER  := linker/sifive_e.ld
sifive_e_PANEL   := port/panel/panel.c port/panel/pages.c port/panel/sh1106.c
sifive_e_ARENA   := 10240
sifive_e_TILE    := 64 8
sifive_e_CROSS   := riscv64-unknown-elf-

template_CPU     := -mcpu=cortex-m3 -mthumb
template_SOURCES := $(CORTEX_M) $(wildcard port/template/*.c)
template_LINKER  := linker/template.ld
template_PANEL   := $(lm3s6965evb_PANEL)
template_ARENA   := 16384

# ---- Programs

PROGRAM_turntable := examples/firmware/turntable_main.c examples/turntable/turntable.c
PROGRAM_scenes    := examples/firmware/scenes_main.c examples/firmware/shown.c $(wildcard examples/scenes/*.c)
PROGRAM_show      := examples/firmware/show_main.c examples/turntable/turntable.c
PROGRAM_animate   := examples/firmware/animate_main.c examples/firmware/animation.c $(wildcard examples/scenes/*.c)
PROGRAM_compose   := examples/firmware/compose_main.c $(wildcard examples/compose/*.c)
PROGRAM_moving    := examples/firmware/moving_main.c examples/moving/moving.c
PROGRAM_own_flush := examples/firmware/own_flush.c tests/board/lcd.c
PROGRAM_minimal   := examples/firmware/minimal.c
PROGRAM_pattern   := tests/board/pattern.c
PROGRAM_identity  := tests/board/identity_board.c tests/board/identity.c tests/board/frames.c \
    examples/turntable/turntable.c $(wildcard examples/scenes/*.c)
PROGRAM_identity-16k := tests/board/identity_16k_board.c $(filter-out tests/board/identity_board.c,$(PROGRAM_identity))
PROGRAM_identity-8k  := tests/board/identity_8k_board.c $(filter-out tests/board/identity_board.c,$(PROGRAM_identity))
PROGRAM_frames    := tools/bench/frames.c
PROGRAM_unit      := tests/board/unit.c tests/harness.c $(wildcard tests/unit/*.c)
PROGRAM_unit-pico := tests/board/unit_pico.c $(filter-out tests/unit/unit.c,$(PROGRAM_unit))
PROGRAM_unit-8k   := tests/board/unit.c tests/board/unit_8k.c tests/harness.c \
    tests/unit/generators.c tests/unit/domains.c tests/unit/drawing.c

# What breaks on a board's bus is a matter of the board.
FAULT_BOARDS := lm3s6965evb pico
$(foreach board,$(FAULT_BOARDS),$(eval PROGRAM_faults-$(board) := tests/board/faults.c tests/board/faults_$(board).c \
    examples/turntable/turntable.c))

# ---- The pattern

# Freestanding and without a C library: memcpy and its like are in port/libc, 64-bit division in libgcc.
FIRMWARE_CFLAGS = -std=c99 $(WARNINGS) $(DEBUG) -ffreestanding -ffunction-sections -fdata-sections -fstack-usage -fcallgraph-info=su \
    -Isrc -Iport -Iport/libc -Iexamples -Itests -I$(BUILD)/bench -MMD -MP
FIRMWARE_LDFLAGS = -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings -Llinker

comma := ,

# $(call cross,board): prefix of the compiler's commands
cross = $(or $($1_CROSS),$(CROSS))

# Levels of optimisation: O0, Os and O2 are the compiler's; `release` is for size, so that a small flash suffices: what a
# loop needs again is computed again, and loops and expressions stay as they are written.
SIZE_FLAGS := -Os -fno-move-loop-invariants -fno-tree-loop-im -fno-tree-loop-ivcanon -fno-tree-forwprop -fno-schedule-insns2
optimise = $(if $(filter release,$1),$(SIZE_FLAGS),-$1)

# $(call twin,board,boards): the first of these boards that is of the same core
twin = $(firstword $(foreach other,$2,$(if $(subst $($(other)_CPU),,$($1_CPU)),,$(other))))

# $(call firmware_objects,board,level,twin): objects and library of one board
define firmware_objects
$(BUILD)/$1/$2/%.o: %.c port/boards.mk
	@mkdir -p $$(@D)
	$$(Q)$(call cross,$1)gcc $$($1_CPU) $$(FIRMWARE_CFLAGS) $$(call optimise,$2,$$<) $(if $($1_ARENA),-DBOARD_ARENA=$($1_ARENA) -DBOARD_TILE_WIDTH=$(or $(firstword $($1_TILE)),0) -DBOARD_TILE_HEIGHT=$(or $(lastword $($1_TILE)),0)) $(if $($1_MODELS),-DTURNTABLE_SHOWN=$($1_MODELS)) \
	    $$(if $$(filter port/libc/%,$$<),-fno-tree-loop-distribute-patterns) -c $$< -o $$@
$(call $(if $(filter-out $1,$3),shared_library,firmware_library),$1,$2,$3)
endef
define firmware_library
$(BUILD)/$1/$2/libglint.a: $(LIBRARY:%.c=$(BUILD)/$1/$2/%.o)
	@rm -f $$@
	$$(Q)$(call cross,$1)gcc-ar rcs $$@ $$^
endef
# Nothing of a board is in the library: boards of one core share it, and what the compiler says of its stack.
define shared_library
$(BUILD)/$1/$2/libglint.a: $(BUILD)/$3/$2/libglint.a
	@mkdir -p $$(@D)
	@rm -rf $$(@D)/src && ln -s ../../$3/$2/src $$(@D)/src
	$$(Q)cp $$< $$@
endef

# $(call firmware_program,board,level,program,linker flags)
define firmware_program
$(BUILD)/$1/$2/$3.elf: $(patsubst %.c,$(BUILD)/$1/$2/%.o,$(PROGRAM_$3) $($1_SOURCES) $($1_PANEL)) \
        $(BUILD)/$1/$2/libglint.a $($1_LINKER) linker/sections.ld
	$$(Q)$(call cross,$1)gcc $$($1_CPU) $$(FIRMWARE_LDFLAGS) $4 -Wl,-Map=$$(@:.elf=.map) -T $($1_LINKER) \
	    $$(filter %.o,$$^) $$(filter %.a,$$^) -lgcc -o $$@
	$(if $($1_FINISH),$$(Q)$($1_FINISH) $$@)
	@python3 tools/size.py $$(@:.elf=.map) > $$(@:.elf=.size)
FIRMWARE += $(BUILD)/$1/$2/$3.elf
endef

$(foreach board,$(BOARDS),$(eval $(call firmware_objects,$(board),release,$(call twin,$(board),$(BOARDS)))))
# Boards whose bits and instructions are compared.
MEASURED := mps2-an385 mps2-an385-m0 mps2-an386 virt
$(foreach board,$(MEASURED),$(foreach level,O0 Os O2,$(eval $(call firmware_objects,$(board),$(level)))))

$(foreach program,turntable minimal pattern,$(eval $(call firmware_program,lm3s6965evb,release,$(program))))
# Example scenes are lit at nodes.
$(eval $(call firmware_program,lm3s6965evb,release,scenes,-Wl$(comma)--defsym=stack_size=4608))
# Vertices lit by lights that have positions take the deepest stack.
UNIT_BOARDS := lm3s6965evb microbit netduinoplus2 mps2-an385 mps2-an386 mps2-an500 mps2-an505 virt sifive_e
$(foreach board,$(UNIT_BOARDS),\
    $(eval $(call firmware_program,$(board),release,unit,-Wl$(comma)--defsym=stack_size=4224)))
$(eval $(call firmware_program,template,release,minimal))
$(foreach board,mps2-an385 mps2-an385-m0 virt,$(foreach level,O0 Os O2,\
    $(eval $(call firmware_program,$(board),$(level),identity))))
# What has no room for the example scenes draws the turntable's frames, in the formats and the tiles that fit.
$(eval $(call firmware_program,sifive_e,release,identity-16k))
$(eval $(call firmware_program,lm3s811evb,release,identity-8k))
$(foreach board,$(MEASURED),$(eval $(call firmware_program,$(board),O2,frames)))

$(foreach board,$(BOARDS),$(eval $(call firmware_program,$(board),release,show)))
# Boards with panels in colour. They have the flash for all meshes, and for code that is built for speed. Scenes that are
# lit by several lights with positions take the deepest stack.
COLOUR_BOARDS := mps2-an385 mps2-an385-m0 mps2-an386 mps2-an500 mps2-an505 netduinoplus2 pico
$(foreach board,$(filter-out $(MEASURED),$(COLOUR_BOARDS)),\
    $(eval $(call firmware_objects,$(board),O2,$(call twin,$(board),$(MEASURED) $(COLOUR_BOARDS)))))
$(foreach board,$(COLOUR_BOARDS),\
    $(eval $(call firmware_program,$(board),O2,animate,-Wl$(comma)--defsym=stack_size=5120)))
$(foreach program,compose moving own_flush,$(eval $(call firmware_program,mps2-an385,O2,$(program))))
$(foreach board,$(FAULT_BOARDS),$(eval $(call firmware_program,$(board),release,faults-$(board))))
$(eval $(call firmware_program,pico,release,unit-pico,-Wl$(comma)--defsym=stack_size=4224))
UNIT_8K_BOARDS := lm3s811evb stm32vldiscovery
$(foreach board,$(UNIT_8K_BOARDS),$(eval $(call firmware_program,$(board),release,unit-8k)))

# What programmers and boot loaders take.
$(BUILD)/%.hex: $(BUILD)/%.elf
	$(Q)$(call cross,$(firstword $(subst /, ,$*)))objcopy -O ihex $< $@
$(BUILD)/%.bin: $(BUILD)/%.elf
	$(Q)$(call cross,$(firstword $(subst /, ,$*)))objcopy -O binary $< $@
$(BUILD)/%.uf2: $(BUILD)/%.bin
	$(Q)python3 tools/uf2.py convert $< $@

-include $(wildcard $(foreach board,$(BOARDS),$(BUILD)/$(board)/*/*/*.d $(BUILD)/$(board)/*/*/*/*.d))

.PHONY: boards
# Files that are read later add firmware too.
FIRMWARE_FILES = $(FIRMWARE) $(FIRMWARE:.elf=.hex) $(FIRMWARE:.elf=.bin) \
    $(patsubst %.elf,%.uf2,$(filter $(BUILD)/pico/%,$(FIRMWARE)))
.SECONDEXPANSION:
boards: $$(FIRMWARE_FILES) ## build the firmware of every board as ELF, HEX, BIN (and UF2); prints flash, RAM and stack
	@cat $(FIRMWARE:.elf=.size)
