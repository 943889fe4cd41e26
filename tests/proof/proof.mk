# SPDX-License-Identifier: MIT
# Proofs by Frama-C that arithmetic of src/ cannot overflow within its documented ranges.

PROVE = python3 tests/proof/prove.py --folder tests/proof --output $(BUILD)/proof --page docs/proofs.md

SUITES += test-prove
.PHONY: prove test-prove proofs-page
test-prove: ## prove arithmetic free of overflow; docs/proofs.md
	@$(PROVE) --check

proofs-page:
	@$(PROVE) --page-only
