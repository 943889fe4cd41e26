# SPDX-License-Identifier: MIT
# The emulator of the Raspberry Pi Pico, from npm: the version and checksum in package-lock.json.

export NODE_MODULES := $(abspath $(BUILD)/pico/emulator/node_modules)

$(BUILD)/pico/emulator/installed: tests/pico/package.json tests/pico/package-lock.json
	@mkdir -p $(@D)
	$(Q)cp $^ $(@D)
	$(Q)cd $(@D) && npm ci --no-audit --no-fund --silent
	@touch $@
