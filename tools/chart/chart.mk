# SPDX-License-Identifier: MIT
# Charts, from figures measured here: errors on the host, instructions on an emulated Cortex-M3.

SHADING_HOST := tools/chart/shading.c tests/image/picture.c tests/reference/reference.c tests/reference/lighting.c
SHADING_BOARD := tools/chart/shading_board.c $(wildcard src/*.c port/cortex-m/*.c) port/mps2-an385/board.c port/libc/memory.c

$(BUILD)/chart/shading: $(SHADING_HOST) $(LIBRARY) tools/chart/shading_scene.h $(wildcard src/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $(CFLAGS) $(SHADING_HOST) $(LIBRARY) -lm -o $@

$(BUILD)/chart/shading.elf: $(SHADING_BOARD) tools/chart/shading_scene.h $(wildcard src/*.h) linker/mps2-an385.ld
	@mkdir -p $(@D)
	$(Q)$(CROSS)gcc $(mps2-an385_CPU) $(filter-out -MMD -MP -fstack-usage,$(FIRMWARE_CFLAGS)) -O2 \
	    -fno-tree-loop-distribute-patterns $(FIRMWARE_LDFLAGS) -T linker/mps2-an385.ld $(SHADING_BOARD) -lgcc -o $@

# evaluation, triangles, root mean square error, largest error, instructions
$(BUILD)/chart/shading.csv: $(BUILD)/chart/shading $(BUILD)/chart/shading.elf
	$(BUILD)/chart/shading > $(BUILD)/chart/errors.csv
	qemu-system-arm -M mps2-an385 -display none -serial none -monitor none -icount shift=0 \
	    -semihosting-config enable=on,target=native -kernel $(BUILD)/chart/shading.elf \
	    > $(BUILD)/chart/instructions.csv 2>&1
	paste -d, $(BUILD)/chart/errors.csv $(BUILD)/chart/instructions.csv | cut -d, -f1-4,7 > $@

.PHONY: chart
chart: ## measure and draw the charts of docs/charts
	@tools/setup.sh
	@$(MAKE) --no-print-directory $(BUILD)/chart/shading.csv
	@mkdir -p docs/charts
	cp $(BUILD)/chart/shading.csv docs/charts/shading.csv
	gnuplot -e "csv='docs/charts/shading.csv'" tools/chart/shading.gp > docs/charts/shading.svg
