# SPDX-License-Identifier: MIT
# Proofs by Frama-C that the arithmetic of src/ cannot overflow within its documented ranges.

PROVE = python3 tests/proof/prove.py --folder tests/proof --output $(BUILD)/proof --page docs/proofs.md

SUITES += test-prove
.PHONY: prove test-prove
prove: ## prove the kernels free of overflow, and write docs/proofs.md
	@$(PROVE)

test-prove: ## the proofs, and docs/proofs.md against them
	@$(PROVE) --check
