# SPDX-License-Identifier: MIT
# Pictures of what docs/cost.md tells the price of; its tables are filled by tools/chart.

COST_PICTURES := $(BUILD)/cost/pictures
$(COST_PICTURES): tools/cost/pictures.c tools/bench/workloads.c tools/bench/boxes.c $(wildcard examples/scenes/*.c) \
        $(addprefix port/host/,framebuffer.c png.c deflate.c output.c memory.c problem.c) $(BUILD)/bench/bench_scenes.h $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Iport/host -Itools/bench -I$(BUILD)/bench $(filter %.c %.a,$^) -lm -o $@

.PHONY: cost-pictures
cost-pictures: $(COST_PICTURES)
	@mkdir -p docs/cost
	$< docs/cost

SUITES += test-cost
.PHONY: test-cost
test-cost: $(COST_PICTURES) ## the pictures of docs/cost.md against what is drawn
	@rm -rf $(BUILD)/cost/drawn && mkdir -p $(BUILD)/cost/drawn
	@$< $(BUILD)/cost/drawn
	@python3 tools/cost/compare.py $(BUILD)/cost/drawn docs/cost docs/cost.md
