# SPDX-License-Identifier: MIT
# docs/reliability.md: its figures are those of the files that other targets write. And what runs count that are too long
# for `make test`.

RELIABILITY := python3 tools/reliability/reliability.py

# $(call recorded,target,'what=pattern'...,sources beside the library): runs the command that follows, and keeps what it counts
recorded = python3 tools/reliability/record.py --runs $(BUILD)/runs.csv --run $1 --counts $2 --sources src $3 --

SUITES += test-reliability
.PHONY: reliability-page runs-figures test-reliability
reliability-page: ## write the figures of docs/reliability.md anew
	@$(RELIABILITY) --write --suites "$(SUITES)"

runs-figures: ## docs/runs.csv: what the last runs of attack, attack-arenas, endurance and domains counted here
	@python3 tools/reliability/record.py --runs $(BUILD)/runs.csv --figures docs/runs.csv

test-reliability: ## the figures of docs/reliability.md, and the targets and files that it and SECURITY.md name
	@python3 tools/reliability/record_test.py
	@$(MAKE) --no-print-directory help | $(RELIABILITY) --suites "$(SUITES)"
