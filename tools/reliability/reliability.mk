# SPDX-License-Identifier: MIT
# docs/reliability.md: its figures are those of the files that other targets write.

RELIABILITY := python3 tools/reliability/reliability.py

SUITES += test-reliability
.PHONY: reliability-page test-reliability
reliability-page: ## write the figures of docs/reliability.md anew
	@$(RELIABILITY) --write --suites "$(SUITES)" --calls $(ATTACK_CALLS)

test-reliability: ## the figures of docs/reliability.md, and the targets and files that it and SECURITY.md name
	@$(MAKE) --no-print-directory help | $(RELIABILITY) --suites "$(SUITES)" --calls $(ATTACK_CALLS)
