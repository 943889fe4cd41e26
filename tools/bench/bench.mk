# SPDX-License-Identifier: MIT
# Instructions of whole frames, counted in QEMU; included by port/boards.mk.

$(BUILD)/bench/scenes: tools/bench/scenes.c examples/bench/bench.c examples/bench/bench.h $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Iexamples/bench $(filter %.c %.a,$^) -lm -o $@

$(BUILD)/bench/bench_scenes.h: $(BUILD)/bench/scenes
	$(Q)$< > $@

# Firmware that draws them includes them.
$(foreach board,mps2-an385 mps2-an385-m0,$(foreach level,Os O2,\
    $(patsubst %.c,$(BUILD)/$(board)/$(level)/%.o,tools/bench/frames.c))): $(BUILD)/bench/bench_scenes.h

BENCH_PROGRAMS := m3=$(BUILD)/mps2-an385/O2/frames.elf m0=$(BUILD)/mps2-an385-m0/O2/frames.elf

.PHONY: bench bench-diff
$(BUILD)/bench.csv: $(foreach program,$(BENCH_PROGRAMS),$(lastword $(subst =, ,$(program)))) tools/bench/bench.py tests/board/qemu.py
	$(Q)python3 tools/bench/bench.py --qemu $(QEMU) --output $(BUILD) $(BENCH_PROGRAMS)

bench: $(BUILD)/bench.csv ## count the instructions of whole frames; writes build/bench.csv
	@python3 tools/bench/table.py $<

bench-diff: $(BUILD)/bench.csv ## what changed against docs/bench.csv; fails when anything did
	@python3 tools/bench/table.py $< --against docs/bench.csv
