# SPDX-License-Identifier: MIT
# Models of panels.

PANEL_MODEL         := tests/panel/panel_model.c $(wildcard tests/panel/model_*.c)
PANEL_MODEL_HEADERS := $(wildcard tests/panel/*.h)

# What a recorded bus stream puts on the glass.
PANEL_STREAM := $(BUILD)/host/panel_stream
$(PANEL_STREAM): tests/panel/panel_stream.c $(PANEL_MODEL) $(PANEL_MODEL_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c99 $(WARNINGS) -g $(CFLAGS) -Itests/panel $(filter %.c,$^) -o $@

.PHONY: panel-stream
panel-stream: $(PANEL_STREAM) ## the program that shows what a recorded bus stream puts on a panel
