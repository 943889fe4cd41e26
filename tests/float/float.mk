# SPDX-License-Identifier: MIT
# Pictures of the float renderer that frames are compared with, against the double-precision reference.

FLOAT_PICTURES := $(TEST_HARNESS) tests/float/pictures.c tests/reference/reference.c tests/reference/lighting.c \
    tools/bench/workloads.c $(wildcard examples/scenes/*.c) \
    $(filter-out tools/bench/float/frames.c,$(wildcard tools/bench/float/*.c))

$(BUILD)/tests/host/float: $(FLOAT_PICTURES) $(wildcard tools/bench/*.h tools/bench/float/*.h) $(TEST_HEADERS) \
        $(BUILD)/host/libglint.a $(BUILD)/bench/bench_scenes.h
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $(CFLAGS) -Iport -Itools/bench -Itools/bench/float -I$(BUILD)/bench $(filter %.c %.a,$^) -lm -o $@

SUITES += test-float
.PHONY: test-float
test-float: $(BUILD)/tests/host/float ## pictures of the float renderer that frames are compared with, against the reference
	$(call run_suites,$^)
