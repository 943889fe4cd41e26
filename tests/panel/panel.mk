# SPDX-License-Identifier: MIT
# Drivers of panels against models of their controllers.

PANEL_MODEL   := $(wildcard tests/panel/*model*.c)
PANEL_DRIVERS := $(wildcard port/panel/*.c)
PANEL_HEADERS := $(wildcard tests/panel/*.h tests/*.h tests/image/*.h port/panel/*.h src/*.h src/*/*.h)

# What a recorded bus stream puts on the glass.
PANEL_STREAM := $(BUILD)/host/panel_stream
$(PANEL_STREAM): tests/panel/panel_stream.c $(PANEL_MODEL) $(PANEL_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c99 $(WARNINGS) $(DEBUG) $(CFLAGS) -Itests/panel $(filter %.c,$^) -o $@

# The suites; under the sanitisers, for models and drivers count in bytes.
PANEL_SUITES := pictures complaints faults i2c
PANEL_SHARED := $(addprefix tests/panel/,wire.c panels.c patterns.c) $(PANEL_MODEL) $(PANEL_DRIVERS) $(TEST_HARNESS) $(TEST_SCENES)
$(BUILD)/sanitize/tests/panel/%.o: TEST_INCLUDES += -Itests/panel
$(foreach suite,$(PANEL_SUITES),\
    $(eval $(call test_program,$(BUILD)/tests/panel/$(suite),sanitize,tests/panel/$(suite).c $(PANEL_SHARED))))

.PHONY: panel-stream test-panel
panel-stream: $(PANEL_STREAM) ## the program that shows what a recorded bus stream puts on a panel

test-panel: $(PANEL_SUITES:%=$(BUILD)/tests/panel/%) $(PANEL_STREAM) ## every panel, rotation and format through driver and model
	@status=0; for suite in $(PANEL_SUITES:%=$(BUILD)/tests/panel/%); do echo "$$suite"; $$suite || status=1; done; \
	    for program in stream traced; do python3 tests/panel/$$program.py $(PANEL_STREAM) || status=1; done; exit $$status

SUITES += test-panel
