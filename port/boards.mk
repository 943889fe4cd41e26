# SPDX-License-Identifier: MIT
# Firmware for every board. A board is the few lines below; a program is its sources.
# build/<board>/<level>/<program>.elf, with its flash, RAM and stack beside it in <program>.size.

CROSS ?= arm-none-eabi-

# ---- Boards
# CPU: the core's flags. PORT: folders of port/ whose sources are linked. PANEL: the driver's files in port/panel/.
# ARENA: bytes of arena that the board can spare. TILE: width and height of its tiles (or one number for both) where not the
# default. MODELS: how many models of the turntable it has room for. FINISH: a command that completes the ELF file. TOOLS:
# prefix of the compiler's commands where it is not Arm's. LIKE: the board that gives each field which is not set here,
# and the linker script where linker/ has none of this name.

BOARDS := lm3s6965evb lm3s811evb microbit stm32vldiscovery netduinoplus2 mps2-an385 mps2-an385-m0 mps2-an386 mps2-an500 \
    mps2-an505 virt sifive_e pico template

CORTEX_M := cortex-m semihosting libc
RISCV    := riscv semihosting libc

lm3s6965evb_CPU   := -mcpu=cortex-m3 -mthumb
lm3s6965evb_PORT  := $(CORTEX_M) lm3s6965evb lm3s pl022
lm3s6965evb_PANEL := panel.c solomon.c ssd0323.c
lm3s6965evb_ARENA := 49152

# 8 KB of RAM, 64 KB of flash: tiles of one page.
lm3s811evb_CPU    := -mcpu=cortex-m3 -mthumb
lm3s811evb_PORT   := $(CORTEX_M) lm3s811evb lm3s
lm3s811evb_PANEL  := panel.c pages.c ssd0303.c i2c.c
lm3s811evb_ARENA  := 5752
lm3s811evb_TILE   := 32 8
lm3s811evb_MODELS := 1

microbit_CPU   := -mcpu=cortex-m0 -mthumb
microbit_PORT  := $(CORTEX_M) microbit
microbit_PANEL := panel.c pages.c ssd1306.c
microbit_ARENA := 12288

mps2-an385_CPU   := -mcpu=cortex-m3 -mthumb
mps2-an385_PORT  := $(CORTEX_M) mps2-an385 pl022
mps2-an385_PANEL := panel.c dcs.c ili9341.c
mps2-an385_ARENA := 262144

# ARMv6-M code runs on the M3 of the same board: a Cortex-M0 with room to spare.
mps2-an385-m0_LIKE := mps2-an385
mps2-an385-m0_CPU  := -mcpu=cortex-m0 -mthumb

# The same with the functions that loop over pixels in RAM, whose gain is measured.
mps2-an385-hot_LIKE := mps2-an385
mps2-an385-hot_CPU  := $(mps2-an385-m0_CPU) -DGLINT_HOT_SECTION='".glint_hot"'

# The Cortex-M4F uses its floating point only for the float renderer that frames are compared with.
mps2-an386_LIKE     := mps2-an385
mps2-an386_CPU      := -mcpu=cortex-m4 -mthumb
mps2-an386-m4f_LIKE := mps2-an385
mps2-an386-m4f_CPU  := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffast-math -ffp-contract=fast

mps2-an500_LIKE := mps2-an385
mps2-an500_CPU  := -mcpu=cortex-m7 -mthumb

# The Cortex-M33 is in its secure state, where every Armv8-M core starts.
mps2-an505_LIKE := mps2-an385
mps2-an505_CPU  := -mcpu=cortex-m33 -mthumb

# The Raspberry Pi Pico's boot ROM wants a checksum in the first 256 bytes of flash.
pico_CPU    := -mcpu=cortex-m0plus -mthumb
pico_PORT   := $(CORTEX_M) pico
pico_PANEL  := panel.c dcs.c st7789.c
pico_ARENA  := 131072
pico_FINISH := python3 tools/uf2.py checksum

netduinoplus2_CPU   := -mcpu=cortex-m4 -mthumb
netduinoplus2_PORT  := $(CORTEX_M) netduinoplus2 stm32
netduinoplus2_PANEL := panel.c dcs.c st7789.c
netduinoplus2_ARENA := 98304

# 8 KB of RAM: tiles of 16x16 leave some for vertices.
stm32vldiscovery_CPU   := -mcpu=cortex-m3 -mthumb
stm32vldiscovery_PORT  := $(CORTEX_M) stm32vldiscovery stm32
stm32vldiscovery_PANEL := panel.c pages.c ssd1306.c
stm32vldiscovery_ARENA := 5544
stm32vldiscovery_TILE  := 16

# RISC-V has no floating point here, and no global pointer to small data.
virt_CPU   := -march=rv32imc -mabi=ilp32 -msmall-data-limit=0
virt_PORT  := $(RISCV) virt
virt_ARENA := 262144
virt_TOOLS := riscv64-unknown-elf-

sifive_e_CPU   := -march=rv32imac -mabi=ilp32 -msmall-data-limit=0
sifive_e_PORT  := $(RISCV) sifive_e
sifive_e_PANEL := panel.c pages.c sh1106.c
sifive_e_ARENA := 10240
sifive_e_TILE  := 64 8
sifive_e_TOOLS := riscv64-unknown-elf-

# An Xtensa LX106, the core of an ESP8266, in QEMU: no board, but the same bits on a core of another kind. Literals lie
# beside their code.
xtensa_CPU   := -mtext-section-literals
xtensa_PORT  := xtensa libc
xtensa_TOOLS := xtensa-lx106-elf-

template_CPU   := -mcpu=cortex-m3 -mthumb
template_PORT  := $(CORTEX_M) template
template_PANEL := panel.c solomon.c ssd0323.c
template_ARENA := 16384

# $(call of,board,FIELD): a field of a board
of = $(or $($1_$2),$($($1_LIKE)_$2))

# $(call port_sources,board), these with the panel's driver, the board's linker script and compiler
port_sources  = $(wildcard $(patsubst %,port/%/*.c,$(call of,$1,PORT)))
board_sources = $(port_sources) $(addprefix port/panel/,$(call of,$1,PANEL))
linker        = $(or $(wildcard linker/$1.ld),linker/$($1_LIKE).ld)
cross         = $(or $($1_TOOLS),$(CROSS))
board_gcc     = $(call cross,$1)gcc $($1_CPU)

# ---- Programs: sources, where it is not one file of that name; bytes of stack where the linker script's are too few (STACK), and functions that a program wraps
# ---- (WRAP). Vertices lit by lights that have positions take the deepest stack.

TURNTABLE         := examples/turntable/turntable.c
PROGRAM_turntable := examples/firmware/turntable_main.c $(TURNTABLE)
PROGRAM_show      := examples/firmware/show_main.c $(TURNTABLE)
PROGRAM_scenes    := examples/firmware/scenes_main.c examples/firmware/shown.c $(EXAMPLE_SCENES)
STACK_scenes      := 4608
PROGRAM_animate   := examples/firmware/animate_main.c examples/firmware/animation.c $(EXAMPLE_SCENES)
STACK_animate     := 5120
PROGRAM_night     := examples/firmware/night_main.c $(EXAMPLE_SCENES)
STACK_night       := $(STACK_animate)
PROGRAM_compose   := examples/firmware/compose_main.c $(wildcard examples/compose/*.c)
PROGRAM_moving    := examples/firmware/moving_main.c examples/moving/moving.c
PROGRAM_own_flush := $(BUILD)/readme/own_flush.c tests/board/lcd.c
PROGRAM_model     := examples/firmware/model_main.c
IDENTITY_FRAMES   := tests/board/identity.c tests/board/frames.c $(TURNTABLE) $(EXAMPLE_SCENES)
PROGRAM_identity     := tests/board/identity_board.c $(IDENTITY_FRAMES)
PROGRAM_identity-16k := tests/board/identity_16k_board.c $(IDENTITY_FRAMES)
PROGRAM_identity-8k  := tests/board/identity_8k_board.c $(IDENTITY_FRAMES)
STACK_identity-8k    := 2920
PROGRAM_unit      := tests/board/unit.c tests/harness.c $(wildcard tests/unit/*.c)
STACK_unit        := 3096
PROGRAM_unit-pico := tests/board/unit_pico.c $(filter-out tests/unit/unit.c,$(PROGRAM_unit))
STACK_unit-pico   := 3096
PROGRAM_unit-8k   := tests/board/unit.c tests/board/unit_8k.c tests/harness.c \
    $(addprefix tests/unit/,generators.c domains.c drawing.c)
PROGRAM_faults-lm3s6965evb := tests/board/faults.c tests/board/faults_lm3s6965evb.c $(TURNTABLE)
PROGRAM_faults-pico        := tests/board/faults.c tests/board/faults_pico.c $(TURNTABLE)
PROGRAM_power_cut := tests/board/power_cut_board.c $(TURNTABLE)
PROGRAM_endurance := tests/endurance/endurance_board.c tests/endurance/endurance.c $(EXAMPLE_SCENES)
STACK_endurance   := 5120
METHODS           := $(addprefix tests/unit/methods/,methods.c power.c normalise.c)
PROGRAM_methods   := tools/bench/methods.c $(METHODS)

# These measure, and are not for a board to run.
WORKLOADS             := tools/bench/workloads.c tools/bench/boxes.c $(EXAMPLE_SCENES)
PROGRAM_workloads     := tools/bench/workload_frames.c $(WORKLOADS)
PROGRAM_default_frames := tools/bench/default_frames.c $(WORKLOADS)
FLOAT_RENDERER        := $(filter-out %/frames.c,$(wildcard tools/bench/float/*.c)) $(WORKLOADS)
PROGRAM_float         := tools/bench/float/frames.c $(FLOAT_RENDERER)
PROGRAM_frame_board   := tools/chart/frame_board.c $(WORKLOADS)
PROGRAM_frame_float_board := tools/chart/frame_float_board.c $(FLOAT_RENDERER)
PROGRAM_painted       := tests/stack/painted.c $(WORKLOADS)
PROGRAM_arena_board   := tools/chart/arena_board.c $(EXAMPLE_SCENES)
PROGRAM_gallery_costs := tools/gallery/costs_board.c $(EXAMPLE_SCENES)
PROGRAM_animate-marked := $(PROGRAM_animate) tools/boards/marked.c
STACK_animate-marked   := 5120
WRAP_animate-marked    := glint_render
PROGRAM_animate-marked-polled := $(PROGRAM_animate-marked) tools/boards/marked_polled.c
STACK_animate-marked-polled   := 5120
WRAP_animate-marked-polled    := glint_render stm32_spi_send

# ---- Which board has which program, by level of optimisation: O0, Os and O2 are the compiler's; `release` is for size, so
# ---- that a small flash suffices: what a loop needs again is computed again, and loops and expressions stay as written.

SIZE_FLAGS := -Os -fno-move-loop-invariants -fno-tree-loop-im -fno-tree-loop-ivcanon -fno-tree-forwprop -fno-schedule-insns2

# Bits and instructions of these are compared, by the name of their core in tables.
BOARD_m3   := mps2-an385
BOARD_m0   := mps2-an385-m0
BOARD_m4   := mps2-an386
BOARD_m4f  := mps2-an386-m4f
BOARD_hot  := mps2-an385-hot
BOARD_rv32 := virt
MEASURED   := mps2-an385 mps2-an385-m0 mps2-an386 virt
# Panels in colour come with flash for all meshes, and for code that is built for speed.
COLOUR_BOARDS  := mps2-an385 mps2-an385-m0 mps2-an386 mps2-an500 mps2-an505 netduinoplus2 pico
UNIT_BOARDS    := lm3s6965evb microbit netduinoplus2 mps2-an385 mps2-an386 mps2-an500 mps2-an505 virt sifive_e
UNIT_8K_BOARDS := lm3s811evb stm32vldiscovery
# What breaks on a board's bus is a matter of the board.
FAULT_BOARDS   := lm3s6965evb pico

# Boards that have no room for the example scenes draw the turntable's frames, in the formats and tiles that fit (identity).
FIRMWARE := $(patsubst %,$(BUILD)/%.elf, \
    $(addprefix lm3s6965evb/release/,turntable minimal pattern scenes) $(UNIT_BOARDS:%=%/release/unit) template/release/minimal \
    $(foreach board,mps2-an385 mps2-an385-m0 virt,$(addprefix $(board)/,O0/identity Os/identity O2/identity)) \
    xtensa/Os/identity xtensa/O2/identity sifive_e/release/identity-16k lm3s811evb/release/identity-8k \
    $(MEASURED:%=%/O2/frames) $(BOARDS:%=%/release/show) \
    $(COLOUR_BOARDS:%=%/O2/animate) pico/O2/night $(addprefix mps2-an385/O2/,compose moving own_flush) \
    $(foreach board,$(FAULT_BOARDS),$(board)/release/faults-$(board)) pico/release/unit-pico $(UNIT_8K_BOARDS:%=%/release/unit-8k) \
    mps2-an385/O2/power_cut mps2-an385/O2/endurance $(MEASURED:%=%/O2/methods))
# The stack of every public function is measured on these.
PAINTED   := $(foreach board,mps2-an385-m0 mps2-an385,$(board)/Os/painted $(board)/O2/painted)
MEASURING := $(patsubst %,$(BUILD)/%.elf,$(MEASURED:%=%/O2/workloads) $(MEASURED:%=%/O2/frame_board) \
    mps2-an385/O2/default_frames $(foreach board,mps2-an385 mps2-an385-m0 mps2-an386 mps2-an386-m4f,$(board)/O2/loops) mps2-an386-m4f/O2/float mps2-an386-m4f/O2/frame_float_board \
    mps2-an385/O2/animate-marked netduinoplus2/O2/animate-marked-polled mps2-an385/O2/shading_board mps2-an385/O2/arena_board \
    mps2-an385/O2/gallery_costs mps2-an385-m0/O2/gallery_costs mps2-an385-hot/O2/frames mps2-an385-hot/O2/workloads \
    $(PAINTED))

# Boards and levels that objects are built for, as <board>/<level>.
FOLDERS := $(BOARDS:%=%/release) $(foreach board,$(MEASURED),$(board)/O0 $(board)/Os $(board)/O2) \
    $(patsubst %,%/O2,$(filter-out $(MEASURED),$(COLOUR_BOARDS))) mps2-an386-m4f/Os mps2-an386-m4f/O2 mps2-an385-hot/O2 \
    xtensa/Os xtensa/O2

# ---- The rules

# Freestanding and without a C library: memcpy and its like are in port/libc, 64-bit division in libgcc.
FIRMWARE_CFLAGS = -std=c99 $(WARNINGS) $(DEBUG) -ffreestanding -ffunction-sections -fdata-sections -fstack-usage -fcallgraph-info=su \
    -Isrc -Iport -Iport/libc -Iexamples -Itests -Itools -I$(BUILD)/bench -MMD -MP
FIRMWARE_LDFLAGS = -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings -Llinker

# $(call board,board/level/program) and $(call level,board/level)
board = $(word 1,$(subst /, ,$1))
level = $(word 2,$(subst /, ,$1))

# $(call board_defines,board): what examples are told of a board
board_defines = $(if $(call of,$1,ARENA),-DBOARD_ARENA=$(call of,$1,ARENA) -DBOARD_TILE_WIDTH=$(or $(firstword $($1_TILE)),0) \
    -DBOARD_TILE_HEIGHT=$(or $(lastword $($1_TILE)),0)) $(if $($1_MODELS),-DTURNTABLE_SHOWN=$($1_MODELS))

# $(call firmware_objects,board,level): the rule of the objects of one board
define firmware_objects
$(BUILD)/$1/$2/%.o: %.c port/boards.mk
	@mkdir -p $$(@D)
	$$(Q)$(call board_gcc,$1) $$(FIRMWARE_CFLAGS) $(if $(filter release,$2),$(SIZE_FLAGS),-$2) $(call board_defines,$1) \
	    $$(if $$(filter port/libc/%,$$<),-fno-tree-loop-distribute-patterns) -c $$< -o $$@
endef
$(foreach folder,$(FOLDERS),$(eval $(call firmware_objects,$(call board,$(folder)),$(call level,$(folder)))))
-include $(foreach depth,* */* */*/*,$(wildcard $(FOLDERS:%=$(BUILD)/%/$(depth)/*.d)))

# Nothing of a board is in the library: boards of one core share it, and what the compiler says of its stack.
# $(call twin,board/level): the first of the folders that has the same core and level
twin   = $(firstword $(foreach other,$(filter %/$(call level,$1),$(FOLDERS)), \
    $(if $(subst $($(call board,$(other))_CPU),,$($(call board,$1)_CPU)),,$(other))))
SHARED := $(foreach folder,$(FOLDERS),$(if $(filter $(folder),$(call twin,$(folder))),,$(folder)))

.SECONDEXPANSION:
$(patsubst %,$(BUILD)/%/libglint.a,$(filter-out $(SHARED),$(FOLDERS))): %/libglint.a: $$(addprefix $$*/,$(LIBRARY:.c=.o))
	@rm -f $@
	$(Q)$(call cross,$(call board,$(@:$(BUILD)/%=%)))gcc-ar rcs $@ $^
$(SHARED:%=$(BUILD)/%/libglint.a): $(BUILD)/%/libglint.a: $(BUILD)/$$(call twin,$$*)/libglint.a
	@mkdir -p $(@D)
	@rm -rf $(@D)/src && ln -s ../../$(call twin,$*)/src $(@D)/src
	$(Q)cp $< $@

# The source of a program that is one file.
program_file = $(firstword $(wildcard examples/firmware/$1.c tools/*/$1.c tests/*/$1.c))

# `make run` builds MODEL, or PROGRAM: one of those above, or somebody's own, which is built each time, from wherever it lies,
# and may have warnings. Where there is room it gets the stack of scenes.
PROGRAM     ?= $(if $(MODEL),model,show)
PROGRAM_run := $(or $(PROGRAM_$(PROGRAM)),$(call program_file,$(PROGRAM)))
RUN_OWN     := $(if $(PROGRAM_run),,$(PROGRAM))
PROGRAM_run := $(or $(PROGRAM_run),$(PROGRAM)) tests/board/watched.c
run_folder   = $(BUILD)/$1/$(if $(filter $1,$(COLOUR_BOARDS)),O2,release)
RUN         := $(if $(filter $(BOARD),$(BOARDS)),$(call run_folder,$(BOARD)))
STACK       ?= $(or $(STACK_$(PROGRAM)),$(if $(filter %/O2,$(RUN)),$(STACK_animate)))
STACK_run   := $(STACK)
WRAP_run     = main $(if $(shell grep -l board_checkpoint $(filter-out %/watched.c,$(PROGRAM_run))),,glint_render)
RUN_MODEL   := $(BUILD)/run/model.h
.PHONY: FORCE
$(RUN:%=%/run.elf) $(RUN_MODEL) $(call objects,$(RUN),$(RUN_OWN)): FORCE
$(call objects,$(RUN),$(RUN_OWN)): FIRMWARE_CFLAGS += -Wno-error
$(call objects,$(RUN),$(PROGRAM_model)): $(RUN_MODEL)
$(call objects,$(RUN),$(PROGRAM_model)): FIRMWARE_CFLAGS += -DMODEL_HEADER=\"$(abspath $(RUN_MODEL))\" \
    $$(grep -q model_objects $(RUN_MODEL) && echo -DMODEL_HAS_MATERIALS) \
    $$(grep -q GLINT_BLEND_ALPHA $(RUN_MODEL) && echo -DMODEL_BLENDS)

# $(call firmware_sources,board/level/program): also the board's
firmware_sources = $(or $(PROGRAM_$(notdir $1)),$(call program_file,$(notdir $1))) $(call board_sources,$(call board,$1))
$(FIRMWARE) $(MEASURING) $(RUN:%=%/run.elf): $(BUILD)/%.elf: $$(call objects,$$(@D),$$(call firmware_sources,$$*)) \
        $$(@D)/libglint.a $$(call linker,$$(call board,$$*)) linker/sections.ld
	$(Q)$(call board_gcc,$(call board,$*)) $(FIRMWARE_LDFLAGS) $(STACK_$(*F):%=-Wl,--defsym=stack_size=%) \
	    $(WRAP_$(*F):%=-Wl,--wrap=%) -Wl,-Map=$(@:.elf=.map) -T $(call linker,$(call board,$*)) $(filter %.o,$^) \
	    $(filter %.a,$^) -lgcc -o $@
	$(if $($(call board,$*)_FINISH),$(Q)$($(call board,$*)_FINISH) $@)
	@python3 tools/size.py $(@:.elf=.map) > $(@:.elf=.size)

# These read the benchmark's scenes, which a program of this machine writes.
$(foreach folder,$(filter %/Os %/O2,$(FOLDERS)),$(addprefix $(BUILD)/$(folder)/tools/,bench/frames.o bench/workloads.o \
    chart/arena_board.o)): $(BUILD)/bench/bench_scenes.h
$(BUILD)/mps2-an385/O2/tools/chart/arena_board.o: $(BUILD)/bench/spot.h
$(BUILD)/mps2-an386-m4f/O2/%.o: FIRMWARE_CFLAGS += -Itools/bench -Itools/bench/float

# The README's program, as it stands there.
$(BUILD)/readme/own_flush.c: README.md
	@mkdir -p $(@D)
	$(Q)awk '/^```c$$/ { on = 1; next } /^```$$/ { on = 0 } on' $< > $@
$(BUILD)/mps2-an385/O2/$(BUILD)/readme/own_flush.o: FIRMWARE_CFLAGS += -Iexamples/firmware

# Programmers and boot loaders take these.
$(BUILD)/%.hex: $(BUILD)/%.elf
	$(Q)$(call cross,$(call board,$*))objcopy -O ihex $< $@
$(BUILD)/%.bin: $(BUILD)/%.elf
	$(Q)$(call cross,$(call board,$*))objcopy -O binary $< $@
$(BUILD)/%.uf2: $(BUILD)/%.bin
	$(Q)python3 tools/uf2.py convert $< $@

FLASHED := $(FIRMWARE) $(FIRMWARE:.elf=.hex) $(FIRMWARE:.elf=.bin) $(patsubst %.elf,%.uf2,$(filter $(BUILD)/pico/%,$(FIRMWARE)))
.PHONY: boards
boards: $(FLASHED) ## build the firmware of every board as ELF, HEX, BIN (and UF2); prints flash, RAM and stack
	@cat $(FIRMWARE:.elf=.size)
