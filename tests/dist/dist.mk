# SPDX-License-Identifier: MIT
# The archive that is released: the same bytes from any clone, and what a user makes of it.

SUITES += test-dist
.PHONY: test-dist
test-dist: ## make dist in two clones of the last commit: the same bytes; what is unpacked draws the demo
	@python3 tests/dist/dist.py $(BUILD)/dist-test
