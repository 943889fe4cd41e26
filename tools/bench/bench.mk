# SPDX-License-Identifier: MIT
# Instructions of whole frames and of methods, counted in QEMU; included by port/boards.mk.

$(BUILD)/bench/scenes: tools/bench/scenes.c examples/bench/bench.c examples/bench/bench.h \
        $(addprefix port/host/,cluster.c cluster.h patch.c patch.h memory.c memory.h) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Iexamples/bench -Iport/host $(filter %.c %.a,$^) -lm -o $@

$(BUILD)/bench/bench_scenes.h: $(BUILD)/bench/scenes
	$(Q)$< > $@

# Firmware that draws them includes them.
$(foreach board,$(MEASURED),$(foreach level,Os O2,\
    $(patsubst %.c,$(BUILD)/$(board)/$(level)/%.o,tools/bench/frames.c tools/bench/workloads.c))): $(BUILD)/bench/bench_scenes.h

PROGRAM_workloads := tools/bench/workload_frames.c tools/bench/workloads.c tools/bench/boxes.c $(wildcard examples/scenes/*.c)
$(foreach board,$(MEASURED),$(eval $(call firmware_program,$(board),O2,workloads)))
# It measures; `make boards` lists what is to run on a board.
FIRMWARE := $(filter-out %/workloads.elf,$(FIRMWARE))

PROGRAM_methods := tools/bench/methods.c $(METHODS)
$(foreach board,$(MEASURED),$(eval $(call firmware_program,$(board),O2,methods)))

# Name in the table, emulated machine and board of each core. ARMv6-M code runs on the M3's board.
BENCH_CORES := m3=mps2-an385=mps2-an385 m0=mps2-an385=mps2-an385-m0 m4=mps2-an386=mps2-an386 rv32=virt=virt

# $(call bench_elf,core,program)
bench_elf = $(BUILD)/$(lastword $(subst =, ,$1))/O2/$2.elf

# $(call bench_programs,program): name=machine=firmware of each core
bench_programs = $(foreach core,$(BENCH_CORES),\
    $(word 1,$(subst =, ,$(core)))=$(word 2,$(subst =, ,$(core)))=$(call bench_elf,$(core),$1))

# The float renderer that they are compared with (float.mk).
BENCH_FLOAT := $(BUILD)/mps2-an386-m4f/O2/float.elf

.PHONY: bench bench-diff
$(BUILD)/bench.csv: $(foreach core,$(BENCH_CORES),$(foreach program,frames workloads methods,$(call bench_elf,$(core),$(program)))) \
        $(BENCH_FLOAT) $(BUILD)/cycles/plugin.so $(wildcard tools/bench/*.py tools/cycles/*.py) tests/board/qemu.py
	$(Q)python3 tools/bench/bench.py --qemu $(QEMU) --output $(BUILD) --plugin $(BUILD)/cycles/plugin.so --frames $(call bench_programs,frames) $(call bench_programs,workloads) \
	    --float m4f=mps2-an386=$(BENCH_FLOAT) \
	    --methods $(call bench_programs,methods)

bench: $(BUILD)/bench.csv ## count the instructions of whole frames of every kind of scene, and of methods; writes build/bench.csv
	@python3 tools/bench/table.py $<

bench-diff: $(BUILD)/bench.csv ## what changed against docs/bench.csv; fails when anything did
	@python3 tools/bench/table.py $< --against docs/bench.csv
