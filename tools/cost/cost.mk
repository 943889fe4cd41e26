# SPDX-License-Identifier: MIT
# Pictures of what docs/cost.md tells the price of; its tables are filled by tools/chart.

COST_PICTURES := $(BUILD)/cost/pictures
$(COST_PICTURES): tools/cost/pictures.c tools/bench/workloads.c tools/bench/boxes.c $(wildcard examples/scenes/*.c) \
        $(addprefix port/host/,framebuffer.c png.c deflate.c output.c memory.c problem.c) $(BUILD)/bench/bench_scenes.h $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Iport/host -Itools/bench -I$(BUILD)/bench $(filter %.c %.a,$^) -lm -o $@

.PHONY: cost-pictures
cost-pictures: $(COST_PICTURES) ## draw the pictures of docs/cost.md
	@mkdir -p docs/cost
	$< docs/cost

# ---- The cost model: prices of what a frame consists of (prices.py)

COST_COUNT := $(BUILD)/cost/count
$(COST_COUNT): tools/cost/count.c $(addprefix port/host/,counts.c counts.h watch.c framebuffer.c memory.c) tools/bench/workloads.c \
        tools/bench/boxes.c $(wildcard examples/scenes/*.c) $(BUILD)/bench/bench_scenes.h $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Iport/host -Itools/bench -I$(BUILD)/bench $(HOST_WATCH) $(filter %.c %.a,$^) -lm -o $@

$(BUILD)/cost/counts.csv: $(COST_COUNT)
	$(Q)$< > $@

.PHONY: prices
prices: $(BUILD)/cost/counts.csv ## fit prices to docs/bench.csv: docs/prices.csv, docs/prices-judged.csv, port/host/prices.h
	python3 tools/cost/prices.py $<

SUITES += test-prices
.PHONY: test-prices
test-prices: $(BUILD)/cost/counts.csv ## prices against frames that they were not fitted to, and against each other
	@python3 tools/cost/prices.py $< --check

SUITES += test-cost
.PHONY: test-cost
test-cost: $(COST_PICTURES) ## the pictures of docs/cost.md against what is drawn
	@rm -rf $(BUILD)/cost/drawn && mkdir -p $(BUILD)/cost/drawn
	@$< $(BUILD)/cost/drawn
	@python3 tools/cost/compare.py $(BUILD)/cost/drawn docs/cost docs/cost.md
