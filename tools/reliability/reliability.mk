# SPDX-License-Identifier: MIT
# docs/reliability.md: what it and SECURITY.md name is there.

SUITES += test-reliability
.PHONY: test-reliability
test-reliability: ## the targets, files and links that docs/reliability.md and SECURITY.md name
	@$(MAKE) --no-print-directory help | python3 tools/reliability/reliability.py --suites "$(SUITES)"
