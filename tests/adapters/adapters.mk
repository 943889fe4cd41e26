# SPDX-License-Identifier: MIT
# The adapters of examples/adapters/ against declarations of what they serve, and doubles that keep what arrives there.

ADAPTER_FOLDER   := $(BUILD)/adapters
ADAPTER_SOURCES  := $(wildcard examples/adapters/*.c examples/adapters/*.cpp tests/adapters/*.c tests/adapters/*.cpp) $(TEST_HARNESS)
ADAPTER_OBJECTS  := $(patsubst %,$(ADAPTER_FOLDER)/%.o,$(ADAPTER_SOURCES))
ADAPTER_INCLUDES := -Isrc -Iexamples -Itests -isystem tests/adapters/declarations -isystem /usr/include/libdrm
ADAPTER_FLAGS    := $(WARNINGS) $(DEBUG) -O1 -pthread -D_GNU_SOURCE $(ADAPTER_INCLUDES) -MMD -MP
ADAPTER_WRAPPED  := open close ioctl mmap munmap

SUITES += test-adapters
.PHONY: test-adapters

$(ADAPTER_FOLDER)/%.c.o: %.c
	@mkdir -p $(@D)
	$(Q)gcc -std=c99 $(ADAPTER_FLAGS) -c $< -o $@
$(ADAPTER_FOLDER)/%.cpp.o: %.cpp
	@mkdir -p $(@D)
	$(Q)g++ -std=c++11 -fno-exceptions -fno-rtti $(ADAPTER_FLAGS) -c $< -o $@
$(ADAPTER_FOLDER)/adapters: $(ADAPTER_OBJECTS) $(BUILD)/host/libglint.a
	$(Q)gcc -pthread $(ADAPTER_WRAPPED:%=-Wl,--wrap=%) $^ -o $@
-include $(ADAPTER_OBJECTS:.o=.d)

test-adapters: $(ADAPTER_FOLDER)/adapters ## LVGL, Zephyr, u8g2, TFT_eSPI, Linux and FreeRTOS, by doubles of each
	$(Q)$<
